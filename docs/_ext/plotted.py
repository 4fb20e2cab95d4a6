"""What a notebook's cell ends with, when that is a picture of matplotlib, as a picture of its page."""

from __future__ import annotations

from typing import Any

from matplotlib.figure import Figure
from sphinx_gallery.scrapers import figure_rst

LAST, SHOWN = "___", "___shown"
"""The names under which the gallery keeps what a cell ends with, and we what was shown already."""


def last_figure(_block: Any, variables: dict[str, Any], gallery: dict[str, Any]) -> str:
    """Return the lines of a page that show the figure a cell ends with; none where it ends with something else."""
    names = variables["example_globals"]
    figure = names.get(LAST)
    if not isinstance(figure, Figure) or names.get(SHOWN) is figure:
        return ""
    names[SHOWN] = figure
    path = next(variables["image_path_iterator"])
    figure.savefig(path, dpi=110)
    text: str = figure_rst([path], gallery["src_dir"])
    return text

"""What every picture must keep: no label on another, none cut off by the paper's edge, minus signs, no hyphens."""

from __future__ import annotations

import itertools

from matplotlib.axis import Axis
from matplotlib.figure import Figure
from matplotlib.text import Text
from matplotlib.transforms import Bbox

from sweetspot.reports.quantities import with_minus_signs


def texts(figure: Figure) -> list[tuple[str, Bbox]]:
    """Return every text that is seen, with the box it takes on paper."""
    figure.draw_without_rendering()
    unseen: set[Text] = set()
    for axis in figure.findobj(Axis):
        assert isinstance(axis, Axis)
        low, high = sorted(axis.get_view_interval())
        for tick in axis.get_major_ticks():
            if not low - 1e-9 <= tick.get_loc() <= high + 1e-9:  # matplotlib keeps such ticks but does not draw them
                unseen |= {tick.label1, tick.label2}
    shown = [text for text in figure.findobj(Text) if isinstance(text, Text) and text.get_visible()]
    shown = [text for text in shown if text not in unseen]
    return [(text.get_text(), Text.get_window_extent(text)) for text in shown if text.get_text().strip()]


def check_labels(figure: Figure) -> None:
    """Fail where a label lies on another or is cut off, or has a hyphen for a minus sign."""
    boxes = texts(figure)
    page = figure.bbox
    for words, box in boxes:
        inside = page.x0 <= box.x0 and box.x1 <= page.x1 and page.y0 <= box.y0 and box.y1 <= page.y1
        assert inside, f"{words!r} is cut off"
        assert words == with_minus_signs(words), f"{words!r} has a hyphen for a minus sign"
    for (words, box), (others, other) in itertools.combinations(boxes, 2):
        shrunk = Bbox.from_extents(box.x0 + 1, box.y0 + 1, box.x1 - 1, box.y1 - 1)
        assert not shrunk.overlaps(other), f"{words!r} lies on {others!r}"

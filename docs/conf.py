"""Sphinx configuration: MyST pages, the furo theme, everything generated and served locally."""

from __future__ import annotations

import sys
import tomllib
from importlib import import_module
from pathlib import Path
from typing import Any

from sphinx.util.logging import getLogger

HERE = Path(__file__).resolve().parent
ROOT = HERE.parent
sys.path[:0] = [str(HERE), str(HERE / "_ext"), str(ROOT / "src")]

PACKAGE = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]

project = "sweetspot"
author = "The sweetspot developers"
project_copyright = author
version = release = PACKAGE["version"]

extensions = [
    "myst_parser", "sphinx.ext.autodoc", "sphinx.ext.napoleon", "sphinx_gallery.gen_gallery", "docstrings", "mathtext",
    "spellings",
]  # fmt: skip
exclude_patterns = ["notebooks", "_build", "_generated", "Thumbs.db", ".DS_Store"]
default_role = "code"
nitpicky = False
suppress_warnings = ["ref.python"]  # a word of a `Literal` such as "mass" is no reference to a field of that name

myst_enable_extensions = ["deflist", "substitution"]
myst_heading_anchors = 3

html_theme = "furo"
html_title = "sweetspot"
html_static_path = ["_static"]
html_css_files = ["sweetspot.css"]
html_show_sourcelink = False
html_copy_source = False
html_extra_path = ["_generated/extra"]  # the schemas of answers
(HERE / html_extra_path[0]).mkdir(parents=True, exist_ok=True)
toc_object_entries = False  # thousands of functions in the contents beside every page: 50 s of the build

napoleon_google_docstring = False
napoleon_use_rtype = False
napoleon_attr_annotations = False  # types stand in the signature
autodoc_member_order = "bysource"
autodoc_typehints = "signature"
autodoc_preserve_defaults = True
autodoc_type_aliases = {"Array": "Array", "ArrayLike": "ArrayLike"}

sphinx_gallery_conf = {
    "examples_dirs": ["notebooks"],
    "gallery_dirs": ["gallery"],
    "filename_pattern": r"\.py$",  # all are run
    "within_subsection_order": "FileNameSortKey",
    "abort_on_example_error": True,
    "image_scrapers": ("matplotlib", "plotted.last_figure"),
    "capture_repr": ("_repr_html_", "__repr__"),
    "ignore_repr_types": r"matplotlib\.|builtins\.int",
    "first_notebook_cell": "%matplotlib inline",
    "remove_config_comments": True,
    "min_reported_time": 600,
    "write_computation_times": False,
    "download_all_examples": False,
    "show_signature": False,
    "show_memory": False,
}


def generate(app: Any) -> None:
    """Write the tables and figures that the pages include, and hand over the numbers that their text quotes."""
    app.config.myst_substitutions = import_module("generate").generate_all(HERE / "_generated")


def check_api(_app: Any, env: Any) -> None:
    """Warn of a public name that other documentation could not refer to as ``sweetspot.NAME``."""
    known = {found[0] for found in env.domains["py"].get_objects()}
    for name in import_module("sweetspot").__all__:
        if f"sweetspot.{name}" not in known:
            getLogger(__name__).warning("docs/api.md lacks sweetspot.%s", name)


def setup(app: Any) -> None:
    """Connect the generator."""
    app.connect("builder-inited", generate, priority=100)  # before MyST reads its configuration
    app.connect("env-check-consistency", check_api)

"""The package's docstrings for napoleon: words of an entry below its name, source keys in square brackets as links."""

from __future__ import annotations

import re
from importlib import import_module
from types import FunctionType
from typing import Any

from sphinx.application import Sphinx
from sphinx.util.inspect import TypeAliasForwardRef

CITATION = re.compile(r"\[([a-z][a-z0-9_]*(?:[,;] [^\]]*)?)\]")
SECTIONS = {"Parameters", "Returns"}
ENTRY = re.compile(r"(\S.*?) : (.+)")


def for_napoleon(lines: list[str]) -> list[str]:
    """Return a docstring as napoleon reads it: types stand in signatures, so ``name : words`` is no type but words.

    They go below the name, and running text after a section stands apart from it.
    """
    result: list[str] = []
    section = ""
    for index, line in enumerate(lines):
        if index and re.fullmatch(r"-{3,}", line.strip()):
            section = lines[index - 1].strip()
        elif section and line[:1].strip() and not lines[index - 1].strip():
            section = ""
            result.append("")
        entry = ENTRY.fullmatch(line) if section in SECTIONS else None
        result += [entry[1], f"    {entry[2]}"] if entry else [line]
    return result


def linked(line: str, keys: set[str]) -> str:
    """Return a line with source keys in square brackets as links to the page of sources."""

    def link(match: re.Match[str]) -> str:
        words = re.split(r"([;, ]+)", match[1])
        return "[" + "".join(f":ref:`{word} <source-{word}>`" if word in keys else word for word in words) + "]"

    return CITATION.sub(link, line)


def process(*event: Any) -> None:
    """Convert in place the docstring that an autodoc event carries last."""
    lines: list[str] = event[-1]
    keys = set(import_module("sweetspot.references").keys())
    lines[:] = [line if ">>>" in line else linked(line.replace("|", r"\|"), keys) for line in for_napoleon(lines)]


def show_own_signatures() -> None:
    """Let autodoc show the signature of each public function, and not look for its defaults in what it wraps."""
    package = import_module("sweetspot")
    for thing in (getattr(package, name) for name in package.__all__):
        if isinstance(thing, FunctionType):
            vars(thing).pop("__wrapped__", None)


def setup(app: Sphinx) -> dict[str, Any]:
    """Listen to autodoc."""
    show_own_signatures()
    app.connect("autodoc-process-docstring", process, priority=400)  # napoleon listens at 500
    TypeAliasForwardRef.__repr__ = lambda alias: alias.name  # the names of our arrays, as the source writes them
    return {"version": "1", "parallel_read_safe": True, "parallel_write_safe": True}

"""Turn the package's docstrings into field lists: sections of ``name : text`` lines, source keys in square brackets."""

from __future__ import annotations

import re
from collections.abc import Iterable
from importlib import import_module
from typing import Any

from sphinx.application import Sphinx

CITATION = re.compile(r"\[([a-z][a-z0-9_]*(?:[,;] [^\]]*)?)\]")
FIELDS = {"Parameters": "param", "Raises": "raises", "Returns": "returns"}
RUBRICS = ("Notes",)


def converted(lines: list[str]) -> list[str]:
    """Return a docstring with its underlined sections as reStructuredText fields."""
    result: list[str] = []
    index = 0
    while index < len(lines):
        title = lines[index].strip()
        underlined = index + 1 < len(lines) and re.fullmatch(r"-{3,}", lines[index + 1].strip())
        if underlined and title in FIELDS:
            end = _section_end(lines, index + 2)
            result += ["", *_fields(FIELDS[title], lines[index + 2 : end]), ""]
            index = end
        elif underlined and title in RUBRICS:
            result += ["", f".. rubric:: {title}", ""]
            index += 2
        else:
            result.append(lines[index])
            index += 1
    return result


def _section_end(lines: list[str], start: int) -> int:
    """Return where a section ends: before the next underlined title, or text after an empty line, or at the end."""
    for index in range(start, len(lines)):
        next_title = index + 1 < len(lines) and re.fullmatch(r"-{3,}", lines[index + 1].strip())
        after_gap = index > start and not lines[index - 1].strip() and lines[index].strip()
        if next_title or after_gap:
            return index
    return len(lines)


def _fields(field: str, lines: list[str]) -> Iterable[str]:
    """Yield one field per entry: ``names : text`` with continuation lines indented, or a name with text below it."""
    for line in lines:
        if line[:1].strip():  # not indented: a new entry
            names, colon, text = line.partition(" : ")
            if field == "param":
                yield from (f":param {name}: {text if colon else ''}" for name in names.split(", "))
            elif field == "raises":
                yield f":raises {names}: {text}"
            else:
                yield f":returns: {names}: {text}".rstrip(": ") + (":" if not colon else "")
        elif line.strip():
            yield "    " + line.strip()


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
    lines[:] = [line if ">>>" in line else linked(line.replace("|", r"\|"), keys) for line in converted(lines)]


def named(*given: Any) -> tuple[str | None, str | None]:
    """Return a signature in which the names of our arrays stand as they are written in the source."""
    signature, returns = given[-2:]
    return tuple(text and ALIAS.sub(r"\1", text) for text in (signature, returns))


ALIAS = re.compile(r"TypeAliasForwardRef\('(\w+)'\)")
"""What Sphinx makes of an alias beside a bar."""


def setup(app: Sphinx) -> dict[str, Any]:
    """Listen to autodoc."""
    app.connect("autodoc-process-docstring", process)
    app.connect("autodoc-process-signature", named)
    return {"version": "1", "parallel_read_safe": True, "parallel_write_safe": True}

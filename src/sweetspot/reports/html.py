"""A document as HTML: a page of its own that needs nothing else, or a fragment for a notebook."""

from __future__ import annotations

import re
from dataclasses import replace
from functools import cache
from io import StringIO
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

from jinja2 import Environment, FileSystemLoader, StrictUndefined
from markupsafe import Markup, escape

from sweetspot import __version__
from sweetspot.references import cite, keys, reference
from sweetspot.reports import document as parts
from sweetspot.reports.quantities import Reader, with_minus_signs
from sweetspot.reports.sentences import read

HERE = Path(__file__).parent
TEMPLATES = HERE / "templates"
SVG = "http://www.w3.org/2000/svg"
CODE = re.compile("`([^`]+)`")
KEY = re.compile(r"\[([a-z]\w+)\]")
XLINK = "{http://www.w3.org/1999/xlink}href"


def page(document: parts.Document, reader: Reader, *, long: bool = False, drawing: bytes | None = None) -> str:
    """Return a document as a whole page, style and pictures inside it.

    Parameters
    ----------
    long : whether details and appendix are open; else they open by a click and do not print.
    drawing : the document's drawing as SVG for this reader, where it was drawn already.
    """
    return _rendered("page.html.j2", document, reader, drawing=drawing, printed=True, long=long)


def fragment(document: parts.Document, reader: Reader) -> str:
    """Return a document as a part of a page that has our style sheet."""
    return _rendered("fragment.html.j2", document, reader)


def notebook_cell(document: parts.Document, reader: Reader) -> str:
    """Return a document as a part of somebody else's page: its few rules of style with it, its colours its own."""
    return _rendered("notebook.html.j2", document, reader, style="notebook.css", colours={})


def page_of(template: str, **parts: Any) -> str:
    """Return a page that is no document, from its template and what is filled in."""
    return _environment().get_template(template).render(**parts)


def _rendered(
    template: str, document: parts.Document, reader: Reader, *, style: str = "page.css",
    colours: dict[str, str] | None = None, drawing: bytes | None = None, printed: bool = False, **more: Any,
) -> str:  # fmt: skip
    def drawn(picture: parts.Picture) -> Markup:
        return _drawn(picture, reader, colours, drawing if picture is document.drawing else None)

    def sheet(picture: parts.Picture) -> Markup | None:
        if not printed or picture.sheet is None:
            return None
        return _drawn(replace(picture, name=f"{picture.name}-sheet", draw=picture.sheet), reader, colours, None)

    return _environment().get_template(template).render(
        document=document, read=lambda words: with_minus_signs(read(words, reader)),
        kind_of=lambda block: type(block).__name__,
        shown=lambda column, cell: with_minus_signs(column.shown(cell, reader)),
        head=lambda column: column.head(reader),
        drawn=drawn, sheet=sheet, told=_told, author=_author, cite=cite, reference=reference,
        version=__version__, style=_style(style), **more,
    )  # fmt: skip


def _told(words: str) -> Markup:
    """Return words whose `code` is set as such, and whose [keys] tell their work to who points at them."""

    def known(found: re.Match[str]) -> str:
        key = found[1]
        return f'[<span title="{escape(cite(key))}">{key}</span>]' if key in keys() else found[0]

    return Markup(KEY.sub(known, CODE.sub(r"<code>\1</code>", str(escape(words)))))


def _author(cited: parts.Cited) -> str:
    """Return the authors and year of a work; its title if it has no authors."""
    work = reference(cited.key)
    named = work.fields.get("shortauthor") or work.authors or work.fields.get("shorttitle") or cite(cited.key)
    return f"{named} ({cited.year})" if cited.year else named


@cache
def _style(name: str) -> Markup:
    return Markup((HERE / name).read_text(encoding="utf-8"))


@cache
def _environment() -> Environment:
    return Environment(
        loader=FileSystemLoader(TEMPLATES), autoescape=True, undefined=StrictUndefined, trim_blocks=True,
        lstrip_blocks=True,
    )  # fmt: skip


def _drawn(picture: parts.Picture, reader: Reader, colours: dict[str, str] | None, drawing: bytes | None) -> Markup:
    """Return a picture as SVG inside the page: its names its own, its colours the page's unless others are given."""
    from sweetspot.reports.pictures.style import PAGE_COLOURS, svg_bytes

    drawn = (drawing or svg_bytes(picture.draw(reader))).decode()
    return Markup(inlined(drawn, name=picture.name, label=read(picture.label, reader),
                          colours=PAGE_COLOURS if colours is None else colours))  # fmt: skip


def inlined(drawing: str, *, name: str, label: str, colours: dict[str, str]) -> str:
    """Return an SVG file as an element of a page.

    What only a file of its own needs (prologue, metadata, fixed size) is left out, every identifier gets ``name`` in
    front, and the colours become variables of the page's style, so that they follow a dark screen.
    """
    ElementTree.register_namespace("", SVG)
    ElementTree.register_namespace("xlink", "http://www.w3.org/1999/xlink")
    root = ElementTree.parse(StringIO(drawing)).getroot()
    for parent in root.iter():
        for child in [child for child in parent if child.tag.endswith("}metadata")]:
            parent.remove(child)
    for size in ("width", "height"):
        root.attrib.pop(size, None)
    root.attrib |= {"role": "img", "aria-label": label}
    for element in root.iter():
        for key, value in list(element.attrib.items()):
            element.set(key, _adapted(key, value, name, colours))
        if element.tag.endswith("}style") and element.text:
            element.text = _coloured(element.text, colours)
    return ElementTree.tostring(root, encoding="unicode", short_empty_elements=True)


def _adapted(key: str, value: str, name: str, colours: dict[str, str]) -> str:
    if key == "id":
        return f"{name}-{value}"
    if key in ("href", XLINK) and value.startswith("#"):
        return f"#{name}-{value[1:]}"
    return (
        _coloured(value.replace("url(#", f"url(#{name}-"), colours)
        if key in ("style", "fill", "stroke") or ("url(#" in value)
        else value
    )


def _coloured(text: str, colours: dict[str, str]) -> str:
    for colour, variable in colours.items():
        text = text.replace(colour, f"var(--{variable})")
    return text

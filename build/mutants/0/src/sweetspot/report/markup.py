"""Small pieces of the printed page: escaped text, tables, and pictures that follow the page's colours."""

from __future__ import annotations

import re
from collections.abc import Sequence
from html import escape

from sweetspot.report.pictures.style import PAGE_COLOURS

Rows = Sequence[Sequence[str]]


class Html(str):
    """Text that is markup already and is not escaped again."""


def text(words: str) -> Html:
    """Return words as markup: escaped, unless they are markup already."""
    return words if isinstance(words, Html) else Html(escape(words))


def paragraphs(many: Sequence[str]) -> Html:
    """Return each text as a paragraph."""
    return Html("\n".join(f"<p>{text(words)}</p>" for words in many))


def bullets(many: Sequence[str]) -> Html:
    """Return a list, one item per text."""
    return Html("<ul>\n" + "\n".join(f"<li>{text(words)}</li>" for words in many) + "\n</ul>")


def table(columns: Sequence[str], rows: Rows, *, numbers: Sequence[int] = (), name: str = "") -> Html:
    """Return a table whose first column names the rows.

    Parameters
    ----------
    columns : headings.
    rows : cells, as many as there are columns.
    numbers : which columns hold numbers and stand to the right, counted from 0.
    name : class, for the style sheet.
    """
    kinds = [' class="number"' if column in numbers else "" for column in range(len(columns))]
    head = "".join(f'<th scope="col"{kind}>{text(words)}</th>' for words, kind in zip(columns, kinds, strict=True))
    body = []
    for row in rows:
        first, *others = (text(cell) for cell in row)
        cells = "".join(f"<td{kind}>{cell}</td>" for cell, kind in zip(others, kinds[1:], strict=True))
        body.append(f'<tr><th scope="row">{first}</th>{cells}</tr>')
    lines = "\n".join(body)
    return Html(
        f'<div class="scroll" tabindex="0"><table class="{name}">\n<thead><tr>{head}</tr></thead>\n'
        f"<tbody>\n{lines}\n</tbody>\n</table></div>"
    )


def section(title: str, *parts: str, name: str) -> Html:
    """Return a section with its heading; ``name`` is its anchor."""
    content = "\n".join(part for part in parts if part)
    heading = f'<h2 id="{name}-title">{text(title)}</h2>'
    return Html(f'<section id="{name}" aria-labelledby="{name}-title">\n{heading}\n{content}\n</section>')


def picture(svg: bytes, *, name: str, label: str, caption: str) -> Html:
    """Return an SVG file as a figure inside the page.

    Its identifiers get a prefix of their own, its colours become those of the page, and what only a file of its
    own needs (prologue, metadata, fixed size) is left out.

    Parameters
    ----------
    name : prefix, unique on the page.
    label : what the picture shows, for people who do not see it.
    caption : shown below it.
    """
    drawing = svg.decode()
    drawing = drawing[drawing.index("<svg") :]
    drawing = re.sub(r"<metadata>.*?</metadata>", "", drawing, flags=re.DOTALL)
    drawing = re.sub(r'(<svg[^>]*?) width="[^"]*"', r"\1", drawing, count=1)
    drawing = re.sub(r'(<svg[^>]*?) height="[^"]*"', r"\1", drawing, count=1)
    drawing = re.sub(r'\b(id="|href="#|url\(#)', rf"\g<1>{name}-", drawing)
    for colour, variable in PAGE_COLOURS.items():
        drawing = drawing.replace(colour, f"var(--{variable})")
    drawing = drawing.replace("<svg", f'<svg role="img" aria-label="{escape(label)}"', 1)
    return Html(
        f'<figure id="{name}">\n<div class="scroll" tabindex="0">{drawing.strip()}</div>\n'
        f"<figcaption>{text(caption)}</figcaption>\n</figure>"
    )

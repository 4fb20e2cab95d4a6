"""A document as files in a folder: a page, its picture, and the numbers."""

from __future__ import annotations

from pathlib import Path

import numpy as np
from pydantic_core import to_json

from sweetspot.report.document import Document
from sweetspot.report.file_set import write_folder
from sweetspot.report.html import page
from sweetspot.report.pictures.files import png_bytes, svg_bytes
from sweetspot.report.quantities import Reader


def write_document(document: Document, folder: Path, *, reader: Reader, long: bool = False) -> list[Path]:
    """Write NAME.html, NAME.json and, where there is a drawing, NAME.png and NAME.svg: all of them or none.

    Parameters
    ----------
    long : whether the page prints its appendix.

    Raises
    ------
    InputError
        when the folder cannot be made or written; it is then as it was.
    """
    pictures: dict[str, bytes] = {}
    if document.drawing is not None:
        figure = document.drawing.draw(reader)
        pictures = {".png": png_bytes(figure), ".svg": svg_bytes(figure)}
    html = page(document, reader, long=long, drawing=pictures.get(".svg"))
    contents = {".html": html.encode(), ".json": as_json(document), **pictures}
    named = {document.name + ending: content for ending, content in contents.items()}
    return write_folder(folder, named | {name: make(reader) for name, make in document.attachments.items()})


def as_json(document: Document) -> bytes:
    """Return the numbers of a document as JSON text; what is not finite is null there, as JSON has neither."""
    return to_json(document.data, indent=1, inf_nan_mode="null", fallback=np.ndarray.tolist) + b"\n"

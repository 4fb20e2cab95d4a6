"""The files that the server hands out: all are read when it starts, so no path of a request ever reaches the disk."""

from __future__ import annotations

import gzip
import hashlib
import json
from dataclasses import dataclass
from pathlib import Path

from sweetspot import __version__
from sweetspot.reports.quantity_table import quantity_data
from sweetspot.web.controls import CARRIED
from sweetspot.web.page_modules import FOLDER, without_comments
from sweetspot.web.views import GROUP_OF, VIEWS

TYPES = {
    ".html": "text/html; charset=utf-8",
    ".js": "text/javascript; charset=utf-8",
    ".css": "text/css; charset=utf-8",
    ".svg": "image/svg+xml",
}


@dataclass(frozen=True)
class File:
    """A file's content, the same for those who can unpack it, and what a browser must know of it."""

    content: bytes
    packed: bytes
    media_type: str
    tag: str


def static_files() -> dict[str, File]:
    """Return every file of the page by its path below /static/; the table of quantities is one, as a module."""
    paths = (path for path in sorted(FOLDER.rglob("*")) if path.suffix in TYPES)
    files = {path.relative_to(FOLDER).as_posix(): _file(_sent(path), path.suffix) for path in paths}
    return files | {"quantities.js": _file(f"export default {json.dumps(quantity_data())};\n".encode(), ".js")}


def shell(template: File) -> File:
    """Return the page's shell with the views and their controls written into it."""
    views = [
        {
            "name": view.name,
            "title": view.title,
            "group": GROUP_OF.get(view.name, ""),
            "schema": view.state.model_json_schema(),
        }
        for view in VIEWS.values()
    ]
    facts = json.dumps({"version": __version__, "views": views, "carried": CARRIED}).replace("<", "\\u003c")
    return _file(template.content.replace(b"@facts@", facts.encode()), ".html")


def _sent(path: Path) -> bytes:
    """Return a file as browsers get it."""
    return without_comments(path.read_text(encoding="utf-8")).encode() if path.suffix == ".js" else path.read_bytes()


def _file(content: bytes, suffix: str) -> File:
    tag = f'"{hashlib.sha256(content).hexdigest()[:20]}"'
    return File(content, gzip.compress(content, mtime=0), TYPES[suffix], tag)

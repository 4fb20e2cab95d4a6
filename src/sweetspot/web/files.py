"""The files that the server hands out: all are read when it starts, so no path of a request ever reaches the disk."""

from __future__ import annotations

import gzip
import hashlib
import json
from dataclasses import dataclass
from pathlib import Path

from sweetspot import __version__
from sweetspot.reports.quantity_table import quantity_data
from sweetspot.web.bundle import LATER, in_two
from sweetspot.web.controls import CARRIED
from sweetspot.web.page_modules import FOLDER, without_comments
from sweetspot.web.views import GROUP_OF, VIEWS

TYPES = {
    ".html": "text/html; charset=utf-8",
    ".js": "text/javascript; charset=utf-8",
    ".css": "text/css; charset=utf-8",
    ".svg": "image/svg+xml",
}
PAGE, SHELL = "page.js", "shell/main.js"
WANTED_LATER = ("shell/exports.js", "bat/wizard.js")
"""Modules beside the views that are wanted when something is pressed."""


@dataclass(frozen=True)
class File:
    """A file's content, the same for those who can unpack it, and what a browser must know of it."""

    content: bytes
    packed: bytes
    media_type: str
    tag: str


def static_files() -> dict[str, File]:
    """Return every file of the page by its path below /static/.

    Besides the modules one by one, with the table of quantities as one of them, there are two files with all of them:
    what the first page needs, and the rest.
    """
    texts = {
        path.relative_to(FOLDER).as_posix(): _sent(path) for path in sorted(FOLDER.rglob("*")) if path.suffix in TYPES
    }
    texts["quantities.js"] = f"export default {json.dumps(quantity_data())};\n"
    modules = {path: text for path, text in texts.items() if path.endswith(".js") and not path.startswith("offline/")}
    views = [f"views/{name}.js" for name in VIEWS]
    texts[PAGE], texts[LATER] = in_two((views[0], SHELL), (*views, *WANTED_LATER), modules)
    return {path: _file(text.encode(), Path(path).suffix) for path, text in texts.items()}


def shells(template: File) -> dict[str, File]:
    """Return the page's shell by the view that somebody comes to, with the views and their controls written into it."""
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
    first, *others = VIEWS
    content = template.content.replace(b"@facts@", facts.encode())
    at_once, soon = (
        _file(content.replace(b"@needed@", needed.encode()), ".html")
        for needed in ("", f'<link rel="modulepreload" href="/static/{LATER}">')
    )
    return {"": at_once, first: at_once, **dict.fromkeys(others, soon)}


def _sent(path: Path) -> str:
    """Return a file as browsers get it."""
    text = path.read_text(encoding="utf-8")
    return without_comments(text) if path.suffix == ".js" else text


def _file(content: bytes, suffix: str) -> File:
    tag = f'"{hashlib.sha256(content).hexdigest()[:20]}"'
    return File(content, gzip.compress(content, mtime=0), TYPES[suffix], tag)

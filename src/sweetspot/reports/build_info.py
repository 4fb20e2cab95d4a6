"""The version that made an answer, and its commit where the program runs from a checkout or was installed from one."""

from __future__ import annotations

import json
import re
from contextlib import suppress
from functools import cache
from importlib.metadata import PackageNotFoundError, distribution
from pathlib import Path

import sweetspot

COMMIT = re.compile(r"[0-9a-f]{40}")


@cache
def commit() -> str | None:
    """Return the commit of the running program; None for a release."""
    return _of_checkout(Path(sweetspot.__file__).resolve().parents[2]) or _of_installation()


def made_with() -> dict[str, str | None]:
    """Return version and commit, as every JSON answer has them.

    >>> sorted(made_with())
    ['commit', 'version']
    """
    return {"version": sweetspot.__version__, "commit": commit()}


def version_words() -> str:
    """Return the version, and the beginning of the commit where there is one, as ``--version`` prints them."""
    found = commit()
    return sweetspot.__version__ + (f" ({found[:8]})" if found else "")


def _of_checkout(root: Path) -> str | None:
    """Return the commit that a checkout stands on; None: this folder is none of this project."""
    pointer = root / ".git"
    if not (root / "pyproject.toml").is_file() or not (root / "src" / "sweetspot").is_dir() or not pointer.exists():
        return None
    with suppress(OSError, ValueError, IndexError):
        folder = pointer if pointer.is_dir() else root / pointer.read_text(encoding="utf-8").split(":", 1)[1].strip()
        shared = folder / "commondir"
        common = folder / shared.read_text(encoding="utf-8").strip() if shared.is_file() else folder
        head = (folder / "HEAD").read_text(encoding="utf-8").strip()
        name = head.removeprefix("ref: ")
        if name == head:
            return _whole(head)
        for place in (folder, common):
            if (place / name).is_file():
                return _whole((place / name).read_text(encoding="utf-8").strip())
        for line in (common / "packed-refs").read_text(encoding="utf-8").splitlines():
            if line.endswith(f" {name}"):
                return _whole(line.split()[0])
    return None


def _of_installation() -> str | None:
    """Return the commit that pip installed from, as it wrote it down; None: from an index or a file."""
    try:
        text = distribution("sweetspot").read_text("direct_url.json")
    except PackageNotFoundError:
        return None
    with suppress(ValueError, AttributeError):
        return _whole(str(json.loads(text or "{}").get("vcs_info", {}).get("commit_id", "")))
    return None


def _whole(text: str) -> str | None:
    return text if COMMIT.fullmatch(text) else None

"""The files of one answer: never half-written, and together or not at all."""

from __future__ import annotations

import os
import shutil
import tempfile
import time
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import TYPE_CHECKING

from sweetspot.errors import InputError

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from sweetspot.reports.document import Document
    from sweetspot.reports.quantities import Reader

WAITING = ".sweetspot-"
"""How folders begin in which files wait until all of them are written."""
ABANDONED = 3600.0
"""s after which such a folder is a killed run's."""


def write_all(contents: dict[Path, bytes]) -> None:
    """Write files of one folder so that each is replaced whole, and none is touched unless all could be written.

    Everything goes to a new hidden folder beside the targets and to the disk first; only then they take the final
    names. A link in place of a target is replaced, not followed.

    Raises
    ------
    InputError
        when a file cannot be written; the old files are then as they were.
    """
    target = Path()
    try:
        for target in contents:
            if target.is_dir() and not target.is_symlink():
                raise InputError(f"{target} is a folder, so no file of that name can be written; move it away")
        with _beside(next(iter(contents)).parent) as waiting:
            for target, content in contents.items():
                _write_to_disk(waiting / target.name, content)
            _take_places(waiting, list(contents))
    except OSError as error:
        reason = (error.strerror or str(error)).lower()
        raise InputError(f"{target} cannot be written: {reason}; choose another folder") from None


def write_folder(folder: Path, contents: Mapping[str, bytes]) -> list[Path]:
    """Write files into a folder, which is made if need be: all of them, or none and no folder either.

    A folder that is made appears under its name with everything in it.

    Parameters
    ----------
    contents : what each file holds, by its name.

    Raises
    ------
    InputError
        when the folder cannot be made or written.
    """
    place = folder.resolve() if ".." in folder.parts else folder
    files = [place / name for name in contents]
    missing = [path for path in (place, *place.parents) if not path.exists()]
    if not missing:
        write_all(dict(zip(files, contents.values(), strict=True)))
        return files
    what = f"{folder} cannot be made"
    try:
        with _beside(missing[-1].parent) as waiting:
            inside = waiting / "new" / place.relative_to(missing[-1])
            inside.mkdir(parents=True)
            for name, content in contents.items():
                what = f"{folder / name} cannot be written"
                _write_to_disk(inside / name, content)
            what = f"{folder} cannot be made"
            _sync(inside)
            (waiting / "new").rename(missing[-1])
        _sync(missing[-1].parent)
    except OSError as error:
        reason = (error.strerror or str(error)).lower()
        raise InputError(f"{what}: {reason}; choose another folder") from None
    return files


@contextmanager
def _beside(folder: Path) -> Iterator[Path]:
    """Make a hidden folder in another; remove it with what is left in it, and those that killed runs left behind."""
    for left in folder.glob(f"{WAITING}*"):
        with suppress(OSError):
            if time.time() - left.lstat().st_mtime > ABANDONED:
                shutil.rmtree(left, ignore_errors=True)
    waiting = Path(tempfile.mkdtemp(prefix=WAITING, dir=folder))
    try:
        yield waiting
    finally:
        shutil.rmtree(waiting, ignore_errors=True)


def _write_to_disk(path: Path, content: bytes) -> None:
    with path.open("xb") as file:
        file.write(content)
        file.flush()
        os.fsync(file.fileno())


def _take_places(waiting: Path, targets: list[Path]) -> None:
    """Give files their final names; give the old ones theirs back when one of them cannot be replaced."""
    old = waiting / "old"
    old.mkdir()
    for target in targets:
        if os.path.lexists(target):
            _keep(target, old / target.name)
    taken: list[Path] = []
    try:
        for target in targets:
            taken.append(target)
            (waiting / target.name).replace(target)
    except BaseException:
        for target in taken:
            with suppress(OSError):
                if os.path.lexists(old / target.name):
                    (old / target.name).replace(target)
                elif not (waiting / target.name).exists():  # the new file got its place, where there was none
                    target.unlink()
        raise
    _sync(targets[0].parent)


def _keep(path: Path, other: Path) -> None:
    """Give a file a second name; where the system has no such thing, copy it."""
    try:
        os.link(path, other, follow_symlinks=False)
    except (OSError, NotImplementedError):
        shutil.copy2(path, other, follow_symlinks=False)


def _sync(folder: Path) -> None:
    """Make the names in a folder as lasting as its files."""
    with suppress(OSError):  # not every system can
        handle = os.open(folder, os.O_RDONLY)
        try:
            os.fsync(handle)
        finally:
            os.close(handle)


def files_of(name: str) -> tuple[str, ...]:
    """Return the files that a document of this name is written to."""
    return tuple(name + ending for ending in (".html", ".json", ".png", ".svg"))


def check_folder(folder: Path, names: Sequence[str]) -> None:
    """Refuse a folder that a report of files with these names could not be written to, without touching anything.

    Raises
    ------
    InputError
        when it is a file, lies below one, cannot be written, or has a folder where a report's file would go.
    """
    existing = next(path for path in (folder, *folder.absolute().parents) if os.path.lexists(path))
    if not existing.is_dir():
        raise InputError(f"{folder} cannot be made a report's folder: {existing} is not a folder; choose another place")
    if not os.access(existing, os.W_OK | os.X_OK):
        raise InputError(f"{folder} cannot be written: no permission to write in {existing}; choose another folder")
    for name in names:
        if (folder / name).is_dir():
            raise InputError(f"{folder / name} is a folder where a file of the report would go; choose another folder")


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
    from sweetspot.reports.html import page
    from sweetspot.reports.pictures.style import png_bytes, svg_bytes

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
    import numpy as np
    from pydantic_core import to_json

    from sweetspot.reports.build_info import made_with

    return (
        to_json({**document.data, "made_with": made_with()}, indent=1, inf_nan_mode="null", fallback=np.ndarray.tolist)
        + b"\n"
    )


def save(figure: Figure, path: Path) -> Path:
    """Write a figure as PNG or SVG, by the name's ending, whole or not at all.

    Raises
    ------
    InputError
        for another ending, or when the file cannot be written.
    """
    from sweetspot.reports.pictures.style import png_bytes, svg_bytes

    if path.suffix.lower() not in (".png", ".svg"):
        raise InputError(f"{path} has no ending that is understood; write to a name that ends in .png or .svg")
    write_all({path: png_bytes(figure) if path.suffix.lower() == ".png" else svg_bytes(figure)})
    return path

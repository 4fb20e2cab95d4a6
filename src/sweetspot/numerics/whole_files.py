"""Files that are there whole or not at all, and what a writer that was killed left beside them.

A writer holds a lock on the file that waits beside its target. The system lets go of it when the process dies, on
whatever machine that shares the folder it ran, so an acquired lock distinguishes a file that no process writes any
more from one under way; a process number would show neither another machine nor a number given out again.
"""

from __future__ import annotations

import hashlib
import os
import re
import secrets
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from importlib import import_module
from pathlib import Path
from typing import Any, BinaryIO

ALGORITHM, DIGEST_SIZE = "sha256", 32
"""Twice as fast as any other of Python's where the processor has it built in, 1.4 GB/s and more; and its bytes."""


def digest(content: bytes) -> bytes:
    """Return the digest of some bytes; any other bytes have another."""
    return hashlib.new(ALGORITHM, content).digest()


def file_digest(path: Path) -> str:
    """Return the digest of a whole file, in hexadecimal digits; it is read piece by piece."""
    with path.open("rb") as file:
        return hashlib.file_digest(file, ALGORITHM).hexdigest()


locks: Any
try:
    locks = import_module("fcntl")
except ImportError:  # Windows removes no file that a process has open, which is as good as a lock
    locks = None


@contextmanager
def written_whole(path: Path) -> Iterator[BinaryIO]:
    """Yield a file that takes a name once all is written and on the disk; after an error nothing of it is left.

    Parameters
    ----------
    path : the name; its folder is made if need be.
    """
    path.parent.mkdir(parents=True, exist_ok=True)
    waiting, file = _opened(path)
    try:
        with file:
            yield file
            file.flush()
            os.fsync(file.fileno())
            if locks is not None:  # still locked: no process can take it for left behind
                waiting.replace(path)
        if locks is None:  # an open file cannot be renamed there
            waiting.replace(path)
    finally:
        with suppress(OSError):
            waiting.unlink(missing_ok=True)


def refusal(error: BaseException) -> tuple[int, str] | None:
    """Return number and words of what the system refused, also where another library tells of it; else None.

    >>> refusal(ValueError("underlying IO error: No space left on device (os error 28)"))
    (28, 'no space left on device')
    """
    code = re.search(r"\(os error (\d+)\)", str(error))
    number = int(code[1]) if code else getattr(error, "errno", None)
    return None if number is None else (number, os.strerror(number).lower())


def _opened(path: Path) -> tuple[Path, BinaryIO]:
    """Return a new locked file beside another; one that was swept before it was locked is made again."""
    while True:
        waiting = path.with_name(f".{path.name}.{secrets.token_hex(8)}")
        file = waiting.open("xb")
        if locks is None:
            return waiting, file
        with suppress(OSError):  # some shared folders know no locks: nothing is swept there
            locks.flock(file, locks.LOCK_EX)
        if waiting.exists():
            return waiting, file
        file.close()


def sweep(folder: Path, names: str) -> None:
    """Remove what killed writers left of some files in a folder; what is being written, by whatever process, stays.

    Parameters
    ----------
    folder : where the files are.
    names : a pattern of what they are called, as `Path.glob` takes it.
    """
    for path in folder.glob(f".{names}.*"):
        with suppress(OSError), path.open("rb") as file:
            if locks is not None:
                locks.flock(file, locks.LOCK_EX | locks.LOCK_NB)
                path.unlink()
        if locks is None:
            with suppress(OSError):
                path.unlink()

"""Standard output, held back until a command has written its files, and what may go wrong when it is let go."""

from __future__ import annotations

import io
import os
import sys
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from typing import TextIO

from sweetspot.reports.plain_signs import spelled_for


class OutputError(Exception):
    """Standard output cannot take what a command says."""


class _Held(io.StringIO):
    """What is printed until a command is done; asked what kind of terminal it is, it answers for the real one."""

    def __init__(self, stream: TextIO) -> None:
        super().__init__()
        self.stream = stream

    @property
    def encoding(self) -> str:  # type: ignore[override] # the real one's
        return self.stream.encoding or "utf-8"

    def isatty(self) -> bool:
        return self.stream.isatty()

    def fileno(self) -> int:
        return self.stream.fileno()


@contextmanager
def held_output() -> Iterator[None]:
    """Hold standard output back until everything inside is done, then print it; nothing where something failed.

    Raises
    ------
    OutputError
        when standard output is closed, full or broken; a reader that has read enough is no fault.
    """
    stream = sys.stdout
    if sys.stderr is None:
        sys.stderr = open(os.devnull, "w", encoding="utf-8")  # noqa: PTH123, SIM115 - print would take standard output
    held = _Held(stream or io.StringIO())
    sys.stdout = held
    try:
        yield
    except SystemExit:  # --help and --version have printed
        sys.stdout = stream
        _deliver(held.getvalue(), stream)
        raise
    finally:
        sys.stdout = stream
    _deliver(held.getvalue(), stream)


def _deliver(text: str, stream: TextIO | None) -> None:
    """Print a text; signs that the terminal lacks are spelled, and letters that it lacks become question marks."""
    if not text:
        return
    if stream is None:
        raise OutputError("standard output is closed, so nothing could be printed")
    encoding = stream.encoding or "utf-8"
    text = spelled_for(encoding, text)
    readable = text.encode(encoding, "replace").decode(encoding)
    try:
        stream.write(readable)
        stream.flush()
    except BrokenPipeError:
        _abandon(stream)
    except (OSError, ValueError) as error:
        _abandon(stream)
        reason = getattr(error, "strerror", None) or str(error)
        raise OutputError(f"standard output cannot be written: {reason.lower()}") from None
    if readable != text:
        lost = sum(before != after for before, after in zip(text, readable, strict=False))
        print(
            f"sweetspot: {lost} characters that {encoding} does not have were printed as ?; "
            "PYTHONIOENCODING=utf-8 prints them",
            file=sys.stderr,
        )


def _abandon(stream: TextIO) -> None:
    """Send what is still in a stream to nowhere, so that the interpreter's last flush does not fail."""
    with suppress(OSError, ValueError):
        nowhere = os.open(os.devnull, os.O_WRONLY)
        os.dup2(nowhere, stream.fileno())
        os.close(nowhere)

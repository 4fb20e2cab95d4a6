"""Printing: data on stdout, when the command has done everything else; progress on stderr."""

from __future__ import annotations

import csv
import io
import json
import os
import shlex
import sys
import threading
import time
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager, suppress
from contextvars import ContextVar
from dataclasses import replace
from datetime import UTC, datetime
from pathlib import Path
from typing import TYPE_CHECKING, Any, TextIO

from sweetspot.cli.settings import SETTINGS
from sweetspot.numerics.text_files import harmless
from sweetspot.reports.plain_signs import spelled_for

if TYPE_CHECKING:
    from sweetspot.answers.answer import Answer
    from sweetspot.cli.options.output import OutputOptions
    from sweetspot.reports.document import Document
    from sweetspot.reports.quantities import Reader


PATIENCE = 3.0
"""s before a run says that it takes a while."""
BEAT = 1.0
"""s between two looks at how long it has taken."""
WIDE, NARROWEST, LONGEST_LINE = 110, 40, 1000
"""Characters of a line where no terminal says how many there are, at least, and at most."""
QUIET: ContextVar[bool] = ContextVar("QUIET", default=False)
"""Whether standard error is for faults and warnings alone."""


def note(text: str) -> None:
    """Say something on standard error that is neither a fault nor a warning; nothing where quiet was asked for."""
    if not QUIET.get():
        print(f"sweetspot: {text}", file=sys.stderr)


def _shows_progress() -> bool:
    """Return whether somebody watches: a terminal, and quiet was not asked for."""
    return not QUIET.get() and sys.stderr is not None and sys.stderr.isatty()


def print_json(value: Any) -> None:
    """Print one JSON object on stdout."""
    json.dump(value, sys.stdout, indent=2, allow_nan=False)
    sys.stdout.write("\n")


def print_csv(columns: Mapping[str, Sequence[Any]]) -> None:
    """Print columns of equal length as CSV on stdout; None becomes an empty field."""
    writer = csv.writer(sys.stdout, lineterminator="\n")
    writer.writerow(columns)
    writer.writerows([harmless(cell) for cell in row] for row in zip(*columns.values(), strict=True))


def _print(document: Document, reader: Reader) -> None:
    """Print an answer on stdout, as wide as the terminal."""
    from rich.console import Console
    from rich.measure import Measurement

    from sweetspot.reports.terminal import to_terminal

    console = Console(soft_wrap=False)
    if not console.is_terminal:
        console = Console(width=_width_of_pipe())
    renderable = to_terminal(document, reader, encoding=sys.stdout.encoding, room=console.width)
    least = Measurement.get(console, console.options.update_width(LONGEST_LINE), renderable).minimum
    if least > console.width:  # lines that are too long can be read, columns of two letters cannot
        console = Console(width=least)
    console.print(renderable, crop=False)


def _width_of_pipe() -> int:
    """Return how wide a text is that goes into a pipe or a file.

    That is what ``COLUMNS`` says; else `WIDE`, or less where whoever pages through it has less.
    """
    if (columns := os.environ.get("COLUMNS", "")).isdigit() and int(columns) >= NARROWEST:
        return int(columns)
    with suppress(OSError, ValueError, AttributeError):
        return max(NARROWEST, min(WIDE, os.get_terminal_size(sys.stderr.fileno()).columns or WIDE))
    return WIDE


def present(answer: Answer | Document, options: OutputOptions, *, long: bool = False) -> int:
    """Print an answer as it was asked for, its files written first, and return the exit code.

    ``long``: whether a printed page goes on after its first sheet, as it does for who asks for details.
    """
    from sweetspot.reports.notebook import document_of

    written: list[Path] = []
    document = document_of(answer)
    document = replace(document, title=options.title or document.title, made_for=options.made_for, made=made())
    reader = document.reader_of(options.units or SETTINGS.get().units)
    if options.out is not None:
        from sweetspot.reports.files import write_document

        written = write_document(document, options.out, reader=reader, long=long or options.details)
    if options.format == "json":
        from sweetspot.reports.build_info import made_with

        print_json({**document.data, "made_with": made_with()})
    elif options.format == "csv":
        print_csv(document.rows)
    else:
        _print(document.unfolded if options.details else document, reader)
    if written:
        note(f"wrote {', '.join(map(str, written))}")
    return 0 if document.passed else 1


ASKED: ContextVar[Sequence[str]] = ContextVar("ASKED", default=())
"""The words of the command line that is being answered."""


def made() -> str:
    """Return when an answer was made, and from what: the head of a page."""
    words = shlex.join(["sweetspot", *ASKED.get()]) if ASKED.get() else ""
    return f"{today()}{': ' if words else ''}{words}"


def today() -> str:
    """Return the day in words; `SOURCE_DATE_EPOCH` may fix it."""
    fixed = os.environ.get("SOURCE_DATE_EPOCH", "")
    day = datetime.fromtimestamp(int(fixed), UTC) if fixed.isdigit() else datetime.now()
    return f"{day.day} {day:%B %Y}"


@contextmanager
def progress(what: str) -> Iterator[Callable[..., None]]:
    """Yield what shows on a terminal how far the work is; off one, and where quiet was asked for, it shows nothing.

    It is called with (done, total), and perhaps with words about what was found so far.
    """
    if not _shows_progress():
        yield lambda *_: None
        return
    from rich.console import Console
    from rich.progress import BarColumn, Progress, TextColumn, TimeRemainingColumn

    _bars.append(what)
    percent = TextColumn("{task.percentage:>3.0f} %")
    with Progress(
        TextColumn("{task.description}"),
        BarColumn(),
        percent,
        TimeRemainingColumn(),
        console=Console(stderr=True),
        transient=True,
    ) as bar:
        task = bar.add_task(what)

        def show(completed: int, total: int, words: str = "") -> None:
            bar.update(task, completed=completed, total=total, description=f"{what}, {words}" if words else what)

        try:
            yield show
        finally:
            _bars.remove(what)


_bars: list[str] = []
"""What bars on the terminal are about."""


@contextmanager
def patience() -> Iterator[None]:
    """Show on a terminal, from `PATIENCE` on, how long the work inside has taken, unless a bar does; clear it at last.

    Nothing goes into a log.
    """
    if not _shows_progress():
        yield
        return
    start, over, begun = time.monotonic(), threading.Event(), threading.Event()

    def watch() -> None:
        while not over.wait(PATIENCE if not begun.is_set() else BEAT):
            if not _bars:
                begun.set()
                _overwrite(f"sweetspot: working, {time.monotonic() - start:.0f} s; a first run also compiles kernels")

    with suppress(RuntimeError):  # without another thread there are no messages
        threading.Thread(target=watch, daemon=True, name="patience").start()
    try:
        yield
    finally:
        over.set()
        if begun.is_set():
            _overwrite("")


def _overwrite(text: str) -> None:
    """Write over the last line of the terminal."""
    with suppress(OSError, ValueError):
        sys.stderr.write(f"\r\033[K{text}")
        sys.stderr.flush()


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

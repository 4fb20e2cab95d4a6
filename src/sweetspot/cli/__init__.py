"""The command line: thin. Parses, calls the library, prints. Heavy imports happen inside the commands."""

from __future__ import annotations

import gc
import os
import sys
import warnings
from collections.abc import Iterator
from contextlib import contextmanager, nullcontext, suppress
from typing import Any

from sweetspot.errors import SweetspotError, UnusualWarning, missing_extras_named
from sweetspot.plausibility import insisting
from sweetspot.reports.plain_signs import spelled_for

EXIT_BAD_INPUT = 2
EXIT_INTERRUPTED = 130
INTERACTIVE = ("app", "new")
"""Commands that wait for somebody."""
NOT_A_WORD = ("--quiet", "-q")
"""Of every command: nothing on standard error but faults and warnings."""
UNTIDIED = 100_000
"""New objects between two looks for garbage: a command makes a million that stay, and looking takes a tenth of it."""
NARROWEST_HELP = 20
"""Letters of a line of help at least: in one or two, rich looks for room in its boxes and never ends."""
FORCE = "--force"
"""Takes every number as it is given, whatever is usual; every command understands it."""


def main(arguments: list[str] | None = None) -> None:
    """Run the command line; exit 0 when done, 1 when a checked thing failed, 2 on bad input with one clear message.

    What a command prints comes out when it has done everything else, so that no terminal, pipe or full disk at the
    other end costs the files it writes.
    """
    gc.set_threshold(UNTIDIED, *gc.get_threshold()[1:])
    os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # our matrices are small; threads only get in each other's way
    if (columns := os.environ.get("COLUMNS", "")).isdigit() and int(columns) < NARROWEST_HELP:
        os.environ["COLUMNS"] = str(NARROWEST_HELP)
    from cyclopts import CycloptsError

    from sweetspot.cli.app import app, load_all
    from sweetspot.cli.complaints import ALWAYS_SURE, SURE, uncounted, understood, with_own_bat
    from sweetspot.cli.output import ASKED, QUIET, OutputError, held_output, patience
    from sweetspot.cli.settings import SETTINGS, read_settings

    given = sys.argv[1:] if arguments is None else arguments
    try:
        QUIET.set(any(each in given for each in NOT_A_WORD))
        SETTINGS.set(read_settings())
        waiting = nullcontext() if given[:1] and given[0] in INTERACTIVE else patience()
        with held_output(), missing_extras_named(), insisting(FORCE in given), _warnings_told(FORCE in given), waiting:
            unasked = (FORCE, *NOT_A_WORD, *((SURE,) if given[:1] and given[0] in ALWAYS_SURE else ()))
            words = with_own_bat(understood([each for each in given if each not in unasked]), SETTINGS.get().bat)
            ASKED.set(tuple(given))
            if dropped := uncounted(given):
                _complain(dropped)
            if not words or words[0].startswith("-"):
                load_all()
            result = app(words, exit_on_error=False, print_error=False, result_action="return_value")
    except (SweetspotError, CycloptsError, OutputError) as error:
        from sweetspot.cli.complaints import one_line

        _complain(one_line(error, given))
        sys.exit(EXIT_BAD_INPUT)
    except OSError as error:  # what no command foresaw: a disk full of a run's own temporary files
        where = f"{error.filename}: " if error.filename else ""
        _complain(f"{where}{(error.strerror or str(error)).lower()}; make room or choose another place")
        sys.exit(EXIT_BAD_INPUT)
    except MemoryError:
        _complain("there is not enough memory for this; nothing was written. Ask for less at once")
        sys.exit(EXIT_BAD_INPUT)
    except KeyboardInterrupt as stopped:
        _complain(str(stopped) or "interrupted; nothing was written")
        sys.exit(EXIT_INTERRUPTED)
    sys.exit(result if isinstance(result, int) else 0)


@contextmanager
def _warnings_told(insisted: bool) -> Iterator[None]:
    """Say warnings of the package in one line each, or nothing to who insists."""

    def say(message: Warning | str, category: type[Warning], *place: Any) -> None:
        if issubclass(category, UnusualWarning):
            _complain(f"warning: {message}")
        else:
            show(message, category, *place)

    with warnings.catch_warnings():
        show = warnings.showwarning
        warnings.simplefilter("ignore" if insisted else "always", UnusualWarning)
        warnings.showwarning = say  # type: ignore[assignment] # what else it is given is handed on
        yield


def _complain(text: str) -> None:
    with suppress(OSError, AttributeError):  # standard error may be closed
        sys.stderr.write(spelled_for(sys.stderr.encoding or "utf-8", f"sweetspot: {text}\n"))

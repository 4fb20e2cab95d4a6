"""The command line: thin. Parses, calls the library, prints. Heavy imports happen inside the commands."""

from __future__ import annotations

import gc
import os
import sys
import warnings
from collections.abc import Iterator
from contextlib import contextmanager, nullcontext, suppress
from itertools import pairwise
from typing import Any

from sweetspot.errors import InputError, SweetspotError, UnusualWarning
from sweetspot.report.plain_signs import spelled_for
from sweetspot.units.usual import insisting

EXIT_BAD_INPUT = 2
EXIT_INTERRUPTED = 130
SERVER = "app"
"""The command that is done when somebody ends it."""
UNTIDIED = 100_000
"""New objects between two looks for garbage: a command makes a million that stay, and looking takes a tenth of it."""
FORCE = "--force"
"""Takes every number as it is given, whatever is usual; every command understands it."""
SURE = "--uncertainty"
ALWAYS_SURE = ("calibrate", "design", "fit-player", "rank", "season", "tap")
"""Commands whose answer has its intervals unasked: they may be asked for them as well, and answer as ever."""
SHORT = {"--json": ("--format", "json"), "--csv": ("--format", "csv"), "-": ("/dev/stdin",)}
"""What other programs have taught people to write, for any command: answers at hand, standard input as the file."""


def main(arguments: list[str] | None = None) -> None:
    """Run the command line; exit 0 when done, 1 when a checked thing failed, 2 on bad input with one clear message.

    What a command prints comes out when it has done everything else, so that no terminal, pipe or full disk at the
    other end costs the files it writes.
    """
    gc.set_threshold(UNTIDIED, *gc.get_threshold()[1:])
    os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # our matrices are small; threads only get in each other's way
    from cyclopts import CycloptsError

    from sweetspot.cli.app import app, load_all
    from sweetspot.cli.output import ASKED, heartbeat
    from sweetspot.cli.standard_output import OutputError, held_output

    given = sys.argv[1:] if arguments is None else arguments
    try:
        beating = nullcontext() if given[:1] == [SERVER] else heartbeat()
        with held_output(), insisting(FORCE in given), _warnings_told(FORCE in given), beating:
            unasked = (FORCE, SURE) if given[:1] and given[0] in ALWAYS_SURE else (FORCE,)
            words = _understood([one for one in given if one not in unasked])
            ASKED.set(tuple(given))
            if not words or words[0].startswith("-"):
                load_all()
            result = app(words, exit_on_error=False, print_error=False, result_action="return_value")
    except (SweetspotError, CycloptsError, OutputError) as error:
        _complain(_one_line(error, given))
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


def _understood(given: list[str]) -> list[str]:
    """Return a command's words with those that other programs have taught people in our own."""
    if any(pair == ("--out", "-") for pair in pairwise(given)):
        raise InputError("--out takes a name; without it the answer goes to standard output")
    return [word for one in given for word in SHORT.get(one, (one,))]


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
    with suppress(OSError, AttributeError):  # nobody listens on standard error
        sys.stderr.write(spelled_for(sys.stderr.encoding or "utf-8", f"sweetspot: {text}\n"))


def _one_line(error: Exception, given: list[str]) -> str:
    from cyclopts.exceptions import MissingArgumentError, UnknownOptionError, UnusedCliTokensError

    if isinstance(error, UnusedCliTokensError):
        left = " ".join(map(str, error.unused_tokens or ()))
        command = " ".join(error.command_chain or ()) or "the command"
        several = (
            "; several bats side by side: sweetspot compare A B" if command in ("report", "hit", "certify") else ""
        )
        return (
            f"{left!r} is more than {command} takes; a name with blanks is written in quotes, and options begin with "
            f"--: see sweetspot {command} --help{several}"
        )
    short = next((one for one in given if SHORT.get(one, ("",))[0] == "--format"), "")
    if isinstance(error, UnknownOptionError) and "--format" in (error.token.keyword, error.token.value) and short:
        return f"{' '.join(error.command_chain or ())} has no {short}: its answer has one form"
    if isinstance(error, UnknownOptionError) and SURE in given:
        command = " ".join(error.command_chain or ())
        return f"{command} has no {SURE}: it tells nothing that is computed from what is not known; leave it out"
    if isinstance(error, MissingArgumentError) and error.argument is not None:
        choices = error.argument.get_choices()
        told = f"{' '.join(error.command_chain or ())} needs {error.argument.name}. {error.argument.parameter.help}" + (
            f" Choices: {', '.join(choices)}." if choices else ""
        )
        negative = any(word[:1] == "-" and word[1:2].isdigit() for word in error.root_input_tokens or ())
        return f"{told} A negative number is written with =, as in --at=-3in." if negative else told
    return " ".join(str(error).split())

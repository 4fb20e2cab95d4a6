"""What the command line says of words that it does not understand: one line each."""

from __future__ import annotations

import re
from collections.abc import Sequence
from itertools import pairwise

from cyclopts.exceptions import (
    CoercionError,
    MissingArgumentError,
    UnknownCommandError,
    UnknownOptionError,
    UnusedCliTokensError,
)

from sweetspot.cli.app import PATHS
from sweetspot.cli.options.reading import option
from sweetspot.errors import InputError, nearest_names
from sweetspot.units.usual_units import TEMPERATURES, WRITTEN

FIELD = re.compile(r"(\w+)(?= was given as | belongs to )")
"""The name that a function's parameter has, which people typed as an option."""
BARE = re.compile(r"[-+]?[\d.,]+")
"""A number that waits for its unit."""
NUMBERS: dict[type | None, str] = {int: "a whole number", float: "a number"}
UNITS = {unit for sizes in (*WRITTEN.values(), TEMPERATURES) for unit in sizes}


def one_line(error: Exception, given: Sequence[str]) -> str:
    """Return a one-line message about an error in a command line.

    ``given``: the words as they were typed.
    """
    if isinstance(error, UnknownCommandError):
        hint = nearest_names(given[0], list(PATHS))
        listed = "" if hint.endswith("?") else " `sweetspot --help` tells of all."
        return f"there is no command {given[0]!r}. {hint}{listed}"
    if isinstance(error, UnusedCliTokensError):
        return _left_over(error, given)
    if isinstance(error, UnknownOptionError):
        return _unknown_option(error, given)
    if isinstance(error, MissingArgumentError) and error.argument is not None:
        return _missing(error)
    if isinstance(error, CoercionError) and error.token is not None and error.target_type in NUMBERS:
        return f"{error.token.keyword} was given as {error.token.value!r}; allowed is {NUMBERS[error.target_type]}"
    words = _as_it_is(error)
    field = FIELD.match(words)
    asked = field and option(field[1])
    return f"{asked}{words[field.end() :]}" if field and asked in {word.split("=")[0] for word in given} else words


def _as_it_is(error: Exception) -> str:
    return " ".join(str(error).split())


def _command(error: MissingArgumentError | UnknownOptionError | UnusedCliTokensError) -> str:
    return " ".join(error.command_chain or ())


def _left_over(error: UnusedCliTokensError, given: Sequence[str]) -> str:
    left, command = list(map(str, error.unused_tokens or ())), _command(error) or "the command"
    for number, unit in pairwise(given):
        if unit in left and unit in UNITS and BARE.fullmatch(number):
            return f"a number and its unit are one word, {number}{unit}, or stand in quotes, '{number} {unit}'"
    several = "; several bats side by side: sweetspot compare A B" if command in ("report", "hit", "certify") else ""
    return (
        f"{' '.join(left)!r} is more than {command} takes; a name with blanks is written in quotes, and options begin "
        f"with --: see sweetspot {command} --help{several}"
    )


def _unknown_option(error: UnknownOptionError, given: Sequence[str]) -> str:
    short = next((word for word in given if word in FORMATS), "")
    if short and "--format" in (error.token.keyword, error.token.value):
        return f"{_command(error)} has no {short}: its answer has one form"
    if SURE in given:
        return (
            f"{_command(error)} has no {SURE}: it tells nothing that is computed from what is not known; leave it out"
        )
    return _as_it_is(error)


def _missing(error: MissingArgumentError) -> str:
    assert error.argument is not None
    choices = error.argument.get_choices()
    message = f"{_command(error)} needs {error.argument.name}. {error.argument.parameter.help}" + (
        f" Choices: {', '.join(choices)}." if choices else ""
    )
    negative = any(word[:1] == "-" and word[1:2].isdigit() for word in error.root_input_tokens or ())
    return f"{message} A negative number is written with =, as in --at=-3in." if negative else message


FORMATS = {"--json": ("--format", "json"), "--csv": ("--format", "csv")}
"""Of any command: answers at hand."""
SHORT = {**FORMATS, "-": ("/dev/stdin",)}
"""And standard input as the file."""
OTHER_NAMES = {
    "--exit-velocity": "--exit-speed",
    "--bat-velocity": "--bat-speed",
    "--swing-speed": "--bat-speed",
    "--pitch-velocity": "--pitch-speed",
    "--altitude": "--elevation",
    "--temp": "--temperature",
    "--weight": "--mass",
    "--ballpark": "--park",
    "--appendix": "--details",
    "-o": "--out",
}
"""Of options, as people call them who bring other programs' words; no command has an option of such a name."""
OTHER_UNITS = {"metric": "si", "imperial": "us"}
ASIDE = {"help": "--help", "version": "--version", "-v": "--version", "-V": "--version"}
"""In a command's place."""
SURE = "--uncertainty"
ALWAYS_SURE = ("calibrate", "design", "fit-player", "rank", "season", "tap")
"""Commands whose answer has its intervals unasked: they may be asked for them as well, and answer as ever."""
ERRORS_ASKED = ("compare", "drop", "fly", "hit", "optimum", "play")
"""Commands that count an error written behind ± only where they are asked for intervals."""


def understood(given: Sequence[str]) -> list[str]:
    """Return the words of a command line with those that stand for others replaced.

    Raises
    ------
    InputError
        for an answer that is to be written to no name.

    >>> understood(["bats", "--json"]), understood(["help", "hit"]), understood(["version"])
    (['bats', '--format', 'json'], ['hit', '--help'], ['--version'])
    >>> understood(["fly", "--exit-velocity=103mph", "--altitude", "5200ft", "--units", "metric"])
    ['fly', '--exit-speed=103mph', '--elevation', '5200ft', '--units', 'si']
    """
    if ("--out", "-") in pairwise(given):
        raise InputError("--out takes a name; without it the answer goes to standard output")
    if given and given[0] in ASIDE:
        command = given[1:2] if given[0] == "help" else ()
        return [*command, ASIDE[given[0]]]
    words = [word for each in given for word in SHORT.get(each, (each,))]
    for place, word in enumerate(words):
        name, equals, value = word.partition("=")
        name = OTHER_NAMES.get(name, name)
        if name == "--units" or words[place - 1] == "--units":
            name, value = OTHER_UNITS.get(name, name), OTHER_UNITS.get(value, value)
        words[place] = f"{name}{equals}{value}"
    return words


OF_ONE_BAT = ("report", "hit", "play", "optimum", "paper", "certify")
"""Commands that begin with one bat."""


def with_own_bat(words: list[str], bat: str | None) -> list[str]:
    """Return the words of a command line with the bat of the settings where it names none.

    >>> with_own_bat(["hit", "--at", "27in"], "mine.toml"), with_own_bat(["report", "youth-30"], "mine.toml")
    (['hit', 'mine.toml', '--at', '27in'], ['report', 'youth-30'])
    """
    unnamed = words[:1] and words[0] in OF_ONE_BAT and (len(words) == 1 or words[1].startswith("--"))
    return [words[0], bat, *words[1:]] if unnamed and bat and "--help" not in words else words


def uncounted(given: Sequence[str]) -> str:
    """Return a word about an error that a command was given and does not count; nothing where it counts them all.

    >>> uncounted(["hit", "r161-ash", "--at", "27in", "--bat-speed", "70mph±2mph"])
    'an error behind ± counts where --uncertainty is given, and here it is not'
    >>> uncounted(["hit", "r161-ash", "--at", "27in", "--bat-speed", "70mph±2mph", "--uncertainty"])
    ''
    """
    dropped = bool(given) and given[0] in ERRORS_ASKED and SURE not in given and any("±" in each for each in given)
    return f"an error behind ± counts where {SURE} is given, and here it is not" if dropped else ""

"""What other programs have taught people to write, read as our own words."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

from sweetspot.errors import InputError

FORMATS = {"--json": ("--format", "json"), "--csv": ("--format", "csv")}
"""Of any command: answers at hand."""
SHORT = {**FORMATS, "-": ("/dev/stdin",)}
"""And standard input as the file."""
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
    """
    if ("--out", "-") in pairwise(given):
        raise InputError("--out takes a name; without it the answer goes to standard output")
    if given and given[0] in ASIDE:
        command = given[1:2] if given[0] == "help" else ()
        return [*command, ASIDE[given[0]]]
    return [word for each in given for word in SHORT.get(each, (each,))]


def uncounted(given: Sequence[str]) -> str:
    """Return a word about an error that a command was given and does not count; nothing where it counts them all.

    >>> uncounted(["hit", "r161-ash", "--at", "27in", "--bat-speed", "70mph±2mph"])
    'an error behind ± counts where --uncertainty is given, and here it is not'
    >>> uncounted(["hit", "r161-ash", "--at", "27in", "--bat-speed", "70mph±2mph", "--uncertainty"])
    ''
    """
    dropped = bool(given) and given[0] in ERRORS_ASKED and SURE not in given and any("±" in each for each in given)
    return f"an error behind ± counts where {SURE} is given, and here it is not" if dropped else ""

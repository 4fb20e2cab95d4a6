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
    return [word for one in given for word in SHORT.get(one, (one,))]

"""Options that would change nothing: they are refused, so that the answer is not mistaken for one that uses them."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from sweetspot.errors import InputError


def given(options: Any, *names: str) -> list[str]:
    """Return those of a group's options that have another value than their default, as they are typed."""
    default = type(options)()
    return [f"--{name.replace('_', '-')}" for name in names if getattr(options, name) != getattr(default, name)]


def refuse_unused(names: Sequence[str], what: str, instead: str) -> None:
    """Raise `InputError` if options were given that belong to something that was not asked for.

    Parameters
    ----------
    what, instead : what they belong to, and what to do to have it.

    Examples
    --------
    >>> refuse_unused(["--plug"], "a corked bat", "add --what-if cork")
    Traceback (most recent call last):
    sweetspot.errors.InputError: --plug belongs to a corked bat; add --what-if cork, or leave it out
    """
    if names:
        belong, them = ("belongs", "it") if len(names) == 1 else ("belong", "them")
        raise InputError(f"{', '.join(names)} {belong} to {what}; {instead}, or leave {them} out")

"""The package's own errors: what was given, what is allowed, what to do."""

from __future__ import annotations


class SweetspotError(Exception):
    """Base of every error that this package raises on purpose."""


class InputError(SweetspotError, ValueError):
    """Something a person gave cannot be used.

    The message is one sentence or two: what was given, what is allowed, what to do.
    The command line prints it as it is and exits with code 2.
    """


class UnusualWarning(UserWarning):
    """What was given can be computed and is like nothing in its sport; probably a unit is wrong."""


def first_line(error: BaseException) -> str:
    r"""Return what another library's error says, in one line of at most 200 letters; its kind where it says nothing.

    >>> first_line(OSError("no such column\nin a long plan")), first_line(OSError())
    ('no such column', 'OSError')
    """
    return str(error).strip().split("\n")[0][:200] or type(error).__name__


def nearest_names(name: str, known: list[str]) -> str:
    """Return a hint that lists the known names closest to ``name``.

    >>> nearest_names("r161", ["r161-ash", "youth-30"])
    'Did you mean r161-ash?'
    """
    import difflib

    close = difflib.get_close_matches(name.lower(), known, n=3, cutoff=0.4)
    close = close or [known_name for known_name in known if name.lower() in known_name][:3]
    if close:
        return f"Did you mean {' or '.join(close)}?"
    return f"Known names: {', '.join(known)}."

"""Errors and warnings of the package: what was given, what is allowed, what to do."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterable, Iterator, Sequence
from contextlib import contextmanager

ALMOST = 0.75
"""Least similarity, from 0 to 1, of two names of which one may be a misspelling of the other. [Our choice.]"""
SPELT_LIKE = 0.65
"""The same for names that are only listed as candidates. [Our choice.]"""
FEW = 3
"""Letters of a name below which the list needs `ALMOST` too: two letters are in many words. [Our choice.]"""
MOST_MEANT, MOST_LISTED, MOST_EXAMPLES = 3, 14, 8
"""Names listed at most: of those spelt alike, of a short list whole, of a long one as examples."""

PACKAGE = "sweetspot"
DISTRIBUTIONS = {"PIL": "pillow", "fontTools": "fonttools", "starlette": "fastapi"}
"""Names under which modules are installed, where they differ."""
REQUIREMENT = re.compile(r"""^([\w.-]+).*;.*\bextra == ['"]([\w-]+)['"]""")
NO_QUESTION = frozenset({"all", "bench", "dev", "docs", "tests"})
"""Extras that hold others, or serve who works on the package."""


class SweetspotError(Exception):
    """Base of every error that this package raises on purpose."""


class InputError(SweetspotError, ValueError):
    """An input that cannot be used.

    The message is one sentence or two: what was given, what is allowed, what to do.
    The command line prints it as it is and exits with code 2.
    """


class MissingExtraError(SweetspotError, ModuleNotFoundError):
    """A package is not installed that only some questions need."""


class UnwritableError(SweetspotError):
    """A result cannot be written: the disk is full or the folder is read-only. The input is not at fault."""


class UnusualWarning(UserWarning):
    """An input can be computed but is unlike anything in its sport, or is partly not understood."""


def first_line(error: BaseException) -> str:
    r"""Return another library's message in one line of at most 200 letters; the error's class if it has none.

    >>> first_line(OSError("no such column\nin a long plan")), first_line(OSError())
    ('no such column', 'OSError')
    """
    return str(error).strip().split("\n")[0][:200] or type(error).__name__


def nearest_names(name: str, names: Sequence[str], *, listed: Sequence[str] | None = None) -> str:
    """Return a hint with the names spelt like ``name``, whole or by a word in them; else with all choices.

    Parameters
    ----------
    listed : the choices as the message lists them; None: ``names``.

    >>> nearest_names("r161", ["r161-ash", "youth-30"]), nearest_names("asch", ["white-ash", "maple"])
    ('Did you mean r161-ash?', 'Did you mean white-ash?')
    >>> nearest_names("nosuch", ["r161-ash", "youth-30"])
    'Known names: r161-ash, youth-30.'
    >>> nearest_names("xx", ["aluminium-7xxx", "cork"])
    'Known names: aluminium-7xxx, cork.'
    """
    import difflib

    def likeness(candidate: str) -> tuple[float, float]:
        """Return the similarity of the closest of the name and its words, then that of the whole name."""
        parts = [candidate, *candidate.replace("-", " ").split()]
        ratios = [difflib.SequenceMatcher(None, asked, part.lower()).ratio() for part in parts]
        return max(ratios), ratios[0]

    asked = name.lower()
    # any two numbers of players share half of their digits
    enough = ALMOST if asked.isdigit() or len(asked) < FEW else SPELT_LIKE
    likely = sorted(((likeness(candidate), candidate) for candidate in names), reverse=True)
    close = [candidate for how, candidate in likely if how[0] >= enough][:MOST_MEANT]
    if close:
        return f"Did you mean {' or '.join(close)}?"
    listed = names if listed is None else listed
    if len(listed) <= MOST_LISTED:
        return f"Known names: {', '.join(listed)}."
    return f"There are {len(listed)}, for example {', '.join(listed[:MOST_EXAMPLES])}."


def maybe_meant(name: str, names: Iterable[str]) -> str:
    """Return a name in quotes, followed by the known name it may misspell, if there is one.

    >>> maybe_meant("r161-asch", ["r161-ash", "youth-30"]), maybe_meant("my gamer", ["r161-ash", "youth-30"])
    ("'r161-asch' (did you mean r161-ash?)", "'my gamer'")
    """
    return _with_meant(name, spelt_almost(name, names))


def spelt_almost(name: str, names: Iterable[str]) -> str | None:
    """Return the known name that ``name`` may misspell; None if there is none.

    >>> spelt_almost("R161-asch", ["r161-ash", "youth-30"]), spelt_almost("my gamer", ["r161-ash", "youth-30"])
    ('r161-ash', None)
    """
    import difflib

    return next(iter(difflib.get_close_matches(name.lower(), list(names), n=1, cutoff=ALMOST)), None)


def _with_meant(name: str, meant: str | None) -> str:
    return f"{name!r} (did you mean {meant}?)" if meant else repr(name)


@contextmanager
def missing_extras_named() -> Iterator[None]:
    """Say of a missing package which extra brings it.

    Raises
    ------
    MissingExtraError
        in the place of `ModuleNotFoundError`, if an extra of this package brings the module.
    """
    try:
        yield
    except ModuleNotFoundError as error:
        name = (error.name or "").partition(".")[0]
        distribution = DISTRIBUTIONS.get(name, name).lower()
        if isinstance(error, MissingExtraError) or (extra := smallest_extras().get(distribution)) is None:
            raise
        message = f"this needs {distribution}, which is not installed: pip install '{PACKAGE}[{extra}]'"
        raise MissingExtraError(message, name=error.name) from error


def smallest_extras() -> dict[str, str]:
    """Return by distribution the smallest extra that brings it, as the installed package says; of two alike the later.

    It is empty where the package is not installed but lies in a folder.

    >>> found = smallest_extras()
    >>> found["polars"], found["av"]
    ('season', 'sound')
    """
    from importlib.metadata import PackageNotFoundError, requires

    try:
        lines = requires(PACKAGE) or []
    except PackageNotFoundError:
        return {}
    pairs = [(found[1].lower(), found[2]) for line in lines if (found := REQUIREMENT.match(line))]
    sizes = Counter(extra for _, extra in pairs)
    largest_first = sorted(pairs, key=lambda pair: -sizes[pair[1]])
    return {name: extra for name, extra in largest_first if extra not in NO_QUESTION}

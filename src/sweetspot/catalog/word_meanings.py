"""What the words of the page and the reports mean, each with its source."""

from __future__ import annotations

from functools import cache
from typing import NamedTuple

from sweetspot.catalog.records import read_table
from sweetspot.references import cite

FILE = "terms.toml"


class Term(NamedTuple):
    """A word that needs one: the names under which it stands, what it means, and the key of its source."""

    key: str
    names: tuple[str, ...]
    words: str
    source: str

    @property
    def cited(self) -> str:
        """The source as people cite it."""
        return cite(self.source)


@cache
def terms() -> tuple[Term, ...]:
    """Return every term.

    >>> next(term.source for term in terms() if term.key == "bbcor")
    'astm_f2219'
    """
    return tuple(Term(key, tuple(one["names"]), one["words"], one["source"]) for key, one in read_table(FILE).items())

"""Which kinds of implements a sport is played with, so that a slip in a file's sport is seen."""

from __future__ import annotations

import tomllib
from functools import cache

from sweetspot.catalog.records import FOLDER, canonical
from sweetspot.errors import InputError


def check_sport(sport: str, *, kind: str) -> None:
    """Refuse a sport of the catalogue that is played with other things.

    Parameters
    ----------
    sport : as a file has it.
    kind : of what the file describes: ``bat``, ``racket``, ...

    Raises
    ------
    InputError
        naming the sports that such a thing may have.

    >>> check_sport("tennis", kind="bat")
    Traceback (most recent call last):
    ...
    sweetspot.errors.InputError: sport was given as 'tennis', and that is played with a racket, not with a bat; \
allowed for a bat: baseball, softball, youth-baseball
    """
    kinds = _kinds()
    found = kinds.get(canonical(sport))
    if found is not None and kind not in found:
        allowed = ", ".join(sorted(one for one, played in kinds.items() if kind in played))
        with_what = " or ".join(f"a {one.replace('-', ' ')}" for one in sorted(found))
        raise InputError(
            f"sport was given as {sport!r}, and that is played with {with_what}, not with a "
            f"{kind.replace('-', ' ')}; allowed for a {kind.replace('-', ' ')}: {allowed}"
        )


@cache
def _kinds() -> dict[str, frozenset[str]]:
    """Return the kinds of implements that the catalogue has for each sport; sports with none are left out."""
    found: dict[str, set[str]] = {}
    for folder in ("bats", "implements"):
        for path in (FOLDER / folder).glob("*.toml"):
            table = tomllib.loads(path.read_text(encoding="utf-8"))
            kind = str(table.get("kind", "bat"))
            found.setdefault(canonical(str(table.get("sport", "baseball"))), set()).add(kind)
    return {sport: frozenset(kinds) for sport, kinds in found.items()}

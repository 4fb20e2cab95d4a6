"""Which kinds of implements a sport is played with, so that a slip in a file's sport is seen."""

from __future__ import annotations

import tomllib
from functools import cache

from sweetspot.catalog.records import FOLDER, canonical, read_table
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
allowed for a bat: baseball, slow-pitch, softball, youth-baseball
    """
    kinds = _kinds()
    played_with = kinds.get(canonical(sport))
    if played_with is not None and kind not in played_with:
        allowed = ", ".join(sorted(one for one, played in kinds.items() if kind in played))
        with_what = " or ".join(f"a {one.replace('-', ' ')}" for one in sorted(played_with))
        raise InputError(
            f"sport was given as {sport!r}, and that is played with {with_what}, not with a "
            f"{kind.replace('-', ' ')}; allowed for a {kind.replace('-', ' ')}: {allowed}"
        )


@cache
def _kinds() -> dict[str, frozenset[str]]:
    """Return the kinds of implements that the catalogue has for each sport, its own and borrowed ones."""
    kinds: dict[str, set[str]] = {}
    kind_of: dict[str, str] = {}
    for folder in ("bats", "implements"):
        for path in (FOLDER / folder).glob("*.toml"):
            table = tomllib.loads(path.read_text(encoding="utf-8"))
            kind_of[path.stem] = str(table.get("kind", "bat"))
            kinds.setdefault(canonical(str(table.get("sport", "baseball"))), set()).add(kind_of[path.stem])
    for sport, table in read_table("sports.toml").items():
        kinds.setdefault(canonical(sport), set()).update(kind_of[name] for name in table.get("implements", ()))
    return {sport: frozenset(those) for sport, those in kinds.items() if those}

"""Leagues by name: their rules for bats as records with source and year."""

from __future__ import annotations

from functools import cache
from typing import Any

from sweetspot.analysis.certification.rules import QUANTITIES, League, Rule
from sweetspot.catalog.balls import DEFAULT_BALL, ball, ball_sport
from sweetspot.catalog.records import canonical, entry, quantity, read_table
from sweetspot.catalog.sports import RULES, sport
from sweetspot.equipment.ball import Ball
from sweetspot.equipment.bat import Bat
from sweetspot.equipment.cricket_bat import CricketBat
from sweetspot.equipment.implement import Implement
from sweetspot.errors import InputError
from sweetspot.plausibility import insisted
from sweetspot.units import Kind

DEFAULT_LEAGUE, WOODEN_LEAGUE = "ncaa", "mlb"
"""Whose rules bats keep whose sport names none, and turned ones of a sport under the first."""
KINDS: dict[str, Kind] = {"m": "length", "m/s": "speed", "kg m^2": "moi"}
"""Kind of a limit's text by the unit of its quantity; every other limit is a ratio."""


def league_names() -> list[str]:
    """Return the names of all leagues in the catalogue."""
    return [canonical(name) for name in read_table(RULES)]


@cache
def league(name: str = DEFAULT_LEAGUE) -> League:
    """Return a league's rules; raises `InputError` with the nearest names for an unknown one.

    >>> league("ncaa").rules[0].most  # BBCOR
    0.5
    """
    key, described = entry(read_table(RULES), name, "league")
    rules = tuple(_rule(table, f"{key} {table['quantity']}") for table in described["rule"])
    return League(canonical(key), described["name"], described["ball"], rules, described.get("superseded", ""))


def leagues_and_ball(name: str, ball_name: str | None = None) -> tuple[list[League], Ball]:
    """Return a league in a list, or "all" that use a ball, and the ball; None: the league's.

    Raises
    ------
    InputError
        for an unknown league, or a ball of another sport.
    """
    if name.strip().lower() == "all":
        ball_name = ball_name or DEFAULT_BALL
        asked = ball(ball_name)
        using = [each for each in map(league, league_names()) if ball(each.ball) == asked]
        if not using:
            raise InputError(f"no league's rules name the ball {ball_name!r}; name one league")
        return using, asked
    chosen = league(name)
    wanted, played = (sport(ball_sport(each)).name.lower() for each in (ball_name or chosen.ball, chosen.ball))
    if wanted != played and not insisted():
        raise InputError(
            f"ball was given as {ball_name}, a ball of {wanted}; {chosen.key} tests bats with a ball of {played}. "
            "Leave it out, or add --force if it is intended"
        )
    return [chosen], ball(ball_name or chosen.ball)


def usual_league(implement: Implement) -> str | None:
    """Return the key of the league whose rules implements like one usually keep; None: no rule on them is known.

    >>> from sweetspot.catalog import load_implement
    >>> [usual_league(load_implement(name)) for name in ("r161-ash", "russell-b5", "cricket-bat", "golf-driver")]
    ['mlb', 'ncaa', 'cricket', None]
    """
    if isinstance(implement, CricketBat):
        return "cricket"
    if not isinstance(implement, Bat):
        return None
    default = sport(implement.sport).rules
    turned = implement.material.family == "wood" and implement.shell is None
    return WOODEN_LEAGUE if default == DEFAULT_LEAGUE and turned else default


def _rule(table: dict[str, Any], what: str) -> Rule:
    kind = KINDS.get(QUANTITIES[table["quantity"]][1], "ratio")
    limits = {side: quantity(table, side, kind, what) for side in ("least", "most")}
    record = table.get("most") or table.get("least") or {"source": table.get("source"), "where": ""}
    return Rule(
        quantity=table["quantity"],
        least=limits["least"],
        most=limits["most"],
        construction=table.get("construction", "any"),
        undecided=table.get("undecided", ""),
        doubt_beyond=table.get("doubt_beyond", ""),
        source=record["source"],
        where=record["where"],
        year=table.get("year"),
        reading=table["reading"],
    )

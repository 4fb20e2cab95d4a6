"""Leagues by name: their rules for bats as records with source and year."""

from __future__ import annotations

from functools import cache
from typing import get_args

from sweetspot.analysis.certification.rules import QUANTITIES, Construction, League, Reading, Rule
from sweetspot.catalog.balls import DEFAULT_BALL, ball, ball_sport
from sweetspot.catalog.records import Entry, canonical, entry, read_table
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
KINDS: dict[str, Kind] = {"m": "length", "m/s": "speed", "kg m^2": "moi", "N": "force", "s": "time"}
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
    rules = tuple(map(_rule, described.tables("rule")))
    return League(canonical(key), described.name, described.text("ball"), rules, described.text("superseded", ""))


def leagues_and_ball(name: str, ball_name: str | None = None) -> tuple[list[League], Ball]:
    """Return a league in a list, or "all" that use a ball, and the ball; None: the league's.

    Raises `InputError` for an unknown league, or a ball of another sport.
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


def _rule(table: Entry) -> Rule:
    quantity = table.text("quantity")
    kind = KINDS.get(QUANTITIES[quantity][1], "ratio")
    record = next((table.table(side) for side in ("most", "least") if side in table), table)
    return Rule(
        quantity=quantity,
        least=table.quantity_or_none("least", kind),
        most=table.quantity_or_none("most", kind),
        construction=table.choice("construction", get_args(Construction), "any"),
        undecided=table.text("undecided", ""),
        doubt_beyond=table.text("doubt_beyond", ""),
        source=record.text("source"),
        where=record.text("where", ""),
        year=int(table.number("year")) if "year" in table else None,
        reading=table.choice("reading", get_args(Reading)),
    )

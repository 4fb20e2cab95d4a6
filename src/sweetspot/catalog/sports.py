"""Sports by name, and how sure what is known of each is."""

from __future__ import annotations

from functools import cache

from sweetspot.catalog.aerodynamic_laws import FILE as AIR
from sweetspot.catalog.aerodynamic_laws import aerodynamics
from sweetspot.catalog.balls import ball_sport
from sweetspot.catalog.bats import DEFAULT_BAT
from sweetspot.catalog.deliveries import delivery_sport
from sweetspot.catalog.files.ball import BALLS
from sweetspot.catalog.implements import implement_tables
from sweetspot.catalog.records import Entry, Record, all_records, canonical, entry, read_table
from sweetspot.equipment.ball import Ball
from sweetspot.equipment.sport import (
    CERTAINTIES,
    Certainty,
    CourtMark,
    DropRule,
    Fact,
    KnownMiss,
    RuleLimit,
    Sport,
    Stroke,
    Terms,
    counted,
)
from sweetspot.flight.aerodynamics import Aerodynamics
from sweetspot.units import Kind

FILE, RULES = "sports.toml", "rules.toml"
DEFAULT_SPORT = "baseball"


UNITS: dict[Kind, str] = {
    "length": "m",
    "mass": "kg",
    "speed": "m/s",
    "moi": "kg m^2",
    "time": "s",
    "frequency": "Hz",
    "force": "N",
    "ratio": "",
}
"""SI unit of every kind of quantity that a sport's numbers can have."""


def sport_names() -> list[str]:
    """Return the names of all sports in the catalogue."""
    return [canonical(name) for name in read_table(FILE)]


@cache
def sport(name: str = DEFAULT_SPORT) -> Sport:
    """Return a sport; raises `InputError` with the nearest names for an unknown one.

    >>> sport("table tennis").balls
    ('table-tennis',)
    """
    key, sport_entry = entry(read_table(FILE), name, "sport")
    stroke = sport_entry.table("stroke")
    return Sport(
        key=canonical(key),
        name=sport_entry.name,
        balls=sport_entry.texts("balls"),
        aerodynamics=sport_entry.text("aerodynamics"),
        stroke=Stroke(
            swing_speed=_fact(stroke.table("swing_speed")),
            from_tip=stroke.quantity("from_tip", "length"),
            ball_speed=_fact(stroke.table("ball_speed")),
            hands=stroke.quantity("hands", "length"),
            pivot=stroke.quantity_or_none("pivot", "length") or 0.0,
        ),
        words=Terms(**sport_entry.table("words")),
        speeds=tuple(map(_fact, sport_entry.tables("speed"))),
        limits=tuple(map(_limit, sport_entry.tables("limit"))),
        marks=tuple(map(_mark, sport_entry.tables("mark"))),
        drops=tuple(map(_drop, sport_entry.tables("drop"))),
        facts=tuple(map(_fact, sport_entry.tables("fact"))),
        terms=tuple(sport_entry.table("terms").items()),
        not_covered=sport_entry.texts("not_covered"),
        misses=tuple(map(_miss, sport_entry.tables("miss"))),
        pitches=sport_entry.texts("pitches"),
        rules=sport_entry.text("rules", ""),
        fields=sport_entry.texts("fields"),
        swing_law=sport_entry.text("swing_law", "baseball"),
    )


def aerodynamics_of_ball(name: str | Ball) -> Aerodynamics:
    """Return the aerodynamic law of a ball, or of the ball of a name in the catalogue or of a file: that of its sport.

    >>> aerodynamics_of_ball("softball-12in") == aerodynamics("softball")
    True
    """
    return aerodynamics(sport(name.sport if isinstance(name, Ball) else ball_sport(name)).aerodynamics)


def pitched_aerodynamics(pitch: str) -> Aerodynamics:
    """Return the aerodynamic law of a pitch of the catalogue: a baseball's own law before it is hit, or its sport's.

    >>> pitched_aerodynamics("slow-pitch") == aerodynamics("softball")
    True
    """
    its = delivery_sport(pitch)
    return aerodynamics("pitched-baseball" if its.endswith("baseball") else sport(its).aerodynamics)


def certainty(name: str) -> dict[Certainty, int]:
    """Return the count of numbers by certainty: those of the sport, its balls, their flight and its implements."""
    return counted([record.kind for record in sport_records(name)])


def sport_records(name: str) -> list[Record]:
    """Return the provenance of every number of a sport, its balls and its implements in the catalogue."""
    game = sport(name)
    records = [
        Record(number.name, number.written, None, number.source, number.where, number.kind) for number in game.numbers()
    ]
    balls = {canonical(key): table for key, table in read_table(BALLS).items()}
    tools = implement_tables()
    air = {canonical(key): table for key, table in read_table(AIR).items()}
    for names, tables in ((game.balls, balls), (sport_implements(game.key), tools), ((game.aerodynamics,), air)):
        records += [record for key in names if key in tables for record in all_records(tables[key], key)]
    return records


@cache
def sport_implements(name: str) -> tuple[str, ...]:
    """Return the names of a sport's implements in the catalogue, the usual one first.

    >>> sport_implements("tennis"), sport_implements("softball")
    (('tennis-racket',), ('fast-pitch',))
    """
    key = sport(name).key
    tools = implement_tables().items()
    names = [name for name, table in tools if canonical(table.text("sport", DEFAULT_SPORT)) == key]
    shared = entry(read_table(FILE), name, "sport")[1].texts("implements")  # of another sport, where it has none
    return tuple(sorted(names, key=lambda name: (name != DEFAULT_BAT, name))) or shared


def _limit(table: Entry) -> RuleLimit:
    """Return a limit of the rules; one that names a league's rule has that rule's record."""
    record, sides = table, ("least", "most")
    if "rule" in table:
        league, quantity = table.text("rule").split()
        rules = read_table(RULES)[league].tables("rule")
        limits = next(rule for rule in rules if rule.text("quantity") == quantity)
        side = next(side for side in sides if side in limits)
        record = limits.table(side)
    else:
        side = table.text("side")
    fact = _fact(record, name=table.name, kind=_kind(table))
    return RuleLimit(**dict(fact), side=side)


def _kind(table: Entry) -> Kind:
    """Return the kind of quantity of a number of a sport: a speed where nothing is said."""
    return table.choice("of", tuple(UNITS), "speed")


def _fact(table: Entry, name: str = "", kind: Kind | None = None) -> Fact:
    """Return the number that a record describes; name and kind of quantity are those in it unless they are given."""
    kind = kind or _kind(table)
    spread = f", spread {table['spread']}" if "spread" in table else ""
    return Fact(
        name=name or table.name,
        value=table.quantity("value", kind),
        unit=UNITS[kind],
        written=f"{table['value']}{spread}",
        source=table.text("source"),
        where=table.text("where", ""),
        kind=table.choice("kind", CERTAINTIES),
    )


def _drop(table: Entry) -> DropRule:
    sizes = {name: table.quantity(name, "length") for name in ("block_thickness", "side", "drop_height")}
    return DropRule(**{**table, **sizes})


def _miss(table: Entry) -> KnownMiss:
    places = {name: table.quantity(name, "length") for name in ("nearest", "farthest")}
    return KnownMiss(**{**table, **places})


def _mark(table: Entry) -> CourtMark:
    name = table.name
    high = _fact(table.table("height"), f"height of the {name}", "length") if "height" in table else None
    distance = _fact(table.table("distance"), name, "length")
    return CourtMark(name=name, distance=distance, height=high, side=table.text("side"))

"""Sports by name, and how sure what is known of each is."""

from __future__ import annotations

from functools import cache
from typing import Any

from sweetspot.catalog.aerodynamic_laws import FILE as AIR
from sweetspot.catalog.aerodynamic_laws import aerodynamics
from sweetspot.catalog.balls import FILE as BALLS
from sweetspot.catalog.balls import ball_sport
from sweetspot.catalog.bats import DEFAULT_BAT
from sweetspot.catalog.deliveries import delivery_sport
from sweetspot.catalog.implements import implement_tables
from sweetspot.catalog.records import Record, all_records, canonical, entry, quantity, read_table
from sweetspot.equipment.sport import Certainty, CourtMark, DropRule, Fact, RuleLimit, Sport, Stroke, Terms, counted
from sweetspot.flight.aerodynamics import Aerodynamics
from sweetspot.plausibility import parse
from sweetspot.units import Kind

FILE, RULES = "sports.toml", "rules.toml"
DEFAULT_SPORT = "baseball"


UNITS: dict[Kind, str] = {
    "length": "m", "mass": "kg", "speed": "m/s", "moi": "kg m^2", "time": "s", "frequency": "Hz", "force": "N",
    "ratio": "",
}  # fmt: skip
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
    stroke = sport_entry["stroke"]
    return Sport(
        key=canonical(key),
        name=sport_entry["name"],
        balls=tuple(sport_entry["balls"]),
        aerodynamics=sport_entry["aerodynamics"],
        stroke=Stroke(
            swing_speed=_known(stroke["swing_speed"]),
            from_tip=parse(stroke["from_tip"], "length", f"{key} from_tip"),
            ball_speed=_known(stroke["ball_speed"]),
            hands=parse(stroke["hands"], "length", f"{key} hands"),
            pivot=parse(stroke.get("pivot", "0 m"), "length", f"{key} pivot"),
        ),
        words=Terms(**sport_entry.get("words", {})),
        speeds=tuple(_known(table) for table in sport_entry.get("speed", ())),
        limits=tuple(_limit(table) for table in sport_entry.get("limit", ())),
        marks=tuple(_mark(table) for table in sport_entry.get("mark", ())),
        drops=tuple(_drop(table) for table in sport_entry.get("drop", ())),
        facts=tuple(_known(table) for table in sport_entry.get("fact", ())),
        terms=tuple((word, meaning) for word, meaning in sport_entry.get("terms", {}).items()),
        not_covered=tuple(sport_entry["not_covered"]),
        pitches=tuple(sport_entry.get("pitches", ())),
        rules=sport_entry.get("rules", ""),
        fields=tuple(sport_entry.get("fields", ())),
        swing_law=sport_entry.get("swing_law", "baseball"),
    )


def aerodynamics_of_ball(name: str) -> Aerodynamics:
    """Return the aerodynamic law of a ball of the catalogue: that of its sport.

    >>> aerodynamics_of_ball("softball-12in") == aerodynamics("softball")
    True
    """
    return aerodynamics(sport(ball_sport(name)).aerodynamics)


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
    names = [name for name, table in implement_tables().items() if canonical(table.get("sport", DEFAULT_SPORT)) == key]
    shared = entry(read_table(FILE), name, "sport")[1].get("implements", ())  # of another sport, where it has none
    return tuple(sorted(names, key=lambda name: (name != DEFAULT_BAT, name))) or tuple(shared)


def _known(table: dict[str, Any]) -> Fact:
    return Fact(**_values(table))


def _limit(table: dict[str, Any]) -> RuleLimit:
    """Return a limit of the rules; one that names a league's rule has that rule's record."""
    if "rule" in table:
        league, quantity_limited = table["rule"].split()
        rules = read_table(RULES)[league]["rule"]
        limits = next(rule for rule in rules if rule["quantity"] == quantity_limited)
        side = next(side for side in ("least", "most") if side in limits)
        table = {**limits[side], "side": side, "name": table["name"], "of": table.get("of", "speed")}
    return RuleLimit(**_values(table), side=table["side"])


def _values(table: dict[str, Any]) -> dict[str, Any]:
    """Return the fields of a `Fact` from a table with ``name``, ``of`` (kind of quantity) and a record."""
    kind: Kind = table.get("of", "speed")
    number = quantity(table, "value", kind, table["name"])
    spread = f", spread {table['spread']}" if "spread" in table else ""
    return {
        "name": table["name"],
        "value": number,
        "unit": UNITS[kind],
        "written": f"{table['value']}{spread}",
        "source": table["source"],
        "where": table.get("where", ""),
        "kind": table["kind"],
    }


def _drop(table: dict[str, Any]) -> DropRule:
    sizes = {name: parse(table[name], "length", name) for name in ("block_thickness", "side", "drop_height")}
    return DropRule(**{**table, **sizes})


def _mark(table: dict[str, Any]) -> CourtMark:
    name = table["name"]
    distance = _known({"name": name, "of": "length", **table["distance"]})
    height = _known({"name": f"height of the {name}", "of": "length", **table["height"]}) if "height" in table else None
    return CourtMark(name=name, distance=distance, height=height, side=table["side"])

"""Coefficients of drag and lift by kind of ball."""

from __future__ import annotations

from dataclasses import replace
from functools import cache

from sweetspot.catalog.records import canonical, entry, read_table
from sweetspot.flight.aerodynamics import Aerodynamics
from sweetspot.flight.batted_spin import NO_SPIN, SHEET, TRACKED, SpinLine
from sweetspot.flight.conditions import FlightConditions
from sweetspot.flight.park import Park
from sweetspot.units import Kind

FILE = "aerodynamics.toml"
DEFAULT_AERODYNAMICS, STILL_AIR, CALCULATOR = "baseball", "baseball-in-still-air", "trajectory-calculator"
BASEBALL = "baseball"
FIELDS: dict[str, Kind] = {
    "drag": "ratio",
    "drag_per_spin": "time",
    "drag_per_active_spin": "time",
    "drag_per_spin_factor": "ratio",
    "drag_per_inverse_reynolds": "ratio",
    "lift_scale": "ratio",
    "lift_offset": "ratio",
    "lift_slope": "ratio",
    "lift_exponent": "ratio",
    "spin_decay_time": "time",
    "spin_decay_speed": "speed",
}
"""Keys of an entry, and the kind of quantity."""


def aerodynamics_names() -> list[str]:
    """Return the names of all entries."""
    return [canonical(name) for name in read_table(FILE)]


@cache
def aerodynamics(name: str = DEFAULT_AERODYNAMICS) -> Aerodynamics:
    """Return the coefficients of a kind of ball; raises `InputError` with the nearest names for an unknown one.

    >>> round(aerodynamics("trajectory-calculator").drag_coefficient(0.2, spin=261.8), 4)  # 0.3008 + 0.0292 x 2.5
    0.3738
    """
    _, table = entry(read_table(FILE), name, "aerodynamics")
    return Aerodynamics(name=table.name, **table.quantities(FIELDS))


def aerodynamics_in(park: Park | None, law: Aerodynamics) -> Aerodynamics:
    """Return a law as it holds in a park: under a roof that never opens no breeze blows on a baseball.

    The baseball's own law has the mean park's breeze in it; any other stays as it is, and so does it under a roof that
    may be open.

    >>> from sweetspot.catalog import park
    >>> aerodynamics_in(park("tropicana"), aerodynamics()) == aerodynamics("baseball-in-still-air")
    True
    >>> aerodynamics_in(park("wrigley"), aerodynamics()) == aerodynamics()
    True
    """
    covered = park is not None and park.roof == "fixed"
    return aerodynamics(STILL_AIR) if covered and law == aerodynamics() else law


def conditions_in(park: Park, outdoors: FlightConditions, *, own_elevation: bool = True) -> FlightConditions:
    """Return the same weather in a park: at its elevation where wanted, with its law of drag (`aerodynamics_in`).

    >>> from sweetspot import catalog, standard_flight
    >>> conditions_in(catalog.park("coors"), standard_flight()).one_air.elevation == catalog.park("coors").elevation
    True
    """
    air = outdoors.one_air.replaced(elevation=park.elevation) if own_elevation else outdoors.one_air
    return replace(outdoors, air=air, aerodynamics=aerodynamics_in(park, outdoors.aerodynamics))


def drag_spread(law: Aerodynamics) -> float:
    """Return the relative uncertainty of the drag of a law of the catalogue; 0 for a law that it does not have.

    >>> round(drag_spread(aerodynamics("baseball")), 4)
    0.0061
    """
    spreads = (table.spread("drag", "ratio") for table in read_table(FILE).values() if table.name == law.name)
    return (next(spreads, None) or 0.0) / law.drag if law.drag > 0 else 0.0


def usual_spin_line(name: str = DEFAULT_AERODYNAMICS) -> SpinLine:
    """Return the line of usual spin that a law was drawn up with: the sheet's own for the trajectory calculator.

    None is known of the balls of other sports than baseball.

    >>> usual_spin_line("trajectory calculator").backspin[0], usual_spin_line("softball") == NO_SPIN
    (-763.0, True)
    """
    if canonical(name) == CALCULATOR:
        return SHEET
    _, table = entry(read_table(FILE), name, "aerodynamics")
    return TRACKED if table.text("sport") == BASEBALL else NO_SPIN

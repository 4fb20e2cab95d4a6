"""The catalog's bats under the standard conditions, analyzed once per build."""

from __future__ import annotations

from functools import cache
from typing import Any

from sweetspot import analyse, catalog, standard_conditions
from sweetspot.analysis.bat_analysis import Analysis
from sweetspot.analysis.optimum import BestSwing, Held, best_swing
from sweetspot.dynamics.reduction import reduced_bat
from sweetspot.flight.air import Air
from sweetspot.flight.conditions import FlightConditions
from sweetspot.units import INCH
from sweetspot.validation.computations.flight import pitch_flight

FLAGSHIP = "r161-ash"


@cache
def analysed(name: str = FLAGSHIP) -> Analysis:
    """Return the full answer for a catalog bat."""
    bat = catalog.bat(name)
    return analyse(bat, standard_conditions(bat))


def from_tip(analysis: Analysis, position: Any) -> Any:
    """Return a position, or an array of them, as inches from the tip."""
    return (analysis.bat.length - position) / INCH


@cache
def best_contact(pitch: str, attack_angle: float | None = None) -> BestSwing:
    """Return the contact of the flagship bat, held level, that carries a catalog pitch farthest."""
    bat, ball = catalog.bat(FLAGSHIP), catalog.ball()
    return best_swing(
        reduced_bat(bat, ball=ball),
        FlightConditions(ball=ball, aerodynamics=catalog.aerodynamics(), air=Air()),
        swing=standard_conditions(bat).swing,
        pitch=pitch_flight(pitch).plate,
        held=Held(attack_angle=attack_angle),
    )

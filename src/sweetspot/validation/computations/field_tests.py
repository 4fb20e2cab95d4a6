"""Bats in the field: metal and composite beside wood, softballs in the air, hoop tones and liveliness."""

from __future__ import annotations

from functools import cache

import numpy as np

from sweetspot import catalog
from sweetspot.analysis.certification.simulated_test import bat_test
from sweetspot.analysis.comparison import Compared, compare
from sweetspot.analysis.trampoline import WallPoint, wall_sweep
from sweetspot.catalog.standard_hit import standard_conditions
from sweetspot.catalog.swing_laws import swing_law
from sweetspot.collision.contact_law import loading_force
from sweetspot.dynamics.hoop import hoop_frequency
from sweetspot.equipment.bat import Bat
from sweetspot.flight.conditions import FlightConditions
from sweetspot.flight.trajectory import Flight, fly
from sweetspot.motion.ball_motion import batted_ball
from sweetspot.units import DEGREE, MPH
from sweetspot.validation.computations import shared
from sweetspot.validation.computations.flight import fly_ball
from sweetspot.validation.computations.sports import SHEET_AIR

TEST_SPEED = 110 * MPH
"""Of a softball on a bat at rest, as standards of softball test it."""


@cache
def _beside(bat: str, other: str, effort: str, stroke: str, pitch_speed: float) -> tuple[Compared[Bat], Compared[Bat]]:
    """Return ``other`` and ``bat`` under one stroke: the usual one of ``stroke``'s sport, known with ``other``."""
    bats = [catalog.bat(other), catalog.bat(bat)]
    sport = catalog.bat(stroke or other).sport
    conditions = standard_conditions(bats[0].replaced(sport=sport))
    if pitch_speed >= 0:
        conditions = conditions.replaced(pitch=conditions.pitch.replaced(speed=pitch_speed))
    law = {"same": swing_law(), "speed": None}[effort]
    first, second = compare(bats, conditions=conditions, law=law).compared
    return first, second


def exit_gain(*, bat: str, other: str, effort: str = "same", ball_speed: float = -1.0) -> float:
    """Return how much faster the best hit of a bat is than that of another one.

    ``effort``: "same" turns the lighter bat faster, "speed" swings both alike. ``ball_speed``: of the pitch; negative:
    the usual one.
    """
    first, second = _beside(bat, other, effort, "", ball_speed)
    return second.exit_speed.value - first.exit_speed.value


def exit_ratio(*, bat: str, other: str, effort: str = "same", ball_speed: float = -1.0) -> float:
    """Return the best hit of a bat over that of another one, less one."""
    first, second = _beside(bat, other, effort, "", ball_speed)
    return second.exit_speed.value / first.exit_speed.value - 1


def carry_gain_of_bat(*, bat: str, other: str) -> float:
    """Return how much farther the best hit of a bat flies, with the usual spin at 28 degrees."""
    first, second = _beside(bat, other, "same", "", -1.0)
    return fly_ball(exit_speed=second.exit_speed.value).carry - fly_ball(exit_speed=first.exit_speed.value).carry


def species_gain(*, bat: str, material: str) -> float:
    """Return the gain of the best exit speed if a bat of this shape is of another wood, swung with the same effort."""
    wood = catalog.bat(bat)
    changed = wood.replaced(material=catalog.material(material), mass=None, balance_point=None, moi=None)
    found = compare([wood, changed], conditions=standard_conditions(wood), law=swing_law())
    return found.compared[1].change.value


def exit_speed_of_stroke(*, bat: str) -> float:
    """Return the best hit of a bat under the usual stroke of its sport."""
    return _beside(bat, bat, "speed", "", -1.0)[1].exit_speed.value


def tee_ratio(*, bat: str) -> float:
    """Return exit speed over bat speed at the best place of a ball at rest."""
    described = catalog.bat(bat)
    conditions = standard_conditions(described, pitch_speed=0.0)
    (found,) = compare([described], conditions=conditions, law=None).compared
    return found.exit_speed.value / conditions.swing.speed_at(found.analysis.best.position)


@cache
def _level_flight(*, ball: str, speed: float, launch_angle: float) -> Flight:
    """Return the flight of a ball from 3 ft above the ground at 70 degF and sea level."""
    start = batted_ball(speed=speed, launch_angle=launch_angle, backspin=0.0, position=(0.0, 0.0, 0.9144))
    law = catalog.aerodynamics_of_ball(ball)
    return fly(start, FlightConditions(ball=catalog.ball(ball), aerodynamics=law, air=SHEET_AIR))


def flight_time(*, ball: str, speed: float, distance: float) -> float:
    """Return the time in which a ball hit or thrown nearly level crosses a distance."""
    flight = _level_flight(ball=ball, speed=speed, launch_angle=4 * DEGREE)
    return float(np.interp(distance, flight.positions[:, 1], flight.times))


def hit_time(*, bat: str, other: str, stroke: str, ball: str, distance: float) -> float:
    """Return that time of the best hit of ``bat``, swung as hard as ``other`` in the stroke of ``stroke``'s sport."""
    speed = _beside(bat, other, "same", stroke, -1.0)[1].exit_speed.value
    return flight_time(ball=ball, speed=round(speed, 3), distance=distance)


def stiffness_ratio(*, ball: str, other: str, pressed: float) -> float:
    """Return the force that presses a ball in by ``pressed`` over that of another ball."""
    return float(loading_force(catalog.ball(ball), pressed) / loading_force(catalog.ball(other), pressed))


@cache
def _sweep(bat: str) -> list[WallPoint]:
    described = catalog.bat(bat)
    return wall_sweep(described, standard_conditions(described), factors=tuple(np.linspace(0.4, 1.4, 11).tolist()))


def tuned_hoop(*, bat: str) -> float:
    """Return hoop frequency times contact time of the liveliest of walls 0.4 to 1.4 times as thick as a bat's."""
    best = max(_sweep(bat), key=lambda point: point.bbcor)
    return best.hoop_frequency * shared.standard(bat).best.contact_time


def least_rise(*, bat: str) -> float:
    """Return the least rise of BBCOR when the wall is thinned by a tenth, from as it is to half as thick."""
    lively = [point.bbcor for point in _sweep(bat)][1:7]
    return float(-np.diff(lively).max())


def hoop_above(*, bat: str, other: str) -> float:
    """Return how much higher the lowest hoop mode of a bat is."""
    return hoop_frequency(shared.beam(bat)) - hoop_frequency(shared.beam(other))


def hoop_of(*, bat: str) -> float:
    """Return the lowest hoop frequency of a bat."""
    return hoop_frequency(shared.beam(bat))


def liveliness_rank(*, bats: list[str]) -> float:
    """Return the rank correlation (Spearman) of BBCOR with the lowest hoop frequency over some bats."""
    from scipy.stats import spearmanr

    tests = [bat_test(shared.beam(b), body=shared.body(b), modes=shared.standard(b).modes, ball=catalog.ball(),
                      closing_speed=136 * MPH).best_bbcor for b in bats]  # fmt: skip
    return float(spearmanr([hoop_of(bat=bat) for bat in bats], tests).statistic)


def livelier(*, bat: str, other: str, ball: str) -> float:
    """Return how much greater the restitution of a bat with a ball is, each at its best place, in a softball's test."""

    def best(name: str) -> float:
        thing = catalog.ball(ball)
        reduced = shared.standard(name).reduced
        return bat_test(
            shared.beam(name), body=shared.body(name), modes=reduced.modes, ball=thing, closing_speed=TEST_SPEED
        ).best_bbcor

    return best(bat) - best(other)

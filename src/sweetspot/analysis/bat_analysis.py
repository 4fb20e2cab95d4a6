"""One bat, one swing, every answer: the whole chain from description to sweet spots.

What a miss costs, and how sure that is: with the ball's law, and with the ends of what is known of it.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Generic, NamedTuple

import numpy as np

from sweetspot.analysis.position_scan import Scan, scan
from sweetspot.analysis.sweet_spot import SweetSpots, miss_cost, sweet_spots
from sweetspot.collision.closed_form import exit_speed
from sweetspot.collision.coupled import hit
from sweetspot.collision.impact import Impact
from sweetspot.collision.kernel import hits
from sweetspot.dynamics.beam import BeamModel
from sweetspot.dynamics.hands import held_modes
from sweetspot.dynamics.modes import Modes
from sweetspot.dynamics.reduction import Given, ReducedBat, Tool_co, reduced_bat
from sweetspot.dynamics.rigid import RigidBody
from sweetspot.equipment.ball import Ball
from sweetspot.equipment.implement import Implement
from sweetspot.errors import InputError
from sweetspot.motion.swing import Conditions, Hands
from sweetspot.numerics.arrays import Array
from sweetspot.numerics.interpolants import top
from sweetspot.numerics.notebook_display import ShownInNotebooks
from sweetspot.units import format_length

TYPICAL_HAND = {"mass": 0.35, "stiffness": 20e3, "damping": 100.0}
"""kg, N/m, N s/m per hand; soft defaults, recalled and not read, used only to show that grip hardly matters."""


@dataclass(frozen=True, repr=False)
class Analysis(ShownInNotebooks, Generic[Tool_co]):
    """Everything computed about one bat under one set of conditions.

    Parameters
    ----------
    modes : of the bat as the collision saw it, free or gripped.
    free : of the bat without hands.
    """

    bat: Tool_co
    conditions: Conditions
    beam: BeamModel
    body: RigidBody
    modes: Modes
    free: Modes
    scan: Scan
    sweet_spots: SweetSpots

    def __repr__(self) -> str:
        return (
            f"<Analysis of {self.bat.name}: best hit {format_length(self.sweet_spots.max_exit_speed)} from the end of "
            "the grip>"
        )

    @property
    def reduced(self) -> ReducedBat[Tool_co]:
        """The bat with its beam, body and free modes."""
        return ReducedBat(self.bat, self.beam, self.body, self.free)

    @property
    def held(self) -> ReducedBat[Tool_co]:
        """The bat with its beam, body and the modes that the collision saw."""
        return ReducedBat(self.bat, self.beam, self.body, self.modes)

    @cached_property
    def best(self) -> Impact:
        """The hit at the place of greatest exit speed."""
        return hit_at(self.sweet_spots.max_exit_speed, modes=self.modes, conditions=self.conditions)

    @cached_property
    def grip_effect(self) -> float:
        """Relative change of the best hit's exit speed when typical hands hold the bat."""
        hands = self.conditions.hands
        typical = Hands(position=hands.position, spacing=hands.spacing, **TYPICAL_HAND)
        with_grip = hit_at(self.best.position, modes=held_modes(self.free, typical), conditions=self.conditions)
        return exit_speed_of(with_grip, self.conditions) / exit_speed_of(self.best, self.conditions) - 1


def analyse(bat: Given, conditions: Conditions) -> Analysis[Given]:
    """Return the full answer for a bat: reduce it, find its modes, hit it everywhere, read off the sweet spots.

    Hands without mass leave the bat free, which is right for the ball's exit (published: grip
    does not matter) and an upper bound for the vibration.

    Parameters
    ----------
    bat : a bat or any other implement, from `catalog.bat`, `catalog.implement`, a file, or made in Python.
    conditions : pitch, swing, ball and hands; `standard_conditions(bat)` gives the usual ones, and its method
        ``replaced`` others.

    Returns
    -------
    Analysis
        ``sweet_spots`` (m from the knob end), ``scan`` (curves along the bat), ``modes``, ``body``, ``best``.

    Raises
    ------
    InputError
        when the swing or the hands do not go with the bat, or the ball outweighs it.

    >>> from sweetspot import analyse, catalog, standard_conditions
    >>> bat = catalog.bat("r161-ash")
    >>> analysis = analyse(bat, standard_conditions(bat))
    >>> round(bat.length - analysis.sweet_spots.max_exit_speed, 2)  # m from the tip
    0.15
    >>> round(float(analysis.scan.exit_speed.max()), 1)  # m/s
    46.6
    """
    return analyse_reduced(reduced_bat(bat, ball=conditions.ball), conditions)


def analyse_reduced(reduced: ReducedBat[Given], conditions: Conditions) -> Analysis[Given]:
    """Return the full answer for a bat whose modes are known already; see `analyse`."""
    check_conditions(reduced, conditions)
    held = reduced.held(conditions.hands)
    along = scan(held, conditions)
    spots = sweet_spots(along, body=reduced.body, modes=reduced.modes, conditions=conditions)
    return Analysis(reduced.bat, conditions, reduced.beam, reduced.body, held.modes, reduced.modes, along, spots)


def hit_at(position: float, *, modes: Modes, conditions: Conditions, lateral: float = 0.0) -> Impact:
    """Return the hit at one place under these conditions.

    ``position``: m from the knob end. ``modes``: those of an `Analysis`. ``lateral``: m across the face from the line.

    >>> from sweetspot import standard_analysis
    >>> from sweetspot.analysis.bat_analysis import exit_speed_of, hit_at
    >>> analysis = standard_analysis("r161-ash")
    >>> impact = hit_at(0.7, modes=analysis.modes, conditions=analysis.conditions)
    >>> round(exit_speed_of(impact, analysis.conditions), 1)  # m/s
    46.5
    """
    closing = conditions.pitch.speed + conditions.swing.speed_at(position)
    return hit(modes, ball=conditions.ball, position=position, lateral=lateral, closing_speed=closing)


def exit_speed_of(impact: Impact, conditions: Conditions) -> float:
    """Return the exit speed in m/s of a hit: q v_ball + (1 + q) v_bat.

    >>> from sweetspot import standard_analysis
    >>> from sweetspot.analysis.bat_analysis import exit_speed_of
    >>> analysis = standard_analysis("r161-ash")
    >>> round(exit_speed_of(analysis.best, analysis.conditions), 1)  # m/s
    46.6
    """
    bat_speed = conditions.swing.speed_at(impact.position)
    return exit_speed(impact.collision_efficiency, ball_speed=conditions.pitch.speed, bat_speed=bat_speed)


def dead_spot(analysis: Analysis[Implement]) -> float | None:
    """Return the place (m from the butt end) beyond the best one where a ball is left with no speed: q = 0; or None."""
    scan = analysis.scan
    beyond = scan.position >= analysis.sweet_spots.max_collision_efficiency
    places, efficiency = scan.position[beyond], scan.collision_efficiency[beyond]
    below = np.flatnonzero(efficiency < 0)
    if len(below) == 0 or below[0] == 0:
        return None
    after = int(below[0])
    return float(np.interp(0.0, efficiency[[after, after - 1]], places[[after, after - 1]]))


def outweighed(body: RigidBody, ball: Ball) -> bool:
    """Return whether the ball weighs as much as what would hit it: then it is not hit, it goes through."""
    return ball.mass >= body.mass


def check_swing(bat: Implement, conditions: Conditions) -> None:
    """Refuse a swing or hands that do not go with the bat."""
    bat.check_position(conditions.hands.position, "hand position")
    swing = conditions.swing
    if swing.measured_at > bat.length + 1e-9:
        raise InputError(
            f"bat speed is measured at {format_length(swing.measured_at)}, beyond the tip at "
            f"{format_length(bat.length)}; give a place on the bat"
        )
    if not -1.0 <= swing.pivot < bat.length / 2:
        raise InputError(
            f"pivot is {format_length(swing.pivot)} from the {bat.grip_end}; allowed is from 1 m behind it to the "
            f"middle, {format_length(bat.length / 2)}"
        )
    if conditions.hands.position > bat.length / 2:
        raise InputError(
            f"hands are at {format_length(conditions.hands.position)}, beyond the middle of the bat at "
            f"{format_length(bat.length / 2)}; hold the handle"
        )


def check_conditions(reduced: ReducedBat[Implement], conditions: Conditions) -> None:
    """Refuse conditions that do not go with the bat: hands or swing off it, a ball that outweighs it."""
    check_swing(reduced.bat, conditions)
    if outweighed(reduced.body, conditions.ball):
        raise InputError(
            f"the ball weighs {conditions.ball.mass:.4g} kg and {reduced.bat.name} {reduced.body.mass:.4g} kg; "
            "allowed is a ball lighter than the bat"
        )


MOST_BENT = 0.01
"""Part of an implement's length up to which it may bend in a hit for beams that bend little to describe it. Our
choice: bats, clubs, sticks and rackets of the catalogue bend by at most 0.3 %, bats of solid cork or rubber by 4 %."""


def bent_part(analysis: Analysis[Implement]) -> float:
    """Return by how much the place of the best hit is bent aside as the ball leaves, over the implement's length."""
    modes, best = analysis.modes, analysis.best
    bending = [index for index, family in enumerate(modes.families) if family == "bending"]
    aside = modes.shape_at(best.position)[bending] @ best.displacement[bending]
    return abs(float(aside)) / analysis.bat.length


def too_soft(analysis: Analysis[Implement]) -> bool:
    """Return whether an implement bends more in its best hit than the model is for: its speeds predict nothing."""
    return not bent_part(analysis) <= MOST_BENT


SPACING = 0.01
"""m between the places that are tried with the other law."""
BEYOND = 0.06
"""m by which the other law's best place may lie elsewhere."""


class Loss(NamedTuple):
    """Exit speed lost, m/s, and the ends of the interval that the ball's law leaves open; nan where nothing is hit."""

    value: float
    low: float
    high: float


def miss_costs(analysis: Analysis[Implement], distances: tuple[float, ...]) -> list[tuple[Loss, Loss]]:
    """Return for each distance (m) what hitting so much nearer the hands and nearer the tip than the best place costs.

    Each law's cost counts from its own best place.
    """
    others = law_scans(analysis, reach=max(distances))
    costs = []
    for distance in distances:
        nominal = miss_cost(analysis.scan, distance)
        sides = zip(nominal, *(_cost(other, distance) for other in others), strict=True)
        inside, outside = (Loss(cost, *_span(cost, *rest)) for cost, *rest in sides)
        costs.append((inside, outside))
    return costs


def _cost(places: LawScan, distance: float) -> tuple[float, float]:
    """Return the cost of a miss on the hands' and on the tip's side of the best place of a scan, m/s."""
    index, shift, best = top(places.exit_speed)
    place = float(places.position[index] + shift * (places.position[1] - places.position[0]))
    inside, outside = (
        best - float(np.interp(place + way * distance, *places, left=np.nan, right=np.nan)) for way in (-1, 1)
    )
    return inside, outside


def _span(cost: float, *others: float) -> tuple[float, float]:
    """Return the lowest and the highest cost; where another law's place is off the bat, without it."""
    return float(np.fmin.reduce([cost, *others])), float(np.fmax.reduce([cost, *others]))


class LawScan(NamedTuple):
    """Hits with another law of the ball around the best place: m from the knob end and m/s, shape (places,)."""

    position: Array
    exit_speed: Array


def law_scans(analysis: Analysis[Implement], *, reach: float) -> list[LawScan]:
    """Return hits under the same conditions with the ball at both ends of what is known of its law (`Ball.with_law`).

    Empty for a ball whose law was not asked. ``reach``: m to either side of our best place, beyond which another
    `BEYOND` is tried.
    """
    best, given = analysis.sweet_spots.max_exit_speed, analysis.conditions
    if given.ball.law_ends is None:
        return []
    low = max(float(analysis.scan.position[0]), best - reach - BEYOND)
    high = min(float(analysis.scan.position[-1]), best + reach + BEYOND)
    places = np.linspace(low, high, max(4, round((high - low) / SPACING) + 1))
    speeds = given.swing.angular_speed * (places - given.swing.pivot)
    found = []
    for end in (-1.0, 1.0):
        ball = given.ball.with_law(end)
        efficiency = hits(
            analysis.modes, ball=ball, position=places, closing_speed=given.pitch.speed + speeds
        ).collision_efficiency
        found.append(LawScan(places, exit_speed(efficiency, ball_speed=given.pitch.speed, bat_speed=speeds)))
    return found

"""Hits at game speed: forces and times, rigid bats, best places, slopes, rigid walls, and the effect of the hands."""

from __future__ import annotations

from dataclasses import replace
from functools import cache
from typing import Any, NamedTuple

import numpy as np

from sweetspot import catalog
from sweetspot.analysis.bat_analysis import TYPICAL_HAND, Analysis, exit_speed_of, hit_at
from sweetspot.analysis.drop_test import fire
from sweetspot.collision.closed_form import exit_speed, restitution_from_efficiency
from sweetspot.collision.coupled import hit
from sweetspot.collision.free_motion import modal_propagator_of
from sweetspot.collision.impact import Impact
from sweetspot.collision.kernel import hits
from sweetspot.dynamics.block import Block
from sweetspot.dynamics.hands import held_modes
from sweetspot.dynamics.modes import Modes
from sweetspot.dynamics.reduction import bending_modes
from sweetspot.dynamics.rigid import centre_of_percussion, effective_mass
from sweetspot.motion.swing import Hands, Pitch
from sweetspot.numerics.arrays import Array
from sweetspot.numerics.piecewise import Piecewise
from sweetspot.units import INCH
from sweetspot.validation.computations import shared


def _wall_restitution(*, speed: float) -> float:
    """Return the rebound ratio of the catalogue's baseball from a wall that cannot move, by the coupled collision."""
    return hit(rigid_wall(), ball=catalog.ball(), position=0.0, closing_speed=speed).collision_efficiency


def ash_wall_restitution(*, speed: float, wall: float) -> float:
    """Return the rebound ratio of the catalogue's baseball from white ash of thickness ``wall`` on a rigid back."""
    block = Block(material=catalog.material("white ash"), thickness=wall, length=0.3, width=0.3, floor_modulus=None)
    return fire(block, ball=catalog.ball(), speed=speed).restitution


def wall_restitution_change(*, speed: float, other_speed: float) -> float:
    """Return the greatest change of that ratio over ten equal steps from ``speed`` up to ``other_speed``.

    Negative only if it falls at every step.
    """
    ratios = [_wall_restitution(speed=float(v)) for v in np.linspace(speed, other_speed, 11)]
    return float(np.diff(ratios).max())


def rigid_wall() -> Modes:
    """Return a body with one motion that no force can excite: its shape is zero, as of an infinite mass."""
    still = Piecewise(np.zeros((1, 1, 1)), np.array([0.0, 1.0]))
    return Modes(
        ("rigid",), (0,), np.zeros(1), np.zeros(1), still, rigid_part=np.zeros((2, 1)), dashpots=np.zeros((0, 1))
    )


class HeldRod(NamedTuple):
    """Angular speed after a hit times m L over the impulse; the hinge's share of the impulse, 1 - m v_c over it."""

    turning: float
    hand_force: float


@cache
def held_rod(*, bat: str, closing_speed: float) -> HeldRod:
    """Return the motion after a hit at the tip of a rigid rod hinged at its end."""
    free, body, length, ball = shared.free_modes(bat), shared.body(bat), shared.length(bat), catalog.ball()
    hinge = Hands(position=0.0, spacing=0.0, mass=1e6, stiffness=1e9)
    held = held_modes(free.selected(free.of_family("rigid")), hinge)
    impact = hit(held, ball=ball, position=length, closing_speed=closing_speed, step=1e-6)
    impulse = ball.mass * closing_speed * (1 + impact.collision_efficiency)
    centre = float(held.shape_at(body.balance_point) @ impact.velocity)
    slope = float(held.slope_at(body.balance_point) @ impact.velocity)
    return HeldRod(slope / impulse * body.mass * length, 1 - body.mass * centre / impulse)


def turned_mean_force(*, contact_time: float, **speeds: Any) -> float:
    """Return the integral of the force on a ball turned from one speed to the other, over a given contact time."""
    impact = turned(**speeds)
    return float(np.trapezoid([*impact.force, 0.0], [*impact.times, impact.release_time]) / contact_time)


@cache
def turned(*, bat: str, ball_mass: float, ball_speed: float, exit_speed: float) -> Impact:
    """Return the hit at the bat's best place whose bat speed sends the ball back at ``exit_speed``."""
    from scipy.optimize import brentq  # here: a report's page names these computations and runs few

    analysis = shared.standard(bat)
    place, modes = analysis.sweet_spots.max_exit_speed, analysis.modes
    ball = catalog.ball().replaced(mass=ball_mass)
    hits: dict[float, Impact] = {}

    def excess(bat_speed: float) -> float:
        hits[bat_speed] = hit(modes, ball=ball, position=place, closing_speed=ball_speed + bat_speed)
        efficiency = hits[bat_speed].collision_efficiency
        return efficiency * ball_speed + (1 + efficiency) * bat_speed - exit_speed

    bat_speed = float(brentq(excess, 20.0, 60.0, xtol=1e-6))
    return hits.get(bat_speed) or hit(modes, ball=ball, position=place, closing_speed=ball_speed + bat_speed)


def flexible_over_rigid(*, bat: str) -> float:
    """Return the greatest excess of the flexible bat's exit speed over the rigid one's beyond the balance point.

    The rigid bat has the same local compliance as the flexible one, so that only bending differs.
    """
    analysis = shared.standard(bat)
    scan, modes, conditions = analysis.scan, analysis.modes, analysis.conditions
    barrel = scan.position > analysis.body.balance_point
    rigid = replace(modes.selected(modes.of_family("rigid")), compliances=modes.compliances)
    impacts = hits(
        rigid, ball=conditions.ball, position=scan.position[barrel], closing_speed=scan.closing_speed[barrel]
    )
    alone = exit_speed(
        impacts.collision_efficiency, ball_speed=conditions.pitch.speed, bat_speed=scan.bat_speed[barrel]
    )
    return float((scan.exit_speed[barrel] / alone - 1).max())


def best_efficiency_from_tip(*, bat: str) -> float:
    """Return the distance of the greatest q from the tip."""
    return shared.length(bat) - shared.standard(bat).sweet_spots.max_collision_efficiency


def efficiency_fall(*, bat: str, outward: float) -> float:
    """Return the loss of q ``outward`` m from its best place toward the tip; negative: toward the hands."""
    analysis = shared.standard(bat)
    place = analysis.sweet_spots.max_collision_efficiency + outward
    efficiency = analysis.scan.collision_efficiency
    return float(efficiency.max() - np.interp(place, analysis.scan.position, efficiency))


def squared_up_from_tip(*, bat: str, side: str) -> float:
    """Return the place of 0.8 of the exit speed 1.23 bat speed + 0.23 pitch speed, on the tip's or the hands' side.

    At the standard speeds, whose ratio is that of games; the pitch's is taken at the plate.
    """
    analysis = shared.standard(bat)
    conditions, scan = analysis.conditions, analysis.scan
    ceiling = 1.23 * conditions.swing.bat_speed + 0.23 * conditions.pitch.speed
    squared = scan.position[np.nan_to_num(scan.exit_speed) >= 0.8 * ceiling]
    return shared.length(bat) - float(squared.max() if side == "tip" else squared.min())


def rigid_best_place_from_tip(*, bat: str) -> float:
    """Return the distance from the tip of the greatest exit speed of a rigid bat of the same mass and inertia."""
    scan = shared.standard(bat).scan
    return shared.length(bat) - float(scan.position[int(np.nanargmax(scan.rigid_exit_speed))])


def best_to_node(*, bat: str) -> float:
    """Return the distance between the place of greatest exit speed and the first mode's node on the barrel."""
    spots = shared.standard(bat).sweet_spots
    return abs(spots.max_exit_speed - spots.node_1)


def best_to_percussion(*, bat: str, pivot: float) -> float:
    """Return the distance between the place of greatest exit speed and the center of percussion about ``pivot``."""
    analysis = shared.standard(bat)
    return abs(analysis.sweet_spots.max_exit_speed - centre_of_percussion(analysis.body, pivot=pivot))


def restitution_at_best(*, bat: str) -> float:
    """Return the ball-bat restitution of that hit."""
    analysis = shared.standard(bat)
    return _restitution(analysis, analysis.best.position, analysis.best.collision_efficiency)


def _restitution(analysis: Analysis, place: float, efficiency: float) -> float:
    recoil = analysis.conditions.ball.mass / effective_mass(analysis.body, place)
    return restitution_from_efficiency(efficiency, recoil=recoil)


def exit_speed_slope(*, bat: str, by: str, speed: float) -> float:
    """Return the change of exit speed at the best place per change of ``by``, swing or pitch, over ``speed``."""
    return (_exit(bat, **{by: speed / 2}) - _exit(bat, **{by: -speed / 2})) / speed


def best_exit_speed(*, bat: str, ball_speed: float, bat_speed: float) -> float:
    """Return the exit speed at the best place for another pitch and another bat speed 6 in from the tip."""
    conditions = shared.standard(bat).conditions
    return _exit(bat, pitch=ball_speed - conditions.pitch.speed, swing=bat_speed - conditions.swing.bat_speed)


@cache
def _exit(bat: str, *, pitch: float = 0.0, swing: float = 0.0) -> float:
    """Return the exit speed at the standard best place with pitch and bat speed changed by so much."""
    analysis = shared.standard(bat)
    old = analysis.conditions
    changed = old.replaced(
        pitch=Pitch(speed=old.pitch.speed + pitch), swing=old.swing.replaced(bat_speed=old.swing.bat_speed + swing)
    )
    return exit_speed_of(hit_at(analysis.sweet_spots.max_exit_speed, modes=analysis.modes, conditions=changed), changed)


HANDS = 6 * INCH
GRIPS = (Hands(position=HANDS, **TYPICAL_HAND), Hands(position=HANDS, mass=1e4, stiffness=1e9))
"""Typical hands, and a vice that holds two places 3.5 in apart: a handle that can neither move nor turn."""
MANY_MODES = 40
"""Bending modes up to about 30 kHz, so that motion cannot arrive before the wave does."""
STEP = 2e-6
WATCHED = 3e-3
"""s after the touch in which the handle's greatest speed is looked for."""
ARRIVED = 0.1
"""Part of that speed at which the wave has arrived."""


def grip_change(*, bat: str) -> float:
    """Return the greatest relative change of exit speed on the barrel by typical hands and by a vice."""
    analysis = shared.standard(bat)
    conditions, free = analysis.conditions, shared.free_modes(bat)
    places = shared.length(bat) - np.linspace(3 * INCH, 9 * INCH, 25)
    swing = conditions.swing.angular_speed * (places - conditions.swing.pivot)

    def speeds(modes: Modes) -> Array:
        closing = conditions.pitch.speed + swing
        impacts = hits(modes, ball=conditions.ball, position=places, closing_speed=closing)
        efficiency = impacts.collision_efficiency
        return np.asarray(efficiency * conditions.pitch.speed + (1 + efficiency) * swing)

    alone = speeds(free)
    return max(float(np.abs(speeds(held_modes(free, hands)) / alone - 1).max()) for hands in GRIPS)


def impulse_given_at_arrival(*, bat: str) -> float:
    """Return the fraction of the impulse delivered before the wave of the best hit arrives at the top hand.

    The handle's motion is the sum of all modes driven by the recorded force, step by step.
    """
    conditions = shared.standard(bat).conditions
    place = shared.standard(bat).sweet_spots.max_exit_speed
    modes = bending_modes(shared.beam(bat), count=MANY_MODES, elements=MANY_MODES)
    closing = conditions.pitch.speed + conditions.swing.speed_at(place)
    force = hit(modes, ball=conditions.ball, position=place, closing_speed=closing, step=STEP).force
    drift, push, handle = modal_propagator_of(modes, STEP), modes.shape_at(place), modes.shape_at(HANDS)
    displacement, velocity = np.zeros(len(modes)), np.zeros(len(modes))
    speed = np.empty(round(WATCHED / STEP))
    for step in range(len(speed)):
        if step < len(force):
            velocity = velocity + push * force[step] * STEP
        displacement, velocity = (
            drift[:, 0, 0] * displacement + drift[:, 0, 1] * velocity,
            drift[:, 1, 0] * displacement + drift[:, 1, 1] * velocity,
        )
        speed[step] = abs(handle @ velocity)
    arrival = int(np.argmax(speed > ARRIVED * speed.max()))
    return float(force[: arrival + 1].sum() / force.sum())

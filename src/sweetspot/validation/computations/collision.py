"""Hits at game speed: forces and times, flexible against rigid, the best places, the slopes, the ball on a wall."""

from __future__ import annotations

from dataclasses import replace
from functools import cache

import numpy as np

from sweetspot import catalog
from sweetspot.analysis.bat_analysis import Analysis, exit_speed_of, hit_at
from sweetspot.analysis.drop_test import fire
from sweetspot.collision.closed_form import exit_speed, restitution_from_efficiency
from sweetspot.collision.coupled import hit
from sweetspot.collision.impact import Impact
from sweetspot.collision.kernel import hits
from sweetspot.dynamics.block import Block
from sweetspot.dynamics.hands import held_modes
from sweetspot.dynamics.modes import Modes
from sweetspot.dynamics.rigid import RigidBody, centre_of_percussion, effective_mass
from sweetspot.motion.swing import Conditions, Hands, Pitch
from sweetspot.numerics.arrays import Array
from sweetspot.numerics.piecewise import Piecewise
from sweetspot.validation.computations import shared


def wall_restitution(*, speed: float) -> float:
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
    ratios = [wall_restitution(speed=float(one)) for one in np.linspace(speed, other_speed, 11)]
    return float(np.diff(ratios).max())


def rigid_wall() -> Modes:
    """Return a body with one motion that no force can excite: its shape is zero, as of an infinite mass."""
    still = Piecewise(np.zeros((1, 1, 1)), np.array([0.0, 1.0]))
    return Modes(
        ("rigid",), (0,), np.zeros(1), np.zeros(1), still, rigid_part=np.zeros((2, 1)), dashpots=np.zeros((0, 1))
    )


def held_rod_turning(*, bat: str, closing_speed: float) -> float:
    """Return the angular speed after a hit at the tip of a rigid rod hinged at its end, times m L over the impulse."""
    _, slope, impulse, body, length = _held_rod(bat, closing_speed)
    return slope / impulse * body.mass * length


def held_rod_hand_force(*, bat: str, closing_speed: float) -> float:
    """Return 1 - m v_c over the impulse of that hit: what the hinge gives, as a part of the blow."""
    centre, _, impulse, body, _ = _held_rod(bat, closing_speed)
    return 1 - body.mass * centre / impulse


@cache
def _held_rod(bat: str, closing_speed: float) -> tuple[float, float, float, RigidBody, float]:
    """Return the speed of the centre, the angular speed, the impulse, the rod as a body, and its length."""
    free, body, length, ball = shared.free_modes(bat), shared.body(bat), shared.length(bat), catalog.ball()
    hinge = Hands(position=0.0, spacing=0.0, mass=1e6, stiffness=1e9)
    held = held_modes(free.selected(free.of_family("rigid")), hinge)
    impact = hit(held, ball=ball, position=length, closing_speed=closing_speed, step=1e-6)
    impulse = ball.mass * closing_speed * (1 + impact.collision_efficiency)
    centre = float(held.shape_at(body.balance_point) @ impact.velocity)
    return centre, float(held.slope_at(body.balance_point) @ impact.velocity), impulse, body, length


def turned_mean_force(
    *, bat: str, ball_mass: float, ball_speed: float, exit_speed: float, contact_time: float
) -> float:
    """Return the integral of the force on a ball turned from one speed to the other, over a given contact time."""
    impact = turned(bat, ball_mass, ball_speed, exit_speed)
    impulse = np.trapezoid([*impact.force, 0.0], [*impact.times, impact.release_time])
    return float(impulse / contact_time)


def turned_peak_force(*, bat: str, ball_mass: float, ball_speed: float, exit_speed: float) -> float:
    """Return the peak force of that hit."""
    return turned(bat, ball_mass, ball_speed, exit_speed).peak_force


def turned_contact_time(*, bat: str, ball_mass: float, ball_speed: float, exit_speed: float) -> float:
    """Return the contact time of that hit: until the force is below 1 % of its peak."""
    return turned(bat, ball_mass, ball_speed, exit_speed).contact_time


@cache
def turned(bat: str, ball_mass: float, ball_speed: float, exit_speed: float) -> Impact:
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


def standard_peak_force(*, bat: str) -> float:
    """Return the peak force of the best hit under the standard conditions."""
    return shared.standard(bat).best.peak_force


def standard_contact_time(*, bat: str) -> float:
    """Return the contact time of the best hit under the standard conditions."""
    return shared.standard(bat).best.contact_time


def standard_angular_speed(*, bat: str) -> float:
    """Return the angular speed of the standard swing."""
    return shared.standard(bat).conditions.swing.angular_speed


def flexible_over_rigid(*, bat: str) -> float:
    """Return by how much the flexible bat's exit speed is above the rigid one's at most, barrel half of the bat."""
    _, ratio = _flexible_over_rigid(bat)
    return float(ratio.max())


def _flexible_over_rigid(bat: str) -> tuple[Array, Array]:
    """Return places beyond the balance point and flexible over rigid exit speed there, less one.

    The rigid bat is dented by the ball as the flexible one is: what counts here is the bending.
    """
    analysis = shared.standard(bat)
    scan, modes, conditions = analysis.scan, analysis.modes, analysis.conditions
    barrel = scan.position > analysis.body.balance_point
    places, closing, bat_speed = scan.position[barrel], scan.closing_speed[barrel], scan.bat_speed[barrel]
    rigid = replace(modes.selected(modes.of_family("rigid")), compliances=modes.compliances)
    efficiency = hits(rigid, ball=conditions.ball, position=places, closing_speed=closing).collision_efficiency
    alone = exit_speed(efficiency, ball_speed=conditions.pitch.speed, bat_speed=bat_speed)
    return places, scan.exit_speed[barrel] / alone - 1


def best_from_tip(*, bat: str) -> float:
    """Return how far from the tip the ball leaves fastest."""
    return shared.length(bat) - shared.standard(bat).sweet_spots.max_exit_speed


def best_efficiency_from_tip(*, bat: str) -> float:
    """Return how far from the tip q is greatest."""
    return shared.length(bat) - shared.standard(bat).sweet_spots.max_collision_efficiency


def efficiency_fall(*, bat: str, outward: float) -> float:
    """Return how far q is below its greatest value ``outward`` m nearer the tip; negative: nearer the hands."""
    analysis = shared.standard(bat)
    place = analysis.sweet_spots.max_collision_efficiency + outward
    efficiency = analysis.scan.collision_efficiency
    return float(efficiency.max() - np.interp(place, analysis.scan.position, efficiency))


def squared_up_from_tip(*, bat: str, side: str) -> float:
    """Return where the ball leaves at 0.8 of 1.23 bat speed + 0.23 pitch speed, on the tip's or the hands' side.

    At the standard speeds, whose ratio is that of games; the pitch's is taken at the plate.
    """
    analysis = shared.standard(bat)
    conditions, scan = analysis.conditions, analysis.scan
    ceiling = 1.23 * conditions.swing.bat_speed + 0.23 * conditions.pitch.speed
    squared = scan.position[np.nan_to_num(scan.exit_speed) >= 0.8 * ceiling]
    return shared.length(bat) - float(squared.max() if side == "tip" else squared.min())


def best_restitution_from_tip(*, bat: str) -> float:
    """Return how far from the tip the ball-bat restitution e = q (1 + r) + r is greatest, barrel half of the bat."""
    analysis = shared.standard(bat)
    places = analysis.scan.position
    restitution = [
        _restitution(analysis, place, efficiency) if place > analysis.body.balance_point else 0.0
        for place, efficiency in zip(places, analysis.scan.collision_efficiency, strict=True)
    ]
    return shared.length(bat) - float(places[int(np.argmax(restitution))])


def rigid_best_place_from_tip(*, bat: str) -> float:
    """Return how far from the tip a rigid bat of the same mass and inertia would send the ball fastest."""
    scan = shared.standard(bat).scan
    return shared.length(bat) - float(scan.position[int(np.nanargmax(scan.rigid_exit_speed))])


def best_to_node(*, bat: str) -> float:
    """Return the distance between the place of greatest exit speed and the first mode's node on the barrel."""
    spots = shared.standard(bat).sweet_spots
    return abs(spots.max_exit_speed - spots.node_1)


def best_to_percussion(*, bat: str, pivot: float) -> float:
    """Return the distance between the place of greatest exit speed and the centre of percussion about ``pivot``."""
    analysis = shared.standard(bat)
    return abs(analysis.sweet_spots.max_exit_speed - centre_of_percussion(analysis.body, pivot=pivot))


def restitution_at_best(*, bat: str) -> float:
    """Return the ball-bat restitution of that hit."""
    analysis = shared.standard(bat)
    return _restitution(analysis, analysis.best.position, analysis.best.collision_efficiency)


def _restitution(analysis: Analysis, place: float, efficiency: float) -> float:
    recoil = analysis.conditions.ball.mass / effective_mass(analysis.body, place)
    return restitution_from_efficiency(efficiency, recoil=recoil)


def bat_speed_slope(*, bat: str, speed: float) -> float:
    """Return the change of exit speed per change of bat speed at the best place, for a change of ``speed``."""
    return (_exit(bat, swing=speed / 2) - _exit(bat, swing=-speed / 2)) / speed


def pitch_speed_slope(*, bat: str, speed: float) -> float:
    """Return the change of exit speed per change of pitch speed at the best place, for a change of ``speed``."""
    return (_exit(bat, pitch=speed / 2) - _exit(bat, pitch=-speed / 2)) / speed


def best_exit_speed(*, bat: str, ball_speed: float, bat_speed: float) -> float:
    """Return the exit speed at the best place for another pitch and another bat speed 6 in from the tip."""
    conditions = shared.standard(bat).conditions
    return _exit(bat, pitch=ball_speed - conditions.pitch.speed, swing=bat_speed - conditions.swing.bat_speed)


@cache
def _exit(bat: str, *, pitch: float = 0.0, swing: float = 0.0) -> float:
    """Return the exit speed at the standard best place with pitch and bat speed changed by so much."""
    analysis = shared.standard(bat)
    old = analysis.conditions
    changed = Conditions(
        pitch=Pitch(speed=old.pitch.speed + pitch),
        swing=old.swing.replaced(bat_speed=old.swing.bat_speed + swing),
        hands=old.hands,
        ball=old.ball,
    )
    return exit_speed_of(hit_at(analysis.sweet_spots.max_exit_speed, modes=analysis.modes, conditions=changed), changed)

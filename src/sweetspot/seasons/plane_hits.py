"""A bat's hits in the plane across its axis: which hit sends a ball in a given direction, and the hardest of all hits.

The hits are those of the bat's `ContactTable`. Seen from the bat a ball comes straight at some speed; the line of
centres stands at some angle to that way. Motion of the ball along the bat is left out; a part of it is kept and added
(`BatInPlane.along`). Places are those of the table, so that nothing is read off between two of them.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from sweetspot.collision.contact_lookup import RISING, band_of, rubbed
from sweetspot.collision.contact_table import ContactTable, tabled_bat
from sweetspot.collision.hit_in_space import Contact
from sweetspot.collision.oblique_contact import USUAL_FRICTION
from sweetspot.equipment.ball import Ball
from sweetspot.equipment.bat import Bat
from sweetspot.errors import InputError
from sweetspot.motion.ball_motion import BallMotions
from sweetspot.motion.swing import SPEED_FROM_TIP
from sweetspot.motion.swing_path import Swings, path_axes
from sweetspot.numerics.arrays import Array
from sweetspot.numerics.kernel_cache import compiled, inner
from sweetspot.numerics.vector_math import sine_and_cosine
from sweetspot.units import INCH, MPH

PLACES: Array = np.linspace(0.0, 18 * INCH, 73)
"""m from the tip, to 18 in. Balls that jam a batter are met 14 in from the tip and more: there a hit is worth half of
the best one."""
RATIOS, SLANTS, SPEEDS = (
    np.linspace(0.0, 2.4, 13),
    np.radians([-15.0, 0.0, 15.0, 30.0]),
    np.array([45.0, 65.0, 85.0]) * MPH,
)
"""Nodes of the ceiling: pitch speed over bat speed, rad between the pitch's way and the bat's, bat speed."""
STEEPEST = 69 * math.pi / 180
"""rad between the line of centres and the ball's way, to either side."""
LINES = 93
"""Lines of centres, evenly spaced, of which the hardest hit is sought."""
TURNS, CLOSE = 12, 5e-4
"""Most steps of the search for the line of centres, and rad by which the direction may miss before the last one."""
USUAL_TURN = 4 / 3
"""rad that a ball turns for a rad of the line of centres, to begin with."""
RUBBING = (USUAL_FRICTION.coefficient, 1 + USUAL_FRICTION.tangential_restitution)


class PlaneTable(NamedTuple):
    """A bat's table as the kernels read it, at `PLACES`.

    ``terms``: polynomials in the closing speed (`ContactTable.along_speeds`), shape (places, bands, 4, terms); nan
    beyond the knob. ``roots``: ends of its bands, sqrt(m/s). ``give_around``, ``give_along``: what the rigid bat gives
    to friction by its turning and moving, 1/kg. ``radius``: of the bat, m. ``reach``: m, radii of ball and bat
    together. ``arm``: bat speed over that where it is measured. ``turning``: speed at which the turning bat's front
    moves towards the hands, over bat speed where it is measured. ``ball_mass``: kg.
    """

    terms: Array
    roots: tuple[float, float, float, float]
    give_around: Array
    give_along: Array
    radius: Array
    reach: Array
    arm: Array
    turning: Array
    ball_mass: float


@dataclass(frozen=True)
class BatInPlane:
    """A bat's answers in the plane across its axis.

    ``along``: what the ball keeps of its speed along the bat, and what the turning bat adds to it per bat speed.
    ``ceiling``: greatest exit speed over bat speed, shape (speeds, ratios, slants). ``best_place``: m from the tip
    where that is, same shape.
    """

    bat: Bat
    table: PlaneTable
    along: tuple[float, float]
    ceiling: Array
    best_place: Array


def bat_in_plane(bat: Bat, *, ball: Ball) -> BatInPlane:
    """Return a bat's answers."""
    contact = tabled_bat(bat, ball=ball)
    terms, body = contact.along_speeds(PLACES), contact.model.body
    if not np.isfinite(terms[..., 0, 0]).any():
        raise InputError(f"{bat.name} does not send the ball back on its barrel; check its wall")
    radius, arm = bat.diameter_at(np.maximum(bat.length - PLACES, 0.0)) / 2, bat.length - bat.choke
    table = PlaneTable(
        terms,
        contact.lookup.roots,
        radius**2 / body.roll_moi,
        1 / body.mass + radius**2 / body.moi_cm,
        radius,
        ball.radius + radius,
        (arm - PLACES) / (arm - SPEED_FROM_TIP),
        np.asarray(radius / (arm - PLACES)),
        ball.mass,
    )
    ceiling, best = np.empty((2, len(SPEEDS), len(RATIOS), len(SLANTS)))
    fill_ceilings(table, (SPEEDS, RATIOS, SLANTS), ceiling, best)
    return BatInPlane(bat, table, _along(contact), ceiling, best)


def _along(contact: ContactTable) -> tuple[float, float]:
    """Return the part of its speed along the bat that a ball keeps, and its gain of it per bat speed."""
    launched = contact.launches(
        swings=Swings(np.full(2, 30.0), path_axes(0.0, 0.0, tilt=0.0, left=False), contact.bat.choke),
        pitches=BallMotions(velocity=[(0.0, -38.0, -4.0), (3.0, -38.0, -4.0)], spin=np.zeros(3)),
        contact=Contact(contact.bat.length - SPEED_FROM_TIP, 0.0),
    )
    still, moving = launched.velocity[:, 0].tolist()
    return (moving - still) / 3.0, still / 30.0


@inner(forceinline=True, error_model="numpy", fastmath={"contract", "nsz"})
def hit_at(
    table: PlaneTable, place: int, closing_speed: float, tangent: float, turning: float, sine: float, cosine: float
) -> tuple[float, float]:
    """Return the ball's velocity after a hit over the closing speed, seen from the bat: back on its way, and across it.

    `oblique_contact.launch` in the plane across the bat's axis.

    ``closing_speed``: m/s between bat and ball. ``tangent``: spin of the pitch about the bat's axis times the ball's
    radius, m/s. ``turning``: m/s at which the bat's front moves towards the hands. ``sine``, ``cosine``: of the angle
    between the line of centres and the ball's way.
    """
    normal = closing_speed * cosine
    band, root = band_of(table.roots, min(max(math.sqrt(normal), table.roots[0]), table.roots[3]))
    efficiency = normal_give = around_give = tilting = 0.0
    for column in range(RISING):
        term = RISING - 1 - column
        efficiency = efficiency * root + table.terms[place, band, 0, term]
        normal_give = normal_give * root + table.terms[place, band, 1, term]
        around_give = around_give * root + table.terms[place, band, 2, term]
        tilting = tilting * root + table.terms[place, band, 3, term]
    give = (
        normal_give,
        around_give + table.give_around[place],
        table.give_along[place],
        table.radius[place] * tilting,
    )
    before = table.ball_mass * normal * (1 + efficiency)
    push, around, _ = rubbed((tangent - closing_speed * sine, -turning), give, table.ball_mass, before, RUBBING)
    per_speed = 1 / (table.ball_mass * closing_speed)
    return (push * cosine - around * sine) * per_speed - 1, (push * sine + around * cosine) * per_speed


@inner(forceinline=True, error_model="numpy", fastmath={"contract", "nsz"})
def hit_towards(
    table: PlaneTable, place: int, asked: tuple[float, float, float, float], cos: float, sin: float, guess: float,
    slope: float,
) -> tuple[float, float, float, float]:  # fmt: skip
    """Return exit speed, offset, the line of centres' angle and the ball's turn for a rad of it, for a hit's direction.

    ``asked``: bat speed where it is measured, pitch along the bat's path and square to it (m/s), and its spin about the
    bat's axis times the ball's radius. ``cos``, ``sin``: of the angle by which the ball leaves the bat's path. NaN, NaN
    and what was guessed where no line of centres does it.
    """
    there = asked[0] * table.arm[place]
    way, across = there - asked[1], -asked[2]
    closing = math.sqrt(way * way + across * across)
    way, across = way / closing, across / closing
    at, turn = min(max(guess, -STEEPEST), STEEPEST), slope
    before, smaller, last = math.nan, 0.0, 0.0
    for _ in range(TURNS):
        sine, cosine = sine_and_cosine(at)
        back, lift = hit_at(
            table,
            place,
            closing,
            asked[3],
            asked[0] * table.turning[place] * (way * cosine - across * sine),
            sine,
            cosine,
        )
        out = there + closing * (way * back - across * lift)
        high = closing * (across * back + way * lift)
        size, miss = out * cos + high * sin, high * cos - out * sin
        if not (math.isfinite(out) and size > 0):
            return math.nan, math.nan, guess, slope
        off, gain = miss / size, 0.0
        if math.isfinite(before) and at != last:
            turn, gain = (off - before) / (at - last), (size - smaller) / (at - last)
        if abs(off) < CLOSE:
            step = -off / turn
            sine, cosine = sine_and_cosine(at + step)
            offset = table.reach[place] * (way * sine + across * cosine)
            return size + gain * step, offset, at + step, turn
        before, smaller, last = off, size, at
        at = min(max(at - off / turn, -STEEPEST), STEEPEST)
        if at == last:
            return math.nan, math.nan, guess, slope
    return math.nan, math.nan, guess, slope


@compiled(nogil=True, error_model="numpy")
def fill_ceilings(table: PlaneTable, nodes: tuple[Array, Array, Array], ceiling: Array, best: Array) -> None:
    """Fill the greatest exit speed over bat speed, without spin, and the place where it is.

    ``nodes``: bat speed (m/s), pitch speed over it, and rad between the pitch's way and the bat's.
    """
    tops = np.empty(len(PLACES))
    sizes = np.empty(LINES)
    step = PLACES[1] - PLACES[0]
    for i in range(len(nodes[0])):
        for j in range(len(nodes[1])):
            for k in range(len(nodes[2])):
                coming = nodes[1][j] * nodes[0][i]
                for place in range(len(PLACES)):
                    there = nodes[0][i] * table.arm[place]
                    way, across = there + coming * math.cos(nodes[2][k]), coming * math.sin(nodes[2][k])
                    closing = math.sqrt(way * way + across * across)
                    way, across = way / closing, across / closing
                    for line in range(LINES):
                        sine, cosine = sine_and_cosine(STEEPEST * (2 * line / (LINES - 1) - 1))
                        turning = nodes[0][i] * table.turning[place] * (way * cosine - across * sine)
                        back, lift = hit_at(table, place, closing, 0.0, turning, sine, cosine)
                        out = there + closing * (way * back - across * lift)
                        high = closing * (across * back + way * lift)
                        sizes[line] = math.sqrt(out * out + high * high) if math.isfinite(out) else 0.0
                    tops[place], _ = _top(sizes)
                height, at = _top(tops)
                ceiling[i, j, k] = height / nodes[0][i]
                best[i, j, k] = at * step


@inner(error_model="numpy")
def _top(values: Array) -> tuple[float, float]:
    """Return the greatest of evenly spaced values, by a parabola through the three about it, and where it lies."""
    top = int(np.argmax(values))
    if top == 0 or top == len(values) - 1:
        return values[top], float(top)
    bend = values[top - 1] - 2 * values[top] + values[top + 1]
    rise = values[top - 1] - values[top + 1]
    if not bend < 0:
        return values[top], float(top)
    return values[top] - rise * rise / (8 * bend), top + rise / (2 * bend)

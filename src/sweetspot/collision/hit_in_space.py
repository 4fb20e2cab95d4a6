"""Bat and ball meet in space: where on the bat, how far off its centre, and how the ball leaves.

The normal part is the coupled collision along the line of centres, for that closing speed and place; `oblique.launch`
adds friction and spin. Head-on and without friction the result is the normal part alone.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from sweetspot.collision.coupled import hit
from sweetspot.collision.impact import Impact, Impacts, Outcome
from sweetspot.collision.kernel import hits_with_motion
from sweetspot.collision.oblique_contact import (
    USUAL_FRICTION,
    ContactFrame,
    Friction,
    Launch,
    bat_give,
    contact_frame,
    launch,
    travel,
    turning_surface,
)
from sweetspot.dynamics.reduction import ReducedBat
from sweetspot.equipment.ball import Ball
from sweetspot.equipment.bat import Bat
from sweetspot.errors import InputError
from sweetspot.motion.ball_motion import BallMotion, BallMotions
from sweetspot.motion.swing import Swing
from sweetspot.motion.swing_path import SwingPath, Swings
from sweetspot.numerics.arrays import Array
from sweetspot.numerics.notebook_display import ShownInNotebooks


class Contact(NamedTuple):
    """Point of contact of ball and bat.

    Parameters
    ----------
    position : m from the knob end, where the line of centres meets the bat's axis; many: shape (n,).
    offset : m by which the ball's centre lies above the bat's axis, square to the bat's path; as much as both radii
        or more is a miss.
    """

    position: ArrayLike
    offset: ArrayLike = 0.0


@dataclass(frozen=True)
class Strike(ShownInNotebooks):
    """One hit in space.

    Parameters
    ----------
    outcome : how it ended; after a miss, or where the bat does not reach the ball, the rest is None.
    bat_speed : m/s at the point of impact.
    impact : the part along the line of centres.
    launched : the ball as it leaves.
    travel_along, travel_around : m that the ball's centre moves past the bat's surface during contact, towards the
        tip and upwards.
    gripped : whether friction was enough to stop the sliding.
    second_plane : vibration that friction gives the bat across the first plane, relative to the first plane's.
    """

    outcome: Outcome
    bat_speed: float
    impact: Impact | None = None
    launched: BallMotion | None = None
    travel_along: float | None = None
    travel_around: float | None = None
    gripped: bool | None = None
    second_plane: float | None = None


@dataclass(frozen=True)
class Strikes(ShownInNotebooks):
    """Many hits in space; rows without a meaning are nan (see `outcome`).

    Parameters
    ----------
    outcome : one per hit.
    closing_speed : m/s along the line of centres.
    collision_efficiency : q of the part along the line of centres.
    contact_time, peak_force, peak_compression : s, N and m of that part.
    touches : how many times the ball was touched; more than once where the bat caught up with it.
    exit_speed, velocity, spin : of the ball as it leaves, m/s and rad/s, shapes (n,), (n, 3) and (n, 3).
    """

    outcome: NDArray[np.int64]
    closing_speed: Array
    collision_efficiency: Array
    contact_time: Array
    peak_force: Array
    peak_compression: Array
    touches: Array
    exit_speed: Array
    velocity: Array
    spin: Array


def strike(
    reduced: ReducedBat[Bat],
    *,
    ball: Ball,
    swing: Swing,
    path: SwingPath,
    pitch: BallMotion,
    contact: Contact,
    friction: Friction = USUAL_FRICTION,
) -> Strike:
    """Return the motion of a pitched ball as it leaves the bat.

    The line of centres lies in the plane across the bat's axis and rises above the bat's path by
    asin(offset / (ball radius + bat radius)). The barrel's own slope is left out: it is below 2 degrees where one hits.

    Parameters
    ----------
    swing, path : how fast the bat moves, and where to.
    pitch : the ball as it arrives.
    contact : where they meet.

    Raises
    ------
    InputError
        for a position that is not on the bat.

    >>> from math import radians
    >>> from sweetspot import BallMotion, Contact, SwingPath, catalog, standard_conditions, strike
    >>> from sweetspot.dynamics.reduction import reduced_bat
    >>> bat, ball = catalog.bat("r161-ash"), catalog.ball()
    >>> pitch = BallMotion(position=(0, 0.5, 0.9), velocity=(0, -37.0, -3.0), spin=(-200.0, 0, 0))
    >>> struck = strike(reduced_bat(bat, ball=ball), ball=ball, swing=standard_conditions(bat).swing,
    ...     path=SwingPath(attack_angle=radians(9)), pitch=pitch, contact=Contact(bat.length - 0.15, 0.018))
    >>> round(struck.launched.speed, 1), round(struck.launched.launch_angle, 2)  # m/s, rad
    (44.7, 0.51)
    """
    position, offset = (float(np.asarray(value)) for value in contact)
    reduced.bat.check_position(position, "position")
    radius = float(reduced.bat.diameter_at(np.array(position))) / 2
    reach = ball.radius + radius
    bat_speed = swing.speed_at(position)
    if abs(offset) >= reach:
        return Strike(Outcome.MISS, bat_speed)
    axes = path.axes
    frame = contact_frame(*axes, lift=np.arcsin(offset / reach))
    bat_velocity = bat_speed * axes.forward
    closing = float((bat_velocity - pitch.velocity) @ frame.normal)
    impact = hit(reduced.modes, ball=ball, position=position, closing_speed=closing)
    if impact.outcome is not Outcome.SEPARATED:
        return Strike(impact.outcome, bat_speed)
    surface = bat_velocity + turning_surface(frame, axes, angular_speed=swing.angular_speed, radius=radius)
    departure = _leaving(
        frame,
        reduced,
        ball=ball,
        pitch=pitch,
        surface_velocity=surface,
        place=(position, radius),
        closing=closing,
        normal=impact,
        friction=friction,
    )
    past, given = pitch.velocity - surface, departure.impulses
    return Strike(
        outcome=impact.outcome,
        bat_speed=bat_speed,
        impact=impact,
        launched=BallMotion(pitch.position, departure.velocity, departure.spin),
        travel_along=travel(impact, ball=ball, speed=float(past @ frame.along), impulse=float(given.along)),
        travel_around=travel(impact, ball=ball, speed=float(past @ frame.around), impulse=float(given.around)),
        gripped=bool(given.gripped),
        second_plane=abs(float(given.around / given.normal)),
    )


def strikes(
    reduced: ReducedBat[Bat],
    *,
    ball: Ball,
    swings: Swings,
    pitches: BallMotion | BallMotions,
    contact: Contact,
    friction: Friction = USUAL_FRICTION,
    threads: int | None = None,
) -> Strikes:
    """Return many hits with one bat; every row ends with its own outcome.

    Parameters
    ----------
    swings : with the bat's speed at the point of impact; their number is that of the hits, or of ``contact``.
    pitches : the balls as they arrive.
    contact : where they meet, shapes (n,); a position off the bat is refused.
    threads : workers of the collision kernel.

    Raises
    ------
    InputError
        for a position that is not on the bat.

    >>> from math import radians
    >>> from sweetspot import BallMotion, Contact, Swings, catalog, strikes
    >>> from sweetspot.dynamics.reduction import reduced_bat
    >>> from sweetspot.motion.swing_path import path_axes
    >>> bat, ball = catalog.bat("r161-ash"), catalog.ball()
    >>> swings = Swings([28.0, 31.0], path_axes(radians(9), 0.0, tilt=radians(35), left=False))
    >>> pitch = BallMotion(position=(0, 0.5, 0.9), velocity=(0, -37.0, -3.0), spin=(-200.0, 0, 0))
    >>> met = Contact([bat.length - 0.15] * 2, [0.018] * 2)
    >>> strikes(reduced_bat(bat, ball=ball), ball=ball, swings=swings, pitches=pitch, contact=met).exit_speed.round(1)
    array([41. , 44.3])
    """
    meets = meetings(reduced.bat, ball=ball, swings=swings, pitches=pitches, contact=contact)
    impacts = hits_with_motion(
        reduced.modes, ball=ball, position=meets.position, closing_speed=meets.closing, threads=threads
    )
    left = _leaving(
        meets.frame,
        reduced,
        ball=ball,
        pitch=meets.pitches,
        surface_velocity=meets.surface_velocity,
        place=(meets.position, meets.radius),
        closing=meets.closing,
        normal=impacts,
        friction=friction,
    )
    return Strikes(
        outcome=np.where(meets.missed, int(Outcome.MISS), impacts.outcome),
        closing_speed=np.where(meets.missed, np.nan, meets.closing),
        collision_efficiency=impacts.collision_efficiency,
        contact_time=impacts.contact_time,
        peak_force=impacts.peak_force,
        peak_compression=impacts.peak_compression,
        touches=impacts.touches,
        exit_speed=np.linalg.norm(left.velocity, axis=-1),
        velocity=left.velocity,
        spin=left.spin,
    )


class Meetings(NamedTuple):
    """Bats and balls as they meet; of what is missed the closing speed is 0.

    Parameters
    ----------
    position, radius : m from the knob end, and of the bat there, shape (n,).
    closing : m/s along the line of centres.
    surface_velocity : m/s of the bat where it is touched, shape (n, 3).
    """

    position: Array
    radius: Array
    closing: Array
    missed: NDArray[np.bool_]
    frame: ContactFrame
    surface_velocity: Array
    pitches: BallMotions


def meetings(bat: Bat, *, ball: Ball, swings: Swings, pitches: BallMotion | BallMotions, contact: Contact) -> Meetings:
    """Return how bat and ball meet in many hits; a position off the bat is refused."""
    axes = swings.axes
    speed, place, above = np.broadcast_arrays(
        *(np.asarray(values, float).ravel() for values in (swings.bat_speed, contact.position, contact.offset))
    )
    check_positions(bat, place)
    velocity, spin = (
        np.broadcast_to(np.asarray(values, float), (len(speed), 3)) for values in (pitches.velocity, pitches.spin)
    )
    radius = bat.diameter_at(place) / 2
    reach = ball.radius + radius
    missed = np.abs(above) >= reach
    frame = contact_frame(*axes, lift=np.arcsin(np.clip(above / reach, -1.0, 1.0)))
    bat_velocity = speed[:, None] * axes.forward
    closing = np.where(missed, 0.0, np.sum((bat_velocity - velocity) * frame.normal, axis=-1))
    frame = ContactFrame(*(np.broadcast_to(axis, (len(speed), 3)) for axis in frame))
    turning = np.divide(speed, place - swings.pivot, out=np.zeros(len(speed)), where=place > swings.pivot)
    surface = bat_velocity + turning_surface(frame, axes, angular_speed=turning, radius=radius)
    return Meetings(place, radius, closing, missed, frame, surface, BallMotions(velocity=velocity, spin=spin))


def check_positions(bat: Bat, place: Array) -> None:
    """Refuse places in m from the knob end that are not on a bat."""
    if np.any((place < 0) | (place > bat.length)):
        worst = float(place[np.argmax(np.abs(place - bat.length / 2))])
        raise InputError(f"position {worst:.4g} m is not on the bat; allowed is 0 to {bat.length:.4g} m")


def _leaving(
    frame: ContactFrame,
    reduced: ReducedBat[Bat],
    *,
    ball: Ball,
    pitch: BallMotion | BallMotions,
    surface_velocity: Array,
    place: tuple[ArrayLike, ArrayLike],
    closing: ArrayLike,
    normal: Impact | Impacts,
    friction: Friction,
) -> Launch:
    """Return the motion of balls after one or many hits, from the part along the line of centres.

    Parameters
    ----------
    place : m from the knob end, and the bat's radius there.
    closing : m/s along the line of centres.
    """
    position, radius = place
    impulse = ball.mass * np.asarray(closing) * (1 + np.asarray(normal.collision_efficiency))
    give = bat_give(
        reduced.modes, reduced.body, position=position, radius=radius, velocity=normal.velocity, normal_impulse=impulse
    )
    return launch(
        frame,
        ball=ball,
        pitch=pitch,
        surface_velocity=surface_velocity,
        normal_impulse=impulse,
        give=give,
        friction=friction,
    )

"""A flight that begins at a bat: the pitch, the swing that meets it, how the ball leaves, and all of it in space."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from typing import Annotated, NamedTuple

import numpy as np

from sweetspot.answers.flight import BallLeaving, ball_leaving
from sweetspot.answers.records import Length, Ratio, Speed
from sweetspot.collision.hit_in_space import Contact, strikes
from sweetspot.dynamics.reduction import ReducedBat
from sweetspot.equipment.ball import Ball
from sweetspot.equipment.bat import Bat
from sweetspot.motion.ball_motion import USUAL_CONTACT, BallMotion, batted_ball
from sweetspot.motion.swing import Conditions
from sweetspot.motion.swing_path import SwingPath, Swings
from sweetspot.numerics.arrays import Array
from sweetspot.reports.swing_in_words import space_words
from sweetspot.units import FOOT, INCH, RPM
from sweetspot.units.dimensions import LENGTH, RATIO, SPEED, SPIN
from sweetspot.web.bats import ball_of, conditions_of, place_of, reduced
from sweetspot.web.documents import Sentences, in_both_systems
from sweetspot.web.drawings import BatPicture, DrawnOutline, bat_picture, outline
from sweetspot.web.errors import about
from sweetspot.web.views.flight_state import FlightState

FORWARD = USUAL_CONTACT[1]
"""m in front of the plate's tip where ball and bat meet."""


@dataclass(frozen=True)
class SwungAt:
    """The swing where it meets the ball, from the knob end."""

    position: Length
    bat_speed: Speed
    collision_efficiency: Ratio


@dataclass(frozen=True, kw_only=True)
class HitInSpace:
    """A swing and a hit where they happen: to the right as the catcher sees it, to centre field, and up.

    Parameters
    ----------
    forward, up, tip : unit vectors of the swing, shape (3,): the way of the barrel, square to its plane, from knob to
        tip.
    outline : of the bat.
    place : where it meets the ball, from the knob end; ``pivot``: what it turns about.
    axis : the place of that point of its axis, shape (3,).
    ball, radius : the ball's centre, shape (3,), and its radius.
    pitch, leaves : its velocity before and after, shape (3,).
    spin : afterwards, shape (3,), right-handed.
    """

    forward: Annotated[Array, RATIO]
    up: Annotated[Array, RATIO]
    tip: Annotated[Array, RATIO]
    outline: DrawnOutline
    place: Length
    pivot: Length
    axis: Annotated[Array, LENGTH]
    ball: Annotated[Array, LENGTH]
    radius: Length
    pitch: Annotated[Array, SPEED]
    leaves: Annotated[Array, SPEED]
    spin: Annotated[Array, SPIN]
    sentence: Sentences


class Meeting(NamedTuple):
    """A pitch and the swing that meets it."""

    free_bat: ReducedBat[Bat]
    conditions: Conditions
    path: SwingPath
    pitch: BallMotion
    contact: Contact


def met(state: FlightState, ball: Ball) -> Meeting:
    """Return the pitch and the swing that the controls describe."""
    free_bat = reduced(state, ball)
    bat, conditions = free_bat.bat, conditions_of(state, free_bat.bat)
    with about("tilt_deg"):
        path = SwingPath(
            attack_angle=math.radians(state.attack_angle_deg),
            attack_direction=math.radians(state.attack_direction_deg),
            tilt=math.radians(state.tilt_deg),
            bats=state.batter,
        )
    place = place_of(state, bat, conditions)
    pitch = batted_ball(
        speed=conditions.pitch.speed,
        launch_angle=math.radians(state.pitch_angle_deg),
        spray=math.pi,
        backspin=state.pitch_backspin_rpm * RPM,
        position=(0.0, FORWARD, state.height_ft * FOOT),
    )
    return Meeting(free_bat, conditions, path, pitch, Contact(place, state.offset_in * INCH))


def struck(state: FlightState, ball: Ball) -> tuple[BallMotion | None, SwungAt, BatPicture]:
    """Return the ball as the swing's controls send it off, by the compiled collision, with the swing and its bat."""
    free_bat, conditions, path, pitch, contact = met(state, ball)
    place = float(np.asarray(contact.position))
    bat_speed = conditions.swing.speed_at(place)
    hits = strikes(
        free_bat.held(conditions.hands),
        ball=ball,
        swings=Swings(bat_speed, path.axes, conditions.swing.pivot),
        pitches=pitch,
        contact=contact,
    )
    leaves = bool(np.isfinite(hits.velocity).all())
    picture, tilt = bat_picture(state, free_bat), state.tilt_deg
    plane = {"attack_angle_deg": (-tilt, tilt), "tilt_deg": (abs(state.attack_angle_deg), 90.0)}  # no path is steeper
    return (
        BallMotion(pitch.position, hits.velocity[0], hits.spin[0]) if leaves else None,
        SwungAt(place, bat_speed, float(hits.collision_efficiency[0])),
        replace(picture, bounds={**picture.bounds, **plane}),
    )


def space(state: FlightState) -> HitInSpace | None:
    """Return the swing and the hit where they happen; None: no bat is swung, or it misses the ball."""
    if state.start != "swing":
        return None
    ball = ball_of(state)
    free_bat, conditions, path, pitch, contact = met(state, ball)
    motion, swung_at, _ = struck(state, ball)
    if motion is None:
        return None
    place, axes = float(swung_at.position), path.axes
    apart = ball.radius + float(free_bat.bat.diameter_at(place)) / 2
    lift = math.asin(float(np.asarray(contact.offset)) / apart)
    normal = math.cos(lift) * axes.forward + math.sin(lift) * axes.up
    leaving: BallLeaving = ball_leaving(motion)
    return HitInSpace(
        forward=axes.forward,
        up=axes.up,
        tip=axes.tip,
        outline=outline(free_bat.bat).outline,
        place=place,
        pivot=conditions.swing.pivot,
        axis=pitch.position - apart * normal,
        ball=pitch.position,
        radius=ball.radius,
        pitch=pitch.velocity,
        leaves=motion.velocity,
        spin=motion.spin,
        sentence=in_both_systems(
            [
                space_words(
                    attack_angle=path.attack_angle,
                    tilt=math.radians(state.tilt_deg),
                    offset=state.offset_in * INCH,
                    leaving=leaving,
                    spin=motion.spin,
                )
            ]
        ),
    )

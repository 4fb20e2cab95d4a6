"""Hits all along a bat: what every definition of the sweet spot is read from."""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple, Protocol

import numpy as np
from numpy.typing import ArrayLike

from sweetspot.collision.closed_form import bbcor, exit_speed, rigid_efficiency
from sweetspot.collision.impact import Impacts, bat_energy
from sweetspot.collision.kernel import hits_with_motion
from sweetspot.dynamics.modes import Modes
from sweetspot.dynamics.reduction import ReducedBat
from sweetspot.dynamics.rigid import hand_impulse_ratio
from sweetspot.equipment.ball import Ball
from sweetspot.equipment.implement import Implement
from sweetspot.motion.swing import Conditions, Hands
from sweetspot.numerics.arrays import Array

LOW, HIGH, BAND_QUALITY = 6.310, 1258.9, 0.71
"""Hz, Hz and resonance quality of the band of Wh [iso5349, annex A]."""
CORNER, CORNER_QUALITY = 15.915, 0.64
"""Hz and quality of its transition from acceleration to velocity [iso5349, annex A]."""


def acceleration_weight(frequency: ArrayLike) -> Array:
    """Return |Wh| of an acceleration at frequencies in Hz [iso5349, annex A].

    Wh = s^2 w2^2 / ((s^2 + w1 s / Q1 + w1^2) (s^2 + w2 s / Q1 + w2^2)) times (s + w3) w3 / (s^2 + w3 s / Q2 + w3^2).

    >>> acceleration_weight([125.9, 501.2]).round(3).tolist()  # the standard's table at 125 and 500 Hz
    [0.127, 0.031]
    """
    s = 2j * np.pi * np.asarray(frequency, float)
    low, high, corner = 2 * np.pi * LOW, 2 * np.pi * HIGH, 2 * np.pi * CORNER
    band = s**2 * high**2 / ((s**2 + low * s / BAND_QUALITY + low**2) * (s**2 + high * s / BAND_QUALITY + high**2))
    slope = (s + corner) * corner / (s**2 + corner * s / CORNER_QUALITY + corner**2)
    return np.asarray(np.abs(band * slope))


def velocity_weight(frequency: ArrayLike) -> Array:
    """Return the same for a velocity, 1 where hands feel velocities alike, from about 30 to 600 Hz.

    |Wh| f / `CORNER`: 0.75 at 1.2 kHz and 0.1 at 4 kHz, without an edge; 0 for rigid motions.
    """
    return np.asarray(acceleration_weight(frequency) * np.asarray(frequency, float) / CORNER)


POINTS = 161
ABOVE_HANDS = 0.05
"""m above the top hand's centre where a scan begins; an implement with a face is hit on its face only."""


class EnergyShares(NamedTuple):
    """Shares of the incoming energy of many hits, each of the shape of the hits; nan where none ended.

    ``heat``: lost in the ball, and the little that the bat's damping takes during contact.
    """

    ball: Array
    translation: Array
    rotation: Array
    bending: Array
    hoop: Array
    face: Array
    heat: Array


@dataclass(frozen=True)
class Scan:
    """Hits at many positions under the same swing; every array has shape (positions,).

    Parameters
    ----------
    position : m from the knob end, increasing.
    bat_speed, closing_speed : m/s.
    collision_efficiency, rigid_efficiency : q of the real bat and of a rigid one of the same mass.
    bbcor : ball-bat restitution about the standard pivot 6 in from the knob.
    exit_speed, rigid_exit_speed : m/s.
    hand_impulse : N s that the hands must give to hold their place, from the rigid motion; 0 at the percussion centre.
    sting : m/s, root mean square of the vibration at both hands after the hit, as felt (`velocity_weight`).
    contact_time, peak_force : s and N.
    touches : how many times the ball was touched; more than once where the bat caught up with it.
    energy : where the incoming energy goes, in the frame of the undisturbed bat.
    """

    position: Array
    bat_speed: Array
    closing_speed: Array
    collision_efficiency: Array
    rigid_efficiency: Array
    bbcor: Array
    exit_speed: Array
    rigid_exit_speed: Array
    hand_impulse: Array
    sting: Array
    contact_time: Array
    peak_force: Array
    touches: Array
    energy: EnergyShares


def scan(reduced: ReducedBat[Implement], conditions: Conditions, positions: Array | None = None) -> Scan:
    """Return hits all along a bat.

    The modes are those of the bat as it is held. ``positions``: m from the knob end; None: evenly from just above the
    top hand to the tip, or along the face.
    """
    body, modes = reduced.body, reduced.modes
    if positions is None:
        outline = reduced.bat.outline
        start = max(conditions.hands.position + ABOVE_HANDS, conditions.swing.pivot + ABOVE_HANDS)
        positions = (
            np.linspace(start, reduced.bat.length, POINTS)
            if outline is None
            else np.linspace(max(start, outline.start), outline.end, POINTS)
        )
    ball, hands = conditions.ball, conditions.hands
    ball_speed = conditions.pitch.speed
    bat_speed = conditions.swing.angular_speed * (positions - conditions.swing.pivot)
    closing = ball_speed + bat_speed
    outcome = hits_with_motion(modes, ball=ball, position=positions, closing_speed=closing)
    efficiency = outcome.collision_efficiency
    rigid = rigid_efficiency(ball, body=body, position=positions, closing_speed=closing)
    rigid = np.where(closing > 0, rigid, np.nan)
    ratio = hand_impulse_ratio(body, positions, hands=hands.position)
    return Scan(
        position=positions,
        bat_speed=bat_speed,
        closing_speed=closing,
        collision_efficiency=efficiency,
        rigid_efficiency=rigid,
        bbcor=bbcor(efficiency, body=body, ball=ball, position=positions),
        exit_speed=exit_speed(efficiency, ball_speed=ball_speed, bat_speed=bat_speed),
        rigid_exit_speed=exit_speed(rigid, ball_speed=ball_speed, bat_speed=bat_speed),
        hand_impulse=ratio * ball.mass * closing * (1 + efficiency),
        sting=sting(modes, hands=hands, displacement=outcome.displacement, velocity=outcome.velocity),
        contact_time=outcome.contact_time,
        peak_force=outcome.peak_force,
        touches=outcome.touches,
        energy=energy_shares(outcome, modes=modes, ball=ball, closing_speed=closing),
    )


def energy_shares(impacts: Impacts, *, modes: Modes, ball: Ball, closing_speed: ArrayLike) -> EnergyShares:
    """Return the shares of the incoming energy m v^2 / 2 of many hits; they sum to one.

    ``closing_speed``: m/s along the line of centres, one or one for each hit.
    """
    incoming = ball.mass * np.asarray(closing_speed, float) ** 2 / 2
    incoming = np.where(incoming > 0, incoming, np.nan)
    translation, rotation, bending, hoop, face = (
        part / incoming for part in bat_energy(modes, impacts.displacement, impacts.velocity)
    )
    leaving = impacts.collision_efficiency**2
    heat = 1 - leaving - translation - rotation - bending - hoop - face
    return EnergyShares(leaving, translation, rotation, bending, hoop, face, heat)


def sting(modes: Modes, *, hands: Hands, displacement: Array, velocity: Array) -> Array:
    """Return the vibration speed at the hands in m/s, root mean square over time and over both hands.

    Each mode rings on with amplitude V_i = sqrt(q'^2 + omega^2 q^2) from release, so the handle at h moves with
    s_i(h) V_i, of which hands feel the part w(f_i) (`velocity_weight`); modes of different frequency add as squares.
    """
    felt = velocity_weight(modes.frequency) ** 2
    amplitude = velocity**2 + (modes.angular_frequency * displacement) ** 2
    shapes = modes.shape_at(np.array(hands.places)) ** 2
    return np.asarray(np.sqrt(amplitude @ (felt * shapes.mean(axis=0)) / 2))


class Ringing(Protocol):
    """Many implements that ring after a hit."""

    @property
    def angular_frequency(self) -> Array: ...
    def shapes_at(self, position: Array) -> Array: ...


def stings(bats: Ringing, impacts: Impacts, *, hands: Hands) -> Array:
    """Return the vibration at the hands in m/s of hits of many implements, shape (bats, places); see `sting`."""
    omega = bats.angular_frequency
    amplitude = impacts.velocity**2 + (omega[:, None, :] * impacts.displacement) ** 2
    shapes = bats.shapes_at(np.tile(np.array(hands.places), (len(omega), 1))) ** 2
    felt = velocity_weight(omega / (2 * np.pi)) ** 2 * shapes.mean(axis=1)
    return np.asarray(np.sqrt(np.einsum("bpm,bm->bp", amplitude, felt) / 2))

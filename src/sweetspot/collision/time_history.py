"""A hit in slow motion: ball, bat and energy at a row of moments, from first touch until the bat rings freely.

Everything is seen from the undisturbed swing, as in `coupled`: the bat starts at rest, the ball comes with the closing
speed, positive along the ball's path.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from sweetspot.collision.contact_law import unloading_exponent
from sweetspot.collision.impact import Impact, bat_energy
from sweetspot.collision.modal_response import ModalMotion, free_motion, replayed
from sweetspot.dynamics.modes import Modes
from sweetspot.equipment.ball import Ball
from sweetspot.errors import InputError
from sweetspot.numerics.arrays import Array

DURATION = 5e-3
"""s; one swing to and fro of a wood bat's lowest mode takes 6 ms."""
CONTACT_FRAMES, FREE_FRAMES = 100, 120
ARRIVAL = 0.1
"""Part of the struck place's greatest speed at which a wave counts as arrived; the dispersed forerunners are below."""


class EnergyHistory(NamedTuple):
    """Energies at each moment, J, shape (times,); in every row they sum to the incoming energy.

    Parameters
    ----------
    ball : kinetic energy of the ball.
    stored : elastic energy in the ball: what it would give back if it sprang back from here.
    heat : lost in the ball: the rest of the work done on it.
    translation, rotation, bending, hoop, damping, face : of the bat, as in `EnergyLedger`.
    dent : stored in the instantaneous compliance of the surface under the ball, C G^2 / 2.
    """

    ball: Array
    stored: Array
    heat: Array
    translation: Array
    rotation: Array
    bending: Array
    hoop: Array
    damping: Array
    face: Array
    dent: Array


@dataclass(frozen=True)
class TimeHistory:
    """A hit at a row of moments.

    Parameters
    ----------
    impact : the hit.
    times : s after first touch, shape (times,).
    travel : m that the ball has moved since first touch, against its path negative, shape (times,).
    force, compression : N and m, of the ball, shape (times,); 0 after release.
    displacement, velocity : of every mode, sqrt(kg) m and sqrt(kg) m/s, shape (times, n).
    energy : where the energy is.
    """

    impact: Impact
    times: Array
    travel: Array
    force: Array
    compression: Array
    displacement: Array
    velocity: Array
    energy: EnergyHistory


def history_of(
    impact: Impact,
    *,
    modes: Modes,
    ball: Ball,
    duration: float = DURATION,
    contact_frames: int = CONTACT_FRAMES,
    free_frames: int = FREE_FRAMES,
) -> TimeHistory:
    """Return the moments of a hit.

    During contact they are kicks of the collision's own time steps, so nothing is interpolated; afterwards the modes
    ring on exactly and the ball flies on. The force law says what the ball gives back from any compression,
    G u / (p + 1) with G the elastic part of its force and p its unloading exponent, less what its damper will take;
    what has been put in beyond that is heat.

    Parameters
    ----------
    impact : a hit by the ball's own contact law.
    modes, ball : the same as in that hit.
    duration : s after first touch, > 0; contact is always shown whole.
    contact_frames, free_frames : moments until release and after it, each >= 2; fewer where there are fewer steps.
    """
    if not len(impact.times):
        raise InputError(f"there is no hit to film: {impact.outcome.sentence}")
    if not (np.isfinite(duration) and duration > 0) or min(contact_frames, free_frames) < 2:
        raise InputError(
            f"a film of {duration:g} s with {contact_frames} and {free_frames} frames was asked for; allowed is more "
            "than 0 s, and 2 frames or more of each"
        )
    contact = replayed(impact, modes)
    chosen = np.unique(np.linspace(0, len(contact.times) - 1, contact_frames).round().astype(int))
    bat, later = _ringing_on(contact, chosen, modes, duration=duration, frames=free_frames)
    force, compression = np.append(impact.force, 0.0), np.append(impact.compression, 0.0)
    speed, travel = _ball_motion(impact, ball, contact.times)
    give = float(modes.compliance_at(impact.position, impact.lateral, closing_speed=impact.closing_speed))
    elastic, stored = _inside_ball(ball, compression)
    dent = give * elastic**2 / 2
    pressed = np.append(impact.approach, 0.0)
    heat = np.concatenate([[0.0], np.cumsum(np.diff(pressed) * (force[1:] + force[:-1]) / 2)]) - stored - dent

    def whole(during: Array, after: Array | float) -> Array:
        """Join the chosen moments of contact to what comes after."""
        return np.concatenate([during[chosen], np.broadcast_to(after, len(later))])

    translation, rotation, bending, hoop, face = bat_energy(modes, bat.displacement, bat.velocity)
    return TimeHistory(
        impact=impact,
        times=bat.times,
        travel=whole(travel, travel[-1] + speed[-1] * later),
        force=whole(force, 0.0),
        compression=whole(compression, 0.0),
        displacement=bat.displacement,
        velocity=bat.velocity,
        energy=EnergyHistory(
            ball=ball.mass * whole(speed, speed[-1]) ** 2 / 2,
            stored=whole(stored, 0.0),
            heat=whole(heat, heat[-1]),
            translation=translation,
            rotation=rotation,
            bending=bending,
            hoop=hoop,
            damping=bat.damping,
            face=face,
            dent=whole(dent, 0.0),
        ),
    )


def arrival_time(film: TimeHistory, *, modes: Modes, position: float) -> float | None:
    """Return when the wave from the hit reaches a place on the bat, s after first touch.

    That is when the place first moves with `ARRIVAL` of the greatest speed of the place that was struck; None where
    it never does within the film. To within a frame.

    Parameters
    ----------
    position : m from the knob end.
    """
    hit = film.impact
    struck = np.abs(film.velocity @ modes.shape_at(hit.position, hit.lateral, closing_speed=hit.closing_speed))
    moving = np.flatnonzero(np.abs(film.velocity @ modes.shape_at(position)) >= ARRIVAL * struck.max())
    return float(film.times[moving[0]]) if len(moving) else None


def impulse_given(impact: Impact, time: float) -> float:
    """Return the part of the whole impulse that the ball has given by ``time`` s after first touch, 0 to 1."""
    given = np.cumsum(impact.impulse)
    return float(np.interp(time, impact.times, given) / given[-1])


def _ringing_on(
    contact: ModalMotion, chosen: NDArray[np.int64], modes: Modes, *, duration: float, frames: int
) -> tuple[ModalMotion, Array]:
    """Return the bat's motion at chosen moments of contact and freely on; and the free ones, s after release."""
    begin = float(contact.times[-1])
    free = free_motion(
        modes,
        displacement=contact.displacement[-1],
        velocity=contact.velocity[-1],
        step=abs(duration - begin) / frames,
        count=frames if duration > begin else 0,
    )
    motion = ModalMotion(
        times=np.concatenate([contact.times[chosen], begin + free.times]),
        displacement=np.concatenate([contact.displacement[chosen], free.displacement]),
        velocity=np.concatenate([contact.velocity[chosen], free.velocity]),
        damping=np.concatenate([contact.damping[chosen], contact.damping[-1] + free.damping]),
    )
    return motion, free.times


def _ball_motion(impact: Impact, ball: Ball, times: Array) -> tuple[Array, Array]:
    """Return the ball's speed and travel at the kicks and at the end; at a kick the speed is the mean across it."""
    after = impact.closing_speed - np.cumsum(impact.impulse) / ball.mass
    before = np.concatenate([[impact.closing_speed], after[:-1]])
    travel = np.concatenate([[0.0], np.cumsum(after * np.diff(times))])
    return np.append((before + after) / 2, after[-1]), travel


def _inside_ball(ball: Ball, compression: Array) -> tuple[Array, Array]:
    """Return the elastic part of the ball's force, N, and the energy stored in it, J, at the kicks and at the end."""
    deepest = _deepest_yet(compression)
    peaks, place = np.unique(deepest, return_inverse=True)
    powers = np.array([unloading_exponent(ball, float(peak)) if peak > 0 else ball.exponent for peak in peaks])
    depth = np.divide(compression, deepest, out=np.zeros_like(compression), where=deepest > 0)
    elastic = ball.stiffness * deepest**ball.exponent * depth ** powers[place]
    return elastic, elastic * compression / (powers[place] + 1)


def _deepest_yet(compression: Array) -> Array:
    """Return the greatest compression so far of the contact under way, m; a ball that was free begins anew."""
    contact = np.cumsum((compression > 0) & (np.append(0.0, compression[:-1]) == 0))
    deepest = np.zeros_like(compression)
    for number in range(1, int(contact[-1]) + 1):
        during = contact == number
        deepest[during] = np.maximum.accumulate(compression[during])
    return deepest

"""What the handle can do to the ball: hands of every kind, and when the wave from the hit gets there."""

from __future__ import annotations

import numpy as np

from sweetspot.analysis.bat_analysis import TYPICAL_HAND
from sweetspot.collision.coupled import hit
from sweetspot.collision.free_motion import modal_propagator_of
from sweetspot.collision.kernel import hits
from sweetspot.dynamics.hands import held_modes
from sweetspot.dynamics.modes import Modes
from sweetspot.dynamics.reduction import bending_modes
from sweetspot.motion.swing import Hands
from sweetspot.numerics.arrays import Array
from sweetspot.units import INCH
from sweetspot.validation.computations import shared

HANDS = 6 * INCH
VICE = 1e9
"""N/m of each of two places 3.5 in apart: a handle that can neither move nor turn."""
BENCH = 1e4
"""kg behind each of them."""
BARREL = np.linspace(3 * INCH, 9 * INCH, 25)
"""m from the tip: barrel impacts."""
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
    places = shared.length(bat) - BARREL
    swing = conditions.swing.angular_speed * (places - conditions.swing.pivot)

    def speeds(modes: Modes) -> Array:
        closing = conditions.pitch.speed + swing
        done = hits(modes, ball=conditions.ball, position=places, closing_speed=closing)
        efficiency = done.collision_efficiency
        return np.asarray(efficiency * conditions.pitch.speed + (1 + efficiency) * swing)

    alone = speeds(free)
    grips = (Hands(position=HANDS, **TYPICAL_HAND), Hands(position=HANDS, mass=BENCH, stiffness=VICE))
    return max(float(np.abs(speeds(held_modes(free, hands)) / alone - 1).max()) for hands in grips)


def impulse_given_at_arrival(*, bat: str) -> float:
    """Return which part of the impulse the ball has given when the wave of the best hit arrives at the top hand.

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


COMPUTATIONS = (grip_change, impulse_given_at_arrival)

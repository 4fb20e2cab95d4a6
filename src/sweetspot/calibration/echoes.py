"""What a room does to the tones of a tap: it answers a tone with others near it, and nobody can tell them apart.

A bat's own tones lie far apart. In a room each has neighbours within a few per cent, which the room adds while it
dies away; a fit gives each a frequency far surer than the tone behind them is known.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from sweetspot.calibration.sinusoids import Sinusoid
from sweetspot.numerics.arrays import Array

ECHO = 0.1
"""Part of its frequency within which a weaker tone that dies away faster is an echo (assumed)."""
NEAR = 0.04
"""Part of its frequency within which a tone's neighbours may be the room's (assumed)."""
IN_A_ROOM = 0.5
"""Part of all tones that have neighbours, from which on they are the room's: two planes or two modes of an implement
give a neighbour or two (assumed)."""


def echoed(one: Sinusoid, tones: Sequence[Sinusoid]) -> bool:
    """Say whether a tone beside this one dies away more slowly and holds more energy: this is its echo in the room."""
    return any(
        abs(other.frequency.value - one.frequency.value) < ECHO * one.frequency.value
        and other.damping_ratio.value < one.damping_ratio.value
        and other.energy(math.inf) > one.energy(math.inf)
        for other in tones
    )


def in_their_room(tones: tuple[Sinusoid, ...]) -> tuple[Sinusoid, ...]:
    """Return tones with what a room leaves open of each: how far its energy is spread over its neighbours.

    sigma^2 = sum E_j (f_j - f)^2 / sum E_j over the tones within `NEAR`, E = a^2 / (zeta f) the energy of each. Where
    less than `IN_A_ROOM` of the tones have neighbours nothing is left open.

    Parameters
    ----------
    tones : of one tap.
    """
    if len(tones) < 2:
        return tones
    frequency = np.array([one.frequency.value for one in tones])
    near = np.abs(frequency[:, None] - frequency) < NEAR * frequency[:, None]
    if np.mean(near.sum(axis=1) > 1) < IN_A_ROOM:
        return tones
    energy: Array = near * np.array([one.energy(math.inf) for one in tones])
    spread = np.sqrt(np.sum(energy * (frequency[:, None] - frequency) ** 2, axis=1) / energy.sum(axis=1))
    return tuple(replace(one, shared_error=float(own)) for one, own in zip(tones, spread, strict=True))

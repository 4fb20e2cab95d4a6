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
"""Part of its frequency within which a tone with less energy than another may be its echo (assumed)."""
AUDIBLE, WEIGHTY = 1e-3, 1e-2
"""Energy over that of the tone with most, below which a tone may be the room's, and below which its damping says
nothing of the body (both assumed; of 103 tones that made-up rooms added to 16 taps, 3 hold more than the first and
none more than the second without another beside it)."""
NEAR = 0.04
"""Part of its frequency within which a tone's neighbours may be the room's (assumed)."""
IN_A_ROOM = 0.5
"""Part of all tones that have neighbours, from which on they are the room's: two planes or two modes of an implement
give a neighbour or two (assumed)."""


def stands_out(one: Sinusoid, tones: Sequence[Sinusoid], *, least: float = AUDIBLE) -> bool:
    """Say whether a tone is surely what was tapped: no other near it holds more energy, and it holds enough.

    A room only gives back what the body rang into it, spread over its own many tones that die away sooner. So the
    body's tone has most of the energy around it. Of a mode in two planes the fainter does not stand out either.

    Parameters
    ----------
    tones : all of the same tap.
    least : of the greatest energy, that it holds.
    """
    own, energies = one.energy(math.inf), [other.energy(math.inf) for other in tones]
    near = (
        energy
        for other, energy in zip(tones, energies, strict=True)
        if abs(other.frequency.value - one.frequency.value) < ECHO * one.frequency.value
    )
    return own >= max(near, default=own) and own >= least * max(energies, default=own)


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

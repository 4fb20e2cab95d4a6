"""Tapping a bat: which of its motions a short push excites."""

from __future__ import annotations

import numpy as np

from sweetspot.errors import InputError
from sweetspot.vibration.modes import Array, Modes


def tapped(modes: Modes, *, position: float, duration: float) -> Array:
    """Return the speed in which every mode is left per impulse of a half-sine tap, 1/sqrt(kg), shape (n,).

    Mode i is left with s_i(x) J G(omega_i), G(omega) = |cos(omega T / 2)| / |1 - (omega T / pi)^2|: slow modes take the
    whole impulse J, modes much faster than the tap hardly any. Damping during the tap is left out.

    Parameters
    ----------
    position : m from the knob end.
    duration : T in s, >= 0; 0 is a blow of no duration, which excites every mode alike.

    >>> from sweetspot import catalog, reduce
    >>> from sweetspot.vibration.beam import bending_modes
    >>> modes = bending_modes(reduce(catalog.bat("r161-ash")))
    >>> bool(tapped(modes, position=0.7, duration=0.0)[0] == modes.shape_at(0.7)[0])
    True
    """
    if not (np.isfinite(duration) and duration >= 0):
        raise InputError(f"tap lasts {duration:g} s; allowed is 0 or more")
    return np.asarray(modes.shape_at(position) * half_sine_gain(modes.angular_frequency * duration / np.pi))


def half_sine_gain(ratio: Array) -> Array:
    """Return |cos(pi r / 2)| / |1 - r^2| for r = omega T / pi: 1 for slow motions, pi / 4 where half a period is T."""
    ratio = np.asarray(ratio, float)
    near = np.abs(ratio - 1) < 1e-6
    safe = np.where(near, 2.0, ratio)
    return np.where(near, np.pi / 4, np.abs(np.cos(np.pi * safe / 2) / (1 - safe**2)))

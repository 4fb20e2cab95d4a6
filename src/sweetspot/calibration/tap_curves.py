"""What a tap looks like: the shape of its sound over time, and its spectrum."""

from __future__ import annotations

import numpy as np

from sweetspot.calibration.recording import Recording
from sweetspot.calibration.sinusoids import Fit
from sweetspot.numerics.arrays import Array

POINTS = 4000
"""Of a waveform, at most."""
FILLED = 4
"""Times the sound's length over which its spectrum is taken, so that peaks are smooth."""


def waveform(recording: Recording, *, points: int = POINTS) -> tuple[Array, Array, Array]:
    """Return times in s with the least and the greatest sample around each, full scale 1.

    Parameters
    ----------
    points : at most.
    """
    size = max(1, -(-len(recording.samples) // points))
    pieces = recording.samples[: len(recording.samples) // size * size].reshape(-1, size)
    return np.arange(len(pieces)) * size / recording.rate, pieces.min(axis=1), pieces.max(axis=1)


def spectrum(fit: Fit) -> tuple[Array, Array]:
    """Return frequencies in Hz and the ringing's level in dB below its loudest."""
    size = FILLED * len(fit.samples)
    power = np.abs(np.fft.rfft(fit.samples, size)) ** 2
    level = 10 * np.log10(power / power.max() + 1e-12)
    return np.asarray(np.fft.rfftfreq(size, 1 / fit.rate), float), np.asarray(level, float)

"""The tone of a club whose grip is clamped, as clubmakers measure shafts: cycles per minute.

The club is a cantilever from the clamp on. Its lowest mode is found by Stodola's iteration: the inertia of a deflection
w bends it into the next one, w'' = M / EI + (V / kappa G A)', with the shear V and the moment M of mu w; the head
counts with its mass and its own moment of inertia.
"""

from __future__ import annotations

import math

import numpy as np

from sweetspot.dynamics.beam import BeamModel, beam_model, section
from sweetspot.dynamics.reduction import bending_frequencies
from sweetspot.numerics.arrays import Array
from sweetspot.units import INCH

CLAMP = 5 * INCH
"""m of the butt in the clamp: five inches, as most machines have it [recalled]."""
PER_MINUTE = 60.0
"""Cycles per minute of one hertz."""
NODES, ROUNDS = 1601, 60
"""Places along the free part, and iterations; each leaves less than a thirtieth of the other modes."""


def clamped_frequency(beam: BeamModel, *, clamp: float = CLAMP) -> float:
    """Return the lowest frequency in Hz of an implement clamped at its butt; see `bending_frequencies` for it free.

    Where its first bending mode was measured, all its stiffness is scaled to that, as there.

    Parameters
    ----------
    clamp : m of the butt that the clamp holds, less than its length.

    >>> from sweetspot import beam_model, catalog
    >>> 200 < 60 * clamped_frequency(beam_model(catalog.implement("golf-driver"))) < 300  # cycles per minute
    True
    """
    tool = beam.bat
    place = np.linspace(clamp, tool.length, NODES)
    parts, step = section(beam, (place[1:] + place[:-1]) / 2), float(place[1] - place[0])
    lumps = [lump for lump in tool.lumps() if lump.position > clamp]
    mass, turning = np.zeros(NODES), np.zeros(NODES)
    mass[:-1] += parts.mass * step / 2
    mass[1:] += parts.mass * step / 2
    for lump in lumps:
        near = (lump.position - clamp) / step
        low, part = min(int(near), NODES - 2), near - min(int(near), NODES - 2)
        for node, share in ((low, 1 - part), (low + 1, part)):
            mass[node] += share * lump.mass
            turning[node] += share * lump.moi
    shape, tilt = ((place - clamp) / (tool.length - clamp)) ** 2, 2 * (place - clamp) / (tool.length - clamp) ** 2
    square = 0.0
    for _ in range(ROUNDS):
        shear = _from_end(mass * shape)[1:]  # in each piece
        moment = _from_end(turning * tilt)[1:] + _from_end(np.append(shear, 0.0) * step)[:-1] - shear * step / 2
        bent = np.concatenate([[0.0], np.cumsum(moment / parts.bending_stiffness * step)])
        slid = shear / parts.shear_stiffness
        moved = np.concatenate([[0.0], np.cumsum(((bent[1:] + bent[:-1]) / 2 + slid) * step)])
        square = float(mass @ (shape * moved) + turning @ (tilt * bent))
        square = float(mass @ shape**2 + turning @ tilt**2) / square
        shape, tilt = moved / moved[-1], bent / moved[-1]
    return math.sqrt(square) / (2 * math.pi) * _stiffening(beam)


def _from_end(values: Array) -> Array:
    """Return the sum of a value and all behind it."""
    return np.asarray(np.cumsum(values[::-1])[::-1])


def _stiffening(beam: BeamModel) -> float:
    """Return by what a measured first tone, hung freely, raises all tones of the drawing."""
    measured = beam.bat.frequency
    if measured is None:
        return 1.0
    drawn = beam_model(beam.bat.replaced(first_frequency=None))
    return measured / float(bending_frequencies(drawn, count=1)[0])

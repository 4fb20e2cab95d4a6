"""Bending modes of one implement hung freely: a batch of one; see `batch.bending` for the equations."""

from __future__ import annotations

import numpy as np

from sweetspot.dynamics.batch.beams import BeamRow
from sweetspot.dynamics.batch.bending import bending_batch, frequencies_of
from sweetspot.dynamics.batch.mesh import MODES
from sweetspot.dynamics.beam import BeamModel
from sweetspot.dynamics.modes import Modes
from sweetspot.numerics.arrays import Array


def bending_modes(beam: BeamModel, *, count: int = MODES, elements: int | None = None) -> Modes:
    """Return the two rigid motions and the lowest ``count`` bending modes of a freely hung bat.

    Parameters
    ----------
    beam : the bat reduced to a beam.
    count : number of bending modes, >= 1.
    elements : number of finite elements at least, None: `least_elements`; more are used where the bat has more
        breakpoints.

    Returns
    -------
    Modes
        translation, rotation, then bending modes 1 to ``count``; mass-normalised shapes, positive at the tip.

    Notes
    -----
    Where the implement has a measured `frequency`, all its stiffness is scaled so that mode 1 has it.
    Damping is the material's free-free ratio, the same for every mode. Holds for transverse waves longer than
    the barrel is thick, that is up to about 10 kHz for a wood bat.

    >>> from sweetspot import beam_model, bending_modes, catalog
    >>> modes = bending_modes(beam_model(catalog.bat("r161-ash")), count=3)
    >>> modes.frequency.round(), modes.nodes(2).round(2)  # Hz; m from the knob end where mode 1 stands still
    (array([   0.,    0.,  172.,  572., 1118.]), array([0.17, 0.67]))
    """
    return bending_batch(BeamRow([beam]), count=count, elements=elements).modes(0)


def bending_frequencies(beam: BeamModel, *, count: int, elements: int | None = None) -> Array:
    """Return the frequencies in Hz of the lowest ``count`` bending modes alone; see `bending_modes`."""
    return np.asarray(frequencies_of(BeamRow([beam]), count=count, elements=elements)[0])

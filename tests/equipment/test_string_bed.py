"""The bed's stiffness against the deflection of a round membrane, integrated outwards."""

from __future__ import annotations

import math

import numpy as np
import pytest

from sweetspot import catalog
from sweetspot.equipment.face import FaceOutline
from sweetspot.equipment.racket import Racket


def test_the_bed_is_a_membrane_under_an_even_push() -> None:
    """tau (r w')' = -p r under the patch and 0 outside, w(R) = 0: force over mean deflection of the patch (exact)."""
    racket = catalog.load_implement("tennis-racket")
    assert isinstance(racket, Racket)
    assert isinstance(racket.outline, FaceOutline)
    assert racket.strings is not None
    bed, outline = racket.strings, racket.outline
    patch, rim, tension = bed.patch, outline.mean_radius, bed.surface_tension(outline)
    radius = np.linspace(0.0, rim, 400_001)
    pushed = np.where(radius < patch, radius, 0.0)
    inside = np.concatenate([[0.0], np.cumsum((pushed[1:] + pushed[:-1]) / 2 * np.diff(radius))])
    slope = -np.divide(inside, radius, out=np.zeros_like(radius), where=radius > 0) / tension
    sunk = np.concatenate([[0.0], np.cumsum((slope[1:] + slope[:-1]) / 2 * np.diff(radius))])
    sunk -= sunk[-1]
    mean = np.trapezoid(sunk * pushed, radius) / np.trapezoid(pushed, radius)
    assert bed.face(outline).stiffness == pytest.approx(math.pi * patch**2 / mean, rel=1e-3)

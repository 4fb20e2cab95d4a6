"""Functions without branches agree with the C library's."""

from __future__ import annotations

import numpy as np

from sweetspot.numerics.vector_math import sine_and_cosine


def test_sine_and_cosine_agree_with_the_library() -> None:
    angles = np.linspace(-1.3, 1.3, 2001)
    both = np.array([sine_and_cosine(float(angle)) for angle in angles])
    assert np.abs(both - np.stack([np.sin(angles), np.cos(angles)], axis=-1)).max() < 4e-16

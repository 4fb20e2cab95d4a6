"""Functions of our own against SciPy's."""

from __future__ import annotations

import numpy as np
import pytest
import scipy.special

from sweetspot.numerics.special import bessel_j1, normal_distribution


@pytest.mark.parametrize("most", [1e-3, 1.0, 12.0, 60.0])
def test_bessel_function_of_the_first_order(most: float) -> None:
    values = np.linspace(-most, most, 401).reshape(-1, 1)
    assert bessel_j1(values) == pytest.approx(scipy.special.j1(values), abs=1e-14 * max(most, 1.0))


def test_normal_distribution() -> None:
    values = np.linspace(-8.0, 8.0, 321).reshape(3, -1)
    assert normal_distribution(values) == pytest.approx(scipy.special.ndtr(values), rel=1e-12)

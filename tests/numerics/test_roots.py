"""The root finder finds what SciPy's finds."""

from __future__ import annotations

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from sweetspot.numerics.roots import root_between

WHERE = st.floats(-5, 5)


@given(root=WHERE, low=st.floats(-10, -5.1), high=st.floats(5.1, 10), steep=st.floats(0.1, 30))
def test_roots_of_bent_functions(root: float, low: float, high: float, steep: float) -> None:
    def bent(x: float) -> float:
        return math.expm1(steep * (x - root) / 10) + (x - root) ** 3

    assert root_between(bent, low, high) == pytest.approx(root, abs=1e-9)
    assert root_between(bent, high, low) == pytest.approx(root, abs=1e-9)


def test_a_jump_is_found_and_no_change_of_sign_is_refused() -> None:
    assert root_between(lambda x: math.copysign(1.0, x - 0.3), 0.0, 1.0) == pytest.approx(0.3, abs=1e-13)
    assert root_between(lambda x: x, 0.0, 1.0) == pytest.approx(0.0, abs=1e-13)
    with pytest.raises(ValueError, match="no sign changes"):
        root_between(lambda x: 1 + x * x, 0.0, 1.0)

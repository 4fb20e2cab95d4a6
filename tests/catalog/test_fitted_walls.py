"""The walls of measured metal bats, fitted to their weights: the drawing alone has them, without being corrected."""

from __future__ import annotations

import pytest

from sweetspot import catalog
from sweetspot.dynamics.beam import beam_model
from sweetspot.dynamics.rigid import rigid_body
from sweetspot.units import INCH, OUNCE


@pytest.mark.parametrize(
    ("name", "mass", "balance_point", "moi"),
    [("russell-b5", 31.4, 19.9, 9325), ("russell-b6", 31.0, 20.4, 9590), ("russell-b7", 30.5, 19.3, 8664)],
)
def test_walls_end_cap_and_knob_weigh_what_was_measured(
    name: str, mass: float, balance_point: float, moi: float
) -> None:
    """Published: russell2010swing, weight in oz, balance point in in, and oz in^2 about 6 in; by tune_bats.py."""
    bat = catalog.bat(name)
    drawn = rigid_body(beam_model(bat.replaced(mass=None, balance_point=None, moi=None)))
    assert drawn.mass / OUNCE == pytest.approx(mass, rel=1e-3)
    assert drawn.balance_point / INCH == pytest.approx(balance_point, abs=0.01)
    assert drawn.moi(6 * INCH) / (OUNCE * INCH**2) == pytest.approx(moi, rel=1e-3)

"""Many bats side by side weigh and balance as each of them alone."""

from __future__ import annotations

import numpy as np
import pytest

from sweetspot import catalog
from sweetspot.calibration.unknowns import described, deviated, deviated_bodies, unknowns_of
from sweetspot.dynamics.rigid import rigid_body
from sweetspot.units import INCH


def test_bodies_side_by_side_are_those_of_each_bat_alone() -> None:
    bat = catalog.bat("corked-r161").cupped(diameter=1.2 * INCH, depth=0.8 * INCH)
    weighted = bat.weighted(position=0.5, mass=0.03).replaced(density_gradient=0.02, mass=None, balance_point=None)
    for line in (described(bat), described(weighted)):
        unknowns = unknowns_of(bat)
        deviations = np.random.default_rng(3).normal(0, 0.03, (5, len(unknowns)))
        bodies = deviated_bodies(line, unknowns, deviations)
        assert bodies is not None
        for body, off in zip(bodies, deviations, strict=True):
            alone = rigid_body(deviated(line, unknowns, off))
            for name in ("mass", "balance_point", "moi_cm", "roll_moi"):
                assert getattr(body, name) == pytest.approx(getattr(alone, name), rel=1e-12)


def test_other_bats_are_worked_out_one_by_one() -> None:
    bat = catalog.bat("single-wall")
    assert deviated_bodies(described(bat), unknowns_of(bat), np.zeros((1, len(unknowns_of(bat))))) is None

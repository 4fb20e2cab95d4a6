"""Our own torpedo beside its twin of equal weight and moment of inertia, as such pairs are published."""

from __future__ import annotations

import math

import pytest

from sweetspot import analyse, catalog
from sweetspot.analysis.sweet_spot import sweet_zone
from sweetspot.catalog.standard_hit import standard_conditions
from sweetspot.numerics.constants import STANDARD_AXIS
from sweetspot.units import INCH


def test_the_same_weight_and_swing_another_place() -> None:
    """The place moves by 0.4 to 0.8 in towards the hands, the fast zone is up to 0.4 in wider, BBCOR nearly the same.

    Published widths are of speed alone, so sting does not bound the zone here.
    """
    torpedo, twin = (
        analyse(bat, standard_conditions(bat)) for bat in (catalog.bat("torpedo"), catalog.bat("torpedo-twin"))
    )
    assert torpedo.body.mass == pytest.approx(twin.body.mass, rel=1e-9)
    assert torpedo.body.moi(STANDARD_AXIS) == pytest.approx(twin.body.moi(STANDARD_AXIS), rel=3e-3)
    shift = twin.sweet_spots.max_exit_speed - torpedo.sweet_spots.max_exit_speed
    assert 0.4 * INCH < shift < 0.8 * INCH
    zones = [sweet_zone(analysis.scan, sting=math.inf) for analysis in (torpedo, twin)]
    assert zones[0] is not None and zones[1] is not None
    widths = [zone[1] - zone[0] for zone in zones if zone is not None]
    assert 0 < widths[0] - widths[1] < 0.4 * INCH
    barrel = twin.scan.position > 0.7 * twin.bat.length
    assert torpedo.scan.bbcor[barrel].max() - twin.scan.bbcor[barrel].max() < 0.01
    assert torpedo.bat.diameter_at(torpedo.bat.length - 8 * INCH) == pytest.approx(2.61 * INCH)

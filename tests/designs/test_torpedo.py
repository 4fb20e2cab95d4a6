"""A torpedo like the published ones, and the extreme that was designed, beside the ordinary bat of equal swing."""

from __future__ import annotations

import math

import pytest

from sweetspot import analyse, catalog
from sweetspot.analysis.sweet_spot import sweet_zone
from sweetspot.catalog.standard_hit import standard_conditions
from sweetspot.dynamics.beam import beam_model
from sweetspot.dynamics.rigid import rigid_body
from sweetspot.numerics.constants import STANDARD_AXIS
from sweetspot.units import INCH


def test_a_torpedo_is_heavier_and_of_lighter_wood_than_its_twin() -> None:
    """Published [torpedobatfan]: 32.1 oz for 31.5 oz, wood 3.3 % lighter, the same moment of inertia."""
    torpedo, twin = (beam_model(catalog.bat(name)) for name in ("torpedo", "torpedo-twin"))
    assert rigid_body(torpedo).mass / rigid_body(twin).mass == pytest.approx(32.1 / 31.5, rel=1e-3)
    assert twin.density_factor / torpedo.density_factor == pytest.approx(1.033, abs=0.003)
    assert max(diameter for _, diameter in catalog.bat("torpedo").profile or ()) < 2.61 * INCH


@pytest.mark.parametrize(("name", "most"), [("torpedo", 0.005), ("torpedo-designed", 0.01)])
def test_the_same_swing_another_place(name: str, most: float) -> None:
    """The place moves by 0.4 to 0.8 in towards the hands, the fast zone is up to 0.4 in wider, BBCOR nearly the same.

    Published widths are of speed alone, so sting does not bound the zone here.
    """
    torpedo, twin = (analyse(bat, standard_conditions(bat)) for bat in (catalog.bat(name), catalog.bat("torpedo-twin")))
    assert torpedo.body.moi(STANDARD_AXIS) == pytest.approx(twin.body.moi(STANDARD_AXIS), rel=3e-3)
    shift = twin.sweet_spots.max_exit_speed - torpedo.sweet_spots.max_exit_speed
    assert 0.4 * INCH < shift < 0.8 * INCH
    zones = [sweet_zone(analysis.scan, sting=math.inf) for analysis in (torpedo, twin)]
    assert zones[0] is not None and zones[1] is not None
    widths = [zone[1] - zone[0] for zone in zones if zone is not None]
    assert 0 < widths[0] - widths[1] < 0.4 * INCH
    barrel = twin.scan.position > 0.7 * twin.bat.length
    assert torpedo.scan.bbcor[barrel].max() - twin.scan.bbcor[barrel].max() < most

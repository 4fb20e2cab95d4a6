"""A bench for the tests of designs: one bat, one batter, few places to look."""

from __future__ import annotations

from dataclasses import replace

import pytest

from sweetspot import catalog
from sweetspot.catalog.rules import league
from sweetspot.catalog.standard_hit import standard_conditions
from sweetspot.catalog.swing_laws import swing_law
from sweetspot.designs import local_search
from sweetspot.designs.batter import Batter, normal_contact
from sweetspot.designs.constraints import Limit, band, lathe_limits, league_limits
from sweetspot.designs.gain import present_measured
from sweetspot.designs.local_search import search_starts
from sweetspot.designs.measures import Bench, bench_of
from sweetspot.designs.pareto import DesignSearch
from sweetspot.designs.turned import turned_space
from sweetspot.numerics.arrays import Array
from sweetspot.units import INCH


@pytest.fixture(scope="session")
def bench() -> Bench:
    bat = catalog.bat("mlb-a")
    conditions = standard_conditions(bat)
    batter = Batter(
        normal_contact(6.5 * INCH, 1.5 * INCH), 0.2 * INCH, 1.1 * INCH, conditions.swing.bat_speed,
        conditions.pitch.speed, swing_law(), 0.5 * INCH,
    )  # fmt: skip
    return bench_of(turned_space(bat), batter, conditions)


@pytest.fixture(scope="session")
def limits(bench: Bench) -> tuple[Limit, ...]:
    now = present_measured(bench).values
    return (
        band("mass", float(now["mass"][0]), part=0.01),
        band("moi", float(now["moi"][0]), part=0.01),
        *league_limits(league("mlb"), catalog.bat("mlb-a")),
        *lathe_limits(),
        Limit("handle", 0.999 * float(now["handle"][0]), None, "breaking"),
    )


@pytest.fixture(scope="session")
def inside_starts(bench: Bench, limits: tuple[Limit, ...]) -> Array:
    """Bats that a search begins with for who meets the ball 8 in from the tip: one that may be, and the fastest."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(local_search, "LOOKS", 60)
        return search_starts(met_at(bench, 8.0), DesignSearch(("exit_speed",), limits))


def met_at(bench: Bench, inches: float) -> Bench:
    """Return the bench for a batter who meets the ball elsewhere."""
    return replace(bench, batter=replace(bench.batter, weight=normal_contact(inches * INCH, 1.2 * INCH)))

"""Over, off or before the fence: exact cases, and properties of every park."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.typing import NDArray

from sweetspot import catalog
from sweetspot.errors import InputError
from sweetspot.flight.fence import OUTCOMES, landing, landings, out_in
from sweetspot.flight.park import Park

Array = NDArray[np.float64]
POLE = math.pi / 4
ROUND = Park(name="round", fence=tuple((math.radians(a), 100.0, 3.0) for a in range(-45, 46)))


def parabola(spray: float, carry: float, apex: float, points: int = 600) -> Array:
    """Return a path in vacuum that comes down after ``carry`` m."""
    way = np.linspace(0.0, 1.0, points)
    r, z = carry * way, 4 * apex * way * (1 - way)
    return np.stack([r * math.sin(spray), r * math.cos(spray), z], axis=-1)


@given(st.floats(-0.78, 0.78), st.floats(101.0, 150.0), st.floats(5.0, 60.0))
def test_clearance_is_the_parabolas_height_at_the_fence(spray: float, carry: float, apex: float) -> None:
    """Exact: z = 4 H (d / R)(1 - d / R) at the distance d of the fence; chords of 600 points cut off < 2e-4 m."""
    wall = ROUND.distance_at(spray)
    found = landing(parabola(spray, carry, apex), ROUND)
    assert found.clearance == pytest.approx(4 * apex * wall / carry * (1 - wall / carry) - 3.0, abs=1e-3)
    assert found.distance == pytest.approx(wall, abs=1e-9)
    assert found.direction == pytest.approx(spray, abs=1e-9)
    assert found.clearance is not None
    assert found.outcome == ("home run" if found.clearance > 0 else "off the wall")


@pytest.mark.parametrize(
    ("spray", "carry", "apex", "outcome"),
    [
        (0.0, 120.0, 30.0, "home run"),
        (0.0, 101.0, 10.0, "off the wall"),
        (0.3, 90.0, 30.0, "in play"),
        (-0.9, 120.0, 30.0, "foul"),
        (0.9, 60.0, 30.0, "foul"),
        (POLE + 0.002, 60.0, 30.0, "foul"),  # the line is at 45 degrees: a tenth of one decides
        (-POLE - 0.002, 60.0, 30.0, "foul"),
        (POLE - 0.002, 60.0, 30.0, "in play"),
    ],
)
def test_words(spray: float, carry: float, apex: float, outcome: str) -> None:
    found = landing(parabola(spray, carry, apex), ROUND)
    assert found.outcome == outcome
    assert (found.clearance is not None) == (outcome in ("home run", "off the wall"))


def test_the_wrong_side_of_the_pole_is_foul_even_if_it_bends_back() -> None:
    """A ball that passes the pole's distance outside it and lands inside the line behind the fence."""
    angles = np.linspace(-50, -44, 400)
    r = np.linspace(60.0, 130.0, 400)
    bending = np.stack([r * np.sin(np.radians(angles)), r * np.cos(np.radians(angles)), np.full(400, 20.0)], axis=-1)
    assert landing(bending, ROUND).outcome == "foul"
    assert landing(bending[:, [0, 1, 2]] * [-1, 1, 1], ROUND).outcome == "foul"


def test_many_flights_are_the_single_flights_one_by_one() -> None:
    generator = np.random.default_rng(7)
    paths = np.stack([parabola(s, c, h) for s, c, h in generator.uniform([-0.9, 70, 5], [0.9, 150, 50], (40, 3))])
    ragged = paths.copy()
    ragged[3, 400:] = np.nan
    for park in (ROUND, catalog.park("fenway"), catalog.park("oracle-park")):
        found = landings(ragged.reshape(8, 5, 600, 3), park)
        assert found.outcome.shape == found.clearance.shape == (8, 5)
        for k, path in enumerate(ragged):
            alone = landing(path[~np.isnan(path[:, 0])], park)
            assert found.outcome.flat[k] == alone.outcome
            assert found.direction.flat[k] == alone.direction and found.height.flat[k] == alone.height
            assert alone.clearance is None or found.clearance.flat[k] == alone.clearance
    assert set(found.outcome.flat) <= set(OUTCOMES)
    assert found.out.sum() == (found.outcome == "home run").sum() > 0


def test_out_in_how_many_parks() -> None:
    """Straightaway to the shortest line and over every centre field; the count agrees with the list."""
    parks = catalog.parks()
    short = parabola(math.radians(44.9), 104.0, 22.0)
    cleared = {park.team for park in parks if landing(short, park).outcome == "home run"}
    assert "Boston Red Sox" in cleared and "Colorado Rockies" not in cleared
    moon = parabola(0.0, 150.0, 40.0)
    paths = np.stack([short, moon, parabola(0.0, 100.0, 30.0)])
    assert list(out_in(paths, parks)) == [len(cleared), 30, 0]


def test_more_carry_never_clears_fewer_parks() -> None:
    carries = np.linspace(90.0, 140.0, 26)
    paths = np.stack([parabola(-0.4, carry, 0.3 * carry) for carry in carries])
    counts = out_in(paths, catalog.parks())
    assert (np.diff(counts) >= 0).all() and counts[0] == 0 and counts[-1] == 30


@pytest.mark.parametrize("shape", [(3,), (1, 3), (5, 2)])
def test_what_is_no_path_is_refused(shape: tuple[int, ...]) -> None:
    with pytest.raises(InputError, match="path has the shape"):
        landings(np.zeros(shape), ROUND)
    with pytest.raises(InputError, match="one flight"):
        landing(np.zeros((4, 5, 3)), ROUND)

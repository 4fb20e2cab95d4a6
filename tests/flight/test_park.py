"""Parks: straight walls between vertices, and what cannot be a fence."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from sweetspot import catalog
from sweetspot.errors import InputError
from sweetspot.flight.park import FOUL_LINE, Park, fence_at, nearest_fence

POLE = math.radians(45)


def test_the_wall_between_two_vertices_is_straight() -> None:
    """Exact: the chord between (d, -45 deg) and (d, 45 deg) is d cos(45 deg) / cos(t) away; its height goes evenly."""
    park = Park(name="chord", fence=((-POLE, 100.0, 2.0), (POLE, 100.0, 4.0)))
    for angle in (-40, -10, 0, 25, 45):
        turned = math.radians(angle)
        assert park.distance_at(turned) == pytest.approx(100 * math.cos(POLE) / math.cos(turned), rel=1e-12)
        assert park.height_at(turned) == pytest.approx(3 + angle / 45, rel=1e-12)


@given(st.sampled_from(catalog.park_names()), st.floats(-POLE, POLE))
def test_every_point_of_a_fence_lies_on_the_line_between_its_vertices(name: str, direction: float) -> None:
    park = catalog.park(name)
    at = [vertex[0] for vertex in park.fence]
    left = min(max(int(np.searchsorted(at, direction, side="right")) - 1, 0), len(at) - 2)
    ends = [np.array([d * math.sin(t), d * math.cos(t)]) for t, d, _ in park.fence[left : left + 2]]
    distance = park.distance_at(direction)
    place = distance * np.array([math.sin(direction), math.cos(direction)]) - ends[0]
    along = ends[1] - ends[0]
    assert abs(place[0] * along[1] - place[1] * along[0]) / np.linalg.norm(along) < 1e-9


@given(st.floats(30, 240), st.floats(30, 240), st.floats(-0.7, 0.7), st.floats(30, 240))
def test_no_point_of_a_fence_is_nearer_than_its_nearest(left: float, middle: float, turn: float, right: float) -> None:
    park = Park(name="odd", fence=((-POLE, left, 3.0), (turn, middle, 3.0), (POLE, right, 3.0)))
    distance, _ = fence_at(park, np.linspace(-POLE, POLE, 400))
    assert nearest_fence(park) <= distance.min() * (1 + 1e-12)


def test_many_directions_at_once_and_beyond_the_poles() -> None:
    park = catalog.park("fenway-park")
    distance, height = fence_at(park, np.radians([[-60.0, -45.0], [45.0, 60.0]]))
    assert distance.shape == height.shape == (2, 2)
    assert distance[0, 0] == distance[0, 1] == park.distance_at(-POLE)
    assert height[1, 1] == height[1, 0] == park.height_at(POLE)


def test_foul_territory_is_refused() -> None:
    with pytest.raises(InputError, match="50 deg from centre field, foul territory"):
        catalog.park("coors-field").distance_at(math.radians(50))
    with pytest.raises(InputError, match="foul territory"):
        catalog.park("coors-field").height_at(math.nan)


@pytest.mark.parametrize(
    ("fence", "message"),
    [
        (((-POLE, 100.0, 3.0),), "two vertices"),
        (((POLE, 100.0, 3.0), (-POLE, 100.0, 3.0)), "rising"),
        (((-0.5, 100.0, 3.0), (POLE, 100.0, 3.0)), "from foul line to foul line"),
        (((-POLE, 10.0, 3.0), (POLE, 100.0, 3.0)), "10 m away"),
        (((-POLE, 100.0, -1.0), (POLE, 100.0, 3.0)), "no negative height"),
    ],
)
def test_what_is_no_fence_is_refused(fence: tuple[tuple[float, float, float], ...], message: str) -> None:
    with pytest.raises(InputError, match=message):
        Park(name="wrong", fence=fence)


def test_the_foul_line_is_where_the_rules_have_it() -> None:
    assert pytest.approx(math.radians(45)) == FOUL_LINE

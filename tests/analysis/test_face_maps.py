"""Maps of hits over a face."""

from __future__ import annotations

import numpy as np
import pytest

from sweetspot import catalog
from sweetspot.analysis.bat_analysis import hit_at
from sweetspot.analysis.face_maps import FaceMap, face_map
from sweetspot.catalog.standard_hit import standard_conditions
from sweetspot.dynamics.reduction import reduced_bat
from sweetspot.errors import InputError


@pytest.fixture(scope="module")
def racket_map() -> FaceMap:
    racket = catalog.implement("tennis-racket")
    conditions = standard_conditions(racket)
    return face_map(reduced_bat(racket, ball=conditions.ball), conditions)


def test_it_is_a_grid_of_the_face(racket_map: FaceMap) -> None:
    assert racket_map.exit_speed.shape == (30, 40)
    inside = np.isfinite(racket_map.exit_speed)
    assert inside.mean() == pytest.approx(np.pi / 4, abs=0.02)  # exact in the limit: an oval in its box
    assert np.array_equal(inside, np.isfinite(racket_map.sting))


def test_it_is_the_same_on_both_sides(racket_map: FaceMap) -> None:
    for values in (racket_map.collision_efficiency, racket_map.exit_speed, racket_map.sting):
        assert np.nan_to_num(values) == pytest.approx(np.nan_to_num(values[::-1]), abs=1e-9)


def test_a_place_on_it_is_the_hit_there(racket_map: FaceMap) -> None:
    """Other code: the readable hit."""
    racket = catalog.implement("tennis-racket")
    conditions = standard_conditions(racket)
    modes = reduced_bat(racket, ball=conditions.ball).modes
    row, column = 22, 25
    one = hit_at(
        float(racket_map.position[column]), modes=modes, conditions=conditions, lateral=float(racket_map.lateral[row])
    )
    assert racket_map.collision_efficiency[row, column] == pytest.approx(one.collision_efficiency, abs=1e-4)


def test_hits_beside_the_line_lose_speed(racket_map: FaceMap) -> None:
    middle, edge = racket_map.exit_speed[15], racket_map.exit_speed[4]
    both = np.isfinite(middle) & np.isfinite(edge)
    assert np.all(edge[both] < middle[both])
    position, lateral = racket_map.best()
    assert racket_map.outline.holds(position, lateral) and abs(lateral) < 0.005


def test_what_has_no_face_has_no_map() -> None:
    bat = catalog.bat()
    conditions = standard_conditions(bat)
    with pytest.raises(InputError, match="is round and has no face"):
        face_map(reduced_bat(bat, ball=conditions.ball), conditions)
    club = catalog.implement("golf-driver")
    stroke = standard_conditions(club)
    with pytest.raises(InputError, match="allowed is 2 by 2 or more"):
        face_map(reduced_bat(club, ball=stroke.ball), stroke, columns=1)

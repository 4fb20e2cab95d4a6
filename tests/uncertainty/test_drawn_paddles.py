"""Drawn paddles are hit as paddles that are worked out one by one."""

from __future__ import annotations

import numpy as np
import pytest

from sweetspot import catalog
from sweetspot.calibration.unknowns import as_described, deviated
from sweetspot.catalog.standard_hit import standard_conditions
from sweetspot.collision.kernel import hits, struck
from sweetspot.dynamics.beam import beam_model
from sweetspot.dynamics.paddle_modes import plate_modes
from sweetspot.dynamics.rigid import rigid_body
from sweetspot.uncertainty.drawn_hits import draws_of, hits_along
from sweetspot.uncertainty.drawn_paddles import DrawnPaddles
from sweetspot.uncertainty.sources import sources_of
from tests.paddles import paddle

PLACES = np.array([0.27, 0.29, 0.31, 0.33, 0.36])
SPEED = 20.0


def test_each_draw_is_hit_as_its_own_paddle() -> None:
    # exact: the same paddle, its plate solved anew; within 5e-4 of q with one thing off by one sigma, 2e-3 with all
    given, ball = paddle(), catalog.ball("pickleball")
    sources = sources_of(given, standard_conditions(given))
    normal = np.array([[0, 0, 0, 0], [1, 0, 0, 0], [0, -1, 0, 1], [1, 1, -1, -1], [-0.5, 0.3, 1, 1]], float)
    draws = draws_of(
        beam_model(given),
        standard_conditions(given),
        sources,
        count=4,
        normal=np.pad(normal[1:], ((0, 0), (0, len(sources.names) - 4))),
    )
    drawn = draws.bats
    assert isinstance(drawn, DrawnPaddles)
    places = np.tile(PLACES, (5, 1))
    q = struck(drawn, ball=ball, position=places, closing_speed=np.full(places.shape, SPEED)).collision_efficiency
    described = as_described(given)
    for number, row in enumerate(normal):
        own = deviated(described, sources.doubt.unknowns, row @ sources.doubt.factor.T)
        exact = hits(plate_modes(own), ball=ball, position=PLACES, closing_speed=SPEED).collision_efficiency
        assert q[number] == pytest.approx(exact, abs=2e-3)
        assert drawn.bending.moi(0.05)[number] == pytest.approx(rigid_body(own).moi(0.05), rel=5e-3)
    assert hits_along(draws, PLACES).exit_speed.shape == (5, 5)


def test_the_core_is_among_what_is_not_known() -> None:
    given = paddle()
    unknowns = [unknown.name for unknown in sources_of(given, standard_conditions(given)).doubt.unknowns]
    assert unknowns == ["mass", "swing_weight", "rim", "core_shear"]

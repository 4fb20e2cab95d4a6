"""How q answers to what is not known: against direct recomputation, limits, and what measuring buys."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest

from sweetspot import catalog
from sweetspot.analysis.position_scan import scan
from sweetspot.calibration.measured import Measured
from sweetspot.calibration.measurements import Measurement, predicted
from sweetspot.calibration.mode_naming import ModeName
from sweetspot.calibration.posterior import calibrate
from sweetspot.calibration.unknowns import described, deviated, unknowns_of
from sweetspot.catalog.balls import MEAN_BALL, ball_doubts
from sweetspot.catalog.standard_hit import standard_conditions
from sweetspot.dynamics.beam import BeamModel, beam_model
from sweetspot.dynamics.reduction import ReducedBat
from sweetspot.dynamics.rigid import rigid_body
from sweetspot.equipment.ball import Ball
from sweetspot.equipment.bat import Bat
from sweetspot.uncertainty.implement_doubt import expected_deviations
from sweetspot.uncertainty.ranking_draws import EfficiencyResponse, response_of_efficiency

PLACES = np.linspace(0.57, 0.80, 24)
PLACE = 0.69
AT = int(np.argmin(np.abs(PLACES - PLACE)))


@pytest.fixture(scope="module")
def beam(r161: Bat) -> BeamModel:
    return beam_model(r161)


@pytest.fixture(scope="module")
def response(r161: Bat, beam: BeamModel) -> EfficiencyResponse:
    unknowns, _ = expected_deviations(r161)
    return response_of_efficiency(beam, standard_conditions(r161), unknowns=unknowns, positions=PLACES)


def test_restitution_against_the_closed_form(response: EfficiencyResponse, beam: BeamModel, baseball: Ball) -> None:
    """Where the bat hardly vibrates q = (e - r) / (1 + r): de is worth 1 / (1 + r) [nathan2003]."""
    body, place = rigid_body(beam), PLACES[AT]
    ratio = baseball.mass * (1 / body.mass + (place - body.balance_point) ** 2 / body.moi_cm)
    doubts = ball_doubts(baseball)
    (index,) = [index for index, doubt in enumerate(doubts) if doubt.part == MEAN_BALL]
    size = dict(doubts[index].deviation)["restitution"]
    slope = response.slopes[len(response.spreads) - len(doubts) + index, AT]
    assert slope == pytest.approx(size / (1 + ratio), rel=0.12)


def test_the_sum_against_recomputed_bats(response: EfficiencyResponse, beam: BeamModel, r161: Bat) -> None:
    """Slopes and bends against the whole way for eight bats: within a tenth of the doubt itself."""
    unknowns, covariance = expected_deviations(r161)
    conditions = standard_conditions(r161)
    doubt = np.sqrt(response.spreads**2 @ response.slopes[:, AT] ** 2)
    for off in np.random.default_rng(5).multivariate_normal(np.zeros(len(unknowns)), covariance, size=8):
        other = deviated(beam, unknowns, off)
        direct = scan(ReducedBat.of_beam(other, conditions.ball), conditions, PLACES).collision_efficiency
        every = np.concatenate([off, np.zeros(len(response.spreads) - len(off))])
        assert np.max(np.abs(response.at(every[None])[0] - direct)) < 0.1 * doubt


def test_measuring_a_bat_narrows_its_answer(r161: Bat) -> None:
    """From the drawing alone to scale, balance, pendulum and tap: the bat's part of the doubt of q falls."""
    beam, unknowns = described(r161), unknowns_of(r161)
    wanted = [
        Measurement("mass", Measured(1, 0.0015)),
        Measurement("balance_point", Measured(1, 0.0013)),
        Measurement("period", Measured(1, 0.003)),
        Measurement("frequency", Measured(1, 0.3), mode=ModeName("bending", 1)),
    ]
    exact = [
        Measurement(one.kind, Measured(value, one.value.error), mode=one.mode)
        for one, value in zip(wanted, predicted(beam, wanted).tolist(), strict=True)
    ]
    conditions = standard_conditions(r161)
    response = response_of_efficiency(beam, conditions, unknowns=unknowns, positions=np.array([PLACE]))
    slope = response.slopes[: len(unknowns), 0]
    errors = []
    for count in range(5):
        spreads = np.diag([one.spread**2 for one in unknowns])
        covariance = calibrate(beam, unknowns, exact[:count]).covariance if count else spreads
        errors.append(np.sqrt(slope @ covariance @ slope))
    assert all(after < before for before, after in pairwise(errors))
    assert errors[-1] < 0.25 * errors[0]


def test_a_hollow_bat_doubts_its_wall() -> None:
    bat = catalog.bat("single-wall")
    unknowns, covariance = expected_deviations(bat)
    response = response_of_efficiency(
        beam_model(bat), standard_conditions(bat), unknowns=unknowns, positions=np.array([bat.length - 0.15])
    )
    own = np.abs(response.slopes[: len(unknowns), 0]) * np.sqrt(np.diag(covariance))
    assert unknowns[int(np.argmax(own))].name == "wall"

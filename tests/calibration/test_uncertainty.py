"""How sure an answer is: against direct recomputation, limits, and what measuring buys."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest

from sweetspot import catalog
from sweetspot.analysis.bat_analysis import Analysis, exit_speed_of
from sweetspot.analysis.position_scan import scan
from sweetspot.calibration.ball_doubt import speed_by_ball
from sweetspot.calibration.measured import Measured
from sweetspot.calibration.measurements import Measurement, predicted
from sweetspot.calibration.naming import ModeName
from sweetspot.calibration.posterior import calibrate
from sweetspot.calibration.uncertainty import (
    OUTPUTS,
    REACHED,
    Doubt,
    difference,
    doubt,
    expected_deviations,
)  # fmt: skip
from sweetspot.calibration.unknowns import described, deviated, unknowns_of
from sweetspot.catalog.balls import ball_spreads
from sweetspot.catalog.standard_hit import standard_conditions
from sweetspot.dynamics.beam import BeamModel, beam_model
from sweetspot.dynamics.mode_assembly import all_modes
from sweetspot.dynamics.rigid import rigid_body
from sweetspot.equipment.ball import Ball
from sweetspot.equipment.bat import Bat


@pytest.fixture(scope="module")
def line(r161: Bat) -> BeamModel:
    return beam_model(r161)


@pytest.fixture(scope="module")
def sure(r161: Bat, line: BeamModel) -> Doubt:
    return doubt(line, standard_conditions(r161))


def test_shares_add_up_and_the_ball_leads(sure: Doubt) -> None:
    for output in OUTPUTS:
        assert sum(sure.shares(output, 0.69).values()) == pytest.approx(1.0)
    assert next(iter(sure.shares("exit_speed", 0.69))) == "ball restitution"


def test_restitution_against_the_closed_form(sure: Doubt, r161: Bat, line: BeamModel, baseball: Ball) -> None:
    """Where the bat hardly vibrates q = (e - r) / (1 + r): de is worth closing speed / (1 + r) [nathan2003]."""
    conditions = standard_conditions(r161)
    body = rigid_body(line)
    place = 0.69
    ratio = baseball.mass * (1 / body.mass + (place - body.balance_point) ** 2 / body.moi_cm)
    closing = conditions.pitch.speed + conditions.swing.speed_at(place)
    slope = sure.slope_at("exit_speed", place)[sure.sources.index("ball restitution")]
    assert slope == pytest.approx(closing / (1 + ratio), rel=0.12)


def test_draws_against_recomputed_bats(sure: Doubt, line: BeamModel, r161: Bat) -> None:
    """Slopes and bends against the whole way for eight bats: within a tenth of the doubt itself."""
    unknowns, covariance = expected_deviations(r161)
    conditions = standard_conditions(r161)
    generator = np.random.default_rng(5)
    middle = slice(5, 36)
    for off in generator.multivariate_normal(np.zeros(len(unknowns)), covariance, size=8):
        other = deviated(line, unknowns, off)
        direct = scan(
            other.bat, body=rigid_body(other), modes=all_modes(other, conditions.ball), conditions=conditions,
            positions=sure.position,
        ).exit_speed  # fmt: skip
        every = np.concatenate([off, np.zeros(len(sure.sources) - len(off))])
        said = sure.values["exit_speed"] + every @ sure.slopes["exit_speed"] + every**2 @ sure.bends["exit_speed"]
        assert np.max(np.abs(said - direct)[middle]) < 0.1 * sure.at("exit_speed", 0.69).error


def test_draws_scatter_as_the_slopes_say(sure: Doubt) -> None:
    index = int(np.argmin(np.abs(sure.position - 0.69)))
    draws = sure.draws("exit_speed")[:, index]
    assert draws.shape == (1024,)
    linear = sure.at("exit_speed", float(sure.position[index]))
    assert np.std(draws) == pytest.approx(linear.error, rel=0.03)
    assert np.mean(draws) == pytest.approx(linear.value, abs=0.1 * linear.error)


def test_the_best_place(sure: Doubt, r161: Bat) -> None:
    place = sure.best_place()
    assert place.value == pytest.approx(r161.length - 5.8 * 0.0254, abs=0.01)
    assert 0.0005 < place.error < 0.02


def test_two_bats_share_their_ball(sure: Doubt) -> None:
    """A bat against its twin: the ball cancels, two bats' own doubt is left."""
    apart = difference(sure, sure, (0.69, 0.69))
    whole = sure.at("exit_speed", 0.69)
    bat = whole.error * np.sqrt(sure.shares("exit_speed", 0.69)["bat"])
    assert apart.value == 0
    assert apart.error == pytest.approx(np.sqrt(2) * bat, rel=1e-6)


def test_measuring_a_bat_narrows_its_answer(r161: Bat) -> None:
    """From the drawing alone to scale, balance, pendulum and tap: the bat's part of the exit speed's doubt falls."""
    line, unknowns = described(r161), unknowns_of(r161)
    conditions = standard_conditions(r161)
    wanted = [
        Measurement("mass", Measured(1, 0.0015)), Measurement("balance_point", Measured(1, 0.0013)),
        Measurement("period", Measured(1, 0.003)),
        Measurement("frequency", Measured(1, 0.3), mode=ModeName("bending", 1)),
    ]  # fmt: skip
    exact = [
        Measurement(one.kind, Measured(value, one.value.error), mode=one.mode)
        for one, value in zip(wanted, predicted(line, wanted).tolist(), strict=True)
    ]
    errors = []
    places = np.array([0.69])
    for count in range(5):
        spreads = np.diag([one.spread**2 for one in unknowns])
        known = calibrate(line, unknowns, exact[:count]).covariance if count else spreads
        sure = doubt(line, conditions, known=(unknowns, known), positions=places)
        errors.append(sure.at("exit_speed", 0.69).error * np.sqrt(sure.shares("exit_speed", 0.69)["bat"]))
    assert all(after < before for before, after in pairwise(errors))
    assert errors[-1] < 0.25 * errors[0]


def test_a_hollow_bat_doubts_its_wall() -> None:
    bat = catalog.bat("single-wall")
    place = bat.length - 0.15
    one = doubt(beam_model(bat), standard_conditions(bat), positions=np.array([place]))
    slopes = np.abs(one.slope_at("exit_speed", place)) * np.sqrt(np.diag(one.covariance))
    assert one.sources[int(np.argmax(np.where(one.of_ball, 0, slopes)))] == "wall"


def test_a_racket_has_its_balls_doubt_only() -> None:
    racket = catalog.implement("tennis-racket")
    one = doubt(beam_model(racket), standard_conditions(racket))
    assert all(one.of_ball)
    assert racket.outline is not None
    assert one.position[0] == racket.outline.start


def test_places_and_spreads(sure: Doubt, r161: Bat, baseball: Ball) -> None:
    assert sure.position[0] == pytest.approx(r161.length - REACHED)
    spreads = ball_spreads(baseball)
    assert spreads["mass"] == pytest.approx(0.125 / 5.125)
    assert spreads["stiffness"] == pytest.approx(2.5 * 5 / 37)
    assert ball_spreads(baseball.replaced(name="my own")) == {}


def test_the_balls_own_part_is_that_of_the_whole_doubt(analysis: Analysis[Bat]) -> None:
    """The quick answer of every report beside the one that moves bat and ball."""
    place = analysis.sweet_spots.max_exit_speed
    whole = doubt(analysis.line, analysis.conditions, positions=np.array([place]))
    slope = np.where(whole.of_ball, whole.slope_at("exit_speed", place), 0.0)
    quick = speed_by_ball(analysis)
    assert quick is not None
    assert quick.error == pytest.approx(float(np.sqrt(slope @ whole.covariance @ slope)), rel=0.01)
    assert quick.value == exit_speed_of(analysis.best, analysis.conditions)

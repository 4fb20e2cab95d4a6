"""Shots as measurements of a bat: grouped by place, with the ball's liveliness as an unknown of its own."""

from __future__ import annotations

import numpy as np
import pytest

from sweetspot import catalog
from sweetspot.analysis.certification.shots import COR_SPEED, Shot
from sweetspot.calibration.measured import Measured
from sweetspot.calibration.measurements import (
    MEASURED_BALLS,
    Measurement,
    Shooting,
    of_shots,
    predicted,
    shot_ball_unknown,
)
from sweetspot.calibration.posterior import calibrate
from sweetspot.calibration.unknowns import OF_BALL, described, deviated, unknowns_of
from sweetspot.catalog.balls import slope_doubt
from sweetspot.units import INCH, MPH

BALL = catalog.ball("baseball")
SPEED = 136 * MPH


def shot(place: float, efficiency: float, cor: float | None = None) -> Shot:
    """Return a shot of a ball that the bat meets at half the closing speed."""
    out = efficiency * SPEED + SPEED / 2
    return Shot(2, SPEED / 2, out, SPEED / 2, place, cor, None, None)


def test_places_are_grouped_and_averaged() -> None:
    shots = [shot(0.70, 0.20), shot(0.75, 0.22), shot(0.702, 0.21), shot(0.70, 0.22), shot(0.70, 0.19)]
    first, second = of_shots(shots, BALL)
    assert first.shooting is not None
    assert first.shooting.position == pytest.approx(0.7005)
    assert first.shooting.closing_speed == pytest.approx(SPEED)
    assert first.value.value == pytest.approx(0.205)
    scatter = np.std([0.20, 0.21, 0.22, 0.19], ddof=1)
    assert first.value.error == pytest.approx(scatter / 2)
    assert second.value == Measured(pytest.approx(0.22), 0.01)  # type: ignore[arg-type]
    assert first.name != second.name


def test_measured_balls_leave_less_doubt() -> None:
    """Their restitution is that of the test at 60 mph, by which `certify` reads the same column."""
    lively = BALL.restitution.at(COR_SPEED) + 0.02
    (one,) = of_shots([shot(0.7, 0.2, lively)], BALL)
    assert one.shooting is not None
    law = one.shooting.ball.restitution
    assert law.at(COR_SPEED) == pytest.approx(lively)
    assert law.at(SPEED) == pytest.approx(BALL.restitution.at(SPEED) + 0.02)
    slope = slope_doubt(BALL)[0] * (SPEED - COR_SPEED) / law.reference
    known, unknown = (shot_ball_unknown([shot(0.7, 0.2, cor)], BALL).spread for cor in (lively, None))
    assert known == pytest.approx(np.hypot(MEASURED_BALLS, slope), rel=0.05)
    assert unknown > 1.3 * known


def test_a_table_of_shots_means_the_same_to_certify_and_calibrate() -> None:
    """Ordinary balls, measured at 60 mph, at an ordinary bat contradict nothing."""
    bat = catalog.bat("mlb-c")
    line, unknowns = described(bat), unknowns_of(bat)
    places = [bat.length - inch * INCH for inch in (4, 6, 8)]
    asked = [Measurement("efficiency", Measured(0, 1), shooting=Shooting(place, SPEED, BALL)) for place in places]
    cor = BALL.restitution.at(COR_SPEED)
    shots = [
        shot(place, float(q), cor) for place, q in zip(places, predicted(line, asked), strict=True) for _ in range(6)
    ]
    found = calibrate(line, (*unknowns, shot_ball_unknown(shots, BALL)), of_shots(shots, BALL))
    assert not found.contradictions
    assert found.deviation(OF_BALL).value == pytest.approx(0, abs=1e-3)


def test_shots_narrow_what_scale_and_balance_left() -> None:
    """A bat lighter towards its tip and a lively ball, injected: shots at five places tell them apart."""
    bat = catalog.bat("mlb-c")
    line, unknowns = described(bat), unknowns_of(bat)
    true = np.array([{"density_gradient": -0.08, "modulus": 0.1}.get(one.name, 0.0) for one in unknowns])
    truth = deviated(line, unknowns, true)
    mass = Measurement("mass", Measured(float(predicted(truth, [Measurement("mass", Measured(1, 1))])[0]), 0.001))
    places = [bat.length - inch * INCH for inch in (3, 5, 7, 9, 11)]
    asked = [Measurement("efficiency", Measured(0, 1), shooting=Shooting(place, SPEED, BALL)) for place in places]
    heard = predicted(truth, asked, livelier=0.03)
    shots = [shot(place, float(q), None) for place, q in zip(places, heard, strict=True) for _ in range(9)]
    with_ball = (*unknowns, shot_ball_unknown(shots, BALL))
    before = calibrate(line, unknowns, [mass])
    after = calibrate(line, with_ball, [mass, *of_shots(shots, BALL)])
    assert not after.contradictions
    for name in ("density_gradient", "modulus"):
        assert after.deviation(name).error < before.deviation(name).error
    assert after.deviation(OF_BALL).value == pytest.approx(0.03, abs=2 * after.deviation(OF_BALL).error)
    assert after.deviation(OF_BALL).error < 0.8 * with_ball[-1].spread
    np.testing.assert_allclose(after.predictions[1:], heard[::-1], atol=0.007)  # nearest the knob first

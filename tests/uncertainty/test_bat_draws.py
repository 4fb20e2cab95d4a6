"""Draws of hits against every hit worked out the whole way."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from sweetspot import catalog
from sweetspot.analysis.bat_analysis import hit_at
from sweetspot.analysis.position_scan import scan
from sweetspot.calibration.unknowns import Unknown, deviated, unknowns_of
from sweetspot.calibration.unknowns import described as described_beam
from sweetspot.catalog.balls import THIS_BALL
from sweetspot.catalog.standard_hit import standard_conditions
from sweetspot.dynamics.beam import beam_model
from sweetspot.dynamics.reduction import ReducedBat
from sweetspot.equipment.bat import Bat
from sweetspot.reports.quantities import ENERGY_NAMES
from sweetspot.uncertainty.drawn_hits import drawn_ledger, draws_of, hits_along
from sweetspot.uncertainty.sources import NOTHING, PATCH, sources_of
from sweetspot.units import MPH

CALIBRATED = {"mass": 0.005, "balance_point": 0.01, "gyration": 0.01, "first_frequency": 0.02}
"""One sigma of the logarithms, some times what scale, string and tap leave open."""


@pytest.mark.parametrize(
    ("name", "most", "weighed"),
    [
        ("r161-ash", 0.1 * MPH, False),
        ("college-alloy", 0.25 * MPH, False),
        ("tennis-racket", 0.1 * MPH, True),
        ("cricket-bat", 0.1 * MPH, True),
    ],
)
def test_draws_against_the_whole_way(name: str, most: float, weighed: bool) -> None:
    """Exit speed, BBCOR, jolt, sting and energies of draws; the interval of an exit speed is several mph wide."""
    bat = catalog.load_implement(name)
    conditions, beam = standard_conditions(bat), beam_model(bat)
    known = [Unknown(one.name, CALIBRATED[one.name]) for one in unknowns_of(bat)] if weighed else []
    left = (known, np.diag([one.spread**2 for one in known])) if weighed else None
    sources = sources_of(bat, conditions, calibration=left, bat_speed_error=0.5, pitch_speed_error=0.5)
    places = np.linspace(bat.length - 0.25, bat.length - 0.05, 5)
    assert {one for one in sources.names if one in {"bat", "racket"}} <= {
        "racket" if name == "tennis-racket" else "bat"
    }
    draws = draws_of(beam, conditions, sources, count=4)
    found = hits_along(draws, places)
    off = sources.deviations(draws.normal)
    off[0] = 0.0
    described: list[Any] = []
    for row in (0, 3):
        start = described_beam(bat) if weighed else beam
        other = deviated(start, sources.unknowns, off[row, : len(sources.unknowns)]) if sources.unknowns else beam
        ball = draws.balls[row]
        own = conditions.replaced(
            ball=ball,
            pitch=conditions.pitch.replaced(speed=float(draws.pitch_speed[row])),
            swing=conditions.swing.replaced(bat_speed=float(draws.bat_speed[row])),
        )
        factor = float(draws.patch[row])
        reduced = ReducedBat.of_beam(other, ball, patch_factor=factor if isinstance(bat, Bat) else 1.0)
        exact = scan(reduced, own, places)
        assert found.exit_speed[row] == pytest.approx(exact.exit_speed, abs=0.002 if row == 0 else most)
        followed = 1e-4 if weighed else 1e-6  # weight and balance by slope and bend, or each worked out
        assert found.rigid_exit_speed[row] == pytest.approx(exact.rigid_exit_speed, rel=followed)
        assert found.bbcor[row] == pytest.approx(exact.bbcor, abs=most / (30 * MPH))
        assert found.hand_impulse[row] == pytest.approx(exact.hand_impulse, abs=0.02)
        assert found.sting[row] == pytest.approx(exact.sting, rel=0.01, abs=0.02)
        described.append(hit_at(float(places[2]), modes=reduced.modes, conditions=own))
    ledger, _ = drawn_ledger(draws, found, 2, described[0])
    for name_of_part in ENERGY_NAMES:
        exact_part, share = (getattr(described[1].energy, name_of_part), 0.01 * described[1].energy.incoming)
        assert ledger[name_of_part][0] == pytest.approx(getattr(described[0].energy, name_of_part))
        assert ledger[name_of_part][3] == pytest.approx(exact_part, abs=share)


def test_one_row_of_everything_as_described_comes_first() -> None:
    bat = catalog.bat()
    conditions = standard_conditions(bat)
    draws = draws_of(beam_model(bat), conditions, sources_of(bat, conditions, bat_speed_error=1.0), count=4)
    assert draws.bat_speed[0] == conditions.swing.bat_speed
    assert draws.balls[0] == conditions.ball
    assert draws.patch[0] == 1.0


def test_deviations_have_the_distributions_that_are_named() -> None:
    bat = catalog.bat()
    sources = sources_of(bat, standard_conditions(bat), pitch_speed_error=0.4)
    off = sources.deviations(sources.normal(1024))
    count = len(sources.unknowns)
    assert np.cov(off[:, :count].T) == pytest.approx(
        sources.doubt.covariance, abs=0.02 * sources.doubt.covariance.max()
    )
    assert np.std(sources.of("pitch", off)) == pytest.approx(0.4, rel=0.02)
    patch = np.exp(sources.of(PATCH, off))
    assert (patch.min(), patch.max()) == pytest.approx((0.83, 1.25), abs=0.002)
    assert set(sources.described) == {*sources.names}


def test_sources_can_be_left_out_and_put_in() -> None:
    bat = catalog.bat()
    sources = sources_of(bat, standard_conditions(bat))
    assert THIS_BALL in sources.names
    assert THIS_BALL not in sources.without(THIS_BALL).names
    assert NOTHING.of("swing", np.zeros((3, 0))).tolist() == [0.0, 0.0, 0.0]


def test_a_racket_that_may_be_a_fifth_stiffer_is_followed() -> None:
    """As tuned: f goes as the exponential. A stiffer racket needs fewer modes, and must not be taken as described."""
    racket = catalog.load_implement("badminton-racket")
    conditions = standard_conditions(racket)
    sources = sources_of(racket, conditions)
    stiffer = [one.name for one in sources.unknowns].index("first_frequency")
    normal = np.zeros((5, len(sources.names)))
    normal[:, stiffer] = (-2.5, -1.0, 0.5, 1.0, 2.5)
    draws = draws_of(beam_model(racket), conditions, sources, count=5, normal=normal)
    first = draws.bats.angular_frequency[:, 2]
    off = sources.deviations(normal)[:, stiffer]
    assert np.max(np.abs(off)) > 0.4
    assert first[1:] / first[0] == pytest.approx(np.exp(off), rel=0.03)

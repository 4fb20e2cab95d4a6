"""The joint fit of drag, lift and spin finds the law by which balls were made up, and bars can be missed."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from studies.air_law import USED, Law, checked, fitted, in_use, made_up

TRUTH = replace(in_use(), college_per_spin=0.0, college_lift=0.0, wind_right=-1.0, turned=-150.0)


def test_the_fit_finds_what_was_put_in() -> None:
    """Recovery: from another start; the league's balls have no scatter, the college's spins scatter about the line."""
    balls = made_up(TRUTH, np.random.default_rng(7), 240)
    fit = fitted(balls, USED, Law())
    for name in ("roof", "open", "college", "per_spin", "lift", "wind_right"):
        assert getattr(fit.law, name) == pytest.approx(getattr(TRUTH, name), rel=0.02), name
    for name in ("back", "back_angle", "side", "side_spray"):
        assert abs(getattr(fit.law, name) - getattr(TRUTH, name)) < 3 * fit.error(name), name
        assert fit.error(name) < 0.15 * abs(getattr(TRUTH, name)), name


def test_a_law_with_less_drag_misses_its_bars(capsys: pytest.CaptureFixture[str]) -> None:
    balls = made_up(TRUTH, np.random.default_rng(7), 240)
    good, bad = (
        {bar.name for bar in checked(balls, law, "law") if bar.missed}
        for law in (TRUTH, replace(TRUTH, roof=0.28, open=0.295, college=0.34))
    )
    assert not any(name.startswith("league") for name in good)
    assert {"league, carry, ft", "college, distance at hang time, ft"} <= bad
    assert "direction solved" in capsys.readouterr().out

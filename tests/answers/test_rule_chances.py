"""How probably a bat keeps a limit by its own shots: Student's t against another program's."""

from __future__ import annotations

import numpy as np
import pytest
import scipy.stats

from sweetspot.analysis.certification.shot_statistics import Estimate
from sweetspot.answers.bat_test import within_limits


@pytest.mark.parametrize(("least", "most"), [(None, 0.5), (0.45, None), (0.47, 0.5)])
def test_the_mean_lies_within_limits_by_students_t(least: float | None, most: float | None) -> None:
    estimate = Estimate(mean=0.49, standard_error=0.01, low=0.47, high=0.51, count=6)
    law = scipy.stats.t(5, loc=0.49, scale=0.01)
    expected = (1.0 if most is None else law.cdf(most)) - (0.0 if least is None else law.cdf(least))
    assert within_limits(estimate, least, most) == pytest.approx(expected, rel=1e-9)


@pytest.mark.parametrize("error", [0.0005, 0.01])
def test_a_moment_in_doubt_makes_a_pass_less_sure(error: float) -> None:
    """Beside a million drawn sums of both; without it five shots of one place would be as sure as a measured bat's."""
    estimate = Estimate(mean=0.472, standard_error=error, low=0.47, high=0.474, count=6)
    rng = np.random.default_rng(1)
    drawn = 0.472 + error * rng.standard_t(5, 1_000_000) + 0.016 * rng.standard_normal(1_000_000)
    for most in (0.47, 0.48, 0.5):
        assert within_limits(estimate, None, most, by_moi=0.016) == pytest.approx(np.mean(drawn <= most), abs=0.002)

"""Home runs expected and hit of like balls, and how unlikely a number of them is."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import polars as pl
import pytest

from sweetspot.answers.ask_measured import season
from sweetspot.reports.season.words import league_words
from sweetspot.seasons.home_run_table import EDGES, UNSURE, home_run_tail, home_runs_by
from sweetspot.units import DEGREE


def _balls(random: np.random.Generator, count: int = 20_000) -> pl.LazyFrame:
    angle, chance = random.uniform(8, 58, count) * DEGREE, random.beta(0.3, 1.0, count)
    gone = random.random(count) < chance
    event = np.where(gone, "home_run", "field_out")
    return pl.LazyFrame({"launch_angle": angle, "home_run_here": chance, "event": event})


def test_true_chances_are_met_within_their_own_spread() -> None:
    balls = _balls(np.random.default_rng(1))
    for kind in ("launch_angle", "home_run_here"):
        groups = home_runs_by(balls, kind)
        assert len(groups) == len(EDGES[kind]) - 1
        misses = [(group.hit - group.expected) / max(group.chance_spread, 1e-9) for group in groups]
        assert 0.4 < float(np.std(misses)) < 1.7
        assert [group.low for group in groups] == EDGES[kind][:-1].tolist()
    assert not home_runs_by(balls, "pull")


def test_every_ball_inside_is_counted_once_and_balls_without_an_end_are_not() -> None:
    balls = _balls(np.random.default_rng(2), 4_000)
    inside = pl.col("launch_angle").is_between(EDGES["launch_angle"][0], EDGES["launch_angle"][-1])
    assert sum(group.balls for group in home_runs_by(balls, "launch_angle")) == len(balls.filter(inside).collect())
    unknown = balls.with_columns(event=pl.lit(None, pl.String))
    assert home_runs_by(unknown, "launch_angle") == ()


@pytest.mark.parametrize("expected", [3.0, 40.0])
def test_tail_is_that_of_a_poisson_number_about_an_unsure_mean(expected: float) -> None:
    random = np.random.default_rng(3)
    numbers = random.poisson(random.gamma(UNSURE**-2, expected * UNSURE**2, 400_000))
    for hit in (round(expected / 2), round(1.6 * expected)):
        seen = min(float(np.mean(numbers <= hit)), float(np.mean(numbers >= hit)))
        assert home_run_tail(hit, expected) == pytest.approx(seen, rel=0.05)


def test_a_table_without_the_home_runs_that_it_should_have_is_called_selected(tmp_path: Path) -> None:
    angles = [28.0 + 0.01 * ball for ball in range(60)]
    hits = pl.DataFrame({"launch_speed": 104.0, "launch_angle": angles, "bearing_deg": 0.0, "home_team": "CHC"})
    words = []
    for event in ("field_out", "home_run"):
        ends = pl.Series([event if ball % 2 else "field_out" for ball in range(60)])
        hits.with_columns(events=ends).write_csv(tmp_path / f"{event}.csv")
        answer = season(tmp_path / f"{event}.csv", contact=False)
        words.append([str(paragraph) for paragraph in league_words(answer) if "selected" in str(paragraph)])
    assert len(words[0]) == 1 and not words[1]

"""What the estimate for balls without exit speed takes back of the bias, on balls of 2022 that were all tracked."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import polars as pl
import pytest

from sweetspot.seasons.survey import survey_tables, tracking_bias
from sweetspot.units import MPH
from tests.real_data import real_file

TABLE = "savant_2022_contact_sample.csv.gz"
LOST = 0.12
"""Part of the balls that are taken away, at most."""


@pytest.mark.parametrize(
    ("why", "least", "most"), [("pop-ups and balls beaten down", 0.75, 1.0), ("slow balls", 0.18, 0.3)]
)
def test_the_estimate_takes_back_what_endings_tell(why: str, least: float, most: float, tmp_path: Path) -> None:
    """Most of it where balls are lost by their angle, which endings tell; a quarter where slow ones are."""
    balls = pl.read_csv(real_file(TABLE), infer_schema_length=None)
    balls = balls.filter(~pl.col("events").str.contains("bunt"))
    speed, angle = balls["launch_speed"].to_numpy(), balls["launch_angle"].to_numpy()
    weight = np.exp(-(speed - 70) / 12) if why == "slow balls" else np.where((angle > 50) | (angle < -25), 1.0, 0.05)
    taken_back = []
    for seed in range(5):
        chance = np.clip(LOST * weight / weight.mean(), 0, 1)
        kept = pl.Series(np.random.default_rng(seed).random(len(balls)) > chance)
        lost = balls.with_columns(pl.when(kept).then(name).alias(name) for name in ("launch_speed", "launch_angle"))
        lost.write_parquet(tmp_path / "lost.parquet")
        bias = tracking_bias(survey_tables([tmp_path / "lost.parquet"], staging=tmp_path))
        assert bias is not None and bias.share == pytest.approx(1 - kept.mean())  # type: ignore[operator]
        tracked = bias.mean_exit_speed_of_tracked
        taken_back.append((tracked - bias.mean_exit_speed_of_all) / (tracked - speed.mean() * MPH))
    assert least < np.mean(taken_back) < most

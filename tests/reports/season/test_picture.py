"""The picture of a season: no empty panel, no label on another, every park's name."""

from __future__ import annotations

import numpy as np
import polars as pl
import pytest

from sweetspot import catalog
from sweetspot.reports.pictures.style import png_bytes
from sweetspot.reports.quantities import SYSTEMS
from sweetspot.reports.season.picture import season_figure
from sweetspot.units import DEGREE, MPH
from tests.reports.pictures.labels import check_labels, texts


def balls(count: int, *, parks: int, tracked: float) -> pl.LazyFrame:
    """Return counted balls as a season leaves them, that share of them with a tracked distance."""
    rng = np.random.default_rng(count)
    names = [park.name for park in catalog.parks()][:parks]
    above = [value if rng.random() < tracked else None for value in rng.normal(2, 5, count)]
    return pl.LazyFrame({
        "squared_up_ratio": rng.normal(0.85, 0.1, count), "league_ratio": rng.normal(0.85, 0.1, count),
        "from_tip_drawn": rng.normal(0.15, 0.05, count), "offset": rng.normal(0, 0.02, count),
        "launch_angle": rng.uniform(15, 45, count) * DEGREE, "exit_speed": rng.normal(95, 8, count) * MPH,
        "bearing": rng.uniform(-45, 45, count) * DEGREE, "carry_above": above,
        "carry_per_drag": rng.uniform(-90, -40, count), "park": [names[row % parks] for row in range(count)],
        "month": [f"2024-{4 + row % 6:02d}" for row in range(count)], "game": [f"{row // 60}" for row in range(count)],
    }, schema_overrides={"carry_above": pl.Float64})  # fmt: skip


CASES = {
    "a year in every park": (balls(3000, parks=30, tracked=1.0), 7),
    "a game": (balls(16, parks=1, tracked=1.0), 2),  # fewer in each part than may be told of
    "no distances": (balls(900, parks=3, tracked=0.0), 2),
    "no bats": (balls(900, parks=1, tracked=1.0).drop("squared_up_ratio"), 3),
    "speeds alone": (balls(90, parks=1, tracked=0.0).drop("squared_up_ratio"), 1),
}


@pytest.mark.parametrize("case", CASES)
def test_panels_that_say_something_with_clear_labels(case: str) -> None:
    counted, panels = CASES[case]
    for reader in SYSTEMS.values():
        figure = season_figure(counted, title="A year $of 2024$", reading=reader)
        assert len(figure.axes) == panels
        assert all(axes.has_data() for axes in figure.axes)
        check_labels(figure)
    every_park = {park.name for park in catalog.parks()} <= {words for words, _ in texts(figure)}
    assert every_park == (case == "a year in every park")
    assert png_bytes(figure).startswith(b"\x89PNG")


def test_few_balls_are_dots() -> None:
    few, many = (season_figure(CASES[case][0]).axes[1] for case in ("a game", "no distances"))
    dots = [line for line in few.lines if line.get_marker() == "o"]
    assert len(dots) == 1 and len(np.asarray(dots[0].get_xdata())) == 16 and not few.collections
    assert many.collections and not [line for line in many.lines if line.get_marker() == "o"]


def test_few_speeds_have_few_bins_of_whole_numbers() -> None:
    """Of ninety balls no bin is a ball's own, and edges are what people read."""
    for reader in SYSTEMS.values():
        axes = season_figure(CASES["speeds alone"][0], reading=reader).axes[0]
        edges = np.unique(np.asarray(axes.patches[0].get_path().vertices)[:, 0])
        assert 5 <= len(edges) - 1 <= 14 and np.allclose(edges, np.round(edges))
        assert axes.get_ylabel() == "balls"

"""Where players of a league lie: ``python -m studies.league_batters LEADERBOARD --swings SWINGS``.

LEADERBOARD is a season's bat-tracking leaderboard, a row a batter; SWINGS is a table of single tracked balls in play.
It prints the quantiles that `sweetspot/catalog/league_batters.toml` holds. The tables themselves are not part of the
project, and no batter can be told from what is printed.
"""

from __future__ import annotations

import argparse
from collections.abc import Sequence
from itertools import pairwise

import numpy as np
import polars as pl

from sweetspot.numerics.arrays import Array

LEVELS = (0.05, 0.1, 0.25, 0.5, 0.75, 0.9, 0.95)
BANDS = (62, 66, 70, 74, 78, 82)
"""mph of bat speed, the ends of the bands."""
BEST = 0.8
"""Of the balls of a band, the quantile of exit speed from which one is among the best."""
SLOWEST = 55
"""mph; slower swings are bunts and checked ones."""


def batters(path: str) -> tuple[int, dict[str, list[float]], tuple[float, float]]:
    """Return how many batters, quantiles by quantity, and slope and spread of squared-up by mph of bat speed."""
    table = pl.read_csv(path)
    speed = table["avg_bat_speed"].to_numpy().astype(float)
    # squared-up balls over balls in play: single files of swings hold no fouls either
    squared = (table["squared_up_per_swing"] * table["swings_competitive"] / table["batted_ball_events"]).to_numpy()
    slope, level = np.polyfit(speed, squared, 1)
    rest = squared - (level + slope * speed)
    in_play = table["batted_ball_events"].to_numpy()
    chance = np.mean(squared * (1 - squared) / in_play)  # what so many balls scatter by themselves
    spread = float(np.sqrt(max(np.var(rest, ddof=2) - chance, 0.0)))
    found = {"bat_speed": _quantiles(speed, 2), "squared_up": _quantiles(squared, 3)}
    return table.height, found, (float(slope), spread)


def bands(path: str) -> list[dict[str, float]]:
    """Return how the hardest fifth of the balls of each band of bat speed was hit, and how the others were."""
    wanted = ["bat_speed", "launch_speed", "launch_angle", "attack_angle"]
    table = pl.read_csv(path, infer_schema_length=50_000, null_values=["NA", ""]).drop_nulls(wanted)
    table = table.filter(pl.col("bat_speed") > SLOWEST).with_columns(
        off=(pl.col("launch_angle") - pl.col("attack_angle")).abs()
    )
    rows = []
    for low, high in pairwise(BANDS):
        band = table.filter(pl.col("bat_speed").is_between(low, high, closed="left"))
        hard = band["launch_speed"].quantile(BEST)
        best, others = band.filter(pl.col("launch_speed") >= hard), band.filter(pl.col("launch_speed") < hard)
        row: dict[str, float] = {
            "from": low,
            "to": high,
            "balls": band.height,
            "exit_speed": round(float(hard or 0), 1),
        }
        for name, part in (("best", best), ("others", others)):
            row[f"{name}_off_path"] = round(float(np.median(part["off"].to_numpy())), 1)
            row[f"{name}_attack_angle"] = round(float(np.mean(part["attack_angle"].to_numpy())), 1)
        rows.append(row)
    return rows


def _quantiles(values: Array, digits: int) -> list[float]:
    return [round(float(value), digits) for value in np.quantile(values, LEVELS)]


def main(arguments: Sequence[str] | None = None) -> None:
    """Print the quantiles."""
    options = argparse.ArgumentParser(description=__doc__)
    options.add_argument("leaderboard", nargs="?", help="none: the bands of single swings only")
    options.add_argument("--swings", required=True)
    given = options.parse_args(arguments)
    if given.leaderboard is not None:
        count, found, (slope, spread) = batters(given.leaderboard)
        print(f"{count} batters, levels {list(LEVELS)}")
        for name, values in found.items():
            print(f"{name}: {values}")
        print(f"squared up by bat speed: {slope:.4f} per mph, spread {spread:.3f}")
    for row in bands(given.swings):
        print(row)


if __name__ == "__main__":
    main()

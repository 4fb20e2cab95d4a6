"""Intervals of seasons unlike what the model supposes: ``python -m studies.unlike_seasons``.

A season is made up by the collision and flight kernels, then measured and written down in ways that the model does not
suppose, each by itself and all together. Printed is how often intervals of 50 and 90 % hold places along the bat, exit
speeds of the half of the balls that nothing was learned from, and players' means and rates, told of each hundred of
their balls by itself, whose truth is what they do in all the others.
"""

from __future__ import annotations

import argparse
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np
import polars as pl

from studies.held_out import told
from sweetspot import catalog
from sweetspot.numerics.arrays import Array
from sweetspot.seasons import contact_kernel as kernel
from sweetspot.seasons.balls import balls_of
from sweetspot.seasons.headings import headings_of
from sweetspot.seasons.made_up import MadeSeason, made_season, normal_scatter
from sweetspot.seasons.pooling import pooled
from sweetspot.seasons.rows import USED, rows_of
from sweetspot.seasons.season_table import Season, analyse_season, season_setting
from sweetspot.seasons.standings import BOUNDS
from sweetspot.seasons.swings import USUAL_ERRORS, Errors
from sweetspot.units import DEGREE, MPH

BAT = "r161-ash"
Scatter = Callable[[np.random.Generator, int], Array]
NO_ERRORS = Errors(exit_speed=0.0, bat_speed=0.0, launch_angle=0.0, attack_angle=0.0)
TRACKED = ("bat_speed", "attack_angle", "attack_direction", "swing_path_tilt")
MEANS, RATES = ("exit_speed", "bat_speed"), ("league_squared_up", "squared_up", "blast")
TAIL = 3
"""Degrees of freedom of heavy tails: of these the variance is just known."""
APART = 0.9
"""Standard deviations that each of two humps lies from the middle."""


def heavy_scatter(rng: np.random.Generator, count: int) -> Array:
    """Return numbers with heavy tails, of mean 0 and variance 1."""
    return np.asarray(rng.standard_t(TAIL, count) / np.sqrt(TAIL / (TAIL - 2)))


def two_humps(rng: np.random.Generator, count: int) -> Array:
    """Return numbers that fall about two middles, of mean 0 and variance 1."""
    side = rng.choice([-APART, APART], count)
    return np.asarray(side + np.sqrt(1 - APART**2) * rng.normal(0, 1, count))


@dataclass(frozen=True)
class Unlike:
    """How a season differs from what is supposed.

    Parameters
    ----------
    scatter : of places along the bat about what is expected of them.
    errors : of exit and bat speeds, in shape; their sizes are the stated ones.
    together : correlation of the errors of exit and bat speed.
    wrong_sides : part of the rows that say the wrong side of the plate.
    untracked : part of the rows that know nothing of the bat.
    """

    scatter: Scatter = normal_scatter
    errors: Scatter = normal_scatter
    together: float = 0.0
    wrong_sides: float = 0.0
    untracked: float = 0.0


UNLIKE: Mapping[str, Unlike] = {
    "as supposed": Unlike(),
    "2 % of the batters' sides wrong": Unlike(wrong_sides=0.02),
    "half of the rows without bat tracking": Unlike(untracked=0.5),
    "errors of exit and bat speed go together (0.7)": Unlike(together=0.7),
    "errors with heavy tails": Unlike(errors=heavy_scatter),
    "places with heavy tails": Unlike(scatter=heavy_scatter),
    "places about two middles": Unlike(scatter=two_humps),
    "all of it, places about two middles": Unlike(two_humps, heavy_scatter, 0.7, 0.02, 0.5),
}


def unlike_season(unlike: Unlike, *, players: int, balls: int, seed: int = 1) -> pl.DataFrame:
    """Return a season as it is measured and written down."""
    how = MadeSeason(players=players, balls=balls, errors=NO_ERRORS, scatter=unlike.scatter)
    made, rng = made_season(catalog.bat(BAT), how, seed=seed), np.random.default_rng([seed, 7])
    count = len(made)
    first, second = unlike.errors(rng, count), unlike.errors(rng, count)
    bat_speed = unlike.together * first + np.sqrt(1 - unlike.together**2) * second
    wrong, nothing = rng.random(count) < unlike.wrong_sides, rng.random(count) < unlike.untracked
    side = made["stand"].to_numpy()
    measured = made.with_columns(
        launch_speed=made["launch_speed"] + USUAL_ERRORS.exit_speed / MPH * first,
        bat_speed=made["bat_speed"] + USUAL_ERRORS.bat_speed / MPH * bat_speed,
        launch_angle=made["launch_angle"] + USUAL_ERRORS.launch_angle / DEGREE * unlike.errors(rng, count),
        attack_angle=made["attack_angle"] + USUAL_ERRORS.attack_angle / DEGREE * unlike.errors(rng, count),
        stand=pl.Series(np.where(wrong, np.where(side == "L", "R", "L"), side)),
    )
    return measured.with_columns(pl.when(~pl.Series(nothing)).then(pl.col(name)).alias(name) for name in TRACKED)


def held(truth: pl.Series, table: pl.DataFrame, low: str, high: str) -> float:
    """Return how many of a hundred truths lie between two columns."""
    inside = ((truth >= table[low]) & (truth <= table[high])).mean()
    return 100 * float(inside or 0.0)  # type: ignore[arg-type]


def places_held(season: Season) -> list[float]:
    """Return how often intervals of 50 and 90 % hold the places."""
    balls = season.balls().filter(pl.col("contact_outcome") == "ok").collect()
    return [held(balls["true_from_tip_in"], balls, f"from_tip_low{level}_in", f"from_tip_high{level}_in")
            for level in (50, 90)]  # fmt: skip


def speeds_held(frame: pl.DataFrame) -> list[float]:
    """Return how often intervals hold exit speeds of balls, told by what was learned from the other half."""
    rows = rows_of(frame, headings_of(frame.columns))
    balls = balls_of(rows.filter((pl.col("reason") == USED) & pl.col("bat_speed").is_not_null()))
    setting = season_setting(bats={"": BAT}).contact
    assert setting is not None
    rank = told(balls, setting, np.random.default_rng(1).random(len(balls)) < 0.5)[:, kernel.RANK]
    rank = rank[np.isfinite(rank)]
    return [100 * float(np.mean((rank > end) & (rank < 1 - end))) for end in (0.25, 0.05)]


def players_held(season: Season, measures: tuple[str, ...], *, balls: int) -> list[float]:
    """Return how often intervals of players' means hold what the players do in other balls, over some measures.

    Every set of so many balls of each player is told of by itself, and held against all the others.

    Parameters
    ----------
    balls : of each player, in a set.
    """
    counted = season.counted().select("batter", *(pl.col(name).cast(pl.Float64) for name in measures)).collect()
    counted = counted.with_columns(part=pl.int_range(pl.len()).over("batter") // balls)
    whole = counted.group_by("batter").agg(pl.len() // balls)["len"].to_list()
    rows = []
    for part in range(min(whole)):
        mine, others = counted.filter(pl.col("part") == part), counted.filter(pl.col("part") != part)
        truth = others.group_by("batter").agg(pl.col(name).mean().alias(f"true {name}") for name in measures)
        for name in measures:
            told = pooled(mine, key="batter", measure=name, bounds=BOUNDS.get(name))[0].join(truth, on="batter")
            rows.append([held(told[f"true {name}"], told, f"low{level}", f"high{level}") for level in (50, 90)])
    return [float(value) for value in np.mean(rows, axis=0)]


def row_of(unlike: Unlike, *, players: int, balls: int, truth: int, seeds: int) -> list[float]:
    """Return coverage of places, exit speeds, players' means and rates, 50 and 90 % of each, over some seasons."""
    rows = []
    for seed in range(1, seeds + 1):
        every = unlike_season(unlike, players=players, balls=balls + truth, seed=seed)
        mine = every.filter(pl.int_range(pl.len()).over("batter") < balls)
        with TemporaryDirectory() as folder:
            season, whole = (_season(frame, Path(folder) / name) for name, frame in (("own", mine), ("all", every)))
            rows.append([*places_held(season), *speeds_held(mine), *players_held(whole, MEANS, balls=balls),
                         *players_held(whole, RATES, balls=balls)])  # fmt: skip
    return [float(value) for value in np.mean(rows, axis=0)]


def _season(frame: pl.DataFrame, folder: Path) -> Season:
    folder.mkdir()
    frame.write_parquet(folder / "season.parquet")
    return analyse_season([folder / "season.parquet"], setting=season_setting(bats={"": BAT}), folder=folder / "out")


def main(arguments: Sequence[str] | None = None) -> None:
    """Print the table."""
    options = argparse.ArgumentParser(description=__doc__)
    options.add_argument("--players", type=int, default=60)
    options.add_argument("--balls", type=int, default=100, help="of each player that answers are of")
    options.add_argument("--truth", type=int, default=900, help="more balls of each, told of and truth in turn")
    options.add_argument("--seasons", type=int, default=2)
    options.add_argument("--only", choices=UNLIKE, help="one way to be unlike")
    given = options.parse_args(arguments)
    print("| | places, 50 % | 90 % | exit speeds, 50 % | 90 % | players' means, 50 % | 90 % | rates, 50 % | 90 % |")
    print("|---|---|---|---|---|---|---|---|---|")
    for name in [given.only] if given.only else UNLIKE:
        row = row_of(UNLIKE[name], players=given.players, balls=given.balls, truth=given.truth, seeds=given.seasons)
        print(f"| {name} | {' | '.join(f'{value:.1f}' for value in row)} |", flush=True)


if __name__ == "__main__":
    main()

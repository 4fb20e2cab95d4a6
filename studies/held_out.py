"""Exit speeds foretold of balls that nothing was learned from: ``python -m studies.held_out``.

A table of tracked swings is cut into two halves, one after the other. Where balls are met is learned from one half and
told of the other. Printed is how often exit speed falls into its intervals of 50 and 90 %, by everything that swing,
pitch and ball are known by, and how likely the balls are that were not learned from; ``--places-to 14`` does the same
with places along the bat that end so many inches from the tip. ``--learn-from 150`` learns from so many balls of a
half, drawn anew three times, and prints all balls of the other half together; ``--usual`` prints the weights learned
from the whole table, which `place_relation` has as the usual ones.
"""

from __future__ import annotations

import argparse
from collections.abc import Sequence
from dataclasses import replace
from itertools import pairwise
from pathlib import Path

import numpy as np
import polars as pl
from numpy.typing import NDArray

from sweetspot.numerics.arrays import Array
from sweetspot.seasons import contact_kernel as kernel
from sweetspot.seasons.balls import Balls, balls_of, taken
from sweetspot.seasons.contact import ContactSetting, contacts, learnt
from sweetspot.seasons.headings import headings_of
from sweetspot.seasons.place_relation import LEVEL, NOISE, PLACE, SPREAD
from sweetspot.seasons.plane_hits import PLACES, BatInPlane
from sweetspot.seasons.rows import USED, rows_of
from sweetspot.seasons.season_table import season_setting
from sweetspot.seasons.swings import in_plane
from sweetspot.units import DEGREE, FOOT, INCH, MPH
from tests.real_data import FOLDER

TABLE = FOLDER / "cmu36sure2026_battedballs_battracking.csv.gz"
BANDS: tuple[tuple[str, str, tuple[float, ...]], ...] = (
    ("bat speed, mph", "bat speed", (40, 55, 66, 70, 74, 78, 82, 100)),
    ("attack angle, degrees", "attack", (-90, -8, -2, 4, 10, 16, 22, 90)),
    ("pitch outside by ft", "outside", (-4, -1.2, -1, -0.6, 0.6, 1, 4)),
    ("pitch above the ground by ft", "height", (-2, 1.5, 2, 2.5, 3, 3.5, 6)),
    ("tilt, degrees", "tilt", (0, 20, 25, 30, 35, 40, 45, 90)),
    ("turned up by degrees", "turned", (-180, -72, -60, -30, 30, 60, 72, 180)),
    ("ball's centre above the axis by in", "offset", (-4, -1.8, -1.4, -1, 1, 1.4, 1.8, 4)),
    ("launch angle, degrees", "launch angle", (-90, -30, -10, 0, 10, 20, 30, 40, 50, 90)),
    ("left-handed", "left", (0, 0.5, 1.5)),
)


def balls_in(path: Path, most: int | None = None) -> Balls:
    """Return the balls of a table that are used and have a bat speed."""
    frame = pl.read_csv(path, n_rows=most)
    rows = rows_of(frame, headings_of(frame.columns))
    return balls_of(rows.filter((pl.col("reason") == USED) & pl.col("bat_speed").is_not_null()))


def shortened(surface: BatInPlane, end: float) -> BatInPlane:
    """Return a bat's table without the places further from the tip than an end, m."""
    terms = np.where((end + 1e-9 >= PLACES)[:, None, None, None], surface.table.terms, np.nan)
    return replace(surface, table=surface.table._replace(terms=terms))


def told(balls: Balls, setting: ContactSetting, first: NDArray[np.bool_]) -> Array:
    """Return rows of `contact_kernel` of all balls, each by what was learned from the half that it is not in."""
    results = np.full((len(balls), kernel.ROWS), np.nan)
    for half in (first, ~first):
        relation = learnt(taken(balls, half), np.zeros(int(half.sum()), np.int64), setting)
        bats = np.zeros(int((~half).sum()), np.int64)
        results[~half] = contacts(taken(balls, ~half), bats, replace(setting, relation=relation)).results
    return results


def told_by_few(balls: Balls, setting: ContactSetting, first: NDArray[np.bool_], count: int) -> tuple[Array, float]:
    """Return ranks of balls by what was learned from a few of the other half, and their mean evidence."""
    rng, results = np.random.default_rng(1), []
    for half in (first, ~first) * 3:
        chosen = rng.choice(np.flatnonzero(half), count, replace=False)
        relation = learnt(taken(balls, chosen), np.zeros(count, np.int64), setting)
        bats = np.zeros(int((~half).sum()), np.int64)
        results.append(contacts(taken(balls, ~half), bats, replace(setting, relation=relation)).results)
    every = np.concatenate(results)
    known = np.isfinite(every[:, kernel.RANK])
    return every[known, kernel.RANK], float(every[known, kernel.EVIDENCE].mean())


def print_usual(balls: Balls, setting: ContactSetting) -> None:
    """Print weights learned from all balls, those of the place in inches."""
    relation = learnt(balls, np.zeros(len(balls), np.int64), setting)
    for names, weights in ((PLACE, relation.weights / INCH), (SPREAD, relation.spread_weights),
                           (LEVEL, relation.level_weights), (NOISE, relation.noise_weights)):  # fmt: skip
        print(", ".join(f"{name} {weight:.3f}" for name, weight in zip(names, weights, strict=True)))
    print("all places, in: " + ", ".join(f"{one / INCH:.2f}" for one in relation.marginal))


def held(rank: Array) -> str:
    """Return number, intervals of 50 and 90 % and mean rank, as a row of a table."""
    inside = [100 * float(np.mean((rank > end) & (rank < 1 - end))) for end in (0.25, 0.05)]
    return f"{len(rank)} | {inside[0]:.1f} | {inside[1]:.1f} | {rank.mean():.2f} |"


def main(arguments: Sequence[str] | None = None) -> None:
    """Print the table."""
    options = argparse.ArgumentParser(description=__doc__)
    options.add_argument("--places-to", type=float, default=None, help="in from the tip")
    options.add_argument("--learn-from", type=int, default=None, help="balls")
    options.add_argument("--usual", action="store_true")
    options.add_argument("--balls", type=int, default=None, help="take only so many of the table")
    given = options.parse_args(arguments)
    setting = season_setting().contact
    assert setting is not None
    if given.places_to is not None:
        setting = replace(setting, surfaces=(shortened(setting.surfaces[0], given.places_to * INCH),))
    balls = balls_in(TABLE, given.balls)
    first = np.arange(len(balls)) < len(balls) // 2
    if given.usual:
        print_usual(balls, setting)
        return
    if given.learn_from is not None:
        ranks, likely = told_by_few(balls, setting, first, given.learn_from)
        print(f"| learned from {given.learn_from} | {held(ranks)} logarithm of the likelihood of a ball {likely:.3f}")
        return
    results = told(balls, setting, first)
    rank = results[:, kernel.RANK]
    known = np.isfinite(rank)
    plane = in_plane(balls, setting.surfaces[0], setting.errors, ball=setting.ball)
    values = {
        "bat speed": balls.bat_speed / MPH, "attack": balls.attack_angle / DEGREE, "outside": balls.outside / FOOT,
        "height": balls.plate_height / FOOT, "tilt": balls.tilt / DEGREE, "turned": plane.turned / DEGREE,
        "offset": results[:, kernel.OFFSET] / INCH, "launch angle": balls.launch_angle / DEGREE,
        "left": balls.left.astype(float),
    }  # fmt: skip
    print("| | balls | 50 % | 90 % | mean rank |\n|---|---|---|---|---|")
    for words, name, edges in BANDS:
        for low, high in pairwise(edges):
            mine = known & (values[name] >= low) & (values[name] < high)
            print(f"| {words}: {low:g} to {high:g} | {held(rank[mine])}")
    topped = known & (values["attack"] < 0) & (values["launch angle"] < -30)
    print(f"| topped below -30 degrees by a bat that goes down | {held(rank[topped])}")
    for words, mine in (("first half", first), ("second half", ~first), ("all", known)):
        print(f"| {words} | {held(rank[known & mine])}")
    sums = [float(np.nansum(results[half, kernel.EVIDENCE])) for half in (first, ~first)]
    print("\nlogarithm of the likelihood of the halves: " + ", ".join(f"{value:.1f}" for value in sums))


if __name__ == "__main__":
    main()

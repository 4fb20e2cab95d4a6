"""How reliable is squared-up against the bat? ``python -m studies.reliability``: some minutes.

No public table has both batter and bat speed, so by how much real players differ is asked of numbers of the league:
at 34 balls of 209 players the reliabilities of exit speed, of the league's rate of squared-up balls and of its blasts,
and how much of the exit speeds of 34 other balls is explained by bat speed, alone and with that rate. Leagues are made
up whose swings scatter like tracked ones [sure2026] and whose players differ by numbers drawn from wide ranges; of
those that come near the league's five numbers, by a straight line through them, we tell what else holds there.
Nothing of what we say ourselves is fitted. Last comes what could be known at most: one such league, as it is read, read
without errors, and hit without balls that differ.
"""

from __future__ import annotations

import argparse
from collections.abc import Sequence
from dataclasses import replace
from typing import Any

import numpy as np
import polars as pl
from numpy.typing import NDArray

from sweetspot import catalog
from sweetspot.catalog.league_batters import LEAGUE_BAT, LEAGUE_PITCH, SQUARED_UP
from sweetspot.seasons.balls import balls_of
from sweetspot.seasons.contact import BLAST
from sweetspot.seasons.headings import headings_of
from sweetspot.seasons.made_up import LIKE_THE_LEAGUE, MadeSeason, made_season
from sweetspot.seasons.pooling import pooled
from sweetspot.seasons.rows import USED, rows_of
from sweetspot.seasons.season_table import season_setting
from sweetspot.seasons.swings import Errors, ceilings, in_plane
from sweetspot.units import INCH, MPH

Array = NDArray[np.float64]
BAT = "r161-ash"
AT = 34
LEAGUE = {"exit_speed": 0.43, "league_rate": 0.23, "blast": 0.52, "explained": 0.255, "explained_with_rate": 0.256}
"""Of 209 players, two halves of 34 balls."""
MEASURED = ("exit_speed", "bat_speed", "league_rate", "blast", "ratio", "league_ratio", "rate", "ratio_above")
TINY = 1e-6
"""m/s and rad: as good as no error."""
TOTAL = 5.42
"""mph that tracked bat speeds scatter by, all together [sure2026]."""


def drawn(rng: np.random.Generator, bats: bool) -> MadeSeason:
    """Return a league whose players differ by chance; ``bats``: in what they swing, too."""
    place, speed, spread = rng.uniform(0, 1.0), rng.uniform(1.5, 3.4), rng.uniform(0, 0.35)
    wilder, offset, level = rng.uniform(-0.05, 0.35), rng.uniform(0, 0.35), rng.uniform(0, 0.025) * bats
    within = np.sqrt(TOTAL**2 - 1 - speed**2)
    like = LIKE_THE_LEAGUE
    return MadeSeason(
        players=like.players, balls=like.balls, place=like.place, per_outside=like.per_outside, noise=like.noise,
        place_spread=2.15 * INCH / np.exp(spread**2 + wilder**2), between=(place * INCH, speed * MPH, spread),
        wilder=wilder, speed_spread=within * MPH, offset_spread=1.22 * INCH / np.exp(offset**2), offset_between=offset,
        level_between=level,
    )  # fmt: skip


def told(made: MadeSeason, seed: int) -> dict[str, float]:
    """Return the reliabilities of a made-up league, and what explains the exit speeds of the other half."""
    frame = made_season(catalog.bat(BAT), made, seed=seed).filter(pl.int_range(pl.len()).over("batter") < 2 * AT)
    setting = season_setting(bats={"": BAT}).contact
    assert setting is not None
    rows = rows_of(frame, headings_of(frame.columns)).filter(pl.col("reason") == USED)
    balls, surface = balls_of(rows), setting.surfaces[0]
    plane = in_plane(balls, surface, setting.errors, ball=setting.ball)
    ceiling, _ = ceilings(plane, surface)
    good = plane.outcome == 0
    league = LEAGUE_BAT * balls.bat_speed + LEAGUE_PITCH * balls.plate_speed
    ratio, league_ratio, speed = balls.exit_speed / ceiling, balls.exit_speed / league, balls.bat_speed / MPH
    usual = np.polyval(np.polyfit(speed[good], ratio[good], 2), speed)
    table = pl.DataFrame({
        "batter": rows["batter"], "exit_speed": balls.exit_speed / MPH, "bat_speed": speed, "ratio": ratio,
        "league_ratio": league_ratio, "rate": (ratio >= SQUARED_UP) * 1.0, "ratio_above": ratio - usual,
        "league_rate": (league_ratio >= SQUARED_UP) * 1.0, "blast": (100 * league_ratio + speed >= BLAST) * 1.0,
    }).filter(pl.Series(good))  # fmt: skip
    found = {name: float(pooled(table, key="batter", measure=name)[1].reliability(float(AT))) for name in MEASURED}
    halves = table.with_columns(half=pl.int_range(pl.len()).over("batter") % 2).group_by("batter").agg(
        pl.col(name).filter(pl.col("half") == half).mean().alias(f"{name} {half}")
        for name in MEASURED for half in (0, 1)
    ).drop_nulls()  # fmt: skip
    found["explained"] = _explained(halves, "exit_speed", ["bat_speed"])
    found["explained_with_rate"] = _explained(halves, "exit_speed", ["bat_speed", "league_rate"])
    found["explained_with_ratio"] = _explained(halves, "exit_speed", ["bat_speed", "ratio"])
    found["ratio_told_by_itself"] = _explained(halves, "ratio", ["ratio"]) ** 0.5
    found["ratio_told_with_bat_speed"] = _explained(halves, "ratio", ["ratio", "bat_speed"]) ** 0.5
    speed_and_rate = np.array(_means(table, "bat_speed", "league_rate"))
    found["rate_against_bat_speed"] = float(np.asarray(np.corrcoef(speed_and_rate))[0, 1])
    return found | {"level_between": made.level_between, "wilder": made.wilder}


def _means(table: pl.DataFrame, *names: str) -> list[Array]:
    means = table.group_by("batter").agg(pl.col(names).mean())
    return [means[name].to_numpy() for name in names]


def _explained(halves: pl.DataFrame, what: str, by: list[str]) -> float:
    shares = []
    for half in (0, 1):
        terms = np.stack([np.ones(len(halves)), *(halves[f"{name} {half}"].to_numpy() for name in by)], axis=1)
        other = halves[f"{what} {1 - half}"].to_numpy()
        rest = other - terms @ np.linalg.lstsq(terms, other, rcond=None)[0]
        shares.append(1 - rest.var() / other.var())
    return float(np.mean(shares))


def predicted(leagues: list[dict[str, float]], what: str) -> tuple[float, float]:
    """Return what holds in leagues with the league's own five numbers, and what single leagues scatter by about it."""
    known = np.array([[one[name] for name in LEAGUE] for one in leagues]) - list(LEAGUE.values())
    values = np.array([one[what] for one in leagues])
    away = np.sqrt(np.mean((known / known.std(axis=0)) ** 2, axis=1))
    near = np.argsort(away)[: len(away) // 2]
    weight = 1 - (away[near] / away[near].max()) ** 2
    terms = np.column_stack([np.ones(len(near)), known[near]])
    root = np.sqrt(weight)
    line = np.linalg.lstsq(terms * root[:, None], values[near] * root, rcond=None)[0]
    return float(line[0]), float(np.sqrt(np.average((values[near] - terms @ line) ** 2, weights=weight)))


def limits(leagues: int) -> None:
    """Print the reliability of squared-up against the bat in a league like the real one, and by what it is limited."""
    sharp = Errors(exit_speed=TINY, bat_speed=TINY, launch_angle=TINY, attack_angle=TINY)
    unread = replace(LIKE_THE_LEAGUE, errors=sharp)
    for words, made in (
        ("as it is read", LIKE_THE_LEAGUE), ("read without errors", unread),
        ("and balls that are hit alike go alike", replace(unread, noise=0.0)),
    ):  # fmt: skip
        values = np.array([[told(made, seed=50 + number)[name] for name in ("ratio", "ratio_told_with_bat_speed")]
                           for number in range(leagues)])  # fmt: skip
        mean, error = values.mean(axis=0), values.std(axis=0) / np.sqrt(leagues)
        print(f"{words}: {mean[0]:.3f} +- {error[0]:.3f}, the other half told with bat speed {mean[1]:.3f}")


def main(arguments: Sequence[str] | None = None) -> None:
    """Print what was found, for players who all swing this bat and for such whose bats differ."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--leagues", type=int, default=300)
    parser.add_argument("--limits", type=int, default=30, help="leagues like the real one; 0: none")
    asked: Any = parser.parse_args(arguments)
    for bats in (False, True):
        rng = np.random.default_rng(7)
        leagues = [told(drawn(rng, bats), seed=1000 + number) for number in range(asked.leagues)]
        print("players' bats differ:" if bats else "all players swing the same bat:")
        for name in leagues[0]:
            value, scatter = predicted(leagues, name)
            print(f"  {name:<26}{value:6.3f} +- {scatter:.3f}" + (" (given)" if name in LEAGUE else ""))

    if asked.limits:
        print("a league like the real one, whose bats differ:")
        limits(asked.limits)


if __name__ == "__main__":
    main()

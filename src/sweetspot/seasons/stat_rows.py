"""Groups and measures for sums over players, pitchers, clubs, pitch types, counts and months: a row per ball, SI."""

from __future__ import annotations

import numpy as np
import polars as pl

from sweetspot.numerics.arrays import Array
from sweetspot.seasons import contact_kernel as kernel
from sweetspot.seasons.ball_columns import Answers
from sweetspot.seasons.contact import measures
from sweetspot.seasons.rows import by_number
from sweetspot.tables.headings import Headings
from sweetspot.units import INCH

CENTRED, LINED_UP = 4 * INCH, 2 * INCH
"""m from the best place along the bat and above or below its axis, within which the league calls a ball centred and
lined up [statcast_contact_point]."""
ON_TIME = 0.007
"""s before or after the usual moment, within which the league calls a ball met on time; on time, centred and lined up
it is met perfectly [statcast_contact_point]."""
EARLIER, USUAL_LEAD = 0.92, 0.018
"""Timing is 0.92 times the way from the batter's middle to the contact over the pitch's speed, less 18 ms: fitted to
the league's own timing with r squared 0.951 [statcast_contact_point]."""
WITH = "with "
"""How columns begin that hold what a ball would gain with another bat, m/s."""
SAME_BAT = 1e-9
"""Gain below which it was that very bat the ball was hit with, and nothing was tried, m/s."""


def counted_rows(rows: pl.DataFrame, answers: Answers, headings: Headings) -> pl.DataFrame:
    """Return groups and measures of balls, one row each.

    ``rows``: that went through `rows_of` and are used.
    """
    balls, flown = answers.balls, answers.flight
    measured: dict[str, Array] = {
        "exit_speed": balls.exit_speed, "launch_angle": balls.launch_angle, "bat_speed": balls.bat_speed,
        "direction": flown.launch_direction, "carry": flown.carry, "carry_above": answers.carry_above,
        "carry_per_drag": flown.carry_per_drag, "home_run_here": flown.home_run_here,
        "home_runs_in_30": flown.home_runs, "home_run_kind": answers.home_run_kind.astype(float),
        "bearing": balls.bearing,
    }  # fmt: skip
    contact = answers.contact
    if contact is not None:
        result = contact.results
        distance, offset = result[:, kernel.DISTANCE + 2], result[:, kernel.OFFSET]
        with np.errstate(invalid="ignore"):
            centred = np.where(np.isnan(distance), np.nan, distance <= CENTRED)
            lined_up = np.where(np.isnan(offset), np.nan, np.abs(offset) <= LINED_UP)
            late = np.abs(timing(rows, balls.plate_speed))
            on_time = np.where(np.isnan(late), np.nan, late <= ON_TIME)
            perfect = np.where(np.isnan(centred + lined_up + on_time), np.nan, centred * lined_up * on_time)
        measured |= measures(balls, contact) | {
            "on_time": on_time, "perfect": perfect,
            "from_best": distance, "from_tip": result[:, kernel.MEAN_PLACE],
            "from_tip_drawn": result[:, kernel.DRAWN], "offset": offset, "centred": centred,
            "lined_up": lined_up, "tip_side": result[:, kernel.TIP_SIDE], "rank": result[:, kernel.RANK],
            "above_usual": balls.exit_speed - result[:, kernel.EXPECTED],
        }  # fmt: skip
        for name, (mean, _, _) in contact.others.items():
            gain = mean - balls.exit_speed
            measured[f"{WITH}{name}"] = np.where(np.abs(gain) < SAME_BAT, np.nan, gain)
    series = [pl.Series(name, values.astype(np.float32), nan_to_null=True) for name, values in measured.items()]
    when = {
        "month": by_number(rows["day"], lambda day: day.dt.strftime("%Y-%m")),
        "season": by_number(rows["season"], lambda year: year.cast(pl.String)),
    }
    return rows.with_columns(**when).select(*groups(headings)).with_columns(*series, park=_parks(answers))


def timing(rows: pl.DataFrame, plate_speed: Array) -> Array:
    """Return the time by which balls were met earlier than usual, s, by the league's formula; NaN where not known.

    ``rows``: that went through `rows_of` and are used. ``plate_speed``: of the pitches, m/s, shape (n,).

    >>> rows = pl.DataFrame({"intercept_ahead": [30 * INCH, None]})
    >>> early = timing(rows, np.array([38.0, 38.0]))
    >>> round(1000 * float(early[0]), 2), bool(np.isnan(early[1]))
    (0.45, True)
    """
    if "intercept_ahead" not in rows.columns:
        return np.full(len(rows), np.nan)
    ahead = rows["intercept_ahead"].fill_null(np.nan).to_numpy()
    return np.asarray(EARLIER * ahead / plate_speed - USUAL_LEAD)


def groups(headings: Headings) -> list[pl.Expr]:
    """Return the groups that a ball belongs to, each as text, of rows whose month and season are texts.

    Who has no number goes by his name.
    """
    nothing = pl.lit(None, pl.String)

    def text(name: str) -> pl.Expr:
        return pl.col(name) if headings.has(name) else nothing

    batting = text("batter_team")
    pitching = text("pitcher_team")
    if headings.has("half_inning", "home_team", "away_team"):
        top = pl.col("half_inning").str.to_lowercase().str.starts_with("t")
        batting = pl.coalesce(batting, pl.when(top).then(pl.col("away_team")).otherwise(pl.col("home_team")))
        pitching = pl.coalesce(pitching, pl.when(top).then(pl.col("home_team")).otherwise(pl.col("away_team")))
    batter, pitcher = (pl.coalesce(text(who), text(f"{who}_name")) for who in ("batter", "pitcher"))
    count = nothing
    if headings.has("balls", "strikes"):
        count = pl.concat_str([pl.col("balls"), pl.col("strikes")], separator="-")
    return [
        batter.alias("batter"), text("batter_name").alias("batter_name"), pitcher.alias("pitcher"),
        text("pitcher_name").alias("pitcher_name"), batting.alias("team"), pitching.alias("fielding_team"),
        text("pitch_type").alias("pitch_type"), count.alias("count"),
        pl.col("month"), pl.col("season"),
        text("event").alias("event"), text("game").alias("game"),
    ]  # fmt: skip


def _parks(answers: Answers) -> pl.Series:
    names = pl.Series("park", [*(park.name for park in answers.fields.parks), None], dtype=pl.String)
    return names.gather(answers.fields.index % len(names))

"""Every answer for some rows of a table: the columns that are put beside its own, their names, units and meanings."""

from __future__ import annotations

import tomllib
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Literal, NamedTuple

import numpy as np
import polars as pl
from numpy.typing import NDArray

from sweetspot.numerics.arrays import Array
from sweetspot.seasons import contact_kernel as kernel
from sweetspot.seasons.balls import ELSEWHERE, Balls, Fields, balls_of, fields_of, home_park
from sweetspot.seasons.contact import Contacts, ContactSetting, contacts, measures
from sweetspot.seasons.flight_columns import GLOVE, FlightColumns, FlightSetting, flown_balls
from sweetspot.seasons.rows import by_number
from sweetspot.seasons.swings import OUTCOMES
from sweetspot.tables.headings import Headings
from sweetspot.units import DEGREE, FOOT, INCH, MPH

System = Literal["us", "si"]
ENDINGS: Mapping[str, Mapping[System, tuple[str, float]]] = {
    "speed": {"us": ("_mph", MPH), "si": ("_m_s", 1.0)},
    "angle": {"us": ("_deg", DEGREE), "si": ("_rad", 1.0)},
    "length": {"us": ("_in", INCH), "si": ("_m", 1.0)},
    "distance": {"us": ("_ft", FOOT), "si": ("_m", 1.0)},
    "time": {"us": ("_s", 1.0), "si": ("_s", 1.0)},
    "ratio": {"us": ("", 1.0), "si": ("", 1.0)},
    "count": {"us": ("", 1.0), "si": ("", 1.0)},
    "text": {"us": ("", 1.0), "si": ("", 1.0)},
    "yes": {"us": ("", 1.0), "si": ("", 1.0)},
}
"""Ending of a column's name and size of its unit, by kind and system."""


@dataclass(frozen=True)
class OutputColumn:
    """A column that is put beside a table's own.

    ``kind``: a key of `ENDINGS`. ``part``: of the answers it belongs to: "flight", "contact" or "bats".
    """

    name: str
    kind: str
    meaning: str
    part: str

    def heading(self, system: System) -> str:
        """Return the name with its unit.

        >>> OutputColumn("carry", "distance", "how far", "flight").heading("us")
        'carry_ft'
        """
        return self.name + ENDINGS[self.kind][system][0]


def columns_in(part: str) -> dict[str, tuple[str, str]]:
    """Return kind and meaning of each column in a part of `columns.toml`, by its name."""
    with Path(__file__).with_name("columns.toml").open("rb") as file:
        return {name: (kind, meaning) for name, (kind, meaning) in tomllib.load(file)[part].items()}


FLIGHT, CONTACT = (
    tuple(OutputColumn(name, *column, part) for name, column in columns_in(part).items())
    for part in ("flight", "contact")
)
SIDES = ("", "_low", "_high")


def columns_of_other(name: str) -> tuple[OutputColumn, ...]:
    """Return the columns of a bat that every swing is tried with: its exit speed and 90 % interval."""
    stem = f"exit_speed_with_{name.replace('-', '_')}"
    meaning = f"exit speed of the same swing with {name}, met at the same place"
    return tuple(OutputColumn(stem + side, "speed", meaning, "bats") for side in SIDES)


class Categories(NamedTuple):
    """A column of few words: which of them stands in each row.

    ``words``: None for nothing. ``number``: index into the words, shape (n,).
    """

    words: tuple[str | None, ...]
    number: NDArray[np.int64]


def as_series(column: OutputColumn, values: Array | Categories, system: System) -> pl.Series:
    """Return values in SI as a column in a system's unit; what is not finite is missing.

    ``values``: in SI; 1 and 0 for yes and no; words where the column's kind is text.
    """
    heading = column.heading(system)
    if isinstance(values, Categories):
        return pl.Series(heading, values.words, dtype=pl.String).gather(values.number)
    if column.kind == "yes":
        return pl.Series(heading, values, nan_to_null=True).cast(pl.Boolean)
    scaled = np.asarray(values, float) / ENDINGS[column.kind][system][1]
    return pl.Series(heading, scaled.astype(np.float32), nan_to_null=True)


MOSTLY_GONE = 8
"""Parks from which on a ball is mostly gone; the league's three kinds [statcast]."""
FLY_BALLS = (15 * DEGREE, 45 * DEGREE)
FLY_SPEED = 80 * MPH
"""Balls whose tracked distance is compared with the carry."""
UNKNOWN_BAT = "unknown"
WHOSE_BAT = ("batter", "batter_name", "bat")
"""Quantities by which the bat of a ball is known, the last one first."""
FLIGHT_OUTCOMES = ("flown", "no launch angle", "not flown", "direction unknown")
HOME_RUN_KINDS = (None, "doubter", "mostly gone", "no doubter")


@dataclass(frozen=True)
class SeasonSetting:
    """The parameters that all rows share.

    ``contact``: of the contacts; None: not wanted. ``bats``: name of the bat of each batter; "" stands for all others.
    ``system``: units of the columns.
    """

    flight: FlightSetting
    contact: ContactSetting | None
    bats: Mapping[str, str]
    system: System = "us"

    @property
    def bat_names(self) -> tuple[str, ...]:
        """Return the names of the bats that occur, in the order of the contact's tables."""
        return tuple(dict.fromkeys(name for name in self.bats.values() if name != UNKNOWN_BAT))


@dataclass(frozen=True)
class Answers:
    """All answers for n balls, in SI."""

    balls: Balls
    fields: Fields
    flight: FlightColumns
    contact: Contacts | None
    bat_of: NDArray[np.int64]

    @cached_property
    def carry_above(self) -> Array:
        """Tracked distance less carry in m, of fly balls and line drives; caught balls end at a glove."""
        flown, balls = self.flight, self.balls
        fly = (balls.launch_angle >= FLY_BALLS[0]) & (balls.launch_angle <= FLY_BALLS[1])
        fly &= (balls.exit_speed >= FLY_SPEED) & (balls.distance > 0)
        with np.errstate(invalid="ignore", divide="ignore"):
            short = np.where(flown.home_run_parks > 0, 0.0, GLOVE / np.tan(flown.landing_angle))
        return np.where(fly, balls.distance - (flown.carry - short), np.nan)

    @cached_property
    def home_run_kind(self) -> NDArray[np.int64]:
        """Index into `HOME_RUN_KINDS`."""
        parks = self.flight.home_run_parks
        return (parks >= 1).astype(np.int64) + (parks >= MOSTLY_GONE) + (parks >= 30)


def answers_of(rows: pl.DataFrame, setting: SeasonSetting) -> Answers:
    """Return all answers for rows that went through `rows_of`."""
    balls = balls_of(rows, pitches=setting.contact is not None)
    fields = fields_of(_places_of(rows), balls.season, otherwise=setting.flight.field)
    flown = flown_balls(balls, fields, setting.flight, airs=fields.airs(setting.flight.air, rows))
    bat_of = bats_of(rows, setting)
    contact = None if setting.contact is None else contacts(balls, bat_of, setting.contact)
    return Answers(balls, fields, flown, contact, bat_of)


def _places_of(rows: pl.DataFrame) -> pl.Series:
    """Return the parks of balls as far as a table names them, else the home clubs of games in their own parks."""
    club = pl.col("home_team") if "home_team" in rows.columns else pl.lit(None, pl.String)
    if "game_kind" in rows.columns:
        club = pl.when(~pl.col("game_kind").is_in(ELSEWHERE).fill_null(value=False)).then(club)
    if "park" in rows.columns:
        unknown = [name for name in rows["park"].drop_nulls().unique() if home_park(name, None) is None]
        club = pl.coalesce(pl.when(~pl.col("park").is_in(unknown)).then(pl.col("park")), club)
    return rows.with_columns(place=club)["place"]


def bats_of(rows: pl.DataFrame, setting: SeasonSetting) -> NDArray[np.int64]:
    """Return the index of each ball's bat in the setting, -1 where not known; the table's column takes precedence."""
    number = {name: index for index, name in enumerate(setting.bat_names)}
    usual = number.get(setting.bats.get("", ""), -1)
    chosen = np.full(len(rows), usual, np.int64)
    for column in WHOSE_BAT:
        if column in rows.columns:
            bat_names = setting.bats if column != "bat" else {name: name for name in number}
            index = {who: number.get(name, -1) for who, name in bat_names.items() if who}
            mapped = rows[column].replace_strict(index, default=-2, return_dtype=pl.Int64) if any(bat_names) else None
            if mapped is not None:
                values = mapped.fill_null(-2).to_numpy()
                chosen = np.where(values > -2, values, chosen)
    return chosen


def answer_columns(answers: Answers, setting: SeasonSetting) -> list[pl.Series]:
    """Return the answers as columns in the setting's units."""
    pairs = [*_flight(answers)]
    if setting.contact is not None and answers.contact is not None:
        pairs += [*_contact(answers, setting), *_others(answers.contact)]
    return [as_series(column, values, setting.system) for column, values in pairs]


def answer_headings(setting: SeasonSetting) -> list[str]:
    """Return the names of the columns of answers."""
    contact = setting.contact
    others = () if contact is None else (column for bat in contact.others for column in columns_of_other(bat.name))
    columns = (*FLIGHT, *(() if contact is None else CONTACT), *others)
    return [column.heading(setting.system) for column in columns]


FLOWN = (
    *("launch_direction", "carry", "carry_spread", "hang_time", "landing_angle", "home_run_here", "home_run_parks"),
)
"""Columns that are called as in `Flown`."""


def _flight(answers: Answers) -> Iterator[tuple[OutputColumn, Array | Categories]]:
    flown, balls = answers.flight, answers.balls
    here = np.isfinite(flown.launch_direction)
    outcome = np.select([np.isnan(balls.launch_angle), ~np.isfinite(flown.carry), ~here], [1, 2, 3], 0)
    values: dict[str, Array | Categories] = {
        **{name: getattr(flown, name) for name in FLOWN},
        "flight_outcome": Categories(FLIGHT_OUTCOMES, outcome),
        "apex": flown.apex_height,
        "carry_above": answers.carry_above,
        "home_runs_in_30": flown.home_runs,
        "home_run_kind": Categories(HOME_RUN_KINDS, answers.home_run_kind),
    }
    yield from ((column, values[column.name]) for column in FLIGHT)


RESULTS = {
    **{"offset": kernel.OFFSET, "offset_spread": kernel.OFFSET_SPREAD, "tip_side": kernel.TIP_SIDE},
    **{"exit_speed_usual": kernel.EXPECTED, "exit_speed_rank": kernel.RANK},
}
"""Rows of the kernel's results that are columns as they are."""


def _contact(answers: Answers, setting: SeasonSetting) -> Iterator[tuple[OutputColumn, Array | Categories]]:
    contact, balls = answers.contact, answers.balls
    assert contact is not None
    counted, rows = measures(balls, contact), contact.results
    names = (*setting.bat_names, UNKNOWN_BAT)
    values: dict[str, Array | Categories] = {
        **counted,
        **{name: rows[:, row] for name, row in RESULTS.items()},
        **{name: getattr(contact, name) for name in ("ceiling", "above_improbable", "league_ceiling")},
        "bat": Categories(names, answers.bat_of % len(names)),
        "contact_outcome": Categories(OUTCOMES, contact.outcome),
        "pitch_at_plate": balls.plate_speed,
        "above_ceiling": contact.above_chance,
        "best_from_tip": contact.best_place,
    }
    ends = ("low90", "low50", "", "high50", "high90")
    for stem, first in (("from_tip", kernel.PLACE), ("from_best", kernel.DISTANCE)):
        for number, end in enumerate(ends):
            values[f"{stem}_{end}".rstrip("_")] = rows[:, first + number]
    yield from ((column, values[column.name]) for column in CONTACT)


def _others(contact: Contacts) -> Iterator[tuple[OutputColumn, Array | Categories]]:
    for name, three in contact.others.items():
        yield from zip(columns_of_other(name), three, strict=True)


FAST_SWING = 75 * MPH
"""Bat speed from which on the league calls a swing fast [statcast]."""
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
        **{name: getattr(balls, name) for name in ("exit_speed", "launch_angle", "bat_speed", "bearing")},
        **{name: getattr(flown, name) for name in ("carry", "carry_per_drag", "home_run_here")},
        "direction": flown.launch_direction,
        "carry_above": answers.carry_above,
        "home_runs_in_30": flown.home_runs,
        "home_run_kind": answers.home_run_kind.astype(float),
        "fast_swing": np.where(np.isnan(balls.bat_speed), np.nan, balls.bat_speed >= FAST_SWING),
        "pull": np.where(balls.sided, np.where(balls.left, balls.bearing, -balls.bearing), np.nan),
    }
    if headings.has("swing_length"):
        measured["swing_length"] = rows["swing_length"].fill_null(np.nan).to_numpy()
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
            **{"on_time": on_time, "perfect": perfect, "centred": centred, "lined_up": lined_up},
            **{"from_best": distance, "offset": offset, "from_tip": result[:, kernel.MEAN_PLACE]},
            **{"from_tip_drawn": result[:, kernel.DRAWN], "tip_side": result[:, kernel.TIP_SIDE]},
            **{"rank": result[:, kernel.RANK], "above_usual": balls.exit_speed - result[:, kernel.EXPECTED]},
        }
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
        *(pl.col(name) for name in ("month", "season")),
        *(text(name).alias(name) for name in ("batter_name", "pitcher_name", "pitch_type", "event", "game")),
        *(batter.alias("batter"), pitcher.alias("pitcher"), count.alias("count")),
        *(batting.alias("team"), pitching.alias("fielding_team")),
    ]


def _parks(answers: Answers) -> pl.Series:
    names = pl.Series("park", [*(park.name for park in answers.fields.parks), None], dtype=pl.String)
    return names.gather(answers.fields.index % len(names))

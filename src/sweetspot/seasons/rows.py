"""Rows of a table in our own terms: every quantity in SI, missing where it is missing, and why a row is not used.

A row is used when a ball was put in play, not by a bunt, and its exit speed is known and possible. All others stay in
the ledger under the first reason that holds.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping
from datetime import date
from functools import partial

import polars as pl

from sweetspot.plausibility import bounds, fine
from sweetspot.seasons.headings import DAY_FIRST
from sweetspot.tables.headings import Headings, TableColumn
from sweetspot.tables.vocabulary import UNITS

USED = "used"
REASONS = {
    "duplicate": "the same pitch a second time",
    "no contact": "a ball, a called strike or a miss; also a foul tip",
    "foul": "fouled off",
    "bunt": "bunted",
    "untracked": "put in play, and no exit speed was measured",
    "impossible": "an exit speed or launch angle that cannot be",
    USED: "balls in play with an exit speed",
}
"""Why a row is where it is in the ledger, in the order in which they are asked."""
ABSENT = ("", "NA", "N/A", "na", "n/a", "#N/A", "<NA>", "NaN", "nan", "NaT", "null", "NULL", "None", "none", "-", "--")
"""Words that mean that there is nothing. Missing is never zero."""
SPORT = "baseball"
POSSIBLE: Mapping[str, tuple[float, float]] = {
    **{name: fine(name, SPORT) for name in ("attack_direction", "axial_offset", "plate_side", "plate_height")},
    **{name: fine(name, SPORT) for name in ("distance", "hang_time", "temperature", "pressure", "humidity")},
    "swing_length": fine("swing_length", SPORT),
    "elevation": fine("elevation", SPORT),
    **{name: fine(f"tracked_{name}") for name in ("attack_angle", "tilt", "launch_direction", "bearing")},
    **{name: (fine(name, SPORT)[0], bounds(name, SPORT).can_be[1]) for name in ("bat_speed", "release_speed")},
    "plate_speed": bounds("pitch_speed", SPORT).can_be,
    "attack_to_right": fine("attack_direction"),
    **dict.fromkeys(("map_x", "map_y"), fine("map_position")),
    **{f"{name}_{axis}": fine(name) for name in ("velocity", "acceleration") for axis in "xyz"},
}
"""SI, what is fine for a measurement (a pressure: at sea level); beyond it stands for something missing (0, -9999) or a
slip, and is missing. Fast bats and pitches stay as long as they are possible: whether a column is in another unit shows
in what is usual of many (`doubts`).
Exit speed and launch angle decide by themselves whether a row counts."""
DATES = ("%Y-%m-%d", "%m/%d/%Y", "%m/%d/%y", "%Y/%m/%d", "%d.%m.%Y", "%Y%m%d", "%m-%d-%Y", "%d-%b-%Y")
SWAPPED = {"%m/%d/%Y": "%d/%m/%Y", "%m/%d/%y": "%d/%m/%y", "%m-%d-%Y": "%d-%m-%Y"}
"""Formats of dates that begin with the day."""
WORDED_DATES = ("%b %d, %Y", "%B %d, %Y", "%d %b %Y", "%d %B %Y")
CLOCK = r",?\s+\d{1,2}:\d{2}.*$"
"""A time of the day behind a date in words."""
SERIAL, SERIAL_ZERO = r"^([3-6]\d{4})(?:\.\d+)?$", date(1899, 12, 30)
"""A day as spreadsheets count them, from 1982 to 2091."""
POINTED = r"^-?\d{1,3}(?:\.\d{3})+,\d+$"
THOUSANDS = r"^-?\d{1,3}(?:,\d{3})+\.\d*$|^-?\d{1,3}(?:,\d{3}){2,}$"
"""Numbers with thousands set off, 1.234,5 and 1,234.5; 2,345 alone may be a decimal comma."""
FIRST_YEAR = 1900
"""Before which 04/02/24 is no date of the year 24."""
IN_PLAY = "in ?play|hit_into_play"
FOUL, TIP = "foul", "foul.?tip"
BUNTED = ("event", "words", "batted_type", "description")
"""Quantities that may report a bunt."""
REASONED = ("exit_speed", "launch_angle", "description", "result_type", "launch_confidence", *BUNTED)
"""Quantities that a row's reason hangs on."""
UNSURE: Mapping[str, tuple[tuple[str, ...], tuple[str, ...]]] = {
    "launch_confidence": (("estimated",), ("exit_speed", "launch_angle", "launch_direction")),
    "landing_confidence": (("low", "estimated", "undefined"), ("distance", "hang_time")),
}
"""Confidences of a radar: words that say that it did not measure something, and what that is then missing."""
SIDED, DATED = ("bats", "bats_left"), ("date", "year")
"""Quantities that tell the batter's side, and the day and season."""
MISSING = {"left": pl.Boolean, "day": pl.Date}
"""What stands in every row even where a table does not tell it."""
SELDOM = 2
"""Times that a text must stand in a column on average for it to pay to change every text once."""
FAR = 1 << 31
"""Whole numbers from which on each is changed by itself."""
NUMBERS = [kind for kind in UNITS if kind != "text"]


def rows_of(frame: pl.DataFrame, headings: Headings, *, first: int = 0) -> pl.DataFrame:
    """Return rows with a column per quantity that the table has, in SI, ``row`` in front and ``reason`` behind.

    ``first``: number of the first of them in the table, from 0. Also ``left`` (batter's side), ``day``, ``season``,
    ``unreadable`` (how many measurements of the row were written so that no number could be read, and whether its date
    was) and ``beyond`` (how many cannot be).
    """
    columns, kinds = headings.columns, frame.schema
    words = {name: Texts(frame[column.heading]) for name, column in columns.items() if column.kind == "text"}
    selected = frame.select(
        *(_number(kinds, column).alias(name) for name, column in columns.items() if column.kind != "text"),
        *(
            _lost(kinds, column).alias(f"lost {name}")
            for name, column in columns.items()
            if column.kind != "text" and not kinds[column.heading].is_numeric()
        ),
    ).with_columns(*(text.column.alias(name) for name, text in words.items()))
    lost = [name for name in selected.columns if name.startswith("lost ")]
    selected, beyond = _possible(_measured(selected))
    read_out = {name: words[of].turned(change) for name, (of, change) in _conversions(headings).items()}
    return (
        selected.with_row_index("row", offset=first)
        .with_columns(
            *(series.alias(name) for name, series in read_out.items()),
            unreadable=pl.sum_horizontal(lost) if lost else pl.lit(0, pl.Int32),
            beyond=beyond,
            **{name: pl.lit(None, kind) for name, kind in MISSING.items() if name not in read_out},
        )
        .with_columns(season=_season(headings), unreadable=pl.col("unreadable") + _undated(headings))
        .drop(lost)
        .with_columns(reason=_reason(headings))
        .drop(name for name in read_out if name not in MISSING)
    )


def by_value(column: pl.Series, change: Callable[[pl.Expr], pl.Expr]) -> pl.Series:
    """Return the changed values of a column; every text is changed once, however often it stands there.

    >>> by_value(pl.Series(["a", "b", None, "a"]), lambda text: text.str.to_uppercase()).to_list()
    ['A', 'B', None, 'A']
    """
    codes, values = coded(column)
    if len(values) > len(column) // SELDOM:
        return pl.select(change(pl.lit(column))).to_series()
    return pl.select(change(pl.lit(values))).to_series().gather(codes)


def by_number(column: pl.Series, change: Callable[[pl.Expr], pl.Expr]) -> pl.Series:
    """Return the changed values of a column of whole numbers or days; close together, each is changed once.

    >>> by_number(pl.Series([2024, None, 2026]), lambda number: number.cast(pl.String)).to_list()
    ['2024', None, '2026']
    """
    number = column.to_physical()
    least, most = number.min(), number.max()
    if not (isinstance(least, int) and isinstance(most, int)) or most >= FAR or most - least > len(column) // SELDOM:
        return pl.select(change(pl.lit(column))).to_series()
    every = pl.Series(range(least, most + 1), dtype=number.dtype).cast(column.dtype)
    return pl.select(change(pl.lit(every))).to_series().gather((number.cast(pl.Int64) - least).cast(pl.UInt32))


def coded(column: pl.Series) -> tuple[pl.Series, pl.Series]:
    """Return the index of the value in each row of a column of texts, and the values; in one pass over the rows."""
    categories = pl.Categories.random()
    coded = column.cast(pl.Categorical(categories))
    return coded.to_physical(), categories.to_series()


class Texts:
    """A column of texts without blanks about them and without the ``.0`` of whole numbers, and what they turn into.

    ``column``: as the table has it.
    """

    def __init__(self, column: pl.Series) -> None:
        self.number: pl.Series | None = None
        if column.dtype.is_integer():
            self.column = by_number(column, lambda number: number.cast(pl.String))
            return
        text = column.cast(pl.String)
        self.column = text
        codes, values = coded(text)
        if len(values) > len(text) // SELDOM:
            self.column = pl.select(tidy(pl.lit(text))).to_series()
            return
        self.values, self.number = pl.select(tidy(pl.lit(values))).to_series(), codes
        if not self.values.equals(values, null_equal=True):
            self.column = self.values.gather(self.number)

    def turned(self, change: Callable[[pl.Expr], pl.Expr]) -> pl.Series:
        """Return the changed texts."""
        if self.number is None:
            return by_value(self.column, change)
        return pl.select(change(pl.lit(self.values))).to_series().gather(self.number)


def tidy(text: pl.Expr) -> pl.Expr:
    """Return texts without blanks about them and without the ``.0`` of whole numbers; `ABSENT` ones are missing."""
    plain = text.str.strip_chars().str.replace(r"^(\d+)\.0$", "$1")
    return pl.when(~plain.is_in(ABSENT)).then(plain)


def _measured(rows: pl.DataFrame) -> pl.DataFrame:
    """Return rows without what the table itself says was guessed."""
    for confidence, (_, quantities) in UNSURE.items():
        if confidence in rows.columns:
            guessed = rows.select(is_unsure(confidence)).to_series()
            held = [name for name in quantities if name in rows.columns]
            rows = rows.with_columns(pl.when(~guessed).then(pl.col(name)).alias(name) for name in held)
    return rows


def is_unsure(confidence: str) -> pl.Expr:
    """Return whether a table says that the launch or the landing of a ball was not measured.

    ``confidence``: a key of `UNSURE`.
    """
    words, _ = UNSURE[confidence]
    return pl.col(confidence).str.to_lowercase().is_in(words).fill_null(value=False)


def _possible(rows: pl.DataFrame) -> tuple[pl.DataFrame, pl.Expr]:
    """Return rows without impossible measurements, and the number of these by quantity."""
    names = [name for name in POSSIBLE if name in rows.columns]
    if not names:
        return rows, pl.lit(0, pl.UInt32)
    found = rows.select(
        *(pl.col(name).min() for name in names), *(pl.col(name).max().alias(f"{name} most") for name in names)
    ).row(0, named=True)
    beyond = [
        name
        for name in names
        if found[name] is not None
        and not POSSIBLE[name][0] <= found[name] <= found[f"{name} most"] <= POSSIBLE[name][1]
    ]
    wrong = {name: ~pl.col(name).is_between(*POSSIBLE[name]) for name in beyond}
    on_map = [found.get(name) for name in ("map_x", "map_y")]
    if all(least is not None and least <= 0 for least in on_map):
        nowhere = (pl.col("map_x") == 0) & (pl.col("map_y") == 0)
        wrong |= {name: wrong.get(name, pl.lit(value=False)) | nowhere for name in ("map_x", "map_y")}
    if not wrong:
        return rows, pl.lit(0, pl.UInt32)
    flags = rows.select(condition.fill_null(value=False).alias(name) for name, condition in wrong.items())
    hit = flags.columns
    possible = rows.with_columns(pl.when(~flags[name]).then(pl.col(name)).alias(name) for name in hit)
    return possible, pl.lit(flags.select(pl.sum_horizontal(hit).cast(pl.UInt32)).to_series())


def _undated(headings: Headings) -> pl.Expr:
    """Return 1 for rows whose date is written so that no day could be read."""
    if not headings.has("date"):
        return pl.lit(0, pl.Int32)
    return (pl.col("date").is_not_null() & pl.col("day").is_null()).cast(pl.Int32)


def _number(kinds: pl.Schema, column: TableColumn) -> pl.Expr:
    value = _as_float(kinds, column)
    return pl.when(value.is_finite()).then(column.zero + column.factor * value)


def _as_float(kinds: pl.Schema, column: TableColumn) -> pl.Expr:
    held = pl.col(column.heading)
    if kinds[column.heading].is_numeric():
        return held.cast(pl.Float64)
    return _bare(held.cast(pl.String).str.strip_chars(), column).cast(pl.Float64, strict=False)


def _bare(text: pl.Expr, column: TableColumn) -> pl.Expr:
    """Return numbers as people write them in the form that computers read: no unit, no thousands, a decimal point."""
    sizes = UNITS[column.kind]
    same = [re.escape(unit).replace("_", "[ _/]?") for unit, size in sizes.items() if size == sizes.get(column.unit)]
    if same:
        text = text.str.replace(rf"(?i)\s*(?:{'|'.join(same)})\.?$", "")
    text = text.str.replace("\u2212", "-", literal=True)
    text = pl.when(text.str.contains(POINTED)).then(text.str.replace_all(".", "", literal=True)).otherwise(text)
    text = pl.when(text.str.contains(THOUSANDS)).then(text.str.replace_all(",", "", literal=True)).otherwise(text)
    if column.kind == "spin":  # no device reports 2.345 turns a minute
        text = text.str.replace(r"^(\d{1,3})[.,](\d{3})$", "$1$2")
    return text.str.replace(r"^(-?\d+),(\d+)$", "$1.$2")


def _lost(kinds: pl.Schema, column: TableColumn) -> pl.Expr:
    text = pl.col(column.heading).cast(pl.String).str.strip_chars()
    written = text.is_not_null() & ~text.is_in(ABSENT)
    return (written & _as_float(kinds, column).is_null()).cast(pl.Int32)


def _conversions(headings: Headings) -> dict[str, tuple[str, Callable[[pl.Expr], pl.Expr]]]:
    """Return the quantities that are read out of texts, each with the conversion of its text."""
    conversions: dict[str, tuple[str, Callable[[pl.Expr], pl.Expr]]] = {}
    if headings.has("bats"):
        conversions["left"] = ("bats", _left)
    elif headings.has("bats_left"):
        conversions["left"] = (
            "bats_left",
            lambda text: text.str.to_lowercase().is_in(["1", "true", "l", "left", "yes"]),
        )
    if headings.has("date"):
        conversions["day"] = ("date", partial(_day, day_first=headings.columns["date"].unit == DAY_FIRST))
    if headings.has("description"):
        conversions["in play"] = ("description", lambda text: text.str.to_lowercase().str.contains(IN_PLAY))
        conversions["fouled"] = ("description", _fouled)
    if headings.has("result_type"):
        conversions["result in play"] = ("result_type", lambda text: text.str.to_uppercase() == "X")
    for name in BUNTED:
        if headings.has(name):
            conversions[f"bunted by {name}"] = (name, _bunted_in_words if name == "words" else _bunted)
    return conversions


def _left(text: pl.Expr) -> pl.Expr:
    """Return whether a batter stood on the left; a switch hitter's S, or Undefined, tells no side."""
    first = text.str.slice(0, 1).str.to_lowercase()
    return pl.when(first.is_in(["l", "r"])).then(first == "l")


def _bunted(text: pl.Expr) -> pl.Expr:
    return text.str.to_lowercase().str.contains("bunt")


def _bunted_in_words(text: pl.Expr) -> pl.Expr:
    """Return whether a sentence tells of a bunt; names of people, which begin with a capital, do not count."""
    return text.str.contains(r"\bbunt")


def _fouled(text: pl.Expr) -> pl.Expr:
    what = text.str.to_lowercase()
    return what.str.contains(FOUL) & ~what.str.contains(TIP)


def _day(text: pl.Expr, *, day_first: bool) -> pl.Expr:
    first = text.str.split(" ").list.first().str.split("T").list.first()
    words = text.str.replace(CLOCK, "")
    forms = [SWAPPED.get(form, form) for form in DATES] if day_first else DATES
    serial = pl.lit(SERIAL_ZERO) + pl.duration(days=first.str.extract(SERIAL).cast(pl.Int32))
    days = (
        serial,
        *(first.str.to_date(form, strict=False) for form in forms),
        *(words.str.to_date(form, strict=False) for form in WORDED_DATES),
    )
    return pl.coalesce(*(pl.when(day.dt.year() >= FIRST_YEAR).then(day) for day in days))


def _season(headings: Headings) -> pl.Expr:
    day = pl.col("day").dt.year()
    if headings.has("year"):
        return pl.coalesce(pl.col("year").cast(pl.Float64, strict=False).cast(pl.Int32, strict=False), day)
    return day


def _reason(headings: Headings) -> pl.Expr:
    """Return the first reason that holds for a row; duplicates are found across files, elsewhere."""
    conditions = list(_conditions(headings))
    chain: pl.Expr = pl.lit(USED)
    for word, condition in reversed(conditions):
        chain = pl.when(condition).then(pl.lit(word)).otherwise(chain)
    return chain


def _conditions(headings: Headings) -> Iterator[tuple[str, pl.Expr]]:
    if headings.has("description"):
        played = pl.col("in play").fill_null(value=True)  # nothing said of it: it has an exit speed, or is untracked
        if headings.has("result_type"):
            played = played | pl.col("result in play").fill_null(value=False)
        yield "foul", ~played & pl.col("fouled")
        yield "no contact", ~played
    elif headings.has("result_type"):
        yield "no contact", ~pl.col("result in play").fill_null(value=True)
    bunted = pl.lit(value=False)
    for name in BUNTED:
        if headings.has(name):
            bunted = bunted | pl.col(f"bunted by {name}").fill_null(value=False)
    yield "bunt", bunted
    yield "untracked", pl.col("exit_speed").is_null()
    steep = (
        ~_near(pl.col("launch_angle"), "tracked_launch_angle").fill_null(value=True)
        if headings.has("launch_angle")
        else False
    )
    yield "impossible", ~_near(pl.col("exit_speed"), "exit_speed") | steep


def _near(value: pl.Expr, quantity: str) -> pl.Expr:
    """Return whether a value is fine for its quantity, its bounds included whatever it is rounded to."""
    low, high = fine(quantity, SPORT)
    return value.is_between(low - 1e-5, high + 1e-5)

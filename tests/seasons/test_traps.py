"""Every trap of a table has its warning, with the count and the rows that it concerns; the page lists them all."""

from __future__ import annotations

import re
from collections.abc import Callable
from datetime import date
from pathlib import Path
from typing import Any

import polars as pl
import pytest

from sweetspot.errors import InputError
from sweetspot.seasons.season_table import analyse_season, season_setting
from sweetspot.seasons.table_file import WARNINGS
from tests.seasons.conftest import made_up

ROW = pl.int_range(pl.len())
ALL: list[int] = []
"""Rows of a trap that concerns a whole table."""
PAGE = Path(__file__).parents[2] / "docs" / "theory" / "season.md"
Trap = tuple[Callable[[], pl.DataFrame | str], int, list[int]]


def changed(rows: int, **columns: object) -> Callable[[], pl.DataFrame]:
    """Return a made-up table with other values in its first rows."""
    values = {name: pl.when(rows > ROW).then(pl.lit(value)).otherwise(pl.col(name)) for name, value in columns.items()}
    return lambda: made_up().with_columns(**values)


def without(*columns: str, year: int = 2024) -> Callable[[], pl.DataFrame]:
    return lambda: made_up(year=year).drop(columns)


def many() -> pl.DataFrame:
    frame = pl.concat([made_up(500, seed=seed) for seed in range(50)])
    return frame.with_columns(game_pk=ROW, hc_x=pl.col("hc_x") + ROW * 1e-3)


def days() -> pl.DataFrame:
    return made_up().with_columns(game_date=pl.Series([date(2024, 4, 1)] * 20 + [date(2024, 5, 1)] * 40))


TRAPS: dict[str, Trap] = {
    "plate reference": (lambda: made_up(year=2026), 60, [2, 3, 4]),
    "plate not moved": (without("vx0", "vy0", "vz0", "ax", "ay", "az", year=2026), 60, [2, 3, 4]),
    "export cut": (many, 25_000, ALL),
    "days missing": (days, 1, [22]),
    "torn": (lambda: made_up().write_csv()[:-100], 1, [61]),
    "untracked": (changed(3, launch_speed=None), 3, [2, 3, 4]),
    "name of the pitcher": (made_up, 60, ALL),
    "bunts": (changed(2, des="Somebody bunts out."), 2, [2, 3]),
    "foul tips": (changed(2, description="foul_tip", type="S"), 2, [2, 3]),
    "fouls": (changed(2, description="foul", type="S"), 2, [2, 3]),
    "duplicates": (lambda: pl.concat([made_up(), made_up().head(2)]), 2, [62, 63]),
    "cannot find duplicates": (lambda: made_up().select("launch_speed", "launch_angle"), 60, ALL),
    "spin not used": (lambda: made_up().with_columns(hit_spin_rpm=pl.lit(2500)), 60, ALL),
    "part off": (without("bat_speed"), 60, ALL),
    "headings": (lambda: made_up().with_columns(exit_velocity_mph="launch_speed"), 60, ALL),
    "replaced": (lambda: made_up().with_columns(carry_ft=pl.lit(1.0)), 60, ALL),
    "unreadable": (lambda: made_up().with_columns(
        bat_speed=pl.when(ROW < 2).then(pl.lit("fast")).otherwise(pl.col("bat_speed").cast(pl.String))), 2, [2, 3]),
    "cannot be": (changed(2, bat_speed=0.0), 2, [2, 3]),
    "placeholders": (changed(6, launch_speed=82.9, launch_angle=-21), 6, [2, 3, 4]),
    "other games": (lambda: made_up().with_columns(
        game_type=pl.when(ROW < 2).then(pl.lit("S")).otherwise(pl.lit("R"))), 2, [2, 3]),
    "swapped": (changed(60, launch_speed=70.0, bat_speed=90.0), 60, [2, 3, 4]),
    "unit": (lambda: made_up().with_columns(pl.col("launch_angle") * 0.01745), 60, [2, 3, 4]),
    "impossible": (changed(2, launch_speed=999.0), 2, [2, 3]),
    "empty column": (changed(60, bat_speed=None), 60, ALL),
    "side unknown": (changed(2, stand="S"), 2, [2, 3]),
    "pitch speed unknown": (lambda: made_up().drop("vx0", "vy0", "vz0").with_columns(
        release_speed=pl.when(ROW > 1).then("release_speed")), 2, [2, 3]),
    "selected": (changed(60, events="home_run"), 60, ALL),
    "not measured": (lambda: made_up().with_columns(
        hit_landing_confidence=pl.when(ROW < 2).then(pl.lit("Low")).otherwise(pl.lit("High"))), 2, [2, 3]),
    "unknown park": (changed(2, home_team="Yomiuri"), 2, [2, 3]),
}  # fmt: skip
"""By the warning: a table that walks into the trap, how many rows it concerns, and the first of them."""


@pytest.mark.parametrize("name", WARNINGS)
def test_a_trap_is_named_with_its_rows(name: str, tmp_path: Path) -> None:
    make, count, rows = TRAPS[name]
    made, path = make(), tmp_path / "table.csv"
    path.write_text(made, "utf-8") if isinstance(made, str) else made.write_csv(path)
    season = analyse_season([path], setting=season_setting(contact=False), folder=tmp_path / "out")
    found = [one for one in season.survey.warnings if one.name == name]
    assert [(one.count, one.rows[:3]) for one in found] == [(count, rows)]


UNITS: dict[str, tuple[dict[str, pl.Expr], str]] = {
    "bat speed in m/s": ({"bat_speed": pl.col("bat_speed") * 0.447}, r"bat_speed is 31\.\d mph .* are they m_s\?"),
    "bat speed in km/h": ({"bat_speed": pl.col("bat_speed") * 1.609}, r"bat_speed is 114 mph .* are they km_h\?"),
    "exit speed in m/s": ({"launch_speed": pl.col("launch_speed") * 0.447}, r"launch_speed is 3\d.* are they m_s\?"),
    "exit speeds, a third of them too fast": ({"launch_speed": pl.col("launch_speed") * 1.3}, "many exit speeds"),
    "pitch speed in m/s": ({"release_speed": pl.col("release_speed") * 0.447}, r"release_speed is .* are they m_s\?"),
    "attack angle in radians": ({"attack_angle": pl.col("attack_angle") * 0.01745}, "no attack_angle .* radians"),
    "tilt in radians": ({"swing_path_tilt": pl.col("swing_path_tilt") * 0.01745}, "no swing_path_tilt .* radians"),
    "place in m": ({"plate_z": pl.col("plate_z") * 0.3048}, r"plate_z is 0\.7\d+ ft .* are they m\?"),
    "distance in m": ({"hit_distance_sc": pl.col("hit_distance_sc") * 0.3048}, r"hit_distance_sc is 12\d ft .*"),
    "Celsius as Fahrenheit": ({"temperature_f": pl.lit(25.0)}, "temperature_f is 25 °F .* are they degc"),
    "pressure at the field": ({"pressure_hpa": pl.lit(975.0)}, "pressure_hpa is 975 hPa .* reduced to sea level"),
    "humidity as a ratio": ({"humidity_%": pl.lit(0.5)}, r"humidity_% is 0\.5 % .* are they ratio"),
}


@pytest.mark.parametrize("ending", ["csv", "parquet"])
@pytest.mark.parametrize("what", UNITS)
def test_a_column_in_another_unit_is_doubted(what: str, ending: str, tmp_path: Path) -> None:
    """And no other column with it; a Parquet file tells ranges by itself, so not all columns are read."""
    change, words = UNITS[what]
    made = made_up(300).with_columns(**change)
    path = tmp_path / f"table.{ending}"
    made.write_csv(path) if ending == "csv" else made.write_parquet(path)
    season = analyse_season([path], setting=season_setting(contact=False), folder=tmp_path / "out")
    (found,) = [one for one in season.survey.warnings if one.name in ("unit", "swapped")]
    assert found.name == "unit" and re.match(words, found.detail), found


@pytest.mark.parametrize(("change", "words"), [
    ({"launch_speed": pl.col("launch_speed") * 1.609}, "launch_speed is 1[56]\\d mph in the median.* are they km_h"),
    ({"launch_speed": "launch_angle", "launch_angle": "launch_speed"}, "exit speed and launch angle"),
])  # fmt: skip
def test_a_table_of_which_most_cannot_be_is_refused(change: dict[str, Any], words: str, tmp_path: Path) -> None:
    """In km/h, and with speeds and angles exchanged; what is left would be no sample of anything."""
    path = tmp_path / "table.csv"
    made_up(300).with_columns(pl.col("launch_speed") * 1.15).with_columns(**change).write_csv(path)
    with pytest.raises(InputError, match=f"of 300 balls .*cannot be.*{words}.*--column"):
        analyse_season([path], setting=season_setting(contact=False), folder=tmp_path / "out")


def test_a_table_without_traps_has_few_warnings(tmp_path: Path) -> None:
    """So that the others are of what was changed: its gaps of days, and whose name stands there."""
    made_up().write_csv(tmp_path / "table.csv")
    season = analyse_season([tmp_path / "table.csv"], setting=season_setting(contact=False), folder=tmp_path / "out")
    assert {one.name for one in season.survey.warnings} == {"days missing", "name of the pitcher"}


def test_the_page_lists_every_trap() -> None:
    table = PAGE.read_text("utf-8").split("## Traps")[1].split("\n## ")[0]
    assert set(re.findall(r"\| `([a-z ]+)` \|", table)) == set(WARNINGS)

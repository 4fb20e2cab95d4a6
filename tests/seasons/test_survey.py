"""The ledger adds up, every trap has its warning, and one bad file never stops the others."""

from __future__ import annotations

import gzip
from collections.abc import Callable
from datetime import date
from pathlib import Path

import numpy as np
import polars as pl
import pytest

from sweetspot.answers.season import season_answer
from sweetspot.answers.season_question import SeasonQuestion
from sweetspot.errors import InputError
from sweetspot.reports.season.document import season_document
from sweetspot.seasons import duplicates, plan, rows, table_copies
from sweetspot.seasons.balls import balls_of
from sweetspot.seasons.batters import require_batter
from sweetspot.seasons.rows import REASONS, USED, rows_of
from sweetspot.seasons.season_table import analyse_season, season_setting
from sweetspot.seasons.survey import Survey, survey_tables, tracking_bias
from sweetspot.seasons.table_file import open_table
from tests.seasons.conftest import made_up

Write = Callable[..., Path]


def look(*paths: Path) -> Survey:
    return survey_tables(list(paths), staging=paths[0].parent / "staging")


def warned(found: Survey, name: str) -> int:
    return sum(warning.count for warning in found.warnings if warning.name == name)


def with_columns(**changes: object) -> pl.DataFrame:
    return made_up().with_columns(**{name: pl.lit(value) for name, value in changes.items()})


def test_the_ledger_adds_up_to_the_row(table: Write) -> None:
    frame = made_up()
    what = ["ball", "foul", "foul_tip", "swinging_strike", "called_strike"] * 4 + ["hit_into_play"] * 40
    frame = frame.with_columns(description=pl.Series(what), type=pl.Series(["B"] * 20 + ["X"] * 40))
    found = look(table(frame=frame))
    assert sum(found.counts[0].values()) == 60
    assert found.counts[0] == {
        "duplicate": 0, "no contact": 16, "foul": 4, "bunt": 0, "untracked": 0, "impossible": 0, USED: 40,
    }  # fmt: skip
    assert warned(found, "foul tips") == 4  # among the misses
    assert warned(found, "fouls") == 4


def test_a_damaged_page_of_one_file_does_not_keep_the_others(table: Write, tmp_path: Path) -> None:
    """The footer is whole, so that a file with a lost block opens; its pages do not."""
    good, torn = table(), tmp_path / "torn.parquet"
    made_up().write_parquet(torn)
    content = bytearray(torn.read_bytes())
    start, end = len(content) // 8, len(content) // 4
    content[start:end] = b"\xff" * (end - start)
    torn.write_bytes(content)
    found = look(good, torn)
    assert [one.path for one in found.tables] == [good]
    assert [path for path, _ in found.faults] == [torn]
    assert "is no whole Parquet file" in found.faults[0][1]


def test_untracked_is_not_zero(table: Write) -> None:
    frame = (
        made_up()
        .drop("hc_x", "hc_y")
        .with_columns(
            launch_speed=pl.when(pl.int_range(pl.len()) % 5 == 0).then(None).otherwise(pl.col("launch_speed")),
            bb_type=pl.when(pl.int_range(pl.len()) % 2 == 0).then(pl.lit("popup")).otherwise(pl.lit("line_drive")),
        )
    )
    found = look(table(frame=frame))
    assert found.counts[0]["untracked"] == warned(found, "untracked") == 12
    bias = tracking_bias(found)
    assert bias is not None and bias.share == pytest.approx(0.2)
    used = rows_of(frame, found.tables[0].headings).filter(pl.col("reason") == USED)
    assert bias.mean_exit_speed_of_tracked == pytest.approx(used["exit_speed"].mean())
    table_of = used.group_by("event", "batted_type").agg(pl.col("exit_speed").mean())
    means = {(event, kind): mean for event, kind, mean in table_of.iter_rows()}
    lost = frame.filter(pl.col("launch_speed").is_null()).select("events", "bb_type").iter_rows()
    total = used["exit_speed"].sum() + sum(means.get(ending, bias.mean_exit_speed_of_tracked) for ending in lost)
    assert bias.mean_exit_speed_of_all == pytest.approx(total / 60)


def test_bunts_arrive_as_balls_in_play(table: Write) -> None:
    frame = made_up().with_columns(
        des=pl.when(pl.int_range(pl.len()) < 3).then(pl.lit("Somebody bunts out.")).otherwise(pl.col("des"))
    )
    found = look(table(frame=frame))
    assert found.counts[0]["bunt"] == warned(found, "bunts") == 3


def test_the_name_is_the_pitcher_s(table: Write) -> None:
    assert warned(look(table()), "name of the pitcher") == 60


def test_pitches_of_overlapping_exports_count_once(table: Write) -> None:
    frame = made_up()
    found = look(table("first.csv", frame.head(40)), table("second.csv", frame.tail(30)))
    assert [counts["duplicate"] for counts in found.counts] == [0, 10]
    assert warned(found, "duplicates") == 10
    bare = frame.drop("at_bat_number", "pitch_number")  # then whatever was measured tells
    assert look(table("bare.csv", pl.concat([bare, bare.head(7)]))).counts[0]["duplicate"] == 7
    nobody = frame.select("launch_speed", "launch_angle", "bat_speed")
    assert warned(look(table("nobody.csv", nobody)), "cannot find duplicates") == 60


def test_pitches_are_the_same_however_their_numbers_are_written(table: Write, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(duplicates, "MOST_KEYS", 25)  # gone through five times
    other = made_up().with_columns(pl.col("at_bat_number").cast(pl.Float64), pl.col("game_pk").cast(pl.String))
    found = look(table("first.parquet"), table("other.parquet", pl.concat([other, other.head(3)])))
    assert [counts["duplicate"] for counts in found.counts] == [0, 63]


def test_cut_exports_and_missing_days(table: Write) -> None:
    frame = pl.concat([made_up(500, seed=seed) for seed in range(50)])
    found = look(table("cut.parquet", frame.with_columns(game_pk=pl.int_range(pl.len()))))
    assert warned(found, "export cut") == 25_000
    days = [date(2024, 4, 1)] * 30 + [date(2024, 5, 1)] * 30
    gap = look(table("gap.csv", made_up().with_columns(game_date=pl.Series(days))))
    assert [warning.detail for warning in gap.warnings if warning.name == "days missing"] == [
        "between 2024-04-01 to 2024-05-01"
    ]


def test_swapped_columns_and_other_units_are_doubted(table: Write) -> None:
    frame = made_up()
    ball, bat = frame["launch_speed"], pl.Series("bat_speed", [72.0] * len(frame))
    swapped = frame.with_columns(launch_speed=bat, bat_speed=ball.fill_null(95.0) + 20)
    assert warned(look(table("swapped.csv", swapped)), "swapped") > 0
    flat = frame.with_columns(launch_angle=pl.col("launch_angle") * 0.01745)
    assert warned(look(table("flat.csv", flat)), "unit") > 0
    assert not {"swapped", "unit"} & {warning.name for warning in look(table("good.csv", frame)).warnings}


def test_a_torn_file_says_so(table: Write) -> None:
    path = table()
    path.write_bytes(path.read_bytes()[:-120])
    found = look(path)
    assert warned(found, "torn") == 1
    packed = path.with_suffix(".csv.gz")
    packed.write_bytes(gzip.compress(table("whole.csv").read_bytes())[:-200])
    assert "damaged" in look(packed).faults[0][1]


def test_the_plate_s_reference_moves_in_2026(table: Write) -> None:
    found = look(table(frame=made_up(year=2026)))
    assert warned(found, "plate reference") == 60
    assert warned(look(table("old.csv")), "plate reference") == 0
    bare = made_up(year=2026).drop("vx0", "vy0", "vz0", "ax", "ay", "az")
    assert warned(look(table("bare.csv", bare)), "plate not moved") == 60


def test_pitches_of_2026_are_flown_to_the_front_edge() -> None:
    """A pitch that passes the middle 8.5 in later has come down by then; at the front edge it is higher."""
    old, new = made_up(year=2025), made_up(year=2026)
    headings = look_headings(old)
    before, after = (balls_of(rows_of(frame, headings)) for frame in (old, new))
    assert after.moved.all() and not before.moved.any()
    drop = after.plate_height - before.plate_height
    expected = 8.5 * 0.0254 * np.tan(before.descent)
    np.testing.assert_allclose(drop, expected, rtol=0.03, atol=2e-4)


@pytest.mark.parametrize("ends", ["\n", "\r\n"])
def test_rows_of_csv_are_numbered_as_a_spreadsheet_shows_them(
    tmp_path: Path, ends: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Lines above the headings, blank ones, totals and cells of several lines do not move them."""
    path = tmp_path / "table.csv"
    lines = ["Player ID:,7", "", "remarks,ExitVelocity,LaunchAngle", "a,90,12", '"one', 'two",,', "", "b,999,12",
             "Total,1182,", "c,95,12", "d,998,12"]  # fmt: skip
    path.write_bytes(ends.join([*lines, ""]).encode())
    sheet = {"90": 4, "999": 7, "95": 9, "998": 10}  # the remark of two lines is one row of the sheet
    monkeypatch.setattr(plan, "TASK_ROWS", 2)
    answer = season_answer(SeasonQuestion(paths=[path], contact=False, folder=tmp_path / "out"))
    season, rows = answer.season, {caution.name: caution.tables[0].first_rows for caution in answer.warnings}
    assert rows["impossible"] == [sheet["999"], sheet["998"]]
    assert season.balls().select("table_row").collect()["table_row"].to_list() == [sheet["90"], sheet["95"]]
    assert season.ledger().collect()["table_row"].to_list() == list(sheet.values())
    words = " ".join(str(block) for block in season_document(answer).blocks)
    assert "the numbers that a spreadsheet shows" in words
    made_up(10).write_parquet(tmp_path / "table.parquet")
    bare = analyse_season([tmp_path / "table.parquet"], setting=season_setting(contact=False), folder=tmp_path / "out")
    assert bare.ledger().collect()["table_row"].to_list() == list(range(1, 11))


def look_headings(frame: pl.DataFrame):  # type: ignore[no-untyped-def]
    from sweetspot.seasons.headings import headings_of

    return headings_of(frame.columns)


def test_numbers_as_people_write_them(tmp_path: Path) -> None:
    path = tmp_path / "wild.csv"
    path.write_text("launch_speed,launch_angle,game_date\n101.5,20,4/2/2024\nfast,N/A,4/3/2024\n,12,\n", "utf-8")
    found = look(path)
    assert found.counts[0][USED] == 1 and found.counts[0]["untracked"] == 2
    assert warned(found, "unreadable") == 1
    assert found.days[0] == (date(2024, 4, 2), date(2024, 4, 3))


def test_european_tables(tmp_path: Path) -> None:
    path = tmp_path / "europe.csv"
    path.write_text("exit_speed_km_h;launch_angle_deg\n160,5;20\n", "utf-8")
    found = look(path)
    rows = rows_of(found.tables[0].part(0, 10), found.tables[0].headings)
    assert rows["exit_speed"][0] == pytest.approx(160.5 / 3.6)


SPANISH = "game_date,Batter,exit_speed_mph,launch_angle_deg\n" + "".join(
    f"2024-04-{1 + number:02d},Ronald Acuña Jr.,{90 + number}.5,{number - 5}\n" for number in range(20)
)
EUROPEAN = SPANISH.replace(",", ";").replace(".5", ",5")


@pytest.mark.parametrize(
    ("name", "content"),
    [
        ("plain.csv", SPANISH.encode()), ("mark.csv", SPANISH.encode("utf-8-sig")),
        ("windows.csv", SPANISH.encode("cp1252")), ("windows.csv.gz", gzip.compress(SPANISH.encode("cp1252"))),
        ("unicode_text.txt", SPANISH.replace(",", "\t").encode("utf-16")),
        ("big_endian.csv", b"\xfe\xff" + SPANISH.encode("utf-16-be")),
        ("packed.csv.gz", gzip.compress(SPANISH.encode("utf-16"))),
        ("old_mac.csv", SPANISH.replace("\n", "\r").encode()),
        ("european.csv", EUROPEAN.encode("cp1252")), ("not_packed.csv.gz", SPANISH.encode()),
        ("european.txt", EUROPEAN.replace(";", "\t").replace("\n", "\r\n").encode()),
        ("quoted.csv", "".join(",".join(f'"{cell}"' for cell in line.split(",")) + "\n"
                               for line in SPANISH.splitlines()).encode()),
    ],
    ids=lambda value: value if isinstance(value, str) else "",
)  # fmt: skip
def test_text_as_spreadsheets_save_it(tmp_path: Path, name: str, content: bytes) -> None:
    """Whatever the encoding, numbers and accents are the same; where it was guessed, a note says so."""
    path = tmp_path / name
    path.write_bytes(content)
    found = look(path)
    rows = rows_of(found.tables[0].part(0, 20), found.tables[0].headings)
    assert set(rows["batter"]) == {"Ronald Acuña Jr."} and found.days[0] == (date(2024, 4, 1), date(2024, 4, 20))
    np.testing.assert_allclose(rows["exit_speed"], (90.5 + np.arange(20)) * 0.44704)
    np.testing.assert_allclose(rows["launch_angle"], np.radians(np.arange(20) - 5.0), atol=1e-12)
    notes = " ".join(warning.detail for warning in found.warnings)
    assert ("Windows-1252" in notes) == (name in ("windows.csv", "windows.csv.gz", "european.csv"))
    require_batter([path], "Ronald Acuña Jr.")


def test_numbers_with_units_thousands_and_other_minus_signs(tmp_path: Path) -> None:
    path = tmp_path / "typed.csv"
    path.write_text(
        "game_date,exit_speed_km_h,launch_angle_deg,hit_spin_rpm,distance_cm\n"
        '45384,160.5 km/h,\N{MINUS SIGN}20°,"2,345","12,034.5"\n'
        "45385.79,150 KM/H,10 deg,2.210,9000\n",
        "utf-8",
    )
    found = look(path)
    rows = rows_of(found.tables[0].part(0, 2), found.tables[0].headings)
    np.testing.assert_allclose(rows["exit_speed"] * 3.6, [160.5, 150])
    np.testing.assert_allclose(np.degrees(rows["launch_angle"]), [-20, 10])
    np.testing.assert_allclose(rows["distance"], [120.345, 90])
    np.testing.assert_allclose(rows["spin_rate"] * 30 / np.pi, [2345, 2210])
    assert rows["day"].to_list() == [date(2024, 4, 2), date(2024, 4, 3)]  # as spreadsheets count days
    assert warned(found, "unreadable") == 0


def test_a_number_with_another_unit_is_unreadable(tmp_path: Path) -> None:
    path = tmp_path / "other.csv"
    path.write_text("exit_speed_mph,launch_angle_deg\n160 km/h,20\n98 mph,12\n", "utf-8")
    found = look(path)
    assert found.counts[0][USED] == 1 and warned(found, "unreadable") == 1


@pytest.mark.parametrize("more", ["Total,,,,9000.5,12,,\n", ",Average,,,90.5,12,,\n", "{head}\n", ",,,,mph,deg,,\n"])
def test_lines_beside_the_balls_are_left_out_and_told(tmp_path: Path, more: str) -> None:
    """Totals and means below them, the headings again, and a second line of headings with the units."""
    names = ("game_date", "batter", "stand", "home_team", "launch_speed", "launch_angle", "hc_x", "hc_y")
    path = tmp_path / "table.csv"
    made_up().select(names).write_csv(path)
    head, *balls = path.read_text("utf-8").splitlines(keepends=True)
    path.write_text("".join([head, *balls[:30], more.format(head=head.strip()), *balls[30:]]), "utf-8")
    found = look(path)
    assert found.counts[0][USED] == 60 and found.counts[0]["beside"] == 1
    assert found.rows == sum(found.counts[0].values()) == 61
    assert any("1 lines that repeat the headings" in warning.detail for warning in found.warnings)


def test_every_line_of_a_file_stands_in_the_ledger(tmp_path: Path) -> None:
    """Blank lines, lines of delimiters, lines with words where nothing is understood, and a mean at the end."""
    path = tmp_path / "table.csv"
    balls = "".join(f"{90 + number},12,a\n" for number in range(5))
    path.write_text(
        f"launch_speed,launch_angle,remarks\n{balls}\n,,\n,,no reading\nnan,--,\n95,20,b\nmph,deg,\n", "utf-8"
    )
    (read,) = season_answer(SeasonQuestion(paths=[path], contact=False)).tables
    assert read.ledger == {**dict.fromkeys(REASONS, 0), USED: 6, "nothing": 4, "beside": 1}
    assert read.rows == sum(read.ledger.values()) == len(path.read_text("utf-8").splitlines()) - 1 == 11


@pytest.mark.parametrize("held", [True, False])
@pytest.mark.parametrize(
    "text", ["launch_speed,launch_angle\n,\n\n", "launch_speed,launch_angle\nnan,3\n", "a,b\n1,2\n"]
)
def test_tables_that_are_refused_leave_no_folder(tmp_path: Path, text: str, held: bool) -> None:
    """One that was there stays; of a new one nothing, nor of those above it."""
    path, out = tmp_path / "table.csv", tmp_path / "new" / "out"
    path.write_text(text, "utf-8")
    if held:
        out.mkdir(parents=True)
    with pytest.raises(InputError):
        analyse_season([path], setting=season_setting(contact=False), folder=out)
    assert (list(out.iterdir()) == []) if held else not out.parent.exists()


def test_a_cluster_that_does_not_answer_leaves_no_folder(tmp_path: Path) -> None:
    def refused(*_: object) -> None:
        raise InputError("none answers there")

    made_up().write_csv(tmp_path / "table.csv")
    with pytest.raises(InputError, match="none answers"):
        analyse_season(
            [tmp_path / "table.csv"], setting=season_setting(contact=False), folder=tmp_path / "out", run=refused
        )
    assert [one.name for one in tmp_path.iterdir()] == ["table.csv"]


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("exit_speed_mph,launch_angle_deg\n95,10\n100,5,20,5\n", "line 3 has 4 cells under 2 headings"),
        ("exit_speed_mph,launch_angle_deg\n1,95,10\n2,100,20\n", "line 2 has 3 cells under 2 headings"),
        ("", "is packed; let its name end in .csv.gz"),
    ],
)
def test_columns_that_may_be_shifted_are_refused(tmp_path: Path, text: str, words: str) -> None:
    """A decimal comma without quotes, row numbers without a heading: nobody must guess which number is which."""
    path = tmp_path / "table.csv"
    path.write_bytes(text.encode() or gzip.compress(SPANISH.encode()))
    assert words in look(path).faults[0][1]
    path.write_text("exit_speed_mph,launch_angle_deg\n95,10\n100,20,,\n", "utf-8")  # nothing in them
    assert look(path).counts[0][USED] == 2


@pytest.mark.parametrize("late", ["", "95", "95.5", "1e3", "95 mph", "true", "99999999999999999999", "inf"])
@pytest.mark.parametrize("early", ["", "90", "90.5", "word", "false"])
def test_columns_are_what_all_lines_make_them(
    early: str, late: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Types that the first lines suggest are given up where a later line knows better."""
    path = tmp_path / "table.csv"
    rows = [f"100,10,{early}"] * 6 + [f"100.5,10,{late}"] * 3
    path.write_text("\n".join(["launch_speed,launch_angle,bat_speed", *rows]), "utf-8")
    read = []
    for lines in (4, 1000):
        monkeypatch.setattr(table_copies, "BEGUN", lines)
        read.append(open_table(path, staging=tmp_path / str(lines)).part(0, 9))
    assert read[0].equals(read[1], null_equal=True)
    assert late == "inf" or read[0].schema == read[1].schema  # no number by its look


def test_very_many_columns(tmp_path: Path) -> None:
    """Of twice as many columns twice the work; blank lines looked for in all of them took minutes."""
    path, wide = tmp_path / "wide.csv", [f"c{number}" for number in range(3000)]
    path.write_text(",".join(["launch_speed", *wide]) + "\n" + ",".join(["95"] * 3001) + "\n\n", "utf-8")
    found = look(path)
    assert found.tables[0].rows == 1 and found.rows == 2 and len(found.tables[0].headings.passed) == 3000


def test_one_bad_file_never_stops_the_others(table: Write, tmp_path: Path) -> None:
    empty, header, other = tmp_path / "empty.csv", tmp_path / "header.csv", tmp_path / "other.csv"
    empty.touch()
    header.write_text("launch_speed,launch_angle\n", "utf-8")
    other.write_text("a,b\n1,2\n", "utf-8")
    found = look(empty, table(), header, other, tmp_path / "none.csv", tmp_path)
    assert len(found.tables) == 1 and found.rows == 60
    reasons = {path.name: reason for path, reason in found.faults}
    assert "is empty" in reasons["empty.csv"] and "no row" in reasons["header.csv"]
    assert "no column for exit speed" in reasons["other.csv"] and "is not a file" in reasons["none.csv"]
    assert all("\n" not in reason for reason in reasons.values())


def test_what_cannot_be_is_missing_and_named(table: Write) -> None:
    """Zeros and -9999 that stand for nothing, in six rows of sixty, each in another column."""
    slips = {"bat_speed": 0.0, "release_speed": 0.0, "plate_x": -9999.0, "attack_angle": 900.0, "hit_distance_sc": -1}
    row, frame = pl.int_range(pl.len()), made_up()
    changes = {
        name: pl.when(row == number).then(value).otherwise(pl.col(name)).alias(name)
        for number, (name, value) in enumerate(slips.items())
    }
    nowhere = {name: pl.when(row == 5).then(0.0).otherwise(pl.col(name)) for name in ("hc_x", "hc_y")}
    found = look(table(frame=frame.with_columns(*changes.values(), **nowhere)))
    assert [one.rows for one in found.warnings if one.name == "cannot be"] == [[2, 3, 4, 5, 6, 7]]
    rows = rows_of(found.tables[0].part(0, 60), found.tables[0].headings)
    lost = [
        rows[name].null_count() for name in ("bat_speed", "release_speed", "plate_side", "attack_angle", "distance")
    ]
    assert lost == [1] * 5 and rows["map_x"].null_count() == rows["map_y"].null_count() == 1
    assert found.counts[0][USED] == 60


def test_placeholders_are_named(table: Write) -> None:
    frame = pl.concat([made_up(seed=seed) for seed in range(10)]).with_columns(game_pk=pl.int_range(pl.len()))
    put_in = pl.int_range(pl.len()) % 20 == 0
    frame = frame.with_columns(
        launch_speed=pl.when(put_in).then(82.9).otherwise(pl.col("launch_speed")),
        launch_angle=pl.when(put_in).then(-20.7).otherwise(pl.col("launch_angle").cast(pl.Float64)),
    )
    found = [one for one in look(table(frame=frame)).warnings if one.name == "placeholders"]
    assert [(one.count, one.rows[:2], one.detail) for one in found] == [(30, [2, 22], "82.9 mph at -20.7 degrees")]


def test_games_elsewhere_have_no_home_park(table: Write) -> None:
    frame = made_up().with_columns(game_type=pl.Series(["S", "R", "E", "A", "F", "D"] * 10))
    path = table(frame=frame)
    assert warned(look(path), "other games") == 30
    balls = analyse_season([path], setting=season_setting(contact=False), folder=path.parent / "out").balls().collect()
    told = balls.group_by("game_type").agg(pl.col("home_run_here").count() > 0).sort("game_type").rows()
    assert told == [("A", False), ("D", True), ("E", False), ("F", True), ("R", True), ("S", False)]


@pytest.mark.parametrize("form", ["%m/%d/%y", "%Y%m%d", "%m-%d-%Y", "%d-%b-%Y", "%B %d, %Y", "%d %b %Y"])
def test_days_as_people_write_them(table: Write, form: str) -> None:
    days = pl.col("game_date").str.to_date().dt.strftime(form)
    found = look(table(frame=made_up().with_columns(game_date=days)))
    assert found.days[0] == (date(2024, 4, 1), date(2024, 8, 25)) and warned(found, "unreadable") == 0


@pytest.mark.parametrize("form", ["%d/%m/%Y", "%d-%m-%Y", "%d/%m/%Y 19:05", "%d/%m/%y"])
@pytest.mark.parametrize("name", ["table.csv", "table.parquet"])
def test_dates_that_begin_with_the_day(table: Write, form: str, name: str) -> None:
    """One day beyond the 12th says how all of a table are written, those that could be either way among them."""
    days = pl.col("game_date").str.to_date().cast(pl.Datetime).dt.strftime(form)
    found = look(table(name, made_up().with_columns(game_date=days)))
    assert found.days[0] == (date(2024, 4, 1), date(2024, 8, 25)) and warned(found, "unreadable") == 0


@pytest.mark.parametrize(
    ("days", "words"),
    [(["05/06/2024"] * 60, "may begin with month or day"), (["25/06/2024", "06/25/2024"] * 30, "the day in others")],
)
def test_dates_that_do_not_tell_are_month_first_and_named(table: Write, days: list[str], words: str) -> None:
    found = look(table(frame=made_up().with_columns(game_date=pl.Series(days))))
    notes = [one.detail for one in found.warnings if one.name == "headings"]
    assert len(notes) == 1 and words in notes[0]
    assert found.days[0] is not None and found.days[0][0].month in (5, 6)


def test_lines_above_the_headings_are_left_out(tmp_path: Path) -> None:
    """As Rapsodo and Blast write them: who it was, then an empty line, then headings in their own units."""
    path = tmp_path / "hits.csv"
    path.write_text(
        '"Player ID:",7\n"Player Name:","Doe, Jo"\n\nNo,Date,HitID,ExitVelocity,LaunchAngle,ExitDirection,Spin\n'
        "1,07/25/2024,1,90.5,12,-3,2000\n2,07/25/2024,2,-,-,-,-\n",
        "utf-8",
    )
    found = look(path)
    assert found.tables[0].headings.system == "Rapsodo" and found.counts[0][USED] == 1
    assert found.counts[0]["untracked"] == 1 and found.days[0] == (date(2024, 7, 25), date(2024, 7, 25))
    notes = [one.detail for one in found.warnings if one.name == "headings"]
    assert notes == ["3 lines above the headings are left out: Player ID:, 7; Player Name:, Doe, Jo; "]


def test_hittrax_s_own_headings(tmp_path: Path) -> None:
    """Of a public report; bats that were not measured stand there as 0."""
    path = tmp_path / "report.csv"
    path.write_text(
        " AB,Date, Time Stamp, Pitch, Strike Zone, P. Type, Velo, LA, Dist, Res, Type, Horiz. Angle, BV, User, Batting"
        "\n1, 11/26/2018 16:08:24.883, 0:0:0.000,60, , N/A,52.9,21,116, 4-3, GB,4,0,Jo Doe,Left\n",
        "utf-8",
    )
    found = look(path)
    rows = rows_of(found.tables[0].part(0, 1), found.tables[0].headings)
    assert rows.select("batter_name", "left", "day").row(0) == ("Jo Doe", True, date(2018, 11, 26))
    assert rows["bat_speed"].to_list() == [None] and rows["launch_direction"][0] == pytest.approx(np.radians(4))


@pytest.mark.parametrize(
    ("headings", "words"),
    [
        ("last_name,player_id,avg_hit_speed,max_hit_speed", "avg_hit_speed is a leaderboard's"),
        ("player_id,launch_speed,launch_angle,batted_ball_events", "batted_ball_events is a leaderboard's"),
        ("Date,Equipment,Bat Speed (mph),Attack Angle (deg)", "swings alone (Bat Speed (mph))"),
    ],
)
def test_tables_of_something_else_are_refused_in_a_line(tmp_path: Path, headings: str, words: str) -> None:
    path = tmp_path / "other.csv"
    path.write_text(f"{headings}\n1,2,3,4\n", "utf-8")
    reason = look(path).faults[0][1]
    assert words in reason and "\n" not in reason


@pytest.mark.parametrize(("name", "words"), [("t.xlsx", "save the sheet as CSV"), ("t.csv.zip", "unpack it")])
def test_files_that_hold_tables_and_are_not_read(tmp_path: Path, name: str, words: str) -> None:
    (tmp_path / name).write_bytes(b"PK\x03\x04\n\r\x00")
    (tmp_path / "t.csv").write_bytes(b"PK\x03\x04\r\n\r\x00\r\x01")  # under another name
    reasons = [reason for _, reason in look(tmp_path / name, tmp_path / "t.csv").faults]
    assert words in reasons[0] and "is a spreadsheet or an archive; save the sheet as CSV" in reasons[1]


def test_the_same_game_in_two_files_counts_once(table: Write) -> None:
    found = look(table(), table("again.parquet"))
    assert [one[USED] for one in found.counts] == [60, 0] and found.counts[1]["duplicate"] == 60


def test_a_day_that_cannot_be_read_is_told(table: Write) -> None:
    days = pl.Series(["45/04/2024", "soon"] + ["2024-04-02"] * 58)
    assert warned(look(table(frame=made_up().with_columns(game_date=days))), "unreadable") == 2


def test_a_switch_hitter_s_letter_tells_no_side(table: Write) -> None:
    sides = pl.Series(["L", "Right", "S", "Undefined", "l", "R"] * 10)
    assert warned(look(table(frame=made_up().with_columns(stand=sides))), "side unknown") == 20


def test_a_name_is_no_bunt(table: Write) -> None:
    words = pl.Series(["Joe Bunting flies out.", "Joe Bunting out on a sacrifice bunt.", "Joe Day bunts out."] * 20)
    assert look(table(frame=made_up().with_columns(des=words))).counts[0]["bunt"] == 40


def test_blank_lines_are_no_balls(table: Write) -> None:
    path = table()
    path.write_text(path.read_text("utf-8") + "\n\n\n", "utf-8")
    found = look(path)
    assert found.tables[0].rows == found.counts[0][USED] == 60
    assert found.rows == 63 and found.counts[0]["nothing"] == 3


def test_lists_and_words_with_units_are_told(table: Write, tmp_path: Path) -> None:
    nested = made_up().with_columns(launch_speed=pl.concat_list("launch_speed"))
    assert "column launch_speed holds List" in look(table("nested.parquet", nested)).faults[0][1]
    path = tmp_path / "units.csv"
    path.write_text("exit_speed_mph,launch_angle_deg\n98 km/h,20\n97 km/h,12\n", "utf-8")
    with pytest.raises(InputError, match="2 rows hold words, or numbers with another unit"):
        analyse_season([path], setting=season_setting(contact=False), folder=tmp_path / "out")


def test_impossible_selected_empty_and_sides(table: Write) -> None:
    frame = made_up().with_columns(
        launch_speed=pl.when(pl.int_range(pl.len()) < 2).then(999.0).otherwise(pl.col("launch_speed")),
        events=pl.lit("home_run"),
        bat_speed=pl.lit(None, pl.Float64),
        stand=pl.lit(None, pl.String),
    )
    found = look(table(frame=frame))
    assert warned(found, "impossible") == 2
    assert warned(found, "selected") == 58
    assert warned(found, "side unknown") == 58
    assert {warning.detail for warning in found.warnings if warning.name == "empty column"} == {"bat_speed", "stand"}


def test_a_row_broken_over_lines_at_the_end_is_whole(tmp_path: Path) -> None:
    """And one whose quotation never closes is not."""
    path, row = tmp_path / "table.csv", '95,12,"one, ""two""\nthree"\n'
    path.write_text("launch_speed,launch_angle,remarks\n" + row * 3, "utf-8")
    found = look(path)
    assert found.counts[0][USED] == 3 and warned(found, "torn") == 0
    for encoding in ("utf-8", "utf-16"):
        path.write_text(f'launch_speed,launch_angle,remarks\n{row * 3}95,12,"one', encoding)
        found = look(path)
        assert warned(found, "torn") == 1 and found.counts[0][USED] == 4, found.faults


def test_whose_name_player_name_is(table: Write) -> None:
    """A search for batters exports theirs under the same heading: numbers beside it tell."""
    names = pl.format("Batter, {}", pl.col("batter"))
    found = look(table(frame=made_up().with_columns(player_name=names)))
    assert warned(found, "name of the pitcher") == 0
    assert found.tables[0].headings.columns["batter_name"].heading == "player_name"
    players = season_answer(SeasonQuestion(paths=[found.tables[0].path], contact=False)).to_frame()
    assert players["name"].to_list() == [f"Batter, {600_000 + number}" for number in range(6)]
    require_batter([found.tables[0].path], "Batter, 600001")


def test_whose_name_player_name_is_without_pitchers(table: Write) -> None:
    """One name for each batter and one batter for each name; names of pitchers go over several batters."""
    bare = made_up().drop("pitcher")
    found = look(table("theirs.csv", bare.with_columns(player_name=pl.format("Batter, {}", "batter"))))
    assert found.tables[0].headings.columns["batter_name"].heading == "player_name"
    for number, names in enumerate((bare["batter"] % 2, bare["batter"] * 0)):
        others = look(table(f"others_{number}.csv", bare.with_columns(player_name=pl.format("Pitcher, {}", names))))
        assert not others.tables[0].headings.has("batter_name")


def test_duplicates_are_found_by_whatever_name_a_batter_is_known(table: Write) -> None:
    """By number in one export, by name in the next; and columns that only one of them has do not matter."""
    frame = made_up()
    bare = frame.drop("at_bat_number", "pitch_number", "player_name")
    named = bare.with_columns(batter_name=pl.format("Batter, {}", "batter")).drop("batter")
    twice = look(table("named.csv", pl.concat([named, named.head(7)])))
    assert twice.counts[0]["duplicate"] == warned(twice, "duplicates") == 7
    found = look(table("whole.csv", frame), table("named.csv", named.tail(20)), table("bare.parquet", bare.head(5)))
    assert [counts["duplicate"] for counts in found.counts] == [0, 20, 5]


def test_rows_of_which_too_little_is_known_are_no_duplicates(table: Write) -> None:
    """Two balls of one batter and day without anything measured are two untracked balls."""
    measured = [name for name, kind in made_up().schema.items() if kind == pl.Float64 or name == "launch_angle"]
    frame = made_up().drop("at_bat_number", "pitch_number").with_columns(
        pl.when(pl.int_range(pl.len()) < 10).then(None).otherwise(pl.col(name)).alias(name) for name in measured
    ).with_columns(batter=pl.lit(600_001), game_date=pl.lit("2024-04-02"), game_pk=pl.lit(7))  # fmt: skip
    found = look(table(frame=frame))
    assert found.counts[0]["untracked"] == 10 and found.counts[0]["duplicate"] == 0


def test_fouls_are_left_out_whether_measured_or_not(table: Write) -> None:
    row = pl.int_range(pl.len())
    frame = (
        made_up()
        .with_columns(
            description=pl.when(row < 10).then(pl.lit("foul")).otherwise("description"),
            launch_speed=pl.when(row < 4).then(None).otherwise("launch_speed"),
        )
        .drop("type")
    )
    details = [one.detail for one in look(table(frame=frame)).warnings if one.name == "fouls"]
    assert details == ["6 of them have an exit speed"]
    none = frame.with_columns(launch_speed=pl.when(row < 10).then(None).otherwise("launch_speed"))
    assert [one.detail for one in look(table(frame=none)).warnings if one.name == "fouls"] == ["none has one"]


def test_parks_that_nobody_knows_are_named_with_their_rows(table: Write) -> None:
    clubs = pl.Series(["BOS", "Yomiuri", None] * 20)
    (found,) = (
        one for one in look(table(frame=made_up().with_columns(home_team=clubs))).warnings if one.name == "unknown park"
    )
    assert (found.count, found.rows[:3], found.detail) == (20, [3, 6, 9], "Yomiuri")


def test_what_no_column_tells_of_bunts_and_spin_is_said(table: Write) -> None:
    frame = made_up()

    def parts(frame: pl.DataFrame) -> str:
        return " ".join(one.detail for one in look(table(frame=frame)).warnings if one.name == "part off")

    assert "of bunts only sacrifices are known" in parts(frame.drop("des")) and "bunt" not in parts(frame)
    assert "nothing tells bunts" in parts(frame.select("launch_speed", "launch_angle", "hc_x", "hc_y"))
    spun = frame.with_columns(hit_spin_rpm=pl.lit(2500.0))
    assert [one.detail for one in look(table(frame=spun)).warnings if one.name == "spin not used"] == ["hit_spin_rpm"]


@pytest.mark.parametrize("word", rows.ABSENT)
@pytest.mark.parametrize("name", ["table.csv", "table.parquet"])
def test_words_that_mean_nothing_are_missing_and_no_slip(table: Write, name: str, word: str) -> None:
    """In numbers, in texts and in dates, whoever read the table first; missing is never zero."""
    nothing = pl.when(pl.int_range(pl.len()) < 10).then(pl.lit(word))
    columns = ("bat_speed", "batter", "game_date")
    frame = made_up().with_columns(nothing.otherwise(pl.col(one).cast(pl.String)).alias(one) for one in columns)
    found = look(table(name, frame))
    read = rows_of(found.tables[0].part(0, 60), found.tables[0].headings)
    assert read.select("bat_speed", "batter", "day").null_count().row(0) == (10, 10, 10)
    assert warned(found, "unreadable") == 0 and found.counts[0][USED] == 60
    assert read["bat_speed"].min() > 20  # type: ignore[operator]


def test_numbers_that_begin_with_a_zero_are_names(tmp_path: Path) -> None:
    path = tmp_path / "table.csv"
    path.write_text("launch_speed,launch_angle,batter,shirt,more\n" + "95,12,00123,07,0\n" * 3, "utf-8")
    balls = analyse_season([path], setting=season_setting(contact=False), folder=tmp_path / "out").balls().collect()
    assert balls.select("batter", "shirt", "more").row(0) == ("00123", "07", 0)


def test_an_estimate_from_endings_comes_nearer_to_the_truth(table: Write) -> None:
    """Balls whose exit speed is taken away are slower ones; those that ended alike tell what is missing."""
    frame = pl.concat([made_up(seed=seed) for seed in range(20)]).with_columns(game_pk=pl.int_range(pl.len()))
    slow = pl.col("launch_speed") < 80
    frame = frame.with_columns(bb_type=pl.when(slow).then(pl.lit("popup")).otherwise(pl.lit("fly_ball")))
    truth = float(frame["launch_speed"].to_numpy().mean())
    lost = frame.with_columns(launch_speed=pl.when(~(slow & (pl.int_range(pl.len()) % 2 == 0))).then("launch_speed"))
    path = table(frame=lost)
    bias = tracking_bias(look(path))
    assert bias is not None and bias.explained == 1.0
    assert bias.mean_exit_speed_of_tracked / 0.44704 - truth > 2
    assert abs(bias.mean_exit_speed_of_all / 0.44704 - truth) < 0.5
    words = " ".join(map(str, season_document(season_answer(SeasonQuestion(paths=[path], contact=False))).blocks))
    assert "the mean exit speed of all would be" in words
    bare = table("bare.csv", lost.drop("events", "bb_type", "hc_x", "hc_y"))
    words = " ".join(map(str, season_document(season_answer(SeasonQuestion(paths=[bare], contact=False))).blocks))
    assert "nothing tells how they ended" in words


def test_columns_that_answers_take_the_place_of_are_named(table: Write) -> None:
    path = table(frame=made_up().with_columns(carry_ft=pl.lit(1.0), carry_m=pl.lit(2.0), hang_time_s=pl.lit(3.0)))
    season = analyse_season([path], setting=season_setting(contact=False), folder=path.parent / "out")
    (found,) = (one for one in season.survey.warnings if one.name == "replaced")
    assert found.detail == "carry_ft, hang_time_s" and found.count == 60
    balls = season.balls().collect()
    assert balls["carry_m"].to_list() == [2.0] * 60 and balls["carry_ft"].max() > 100  # type: ignore[operator]


def test_how_far_out_untracked_balls_came_tells_of_them(table: Write) -> None:
    """Balls that all ended in the same words, slow ones nearer home: their places tell what the lost ones were."""
    frame = pl.concat([made_up(seed=seed) for seed in range(20)]).with_columns(game_pk=pl.int_range(pl.len()))
    near = pl.col("launch_speed") < 80
    frame = frame.with_columns(
        events=pl.lit("field_out"), hc_x=pl.lit(125.42), hc_y=pl.when(near).then(180.0).otherwise(100.0)
    )
    lost = frame.with_columns(launch_speed=pl.when(~(near & (pl.int_range(pl.len()) % 2 == 0))).then("launch_speed"))
    bias = tracking_bias(look(table(frame=lost)))
    assert bias is not None and bias.mean_exit_speed_of_tracked / 0.44704 - frame["launch_speed"].mean() > 2  # type: ignore[operator]
    assert bias.mean_exit_speed_of_all / 0.44704 == pytest.approx(frame["launch_speed"].mean(), abs=0.5)
    fled = lost.with_columns(hc_y=pl.when(pl.col("launch_speed").is_null()).then(20.0).otherwise("hc_y"))
    farther = tracking_bias(look(table(frame=fled)))  # where no tracked one came down the words tell
    assert (
        farther is not None
        and farther.explained == 1.0
        and farther.mean_exit_speed_of_all == pytest.approx(farther.mean_exit_speed_of_tracked)
    )

"""`sweetspot season` from the outside."""

from __future__ import annotations

import io
import json
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import polars as pl
import pytest

from sweetspot.answers.season import SeasonAnswer
from sweetspot.cli import main
from sweetspot.errors import InputError
from sweetspot.reports import html
from sweetspot.reports.quantities import US
from sweetspot.reports.season.document import player_page, write_tables
from sweetspot.seasons.batters import read_bats, require_batter
from sweetspot.seasons.standings import GROUPS, Standing
from tests.reports.season.test_picture import CASES
from tests.seasons.conftest import made_up


def run(*arguments: object) -> int:
    with pytest.raises(SystemExit) as ended:
        main(["season", *map(str, arguments)])
    return int(ended.value.code or 0)


def test_tables_in_answers_out(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    table, out = tmp_path / "table.csv", tmp_path / "out"
    made_up(300).write_csv(table)
    assert run(table, "--try", "mlb-a", "--try", "r161-ash", "--out", out) == 0  # the second is the bat it was hit with
    shown = capsys.readouterr()
    assert "300 rows in one file; 300 balls in play" in shown.out
    balls = pl.read_parquet(out / "balls")
    assert len(balls) == 300
    assert {"umpire", "carry_ft", "home_run_here", "from_tip_in", "exit_speed_with_mlb_a_mph"} <= set(balls.columns)
    assert balls.filter(pl.col("contact_outcome") == "ok")["from_tip_in"].null_count() == 0
    players = pl.read_csv(out / "players.csv")
    assert len(players) == 6 and "squared_up_low90" in players.columns
    assert (players["gain_with_mlb_a_balls"] <= players["balls"]).all() and "gain_with_mlb_a_low90_mph" in players
    assert (players["gain_with_mlb_a_reliability"] <= 1).all() and "gain_with_r161_ash_mph" not in players.columns
    data = json.loads((out / "season.json").read_text("utf-8"))
    assert sum(data["tables"][0]["ledger"].values()) == data["tables"][0]["rows"] == 300
    (tried,) = data["other_bats"]  # all balls together; with the very bat that they were hit with nothing was tried
    with_it = (balls["exit_speed_with_mlb_a_mph"] - balls["launch_speed"]).drop_nulls().to_numpy()
    low, high = (balls[f"exit_speed_with_mlb_a_{end}_mph"].drop_nulls().to_numpy().mean() for end in ("low", "high"))
    assert tried["bat"] == "mlb-a" and tried["balls"] == len(with_it)
    assert tried["gain_m_s"] == pytest.approx(with_it.mean() * 0.44704, abs=1e-4)
    assert tried["high_m_s"] - tried["low_m_s"] == pytest.approx((high - low) * 0.44704, abs=1e-4)
    assert "With mlb-a the same swings would have given" in " ".join(shown.out.split())
    assert set(pl.read_parquet(out / "ledger")["table"]) == {"table.csv"}  # rows of several tables are told apart
    assert (out / "season.html").exists() and (out / "season.png").exists()


@pytest.mark.parametrize("asked", [(), ("--player", "600002")])
def test_csv_and_json_are_si_with_the_unit_in_every_name(
    asked: tuple[str, ...], tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """Whatever the units of tables and pages; players' tables in the folder are in those of its balls."""
    table = tmp_path / "table.csv"
    made_up(300).write_csv(table)
    assert run(table, *asked, "--flight-only", "--format", "csv", "--units", "us", "--out", tmp_path / "out") == 0
    told = pl.read_csv(io.StringIO(capsys.readouterr().out)).filter(pl.col("batter") == 600_002)
    written = pl.read_csv(tmp_path / "out" / "players.csv").filter(pl.col("batter") == 600_002)
    assert "exit_speed" not in told.columns and "ev20" not in told.columns
    for name in ("ev20", "exit_speed", "exit_speed_low90"):
        assert told[f"{name}_m_s"][0] == pytest.approx(written[f"{name}_mph"][0] * 0.44704)


def test_few_balls_with_bat_speed_are_told_as_few(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """What is told of bats from so little is called rough; nobody is listed by four balls, and no heading is cut."""
    table = tmp_path / "a_table_with_a_name_of_many_many_characters.csv"
    made_up(20).write_csv(table)
    assert run(table, "--out", tmp_path / "out") == 0
    out = capsys.readouterr().out
    words = " ".join(out.split())
    assert "Squared up" in words and "Too few balls have a bat speed" in words and "nothing is reported" not in words
    assert "No batter has 5 balls in play" in words and "expected home runs per" not in out.split("Reliability")[0]
    capsys.readouterr()
    assert run(table, "--format", "json") == 0
    assert json.loads(capsys.readouterr().out)["places"]["bat_speeds"]["full_speed"] > 0


def test_a_name_that_is_a_formula_is_only_shown(tmp_path: Path) -> None:
    names = pl.DataFrame({"player": ["=HYPERLINK(1)", "A"], "balls": [3, 4]})
    question = SimpleNamespace(system="us")
    answer: Any = SimpleNamespace(standings=["batter"], to_frame=lambda *_, **__: names, question=question)
    (name,) = (name for name in write_tables(answer, tmp_path) if name.endswith(".csv"))
    assert (tmp_path / name).read_text("utf-8") == "player,balls\n'=HYPERLINK(1),3\nA,4\n"


def test_one_bad_file_is_listed_and_the_exit_code_is_1(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    table, empty = tmp_path / "table.parquet", tmp_path / "empty.csv"
    made_up(30).write_parquet(table)
    empty.touch()
    assert run(table, empty, "--flight-only") == 1
    shown = capsys.readouterr()
    assert "30 balls in play" in shown.out and f"not read: {empty} is empty" in shown.err


def test_its_own_tables_are_left_out_a_second_time(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    made_up(30).write_csv(tmp_path / "balls.csv")
    asked = ("--flight-only", "--out", tmp_path)
    assert run(tmp_path / "balls.csv", *asked) == 0
    first, _ = (tmp_path / "players.csv").read_bytes(), capsys.readouterr()
    tables = sorted(tmp_path.glob("*.csv"))
    assert len(tables) > len(GROUPS)
    assert run(*tables, tmp_path / "parks.parquet", *asked) == 0
    shown = capsys.readouterr()
    assert "30 rows in one file" in shown.out and "parks.csv" in shown.err and "parks.parquet" in shown.err
    assert "left out, as season wrote them itself" in shown.err and (tmp_path / "players.csv").read_bytes() == first


@pytest.mark.parametrize(
    ("name", "words"),
    [
        ("clubs.csv", "is where season writes a table of its own"),  # and of somebody else's
        ("players.csv", "is a table that season itself wrote"),
        ("balls/0000-0000000000.parquet", "is one of the answers in"),
    ],
)
def test_what_a_season_would_replace_is_no_input(
    name: str, words: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    out, table = tmp_path / "out", tmp_path / "table.csv"
    made_up(30).write_csv(table)
    assert run(table, "--flight-only", "--out", out) == 0
    capsys.readouterr()
    if name == "clubs.csv":
        table.replace(out / name)
    held = (out / name).read_bytes()
    assert run(out / name, "--flight-only", "--out", out) == 2
    said = [line for line in capsys.readouterr().err.splitlines() if line]
    assert len(said) == 1 and words in said[0] and (out / name).read_bytes() == held


def test_a_page_for_one_player(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    table, out = tmp_path / "table.csv", tmp_path / "out"
    made_up(300).write_csv(table)
    assert run(table, "--player", "600002", "--flight-only", "--out", out) == 0
    assert "50 balls in play" in capsys.readouterr().out
    assert json.loads((out / "player-600002.json").read_text("utf-8"))["balls"] == 50
    page = (out / "player-600002.html").read_text("utf-8")
    assert "<h1>Player 600002</h1>" in page and "<details" not in page  # which would begin a second sheet
    assert "nothing per contact or per swing" in page
    assert "ceiling" not in page.split("</style>")[1]  # no bats, so nothing of them


@pytest.mark.parametrize("name", ["table.csv", "table.csv.gz", "table.parquet"])
def test_an_unknown_player_is_refused_before_anything_is_computed(
    name: str, tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    table, other = tmp_path / name, tmp_path / "other.csv"
    made = made_up(30).with_columns(batter=pl.col("batter").cast(pl.Float64))  # 600002.0, as exports write it
    made.write_parquet(table) if name.endswith("parquet") else made.write_csv(
        table, compression="gzip" if name.endswith("gz") else "uncompressed"
    )
    other.write_text("launch_speed\n90\n", encoding="utf-8")
    monkeypatch.setattr("sweetspot.answers.season.analyse_season", lambda *_, **__: pytest.fail("computed"))
    assert run(table, "--player", "600009") == 2
    said = capsys.readouterr().err.strip()
    assert said.count("\n") == 0 and "no batter '600009' in the tables. Did you mean 60000" in said
    assert run(table, other, tmp_path / "none.csv", "--player", "Nobody") == 2
    assert "Known names: 600000, 600001" in capsys.readouterr().err
    assert run(other, "--player", "600009") == 2
    assert "no table has a column of batters" in capsys.readouterr().err
    require_batter([other, table], "600002")  # and with another table that knows no batters


def test_bats_of_batters_who_are_not_in_the_tables(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """All of them: nothing is computed with bats that are nobody's. Some: they are named, and the others count."""
    table, bats = tmp_path / "table.csv", tmp_path / "bats.csv"
    made_up(30).write_csv(table)
    bats.write_text("batter,bat\nNobody,mlb-a\n600009,r161-ash\n", "utf-8")
    assert run(table, "--bats", bats) == 2
    said = capsys.readouterr().err.strip()
    assert said.count("\n") == 0 and "no batter of the table of bats is in the tables: 'Nobody', '600009'" in said
    bats.write_text("batter,bat\n600000.0,mlb-a\n600009,r161-ash\n", "utf-8")
    assert run(table, "--bats", bats, "--out", tmp_path / "out") == 0
    assert "'600009' has a bat and is no batter of the tables" in capsys.readouterr().err
    told = pl.read_parquet(tmp_path / "out" / "balls").group_by("batter").agg(pl.col("bat").unique()).sort("batter")
    assert told["bat"].to_list() == [["mlb-a"], *[["unknown"]] * 5]


@pytest.mark.parametrize("text", ["batter,bat\n7,mlb-a\n", "Batter;Bat\n7;mlb-a\n", "hitter\tbat\n7.0\tmlb-a\n"])
def test_a_table_of_bats_as_spreadsheets_save_it(text: str, tmp_path: Path) -> None:
    (tmp_path / "bats.csv").write_text(text, "utf-8")
    assert read_bats(tmp_path / "bats.csv") == {"7": "mlb-a", "": "unknown"}


def test_one_is_not_several() -> None:
    row = {"batter": "7", "name": None, "balls": 1, "ev20": 40.0, "home_runs_expected": 0.2, "home_runs": 0,
           "doubters": 1, "mostly_gone": 1, "no_doubters": 2}  # fmt: skip
    answer: Any = SimpleNamespace(
        standings={"batter": Standing("batter", pl.DataFrame([row]), {})},
        to_frame=lambda _: pl.DataFrame([row]),
        counted=CASES["speeds alone"][0].with_columns(batter=pl.lit("7")),
        rare_shares={"batter": []},
    )
    told = html.page(player_page(SeasonAnswer.player(answer, "7")), US)
    assert "1 ball in play" in told and "1 doubter, 1 mostly gone, 2 no-doubters" in told


@pytest.mark.parametrize(
    ("asked", "words"),
    [
        ("Doe", "2 batters are called 'Doe'; give the number of one: 1, 2"),
        ("Ro", "no batter 'Ro' in the tables. Did you mean Roe"),
        ("nobody at all", "There are 202, for example Doe, Roe"),
    ],
)
def test_a_name_that_is_nobody_s_or_of_several_is_refused(asked: str, words: str) -> None:
    numbers = [str(number) for number in range(1, 204)]
    table = pl.DataFrame({"batter": numbers, "name": ["Doe", "Doe", "Roe", *(f"X{one}Y" for one in numbers[3:])]})
    answer: Any = SimpleNamespace(standings={"batter": Standing("batter", table, {})})
    with pytest.raises(InputError, match=words):
        SeasonAnswer.player(answer, asked)


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (["none.csv"], "none.csv is not a file; give CSV"),
        (["{folder}/tabel.csv"], "tabel.csv is not a file; did you mean {folder}/table.csv? Otherwise give CSV"),
        (["{table}", "--bat", "r162-ash"], "bat 'r162-ash' is not in the catalogue"),
        (["{table}", "--column", "exit_speed"], "give quantity=heading"),
        (["{table}", "--resume"], "--resume needs --out"),
        (["{table}", "--bats", "{table}"], "has no column bat"),
    ],
)
def test_bad_input_is_one_line(
    arguments: list[str], words: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    table = tmp_path / "table.csv"
    made_up(30).write_csv(table)
    assert run(*(argument.format(table=table, folder=tmp_path) for argument in arguments)) == 2
    said = [line for line in capsys.readouterr().err.splitlines() if line]
    assert len(said) == 1 and words.format(folder=tmp_path) in said[0]


def test_columns_are_shown(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    table = tmp_path / "table.csv"
    made_up(30).write_csv(table)
    assert run(table, "--show-columns") == 0
    shown = capsys.readouterr().out
    assert "Statcast, 30 rows" in shown and "launch_speed [mph]" in shown and "passed through: umpire" in shown


def test_every_ball_as_csv_is_every_ball_of_the_folder(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    made_up().with_columns(umpire=pl.lit("=1+1")).write_csv(tmp_path / "table.csv")
    with pytest.raises(SystemExit, match=r"^0$"):
        main(["season", str(tmp_path / "table.csv"), "--flight-only", "--out", str(tmp_path / "out"), "--balls-csv"])
    written = pl.read_csv(tmp_path / "out" / "balls.csv", infer_schema_length=None)
    balls = pl.read_parquet(tmp_path / "out" / "balls" / "*.parquet")
    assert written.columns == balls.columns and len(written) == len(balls)
    assert written["carry_ft"].to_list() == pytest.approx(balls["carry_ft"].to_list(), rel=1e-6)
    assert set(written["umpire"]) == {"'=1+1"}
    with pytest.raises(SystemExit, match=r"^2$"):
        main(["season", str(tmp_path / "table.csv"), "--balls-csv"])
    assert "--balls-csv needs --out" in capsys.readouterr().err

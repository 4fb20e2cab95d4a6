"""The JSON of every answer is as its schema says, in both systems of units."""

from __future__ import annotations

import json
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any

import jsonschema
import polars as pl
import pytest

import sweetspot
import sweetspot.cli
from sweetspot import catalog
from sweetspot.answers.schema import answer_names, answer_schema, answer_type
from sweetspot.reports.season.document import write_tables
from tests.documented import TUTORIALS
from tests.seasons.conftest import made_up

RACKET = catalog.implement("tennis-racket")
ASKED: Mapping[str, Callable[[], Any]] = {
    "report": lambda: sweetspot.report("tennis-racket", uncertainty=True),
    "hit": lambda: sweetspot.hit("college-alloy", at=0.7, uncertainty=True),
    "play": lambda: sweetspot.play("r161-ash", park="fenway", uncertainty=True),
    "fly": lambda: sweetspot.fly(park="coors"),
    "fly-table": lambda: sweetspot.fly_table({"exit_speed": [40.0, 45.0]}),
    "compare": lambda: sweetspot.compare("r161-ash", "mlb-a"),
    "what-if": lambda: sweetspot.what_if("r161-ash", {"mass": [0.85, 0.9], "bore_depth": [0.0, 0.2]}),
    "certify": lambda: sweetspot.certify("college-alloy", uncertainty=True),
    "certify-paddle": lambda: sweetspot.certify_paddle("pickleball-paddle"),
    "certify-club": lambda: sweetspot.certify_club("golf-driver"),
    "optimum": lambda: sweetspot.optimum("r161-ash", show=["launch"]),
    "drop": lambda: sweetspot.drop(height=1.0),
    "paper": lambda: sweetspot.paper("r161-ash"),
    "pendulum": lambda: sweetspot.pendulum(mass=0.87, balance_point=0.56, period=1.45, uncertainty=True),
    "rank": lambda: sweetspot.rank(TUTORIALS / "coach" / "dozen.csv", like="r161-ash"),
    "tap": lambda: sweetspot.tap(TUTORIALS / "metal_bat" / "taps.flac", implement="college-alloy", at="1in-from-tip"),
    "calibrate": lambda: sweetspot.calibrate("r161-ash", mass="31 oz"),
    "fit-player": lambda: sweetspot.fit_player(TUTORIALS / "coach" / "swings.csv"),
    "plan-swings": lambda: sweetspot.plan_swings("r161-ash", "mlb-a"),
    "kit": lambda: sweetspot.kit("r161-ash", pieces=3),
    "match": lambda: sweetspot.match(RACKET, RACKET.replaced(name="heavier", mass=0.33, moi=0.0335)),
}
OTHERWISE = {"season": "below, from a table", "design": "seconds of searching", "outline": "a drawing"}
"""Answers that are validated where they are made, or take long; their schemas are valid ones."""


@pytest.mark.parametrize("name", answer_names())
def test_every_answer_has_a_valid_schema(name: str) -> None:
    for units in ("si", "us"):
        schema = answer_schema(answer_type(name), units)
        jsonschema.Draft202012Validator.check_schema(schema)
        assert schema["required"] and schema["additionalProperties"] is False


def test_no_answer_is_left_out() -> None:
    assert {*ASKED, *OTHERWISE} == set(answer_names())


@pytest.mark.parametrize("name", ASKED)
def test_an_answer_is_as_its_schema_says(name: str) -> None:
    answer: Any = ASKED[name]()
    assert type(answer).__name__ == answer_type(name).__name__
    for units in ("si", "us"):
        told = json.loads(json.dumps(answer.to_dict(units), allow_nan=False))
        jsonschema.Draft202012Validator(answer_schema(type(answer), units)).validate(told)


def test_a_season_is_as_its_schema_says_and_its_parquet_names_its_units(tmp_path: Path) -> None:
    made_up(60, year=2024).write_csv(tmp_path / "season.csv")
    answer = sweetspot.season(tmp_path / "season.csv", bats="r161-ash")
    jsonschema.validate(json.loads(json.dumps(answer.to_dict())), answer_schema(type(answer)))
    assert "players.parquet" in write_tables(answer, tmp_path)
    metadata = pl.read_parquet_metadata(tmp_path / "players.parquet")
    assert json.loads(metadata["made_with"])["version"] == sweetspot.__version__
    units = json.loads(metadata["units"])
    assert units["exit_speed_low90_mph"] == "mph" and units["carry_above_ft"] == "ft" and "home_runs" not in units
    assert set(units) <= set(pl.read_parquet_schema(tmp_path / "players.parquet"))


def test_another_unit_or_a_missing_number_is_noticed() -> None:
    told = sweetspot.hit("r161-ash", at=0.7).to_dict("us")
    with pytest.raises(jsonschema.ValidationError):
        jsonschema.validate(told, answer_schema(answer_type("hit"), "si"))
    del told["exit_speed_mph"]
    with pytest.raises(jsonschema.ValidationError, match="exit_speed_mph"):
        jsonschema.validate(told, answer_schema(answer_type("hit"), "us"))


def test_the_command_prints_what_its_json_keeps_to(capsys: pytest.CaptureFixture[str]) -> None:
    printed = {}
    for words in ("schema hit", "hit r161-ash --at 6in-from-tip --format json"):
        with pytest.raises(SystemExit) as stopped:
            sweetspot.cli.main(words.split())
        assert not stopped.value.code
        printed[words.split()[0]] = json.loads(capsys.readouterr().out)
    jsonschema.validate(printed["hit"], printed["schema"])

"""What to beware of stands once, however many tables it concerns."""

from __future__ import annotations

from pathlib import Path

import polars as pl
import pytest

from sweetspot.answers.cautions import DETAILS
from sweetspot.answers.season import SeasonAnswer, season_answer
from sweetspot.answers.season_question import SeasonQuestion
from sweetspot.reports.document import Table
from sweetspot.reports.season.document import season_document
from tests.seasons.conftest import made_up

TABLES = 33


@pytest.fixture(scope="module")
def answer(tmp_path_factory: pytest.TempPathFactory) -> SeasonAnswer:
    folder = tmp_path_factory.mktemp("many")
    for number in range(TABLES):
        frame = made_up(30, seed=number).drop("bat_speed", "home_team", "type")
        fouls = ["foul"] * (1 + number % 5) + ["hit_into_play"] * (29 - number % 5)
        frame.with_columns(description=pl.Series(fouls), game_pk=pl.lit(number)).write_csv(
            folder / f"game{number:02d}.csv"
        )
    return season_answer(SeasonQuestion(paths=sorted(folder.glob("*.csv")), contact=False))


def test_the_same_of_all_tables_is_one_caution(answer: SeasonAnswer) -> None:
    kinds = [(caution.name, caution.detail) for caution in answer.warnings]
    assert len(kinds) == len(set(kinds)) and len({name for name, _ in kinds}) <= len(kinds) < 10
    assert {len(caution.tables) for caution in answer.warnings} == {TABLES}
    (fouls,) = (caution for caution in answer.warnings if caution.name == "fouls")
    assert fouls.rows == sum(1 + number % 5 for number in range(TABLES))
    assert fouls.detail.startswith("game00.csv: 1 of them")
    assert fouls.detail.count(" have an exit speed") == DETAILS and fouls.detail.endswith("; …")
    missing = [caution.detail for caution in answer.warnings if caution.name == "part off"]
    assert len(missing) == 2 and {words.split(" (")[0] for words in missing} == {"no bat speed", "no home club"}


def test_a_row_of_the_table_names_how_many_tables_and_the_first_rows(answer: SeasonAnswer) -> None:
    (table,) = (
        block
        for block in season_document(answer).blocks
        if isinstance(block, Table) and str(block.title).startswith("Beware; rows of a CSV file")
    )
    (row,) = (row for row in table.rows if row[0] == "fouls")
    assert row[1:4] == [f"{TABLES} tables", "96", "2, … in game00.csv"]
    assert all(cells[3] == "all" for cells in table.rows if cells[0] == "part off")


def test_its_data_have_every_table(answer: SeasonAnswer) -> None:
    data = answer.to_dict()["warnings"]
    assert isinstance(data, list) and len(data) == len(answer.warnings)
    assert [Path(table["file"]).name for table in data[0]["tables"]][:2] == ["game00.csv", "game01.csv"]
    assert {"rows", "first_rows", "detail"} < set(data[0]["tables"][0])

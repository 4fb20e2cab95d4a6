"""Player's answers: a table of several batters is read one batter at a time, and what is no table is told in words."""

from __future__ import annotations

import shlex
from typing import Any

import httpx
import pytest

from sweetspot.web.errors import FieldError
from sweetspot.web.views.design import batter
from sweetspot.web.views.design_state import DesignState
from sweetspot.web.views.player import PlayerState, answer, fit, recipe

TEAM = "bat_speed_mph,exit_speed_mph,player\n" + "".join(
    f"{60 + row},{85 + row},{'Ann' if row % 3 else 'Bob'}\n" for row in range(18)
)


def test_a_team_s_table_is_read_one_batter_at_a_time() -> None:
    first, second = (answer(PlayerState(swings_csv=TEAM, swings_of=name)) for name in (None, "Bob"))
    assert first.batters == ("Ann", "Bob") == second.batters
    assert (first.batter, len(first.bat_speed), second.batter, len(second.bat_speed)) == ("Ann", 12, "Bob", 6)
    for state, name in ((PlayerState(swings_csv=TEAM), "Ann"), (PlayerState(swings_csv=TEAM, swings_of="Bob"), "Bob")):
        words = shlex.split(recipe(state)["command"])
        assert words[words.index("--batter") + 1] == name
    with pytest.raises(FieldError, match="no swings of 'Bo'") as refused:
        answer(PlayerState(swings_csv=TEAM, swings_of="Bo"))
    assert refused.value.field == "swings_of"


def test_the_made_up_player_has_no_name() -> None:
    found = answer(PlayerState())
    assert "made-up player" in found.words and found.batters == () and found.batter is None
    assert "--batter" not in recipe(PlayerState())["command"]


def test_the_report_shows_its_picture_and_opens_its_words_on_demand() -> None:
    for html in fit(PlayerState()).html.values():
        before, _, behind = html.partition("<details>")
        assert "<svg" in before and "What to train" in before and "Questions and answers" not in before
        assert "Questions and answers" in behind and "What the swings say" in behind


def test_design_takes_the_batter_who_was_chosen() -> None:
    with pytest.raises(FieldError, match="swings of 2 batters"):
        batter(DesignState(swings_csv=TEAM))
    ann, bob = (batter(DesignState(swings_csv=TEAM, swings_of=name)) for name in ("Ann", "Bob"))
    assert ann.bat_speed_mph != bob.bat_speed_mph


def test_a_long_file_keeps_the_columns_that_mean_something(client: httpx.Client) -> None:
    wide = "shoe size,bat_speed_mph,exit_speed_mph,player,remark\n" + "".join(
        f"42,{50 + row / 100},{80 + row / 90:.2f},Ann,went well today indeed\n" for row in range(1500)
    )
    key = handed_in(client, "wide.csv", wide.encode())
    found = client.post("/api/v1/player/table", json={"upload": key}).json()["csv"]
    assert len(found) < 40_000 < len(wide)
    assert found.startswith("bat_speed_mph,exit_speed_mph,player\n50.0,80.00,Ann\n50.01,80.01,Ann\n")
    assert answer(PlayerState(swings_csv=found)).batters == ("Ann",)
    for content, words in ((b"milk,eggs\n1,2\n", "wide.csv: no column"), (wide.encode() * 3, "more than fit here")):
        key = handed_in(client, "wide.csv", content)
        refused = client.post("/api/v1/player/table", json={"upload": key})
        assert refused.status_code == 422 and words in refused.json()["error"]["message"]


def handed_in(client: httpx.Client, name: str, content: bytes) -> str:
    key = str(client.post("/api/v1/uploads", json={"name": name, "size": len(content)}).json()["upload"])
    for offset in range(0, len(content), 50_000):
        assert client.post(f"/api/v1/uploads/{key}/{offset}", content=content[offset : offset + 50_000]).is_success
    return key


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("", "is empty"),
        ("milk,eggs\n1,2\n", "no column for bat speed or exit speed"),
        ("bat_speed_mph,exit_speed_mph\nfast,high\n", "'fast', not a number"),
        ("bat_speed_mph,exit_speed_mph\n60,90\n", "5 are the fewest that tell anything of a player. Swing more$"),
    ],
)
def test_what_is_no_table_of_swings_is_told_beside_it(text: str, words: str) -> None:
    with pytest.raises(FieldError, match=words) as refused:
        answer(PlayerState(swings_csv=text))
    assert refused.value.field == "swings_csv"


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ('{"a": 1}', "has no parameters"),
        ('{"a":', "is no JSON"),
        ('{"parameters": null}', "has something else where its numbers should be"),
    ],
)
def test_what_is_no_answer_of_fit_player_is_told_in_words(text: str, words: Any) -> None:
    with pytest.raises(FieldError, match=f"{words}.*give the file that fit-player --out writes, player.json"):
        batter(DesignState(swings_csv=text))

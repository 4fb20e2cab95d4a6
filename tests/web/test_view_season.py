"""Season: tables are handed in, read in a job, told of, chosen from and taken away; what is wrong is one clear line."""

from __future__ import annotations

import time
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import httpx
import numpy as np
import polars as pl
import pytest

from sweetspot.equipment.bat import Bat
from sweetspot.errors import InputError
from sweetspot.web.views import season_work

URL = "/api/v1/season"


def asked(client: httpx.Client, path: str = "", **fields: Any) -> dict[str, Any]:
    response = client.post(f"{URL}{path}", json=fields)
    assert response.status_code == 200, response.text
    return dict(response.json())


def handed_in(client: httpx.Client, path: Path, name: str = "") -> str:
    content = path.read_bytes()
    told = client.post("/api/v1/uploads", json={"name": name or path.name, "size": len(content)}).json()
    for start in range(0, len(content), told["piece"]):
        client.post(f"/api/v1/uploads/{told['upload']}/{start}", content=content[start : start + told["piece"]])
    return str(told["upload"])


def read(client: httpx.Client, *uploads: str, **fields: Any) -> dict[str, Any]:
    """Return how a reading ended; compiling kernels for it may take minutes."""
    job = asked(client, "/read", uploads=uploads, **fields)["job"]
    deadline = time.monotonic() + 600
    while True:
        told = client.post(f"/api/v1/jobs/{job}", json={}).json()
        if told["status"] != "running":
            return dict(told)
        assert time.monotonic() < deadline, told
        time.sleep(0.1)


@pytest.fixture(scope="module")
def known(server: str, balls: Path) -> str:
    """The name of a season that was read: a good table, and one that is none."""
    with httpx.Client(base_url=server, timeout=600, verify=False) as client:
        empty = balls.with_name("nothing.csv")
        empty.write_text("launch_angle_deg\n12\n")
        told = read(client, handed_in(client, balls), handed_in(client, empty))
    assert told["status"] == "done", told
    return str(told["found"]["season"])


def test_before_anything_is_read_nothing_is_told(client: httpx.Client) -> None:
    answer = asked(client)
    assert answer["season"] is None and answer["bat"]["length_m"] > 0.8
    assert answer["park"]["out_m"][len(answer["park"]["out_m"]) // 2] > 110
    assert asked(client, "/summary") == asked(client, "/maps") == {}
    assert client.post(f"{URL}/player", json={}).json() is None


def test_a_season_is_told_by_the_names_people_know(client: httpx.Client, known: str, balls: Path) -> None:
    answer = asked(client, season=known)
    rows = len(pl.read_csv(balls))
    assert answer["season"]["rows"] == rows and answer["season"]["files"] == ["my balls.csv"]
    assert answer["season"]["same_bat"] and not asked(client, season=known, bat="mlb-a")["season"]["same_bat"]
    summary = asked(client, "/summary", season=known)
    assert len(summary["players"]) == 6
    for words in summary["html"].values():
        assert "my balls.csv" in words and "Not read: nothing.csv" in words and "exit_speed" in words
        assert "/tmp" not in words and "handed-in" not in words
    assert " m/s" in summary["html"]["si"] and " mph" not in summary["html"]["si"]


def test_maps_hold_the_chosen_balls_each_once(client: httpx.Client, known: str) -> None:
    everybody = asked(client, "/maps", season=known)
    one = asked(client, "/summary", season=known)["players"][0]
    his = asked(client, "/maps", season=known, batter=one["batter"])
    assert his["means"]["balls"] == one["balls"] < everybody["means"]["balls"]
    months = asked(client, season=known)["season"]["choices"]["month"]
    assert sum(balls for _, balls in months) == everybody["means"]["balls"]
    month, count = months[0]
    assert asked(client, "/maps", season=known, month=month)["means"]["balls"] == count
    for found in (everybody, his):
        barrel, field = found["barrel"], found["field"]
        assert np.sum(barrel["balls"]) + barrel["outside"] == found["means"]["balls"]
        assert np.sum(field["balls"]) + field["outside"] + field["near"] <= found["means"]["balls"]
        assert np.sum(found["ceilings"]["league_ratio"]) == pytest.approx(1, abs=0.02)
    nobody = asked(client, "/maps", season=known, batter="nobody")
    assert nobody["means"]["balls"] == 0 and "barrel" not in nobody and "ceilings" not in nobody


def test_the_fence_is_that_of_the_park_chosen_unless_another_was_chosen_by_hand(
    client: httpx.Client, known: str
) -> None:
    def fence(**fields: Any) -> str:
        return str(asked(client, season=known, **fields)["park"]["name"])

    parks = [park for park, _ in asked(client, season=known)["season"]["choices"]["park"]]
    assert len(parks) > 2
    assert fence() == "Fenway Park" and [fence(park=park) for park in parks] == parks
    assert fence(park="Coors Field", fence="wrigley-field") == "Wrigley Field"
    assert fence(park="Nowhere Park") == "Fenway Park"


def test_a_players_page_and_the_tables_are_there_and_nothing_else(client: httpx.Client, known: str) -> None:
    one = asked(client, "/summary", season=known)["players"][0]
    page = asked(client, "/player", season=known, batter=one["batter"])
    assert f"{one['balls']} balls in play" in page["html"]["us"]
    names = [table["name"] for table in asked(client, season=known)["season"]["tables"]]
    assert {"players.csv", "players.parquet", "balls.parquet", "ledger.parquet", "months.csv"} <= set(names)
    table = pl.read_csv(client.get(f"/api/v1/uploads/{known}/players.csv").content)
    assert set(table["batter"].cast(pl.String)) == {
        player["batter"] for player in asked(client, "/summary", season=known)["players"]
    }
    balls = pl.read_parquet(client.get(f"/api/v1/uploads/{known}/balls.parquet").content)
    assert "from_tip_in" in balls.columns and len(balls) == sum(table["balls"])
    for name in ("summary.pickle", "answer.pickle", "..%2Fsummary.pickle", "nobody.csv"):
        assert client.get(f"/api/v1/uploads/{known}/{name}").status_code in (404, 422)
    command = asked(client, "/recipe", season=known, batter=one["batter"])["command"]
    assert command == f"sweetspot season TABLE.csv --bat r161-ash --player {one['batter']} --out season"


def test_a_players_contacts_are_controls_of_the_design(client: httpx.Client, known: str) -> None:
    """Drawn towards all players, and no better known than an inch; who was not seen is one clear line."""
    one = asked(client, "/summary", season=known)["players"][0]
    found = asked(client, "/contacts", season=known, batter=one["batter"])
    assert 4 < found["contact_in"] < 10 and 1 < found["contact_doubt_in"] < 1.5
    assert found["bat_speed_mph"] == pytest.approx(one["bat_speed"] / 0.44704, abs=0.01)
    told = client.post("/api/v1/design", json=found)
    assert told.status_code == 200 and told.json()["curves"]["contacts"]
    assert asked(client, "/contacts", season=known) == asked(client, "/contacts") == {}
    response = client.post(f"{URL}/contacts", json={"season": known, "batter": "nobody"})
    assert response.status_code == 422 and response.json()["error"]["field"] == "batter"


@pytest.mark.parametrize(
    ("name", "text", "words"),
    [
        ("speedless.csv", "launch_angle_deg,bat_speed_mph\n12,70\n", "exit_speed"),
        ("empty.csv", "launch_speed,launch_angle\n", "no row"),
        ("words.csv", "launch_speed,launch_angle\nfast,high\n", "none of 1 rows"),
    ],
)
def test_a_bad_table_is_one_clear_line(r161: Bat, tmp_path: Path, name: str, text: str, words: str) -> None:
    path = tmp_path / name
    path.write_text(text)
    with pytest.raises(InputError) as fault:
        season_work.read_season(
            ((path, name),), tmp_path / "own", "key", r161, "as it is", after=None, say=lambda *_: None
        )
    message = str(fault.value)
    assert name in message and words in message and "\n" not in message
    assert "/" not in message.replace("and/or", "")


def test_a_reading_that_fails_says_why(client: httpx.Client, tmp_path: Path) -> None:
    path = tmp_path / "words.csv"
    path.write_text("launch_speed,launch_angle\nfast,high\n")
    told = read(client, handed_in(client, path))
    assert told["status"] == "failed"
    message = told["error"]["message"]
    assert message.startswith("words.csv: none of 1 rows") and "Traceback" not in message


@pytest.mark.parametrize(
    ("fields", "control"),
    [
        ({"season": "A" * 16}, "season"),
        ({"season": "short"}, "season"),
        ({"fence": "nowhere"}, "fence"),
        ({"bat": "no-such-bat"}, "bat"),
        ({"batter": ""}, "batter"),
    ],
)
def test_what_cannot_be_is_told_beside_its_control(client: httpx.Client, fields: dict[str, Any], control: str) -> None:
    response = client.post(URL, json=fields)
    assert response.status_code == 422 and response.json()["error"]["field"] == control


def test_tables_that_are_gone_are_asked_for_again(client: httpx.Client, known: str) -> None:
    response = client.post(f"{URL}/read", json={"uploads": ["A" * 16]})
    assert response.status_code == 422 and "hand them in again" in response.text
    assert client.post(f"{URL}/read", json={"uploads": [known]}).status_code == 422  # what was made is no table
    response = client.post(f"{URL}/player", json={"season": known, "batter": "nobody"})
    assert response.status_code == 422 and response.json()["error"]["field"] == "batter"


def test_a_reading_is_stopped_and_goes_on(client: httpx.Client, balls: Path) -> None:
    job = asked(client, "/read", uploads=[handed_in(client, balls)])["job"]
    look = f"/api/v1/jobs/{job}"
    assert client.post(look, json={"stop": True}).json()["status"] == "stopped"
    assert client.post(look, json={"go_on": True}).json()["status"] == "running"
    deadline = time.monotonic() + 600
    while (told := client.post(look, json={}).json())["status"] == "running":
        assert time.monotonic() < deadline
        time.sleep(0.1)
    assert told["status"] == "done"
    assert asked(client, season=told["found"]["season"])["season"]["files"] == ["my balls.csv"]


def test_progress_has_a_speed_once_there_is_enough_to_count(monkeypatch: pytest.MonkeyPatch) -> None:
    now = iter((10.0, 10.01, 12.0, 14.0))  # s: the first parts come together, and say nothing of speed
    monkeypatch.setattr(season_work, "time", SimpleNamespace(monotonic=lambda: next(now)))
    told: list[season_work.SeasonReading] = []
    progress = season_work.counting(lambda found, _: told.append(found))
    for done in (100, 200, 300, 400):
        progress(done, 400)
    *rows, last = told
    assert [step.rows_read for step in rows] == [100, 200, 300, 400] and last.phase == "players"
    assert [step.reached for step in rows] == [f"{done} of 400 rows" for done in (100, 200, 300, 400)]
    speeds = (" …", " …", ", 100 rows/s, 1 s left", ", 75 rows/s, 0 s left")
    assert [step.words for step in rows] == [step.reached + speed for step, speed in zip(rows, speeds, strict=True)]

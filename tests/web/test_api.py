"""The API as a program sees it: right answers, and a clear refusal of everything else, with the server still up."""

from __future__ import annotations

import json
import math
import shlex
import warnings
from collections.abc import Callable
from pathlib import Path
from typing import Any

import httpx
import numpy as np
import pytest

from sweetspot import catalog
from sweetspot.analysis.bat_analysis import analyse, exit_speed_of, hit_at
from sweetspot.catalog.entries import entry_toml
from sweetspot.catalog.files.write import bat_toml
from sweetspot.catalog.standard_hit import standard_conditions
from sweetspot.errors import UnusualWarning
from sweetspot.units import INCH, MPH
from sweetspot.web.errors import NO_OBJECT
from sweetspot.web.limits import LARGEST_BODY
from sweetspot.web.views import VIEWS

Followed = Callable[[dict[str, Any]], tuple[list[Any], dict[str, Any]]]


@pytest.mark.parametrize("name", VIEWS)
def test_every_view_answers_with_its_first_picture(client: httpx.Client, name: str) -> None:
    response = client.post(f"/api/v1/{name}", json={})
    assert response.status_code == 200, response.text
    assert response.json()


def test_the_explorer_gives_the_librarys_numbers(client: httpx.Client) -> None:
    """Golden by construction: the same bat and conditions asked of the library."""
    found = client.post("/api/v1/explorer", json={"impact_from_tip_in": 5}).json()
    bat = catalog.bat()
    conditions = standard_conditions(bat)
    result = analyse(bat, conditions)
    assert found["scan"]["exit_speed_m_s"] == pytest.approx(result.scan.exit_speed.tolist(), rel=1e-12)
    assert found["sweet_spots"]["max_exit_speed_m"] == pytest.approx(result.sweet_spots.max_exit_speed, rel=1e-12)
    impact = hit_at(bat.length - 5 * INCH, modes=result.modes, conditions=conditions)
    # the compiled solution takes longer steps; its exit speeds are stated to lie within 1e-4
    assert found["hit"]["exit_speed_m_s"] == pytest.approx(exit_speed_of(impact, conditions), rel=2e-4)


@pytest.fixture
def followed(
    client: httpx.Client, run_json: Callable[..., Any], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> Followed:
    """A function that does what the explorer's recipe says; returns the commands' answers and Python's names."""
    monkeypatch.chdir(tmp_path)

    def follow(state: dict[str, Any]) -> tuple[list[Any], dict[str, Any]]:
        lines = client.post("/api/v1/explorer/recipe", json=state).json()
        Path("bat.toml").write_text(lines["toml"], encoding="utf-8")
        answers = [run_json(*shlex.split(line)[1:]) for line in lines["command"].splitlines() if line[0] != "#"]
        names: dict[str, Any] = {}
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", UnusualWarning)  # a softball may be hit by a baseball bat
            exec(lines["python"], names)
        return answers, names

    return follow


@pytest.mark.parametrize(
    "state",
    [
        {},
        {"pitch_speed_mph": 0, "ball": "softball-12in", "hands_in": 7},
        {"bat": "composite", "wall_factor": 0.9, "choke_up_in": 1, "ball_cor": 0.5, "ball_temperature_degf": 40},
        {"bore_diameter_in": 1, "cup_diameter_in": 1.2, "weight_oz": 1, "impact_from_tip_in": 4.5},
        {"mass_oz": 28, "weight_oz": 1, "choke_up_in": 0.5, "bat_speed_mph": 66},
        {"mass_oz": 34, "choke_up_in": 1, "same": "speed"},
    ],
)
def test_recipes_give_the_same_numbers(client: httpx.Client, state: dict[str, Any], followed: Followed) -> None:
    found = client.post("/api/v1/explorer", json=state).json()
    (report, hit), names = followed(state)
    assert report["scan"]["exit_speed_m_s"] == pytest.approx(found["scan"]["exit_speed_m_s"], rel=1e-9)
    assert report["sweet_spots"]["min_sting_m"] == pytest.approx(found["sweet_spots"]["min_sting_m"], rel=1e-9)
    assert hit["exit_speed_m_s"] == pytest.approx(found["hit"]["exit_speed_m_s"], rel=2e-4)
    assert names["report"].scan.sting == pytest.approx(found["scan"]["sting_m_s"], rel=1e-9)


@pytest.mark.parametrize("state", [{"offset_in": 0.5}, {"offset_in": -0.6, "bat": "youth-30", "bore_diameter_in": 0.5}])
def test_the_lines_of_a_ball_met_off_the_axis_give_that_hit(
    client: httpx.Client, state: dict[str, Any], followed: Followed
) -> None:
    found = client.post("/api/v1/explorer", json=state).json()["hit"]
    (*_, played), names = followed(state)
    for name in ("exit_speed_m_s", "launch_angle_rad", "backspin_rad_s"):
        assert played[name] == pytest.approx(found[name], rel=2e-4)
    assert names["play"].exit_speed == pytest.approx(found["exit_speed_m_s"], rel=2e-4)


def test_a_ball_met_off_the_axis_is_lifted_and_slower(client: httpx.Client) -> None:
    middle, above, over = (
        client.post("/api/v1/explorer", json={"offset_in": inches}).json()["hit"] for inches in (0, 0.7, 2.5)
    )
    assert middle["launch_angle_rad"] == pytest.approx(0, abs=1e-12)
    assert above["launch_angle_rad"] > 0.2
    assert above["backspin_rad_s"] > 100
    assert above["exit_speed_m_s"] < middle["exit_speed_m_s"]
    assert over["exit_speed_m_s"] < above["exit_speed_m_s"]


def test_uploaded_bats_are_parsed(client: httpx.Client) -> None:
    text = 'name = "x"\nlength = "33 in"\nmaterial = "white ash"\nprofile = [["0 in", "1 in"], ["33 in", "2.5 in"]]'
    response = client.post("/api/v1/bat", json={"toml": text})
    assert response.status_code == 200
    assert response.json()["length_m"] == pytest.approx(0.8382)
    found = client.post("/api/v1/explorer", json={"bat_toml": text}).json()
    assert found["bat"]["name"] == "x"
    listed = client.get("/api/v1/bats").json()
    assert {bat["key"] for bat in listed} == set(catalog.bat_names())


def test_a_ball_of_ones_own_is_the_one_that_is_hit(client: httpx.Client) -> None:
    """What `show` prints answers as the name does; what differs counts, and its file goes along with the lines."""
    state = {"impact_from_tip_in": 6.0, "pitch_speed_mph": 80.0}
    speeds = [
        client.post("/api/v1/hit", json=state | ball).json()["hit"]["exit_speed_m_s"]
        for ball in ({}, {"ball_toml": entry_toml("baseball", "ball")}, {"ball_toml": DEAD})
    ]
    assert speeds[0] == speeds[1] > speeds[2] + 0.5
    lines = client.post("/api/v1/hit/recipe", json=state | {"ball_toml": DEAD}).json()
    assert lines["ball.toml"] == DEAD and "--ball ball.toml" in lines["command"]


DEAD = 'like = "baseball"\nname = "dead"\ncor_reference = 0.48\n'
WRONG_STATES: list[tuple[dict[str, Any], str]] = [
    ({"pitch_speed_mph": 1e308}, "pitch_speed_mph"),
    ({"pitch_speed_mph": "fast"}, "pitch_speed_mph"),
    ({"hands_in": None}, "hands_in"),
    ({"bat": "no-such-bat"}, "bat"),
    ({"bat": "../../etc/passwd"}, "bat"),
    ({"bat": "/etc/passwd.toml"}, "bat"),
    ({"bat": "x" * 61}, "bat"),
    ({"ball": "no-such-ball"}, "ball"),
    ({"ball": "/etc/passwd.toml"}, "ball"),
    ({"ball_toml": ""}, "ball_toml"),
    ({"ball_toml": 'like = "/etc/passwd.toml"'}, "ball_toml"),
    ({"ball_toml": 'like = "baseball"\nweight = "5 oz"'}, "ball_toml"),
    ({"bore_diameter_in": 1, "bore_fill": "gold"}, "bore_fill"),
    ({"bore_diameter_in": 2}, "bore_diameter_in"),
    ({"bat": "composite", "bore_diameter_in": 1}, "bore_diameter_in"),
    ({"wall_factor": 0.9}, "wall_factor"),
    ({"mass_oz": 11}, "mass_oz"),
    ({"profile_in": [[0, 1], [0, 2]]}, "profile_in"),
    ({"profile_in": [[0, 1]] * 61}, "profile_in"),
    ({"weight_oz": 1, "weight_from_tip_in": 50}, "weight_from_tip_in"),
    ({"impact_from_tip_in": 30}, "impact_from_tip_in"),
    ({"no_such_control": 1}, "no_such_control"),
    ({"bat_toml": ""}, "bat_toml"),
    ({"bat_toml": "name = 'x'"}, "bat_toml"),
]


@pytest.mark.parametrize(("state", "field"), WRONG_STATES, ids=lambda value: str(value)[:40])
def test_wrong_controls_are_named(client: httpx.Client, state: dict[str, Any], field: str) -> None:
    response = client.post("/api/v1/explorer", json=state)
    assert response.status_code == 422, response.text
    error = response.json()["error"]
    assert error["field"] == field
    assert 10 < len(error["message"]) <= 500
    assert "Traceback" not in error["message"]
    assert "/work" not in error["message"]


@pytest.mark.parametrize(
    ("state", "words"),
    [
        ({"profile_in": [[0, 1]]}, "give at least 2; given were 1"),
        ({"profile_in": [[0, 1]] * 61}, "give at most 60; given were 61"),
        ({"profile_in": "x"}, "give a list; given was 'x'"),
        ({"bat": None}, "give a text"),
        ({"mass_oz": "x"}, "give a number; given was 'x'"),
    ],
)
def test_faults_are_told_in_our_own_words(client: httpx.Client, state: dict[str, Any], words: str) -> None:
    """None of pydantic's, which speak of tuples, validation and input."""
    assert client.post("/api/v1/explorer", json=state).json()["error"]["message"] == words


def test_no_name_opens_a_file(client: httpx.Client, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """A file that is a bat, named where a name of the catalogue is wanted, is refused like any unknown name."""
    Path(tmp_path / "own.toml").write_text(bat_toml(catalog.bat("youth-30").replaced(name="a secret")), "utf-8")
    monkeypatch.chdir(tmp_path)  # the server's too: it runs in this process
    rows = "bat,bat_speed_mph,exit_speed_mph\n" + "".join(f"own.toml,{60 + i},{80 + i}\n" for i in range(12))
    for view, state in (
        ("explorer", {"bat": "own.toml"}),
        ("compare", {"others": [{"bat": "./own.toml"}]}),
        ("sports", {"implement": "own.toml"}),
        ("player", {"swings_csv": rows}),
    ):
        response = client.post(f"/api/v1/{view}", json=state)
        assert response.status_code == 422 or view == "player"  # whose rows are told as bad ones
        assert "secret" not in response.text
        assert "own.toml" in response.text


BOMBS = {
    "nested arrays": "a=" + "[" * 9000,
    "nested tables": "[" + ".".join(["a"] * 4000) + "]",
    "dotted keys": "\n".join(f"{'a.' * 50}b{number} = 1" for number in range(150)),
    "powers": 'name = "x"\nlength = "9**9**9 in"\nmaterial = "white ash"\nlinear_density = [1.0]',
    "superscripts": 'name = "x"\nlength = "9⁹⁹⁹⁹⁹⁹⁹⁹ in"\nmaterial = "white ash"\nlinear_density = [1.0]',
    "many values": "name = 'x'\nlinear_density = [" + "1.0," * 3000 + "]",
    "not a number": 'name = "x"\nlength = "nan in"\nmaterial = "white ash"\nlinear_density = [1.0]',
    "infinite": 'name = "x"\nlength = "33 in"\nmaterial = "white ash"\nlinear_density = [inf]',
    "long integer": "a = " + "9" * 9000,
    "control letters": "a = '\x00'",
}


@pytest.mark.parametrize("name", BOMBS)
def test_bombs_are_refused(client: httpx.Client, name: str) -> None:
    response = client.post("/api/v1/bat", json={"toml": BOMBS[name]})
    assert response.status_code == 422, response.text
    assert response.json()["error"]["field"] == "toml"


BODIES = {
    "not JSON": (b"{", 422),
    "NaN": (b'{"pitch_speed_mph": NaN}', 422),
    "infinite": (b'{"pitch_speed_mph": 1e999}', 422),
    "a list": (b"[]", 422),
    "empty": (b"", 422),
    "not UTF-8": (b'{"bat": "\xff"}', 400),
    "deep": (b"[" * 30_000, 400),
    "10 MB": (b"x" * 10_000_000, 413),
    "just too large": (b" " * (LARGEST_BODY + 1), 413),
}


def test_a_body_that_is_no_json_names_no_control(client: httpx.Client) -> None:
    response = client.post("/api/v1/explorer", content=b"{", headers={"content-type": "application/json"})
    error = response.json()["error"]
    assert error["field"] == "" and error["message"] == NO_OBJECT


@pytest.mark.parametrize("name", BODIES)
def test_malformed_messages_are_refused(client: httpx.Client, name: str) -> None:
    body, status = BODIES[name]
    response = client.post("/api/v1/explorer", content=body, headers={"content-type": "application/json"})
    assert response.status_code in (status, 400, 422), response.text
    assert status != 413 or response.status_code == 413
    assert response.json()["error"]["message"]
    assert client.post("/api/v1/explorer", json={}).status_code == 200


def test_a_body_without_an_honest_length_is_stopped(client: httpx.Client) -> None:
    def endless() -> Any:
        for _ in range(100):
            yield b" " * 10_000

    response = client.post("/api/v1/explorer", content=endless(), headers={"content-type": "application/json"})
    assert response.status_code == 413
    assert "too large" in response.json()["error"]["message"]


def test_paths_do_not_reach_the_disk(client: httpx.Client) -> None:
    for path in (
        "/static/../server.py",
        "/static/%2e%2e/server.py",
        "/static//etc/passwd",
        "/..%2f..%2fetc/passwd",
        "/x",
    ):
        response = client.get(path)
        assert response.status_code == 404, path
        assert response.json()["error"]["message"].startswith("there is no page")


def test_pages_come_with_a_policy_and_a_tag(client: httpx.Client) -> None:
    response = client.get("/explorer")
    assert response.headers["content-type"].startswith("text/html")
    assert "default-src 'none'" in response.headers["content-security-policy"]
    assert response.headers["x-content-type-options"] == "nosniff"
    assert "microphone=(self)" in response.headers["permissions-policy"]
    module = client.get("/static/shell/main.js")  # no document, so what is said of documents is left out
    assert "content-security-policy" not in module.headers and module.headers["x-content-type-options"] == "nosniff"
    assert (response.headers["cache-control"], module.headers["cache-control"]) == ("no-cache", "max-age=20")
    again = client.get("/explorer", headers={"if-none-match": response.headers["etag"]})
    assert again.status_code == 304
    assert "http://" not in response.text.replace("http://www.w3.org", "")
    assert "https://" not in response.text


def test_files_travel_packed_to_those_who_can_unpack(server: str) -> None:
    packed = httpx.get(f"{server}/static/shell/main.js", headers={"accept-encoding": "gzip"})
    plain = httpx.get(f"{server}/static/shell/main.js", headers={"accept-encoding": "identity"})
    assert packed.headers["content-encoding"] == "gzip"
    assert "content-encoding" not in plain.headers
    assert packed.content == plain.content
    assert int(packed.headers["content-length"]) < len(plain.content) / 2
    answer = httpx.post(f"{server}/api/v1/explorer", json={}, headers={"accept-encoding": "gzip"})
    assert answer.headers["content-encoding"] == "gzip" and answer.json()["bat"]


def test_only_this_server_by_name_and_its_own_pages(client: httpx.Client, server: str) -> None:
    assert client.get("/", headers={"host": "evil.example"}).status_code == 421
    assert client.get("/", headers={"host": "[::1"}).status_code == 421
    foreign = client.post("/api/v1/explorer", json={}, headers={"origin": "https://evil.example"})
    assert foreign.status_code == 403
    assert client.post("/api/v1/explorer", json={}, headers={"origin": server}).status_code == 200
    asked = (("cross-site", "cors", 403), ("same-site", "no-cors", 403), ("cross-site", "navigate", 200))
    for site, mode, code in asked:
        of_others = {"sec-fetch-site": site, "sec-fetch-mode": mode}
        assert client.get("/explorer", headers=of_others).status_code == code
        assert client.post("/api/v1/explorer", json={}, headers=of_others).status_code == 403
    assert client.get("/explorer", headers={"sec-fetch-site": "none"}).status_code == 200
    assert client.get("/explorer?" + "x" * 40_000).status_code == 414


def test_the_api_describes_itself(client: httpx.Client) -> None:
    document = client.get("/api/v1/openapi.json").json()
    for name, view in VIEWS.items():
        body = document["paths"][f"/api/v1/{name}"]["post"]["requestBody"]["content"]["application/json"]["schema"]
        schema = document["components"]["schemas"][body["$ref"].rsplit("/", 1)[1]]
        assert set(schema["properties"]) == set(view.state.model_fields)
    assert client.get("/docs").status_code == 200
    assert json.dumps(document)


def test_a_fault_of_the_program_is_told_as_json(monkeypatch: pytest.MonkeyPatch) -> None:
    """As the API describes every refusal, and not in the server's own words."""
    import asyncio
    from concurrent.futures import ThreadPoolExecutor

    from sweetspot.web import answers, server

    def broken(self: object, name: str, state: object) -> None:
        raise ZeroDivisionError

    monkeypatch.setattr(answers.AnswerPool, "json", broken)

    async def asked() -> httpx.Response:
        transport = httpx.ASGITransport(app=server.create_app(), raise_app_exceptions=False)
        async with httpx.AsyncClient(transport=transport, base_url="http://localhost") as client:
            return await client.post("/api/v1/explorer", json={})

    with ThreadPoolExecutor(1) as pool:  # this thread may have the browser's loop
        response = pool.submit(asyncio.run, asked()).result()
    assert response.status_code == 500
    assert "report it" in response.json()["error"]["message"]


HOSTILE = ('baseball" if not __import__("os").system("id") else "', "$(id)")


def texts_of(name: str) -> list[str]:
    """Return the fields of a view that may hold any text; an uploaded bat's own text is handed out as a file only."""
    fields = VIEWS[name].state.model_json_schema()["properties"]
    return [field for field, one in fields.items() if one.get("type") == "string" and "enum" not in one]


@pytest.mark.parametrize("name", VIEWS)
def test_a_name_that_is_in_no_catalogue_has_no_lines(client: httpx.Client, name: str) -> None:
    """Lines are for people to copy and run, and a state may come from anybody's link."""
    used = {"bore_diameter_in": 1.0, "question": "corking", "start": "swing", "what_if": "change"}
    fields = texts_of(name)
    assert fields
    for field in fields:
        for text in HOSTILE:
            state = {
                key: value for key, value in {field: text, **used}.items() if key in VIEWS[name].state.model_fields
            }
            response = client.post(f"/api/v1/{name}/recipe", json=state)
            assert response.status_code == 422, (field, text, response.text)


def test_the_other_bats_of_a_comparison_are_names_of_the_catalogue_too(client: httpx.Client) -> None:
    response = client.post("/api/v1/compare/recipe", json={"others": [{"bat": "$(id)"}]})
    assert response.status_code == 422
    assert response.json()["error"]["field"] == "others.0.bat"


@pytest.mark.parametrize("path", ["/", "/explorer", "/static/page.css"])
def test_heads_of_pages_are_answered(client: httpx.Client, path: str) -> None:
    """As link checkers and monitors ask."""
    head, whole = client.head(path), client.get(path)
    assert head.status_code == whole.status_code
    assert head.content == b""


def test_a_ball_met_far_off_the_axis_goes_backwards(client: httpx.Client) -> None:
    """The launch angle goes on beyond a right angle, and the curves answer to the offset as the hit does."""
    state = {"offset_in": 2.5, "impact_from_tip_in": 6}
    found = client.post("/api/v1/explorer", json=state).json()
    hit, scan = found["hit"], found["scan"]
    assert math.pi / 2 < hit["launch_angle_rad"] < math.pi
    assert hit["backspin_rad_s"] > 0
    for name in ("exit_speed_m_s", "launch_angle_rad", "bbcor"):
        there = np.interp(hit["position_m"], scan["position_m"], [v if v is not None else math.nan for v in scan[name]])
        assert there == pytest.approx(hit[name], rel=2e-3), name


def test_where_the_energy_goes_sums_to_all_of_it(client: httpx.Client) -> None:
    for state in ({}, {"offset_in": 0.8}, {"bat": "composite"}):
        shares = client.post("/api/v1/explorer", json=state).json()["energy_shares"]
        assert np.sum([*shares.values()], axis=0) == pytest.approx(1, abs=1e-4)


def test_the_map_is_the_hit_at_every_place(client: httpx.Client) -> None:
    power = client.post("/api/v1/explorer/map", json={}).json()
    row, column = 16, 30
    place, above = power["position_m"][column], power["offset_m"][row]
    length = catalog.bat().length
    state = {"impact_from_tip_in": (length - place) / INCH, "offset_in": above / INCH}
    hit = client.post("/api/v1/explorer", json=state).json()["hit"]
    assert power["exit_speed_m_s"][row][column] == pytest.approx(hit["exit_speed_m_s"], abs=1e-3)


def test_why_here_adds_up_and_is_what_the_report_says(client: httpx.Client) -> None:
    found = client.post("/api/v1/explorer", json={"impact_from_tip_in": 2}).json()
    parts = found["difference_m_s"]
    assert parts["motion"] + parts["giving"] + parts["keeping"] == pytest.approx(parts["whole"], abs=1e-12)
    assert parts["motion"] > 0 > parts["keeping"]  # nearer to the tip it moves faster, and bends more
    assert parts["whole"] == pytest.approx(-found["lost_m_s"], abs=0.02)
    above = client.post("/api/v1/explorer", json={"impact_from_tip_in": 5.8, "offset_in": 0.7}).json()
    best, missed = above["why"]["us"]
    assert best.startswith("For a ball met in the middle this is the best place along the bat")
    assert f"(\N{MINUS SIGN}{above['lost_m_s'] / MPH:.1f} mph)" in missed  # all that is lost here
    told = client.post("/api/v1/explorer/why", json={}).json()["sentences"]
    assert any("Why not at the tip?" in one for one in told["us"])
    assert any("What a miss costs" in one for one in told["si"])


def test_where_a_ball_is_touched_twice_is_told_and_its_numbers_agree(client: httpx.Client) -> None:
    """Speeds jump where second touches begin: what is told of a place is of that place, not between neighbours."""
    bat = {"bat": "fast-pitch"}
    found = client.post("/api/v1/explorer", json={**bat, "impact_from_tip_in": 16}).json()
    assert found["hit"]["touched_again"]["us"]
    assert found["difference_m_s"]["whole"] == pytest.approx(-found["lost_m_s"], abs=0.05)
    elsewhere = client.post("/api/v1/explorer", json={**bat, "impact_from_tip_in": 8}).json()
    assert not elsewhere["hit"]["touched_again"]["us"]
    [told] = elsewhere["touched_again"]["us"]
    assert "hits it again" in told and "to 18.0 in from the tip" in told
    wooden = client.post("/api/v1/explorer", json={}).json()
    assert wooden["touched_again"]["us"] == []


def test_what_is_fouled_back_is_met_at_no_best_place(client: httpx.Client) -> None:
    found = client.post("/api/v1/explorer", json={"impact_from_tip_in": 5.8, "offset_in": 2.5}).json()
    assert abs(found["hit"]["launch_angle_rad"]) > math.pi / 2
    [told] = found["why"]["us"]
    assert "goes on backwards" in told and "best place" not in told
    assert found["lost_m_s"] is None


CONE = """name = "cone"
length = "33 in"
material = "white-ash"
profile = [["0 in", "1 in"], ["20 in", "1 in"], ["33 in", "2.5 in"]]
"""


def test_a_best_place_that_rests_on_a_second_push_is_not_crowned_without_a_word(client: httpx.Client) -> None:
    """A cone that whips: at its best place the ball is pressed several times."""
    found = client.post("/api/v1/explorer", json={"bat_toml": CONE, "impact_from_tip_in": 12.2}).json()
    [_, doubt, _] = found["headline"]["us"]
    assert "has not been measured" in doubt and "best place" in doubt
    here = found["hit"]["touched_again"]["us"]
    assert "it again" in here[0] and "By the first touch alone" in here[1]
    assert (
        client.post("/api/v1/hit", json={"bat_toml": CONE, "impact_from_tip_in": 12.2}).json()["hit"]["touched_again"][
            "us"
        ]
        == here
    )
    assert found["lost_m_s"] == pytest.approx(0, abs=0.7)  # the speed that is told is that of the place that is told
    assert any(
        doubt == one for one in client.post("/api/v1/explorer/why", json={"bat_toml": CONE}).json()["sentences"]["us"]
    )
    for bat in ("r161-ash", "fast-pitch", "youth-alloy", "uniform-rod"):
        assert len(client.post("/api/v1/explorer", json={"bat": bat}).json()["headline"]["us"]) == 2


def test_beside_a_jump_what_is_told_of_the_hit_is_of_that_hit(client: httpx.Client) -> None:
    """11.3 and 11.4 in from a cone's tip differ by 12 mph: shares and sting between them would be of neither."""
    asked = {"bat_toml": CONE, "impact_from_tip_in": 11.3}
    hit, scan = (client.post("/api/v1/explorer", json=asked).json()[name] for name in ("hit", "scan"))
    assert sum(hit["energy_shares"].values()) == pytest.approx(1, abs=1e-4)
    assert hit["energy_shares"]["ball"] == pytest.approx(hit["collision_efficiency"] ** 2, abs=1e-3)
    closest = np.argmin(np.abs(np.array(scan["position_m"]) - hit["position_m"]))
    assert hit["sting_m_s"] == pytest.approx(scan["sting_m_s"][closest], rel=0.1)
    assert "sting_m_s" not in client.post("/api/v1/explorer", json={}).json()["hit"]  # no jump: neighbours tell it


def test_modules_are_sent_without_their_comments_line_by_line(client: httpx.Client) -> None:
    from sweetspot.web.page_modules import FOLDER

    written = (FOLDER / "shell" / "main.js").read_text(encoding="utf-8").splitlines()
    sent = client.get("/static/shell/main.js").text.splitlines()
    assert len(sent) == len(written)  # a fault is told with the line of the source
    assert all(line in ("", source) for line, source in zip(sent, written, strict=True))
    assert not any(line.strip().startswith(("//", "/*")) for line in sent)
    assert "new App().start();" in sent
    formulas = client.get("/static/controls/formula.js").text  # a line of it has code behind its comment
    assert "/** @type {ChildNode} */ (node).replaceWith(" in formulas and formulas.rstrip().endswith("}")


def test_people_get_a_page_where_there_is_none(client: httpx.Client) -> None:
    response = client.get("/<b>x", headers={"accept": "text/html"})
    assert response.status_code == 404
    assert "<b>x" not in response.text
    assert 'href="/"' in response.text

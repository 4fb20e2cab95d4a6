"""Own bat: intervals that shrink with what is measured, contradictions by name, and taps that make tones."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import httpx
import pytest

WEIGHED: dict[str, Any] = {"weighed_oz": 31.0, "balanced_in": 22.05, "pendulum_ms": 1454.5}


def asked(client: httpx.Client, path: str = "", **fields: Any) -> dict[str, Any]:
    response = client.post(f"/api/v1/own{path}", json=fields)
    assert response.status_code == 200, response.text
    return dict(response.json())


def handed_in(client: httpx.Client, path: Path) -> str:
    content = path.read_bytes()
    key = str(client.post("/api/v1/uploads", json={"name": path.name, "size": len(content)}).json()["upload"])
    assert client.post(f"/api/v1/uploads/{key}/0", content=content).status_code == 200
    return key


def doubt(answer: dict[str, Any], name: str) -> float:
    return float(next(one["after"] for one in answer["unknowns"] if one["name"] == name))


def test_nothing_measured_is_the_bat_as_described(client: httpx.Client) -> None:
    answer = asked(client)
    assert answer["values"] == [] and answer["measurements"] == []
    assert answer["guesses"]["weighed_oz"] == pytest.approx(31.0, abs=0.1)
    assert [one["name"] for one in answer["expected"][:2]] == ["bending 1", "bending 2"]
    assert asked(client, "/file") == {}


def test_intervals_shrink_with_every_measurement_and_the_file_is_a_bat(client: httpx.Client) -> None:
    few = asked(client, weighed_oz=31.0)
    more = asked(client, **WEIGHED, tones=[["bending-1", 171.3, 0.4]])
    assert doubt(more, "density") < 0.7 * doubt(few, "density")
    assert doubt(more, "modulus") < 0.5 * doubt(few, "modulus")
    assert more["contradictions"]["us"] == [] and all(abs(one["sigma"]) < 3 for one in more["measurements"])
    toml = asked(client, "/file", **WEIGHED)["toml"]
    facts = client.post("/api/v1/bat", json={"toml": toml}).json()
    assert facts["mass_kg"] == pytest.approx(0.8788, abs=5e-4) and "calibrated" in facts["name"]
    assert "--mass 31oz±0.05oz" in asked(client, "/recipe", **WEIGHED)["command"]


def test_a_contradiction_is_named_and_keeps_the_file_back_until_it_is_left_out(client: httpx.Client) -> None:
    wrong = {**WEIGHED, "balanced_in": 23.05}
    answer = asked(client, **wrong)
    assert (
        "balance point lies" in answer["contradictions"]["us"][0]
        and "in and not 23.05 in" in answer["contradictions"]["us"][1]
    )
    assert not answer["values"] and not answer["unknowns"] and not answer["budget"]["us"]  # nothing is told of a bat
    assert {one["fitted"] for one in answer["measurements"]} == {None}
    described = asked(client)
    assert answer["fitted"] == described["fitted"] and answer["rules"] == described["rules"]
    refused = client.post("/api/v1/own/file", json=wrong)
    assert refused.status_code == 422 and "contradict" in refused.text
    without = asked(client, **wrong, left_out=["balance point"])
    assert without["contradictions"]["us"] == []
    assert [one["counts"] for one in without["measurements"]] == [True, False, True]


def test_taps_are_averaged_bad_ones_told_and_the_tones_named(client: httpx.Client, taps: Path) -> None:
    found = asked(client, "/tap", recordings=[handed_in(client, taps)])
    assert [one["good"] for one in found["taps"][:3]] == [True, True, False]
    assert all("doubled" in one["fault"] or "short" in one["fault"] for one in found["taps"][2:])
    heard = {name: (hertz, error) for name, hertz, error in found["measured"]}
    expected = {one["name"]: one["frequency_hz"] for one in asked(client)["expected"]}
    assert heard["bending-1"][0] == pytest.approx(expected["bending 1"], abs=3 * heard["bending-1"][1])
    assert [one["own"] for one in found["tones"] if one["name"] == "bending 1"] == [True]
    assert max(found["spectrum"]["level_db"]) == pytest.approx(0, abs=0.01) and found["damping"][0] > 0


@pytest.mark.parametrize(
    ("fields", "control"),
    [
        ({"bat": "composite"}, "bat"),
        ({"tones": [["bending-9", 100, 1]]}, "tones"),
        ({"pendulum_ms": 1500, "pivot_in": 20, "bat": "youth-30", "weighed_oz": 20}, "pivot_in"),
        ({"league": "moon"}, "league"),
        ({"weighed_oz": 500}, "weighed_oz"),
    ],
)
def test_what_cannot_be_is_told_beside_its_control(client: httpx.Client, fields: dict[str, Any], control: str) -> None:
    response = client.post("/api/v1/own", json=fields)
    assert response.status_code == 422 and response.json()["error"]["field"] == control


def test_a_sound_that_is_none_is_told_in_a_line_and_the_others_are_heard(
    client: httpx.Client, taps: Path, tmp_path: Path
) -> None:
    path = tmp_path / "noise.wav"
    path.write_bytes(b"RIFF nothing")
    bad, good = handed_in(client, path), handed_in(client, taps)
    found = asked(client, "/tap", recordings=[bad, good])
    [refused] = found["refused"]
    assert refused["recording"] == bad and "noise.wav cannot be read as a sound" in refused["fault"]
    assert "/tmp" not in refused["fault"]
    alone = asked(client, "/tap", recordings=[good])
    assert found["measured"] == alone["measured"] and alone["refused"] == []
    assert asked(client, "/tap", recordings=[bad]) == {
        "refused": [refused],
        "taps": [],
        "tones": [],
        "spectrum": None,
        "fault": None,
    }
    gone = client.post("/api/v1/own/tap", json={"recordings": ["A" * 16]})
    assert gone.status_code == 422 and "not here any more" in gone.text

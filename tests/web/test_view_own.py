"""Own bat: intervals that shrink with what is measured, contradictions by name, and taps that make tones."""

from __future__ import annotations

import json
import shlex
import subprocess
import sys
from pathlib import Path
from typing import Any

import httpx
import pytest

from sweetspot import catalog
from sweetspot.calibration.recording import recording_bytes, synthesised
from sweetspot.calibration.tap_analysis import modes_to_name

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


def test_who_contradicts_the_others_is_told_beside_its_control(client: httpx.Client) -> None:
    wrong = asked(client, **{**WEIGHED, "balanced_in": 23.05})["measurements"]
    [suspect] = [one for one in wrong if one["should"] is not None]
    assert suspect["field"] == "balanced_in" and suspect["should"] == pytest.approx(21.9 * 0.0254, abs=2e-3)
    renamed = asked(client, weighed_oz=31.0, balanced_in=22.05, tones=[["bending-2", 171.3, 0.4]])["measurements"]
    assert [one["right_tone"] for one in renamed if one["tone"] == "bending-2"] == ["bending-1"]
    outline = asked(client, bat="mlb-a", **WEIGHED, tones=[["bending-1", 171.3, 0.4], ["bending-2", 572.4, 1.0]])
    assert outline["contradictions"]["us"] and {one["should"] for one in outline["measurements"]} == {None}


def test_there_is_no_command_before_something_was_measured(client: httpx.Client) -> None:
    """`sweetspot calibrate` refuses a bat of which nothing is known."""
    for state in ({}, {"weighed_oz": 31.0, "left_out": ["mass"]}):
        lines = asked(client, "/recipe", **state)
        assert "command" not in lines and "once something was measured" in lines["note"]


def test_what_is_left_out_must_be_something_that_can_be_measured(client: httpx.Client) -> None:
    refused = client.post("/api/v1/own", json={"weighed_oz": 31, "left_out": ["weight"]})
    assert refused.status_code == 422 and refused.json()["error"]["field"] == "left_out"
    assert "'weight'" in refused.text and "mass, balance point" in refused.text
    command = asked(client, "/recipe", weighed_oz=31, left_out=["pendulum"])["command"]
    assert "--leave-out" not in command  # of what was not measured the command line knows nothing


@pytest.mark.parametrize(
    ("implement", "axis_m", "tone_hz"),
    [("tennis-racket", 0.1, 140), ("cricket-bat", 0, 132), ("golf-driver", 0, 41.8), ("hockey-stick", 0, 139)],
)
def test_other_sports_go_the_same_way(
    client: httpx.Client, tmp_path: Path, implement: str, axis_m: float, tone_hz: float
) -> None:
    """The numbers are the command's own: what is copied from the page gives them again."""
    described = asked(client, implement=implement)
    guesses = described["guesses"]
    assert guesses["pivot_in"] * 0.0254 == pytest.approx(axis_m)
    expected = described["expected"][0]
    assert expected["name"] == "bending 1" and expected["frequency_hz"] == pytest.approx(tone_hz, rel=0.01)
    measured = {name: guesses[name] for name in ("weighed_oz", "balanced_in", "swing_weight_oz_in2")}
    tones = [["bending-1", 1.05 * expected["frequency_hz"], 0.2]]
    answer = asked(client, implement=implement, **measured, tones=tones)
    assert answer["contradictions"]["us"] == [] and len(answer["measurements"]) == 4
    values = {one["name"]: one for one in answer["values"]}
    assert values["first_frequency"]["value"] == pytest.approx(1.05 * expected["frequency_hz"], rel=1e-3)
    command = asked(client, "/recipe", implement=implement, **measured, tones=tones)["command"]
    ran = subprocess.run(
        [sys.executable, "-m", "sweetspot", *shlex.split(command)[1:], "--format", "json"],
        cwd=tmp_path,
        capture_output=True,
        text=True,
        check=True,
    )
    told = json.loads(ran.stdout)["bat"]
    assert told["mass"]["mass_kg"] == pytest.approx(values["mass"]["value"], rel=1e-9)
    assert (tmp_path / "mine.toml").exists()
    toml = asked(client, "/file", implement=implement, **measured, tones=tones)["toml"]
    again = asked(client, implement=implement, implement_toml=toml)
    assert again["bat"]["mass_kg"] == pytest.approx(values["mass"]["value"], rel=1e-6)


def test_taps_are_averaged_bad_ones_told_and_the_tones_named(client: httpx.Client, taps: Path) -> None:
    found = asked(client, "/tap", recordings=[handed_in(client, taps)])
    assert [one["good"] for one in found["taps"][:3]] == [True, True, False]
    assert all("doubled" in one["fault"] or "short" in one["fault"] for one in found["taps"][2:])
    heard = {name: (hertz, error) for name, hertz, error in found["measured"]}
    expected = {one["name"]: one["frequency_hz"] for one in asked(client)["expected"]}
    assert heard["bending-1"][0] == pytest.approx(expected["bending 1"], abs=3 * heard["bending-1"][1])
    assert [one["from_bat"] for one in found["tones"] if one["name"] == "bending 1"] == [True]
    assert max(found["spectrum"]["level_db"]) == pytest.approx(0, abs=0.01) and found["damping"][0] > 0


@pytest.mark.parametrize(
    ("fields", "control"),
    [
        ({"bat": "composite"}, "bat"),
        ({"tones": [["bending-9", 100, 1]]}, "tones"),
        ({"pendulum_ms": 1500, "pivot_in": 20, "bat": "youth-30", "weighed_oz": 20}, "pivot_in"),
        ({"league": "moon"}, "league"),
        ({"implement": "table-tennis-racket"}, "implement"),
        ({"implement": "/etc/passwd"}, "implement"),
        ({"weighed_oz": 500}, "weighed_oz"),
    ],
)
def test_what_cannot_be_is_told_beside_its_control(client: httpx.Client, fields: dict[str, Any], control: str) -> None:
    response = client.post("/api/v1/own", json=fields)
    assert response.status_code == 422 and response.json()["error"]["field"] == control


def test_a_bat_that_is_held_and_one_that_is_another_count_for_nothing(
    client: httpx.Client, taps: Path, tmp_path: Path
) -> None:
    import numpy as np
    import soundfile

    samples, rate = soundfile.read(taps)
    time = np.arange(len(samples)) / rate
    since = time - 0.3 - np.floor(time - 0.3)  # a tap every second
    held = tmp_path / "held.wav"
    soundfile.write(held, samples * np.exp(-55 * since), rate, subtype="PCM_16")
    found = asked(client, "/tap", recordings=[handed_in(client, held)])
    assert "no tap can be used" in found["fault"] and found["measured"] == []
    assert "not free" in found["taps"][0]["fault"] and "--" not in found["taps"][0]["fault"]
    alloy = catalog.bat("college-alloy")
    sound = synthesised(modes_to_name(alloy), position=alloy.length - 0.025, listened=alloy.length - 0.025, taps=1)
    other = tmp_path / "other.wav"
    other.write_bytes(recording_bytes(sound, other))
    unlike = asked(client, "/tap", recordings=[handed_in(client, other)])
    assert unlike["unlike"] and "hardly" in " ".join([unlike["fault"] or "", *unlike["doubts"]])
    assert asked(client, "/tap", bat="college-alloy", recordings=[handed_in(client, other)])["fault"] is None


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
    nothing = asked(client, "/tap", recordings=[bad])
    assert nothing.pop("refused") == [refused] and not any(nothing.values())
    gone = client.post("/api/v1/own/tap", json={"recordings": ["A" * 16]})
    assert gone.status_code == 422 and "not here any more" in gone.text

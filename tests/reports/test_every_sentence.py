"""Sentences of plays, flights, tests, optima, players and seasons: their numbers stand in the answer's tables or data,
their direction words agree with the signs there, in either system of units."""

from __future__ import annotations

import math
import re
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import pytest

from sweetspot import catalog
from sweetspot.numerics.constants import STANDARD_AXIS
from sweetspot.numerics.interval import sure_sign
from sweetspot.player.goal import NO_GAIN
from sweetspot.reports.document import Document, Table
from sweetspot.reports.quantities import SI, SYSTEMS, US
from sweetspot.units import INCH, OUNCE
from tests.documented import DOCS, write_files
from tests.reports.told import Tell, blocks, check_sentences, numbers_after, sentences, tell, text_of

__all__ = ["tell"]
READERS = tuple(SYSTEMS.values())
DEGREE = 0.0175
AT_PARK = ("--park", "BOS")


def agrees(text: str, value: float, positive: str, negative: str, *, least: float = 1e-9) -> None:
    """Fail unless the word that is there is the one of the value's sign; a value below ``least`` may have neither."""
    found = (re.search(rf"\b{positive}\b", text) is not None, re.search(rf"\b{negative}\b", text) is not None)
    assert found == (value > 0, value < 0) if abs(value) > least else not all(found), (positive, negative, value, text)


def check_launch(text: str, launch: Mapping[str, Any]) -> None:
    """Up and down, right and left, backspin and topspin."""
    leaves = next(line for line in re.split(r"\.\s", text) if "leaves at" in line)
    agrees(leaves, launch["launch_angle_rad"], "up", "down")
    agrees(leaves, launch["spray_rad"], "to (the right|right field)", "to (the left|left field)", least=0.01 * DEGREE)
    agrees(leaves, launch["backspin_rad_s"], "backspin", "topspin", least=DEGREE)
    agrees(leaves, launch["sidespin_rad_s"], "bend it left", "bend it right", least=DEGREE)


@pytest.mark.parametrize(
    "words",
    [
        ("r161-ash", *AT_PARK),
        ("r161-ash", "--offset=-1.6in"),
        ("r161-ash", "--offset", "2.2in", *AT_PARK),
        ("single-wall", "--pitch", "curve", "--bats", "left", *AT_PARK),
        ("youth-30", "--pitch", "little-league-fastball", "--park", "little-league"),
        ("slow-pitch", "--pitch", "slow-pitch", "--park", "slow-pitch"),
    ],
    ids=" ".join,
)
def test_a_play(tell: Tell, words: tuple[str, ...]) -> None:
    document = tell("play", *words)
    data, text = document.data, check_place(document, words[0])
    check_launch(text, data)
    flight = data["flight"]
    bent = flight["bearing_rad"] - data["spray_rad"]
    spin_says_it = flight["carry_m"] <= 30 or abs(bent) <= DEGREE  # other code says how a long flight bends
    assert spin_says_it or f"bend it {'right' if bent > 0 else 'left'}" in text
    check_fence(text, data["fence"])


def test_a_miss(tell: Tell) -> None:
    document = tell("play", "r161-ash", "--offset", "3in", "--force")
    assert "miss" in check_place(document, "r161-ash") and document.data["exit_speed_m_s"] is None


def check_place(document: Document, bat: str) -> str:
    """Check a play's numbers and on which side of the ball's centre the bat comes; return its text."""
    text, data = text_of(document, US), document.data
    check_sentences(document, READERS, [catalog.bat(bat).length - data["position_m"]])
    assert f"{'below' if data['offset_m'] >= 0 else 'above'} the ball's centre" in text
    return text


def check_fence(text: str, fence: Mapping[str, Any] | None) -> None:
    if not fence or fence["clearance_m"] is None or fence["outcome"] == "foul":
        assert "its top:" not in text
        return
    over = fence["clearance_m"] > 0
    said = fence["outcome"]
    if chance := re.search(r"Of a hundred (?:hit )?like it (\d+) are home runs", text):  # the words follow it
        likely = int(chance[1]) > 50
        said = said if over == likely else f"such balls {'go out' if likely else 'stay in'} more often than not"
    assert f"{'over' if over else 'below'} its top: {said}" in text
    assert (fence["outcome"] == "home run") == over


AT_FENWAY = ("--exit-speed", "100mph", "--launch-angle", "28deg", *AT_PARK)
IN_A_WIND = ("--exit-speed", "104mph", "--launch-angle", "31deg", "--spray=-40deg", "--wind-speed", "12mph",
             "--wind-direction=-90deg", *AT_PARK)  # fmt: skip
ON_A_COURT = (
    ("--ball", "tennis", "--exit-speed", "57m/s", "--launch-angle=-6deg", "--backspin=-1500rpm", "--spray", "3deg",
     "--height", "2.7m", "--wind-speed", "4m/s"),
    ("--ball", "golf", "--exit-speed", "167mph", "--launch-angle", "10.9deg", "--backspin", "2686rpm", "--sidespin",
     "400rpm"),
    ("--ball", "shuttle", "--exit-speed", "60m/s", "--launch-angle", "30deg", "--height", "1m"),
)  # fmt: skip


@pytest.mark.parametrize("words", [AT_FENWAY, IN_A_WIND, *ON_A_COURT], ids=" ".join)
def test_a_flight(tell: Tell, words: tuple[str, ...]) -> None:
    document = tell("fly", *words)
    data, text = document.data, text_of(document, US)
    margins = [mark["margin_m"] for mark in data.get("court", {}).get("marks", [])]
    weather = [294.26111, 21.11111, 0.5, 6.4008, 12 * 0.44704, 4.0, math.pi / 2]  # of the options, or usual
    start = [document.rows[name][0] for name in ("right_m", "out_m")] if document.rows else []
    reached = ((document.rows["right_m"][-1] - start[0]) ** 2 + (document.rows["out_m"][-1] - start[1]) ** 2) ** 0.5
    bent = data["bearing_rad"] - data["launch"]["spray_rad"]
    check_sentences(document, READERS, [*margins, *weather, reached, bent])
    check_launch(text, data["launch"])
    assert set(re.findall(r"bends? it \S+ to the (right|left)", text)) <= {"right" if bent > 0 else "left"}
    check_fence(text, data.get("fence"))


def test_a_flight_in_the_parks(tell: Tell) -> None:
    document = tell("fly", *AT_FENWAY)
    data, text = document.data, text_of(document, US)
    assert f"home run in {data['out_in']} of {data['parks']} parks" in text
    assert f"{round(100 * data['home_run_chance'])} are home runs here" in text


@pytest.mark.parametrize("words", ON_A_COURT, ids=" ".join)
def test_a_flight_on_a_court(tell: Tell, words: tuple[str, ...]) -> None:
    document = tell("fly", *words)
    text, marks = text_of(document, US), document.data.get("court", {}).get("marks", [])
    assert bool(marks) != ("golf" in words)
    assert not re.search(r"centre field|right field|left field|home plate|home run", text)
    for mark in marks:
        told = next(line for line in re.split(r"(?<=[a-z])\. ?", text) if f"the {mark['name']}" in line)
        good = " over " if mark["side"] != "before" else " before "
        assert (good in told) == mark["good"], told


@pytest.mark.parametrize("words", [("r161-ash",), ("r161-ash", "--league", "all"), ("russell-b5", "--wall-that-passes"),
                                   ("youth-30",), ("corked-r161", "--league", "mlb"), ("slow-pitch",)],
                         ids=" ".join)  # fmt: skip
def test_a_bat_test(tell: Tell, words: tuple[str, ...]) -> None:
    document = tell("certify", *words)
    data, text = document.data, text_of(document, US)
    walls = [1e3 * wall["thickness_m"] for wall in data.get("walls", [])]
    check_sentences(document, READERS, walls)
    verdicts = [check["verdict"] for check in data["checks"]]
    headline = text.splitlines()[0]
    assert ("fails:" in headline) == ("fail" in verdicts) == (not data["passed"])
    kept = sum(check["verdict"] == "pass" and check["sure"] for check in data["checks"])
    decided = len(verdicts) - verdicts.count("does not apply")
    counted = f"{kept} of {decided}" in headline or (kept == decided and "every rule." in headline)
    assert counted == data["passed"]
    (first, *_) = sentences(document)
    limits = "allowed at most" in headline and numbers_after(first, "(")
    assert not limits or limits[0] > limits[1]
    margins = [
        check for check in data["checks"] if check["verdict"] in ("pass", "fail") and check["margin"] is not None
    ]
    for check in margins:
        assert abs(check["margin"]) <= 0.006 or (check["margin"] > 0) == (check["verdict"] == "pass"), check


def test_walls_that_pass(tell: Tell) -> None:
    document = tell("certify", "russell-b5", "--wall-that-passes")
    (wall,) = document.data["walls"]
    mass, before = numbers_after(document, "would weigh ")[:2]
    assert (mass > before) == (wall["factor"] > 1)


def test_the_best_way_to_hit(tell: Tell) -> None:
    document = tell("optimum")
    check_sentences(
        document, READERS, [catalog.bat("r161-ash").length - row["position_m"] for row in document.data["swings"]]
    )
    text = text_of(document, US)
    assert document.data["swings"]
    for row, line in zip(document.data["swings"], text.splitlines(), strict=False):
        agrees(line.split("tip, ")[1], row["undercut_m"], "below its", "above its")
        assert US.number(row["carry_m"], "distance") in line and row["pitch"] in line


def test_the_easiest_park(tell: Tell) -> None:
    document = tell("optimum", "--show", "parks", "--park", "all")
    check_sentences(document, READERS)
    parks, text = document.data["parks"], text_of(document, US)
    easiest = min(parks, key=lambda park: park["exit_speed_m_s"])
    assert f"Easiest to leave is {easiest['park']}: a ball of {US.shown(easiest['exit_speed_m_s'], 'speed')}" in text
    agrees(text, easiest["direction_rad"], "to right field", "to left field", least=0.01 * DEGREE)


def test_parks_say_what_their_fences_are(tell: Tell) -> None:
    """Tables only: their distances are those of the data, and a wall's span has its lower end first."""
    document = tell("parks")
    (table, *_) = [block for block in blocks(document) if isinstance(block, Table)]
    for row, park in zip(table.rows, document.data["parks"], strict=True):
        assert row[0] == park["key"]
        told = [
            park[f"{name}_m"] for name in ("left_field", "left_center", "center_field", "right_center", "right_field")
        ]
        assert list(row[4:9]) == told
        assert park["lowest_fence_m"] <= park["highest_fence_m"] < min(told)


@pytest.mark.parametrize("words", [("r161-ash", "--at", "4in-from-tip"), ("r161-ash", "--at", "14in-from-tip"),
                                   ("single-wall", "--at", "19in-from-tip"), ("tennis-racket", "--at", "16cm-from-tip"),
                                   ("golf-driver", "--at", "3cm-from-tip")], ids=" ".join)  # fmt: skip
def test_a_hit(tell: Tell, words: tuple[str, ...]) -> None:
    document = tell("hit", *words)
    hit = document.data
    differences = [hit["exit_speed_in_hands_m_s"] - hit["exit_speed_m_s"]] if hit.get("exit_speed_in_hands_m_s") else []
    if hit.get("first_touch_efficiency") is not None:
        differences.append(hit["closing_speed_m_s"] * (hit["first_touch_efficiency"] - hit["collision_efficiency"]))
    check_sentences(document, READERS, differences)


@pytest.fixture
def swings(tmp_path: Path) -> Path:
    write_files(tmp_path, DOCS / "users" / "coach.md")
    return tmp_path


@pytest.mark.parametrize(
    "goal", [("--goal", "exit-speed"), ("--goal", "line", "--line", "250ft", "--bat", "mlb-a")], ids=" ".join
)
def test_a_player(tell: Tell, swings: Path, goal: tuple[str, ...]) -> None:
    swung = "--bat" not in goal  # the bat whose speed is told
    if not swung:
        head, *rows = (line.split(",") for line in (swings / "swings.csv").read_text(encoding="utf-8").splitlines())
        for row in rows:
            row[head.index("bat")] = "r161-ash"
        (swings / "swings.csv").write_text("\n".join(",".join(row) for row in (head, *rows)), encoding="utf-8")
    document = tell("fit-player", str(swings / "swings.csv"), *goal)
    data, text = document.data, text_of(document, US)
    check_sentences(document, READERS, [OUNCE, INCH, INCH / 4, STANDARD_AXIS])
    assert text.count("12 swings count") == 1 and ("6 with R161" in text) == swung
    assert ("Bat speed is" in text, "which no swing of the file was made with" in text) == (swung, not swung)
    check_verdicts(document, data)


def check_verdicts(document: Document, data: Mapping[str, Any]) -> None:
    """A recommendation stands where the interval leaves zero, as it is told, out; "cannot tell" where it does not."""
    answers = {one["question"]: one["answer"] for one in data["answers"]}
    (change,) = {key for key in data["options"][0] if key.startswith("change_") and key != "change_probability"}
    options = {option["key"]: option for option in data["options"]}
    nothing = NO_GAIN[data["goal"]["name"]]
    question = "Heavier or lighter?"
    own = [one for one in data["options"] if one["family"] == "weight" and one["told_by_swings"]]
    sure = [one["label"] for one in own if one[change]["low"] > nothing]
    first = answers[question].split(".")[0].lower()
    assert first.startswith(f"best is {sure[0].lower()}") if sure else not first.startswith("best is")
    assert bool(own) != (answers[question] == "These swings cannot tell.")
    for one in own:
        told = re.search(re.escape(one["label"]) + r" ([-+])", answers[question])
        assert told is not None and (told[1] == "+") == (one[change]["value"] > -1e-12)
    (loaded,) = (value for key, value in data.items() if key.startswith("end_loaded_against"))
    ends_own = any(options[key]["told_by_swings"] for key in ("end-loaded", "knob-loaded"))
    for words, key, interval, is_own in (
        (("End-loaded", "Balanced"), "Balanced or end-loaded?", loaded, ends_own),
        (("Yes", "No"), "Choke up?", options["choke1in"][change], options["choke1in"]["told_by_swings"]),
    ):
        sign = sure_sign(interval["low"], interval["high"], nothing=nothing) if is_own else 0
        assert answers[key].startswith({1: words[0], -1: words[1], 0: "These swings cannot"}[sign])
    pairs = data["pairs"]
    for pair in pairs:
        gain = next(value for key, value in pair.items() if key.startswith("gain"))
        assert pair["better"] in answers["Which bat?"] and gain["value"] >= 0
        assert ("better" in pair["verdict"]) <= (gain["low"] > nothing)


def test_a_season(tell: Tell, swings: Path) -> None:
    document = tell("season", str(swings / "statcast_2024.csv.gz"), "--try", "mlb-a")
    text = text_of(document, US)
    check_sentences(document, READERS)
    (ledger, *_) = [block for block in blocks(document) if isinstance(block, Table)]
    heads = [str(column.heading) for column in ledger.columns]
    rows, used = (ledger.rows[-1][heads.index(name)] for name in ("rows", "used"))
    assert text.startswith(f"{rows} rows in one file; {used} balls in play with an exit speed.")
    players = document.rows
    expected, hit = round(sum(players["home_runs_expected"])), sum(players["home_runs"])
    assert f"Home runs: {expected} expected in the parks they were hit in, {hit} hit." in text
    assert sum(players["balls"]) == int(str(used).replace(",", ""))


def test_a_player_of_a_season(tell: Tell, swings: Path) -> None:
    document = tell("season", str(swings / "statcast_2024.csv.gz"), "--player", "592450", "--try", "mlb-a")
    data, text = document.data, text_of(document, SI)
    check_sentences(document, READERS)
    assert text.startswith(f"{data['balls']} balls in play") and f", {data['home_runs']} hit;" in text
    assert f"Home runs: {data['home_runs_expected']:.1f} expected" in text
    assert f"{data['mostly_gone']} mostly gone" in text
    gain = [data[f"gain_with_mlb_a_{end}m_s"] for end in ("", "low90_", "high90_")]
    assert data["best_bat"] == "mlb-a"
    assert numbers_after(document, "Of the bats tried mlb-a would serve best: ") == pytest.approx(gain)

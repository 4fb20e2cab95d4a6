"""`sweetspot fly` as a user meets it."""

from __future__ import annotations

import csv
import io
import json
import math
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from sweetspot.units import FOOT

Run = Callable[..., tuple[int, str, str]]
RunJson = Callable[..., Any]
FLIGHT = ("fly", "--exit-speed", "103mph", "--launch-angle", "28deg")
SHEET = ("--exit-speed", "103mph", "--launch-angle", "27.5deg", "--backspin", "2500rpm", "--sidespin", "0rpm",
         "--law", "trajectory-calculator", "--elevation", "15ft")  # fmt: skip


def test_the_published_run_in_words(run: Run) -> None:
    """Published: nathan_calculator, 421.5 ft in 5.52 s, 92.0 ft high, 55.5 mph; see the data tests for the 1 ft."""
    code, out, _ = run("fly", *SHEET)
    words = " ".join(out.split())
    assert code == 0
    assert "It carries 423 ft in 5.5 s, at most 92 ft high, and comes down 47° steep at 56 mph." in words
    assert "0.0745 lb/ft³; no wind" in words and "2500 rpm of backspin" in words and "usually" not in words


def test_border_contract(run_json: RunJson) -> None:
    found = run_json("fly", *SHEET)
    assert found["carry_m"] == pytest.approx(422.6 * FOOT, abs=0.1)
    assert {"hang_time_s", "apex_m", "landing_speed_m_s", "landing_angle_rad", "outcome", "launch"} < set(found)
    path = found["path"]
    assert path["time_s"][-1] == found["hang_time_s"] and path["up_m"][-1] == 0.0
    assert math.hypot(path["right_m"][-1], path["out_m"][-1]) == pytest.approx(found["carry_m"])


def test_usual_spin_is_named(run: Run, run_json: RunJson) -> None:
    _, out, _ = run("fly", "--bats", "left")
    assert "(what such hits usually have)" in " ".join(out.split())
    assert "1004 rpm that bend it left" in " ".join(out.split())
    assert run_json("fly", "--bats", "left")["launch"]["sidespin_rad_s"] == pytest.approx(1004 * math.pi / 30)


def test_a_park_and_all_the_others(run: Run, run_json: RunJson) -> None:
    _, out, _ = run("fly", *SHEET, "--park", "fenway")
    words = " ".join(out.split())
    assert "At Fenway Park it reaches the fence" in words and "of 30 parks" in words
    found = run_json("fly", *SHEET, "--park", "fenway")
    assert found["fence"]["outcome"] == "home run" and 0 < found["out_in"] <= found["parks"] == 30


def test_the_park_brings_its_elevation(run_json: RunJson) -> None:
    hit = SHEET[:-2]
    high, low = run_json("fly", *hit, "--park", "coors"), run_json("fly", *hit, "--park", "coors", "--elevation", "0ft")
    assert 25 < (high["carry_m"] - low["carry_m"]) / FOOT < 35


def test_under_a_roof_that_never_opens_no_breeze_blows(run: Run, run_json: RunJson) -> None:
    """There a ball flies by the law of still air; the mean park's breeze would cost it 5 ft."""
    hit = ("fly", "--elevation", "15ft")
    roofed, still, usual = (
        run_json(*hit, *more)["carry_m"]
        for more in (("--park", "tropicana"), ("--law", "baseball-in-still-air"), ("--park", "wrigley"))
    )
    assert roofed == pytest.approx(still) and 3 < (roofed - usual) / FOOT < 8
    _, out, _ = run(*hit, "--park", "tropicana")
    assert "still, under the roof" in " ".join(out.split())


def test_the_bearing_is_where_it_lands(run: Run, run_json: RunJson) -> None:
    found = run_json("fly", "--bearing", "-30deg")
    assert found["bearing_rad"] == pytest.approx(math.radians(-30), abs=1e-4)
    assert abs(found["launch"]["spray_rad"] - found["bearing_rad"]) > math.radians(1)
    again = run_json("fly", "--spray", f"{found['launch']['spray_rad']}rad")
    assert again["bearing_rad"] == pytest.approx(found["bearing_rad"], abs=1e-6)
    _, out, _ = run("fly", "--bearing", "0deg")
    assert "it lands to centre field" in " ".join(out.split())
    table = run_json("fly", "--bearing=-30deg:30deg:3")
    assert table["answers"]["carry_m"][0][0] == pytest.approx(found["carry_m"], abs=0.01)


def test_spray_and_bearing_are_one_or_the_other(run: Run) -> None:
    code, _, err = run("fly", "--bearing", "0deg", "--spray", "3deg")
    assert code == 2 and "both given" in err


def test_two_way_table(run: Run, run_json: RunJson) -> None:
    ranges = ("--exit-speed", "90mph:110mph:3", "--launch-angle", "20deg:40deg:5")
    _, out, _ = run("fly", *ranges)
    assert " ".join(out.split()).startswith(
        "Farthest of this table: 426 ft, at exit speed 110.0 mph and launch angle 25.0°."
    )
    lines = out[out.index("carry (ft)") :].splitlines()
    assert lines[0].strip() == "carry (ft): exit speed (mph) down, launch angle (°) across"
    assert lines[1].split() == ["20.0", "25.0", "30.0", "35.0", "40.0"]
    assert [line.split()[0] for line in lines[2:5]] == ["90.0", "100.0", "110.0"]
    found = run_json("fly", *ranges)
    assert found["rows"]["exit_speed_m_s"][1] == pytest.approx(44.704)
    assert len(found["answers"]["carry_m"]) == 3 and len(found["answers"]["carry_m"][0]) == 5
    single = run_json("fly", "--exit-speed", "100mph", "--launch-angle", "30deg")
    assert found["answers"]["carry_m"][1][2] == pytest.approx(single["carry_m"], abs=0.001)
    assert float(lines[3].split()[3]) == round(single["carry_m"] / FOOT)


def test_weather_down_and_elevation_across(run: Run) -> None:
    _, out, _ = run("fly", "--temperature", "50degF:90degF:3", "--elevation", "0ft:5000ft:2", "--cell", "hang-time")
    assert "In every cell: baseball (Major League); exit speed" in " ".join(out.split())
    lines = out[out.index("hang time (s)") :].splitlines()
    assert lines[0].strip() == "hang time (s): temperature (°F) down, elevation (ft) across"
    assert [line.split()[0] for line in lines[2:5]] == ["50", "70", "90"]


def test_one_way_table_as_csv(run: Run) -> None:
    _, out, _ = run("fly", "--wind-speed", "0mph:10mph:3", "--format", "csv")
    rows = list(csv.DictReader(io.StringIO(out)))
    carries = [float(row["carry_m"]) for row in rows]
    assert len(rows) == 3 and carries == sorted(carries)
    assert float(rows[2]["wind_speed_m_s"]) == pytest.approx(4.4704)


def test_path_as_csv(run: Run) -> None:
    _, out, _ = run("fly", "--format", "csv")
    rows = list(csv.DictReader(io.StringIO(out)))
    assert list(rows[0]) == ["time_s", "right_m", "out_m", "up_m"] and float(rows[-1]["up_m"]) == 0.0


def test_golf_flies_by_its_own_law(run_json: RunJson) -> None:
    found = run_json("fly", "--ball", "golf", "--exit-speed", "160mph", "--launch-angle", "11deg", "--height", "0m",
                     "--backspin", "3000rpm")  # fmt: skip
    assert 240 < found["carry_m"] / (3 * FOOT) < 280
    assert found["launch"]["sidespin_rad_s"] == 0.0


def test_files(run: Run, tmp_path: Path) -> None:
    code, _, err = run("fly", *SHEET, "--park", "yankees", "--out", str(tmp_path / "new"))
    assert code == 0 and "fly.png" in err
    assert (tmp_path / "new" / "fly.png").read_bytes()[:4] == b"\x89PNG"
    assert "<svg" in (tmp_path / "new" / "fly.svg").read_text(encoding="utf-8")
    assert json.loads((tmp_path / "new" / "fly.json").read_text(encoding="utf-8"))["outcome"] == "landed"


def test_a_shuttle_is_called_a_shuttle(run: Run) -> None:
    out = run("fly", "--ball", "shuttle", "--exit-speed", "60m/s", "--launch-angle", "30deg", "--height", "1m")[1]
    assert out.startswith("A shuttle leaves at 60.0 m/s")


def test_a_field_s_own_pressure_is_taken_at_no_elevation(run: Run) -> None:
    """Denver's barometer reads 24.6 inHg; not reduced to sea level it is meant with no elevation on top."""
    code, text, _ = run(*FLIGHT, "--pressure", "24.6inHg", "--elevation", "0ft")
    assert code == 0 and "carries" in text


def test_a_wind_in_words_is_that_of_its_angle(run: Run) -> None:
    """Exact; and answers for programs come by the short word too."""
    carries = [
        json.loads(run(*FLIGHT, "--wind-speed", "9mph", "--wind-direction", to, "--json")[1])["carry_m"]
        for to in ("in-from-lf", "135deg", "0deg")
    ]
    assert carries[0] == carries[1] < carries[2] - 10


def test_no_wind_bends_no_ball(run: Run) -> None:
    pulled = (*FLIGHT, "--spray", "20deg")
    assert "Its spin bends it" in " ".join(run(*pulled)[1].split())
    windy = (*pulled, "--wind-speed", "10mph", "--wind-direction", "0deg")
    assert "Its spin and the wind bend it" in " ".join(run(*windy)[1].split())

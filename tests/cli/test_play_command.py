"""The command `play`: the numbers of the library, a picture, a miss, and bad input."""

from __future__ import annotations

import math
import re
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from sweetspot import catalog
from sweetspot.analysis.bat_analysis import Analysis
from sweetspot.analysis.full_play import play
from sweetspot.catalog.standard_hit import standard_conditions
from sweetspot.collision.hit_in_space import Contact
from sweetspot.dynamics.reduction import reduced_bat
from sweetspot.equipment.bat import Bat
from sweetspot.flight.air import Air
from sweetspot.flight.conditions import FlightConditions
from sweetspot.motion.ball_motion import batted_ball
from sweetspot.motion.swing import Swing
from sweetspot.motion.swing_path import SwingPath
from sweetspot.numerics.interval import REACH
from sweetspot.uncertainty.sources import errors_by_ball
from sweetspot.units import DEGREE, FOOT, INCH, MPH, RPM

Run = Callable[..., tuple[int, str, str]]


def test_the_command_gives_the_librarys_numbers(run_json: Callable[..., Any]) -> None:
    found = run_json("play", "r161-ash", "--at", "5in-from-tip", "--offset", "0.5in", "--bat-speed", "74mph",
                     "--pitch-speed", "84mph", "--attack-angle", "11deg", "--bats", "left", "--temperature", "50degF",
                     "--elevation", "0ft", "--pressure", "1013.25hPa")  # fmt: skip
    bat, ball = catalog.bat("r161-ash"), catalog.ball()
    expected = play(
        reduced_bat(bat, ball=ball),
        FlightConditions(
            ball=ball,
            aerodynamics=catalog.aerodynamics("baseball"),
            air=Air(temperature=10.0, pressure=101325.0, humidity=0.5),
        ),
        swing=Swing(bat_speed=74 * MPH, measured_at=bat.length - 6 * INCH),
        path=SwingPath(attack_angle=11 * DEGREE, tilt=32 * DEGREE, bats="left"),
        pitch=batted_ball(
            speed=84 * MPH,
            launch_angle=-6 * DEGREE,
            spray=math.pi,
            backspin=2200 * RPM,
            position=(0.0, 2 * FOOT, 3 * FOOT),
        ),
        contact=Contact(bat.length - 5 * INCH, 0.5 * INCH),
    )
    assert expected.strike.launched is not None and expected.flight is not None
    assert found["exit_speed_m_s"] == pytest.approx(expected.strike.launched.speed, rel=1e-9)
    assert found["spray_rad"] == pytest.approx(expected.strike.launched.spray, rel=1e-9)
    assert found["flight"]["carry_m"] == pytest.approx(expected.flight.carry, rel=1e-6)
    assert found["fence"] is None


def test_a_park_judges_the_flight(run: Run) -> None:
    code, out, _ = run("play", "--park", "fenway", "--offset", "0.7in", "--bat-speed", "75mph")
    assert code == 0
    assert "Fenway Park" in out and "carries" in out


def test_a_play_is_as_sure_of_its_end_as_the_flight_alone(run_json: Callable[..., Any], run: Run) -> None:
    """A ball that just clears the fence is no sure home run; `fly` with the same launch says nearly the same chance.

    Balls that are hit alike do not leave alike; the fence is passed by so little that some more fall short of it.
    """
    asked = ("--park", "fenway", "--bat-speed", "73mph")
    played = run_json("play", *asked)
    options = {
        "exit-speed": f"{played['exit_speed_m_s']}m/s",
        "launch-angle": f"{played['launch_angle_rad']}rad",
        "spray": f"{played['spray_rad']}rad",
    } | {spin: f"{played[f'{spin}_rad_s']}rad/s" for spin in ("backspin", "sidespin", "gyrospin")}
    given = (f"--{name}={text}" for name, text in options.items())
    flown = run_json("fly", "--park", "fenway", *given)
    assert played["fence"]["outcome"] == "home run" and 0 < played["fence"]["clearance_m"] < 2
    assert played["home_run_chance"] == pytest.approx(flown["home_run_chance"], abs=0.03)
    assert 0.1 < played["home_run_chance"] < 0.9
    assert played["carry_spread_m"] == pytest.approx(flown["carry_spread_m"], rel=1e-6)
    assert played["home_run_chance_low"] < played["home_run_chance"] < played["home_run_chance_high"]
    chances = [round(100 * played[f"home_run_chance{end}"]) for end in ("", "_low", "_high")]
    printed = " ".join(run("play", *asked)[1].split())
    assert re.search(r"a hundred hit like it (\d+) are home runs: (\d+) if .*, (\d+) if", printed).groups() == tuple(  # type: ignore[union-attr]
        map(str, chances)
    )
    softball = run_json("play", "slow-pitch", "--park", "slow-pitch")  # nobody measured how those scatter
    assert softball["fence"] and "home_run_chance" not in softball and "carry_spread_m" not in softball


def test_the_roof_counts_in_the_chance(run_json: Callable[..., Any]) -> None:
    """Under a roof that never opens the mean ball flies by the law in still air, and the scatter knows of the roof."""
    asked = "--offset=0.9in", "--bats=left"
    roofed, fly = run_json("play", "--park", "tropicana", *asked), run_json
    options = [f"--{name}={roofed[f'{name}_rad_s']}rad/s" for name in ("backspin", "sidespin", "gyrospin")]
    options += [f"--exit-speed={roofed['exit_speed_m_s']}m/s", f"--launch-angle={roofed['launch_angle_rad']}rad"]
    flown = fly("fly", "--park", "tropicana", f"--spray={roofed['spray_rad']}rad", *options)
    assert roofed["home_run_chance"] == pytest.approx(flown["home_run_chance"], abs=0.03)


def test_a_named_pitch_is_thrown(run_json: Callable[..., Any], run: Run) -> None:
    """A curve arrives slower than a fastball, so it leaves slower too; topspin adds to what the bat gives."""
    fast, curve = (run_json("play", "--pitch", name) for name in ("fastball", "curve"))
    assert curve["pitch_speed_m_s"] < fast["pitch_speed_m_s"]
    assert curve["exit_speed_m_s"] < fast["exit_speed_m_s"]
    over, under = (run_json("play", "--pitch-backspin", spin)["backspin_rad_s"] for spin in ("-2000rpm", "2000rpm"))
    assert over > under
    slow = run_json("play", "--pitch", "fastball", "--release-speed", "80mph")
    assert 0.90 < slow["pitch_speed_m_s"] / (80 * MPH) < 0.94  # published: 0.920 on the way to the plate
    assert run("play", "--pitch", "fastball", "--pitch-speed", "90mph")[0] == 2
    assert run("play", "--release-speed", "90mph")[0] == 2


def test_a_miss_is_an_outcome(run_json: Callable[..., Any], run: Run) -> None:
    found = run_json("play", "--offset", "3in")
    assert (found["outcome"], found["flight"], found["exit_speed_m_s"]) == ("miss", None, None)
    code, out, _ = run("play", "--offset", "3in")
    assert code == 0 and "a miss" in out
    assert run("play", "--offset", "3in", "--format", "csv")[1] == "time_s,right_m,out_m,up_m\n"


def test_the_picture_is_written_whole(run: Run, tmp_path: Path) -> None:
    code, _, err = run("play", "--out", str(tmp_path / "new"))
    assert code == 0 and "wrote" in err
    assert sorted(file.name for file in (tmp_path / "new").iterdir()) == [
        "play.html",
        "play.json",
        "play.png",
        "play.svg",
    ]


def test_a_softball_flies_by_a_softballs_drag(run_json: Callable[..., Any]) -> None:
    """The bat decides which ball, the ball by which law it flies; another ball can be asked for."""
    bat, arguments = catalog.bat("slow-pitch"), ("--at", "6in-from-tip", "--offset", "0.9in")
    usual = run_json("play", "slow-pitch", *arguments)
    asked = run_json("play", "slow-pitch", *arguments, "--ball", "softball-12in")
    conditions = standard_conditions(bat)
    ball = conditions.ball
    flown = {}
    for law in ("softball", "baseball"):
        played = play(
            reduced_bat(bat, ball=ball),
            FlightConditions(ball=ball, aerodynamics=catalog.aerodynamics(law), air=Air()),
            swing=conditions.swing,
            path=SwingPath(attack_angle=9 * DEGREE, tilt=32 * DEGREE),
            pitch=batted_ball(
                speed=conditions.pitch.speed,
                launch_angle=-6 * DEGREE,
                spray=math.pi,
                backspin=2200 * RPM,
                position=(0.0, 2 * FOOT, 3 * FOOT),
            ),
            contact=Contact(bat.length - 6 * INCH, 0.9 * INCH),
        )
        assert played.flight is not None
        flown[law] = played.flight.carry
    assert usual["flight"]["carry_m"] == asked["flight"]["carry_m"] == pytest.approx(flown["softball"], rel=1e-3)
    assert abs(flown["baseball"] / flown["softball"] - 1) > 0.01


def test_hit_and_play_are_as_sure_of_the_ball_as_the_report(run: Run, analysis: Analysis[Bat]) -> None:
    """What balls of a kind differ by is in both; the report adds the bat, and draws have it in their intervals."""
    place = analysis.sweet_spots.max_exit_speed
    quick = errors_by_ball(analysis.reduced, conditions=analysis.conditions, position=place)
    assert quick is not None
    for words in (
        ("hit", "r161-ash", "--at", "5.8in-from-tip"),
        ("play", "r161-ash", "--at", "5.8in-from-tip", "--offset", "0in"),
    ):
        printed = " ".join(run(*words)[1].split())
        found = re.search(r"come off within (\d\.\d) mph of that.* known to (\d\.\d) mph", printed)
        assert found, printed
        assert float(found[1]) * MPH == pytest.approx(REACH * quick.scatter, abs=0.1 * MPH)
        assert float(found[2]) * MPH == pytest.approx(REACH * quick.common, abs=0.1 * MPH)
    assert "No two balls" not in run("hit", "r161-ash", "--at", "5.8in-from-tip", "--uncertainty")[1]

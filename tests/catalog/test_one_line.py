"""What a teacher writes in a notebook: an analysis in one line, arrays where they make sense, a plot of each answer."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest

import sweetspot
from sweetspot import catalog
from sweetspot.analysis.comparison import compare
from sweetspot.errors import InputError
from sweetspot.flight.air import VACUUM
from sweetspot.flight.kernel import Flights
from sweetspot.flight.trajectory import Flight
from sweetspot.motion.ball_motion import BallMotion, BallMotions, batted_ball

STANDARD = sweetspot.standard_flight().__class__(ball=catalog.ball(), aerodynamics=catalog.aerodynamics(), air=VACUUM)


def test_one_ball_or_many() -> None:
    """Exact: without air range = v^2 sin(2 a) / g; one by one and together give the same."""
    speeds, angle = np.array([30.0, 40.0]), math.radians(30)
    many = batted_ball(speed=speeds, launch_angle=angle, backspin=[100.0, 0.0])
    assert isinstance(many, BallMotions) and np.shape(many.velocity) == (2, 3)
    flown = sweetspot.trajectory(many, STANDARD)
    assert isinstance(flown, Flights)
    assert flown.carry == pytest.approx(speeds**2 * math.sin(2 * angle) / 9.80665, rel=1e-6)
    one = batted_ball(speed=40.0, launch_angle=angle)
    assert isinstance(one, BallMotion)
    single = sweetspot.trajectory(one, STANDARD)
    assert isinstance(single, Flight) and single.carry == pytest.approx(float(flown.carry[1]), rel=1e-6)
    with pytest.raises(InputError, match=r"math\.radians\(28\)"):
        batted_ball(speed=speeds, launch_angle=[0.4, 28.0])


def test_a_file_or_a_name_anywhere(tmp_path: Path) -> None:
    path = tmp_path / "own.toml"
    path.write_text('like = "r161-ash"\nname = "mine"\n', encoding="utf-8")
    assert sweetspot.bat(str(path)).name == "mine" and sweetspot.bat(path) == catalog.bat(path)
    assert sweetspot.implement("golf-driver").sport == "golf"
    with pytest.raises(InputError, match="Did you mean r161-ash"):
        sweetspot.bat("r161")


def test_conditions_and_analysis_in_one_line() -> None:
    bat = sweetspot.bat("r161-ash")
    assert sweetspot.standard_conditions(bat, pitch_speed=0.0).pitch.speed == 0.0
    assert sweetspot.standard_conditions(bat, bat_speed=30.0).swing.bat_speed == 30.0
    slower = sweetspot.standard_analysis("r161-ash", pitch_speed=30.0)
    assert slower.conditions == sweetspot.standard_conditions(bat, pitch_speed=30.0)


def test_every_answer_plots_and_stays_short_in_print() -> None:
    bat = sweetspot.bat("r161-ash")
    conditions = sweetspot.standard_conditions(bat)
    analysis = sweetspot.analyse(bat, conditions)
    flight = sweetspot.trajectory(
        batted_ball(speed=45.0, launch_angle=0.5, position=(0, 0, 1)), sweetspot.standard_flight()
    )
    comparison = compare([bat, catalog.bat("mlb-a")], conditions=conditions, law=catalog.swing_law())
    for answer in (analysis, flight, comparison, analysis.best):
        assert len(answer.plot().axes) > 0
        shown = answer._repr_html_()
        assert len(repr(answer)) < 600 and "<" in shown
        assert "var(--" not in shown and ".sweetspot" in shown  # a notebook has none of our page's colours
    with pytest.raises(InputError, match="has no picture"):
        bat.plot()

"""The best contact: it is a top, it is the limit that theory gives, and it is what the parts say."""

from __future__ import annotations

import math

import numpy as np
import pytest

from sweetspot import catalog
from sweetspot.analysis.bat_analysis import Analysis
from sweetspot.analysis.full_play import play
from sweetspot.analysis.optimum import BestSwing, Held, best_swing
from sweetspot.collision.hit_in_space import Contact
from sweetspot.collision.oblique_contact import Friction
from sweetspot.dynamics.reduction import ReducedBat
from sweetspot.equipment.bat import Bat
from sweetspot.errors import InputError
from sweetspot.flight.air import VACUUM, Air
from sweetspot.flight.conditions import FlightConditions
from sweetspot.motion.ball_motion import batted_ball
from sweetspot.motion.swing_path import SwingPath, SwingPlane
from sweetspot.units import DEGREE, FOOT, INCH, MPH, RPM

BALL, LAW, AIR = catalog.ball(), catalog.aerodynamics(), Air()
PITCH = batted_ball(
    speed=85 * MPH, launch_angle=-5 * DEGREE, spray=math.pi, backspin=2200 * RPM, position=(0.0, 0.6, 0.9)
)


@pytest.fixture(scope="module")
def model(analysis: Analysis) -> ReducedBat[Bat]:
    return analysis.reduced


@pytest.fixture(scope="module")
def best(model: ReducedBat[Bat], analysis: Analysis) -> BestSwing:
    return best_swing(
        model, FlightConditions(ball=BALL, aerodynamics=LAW, air=AIR), swing=analysis.conditions.swing, pitch=PITCH
    )


@pytest.mark.parametrize("change", [(1.0, 0, 0), (-1.0, 0, 0), (0, 0.04, 0), (0, -0.04, 0), (0, 0, 0.4), (0, 0, -0.4)])
def test_no_neighbour_is_farther(
    model: ReducedBat[Bat], analysis: Analysis, best: BestSwing, change: tuple[float, float, float]
) -> None:
    """By the readable collision and flight: 1 deg, 1 mm and 0.4 in to either side carry less; 1 cm for their steps."""
    turn, lift, along = change
    moved = play(
        model,
        FlightConditions(ball=BALL, aerodynamics=LAW, air=AIR),
        swing=analysis.conditions.swing,
        path=SwingPath(attack_angle=best.attack_angle + turn * DEGREE),
        pitch=PITCH,
        contact=Contact(best.position + along * INCH, best.offset + lift * INCH),
    )
    assert moved.flight is not None and moved.flight.carry < best.carry + 0.01


def test_the_answer_is_what_the_parts_say(model: ReducedBat[Bat], analysis: Analysis, best: BestSwing) -> None:
    again = play(
        model,
        FlightConditions(ball=BALL, aerodynamics=LAW, air=AIR),
        swing=analysis.conditions.swing,
        path=SwingPath(attack_angle=best.attack_angle),
        pitch=PITCH,
        contact=Contact(best.position, best.offset),
    )
    assert again.flight is not None and again.strike.launched is not None
    assert again.flight.carry == pytest.approx(best.carry, abs=0.01)
    assert again.strike.launched.velocity == pytest.approx(best.launched.velocity, abs=0.01)
    assert 25 < best.launched.launch_angle / DEGREE < 35 and 390 < best.carry / FOOT < 435
    reach = BALL.radius + float(model.bat.diameter_at(np.array(best.position))) / 2
    assert best.undercut == pytest.approx(reach * math.sin(best.attack_angle + math.asin(best.offset / reach)))


def test_the_place_is_that_of_the_greatest_exit_speed(analysis: Analysis, best: BestSwing) -> None:
    """Carry is bought with exit speed: within 0.25 in of where that is greatest head-on."""
    assert best.position == pytest.approx(analysis.sweet_spots.max_exit_speed, abs=0.25 * INCH)


def test_without_air_the_best_launch_is_half_a_right_angle(model: ReducedBat[Bat], analysis: Analysis) -> None:
    """A parabola from near the ground goes farthest at 45 deg; the exit speed changes slowly there, hence 2 deg."""
    found = best_swing(
        model, FlightConditions(ball=BALL, aerodynamics=LAW, air=VACUUM), swing=analysis.conditions.swing, pitch=PITCH
    )
    assert found.launched.launch_angle / DEGREE == pytest.approx(45, abs=2)
    assert found.carry > 180


def test_what_is_given_stays_and_costs_carry(model: ReducedBat[Bat], analysis: Analysis, best: BestSwing) -> None:
    place = model.bat.length - 4 * INCH
    held = best_swing(
        model,
        FlightConditions(ball=BALL, aerodynamics=LAW, air=AIR),
        swing=analysis.conditions.swing,
        pitch=PITCH,
        plane=SwingPlane(tilt=32 * DEGREE),
        held=Held(position=place, attack_angle=9 * DEGREE),
    )
    assert (held.position, held.attack_angle) == (place, 9 * DEGREE)
    assert held.carry < best.carry - 5


def test_topspin_is_worth_more_to_a_ball_that_rolls_off(model: ReducedBat[Bat], analysis: Analysis) -> None:
    """The two reasons why our curve is not the longest hit: gains of a curve as fast as the fastball, both ways."""
    curve = batted_ball(
        speed=85 * MPH, launch_angle=-5 * DEGREE, spray=math.pi, backspin=-2200 * RPM, position=(0.0, 0.6, 0.9)
    )
    gains = []
    for law, returned in ((LAW, 0.405), (LAW.replaced(drag_per_active_spin=0.0), 0.0)):
        carries = [
            best_swing(
                model,
                FlightConditions(ball=BALL, aerodynamics=law, air=AIR),
                swing=analysis.conditions.swing,
                pitch=pitch,
                friction=Friction(tangential_restitution=returned),
                held=Held(position=model.bat.length - 6 * INCH),
            ).carry
            for pitch in (curve, PITCH)
        ]
        gains.append(carries[0] - carries[1])
    assert 0 < gains[0] < gains[1]


def test_impossible_questions_are_refused(model: ReducedBat[Bat], analysis: Analysis) -> None:
    with pytest.raises(InputError, match="allowed is -20 to 60 deg"):
        best_swing(
            model,
            FlightConditions(ball=BALL, aerodynamics=LAW, air=AIR),
            swing=analysis.conditions.swing,
            pitch=PITCH,
            held=Held(attack_angle=1.2),
        )
    slow = analysis.conditions.swing.replaced(bat_speed=0.01)
    going = batted_ball(speed=5.0, launch_angle=0.0, position=(0.0, 0.6, 0.9))
    with pytest.raises(InputError, match="makes the ball fly"):
        best_swing(model, FlightConditions(ball=BALL, aerodynamics=LAW, air=AIR), swing=slow, pitch=going)

"""Which way the catalogue's pitches break, and how fast a ball's spin tires: signs and sizes that are published."""

from __future__ import annotations

import math

import pytest

from sweetspot import catalog
from sweetspot.flight.air import Air
from sweetspot.flight.conditions import FlightConditions
from sweetspot.flight.kernel import flights
from sweetspot.motion.ball_motion import batted_ball
from sweetspot.units import DEGREE, MPH, RPM

ARM_SIDE = {"four-seam": True, "sinker": True, "changeup": True, "slider": False, "curve": False}


@pytest.mark.parametrize(("pitch", "arm_side"), ARM_SIDE.items())
def test_pitches_break_to_their_side(pitch: str, arm_side: bool) -> None:
    """[savant_2020day]: a right-hander lets go left of the plate as the catcher sees it, and that is his arm side."""
    delivery = catalog.delivery(pitch)
    assert delivery.side < 0
    assert (math.sin(delivery.spin_axis) < 0) is arm_side
    assert (math.cos(delivery.spin_axis) < 0) is (pitch != "curve")  # all but curves are held up by their spin


@pytest.mark.parametrize("law", ["baseball", "pitched-baseball", "trajectory-calculator"])
def test_a_hit_keeps_most_of_its_spin(law: str) -> None:
    """[nathan_calculator]: 2500 rpm become 2418 in the first second at 103 mph, and exp(-0.15) of it in 5 s."""
    hit = batted_ball(speed=103 * MPH, launch_angle=27.5 * DEGREE, backspin=2500 * RPM, position=(0.0, 0.0, 0.9))
    done = flights(hit, FlightConditions(ball=catalog.ball(), aerodynamics=catalog.aerodynamics(law), air=Air()))
    assert 0.82 < done.spin_left[0] < 0.92

"""The table of a bat's hits says what the kernel says, between its nodes too."""

from __future__ import annotations

import numpy as np
import pytest

from sweetspot import catalog
from sweetspot.collision.contact_table import SPEED_ERROR, table_errors, tabled_bat
from sweetspot.collision.hit_in_space import Contact, strikes
from sweetspot.collision.kernel import hits
from sweetspot.motion.ball_motion import BallMotions
from sweetspot.motion.swing_path import Swings, path_axes
from sweetspot.units import DEGREE, INCH, RPM


@pytest.mark.parametrize("name", ["r161-ash", "youth-30", "college-alloy", "double-wall", "youth-alloy"])
def test_hits_between_the_nodes_are_the_kernel_s(name: str) -> None:
    """Wood, and walls from which balls are touched twice."""
    speed, angle = table_errors(tabled_bat(catalog.bat(name), ball=catalog.ball()), part=0.99)
    assert speed < SPEED_ERROR and angle < 0.02 * DEGREE


def test_spin_and_direction_of_one_hit() -> None:
    bat, ball = catalog.bat("r161-ash"), catalog.ball()
    table, swings = tabled_bat(bat, ball=ball), Swings(31.0, path_axes(0.15, 0.0, tilt=0.6, left=True), bat.choke)
    pitches = BallMotions(velocity=(0.5, -38.0, -4.0), spin=(-200.0, 30.0, 50.0))
    contact = Contact(bat.length - 5.1 * INCH, [-0.02, 0.01, 0.031])
    struck = strikes(table.model, ball=ball, swings=swings, pitches=pitches, contact=contact)
    tabled = table.launches(swings=swings, pitches=pitches, contact=contact)
    assert tabled.velocity == pytest.approx(struck.velocity, abs=0.003)
    assert tabled.spin == pytest.approx(struck.spin, abs=2 * RPM)


def test_efficiency_is_the_kernel_s() -> None:
    bat, ball = catalog.bat("mlb-a"), catalog.ball()
    table = tabled_bat(bat, ball=ball)
    from_tip, speed = np.meshgrid(np.linspace(0.3, 14, 41) * INCH, np.linspace(20.3, 80, 17))
    truth = hits(table.model.modes, ball=ball, position=bat.length - from_tip, closing_speed=speed)
    assert table.efficiency(from_tip, speed) == pytest.approx(truth.collision_efficiency, abs=1e-4)


def test_what_does_not_meet_has_no_answer() -> None:
    """A ball that runs away from the bat, one beside it, and a place where there is no bat."""
    bat, ball = catalog.bat("r161-ash"), catalog.ball()
    table = tabled_bat(bat, ball=ball)
    swings = Swings(10.0, path_axes(0.0, 0.0, tilt=0.0, left=False))
    away, at_it = (BallMotions(velocity=[(0.0, speed, 0.0)], spin=np.zeros(3)) for speed in (20.0, -20.0))
    for pitches, offset in ((away, 0.0), (at_it, 0.1)):
        launched = table.launches(swings=swings, pitches=pitches, contact=Contact([0.7], [offset]))
        assert np.isnan(launched.velocity).all()
    assert np.isnan(table.efficiency(0.1, [-3.0, 0.0, 50.0])).tolist() == [True, True, False]

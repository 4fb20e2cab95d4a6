"""The table of a bat's hits says what the kernel says, between its nodes too."""

from __future__ import annotations

import numpy as np
import pytest

from sweetspot import catalog
from sweetspot.collision.contact_table import SPEED_ERROR, tabled_bat
from sweetspot.collision.hit_in_space import Contact, strikes
from sweetspot.collision.kernel import hits
from sweetspot.motion.ball_motion import BallMotions
from sweetspot.motion.swing_path import Swings, path_axes
from sweetspot.units import INCH, RPM

HITS = 4000


@pytest.mark.parametrize("name", ["r161-ash", "youth-30", "college-alloy", "double-wall", "youth-alloy"])
def test_hits_between_the_nodes_are_the_kernel_s(name: str) -> None:
    """Wood, and walls from which balls are touched twice: off a tee or pitched, above and below the axis, with spin."""
    rng = np.random.default_rng(2)
    bat, ball = catalog.bat(name), catalog.ball()
    table = tabled_bat(bat, ball=ball)
    place, down = bat.length - rng.uniform(1, 14, HITS) * INCH, np.radians(rng.uniform(2, 12, HITS))
    pitch = rng.uniform(0, 45, HITS)
    swings = Swings(
        rng.uniform(18, 38, HITS),
        path_axes(rng.uniform(-0.3, 0.5, HITS), 0.0, tilt=rng.uniform(0.55, 0.9, HITS), left=False),
        bat.choke,
    )
    pitches = BallMotions(
        velocity=np.stack([rng.normal(0, 2, HITS), -pitch * np.cos(down), -pitch * np.sin(down)], axis=-1),
        spin=rng.normal(0, 1500 * RPM, (HITS, 3)),
    )
    contact = Contact(place, rng.uniform(-0.85, 0.85, HITS) * (ball.radius + bat.diameter_at(place) / 2))
    struck = strikes(table.model, ball=ball, swings=swings, pitches=pitches, contact=contact)
    tabled = table.launches(swings=swings, pitches=pitches, contact=contact)
    assert np.array_equal(np.isnan(struck.exit_speed), np.isnan(tabled.velocity[:, 0]))
    miss = np.linalg.norm(tabled.velocity - struck.velocity, axis=-1)
    assert np.quantile(miss, 0.99) < SPEED_ERROR
    assert np.quantile(np.linalg.norm(tabled.spin - struck.spin, axis=-1), 0.99) < 5 * RPM


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

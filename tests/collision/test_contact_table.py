"""The table of a bat's hits says what the kernel says, between its nodes too."""

from __future__ import annotations

import numpy as np
import pytest

from sweetspot import catalog
from sweetspot.collision.contact_lookup import fill_efficiency
from sweetspot.collision.contact_table import (
    BANDS,
    DIRECTION_ERROR,
    REACH,
    SPEED_ERROR,
    SPIN_ERROR,
    table_errors,
    tabled_bat,
)
from sweetspot.collision.hit_in_space import Contact, strikes
from sweetspot.collision.kernel import hits
from sweetspot.motion.ball_motion import BallMotions
from sweetspot.motion.swing_path import Swings, path_axes
from sweetspot.units import INCH, RPM

HOLLOW = ["composite", "college-alloy", "single-wall", "double-wall", "slow-pitch", "fast-pitch", "youth-alloy"]


@pytest.mark.parametrize("name", ["r161-ash", "youth-30", *HOLLOW])
def test_hits_between_the_nodes_are_the_kernel_s(name: str) -> None:
    """Wood, and walls from which balls are touched twice."""
    speed, direction, spin = table_errors(tabled_bat(catalog.bat(name), ball=catalog.ball()), part=0.999)
    assert speed < SPEED_ERROR and direction < DIRECTION_ERROR and spin < SPIN_ERROR


@pytest.mark.parametrize("name", ["r161-ash", "youth-30", *HOLLOW])
def test_what_a_certified_cell_answers_is_within_1e_4_of_the_converged_hit(name: str) -> None:
    table = tabled_bat(catalog.bat(name), ball=catalog.ball())
    rng, lookup = np.random.default_rng(5), table.lookup
    from_tip, closing = rng.uniform(0, REACH, 4000), rng.uniform(BANDS[1], BANDS[-1], 4000)
    found, left = np.empty(4000), np.empty(4000, np.bool_)
    fill_efficiency(lookup, from_tip, closing, found, left)
    position = table.bat.length - from_tip
    true = hits(table.model.modes, ball=table.ball, position=position, closing_speed=closing, step=1e-6)
    missed = np.abs(found - true.collision_efficiency) / np.maximum(true.collision_efficiency + 0.44, 0.2)
    assert (true.touches[~left] == 1).mean() > 0.999
    assert missed[~left].max() < 1e-4
    zone = (from_tip > INCH) & (from_tip < 10 * INCH) & (closing > 55) & (closing < 85)
    assert left[zone].mean() < (0.05 if name != "youth-alloy" else 0.3)  # from a thin wall balls are touched twice
    assert table.efficiency(from_tip, closing)[~left] == pytest.approx(found[~left], abs=0)


@pytest.mark.parametrize("name", ["r161-ash", "composite"])
def test_a_table_is_nearer_to_the_converged_hit_than_the_kernel(name: str) -> None:
    table = tabled_bat(catalog.bat(name), ball=catalog.ball())
    rng = np.random.default_rng(6)
    from_tip, closing = rng.uniform(1 * INCH, 10 * INCH, 2000), rng.uniform(55, 85, 2000)
    position = table.bat.length - from_tip
    true, ours = (
        hits(table.model.modes, ball=table.ball, position=position, closing_speed=closing, step=step)
        for step in (1e-6, None)
    )
    apart = [
        np.sqrt(np.mean(np.square(q - true.collision_efficiency)))
        for q in (table.efficiency(from_tip, closing), ours.collision_efficiency)
    ]
    assert apart[0] < 0.6 * apart[1]


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

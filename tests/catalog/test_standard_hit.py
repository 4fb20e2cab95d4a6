"""Every implement is hit at its own sport's stroke by its own sport's ball."""

from __future__ import annotations

import pytest

from sweetspot import catalog
from sweetspot.catalog.sports import sport
from sweetspot.catalog.standard_hit import standard_conditions
from sweetspot.units import INCH, MPH


def test_a_baseball_bat_meets_a_ninety_mile_pitch() -> None:
    bat = catalog.bat("r161-ash")
    usual = standard_conditions(bat)
    assert (usual.pitch.speed, usual.swing.bat_speed) == pytest.approx((90 * MPH, 70 * MPH))
    assert usual.swing.measured_at == pytest.approx(bat.length - 6 * INCH)
    assert usual.hands.position == pytest.approx(6 * INCH) and usual.ball == catalog.ball()


def test_a_softball_bat_meets_a_softball_at_a_softballs_speed() -> None:
    game = sport("slow-pitch")
    usual = standard_conditions(catalog.bat("slow-pitch"))
    assert usual.ball == catalog.ball(game.balls[0]) and usual.ball.mass > 1.2 * catalog.ball().mass
    assert usual.pitch.speed == game.stroke.ball_speed.value < 30 * MPH
    assert usual.swing.bat_speed == game.stroke.swing_speed.value


def test_a_youth_bat_is_swung_by_a_child() -> None:
    usual = standard_conditions(catalog.bat("youth-30"))
    assert usual.ball == catalog.ball()
    assert usual.pitch.speed < 60 * MPH and usual.swing.bat_speed < 60 * MPH

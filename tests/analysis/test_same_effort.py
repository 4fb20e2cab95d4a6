"""A changed bat in the hands of the player whose swing with it as it was is known."""

from __future__ import annotations

import pytest

from sweetspot import catalog
from sweetspot.analysis.comparison import ChangedBat, compare
from sweetspot.catalog.standard_hit import standard_conditions
from sweetspot.equipment.bat import Bat
from sweetspot.motion.swing import Conditions
from sweetspot.units import INCH, MPH, OUNCE

LAW = catalog.swing_law()
SPEED = 70 * MPH


def swung(bat: Bat) -> Conditions:
    """Return the swing of a bat at 70 mph, held by its own grip."""
    return standard_conditions(bat, bat_speed=SPEED)


def changed(bat: Bat) -> ChangedBat:
    return ChangedBat.of(bat, law=LAW)


def test_a_bat_as_it_is_was_not_changed(r161: Bat) -> None:
    assert r161.before_changes() is r161


@pytest.mark.parametrize("what", ["drilled", "cupped", "weighted", "choked up"])
def test_it_is_swung_as_compare_says(r161: Bat, what: str) -> None:
    """The comparison with the bat as it was, that bat the reference: the same swing, to rounding."""
    made = {
        "drilled": r161.drilled(diameter=1 * INCH, depth=10 * INCH),
        "cupped": r161.cupped(diameter=1.2 * INCH, depth=1 * INCH),
        "weighted": r161.weighted(position=r161.length - 2 * INCH, mass=2 * OUNCE),
        "choked up": r161.choked_up(1 * INCH),
    }[what]
    (_, other) = compare([r161, made], conditions=swung(r161), law=LAW).compared
    expected = other.analysis.conditions.swing
    found = changed(made).with_same_effort(swung(made)).swing
    assert found.bat_speed == pytest.approx(expected.bat_speed, rel=1e-12)
    assert (found.measured_at, found.pivot) == pytest.approx((expected.measured_at, expected.pivot))
    assert (found.bat_speed > SPEED) == (what in ("drilled", "cupped"))


def test_the_speed_before_is_found_again(r161: Bat) -> None:
    made = changed(r161.weighted(position=0.8, mass=0.05).choked_up(1.5 * INCH))
    turned = made.with_same_effort(swung(r161.choked_up(1.5 * INCH)))
    assert made.speed_before(turned) == pytest.approx(SPEED, rel=1e-12)


def test_an_inch_up_the_handle_is_a_mile_per_hour_slower(r161: Bat) -> None:
    """The barrel is an inch of 27 nearer to the axis, and turns faster by what the law gives for the smaller moment."""
    made = changed(r161.choked_up(1 * INCH))
    arm = r161.length - 6 * INCH
    turned = made.with_same_effort(swung(made.bat)).swing.bat_speed  # type: ignore[arg-type]
    assert turned == pytest.approx(SPEED * made.ratio * (arm - INCH) / arm, rel=1e-12)
    assert turned / MPH == pytest.approx(69.0, abs=0.1)

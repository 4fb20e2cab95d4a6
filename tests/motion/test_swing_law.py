"""How bat speed depends on the bat: limits, continuity, published values with their sources."""

from __future__ import annotations

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from sweetspot import references
from sweetspot.catalog.records import all_records, read_table
from sweetspot.catalog.swing_laws import FILE, swing_law, swing_law_names
from sweetspot.errors import InputError
from sweetspot.motion.swing import Swing
from sweetspot.motion.swing_law import SwingLaw, turned_faster
from sweetspot.units import OUNCE_INCH_SQUARED

MOI = st.floats(0.01, 1.0)


def law(exponent: float = 0.29, spread: float = 0.04) -> SwingLaw:
    return SwingLaw("test", exponent, spread, axis=0.0, lightest_moi=0.27)


@given(MOI, MOI)
def test_exponent_0_is_the_same_speed(moi: float, reference: float) -> None:
    assert law(0.0).speed_ratio(moi, reference_moi=reference) == 1.0  # exact


@given(MOI, MOI)
def test_exponent_one_half_is_the_same_energy_of_rotation(moi: float, reference: float) -> None:
    ratio = law(0.5).speed_ratio(moi, reference_moi=reference)
    assert moi * ratio**2 == pytest.approx(reference, rel=1e-12)  # exact: I omega^2


@given(MOI, MOI, MOI, st.floats(0.0, 0.5))
def test_the_way_from_bat_to_bat_does_not_matter(one: float, other: float, third: float, exponent: float) -> None:
    some = law(exponent)
    direct = some.speed_ratio(third, reference_moi=one)
    by_way = some.speed_ratio(other, reference_moi=one) * some.speed_ratio(third, reference_moi=other)
    assert by_way == pytest.approx(direct, rel=1e-12)
    assert some.speed_ratio(one, reference_moi=one) == 1.0


def test_power_law_for_ordinary_bats() -> None:
    ratio = law().speed_ratio(0.29, reference_moi=0.33)
    assert ratio == pytest.approx((0.29 / 0.33) ** -0.29, rel=1e-12)  # exact


def test_light_bats_are_capped_by_the_players_own_inertia() -> None:
    """Value and slope go on at the lightest studied bat; no bat at all is not swung infinitely fast."""
    some, edge, step = law(), 0.27, 1e-6
    below, above = (some.speed_ratio(edge * (1 + sign * step), reference_moi=edge) for sign in (-1, 1))
    assert (1 - below) / step == pytest.approx((above - 1) / step, rel=1e-4)
    assert (above - 1) / step == pytest.approx(-0.29, rel=1e-4)
    nothing = some.speed_ratio(1e-12, reference_moi=edge)
    assert nothing == pytest.approx(math.sqrt(1 / (1 - 2 * 0.29)), rel=1e-6)  # exact: sqrt((1 + b) / b), b = 1/2n - 1
    assert some.speed_ratio(0.1, reference_moi=edge) < (0.1 / edge) ** -0.29


def test_interval_of_the_exponent() -> None:
    exponents = swing_law("baseball").exponents
    assert (exponents.low, exponents.high) == pytest.approx((0.2242, 0.3558), abs=1e-4)  # 0.29 -+ 1.645 x 0.04
    wide = law(0.4, 0.2).exponents
    assert (wide.low, wide.high) == pytest.approx((0.4 - 1.6449 * 0.2, 0.5), abs=1e-4)


@pytest.mark.parametrize("name", swing_law_names())
def test_every_value_has_a_source_and_a_kind(name: str) -> None:
    entries = read_table(FILE)
    entry = next(entry for key, entry in entries.items() if key.replace("_", "-") == name)
    found, sources = all_records(entry, name), references.keys()
    assert {record.name.split(".")[1] for record in found} == {"exponent", "axis", "lightest_moi"}
    for record in found:
        assert record.source in sources
        assert record.source != "recalled" or record.kind == "assumed"
    assert 0 <= swing_law(name).exponent <= 0.5


def test_published_values() -> None:
    """nathan2011comparative: 0.29 +- 0.04 about the knob; smith2003swing: 0.25."""
    baseball, slow = swing_law(), swing_law("slow pitch")
    assert (baseball.exponent, baseball.exponent_spread, baseball.axis) == (0.29, 0.04, 0.0)
    assert slow.exponent == 0.25 and slow.axis == pytest.approx(0.1524)
    assert baseball.lightest_moi == pytest.approx(15000 * OUNCE_INCH_SQUARED)


def test_a_swing_told_at_another_place_turns_as_fast() -> None:
    swing = Swing(bat_speed=31.0, measured_at=0.69, pivot=0.0)
    other = turned_faster(swing, 1.05, measured_at=0.72, pivot=0.02)
    assert other.angular_speed == pytest.approx(1.05 * swing.angular_speed, rel=1e-12)
    assert turned_faster(swing, 1.0, measured_at=0.69, pivot=0.0) == swing


@pytest.mark.parametrize(
    ("make", "message"),
    [
        (lambda: law(0.6), "allowed is 0"),
        (lambda: law(-0.1), "allowed is 0"),
        (lambda: law(math.nan), "allowed is 0"),
        (lambda: law(0.3, -1.0), "zero or more"),
        (lambda: SwingLaw("test", 0.3, 0.0, 0.0, 0.0), "above zero"),
        (lambda: law().speed_ratio(-1.0, reference_moi=0.3), "moi is -1"),
        (lambda: law().speed_ratio(0.3, reference_moi=math.inf), "reference_moi is inf"),
        (lambda: law().speed_ratio(0.3, reference_moi=0.2, exponent=0.7), "allowed is 0"),
        (lambda: swing_law("base"), "baseball"),
    ],
)
def test_what_cannot_be_is_refused(make: object, message: str) -> None:
    assert callable(make)
    with pytest.raises(InputError, match=message):
        make()

"""Bats side by side: limits, signs, order, and corking against what is published."""

from __future__ import annotations

import numpy as np
import pytest

from sweetspot import catalog
from sweetspot.analysis.bat_analysis import exit_speed_of
from sweetspot.analysis.comparison import Comparison, best_exit_speeds, compare
from sweetspot.catalog.standard_hit import standard_conditions
from sweetspot.equipment.bat import Bat
from sweetspot.errors import InputError
from sweetspot.motion.swing_law import SwingLaw
from sweetspot.numerics.interpolants import peak
from sweetspot.units import INCH, MPH, OUNCE

HOLE = {"diameter": 1 * INCH, "depth": 10 * INCH}


def corkings(bat: Bat) -> list[Bat]:
    cork = catalog.material("cork")
    return [bat, bat.drilled(**HOLE), bat.corked(**HOLE, fill=cork), bat.corked(**HOLE, fill=cork, plug=1 * INCH)]


@pytest.fixture(scope="module")
def found() -> Comparison:
    bat = catalog.bat("r161-ash")
    return compare(
        corkings(bat),
        conditions=standard_conditions(bat),
        law=catalog.swing_law(),
        labels=["whole", "drilled", "open", "corked"],
    )


def test_identical_bats_differ_by_exactly_nothing(r161: Bat) -> None:
    result = compare(
        [r161, r161, r161.replaced(name="twin")], conditions=standard_conditions(r161), law=catalog.swing_law()
    )
    for other in result.compared:
        assert (other.change.value, other.change.low, other.change.high) == (0.0, 0.0, 0.0)
        assert other.break_even == other.bat_speed.value == result.reference.bat_speed.value


def test_drilled_is_lighter_than_corked_is_lighter_than_whole(found: Comparison) -> None:
    whole, drilled, open_end, corked = (other.analysis.body for other in found.compared)
    assert drilled.mass < open_end.mass < corked.mass < whole.mass
    assert drilled.moi(0.0) < open_end.moi(0.0) < corked.moi(0.0) < whole.moi(0.0)
    speeds = [other.bat_speed.value for other in found.compared]
    assert speeds[1] > speeds[2] > speeds[3] > speeds[0]
    assert [other.label for other in found.compared] == ["whole", "drilled", "open", "corked"]


def test_corking_as_published(found: Comparison) -> None:
    """nathan2011corked: q falls from 0.214 to 0.193 (the tolerance is that of its validation case); 2.9 mph needed."""
    whole, corked = found.compared[0], found.compared[3]
    assert whole.collision_efficiency - corked.collision_efficiency == pytest.approx(0.021, abs=0.007)
    assert (corked.break_even - whole.bat_speed.value) / MPH == pytest.approx(2.9, abs=1.0)  # q +-0.007 is +-1 mph
    assert abs(corked.bbcor - whole.bbcor) < 0.008  # no measurable trampoline effect
    assert 1.0 < (whole.analysis.body.mass - corked.analysis.body.mass) / OUNCE < 2.5  # nathan_corknote: 1 to 2 oz
    assert corked.bat_speed.value < corked.break_even and corked.change.high < 0


def test_break_even_breaks_even(found: Comparison) -> None:
    for other in found.compared:
        analysis = other.analysis
        swing = analysis.conditions.swing.replaced(bat_speed=other.break_even)
        (speed,) = best_exit_speeds(
            analysis.modes,
            analysis.scan.position[analysis.scan.position > analysis.body.balance_point],
            [analysis.conditions.replaced(swing=swing)],
        )
        assert speed == pytest.approx(found.reference.exit_speed.value, abs=1e-8)


def test_intervals_hold_their_values_and_grow_with_the_difference(found: Comparison) -> None:
    widths = []
    for other in found.compared:
        for interval in (other.bat_speed, other.exit_speed, other.change):
            assert interval.low <= interval.value <= interval.high
        widths.append(other.change.high - other.change.low)
    assert widths[0] == 0.0 and widths[1] > widths[2] > widths[3] > 0


def test_best_exit_speed_is_that_of_the_full_analysis(found: Comparison) -> None:
    """Two ways to the same number: the kernel's parabola and the readable collision at the best place."""
    for other in found.compared:
        full = exit_speed_of(other.analysis.best, other.analysis.conditions)
        assert other.exit_speed.value == pytest.approx(full, rel=2e-4)


def test_same_speed_and_exponent_0_agree_exactly(r161: Bat) -> None:
    bats, conditions = corkings(r161), standard_conditions(r161)
    flat = SwingLaw("flat", 0.0, 0.0, 0.0, 0.27)
    speed, effort = compare(bats, conditions=conditions, law=None), compare(bats, conditions=conditions, law=flat)
    assert speed.law is None and effort.law is flat
    for one, other in zip(speed.compared, effort.compared, strict=True):
        assert one.bat_speed == other.bat_speed and one.exit_speed == other.exit_speed
        assert one.bat_speed.value == conditions.swing.bat_speed


def test_exponent_one_half_gives_every_bat_the_same_energy(r161: Bat) -> None:
    bats, equal = corkings(r161), SwingLaw("equal", 0.5, 0.0, 0.0, 0.27)
    result = compare(bats, conditions=standard_conditions(r161), law=equal)
    energies = [
        other.analysis.body.moi(0.0) * other.analysis.conditions.swing.angular_speed**2 for other in result.compared
    ]
    assert energies == pytest.approx([energies[0]] * len(energies), rel=1e-12)


def test_the_order_of_the_others_does_not_matter(found: Comparison, r161: Bat) -> None:
    bats = corkings(r161)
    turned = compare([bats[0], *reversed(bats[1:])], conditions=standard_conditions(r161), law=catalog.swing_law())
    for one, other in zip(found.compared[1:], reversed(turned.compared[1:]), strict=True):
        assert one.exit_speed == other.exit_speed and one.change == other.change and one.break_even == other.break_even


def test_the_axis_of_the_law_is_used(r161: Bat) -> None:
    """The same exponent about 6 in instead of the knob gives another speed, that of the inertia there."""
    corked = corkings(r161)[3]
    about_6 = SwingLaw("six", 0.25, 0.0, 0.1524, 0.01)
    result = compare([r161, corked], conditions=standard_conditions(r161), law=about_6)
    first, second = (other.analysis for other in result.compared)
    expected = (second.body.moi(0.1524) / first.body.moi(0.1524)) ** -0.25
    ratio = second.conditions.swing.angular_speed / first.conditions.swing.angular_speed
    assert ratio == pytest.approx(expected, rel=1e-12)


def test_other_lengths_and_grips_keep_the_distance_from_the_tip(r161: Bat) -> None:
    youth, choked = catalog.bat("youth-30"), r161.choked_up(1 * INCH)
    result = compare([r161, youth, choked], conditions=standard_conditions(r161), law=catalog.swing_law())
    _, short, moved = (other.analysis for other in result.compared)
    assert youth.length - short.conditions.swing.measured_at == pytest.approx(6 * INCH)
    assert moved.conditions.swing.pivot == pytest.approx(1 * INCH)
    assert moved.conditions.hands.position == pytest.approx(7 * INCH)
    assert result.compared[1].break_even > result.compared[1].bat_speed.value


def test_no_break_even_within_what_a_swing_can_be_is_nan(r161: Bat) -> None:
    conditions = standard_conditions(r161)
    fast = conditions.replaced(swing=conditions.swing.replaced(bat_speed=66.0))
    result = compare([r161, catalog.bat("youth-30")], conditions=fast, law=None)
    assert np.isnan(result.compared[1].break_even)


def test_peak_of_a_parabola_is_exact() -> None:
    places = np.linspace(-1.0, 1.0, 9)
    assert peak(3.0 - 2.0 * (places - 0.1) ** 2) == pytest.approx(3.0, abs=1e-12)
    assert peak(np.array([1.0, 2.0, 3.0])) == 3.0 and peak(np.array([np.nan, 1.0, 0.5])) == 1.0


def test_nothing_to_compare_is_refused(r161: Bat) -> None:
    with pytest.raises(InputError, match="no bat was given"):
        compare([], conditions=standard_conditions(r161), law=catalog.swing_law())
    with pytest.raises(InputError, match="2 labels were given for 1 bats"):
        compare([r161], conditions=standard_conditions(r161), law=catalog.swing_law(), labels=["a", "b"])
    with pytest.raises(InputError, match="mph"):
        too_fast = standard_conditions(r161).swing.replaced(bat_speed=69.9)
        compare(
            [r161, r161.drilled(**HOLE)],
            conditions=standard_conditions(r161).replaced(swing=too_fast),
            law=catalog.swing_law(),
        )


def test_implements_of_different_sports_are_compared_only_when_somebody_insists() -> None:
    """The ball of the first would hit both; two round bats of different games stand the same ball."""
    bat, racket = catalog.bat("r161-ash"), catalog.implement("tennis-racket")
    with pytest.raises(InputError, match=r"is of baseball and .* of tennis; .* --force"):
        compare([bat, racket], conditions=standard_conditions(bat), law=None)
    softball = catalog.bat("slow-pitch")
    assert len(compare([bat, softball], conditions=standard_conditions(bat), law=None).compared) == 2

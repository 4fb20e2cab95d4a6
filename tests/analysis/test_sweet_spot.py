"""Every meaning of the sweet spot, on the flagship bat and on made-up curves."""

from __future__ import annotations

import dataclasses
from typing import Any

import numpy as np
import pytest

from sweetspot.analysis.bat_analysis import Analysis, analyse, check_conditions, exit_speed_of, hit_at
from sweetspot.analysis.position_scan import Scan, acceleration_weight, velocity_weight
from sweetspot.analysis.sweet_spot import barrel_node, max_collision_efficiency, max_exit_speed, miss_cost, sweet_zone
from sweetspot.catalog.standard_hit import standard_conditions
from sweetspot.collision.impact import Outcome
from sweetspot.equipment.bat import Bat
from sweetspot.errors import InputError
from sweetspot.motion.swing import Conditions
from sweetspot.units import INCH, MPH


def made_up(exit_speed: np.ndarray, sting: np.ndarray) -> Scan:
    position = np.linspace(0.4, 0.8, len(exit_speed))
    same: dict[str, Any] = {field.name: position for field in dataclasses.fields(Scan)}
    return Scan(**{**same, "exit_speed": exit_speed, "sting": sting})


def test_a_slender_handle_is_no_sweet_spot(analysis: Analysis) -> None:
    """A thin hollow handle swings back against the ball and throws it as well as the barrel; nobody hits there."""
    scan = analysis.scan
    thrown = scan.collision_efficiency.copy()
    thrown[scan.position < 0.35] = 0.9
    changed = dataclasses.replace(scan, collision_efficiency=thrown)
    usual = max_collision_efficiency(scan, body=analysis.body)
    assert (
        max_collision_efficiency(changed, body=analysis.body) == usual == analysis.sweet_spots.max_collision_efficiency
    )


def test_definitions_differ_and_lie_on_the_barrel(analysis: Analysis) -> None:
    spots = analysis.sweet_spots
    places = [value for field, value in dataclasses.asdict(spots).items() if field != "zone"]
    assert len({round(place, 4) for place in places}) == 6
    assert all(analysis.body.balance_point < place < analysis.bat.length for place in places)
    assert spots.node_1 < spots.min_sting < spots.node_2  # least sting lies between the nodes
    assert spots.max_collision_efficiency < spots.max_exit_speed  # the tip moves faster, which pulls the best point out


def test_best_hit_is_the_top_of_the_scan(analysis: Analysis) -> None:
    best = exit_speed_of(analysis.best, analysis.conditions)
    assert best == pytest.approx(np.nanmax(analysis.scan.exit_speed), rel=2e-4)
    for shift in (-0.01, 0.01):
        beside = hit_at(analysis.best.position + shift, modes=analysis.modes, conditions=analysis.conditions)
        assert exit_speed_of(beside, analysis.conditions) < best


def test_real_bat_beats_the_rigid_one_by_no_more_than_its_dent_gives_back(analysis: Analysis) -> None:
    """Nathan 2000: vibration only takes; what the dent of the wood gives back (up to 2 mph) is not in his model.

    Nor is a ball that loses by the rate of its compression: what gives way presses it more slowly, and costs it less.
    """
    less, more = (analysed_with(analysis, law) for law in (-1.0, 1.0))
    excess = [excess_on_the_barrel(one) for one in (less, analysis, more)]
    assert excess == sorted(excess)
    assert 0 < excess[0] < 2 * MPH  # hysteresis alone
    assert excess[2] - excess[0] < 1.5 * MPH


def analysed_with(analysis: Analysis, law: float) -> Analysis:
    conditions = analysis.conditions
    return analyse(analysis.bat, conditions.replaced(ball=conditions.ball.with_law(law)))


def excess_on_the_barrel(analysis: Analysis) -> float:
    barrel = analysis.scan.position > 0.6
    return float(np.max((analysis.scan.exit_speed - analysis.scan.rigid_exit_speed)[barrel]))


def test_hand_impulse_changes_sign_at_the_percussion_centre(analysis: Analysis) -> None:
    scan = analysis.scan
    crossing = np.interp(0.0, -scan.hand_impulse[60:], scan.position[60:])
    assert crossing == pytest.approx(analysis.sweet_spots.center_of_percussion, abs=1e-3)


def test_zone_of_made_up_curves() -> None:
    place = np.linspace(0.4, 0.8, 401)
    speed = 45.0 - 500 * (place - 0.7) ** 2
    loss = 500 * 0.05**2
    quiet = np.where(np.abs(place - 0.7) < 0.04, 0.1, 1.0)
    start, end = sweet_zone(made_up(speed, np.zeros(401) + 0.0 * place), loss=loss, sting=2.0) or (0.0, 0.0)
    assert (start, end) == (0.0, 0.0)  # no sting at all anywhere: nothing lies below half of zero
    start, end = sweet_zone(made_up(speed, quiet), loss=loss) or (0.0, 0.0)
    assert (start, end) == pytest.approx((0.66, 0.74), abs=2e-3)  # bounded by sting
    start, end = sweet_zone(made_up(speed, np.where(place < 0.5, 9.0, 1.0)), loss=loss) or (0.0, 0.0)
    assert (start, end) == pytest.approx((0.65, 0.75), abs=1e-3)  # bounded by speed
    assert sweet_zone(made_up(speed, np.where(np.abs(place - 0.7) < 0.1, 9.0, 0.1))) is None


def test_best_point_at_the_edge_is_reported_as_it_is() -> None:
    place = np.linspace(0.4, 0.8, 101)
    assert max_exit_speed(made_up(place, place)) == pytest.approx(0.8)
    inside, outside = miss_cost(made_up(place, place), 0.1)
    assert inside == pytest.approx(0.1) and np.isnan(outside)


def test_asking_for_a_mode_that_was_not_computed(analysis: Analysis) -> None:
    with pytest.raises(InputError, match="ask for more modes"):
        barrel_node(analysis.modes, harmonic=40)


def test_choking_up_moves_pivot_and_hands_together(r161: Bat) -> None:
    choked = r161.choked_up(1 * INCH)
    before, after = standard_conditions(r161), standard_conditions(choked)
    assert after.swing.pivot == pytest.approx(before.swing.pivot + INCH)
    assert after.hands.position == pytest.approx(before.hands.position + INCH)
    moved = analyse(choked, after).sweet_spots.center_of_percussion
    assert moved > analyse(r161, before).sweet_spots.center_of_percussion


def with_hands(analysis: Analysis, position: float) -> Conditions:
    return analysis.conditions.replaced(hands=analysis.conditions.hands.replaced(position=position))


@pytest.mark.parametrize(
    ("changed", "said"),
    [
        (lambda a: with_hands(a, 0.9), r"hand position is 0.9 m \(35.43 in\)"),
        (lambda a: with_hands(a, 0.5), "hold the handle"),
        (lambda a: a.conditions.replaced(swing=a.conditions.swing.replaced(measured_at=0.9)), "beyond the tip"),
        (lambda a: a.conditions.replaced(swing=a.conditions.swing.replaced(pivot=-2.0)), "pivot is -2 m"),
        (lambda a: a.conditions.replaced(ball=a.conditions.ball.replaced(mass=0.9)), "lighter than the bat"),
    ],
)
def test_impossible_conditions(analysis: Analysis, changed, said: str) -> None:  # type: ignore[no-untyped-def]
    with pytest.raises(InputError, match=said):
        check_conditions(analysis.reduced, changed(analysis))


def test_a_bat_that_runs_away_makes_no_contact(analysis: Analysis) -> None:
    """Behind a pivot in mid-handle the bat moves away from a slow ball: an outcome, not an error."""
    conditions = analysis.conditions.replaced(
        pitch=analysis.conditions.pitch.replaced(speed=0.0), swing=analysis.conditions.swing.replaced(pivot=0.3)
    )
    impact = hit_at(0.1, modes=analysis.modes, conditions=conditions)
    assert impact.outcome is Outcome.NO_CONTACT and np.isnan(impact.collision_efficiency)
    assert "does not reach" in impact.outcome.sentence


def test_answer_of_the_flagship(analysis: Analysis) -> None:
    """The main job's bands: Nathan 2000 and 2003, and the sources named in validation/."""
    scan, bat = analysis.scan, analysis.bat
    top = np.nanargmax(scan.collision_efficiency)
    assert 0.19 <= scan.collision_efficiency[top] <= 0.23
    assert 4 * INCH <= bat.length - scan.position[top] <= 7 * INCH
    hit = hit_at(bat.length - 6 * INCH, modes=analysis.modes, conditions=analysis.conditions)
    assert 30e3 <= hit.peak_force <= 42e3
    assert 0.6e-3 <= hit.contact_time <= 1.1e-3
    close = np.abs(scan.exit_speed / scan.rigid_exit_speed - 1) < 0.01
    width = np.ptp(scan.position[close & (scan.position > 0.6)])
    assert 0 < width < 3 * INCH  # equal to the rigid value only in a narrow zone
    assert scan.exit_speed[-1] < 0.65 * scan.rigid_exit_speed[-1]  # and falling sharply outside it
    assert abs(analysis.grip_effect) < 0.01
    assert exit_speed_of(analysis.best, analysis.conditions) / MPH == pytest.approx(103.4, abs=2.0)


def test_a_peak_too_narrow_to_hit_is_no_sweet_spot(analysis: Analysis) -> None:
    """A second push may give a spike of a few millimetres; one that half an inch holds counts."""
    scan = analysis.scan
    at = int(np.searchsorted(scan.position, 0.45))
    spike, hump = scan.exit_speed.copy(), scan.exit_speed.copy()
    spike[at] += 40.0
    hump[at - 3 : at + 4] += 40.0
    narrow, wide = (dataclasses.replace(scan, exit_speed=speed) for speed in (spike, hump))
    assert max_exit_speed(narrow) == max_exit_speed(scan)
    assert sweet_zone(narrow) == sweet_zone(scan)
    assert miss_cost(narrow, 0.02) == miss_cost(scan, 0.02)
    assert abs(max_exit_speed(wide) - scan.position[at]) < 0.02


def test_what_hands_feel_has_no_edge() -> None:
    """iso5349, annex A: 15.9 Hz / f from there to about 600 Hz, 0.7 of that at the end of the band, and smooth."""
    frequency = np.linspace(1.0, 5000.0, 5000)
    felt = velocity_weight(frequency)
    assert np.abs(np.diff(felt[50:])).max() < 2e-3  # a band from 50 to 700 Hz would jump by 1
    assert felt[99:600] == pytest.approx(1.0, abs=0.03)
    assert float(acceleration_weight(1258.9)) == pytest.approx(0.71 * 15.915 / 1258.9, rel=0.02)
    assert float(velocity_weight(0.0)) == 0.0


def test_least_sting_does_not_jump_where_mode_2_crosses_700_hz(r161: Bat) -> None:
    """A bat whose wood is a little stiffer: the place moves by less than a tenth of an inch for every per cent."""
    places = []
    for factor in (1.38, 1.42, 1.46, 1.50):
        material = r161.material
        stiff = r161.replaced(
            material=material.replaced(
                longitudinal_modulus=factor * material.longitudinal_modulus, shear_modulus=factor * material.shear
            )
        )
        found = analyse(stiff, standard_conditions(stiff))
        places.append(found.sweet_spots.min_sting)
        assert 600 < found.modes.frequency[3] < 760
    assert np.abs(np.diff(places)).max() < 0.1 * 0.0254 * 3

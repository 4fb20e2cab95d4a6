"""Rackets and clubs on the same bench as bats."""

from __future__ import annotations

import numpy as np
import pytest

from sweetspot import catalog
from sweetspot.analysis.certification.rules import Verdict, check_rules
from sweetspot.catalog.rules import league
from sweetspot.catalog.standard_hit import standard_conditions
from sweetspot.designs.batter import FROM_TIP, Batter, normal_contact
from sweetspot.designs.constraints import findings_of, league_limits
from sweetspot.designs.gain import GainVerdict, gain_of, present_measured
from sweetspot.designs.measures import Bench, bench_of
from sweetspot.designs.spaces import club_space, cricket_space, racket_space
from sweetspot.designs.variables import Space
from sweetspot.equipment.cricket_bat import CricketBat
from sweetspot.equipment.golf_club import GolfClub
from sweetspot.equipment.racket import Racket
from sweetspot.units import INCH


def bench(space: Space, contact: float) -> Bench:
    hit = standard_conditions(space.present)
    batter = Batter(
        normal_contact(contact, 0.4 * INCH), 0.0, 0.01 * INCH, hit.swing.bat_speed, hit.pitch.speed, None, 0.0,
        speed_from_tip=space.present.length - hit.swing.measured_at,
    )  # fmt: skip
    return bench_of(space, batter, hit)


def test_a_heavier_racket_at_the_same_speed_hits_harder() -> None:
    racket = catalog.load_implement("tennis-racket")
    assert isinstance(racket, Racket)
    space = racket_space(racket)
    rows = np.tile(space.start, (3, 1))
    rows[:, 1] *= [0.97, 1.0, 1.03]
    measured = bench(space, 6 * INCH).measured(rows)
    assert np.all(np.diff(measured.values["exit_speed"]) > 0)
    assert space.made(rows[2], "taped").moi == pytest.approx(rows[2, 1])


def test_a_heavier_head_at_the_same_speed_hits_harder() -> None:
    club = catalog.load_implement("golf-driver")
    assert isinstance(club, GolfClub)
    space = club_space(club)
    rows = np.tile(space.start, (3, 1))
    rows[:, 0] *= [0.9, 1.0, 1.1]
    measured = bench(space, 1.25 * INCH).measured(rows)
    assert np.all(np.diff(measured.values["exit_speed"]) > 0)


@pytest.fixture(scope="module")
def willow() -> Bench:
    bat = catalog.load_implement("cricket-bat")
    assert isinstance(bat, CricketBat)
    return bench(cricket_space(bat), 6 * INCH)


def test_the_present_cricket_bat_is_its_own_start(willow: Bench) -> None:
    start, now = willow.measured(willow.space.start), present_measured(willow)
    for name in ("exit_speed", "mass", "moi", "blade_depth", "blade_edge", "blade_width"):
        assert start.values[name][0] == pytest.approx(now.values[name][0], rel=1e-12)


def test_a_blade_that_swells_lower_hits_harder_low_and_picks_up_heavier(willow: Bench) -> None:
    rows = np.tile(willow.space.start, (2, 1))
    rows[1, 0] -= 0.08  # m, towards the toe
    values = willow.measured(rows).values
    assert values["exit_speed"][1] > values["exit_speed"][0] + 0.1 and values["moi"][1] > values["moi"][0]
    made = willow.space.made(rows[1], "low")
    assert isinstance(made, CricketBat) and made.spine[2][0] == pytest.approx(0.70)


def test_a_weighed_cricket_bat_keeps_its_willow(willow: Bench) -> None:
    bat = willow.space.present.replaced(mass=1.1)
    assert isinstance(bat, CricketBat)
    space = cricket_space(bat)
    made = space.made(space.start, "same")
    assert isinstance(made, CricketBat)
    assert made.mass == pytest.approx(1.1, rel=1e-9) and made.material == bat.material


def test_law_5_is_data_and_limits_the_blade(willow: Bench) -> None:
    """67 mm deep, edges of 40 mm, 108 mm wide, 965 mm long [cricket_bat_limits; cricket_bat_law]."""
    found = {one.measure: one.most for one in league_limits(league("cricket"), willow.space.present)}
    sizes = {"length": 0.965, "blade_width": 0.108, "blade_depth": 0.067, "blade_edge": 0.04}
    assert found == pytest.approx(sizes)
    deep = willow.space.start.copy()
    deep[1] = 0.070
    bat = willow.space.made(deep, "deep")
    checks = check_rules(
        league("cricket"),
        bat=bat,
        findings=findings_of(bat, willow.measured(deep), like=bat, ball=willow.conditions.ball),
    )
    assert {one.rule.quantity for one in checks if one.verdict is Verdict.FAIL} == {"blade_depth"}
    assert not league_limits(league("cricket"), catalog.bat("mlb-a"))
    assert not league_limits(league("mlb"), bat)


def test_two_pieces_of_one_model_hide_small_gains_of_every_sport(willow: Bench) -> None:
    """A design 1 % away in every number cannot be told from the present one."""
    near = 1.01 * willow.space.start
    gain = gain_of(willow, near, willow.measured(near), present_measured(willow))
    assert gain.wood > 0 and gain.shipment == 0 and gain.verdict is not GainVerdict.SEEN
    assert (gain.noise > 0).all()  # all of the outer 13 in are blade
    flat = np.array([*willow.space.start[:-1], 1.0])  # a back of two planes: nothing is less concave
    assert gain_of(willow, flat, willow.measured(flat), present_measured(willow)).wood > 0


def test_off_the_face_nothing_is_told() -> None:
    club = catalog.load_implement("golf-driver")
    assert isinstance(club, GolfClub)
    own = bench(club_space(club), 1.25 * INCH)
    heavier = own.space.start * [1.1, 1.0]
    gain = gain_of(own, heavier, own.measured(heavier), present_measured(own))
    on = club.head.height > FROM_TIP
    assert (gain.curve[on] > 0).all() and (gain.curve[~on] == 0).all() and (gain.noise[~on] == 0).all()

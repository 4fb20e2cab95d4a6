"""Rules of leagues: pass, fail, not decidable, does not apply."""

from __future__ import annotations

import math

import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from sweetspot import catalog, references
from sweetspot.analysis.certification.rules import (
    QUANTITIES,
    Check,
    Finding,
    Rule,
    Verdict,
    applies,
    check_rule,
    check_rules,
    construction_findings,
)
from sweetspot.analysis.certification.simulated_test import certify
from sweetspot.catalog.records import read_table
from sweetspot.catalog.rules import league, league_names
from sweetspot.catalog.sports import RULES
from sweetspot.dynamics.beam import beam_model
from sweetspot.dynamics.rigid import rigid_body
from sweetspot.equipment.ball import Ball
from sweetspot.equipment.bat import Bat, PointMass
from sweetspot.errors import InputError
from sweetspot.units import INCH, MPH

KEYS = set(references.keys())
WOOD_BATS = (
    "r161-ash", "russell-b1", "russell-b2", "russell-b3", "mlb-a", "mlb-b", "mlb-c", "mlb-d", "youth-30",
)  # fmt: skip


def checks(name: str, bat: Bat, **findings: Finding) -> dict[str, Check]:
    known = construction_findings(bat, body=rigid_body(beam_model(bat))) | findings
    return {check.rule.quantity: check for check in check_rules(league(name), bat=bat, findings=known)}


def rule(**changes: object) -> Rule:
    values: dict[str, object] = {
        "quantity": "bbcor", "least": None, "most": 0.5, "construction": "any", "undecided": "", "doubt_beyond": "",
        "source": "ncaa_bbcor", "where": "", "year": 2011, "reading": "primary",
    }  # fmt: skip
    return Rule(**(values | changes))  # type: ignore[arg-type]


@pytest.mark.parametrize("name", league_names())
def test_every_rule_has_a_source_and_says_how_it_was_read(name: str) -> None:
    found = league(name)
    assert catalog.ball(found.ball).name
    assert found.rules
    for rule in found.rules:
        assert rule.source in KEYS
        assert rule.reading in ("primary", "secondary", "recalled")
        assert rule.quantity in QUANTITIES
        limit = (rule.least, rule.most) != (None, None)
        assert rule.undecided or (rule.where and rule.reading != "recalled")
        assert not (limit and rule.reading == "recalled")  # a number known only from memory is never a limit


def test_limits_are_specified_records() -> None:
    rules = [rule for entry in read_table(RULES).values() for rule in entry.tables("rule")]
    limits = [rule.table(side) for rule in rules for side in ("least", "most") if side in rule]
    assert limits
    for limit in limits:
        assert set(limit) == {"value", "source", "where", "kind"}
        assert limit["kind"] in ("specified", "derived")


def test_the_numbers_are_those_of_the_sources() -> None:
    """Printed: mlb_rules, ncaa_bbcor, nathan2003sabr; quoted: bpf_limits, usabat."""
    most = {(name, one.quantity): one.most for name in league_names() for one in league(name).rules}
    assert most["mlb", "diameter"] == pytest.approx(2.61 * INCH)
    assert most["mlb", "length"] == pytest.approx(42 * INCH)
    assert (most["ncaa", "bbcor"], most["ncaa", "drop"]) == (0.5, 3.0)
    ncaa = {(one.quantity, one.construction): one.most for one in league("ncaa").rules}  # ncaa_bat_rule, 1-12
    assert ncaa["length", "not wood"] == pytest.approx(36 * INCH) and ncaa["length", "wood"] == pytest.approx(42 * INCH)
    assert ncaa["diameter", "not wood"] == most["usabat", "diameter"] == pytest.approx(2.625 * INCH)
    assert ncaa["diameter", "wood"] == pytest.approx(2.75 * INCH)
    assert most["ncaa-1999", "besr"] == 0.728
    assert (most["usssa", "bpf"], most["little-league", "bpf"], most["softball", "bpf"]) == (1.15, 1.15, 1.2)
    assert most["ncaa", "moi"] is None and most["asa", "batted_ball_speed"] == pytest.approx(98 * MPH)
    assert next(one for one in league("asa").rules).undecided


def test_a_limit_stands_once() -> None:
    """What a sport says of its limits is the league's own record."""
    limits = {
        limit.name: limit for name in ("baseball", "softball", "slow-pitch") for limit in catalog.sport(name).limits
    }
    assert limits["batted-ball speed of the bat test"].value == league("asa").rules[0].most
    assert limits["bat performance factor"].value == league("softball").rules[0].most == 1.2
    assert limits["BBCOR of bats not made of one piece of wood"].value == league("ncaa").rules[0].most == 0.5


@pytest.mark.parametrize("name", WOOD_BATS)
def test_wood_bats_need_not_meet_bbcor_and_would(name: str, baseball: Ball) -> None:
    """ncaa_bbcor: the limit lies above the best wood bat; ncaa_bat_rule, nfhs_bat_rule: one piece of wood is exempt."""
    bat = catalog.bat(name)
    findings = certify(bat, ball=baseball).findings()
    found = checks("ncaa", bat, **findings)
    assert found["bbcor"].verdict is Verdict.NOT_APPLICABLE and "one piece of wood" in found["bbcor"].reason
    glued = checks("ncaa", bat.replaced(material=bat.material.replaced(laminated=True)), **findings)["bbcor"]
    assert glued.verdict is Verdict.PASS
    assert 0.0 < (glued.margin or 0) < 0.014
    assert found["drop"].verdict is Verdict.NOT_APPLICABLE  # stated for bats that are not wood
    assert found["moi"].verdict is Verdict.NOT_APPLICABLE  # of the certification, which wood does not need
    assert found["length"].verdict is found["unaltered"].verdict is Verdict.PASS
    assert found["diameter"].verdict is (Verdict.FAIL if name == "russell-b3" else Verdict.PASS)  # its knob: 3.3 in


@pytest.mark.parametrize("name", ["torpedo", "r161-ash"])
def test_a_lively_one_piece_bat_is_no_fail_and_bamboo_is(name: str) -> None:
    bat, lively = catalog.bat(name), Finding(0.51)
    assert checks("nfhs", bat, bbcor=lively)["bbcor"].verdict is Verdict.NOT_APPLICABLE
    bamboo = checks("nfhs", bat.with_material(catalog.material("bamboo")), bbcor=lively)
    assert bamboo["bbcor"].verdict is Verdict.FAIL and bamboo["ring_gauge"].verdict is Verdict.NOT_DECIDABLE
    assert checks("mlb", bat.with_material(catalog.material("bamboo")))["solid_wood"].verdict is Verdict.FAIL


@pytest.mark.parametrize("name", ["mlb", "ncaa", "usssa", "softball"])
@pytest.mark.parametrize("fill", [None, "cork"])
def test_an_altered_bat_is_forbidden_whatever_its_number(name: str, fill: str | None, r161: Bat) -> None:
    own = None if fill is None else catalog.material(fill)
    holed = (
        r161.drilled(diameter=0.0254, depth=0.2) if own is None else r161.corked(diameter=0.0254, depth=0.2, fill=own)
    )
    assert checks(name, holed, bbcor=Finding(0.3))["unaltered"].verdict is Verdict.FAIL
    assert checks(name, r161)["unaltered"].verdict is Verdict.PASS


def test_metal_has_its_own_sizes_and_wood_its_own() -> None:
    metal, wood = catalog.bat("russell-b5"), catalog.bat("r161-ash")
    for bat, longest in ((metal, 36), (wood, 42)):
        known = construction_findings(bat, body=rigid_body(beam_model(bat)))
        held = [one for one in check_rules(league("ncaa"), bat=bat, findings=known) if one.rule.quantity == "length"]
        assert [one.rule.most for one in held] == [pytest.approx(longest * INCH)]


@pytest.mark.parametrize(
    ("wider", "verdict", "sure"), [(-1e-4, Verdict.PASS, True), (1e-4, Verdict.PASS, False), (3e-4, Verdict.FAIL, True)]
)
def test_a_barrel_too_wide_by_less_than_a_caliper_tells_is_no_fail(wider: float, verdict: Verdict, sure: bool) -> None:
    """A calibrated bat's barrel comes out of the fit a few hundredths of a millimetre off the drawn one."""
    limited = rule(quantity="diameter", most=2.625 * INCH)
    found = check_rule(limited, bat=catalog.bat(), finding=Finding(2.625 * INCH + wider))
    assert (found.verdict, found.sure) == (verdict, sure)


def test_one_piece_of_solid_wood(r161: Bat) -> None:
    cork = catalog.material("cork")
    assert checks("mlb", r161)["solid_wood"].verdict is Verdict.PASS
    assert checks("mlb", r161.corked(diameter=0.0254, depth=0.2, fill=cork))["solid_wood"].verdict is Verdict.FAIL
    assert checks("mlb", r161.drilled(diameter=0.0254, depth=0.2))["solid_wood"].verdict is Verdict.FAIL
    assert checks("mlb", catalog.bat("russell-b5"))["solid_wood"].verdict is Verdict.FAIL
    weighted = checks("mlb", r161.weighted(position=0.7, mass=0.02))["solid_wood"]
    assert weighted.verdict is Verdict.NOT_DECIDABLE and "inside the wood" in weighted.reason
    taped = r161.replaced(point_masses=(PointMass(position=0.0, mass=0.005, on_surface=True),))
    assert checks("mlb", taped)["solid_wood"].verdict is Verdict.PASS


def test_cups(r161: Bat) -> None:
    none, good, deep, wide = (
        checks("mlb", bat)
        for bat in (
            r161,
            r161.cupped(diameter=1.4 * INCH, depth=0.9 * INCH),
            r161.cupped(diameter=1.4 * INCH, depth=1.2 * INCH),
            r161.cupped(diameter=0.8 * INCH, depth=0.9 * INCH),
        )
    )
    assert none["cup_depth"].verdict is none["cup_diameter"].verdict is Verdict.NOT_APPLICABLE
    assert good["cup_depth"].verdict is good["cup_diameter"].verdict is Verdict.PASS
    assert deep["cup_depth"].verdict is Verdict.NOT_DECIDABLE and "not in the catalogue" in deep["cup_depth"].reason
    assert wide["cup_diameter"].verdict is Verdict.FAIL
    assert wide["cup_diameter"].margin == pytest.approx(-0.2 * INCH)


def test_metal_and_composite() -> None:
    metal = catalog.bat("russell-b5")
    found = checks("ncaa", metal)
    assert found["drop"].verdict is Verdict.PASS and found["drop"].margin == pytest.approx(3 - (33 - 31.4), abs=1e-6)
    assert found["diameter"].verdict is Verdict.PASS  # 2 5/8 in to the last digit
    assert found["break_in"].verdict is Verdict.NOT_APPLICABLE
    light = checks("ncaa", metal, drop=Finding(4.0))["drop"]
    assert light.verdict is Verdict.FAIL and light.margin == -1.0
    weighed = checks("ncaa", metal, drop=Finding(3.004))["drop"]
    assert weighed.verdict is Verdict.PASS  # a scale reads hundredths of an ounce


@pytest.mark.parametrize("name", catalog.bat_names())
def test_every_bat_is_either_wood_or_not(name: str) -> None:
    bat = catalog.bat(name)
    wood, other = (applies(rule(construction=kind), bat) for kind in ("wood", "not wood"))
    assert wood != other
    composite, laminate = applies(rule(construction="composite"), bat), bat.shell is not None and bat.shell.laminate
    assert not (wood and composite)
    assert composite or not laminate


def test_nothing_known_decides_nothing(r161: Bat) -> None:
    found = checks("usssa", r161)["bpf"]
    assert found.verdict is Verdict.NOT_DECIDABLE and found.margin is None and "nothing is known" in found.reason


@given(value=st.floats(0.2, 0.8), most=st.floats(0.3, 0.7))
def test_margin_has_the_sign_of_the_verdict(value: float, most: float) -> None:
    found = check_rule(rule(most=most), bat=catalog.bat(), finding=Finding(value))
    assert found.margin == pytest.approx(most - value)
    assume(abs(value - most) > 1e-5)
    assert found.verdict is (Verdict.PASS if value < most else Verdict.FAIL)


def test_an_interval_across_the_limit_is_said(r161: Bat) -> None:
    found = check_rule(rule(), bat=r161, finding=Finding(0.499, interval=(0.49, 0.508)))
    assert found.verdict is Verdict.PASS and "reaches across the limit" in found.reason


def test_a_doubt_beats_a_value(r161: Bat) -> None:
    found = check_rule(rule(), bat=r161, finding=Finding(0.6, "only two hits"))
    assert found.verdict is Verdict.NOT_DECIDABLE and found.reason == "only two hits"
    assert check_rule(rule(), bat=r161, finding=Finding(math.nan)).verdict is Verdict.NOT_DECIDABLE


@pytest.mark.parametrize(
    ("changes", "message"),
    [
        ({"quantity": "colour"}, "known quantities"),
        ({"most": None}, "a limit or the reason"),
        ({"reading": "recalled"}, "only from memory"),
    ],
)
def test_impossible_rules_are_refused(changes: dict[str, object], message: str) -> None:
    with pytest.raises(InputError, match=message):
        rule(**changes)


def test_an_unknown_league_names_the_nearest() -> None:
    with pytest.raises(InputError, match="ncaa"):
        league("nca")
    with pytest.raises(InputError, match=r"ncaa \(nfhs, high-school"):
        league("xyzzy")

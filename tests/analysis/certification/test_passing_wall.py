"""Legal hollow bats: that there are some, what makes them so, and the wall that would just pass."""

from __future__ import annotations

import math

import pytest

from sweetspot import catalog
from sweetspot.analysis.certification.passing_wall import wall_that_passes
from sweetspot.analysis.certification.rules import Verdict, check_rules, construction_findings
from sweetspot.analysis.certification.simulated_test import certify
from sweetspot.catalog.rules import league
from sweetspot.dynamics.beam import beam_model
from sweetspot.dynamics.rigid import rigid_body
from sweetspot.equipment.ball import Ball
from sweetspot.equipment.shell import Ring
from sweetspot.errors import InputError
from sweetspot.units import INCH, OUNCE


@pytest.mark.parametrize(("name", "rules"), [("college-alloy", "ncaa"), ("youth-alloy", "usabat")])
def test_legal_metal_bats_pass_every_rule(name: str, rules: str, baseball: Ball) -> None:
    """Their walls were chosen so; the weights are those of such bats: 30 to 31 oz at 33 in, 20 oz at 29 in."""
    bat = catalog.bat(name)
    done = certify(bat, ball=baseball)
    findings = construction_findings(bat, body=done.body) | done.findings()
    checks = {check.rule.quantity: check for check in check_rules(league(rules), bat=bat, findings=findings)}
    assert checks["bbcor"].verdict is Verdict.PASS
    assert not any(check.verdict is Verdict.FAIL for check in checks.values())
    assert abs(done.body.mass / OUNCE - (30.2 if rules == "ncaa" else 20.0)) < 0.05


def test_the_patch_leaves_an_interval_about_every_measure(baseball: Ball) -> None:
    done = certify(catalog.bat("single-wall"), ball=baseball)
    for name, (low, high) in done.spreads.items():
        assert low < getattr(done, name) < high
    low, high = done.spreads["bbcor"]
    assert 0.015 < high - low < 0.03
    wood = certify(catalog.bat("mlb-d"), ball=baseball).spreads["bbcor"]
    assert wood[1] - wood[0] < 0.4 * (high - low)  # a dent hardly asks how large the patch is
    # the walls' moment of inertia was not measured: it moves what recoil is in, and hardly what it is taken out of
    by_moi = done.moi_spreads
    assert by_moi["besr"][1] - by_moi["besr"][0] > 1.5 * (done.spreads["besr"][1] - done.spreads["besr"][0])
    assert by_moi["bbcor"][1] - by_moi["bbcor"][0] < 0.25 * (high - low)
    assert by_moi["besr"][0] < done.besr < by_moi["besr"][1]
    found = done.findings()["bbcor"]
    assert found.interval is not None and "moment of inertia" in found.interval_is
    assert found.interval[0] < low < high < found.interval[1] and found.interval[1] - found.interval[0] < 0.05
    measured = certify(catalog.bat("russell-b1"), ball=baseball)
    assert measured.moi_spreads == {}
    patch, law, both = measured.spreads["besr"], measured.law_spreads["besr"], measured.findings()["besr"].interval
    assert both is not None and both[0] < min(patch[0], law[0]) and max(patch[1], law[1]) < both[1]
    ends = [math.hypot(patch[end] - measured.besr, law[end] - measured.besr) for end in (0, 1)]
    assert both == pytest.approx((measured.besr - ends[0], measured.besr + ends[1]), rel=1e-9)


def test_the_thinnest_wall_that_passes_lies_on_the_limit(baseball: Ball) -> None:
    bat = catalog.bat("single-wall")
    found = wall_that_passes(bat, ball=baseball, limit=0.52)
    assert certify(found.bat, ball=baseball).bbcor == pytest.approx(0.52, abs=5e-4)
    assert found.thickness == pytest.approx(found.factor * 2.9e-3, rel=1e-6) and 1.1 < found.factor < 1.6
    assert found.mass == pytest.approx(rigid_body(beam_model(found.bat)).mass)
    assert found.mass > rigid_body(beam_model(bat)).mass


def test_a_disc_makes_a_lively_barrel_legal(baseball: Ball) -> None:
    """A disc of 6 mm where it is hit adds less than two ounces; a wall that does the same adds more than ten."""
    bat = catalog.bat("single-wall")
    assert bat.shell is not None
    disc = Ring(position=bat.length - 6.3 * INCH, width=6e-3, material=bat.material)
    stiffer = bat.replaced(shell=bat.shell.replaced(rings=(disc,)))
    done = certify(stiffer, ball=baseball)
    assert done.bbcor < 0.505 and certify(bat, ball=baseball).bbcor > 0.54
    assert (done.body.mass - rigid_body(beam_model(bat)).mass) / OUNCE < 2


def test_what_has_no_wall_and_what_nothing_helps_is_refused(baseball: Ball) -> None:
    with pytest.raises(InputError, match="solid"):
        wall_that_passes(catalog.bat("r161-ash"), ball=baseball, limit=0.5)
    with pytest.raises(InputError, match="rings or a disc"):
        wall_that_passes(catalog.bat("single-wall"), ball=baseball, limit=0.4)
    with pytest.raises(InputError, match="bbcor and bpf"):
        wall_that_passes(catalog.bat("single-wall"), ball=baseball, limit=0.5, measure="q")

"""Swing weight, twist weight and their like, as people of rackets compute them."""

from __future__ import annotations

from pathlib import Path

import pytest

import sweetspot
from sweetspot import catalog
from sweetspot.answers.handling import handling_of
from sweetspot.dynamics.beam import beam_model
from sweetspot.dynamics.rigid import rigid_body


def test_lead_at_three_and_nine_o_clock() -> None:
    """Published (technicalpickleball.net): 12 g turn a swing weight of 117 into 123 and a twist weight of 6.8 into 7.9.

    The paddle's half width and the place follow from the two changes; the masses are the printed ones.
    """
    plain = catalog.implement("tennis-racket").replaced(
        name="paddle", length=0.419, mass=0.227, balance_point=0.235, moi=117e-4, moi_axis=0.0508, twist_moi=6.8e-4,
        handle_length=0.12, head={"start": 0.15, "end": 0.409, "width": 0.192},
    )  # fmt: skip
    leaded = plain.replaced(added=tuple({"position": 0.2748, "mass": 6e-3, "lateral": way * 0.096} for way in (1, -1)))
    for paddle, swing, twist in ((plain, 117.0, 6.8), (leaded, 123.0, 7.9)):
        body = rigid_body(beam_model(paddle))
        assert 1e4 * body.moi(0.0508) == pytest.approx(swing, abs=0.5)
        assert 1e4 * body.roll_moi == pytest.approx(twist, abs=0.05)


def test_numbers_of_the_catalogue_s_racket() -> None:
    """Exact, from 318 g, 32.5 cm, 320 kg cm^2 about 10 cm: the formulas that calculators of rackets use."""
    racket = catalog.implement("tennis-racket")
    numbers = handling_of(racket, rigid_body(beam_model(racket)))
    assert numbers is not None
    assert 1e4 * numbers.recoil_weight == pytest.approx(320 - 0.318 * 22.5**2)
    about_butt = 320 + 20 * 0.318 * 32.5 - 100 * 0.318
    assert numbers.mgr_over_i == pytest.approx(0.318 * 980.665 * 32.5 / about_butt)
    assert (
        handling_of(catalog.implement("hockey-stick"), rigid_body(beam_model(catalog.implement("hockey-stick"))))
        is None
    )


def test_a_report_and_a_comparison_have_them(tmp_path: Path) -> None:
    file = tmp_path / "lead.toml"
    weight = '[[point_mass]]\nposition = "52 cm"\nmass = "6 g"\nbeside = "12.5 cm"\n'
    file.write_text('like = "tennis-racket"\nname = "leaded"\n' + 2 * weight, encoding="utf-8")
    plain, leaded = sweetspot.compare("tennis-racket", str(file)).bats
    assert plain.handling is not None and leaded.handling is not None
    assert float(leaded.handling.twist_weight) - float(plain.handling.twist_weight) == pytest.approx(0.012 * 0.125**2)
    assert [hit.lateral for hit in plain.off_center] == [0.03, 0.05]
    assert all(
        float(after.aside) < float(before.aside)
        for before, after in zip(plain.off_center, leaded.off_center, strict=True)
    )
    assert all(
        float(after.exit_speed) > float(before.exit_speed)
        for before, after in zip(plain.off_center, leaded.off_center, strict=True)
    )
    assert sweetspot.report("r161-ash").off_center == ()
    toe, edge = sweetspot.report("golf-driver").off_center
    assert toe.gear_spin is not None and edge.gear_spin is not None
    assert float(edge.gear_spin) > float(toe.gear_spin) > 0

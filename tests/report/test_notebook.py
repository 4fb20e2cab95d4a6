"""What a notebook shows: answers as reports, and a short line where it prints them."""

from __future__ import annotations

import pytest

from sweetspot import catalog
from sweetspot.analysis.bat_analysis import Analysis
from sweetspot.analysis.certification.simulated_test import certify
from sweetspot.analysis.comparison import compare
from sweetspot.catalog.standard_hit import standard_conditions
from sweetspot.report.notebook import document_of


def test_a_comparison_is_shown_as_its_report() -> None:
    bats = [catalog.bat("r161-ash"), catalog.bat("corked-r161")]
    comparison = compare(bats, conditions=standard_conditions(bats[0]), law=catalog.swing_law())
    shown = comparison._repr_html_()
    assert "2 bats, one player" in shown and "mph slower" in shown and "<svg" in shown
    assert repr(comparison) == "<Comparison of R161, white ash, R161, corked>"


def test_a_bat_test_is_shown_as_its_report() -> None:
    certification = certify(catalog.bat("r161-ash"), ball=catalog.ball())
    shown = certification._repr_html_()
    assert "BBCOR of the test" in shown and f"{certification.bbcor:.4f}" in shown
    assert repr(certification).startswith("<Certification of R161, white ash: BBCOR 0.4")


def test_a_bat_its_analysis_and_a_hit_are_shown(analysis: Analysis) -> None:
    assert "moment of inertia" in analysis.bat._repr_html_() and analysis.bat.name in analysis.bat._repr_html_()
    shown = analysis._repr_html_()
    assert "This bat hits best" in shown and "<svg" in shown and len(repr(analysis)) < 120
    hit = analysis.best._repr_html_()
    assert f"{analysis.best.collision_efficiency:.4f}" in hit and "peak force" in hit and len(repr(analysis.best)) < 160


def test_what_has_no_report_is_named() -> None:
    with pytest.raises(TypeError, match="a int has no document"):
        document_of(3)

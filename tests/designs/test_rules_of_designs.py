"""How sure it is that a designed bat keeps the rules: no surer than `certify` is of the same bat."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from sweetspot import catalog
from sweetspot.analysis.certification.rules import check_rules
from sweetspot.analysis.certification.simulated_test import certify
from sweetspot.catalog.rules import league
from sweetspot.designs.constraints import findings_of
from sweetspot.designs.measures import MeasuredDesigns


def test_a_bbcor_next_to_its_limit_is_not_sure_of_a_design_either() -> None:
    bat, ball = catalog.bat("college-alloy"), catalog.ball()
    tested = certify(bat, ball=ball)
    measured = MeasuredDesigns({"bbcor": np.array([tested.bbcor])}, np.zeros((1, 1)), np.zeros((1, 1)))
    found, in_the_test = findings_of(bat, measured, like=bat, ball=ball)["bbcor"], tested.findings()["bbcor"]
    assert found.interval == pytest.approx(in_the_test.interval, rel=1e-12)
    assert replace(found, interval=in_the_test.interval) == in_the_test
    for bbcor, sure in ((tested.bbcor, False), (0.499, False), (0.501, False), (0.45, True), (0.55, True)):
        measured = MeasuredDesigns({"bbcor": np.array([bbcor])}, np.zeros((1, 1)), np.zeros((1, 1)))
        known = findings_of(bat, measured, like=bat, ball=ball)
        check = {one.rule.quantity: one for one in check_rules(league("ncaa"), bat=bat, findings=known)}["bbcor"]
        assert check.decided and check.sure is sure, bbcor

"""What a measurement would leave of an interval, beside the interval of an implement that was so measured."""

from __future__ import annotations

import numpy as np
import pytest

from sweetspot import catalog, rigid_body
from sweetspot.analysis.comparison import Comparison, compare
from sweetspot.calibration.measurements import MeasuredKind
from sweetspot.catalog.standard_hit import standard_analysis, standard_conditions
from sweetspot.equipment.bat import Bat
from sweetspot.equipment.implement import Implement
from sweetspot.uncertainty.comparison_draws import DrawnComparison, linear_comparison, narrowings_of_changes
from sweetspot.uncertainty.drawn_hits import SpeedDoubt, speed_doubt
from sweetspot.uncertainty.implement_doubt import beam_of
from sweetspot.uncertainty.sources import Sources, sources_of
from sweetspot.uncertainty.worth_measuring import Narrowing


def doubt(tool: Implement) -> SpeedDoubt:
    analysis = standard_analysis(tool)
    found = speed_doubt(analysis, sources_of(tool, analysis.conditions))
    assert found is not None
    return found


@pytest.mark.parametrize("kinds", [("balance_point",), ("moi",)])
@pytest.mark.parametrize("name", ["r161-ash", "torpedo"])
def test_what_is_told_is_what_comes_of_it(name: str, kinds: tuple[MeasuredKind, ...]) -> None:
    tool = catalog.implement(name)
    told = {each.measured: each.error for each in doubt(tool).narrowings}
    body = rigid_body(beam_of(tool))
    values = {"balance_point": body.balance_point, "moi": body.moi(tool.moi_axis)}
    measured = tool.replaced(**{kind: values[kind] for kind in kinds})
    assert told[kinds] == pytest.approx(doubt(measured).error, rel=0.06)


@pytest.mark.parametrize("name", ["mlb-a", "college-alloy", "tennis-racket", "cricket-bat", "golf-driver"])
def test_each_measurement_more_leaves_less(name: str) -> None:
    found = doubt(catalog.implement(name))
    weighed, *others = found.narrowings
    assert weighed.measured == ("mass",)
    assert {each.measured for each in others} == {("mass", "balance_point"), ("mass", "moi")}
    assert found.error > weighed.error > max(each.error for each in others)


def test_what_stands_in_the_file_is_not_asked_for_again() -> None:
    bat = catalog.bat("r161-ash")
    body = rigid_body(beam_of(bat))
    whole = bat.replaced(balance_point=body.balance_point, moi=body.moi(bat.moi_axis))
    assert doubt(whole).narrowings == ()
    balanced = doubt(bat.replaced(balance_point=body.balance_point)).narrowings
    assert [each.measured for each in balanced] == [("moi",)]
    assert np.isfinite(balanced[0].error)


def test_a_difference_narrows_as_it_does_between_bats_so_measured() -> None:
    bats = [catalog.bat("r161-ash"), catalog.bat("torpedo")]
    narrower = {each.measured: each for each in narrowed(bats)[1]}
    measured = [bat.replaced(moi=rigid_body(beam_of(bat)).moi(bat.moi_axis)) for bat in bats]
    assert narrower["moi",].of == (0, 1)
    # a little more is left than to bats so measured, whose balance points are then taken as drawn
    after = error_of_change(measured)
    assert after < narrower["moi",].error < 1.25 * after
    assert narrowed(bats)[0] == ()


def linear(bats: list[Bat]) -> tuple[DrawnComparison, Comparison[Implement], list[Sources]]:
    law = catalog.swing_law(catalog.sport("baseball").swing_law)
    comparison = compare(bats, conditions=standard_conditions(bats[0]), law=law)
    sources = [sources_of(each.analysis.bat, each.analysis.conditions) for each in comparison.compared]
    return linear_comparison(comparison, sources), comparison, sources


def narrowed(bats: list[Bat]) -> list[tuple[Narrowing, ...]]:
    return narrowings_of_changes(*linear(bats))


def error_of_change(bats: list[Bat]) -> float:
    up, down = np.split(linear(bats)[0].bats[1].change[1:], 2)
    return float(np.linalg.norm((up - down) / 2))

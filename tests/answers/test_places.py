"""Places by name mean the same for every question, in Python as on the command line."""

from __future__ import annotations

import pytest

import sweetspot
from sweetspot import InputError, catalog, standard_analysis, standard_conditions
from sweetspot.answers.places import END, position_of
from sweetspot.units import INCH

R161 = catalog.bat("r161-ash")


def test_each_name_lies_where_it_says() -> None:
    conditions = standard_conditions(R161)
    tip, barrel, best = (position_of(name, R161, conditions) for name in ("tip", "barrel", "sweet-spot"))
    assert tip == pytest.approx(R161.length - END)
    assert best == pytest.approx(float(standard_analysis(R161).sweet_spots.max_exit_speed))
    assert R161.diameter_at(barrel) > 0.98 * 2.5 * INCH and barrel < tip
    assert position_of(0.7, R161, conditions) == 0.7


@pytest.mark.parametrize("written", ["sweet-spot", "sweetspot", "Sweet Spot", "sweet_spot"])
def test_a_hit_there_is_the_best_of_the_report(written: str) -> None:
    assert sweetspot.hit("r161-ash", at=written).exit_speed == pytest.approx(
        float(sweetspot.report("r161-ash").best_hit.exit_speed)
    )


def test_a_play_is_met_there_too() -> None:
    met = sweetspot.play("r161-ash", at="tip").to_dict()
    assert met["position_m"] == pytest.approx(R161.length - END)


def test_a_racket_has_no_barrel() -> None:
    with pytest.raises(InputError, match="bats alone"):
        sweetspot.hit("tennis-racket", at="barrel")
    assert float(sweetspot.hit("tennis-racket", at="sweet-spot").exit_speed) > 0

"""The doubt of the first sentence against draws of the same sources, and its words."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from sweetspot import beam_model, catalog, rigid_body
from sweetspot.analysis.bat_analysis import Analysis, analyse
from sweetspot.analysis.comparison import compare
from sweetspot.answers.compare import compare_of
from sweetspot.answers.hit import HitQuestion, hit_answer
from sweetspot.catalog.standard_hit import standard_conditions
from sweetspot.equipment.bat import Bat
from sweetspot.equipment.implement import Implement
from sweetspot.equipment.sport import Terms
from sweetspot.numerics.constants import STANDARD_AXIS
from sweetspot.numerics.interval import REACH, Interval, Number
from sweetspot.reports.bat.interval_words import doubt_words
from sweetspot.uncertainty.drawn_hits import SpeedDoubt, speed_doubt
from sweetspot.uncertainty.sources import Sources, sources_of


def half_of_draws(analysis: Analysis[Implement], sources: Sources) -> float:
    hit = hit_answer(
        HitQuestion(analysis.bat, analysis.conditions, analysis.sweet_spots.max_exit_speed, sources=sources)
    )
    return half(hit.exit_speed)


def half(number: Number) -> float:
    """Half of the width of a number's interval."""
    assert isinstance(number, Interval)
    return (number.high - number.low) / 2


@pytest.mark.parametrize(
    "name", ["r161-ash", "russell-b1", "double-wall", "composite", "youth-30", "slow-pitch", "cricket-bat",
             "tennis-racket", "golf-driver"],
)  # fmt: skip
def test_the_first_sentence_is_that_of_draws(name: str) -> None:
    """Straight lines instead of bends, for wood, walls, plies and other sports."""
    implement = catalog.load_implement(name)
    analysis = analyse(implement, standard_conditions(implement))
    sources = sources_of(implement, analysis.conditions)
    doubt = speed_doubt(analysis, sources)
    assert doubt is not None
    assert REACH * doubt.error == pytest.approx(half_of_draws(analysis, sources), rel=0.1)
    assert sum(doubt.shares.values()) == pytest.approx(1.0)


PAIRS = {
    "two maples": ("torpedo-twin", "torpedo"),
    "wood and alloy": ("r161-ash", "college-alloy"),
    "two lengths": ("r161-ash", "youth-30"),
    "ash and a thin wall": ("r161-ash", "russell-b6"),
}


@pytest.mark.parametrize("pair", [*PAIRS, "corked"])
def test_a_comparison_s_intervals_are_those_of_draws(pair: str) -> None:
    """What the bats share cancels, a corked bat is the bat it was, and the law's exponent counts, as in draws."""
    bats = [catalog.bat(name) for name in PAIRS.get(pair, ("r161-ash", "corked-r161"))]
    found = compare(bats, conditions=standard_conditions(bats[0]), law=catalog.swing_law())
    sources = [sources_of(one.analysis.bat, one.analysis.conditions) for one in found.compared]
    straight, drawn = (compare_of(found, sources, drawn=drawn, draws=512).bats[1] for drawn in (False, True))
    for name in ("change", "exit_speed", "bat_speed"):
        assert half(getattr(straight, name)) == pytest.approx(half(getattr(drawn, name)), rel=0.15), name


def test_one_bat_twice_differs_by_nothing(analysis: Analysis[Bat]) -> None:
    """Exact: both are off alike in everything that is not known."""
    found = compare([analysis.bat] * 2, conditions=analysis.conditions, law=catalog.swing_law())
    again = compare_of(found, [sources_of(analysis.bat, analysis.conditions)] * 2).bats[1]
    assert half(again.change) == 0.0 < half(again.exit_speed)


def test_a_speed_that_was_written_with_an_error_counts(analysis: Analysis[Bat]) -> None:
    """Exact: of the bat speed at the best place the ball keeps 1 + q, and independent variances add up."""
    known = sources_of(analysis.bat, analysis.conditions)
    swung = sources_of(analysis.bat, analysis.conditions, bat_speed_error=2.0)
    place, swing = analysis.sweet_spots.max_exit_speed, analysis.conditions.swing
    alone, both = speed_doubt(analysis, known), speed_doubt(analysis, swung)
    assert alone is not None and both is not None
    faster = 2.0 * swing.speed_at(place) / swing.bat_speed
    assert both.error**2 - alone.error**2 == pytest.approx(both.error**2 * both.shares["swing"], rel=0.01)
    # a faster hit also meets a ball that gives back less
    assert (both.error**2 * both.shares["swing"]) ** 0.5 == pytest.approx(
        faster * (1 + analysis.best.collision_efficiency), rel=0.1
    )


@pytest.mark.parametrize(
    ("shares", "told"),
    [
        ({"the mean ball": 0.7, "patch of the ball": 0.3}, "give or take 3.7 mph by the ball alone"),
        ({"the mean ball": 0.7, "bat": 0.3}, "give or take 3.7 mph, mostly by the ball"),
        ({"this ball": 0.45, "bat": 0.55}, "give or take 3.7 mph, by the bat and the ball"),
        (
            {"this ball": 0.3, "bat": 0.25, "swing": 0.4, "pitch": 0.05},
            "give or take 3.7 mph, by the speeds as they were written, the ball and the bat",
        ),
    ],
)
def test_what_it_comes_from_in_words(shares: dict[str, float], told: str) -> None:
    assert str(doubt_words(SpeedDoubt(1.0, shares, ()), Terms())) == f", {told}"


def test_the_default_report_says_it(run: Callable[..., tuple[int, str, str]]) -> None:
    """As the plain answer says so do draws: within a tenth, in the first sentence of both."""
    said = [" ".join(run("report", "tennis-racket", *more)[1].split()) for more in ((), ("--uncertainty",))]
    assert "leaves at 48.3 m/s, give or take 2.9 m/s, mostly by the racket." in said[0]
    assert "leaves at 48.3 ± 2.9 m/s." in said[1]
    for told in said:
        assert "To know it within 1.0 m/s, weigh it and time how it swings from a pivot (sweetspot pendulum)." in told


def test_a_difference_of_open_sign_says_what_would_decide_it(run: Callable[..., tuple[int, str, str]]) -> None:
    told = " ".join(run("compare", "r161-ash", "torpedo")[1].split())
    assert "To know it within 1.0 mph, time how both swing from a pivot (sweetspot pendulum)." in told
    assert "To know it within" not in run("compare", "tennis-racket", "--add", "6g@52cm")[1]  # a gain is a gain


def test_nothing_is_to_be_measured_where_little_would_come_of_it(
    run: Callable[..., tuple[int, str, str]], tmp_path: Path
) -> None:
    file = tmp_path / "measured.toml"
    body = rigid_body(beam_model(catalog.bat()))
    moments = f'balance_point = "{body.balance_point} m"\nmoi = "{body.moi(STANDARD_AXIS)} kg*m^2"'
    file.write_text(f'like = "r161-ash"\n{moments}\n', encoding="utf-8")
    assert "To know it within" not in run("report", str(file))[1]

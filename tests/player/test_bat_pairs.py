"""Bats that a player swung, each against each: what is told of them, and what is not."""

from __future__ import annotations

from dataclasses import replace
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from sweetspot import catalog
from sweetspot.numerics.interval import Interval
from sweetspot.player.bat_pairs import BatPair, MeasuredBat, compared_pairs
from sweetspot.player.goal import Goal
from sweetspot.reports.document import Table
from sweetspot.reports.player.phrases import of_those_swung, pairs_table
from sweetspot.reports.quantities import US
from sweetspot.reports.sentences import read
from sweetspot.units import FOOT, MPH

BAT = catalog.bat("r161-ash")
SPREAD = np.linspace(-1.0, 1.0, 101)


def swung(name: str, speed: float | None = 40.0, *, count: int = 10, half: float = 0.5) -> MeasuredBat:
    measured = None if speed is None else Interval(speed, speed - half, speed + half)
    return MeasuredBat(BAT.replaced(name=name), count, None, measured)


def told(
    bats: list[MeasuredBat], gained: dict[str, Any], goal: Goal | None = None
) -> tuple[tuple[BatPair, ...], str, Table]:
    goal = goal or Goal()
    usual = {name: 10 * SPREAD * number for number, name in enumerate(gained)}
    pairs, seldom = compared_pairs(bats, gained, usual, goal=goal)
    advice: Any = SimpleNamespace(pairs=pairs, seldom=seldom, goal=goal)
    return pairs, read(of_those_swung(advice), US), pairs_table(advice)


def test_every_two_bats_are_compared_the_best_first() -> None:
    """Exact: medians 3, 1 and 0 m/s; the same draws for every bat, so that a constant difference has no width."""
    bats = [swung("own", 40.0), swung("second", 43.0), swung("third", 41.0)]
    pairs, words, table = told(bats, {"own": SPREAD, "second": SPREAD + 3, "third": SPREAD + 1})
    assert [(pair.better, pair.other) for pair in pairs] == [("second", "third"), ("second", "own"), ("third", "own")]
    assert [pair.gain.value for pair in pairs] == pytest.approx([2.0, 3.0, 1.0])
    assert {pair.verdict for pair in pairs} == {"better"} and all(pair.chance == 1 for pair in pairs)
    assert pairs[0].measured is not None and pairs[0].measured.value == pytest.approx(2.0)
    assert pairs[0].measured.high - pairs[0].measured.value == pytest.approx(0.5 * 2**0.5)
    assert words.startswith("Of the bats swung second is best: second against third +4.5 mph")
    assert "as measured +4.5 mph (+2.9 to +6.1);" in words
    assert len(table.rows) == 3


@pytest.mark.parametrize(
    ("measured", "spread", "verdict"),
    [
        (42.0, 0.0, "better"),
        (42.0, 1.0, "cannot tell"),  # draws on both sides of zero
        (None, 0.0, "better by the model"),  # by bat speeds alone
        (40.2, 0.0, "better by the model"),  # measured faster, not surely
        (39.8, 0.0, "cannot tell"),  # measured a little slower
        (39.0, 0.0, "gainsaid"),  # measured surely slower
        (39.0, 1.0, "gainsaid"),
    ],
)
def test_only_what_the_data_can_tell_is_told(measured: float | None, spread: float, verdict: str) -> None:
    bats = [swung("own", 40.0), swung("second", measured)]
    (pair,), words, _ = told(bats, {"own": np.zeros(101), "second": 0.5 + spread * SPREAD})
    assert pair.verdict == verdict
    assert ("second is best" in words) == verdict.startswith("better")
    assert ("best by the model" in words) == (verdict == "better by the model")
    assert ("not sure" in words) == (verdict == "cannot tell")
    assert ("Believe the measurement" in words) == (verdict == "gainsaid")


@pytest.mark.parametrize(("mph", "goal", "verdict"), [
    (0.01, Goal(), "cannot tell"), (0.06, Goal(), "better by the model"),
    (0.01, Goal("carry"), "cannot tell"), (0.06, Goal("carry"), "better by the model"),
])  # fmt: skip
def test_a_gain_that_is_told_as_none_is_not_sure(mph: float, goal: Goal, verdict: str) -> None:
    """Exact: 0.01 mph or ft in every draw is told as +0.0, and its sign is left open, as `compare` leaves it."""
    gain = mph * (MPH if goal.name == "exit-speed" else FOOT)
    bats = [swung("own", None), swung("second", None)]
    (pair,), _, table = told(bats, {"own": SPREAD, "second": SPREAD + gain}, goal)
    assert pair.verdict == verdict
    assert pair.chance == (0 if verdict == "cannot tell" else 1)
    assert ("cannot tell" in str(table.rows[0][-1])) == (verdict == "cannot tell")


def test_a_measured_exit_speed_does_not_gainsay_a_carry() -> None:
    (pair,), _, _ = told(
        [swung("own"), swung("second", 39.0)], {"own": 90 + SPREAD, "second": 93 + SPREAD}, Goal("carry")
    )
    assert pair.verdict == "better by the model"


def test_a_bat_swung_twice_is_named_and_not_compared() -> None:
    bats = [swung("own"), swung("second", None, count=2)]
    pairs, words, _ = told(bats, {"own": SPREAD, "second": SPREAD + 3})
    assert pairs == () and words == "Swung too seldom to be compared: second."
    assert told([swung("own")], {"own": SPREAD})[1] == ""


def test_many_bats_are_told_by_the_table() -> None:
    bats = [swung(f"bat {number}", 40.0 + number) for number in range(5)]
    gained = {one.bat.name: SPREAD + number for number, one in enumerate(bats)}
    pairs, words, table = told(bats, gained)
    assert len(pairs) == len(table.rows) == 10
    assert words.count("against") == 6 and "4 more pairs in the table" in words
    assert replace(pairs[0], chance=0.5).verdict == "better"

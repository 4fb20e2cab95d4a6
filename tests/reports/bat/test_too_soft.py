"""Bats of cork, rubber and foam: an answer in numbers that are some, or a sentence that says why there is none."""

from __future__ import annotations

import pytest

from sweetspot import catalog, report
from sweetspot.analysis.bat_analysis import MOST_BENT, bent_part
from sweetspot.answers.report import ReportAnswer
from sweetspot.equipment.bat import Bat
from sweetspot.equipment.shell import Shell

NAMES = ("r161-ash", "youth-alloy", "composite", "badminton-racket", "hockey-stick", "golf-driver", "cricket-bat")


def answer(told: ReportAnswer) -> str:
    """Return what stands before the tables."""
    return str(told).partition("Every sweet spot")[0]


@pytest.mark.filterwarnings("ignore")
@pytest.mark.parametrize("material", ["cork", "rubber"])
def test_a_bat_that_bends_far_is_given_no_speed(r161: Bat, material: str) -> None:
    """Derived: beams describe what bends little; these bend by 3 and 4 % of their length in a hit."""
    told = report(
        Bat(name="soft", length=r161.length, material=catalog.material(material), profile=r161.profile, cup=None)
    )
    assert bent_part(told.analysis) > 2 * MOST_BENT
    assert told.best_hit.exit_speed_half is None and told.half_by_ball is None
    assert "predict nothing" in answer(told) and "give or take" not in answer(told)


@pytest.mark.filterwarnings("ignore")
def test_no_number_that_is_none() -> None:
    """A hose that a ball does not leave at most places: once "1 in: - towards the hands"."""
    profile = ((0.0, 0.033617), (0.36275, 0.019233), (0.85003, 0.057229), (1.008, 0.057229))
    shell = Shell(wall=((0.0, 7e-3), (1.008, 2.114e-3)))
    hose = Bat(name="hose", length=1.008, material=catalog.material("rubber"), profile=profile, shell=shell)
    first = answer(report(hose))
    assert "nan" not in first and " - " not in first and "give or take" not in first


@pytest.mark.parametrize("name", NAMES)
def test_what_is_played_with_bends_little(name: str) -> None:
    """Everything in the catalogue is far within what beams describe."""
    told = report(name)
    assert bent_part(told.analysis) < MOST_BENT / 3
    assert "predict nothing" not in str(told)

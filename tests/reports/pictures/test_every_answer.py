"""The pictures of plays, players, optima, tests and comparisons: no label on another, none cut off."""

from __future__ import annotations

import itertools
import re

import numpy as np
import pytest

from sweetspot import catalog
from sweetspot.flight.air import Air
from sweetspot.player.advice import advise
from sweetspot.player.goal import Goal
from sweetspot.player.model import player_model
from sweetspot.player.posterior import fit_player
from sweetspot.player.prior import NAMES, natural
from sweetspot.player.simulate import simulated_swings
from sweetspot.reports.pictures.shares import shares_figure
from sweetspot.reports.player.picture import ALONE, ON_A_SHEET, player_figure
from sweetspot.reports.quantities import SYSTEMS
from sweetspot.units import MPH
from tests.reports.pictures.labels import check_labels, texts
from tests.reports.told import Tell, tell

__all__ = ["tell"]
COMMANDS = (
    ("play", "r161-ash", "--park", "BOS"),
    ("play", "r161-ash", "--offset", "0.05in"),  # ball and pitch on nearly one line
    ("play", "r161-ash", "--offset=-1.6in"),
    ("play", "r161-ash", "--offset", "2.2in"),
    ("play", "r161-ash", "--offset", "3in", "--force"),  # a miss
    ("play", "youth-30", "--pitch", "little-league-fastball", "--park", "little-league"),
    ("play", "slow-pitch", "--pitch", "slow-pitch", "--park", "slow-pitch"),
    ("play", "r161-ash", "--pitch-speed", "tee"),
    ("certify", "r161-ash", "--league", "all"),
    ("certify", "russell-b5"),
    ("fly", "--exit-speed", "100mph", "--launch-angle", "28deg", "--park", "BOS"),
    ("fly", "--ball", "tennis", "--exit-speed", "57m/s", "--launch-angle=-6deg", "--backspin=-1500rpm",
     "--height", "2.7m"),
    ("fly", "--ball", "golf", "--exit-speed", "167mph", "--launch-angle", "11deg", "--backspin", "2700rpm"),  # in yards
    ("fly", "--exit-speed", "103mph", "--launch-angle", "25deg", "--spray=-30deg", "--park", "fenway-park"),
    ("fly", "--exit-speed", "80mph", "--launch-angle=-5deg", "--park", "little-league"),
    ("hit", "r161-ash", "--at", "20in-from-tip"),
    ("hit", "tennis-racket", "--at", "15cm-from-tip"),
    ("parks", "little-league"),
    ("parks", "fenway-park"),
    ("compare", "r161-ash", "mlb-a", "college-alloy", "youth-30", "slow-pitch"),
    ("compare", "table-tennis-racket", "table-tennis-racket"),
    ("compare", "golf-driver", "golf-driver"),
    ("hit", "badminton-racket", "--at", "10cm-from-tip"),
    ("optimum", "--show", "launch"),
    ("optimum", "slow-pitch", "--show", "launch"),
    ("optimum", "--show", "parks", "--park", "all"),
)  # fmt: skip


@pytest.mark.parametrize("command", COMMANDS, ids=" ".join)
def test_labels_are_clear_of_each_other(command: tuple[str, ...], tell: Tell) -> None:
    document = tell(*command)
    drawing = document.drawing
    assert drawing is not None
    for reader in {id(one): one for one in (document.reader, SYSTEMS["si"])}.values():
        for draw in filter(None, (drawing.draw, drawing.sheet)):
            check_labels(draw(reader))


def test_a_picture_tells_the_words_numbers(tell: Tell) -> None:
    """A drive counts from the tee, in words, picture and data; a tee ball has no pitch; names of doubt are whole."""
    golf = tell("fly", "--ball", "golf", "--exit-speed", "167mph", "--launch-angle", "11deg", "--backspin", "2700rpm")
    tee = tell("play", "r161-ash", "--pitch-speed", "tee")
    drive, played = ([words for words, _ in texts(one.drawing.draw(one.reader))] for one in (golf, tee) if one.drawing)
    (told,) = re.findall(r"carries ([\d.]+ yd)", str(golf.blocks[0].words.read(golf.reader)))  # type: ignore[union-attr]
    assert told in drive and any(told in words and "11° up" in words for words in drive)
    assert golf.data["carry_m"] == pytest.approx(float(told.split()[0]) * 0.9144, abs=0.05)
    assert any("no wind" in words for words in drive)
    assert "ball at rest" in played and not any("pitch" in words for words in played)
    check_labels(shares_figure({"a source of doubt with a long name, at that": 0.6, "ball": 0.4}, "best exit speed"))


def test_a_player_s_picture() -> None:
    own, other, ball = catalog.bat("r161-ash"), catalog.bat("mlb-a"), catalog.ball()
    swings = simulated_swings(
        natural(np.zeros(len(NAMES))), bats=[own, other], ball=ball, count=12, pitch_speed=60 * MPH, seed=3
    )
    model = player_model(swings, bat=own, ball=ball, others={other.name: other}, law=catalog.swing_law())
    fitted = fit_player(model, seed=1)
    advice = advise(fitted, goal=Goal("exit-speed"), aerodynamics=catalog.aerodynamics(), air=Air())
    for reader, paper in itertools.product(SYSTEMS.values(), (ALONE, ON_A_SHEET)):
        named = "A player with a long name, of a club"
        check_labels(player_figure(advice, player=named, day="30 September 2026", reading=reader, paper=paper))

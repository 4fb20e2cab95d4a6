"""The pictures of plays, players, optima, tests and comparisons: no label on another, none cut off."""

from __future__ import annotations

from collections.abc import Callable

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
from sweetspot.report.document import Document
from sweetspot.report.player.picture import player_figure
from sweetspot.report.quantities import SYSTEMS
from sweetspot.units import MPH
from tests.report.pictures.labels import check_labels

Run = Callable[..., tuple[int, str, str]]

COMMANDS = (
    ("play", "r161-ash", "--park", "BOS"),
    ("play", "r161-ash", "--offset", "0.05in"),  # ball and pitch on nearly one line
    ("play", "r161-ash", "--offset=-1.6in"),
    ("play", "r161-ash", "--offset", "2.2in"),
    ("play", "r161-ash", "--offset", "3in", "--force"),  # a miss
    ("play", "youth-30", "--pitch", "little-league-fastball", "--park", "little-league"),
    ("play", "slow-pitch", "--pitch", "slow-pitch", "--park", "slow-pitch"),
    ("certify", "r161-ash", "--league", "all"),
    ("certify", "russell-b5"),
    ("fly", "--exit-speed", "100mph", "--launch-angle", "28deg", "--park", "BOS"),
    ("fly", "--ball", "tennis", "--exit-speed", "57m/s", "--launch-angle=-6deg", "--backspin=-1500rpm",
     "--height", "2.7m"),
    ("compare", "r161-ash", "mlb-a", "college-alloy", "youth-30", "slow-pitch"),
    ("compare", "table-tennis-racket", "table-tennis-racket"),
    ("optimum", "--show", "launch"),
    ("optimum", "--show", "parks", "--park", "all"),
)  # fmt: skip


@pytest.mark.parametrize("command", COMMANDS, ids=" ".join)
def test_labels_are_clear_of_each_other(command: tuple[str, ...], run: Run, monkeypatch: pytest.MonkeyPatch) -> None:
    caught: list[Document] = []

    def present(document: Document, *_: object, **__: object) -> int:
        caught.append(document)
        return 0

    monkeypatch.setattr("sweetspot.cli.output.present", present)
    code, _, said = run(*command)
    assert len(caught) == 1, (code, said)
    for reader in {id(one): one for one in (caught[0].reader, SYSTEMS["si"])}.values():
        assert caught[0].drawing is not None
        check_labels(caught[0].drawing.draw(reader))


def test_a_player_s_picture() -> None:
    own, other, ball = catalog.bat("r161-ash"), catalog.bat("mlb-a"), catalog.ball()
    swings = simulated_swings(natural(np.zeros(len(NAMES))), bats=[own, other], ball=ball, count=12,
                              pitch_speed=60 * MPH, seed=3)  # fmt: skip
    model = player_model(swings, bat=own, ball=ball, others={other.name: other}, law=catalog.swing_law())
    fitted = fit_player(model, seed=1)
    advice = advise(fitted, goal=Goal("exit-speed"), aerodynamics=catalog.aerodynamics(), air=Air())
    for reader in SYSTEMS.values():
        check_labels(player_figure(fitted, advice, player="A player with a long name, of a club", reading=reader))

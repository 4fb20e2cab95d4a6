"""Bats that a file of swings describes by weight and length alone."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from sweetspot import catalog
from sweetspot.answers.player_question import FitPlayerQuestion, player_posterior, read_player
from sweetspot.answers.team import fit_team_answer
from sweetspot.catalog.scaled_implements import Measures, scaled_to
from sweetspot.dynamics.beam import beam_model
from sweetspot.dynamics.rigid import rigid_body
from sweetspot.equipment.bat import Bat
from sweetspot.errors import InputError
from sweetspot.player.prior import NAMES, natural
from sweetspot.player.simulate import simulated_swings
from sweetspot.units import INCH, MPH, OUNCE

OWN = catalog.bat("r161-ash")


def of_weight(ounces: float) -> Bat:
    bat, _ = scaled_to(OWN, Measures(mass=ounces * OUNCE))
    assert isinstance(bat, Bat)
    return bat.replaced(name=f"{ounces:g}")


def rows_of(player: str, weights: tuple[float, ...], exponent: float, count: int, seed: int) -> list[str]:
    """Return rows of a usual player with this exponent, who swings bats of these weights in turn."""
    parameters = natural(np.zeros(10))
    parameters[NAMES.index("exponent")] = exponent
    swings = simulated_swings(
        parameters,
        bats=[of_weight(ounces) for ounces in weights],
        ball=catalog.ball(),
        count=count,
        pitch_speed=60 * MPH,
        seed=seed,
    )
    speeds = [(swing.bat or f"{weights[0]:g}", swing.bat_speed or 0.0, swing.exit_speed or 0.0) for swing in swings]
    return [f"{player},{bat},33,{speed / MPH:.2f},{out / MPH:.2f},60" for bat, speed, out in speeds]


HEAD = "player,bat_weight_oz,bat_length_in,bat_speed_mph,exit_speed_mph,pitch_speed_mph"


def write(path: Path, rows: list[str]) -> FitPlayerQuestion:
    path.write_text("\n".join([HEAD, *rows]), encoding="utf-8")
    return FitPlayerQuestion(path)


def test_each_weight_is_a_bat(tmp_path: Path) -> None:
    """Exact: the bats weigh what the rows say; a row with a weight that no such bat has is left out with its reason."""
    rows = rows_of("Ann", (28.0, 34.0), 0.29, 20, 1)
    question = write(tmp_path / "swings.csv", [*rows, rows[0].replace(",28,", ",400,")])
    swings = read_player(question)
    (bad,) = swings.file.bad_rows
    assert bad.row == 22 and "400 oz" in bad.reason
    weights = sorted(rigid_body(beam_model(bat)).mass / OUNCE for bat in (swings.bat, *swings.others.values()))
    assert weights == pytest.approx([28.0, 34.0], abs=0.01)
    assert {swing.bat for swing in swings.file.swings} == {"", *swings.others}
    assert any("made by their weight and length, like R161" in note for note in swings.file.notes)


def test_a_place_from_the_knob_is_on_the_rows_own_bat(tmp_path: Path) -> None:
    """Exact: 27 in from the knob is 7 in from the tip of a bat of 34 in, 6 in of one of 33 in."""
    path = tmp_path / "swings.csv"
    rows = [f"{length},{70 + i / 10},{95 + i / 10},60,27" for i in range(6) for length in (33, 34)]
    head = "bat_length_in,bat_speed_mph,exit_speed_mph,pitch_speed_mph,position_in_from_knob"
    path.write_text("\n".join([head, *rows]), encoding="utf-8")
    found = {swing.bat_length: swing.position for swing in read_player(FitPlayerQuestion(path)).file.swings}
    assert {length and length / INCH: place and place / INCH for length, place in found.items()} == pytest.approx(
        {33.0: 6.0, 34.0: 7.0}
    )


def test_no_bat_that_can_be(tmp_path: Path) -> None:
    with pytest.raises(InputError, match="has no bat that can be: row 2: "):
        read_player(write(tmp_path / "swings.csv", [f"Ann,300,33,{70 + i},95,60" for i in range(6)]))


def test_two_weights_teach_the_exponent(tmp_path: Path) -> None:
    """The truth lies within three standard deviations; one weight teaches nothing."""
    known = {}
    for weights in ((28.0,), (28.0, 36.0)):
        question = write(tmp_path / f"{len(weights)}.csv", rows_of("Ann", weights, 0.12, 120, 2))
        known[len(weights)] = player_posterior(read_player(question)).learned["exponent"]
    assert not known[1].told and known[2].told
    found = known[2].interval
    assert abs(found.value - 0.12) < 3 * (found.high - found.low) / 3.29


def test_a_team_teaches_one_who_swung_one_bat_and_it_is_not_called_his_own(tmp_path: Path) -> None:
    """Seven batters whom weight hardly slows, and one with one bat only, whose exponent moves to theirs."""
    rows = [line for i in range(7) for line in rows_of(f"B{i}", (28.0, 36.0), 0.1, 120, 10 + i)]
    team = fit_team_answer(write(tmp_path / "team.csv", [*rows, *rows_of("Zoe", (28.0,), 0.1, 60, 30)]))
    (zoe,) = (batter for batter in team.batters if batter.batter == "Zoe")
    exponent = zoe.parameters["exponent"]
    assert float(exponent.alone.value) > 0.25 > float(exponent.pooled.value)
    assert zoe.best is None and exponent.own_share < 0.3
    assert not any(option.own for option in zoe.advice.options if option.candidate.family == "weight")

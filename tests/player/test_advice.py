"""Advice to a player: what is expected, which bat, where to meet the ball, what an inch is worth."""

from __future__ import annotations

import json
import math
import re
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from sweetspot import catalog
from sweetspot.analysis.comparison import compare
from sweetspot.answers.player import FitPlayerAnswer, player_answer
from sweetspot.answers.player_question import FitPlayerQuestion, PlayerSwings
from sweetspot.catalog.aerodynamic_laws import aerodynamics
from sweetspot.catalog.standard_hit import standard_conditions
from sweetspot.collision.closed_form import exit_speed
from sweetspot.dynamics.beam import beam_model
from sweetspot.dynamics.rigid import rigid_body
from sweetspot.errors import InputError
from sweetspot.flight.air import Air
from sweetspot.flight.conditions import FlightConditions
from sweetspot.flight.trajectory import fly
from sweetspot.motion.ball_motion import batted_ball
from sweetspot.numerics.interval import Interval
from sweetspot.player.advice import Advice, advise
from sweetspot.player.bat_pairs import BatPair
from sweetspot.player.bat_response import RATIOS, response_of
from sweetspot.player.candidate import candidates
from sweetspot.player.expected_gain import Change, expectation
from sweetspot.player.goal import CarryTable, Goal, carry_table
from sweetspot.player.model import player_model
from sweetspot.player.player_swing import PlayerSwing, fault_of
from sweetspot.player.posterior import PlayerPosterior, fit_player
from sweetspot.player.prior import NAMES, natural
from sweetspot.player.simulate import simulated_swings
from sweetspot.player.swings import SwingFile, read_swings
from sweetspot.reports.player.document import player_document
from sweetspot.reports.player.phrases import pitch_words
from sweetspot.reports.player.words import answers, findings, notes
from sweetspot.reports.quantities import US
from sweetspot.tables.cells import BadRow
from sweetspot.units import FOOT, INCH, MPH
from tests.real_data import real_file

BALL, OWN = catalog.ball(), catalog.bat("r161-ash")
PITCH = 82 * MPH
AIR, DRAG = Air(), aerodynamics()


@pytest.fixture(scope="module")
def posterior() -> PlayerPosterior:
    swings = simulated_swings(natural(np.zeros(10)), bats=[OWN], ball=BALL, count=40, pitch_speed=PITCH, seed=2)
    return fit_player(player_model(swings, bat=OWN, ball=BALL))


@pytest.fixture(scope="module")
def advice(posterior: PlayerPosterior) -> Advice:
    return advise(posterior, goal=Goal("carry"), aerodynamics=DRAG, air=AIR, others=[catalog.bat("mlb-a")])


@pytest.fixture
def swings(posterior: PlayerPosterior) -> SwingFile:
    return SwingFile(posterior.model.swings, (BadRow(7, "too fast"),), 3, "Blast", ("x",), ("a note",), None, None)


def certain(posterior: PlayerPosterior, **values: float) -> PlayerPosterior:
    """Return a posterior of one player who is known and never varies."""
    row = natural(np.zeros(10))
    for name in ("bat_speed_spread", "position_spread", "offset_spread", "offset", "efficiency_shift"):
        row[NAMES.index(name)] = 0.0
    for name, value in values.items():
        row[NAMES.index(name)] = value
    return replace(posterior, draws=np.tile(row, (2, 1)))


def test_a_player_without_scatter_gets_the_plain_collision(posterior: PlayerPosterior) -> None:
    """Exact: the table's efficiency in v_f = q v_ball + (1 + q) v_bat, but for pitch and swing not quite in line."""
    model = posterior.model
    known = certain(posterior, bat_speed=31.0, position=6 * INCH)
    asked = expectation(known, goal=Goal(), pitch_speed=PITCH, carries=None, seed=1)
    own = model.bats[0]
    at = 24  # the place 6 in from the tip: every quarter of an inch from 0
    q = own.efficiency[at] + (PITCH + 31.0) * own.efficiency_slope[at]
    in_line = np.interp(PITCH / 31.0, RATIOS, own.usual[0][:, len(own.offset) // 2])
    assert in_line == pytest.approx(1.0, abs=1e-3)
    assert asked.of(own)[0] == pytest.approx(in_line * exit_speed(q, ball_speed=PITCH, bat_speed=31.0), rel=1e-6)
    faster = asked.of(own, Change(bat_speed=1.0))[0] - asked.of(own)[0]
    assert faster == pytest.approx(1 + q + own.efficiency_slope[at] * (PITCH + 32), rel=1e-3)


def test_a_ball_met_off_the_axis_keeps_the_tabled_part(posterior: PlayerPosterior) -> None:
    """Exact: straight lines between the table's rows and columns, by numpy."""
    own, known = posterior.model.bats[0], certain(posterior, bat_speed=31.0, position=6 * INCH)
    asked = expectation(known, goal=Goal(), pitch_speed=PITCH, carries=None, seed=1)
    left = [np.interp(PITCH / 31.0, RATIOS, column) for column in own.usual[0].T]
    for above in (-0.4 * INCH, 0.83 * INCH):
        part = asked.of(own, offset=np.full(2, above))[0] / asked.of(own)[0]
        assert part == pytest.approx(np.interp(above, own.offset, left) / np.interp(0, own.offset, left), rel=1e-5)


def test_another_bat_changes_exit_speed_as_compare_says(posterior: PlayerPosterior) -> None:
    """Other code: `compare` finds the greatest exit speed of both bats under the same law."""
    law = posterior.model.law
    known = certain(posterior, bat_speed=70 * MPH, exponent=law.exponent)
    asked = expectation(known, goal=Goal(), pitch_speed=90 * MPH, carries=None, seed=1)
    heavy = catalog.bat("mlb-a")
    tables = [posterior.model.bats[0], response_of(heavy, ball=BALL, axis=law.axis)]
    grid = np.arange(4, 8, 0.1) * INCH
    best = [max(asked.of(table, position=np.full(2, place))[0] for place in grid) for table in tables]
    pair = compare([OWN, heavy], conditions=standard_conditions(OWN), law=catalog.swing_law()).compared
    assert best[1] - best[0] == pytest.approx(pair[1].change.value, abs=0.1 * MPH)


def test_carry_of_a_hit_is_its_flight(posterior: PlayerPosterior) -> None:
    """Other code: one flight by `fly` with about the spin that such a hit gets; carry grows with speed."""
    table = carry_table(posterior.model, pitch_speed=PITCH, aerodynamics=DRAG, air=AIR)
    speed, attack = np.array([46.0]), np.radians([9.0])
    carry = float(table.at(speed, np.array([0.7 * INCH]), attack)[0])
    flight = fly(
        batted_ball(speed=44.7, launch_angle=math.radians(27), backspin=200.0, position=(0.0, 0.0, 0.9)),
        FlightConditions(ball=BALL, aerodynamics=DRAG, air=AIR),
    )
    assert carry == pytest.approx(flight.carry, rel=0.08)
    up = table.at(np.array([30.0, 35.0, 40.0, 45.0]), np.full(4, 0.7 * INCH), np.full(4, 0.15))
    assert np.all(np.diff(up) > 0)


def test_straight_lines_between_the_grids() -> None:
    """Exact: a linear function is its own interpolation; beyond the grids their end counts."""
    speed, offset, attack = np.linspace(0, 1, 3), np.linspace(-1, 1, 5), np.linspace(2, 3, 4)
    mesh = np.meshgrid(speed, offset, attack, indexing="ij")
    table = CarryTable(speed, offset, attack, 2 * mesh[0] - mesh[1] + 3 * mesh[2])
    places = np.array([0.3, 0.9]), np.array([0.2, -0.7]), np.array([2.1, 2.9])
    assert table.at(*places) == pytest.approx(2 * places[0] - places[1] + 3 * places[2], abs=1e-5)
    assert table.at(np.array([9.0]), np.array([0.0]), np.array([2.0]))[0] == pytest.approx(8.0, abs=1e-4)


def test_advice_is_whole_and_ordered(advice: Advice, posterior: PlayerPosterior) -> None:
    changes = [option.change.value for option in advice.options]
    assert changes == sorted(changes, reverse=True)
    assert {option.candidate.family for option in advice.options} == {"weight", "balance", "choke", "catalogue"}
    assert advice.faults == ()
    for option in advice.options:
        assert option.change.low <= option.change.value <= option.change.high
        assert 0 <= option.chance <= 1
    assert advice.pitch_speed == pytest.approx(PITCH)
    assert 4 * INCH < advice.contact_point.value < 8 * INCH
    assert advice.contact_gain.low >= -0.01  # the best place of a grid is no worse than the present one
    for key in ("bat_speed", "position_spread", "offset_spread"):
        assert advice.worth[key].gain.low > 0, key
    assert len({name.candidate.key for name in advice.options}) == len(advice.options)


def test_a_mile_an_hour_of_exit_speed_is_worth_a_few_feet(posterior: PlayerPosterior) -> None:
    """Published: 5 ft per mph near 100 mph at the best angle and constant spin.

    Here spin grows with speed, side spin too: less, but not half of it.
    """
    carries = carry_table(posterior.model, pitch_speed=PITCH, aerodynamics=DRAG, air=AIR)
    own, above, attack = posterior.model.bats[0], np.full(2, 0.6 * INCH), np.full(2, np.radians(9.0))
    slow, fast = carries.at(np.array([102.0, 107.0]) * MPH, above, attack)
    kept = float(np.interp(0.6 * INCH, own.offset, own.usual[0][3]))
    assert 3 < (fast - slow) / FOOT / (5 * kept) < 5


def test_a_line_is_a_part_of_the_swings(posterior: PlayerPosterior) -> None:
    carries = carry_table(posterior.model, pitch_speed=PITCH, aerodynamics=DRAG, air=AIR)
    own = posterior.model.bats[0]
    parts = [
        expectation(posterior, goal=Goal("line", line=feet * FOOT), pitch_speed=PITCH, carries=carries, seed=1).of(own)
        for feet in (150, 300, 450)
    ]
    assert 1 >= parts[0].mean() > parts[1].mean() > parts[2].mean() >= 0


def test_goals_that_make_no_sense() -> None:
    with pytest.raises(InputError, match="give both"):
        Goal("line")
    with pytest.raises(InputError, match="give both"):
        Goal("carry", line=90.0)
    with pytest.raises(InputError, match="33 to 656 ft"):
        Goal("line", line=1000.0)
    with pytest.raises(InputError, match="allowed is"):
        Goal("home-run")  # type: ignore[arg-type]


@pytest.mark.parametrize("name", ["r161-ash", "mlb-a", "single-wall"])
def test_every_kind_of_bat_can_be_varied(name: str) -> None:
    """Exact: the weights are what the labels say."""
    bat = catalog.bat(name)
    mass = rigid_body(beam_model(bat)).mass
    found, _ = candidates(bat)
    by_key = {one.key: one for one in found}
    for key in ("end-loaded", "knob-loaded", "weight+1oz"):
        assert by_key[key].body.mass - mass == pytest.approx(0.0283495, rel=1e-4), key
    assert by_key["end-loaded"].body.moi(0.0) > by_key["knob-loaded"].body.moi(0.0)


@pytest.fixture
def answer(advice: Advice, swings: SwingFile) -> FitPlayerAnswer:
    return player_answer(PlayerSwings(FitPlayerQuestion(Path("swings.csv")), swings, OWN, {}), advice)


def test_the_answers_in_words(advice: Advice, answer: FitPlayerAnswer, swings: SwingFile) -> None:
    asked = {question: str(words) for question, words in answers(advice)}
    assert set(asked) >= {"Balanced or end-loaded?", "Choke up?", "Which bat?"}
    unknown = {
        question for question, spoken in asked.items() if spoken.startswith(("These swings cannot", "Not known"))
    }
    assert unknown >= {"Heavier or lighter?", "Longer or shorter?", "Choke up?"}  # all swings are with one bat
    for spoken in (spoken for question, spoken in asked.items() if question not in unknown):
        assert re.search(r"ft \([-+]?[\d.]+ to [-+]?[\d.]+\)", spoken), spoken
    assert not any("nan" in spoken for spoken in asked.values())
    words = " ".join(map(str, findings(answer)))
    assert "The data cannot tell: what a heavier bat costs" in words
    assert any("row 7: too fast" in note for note in notes(swings))


def test_json_is_plain_and_rows_are_equal(answer: FitPlayerAnswer) -> None:
    document = player_document(answer)
    found = json.loads(json.dumps(document.data, allow_nan=False))
    assert found["parameters"]["exponent"]["told_by_data"] is False
    assert found["goal"] == {"name": "carry", "line_m": None}
    assert found["swings"]["bad_rows"] == [{"row": 7, "reason": "too fast"}]
    assert {len(column) for column in document.rows.values()} == {len(answer.options)}
    assert None not in document.rows["change_low_m"]


def test_real_swings_give_sensible_numbers() -> None:
    """Four hundred tracked major-league swings: near the whole table, 71.5 mph and 8.6 degrees [sure2026].

    Many batters are taken for one, so the scatter of the offset may be wide: 27 degrees are more than an inch.
    """
    path = real_file("cmu36sure2026_battedballs_battracking.csv.gz")
    found = read_swings(path, length=OWN.length, pitch_speed=PITCH)
    some: tuple[PlayerSwing, ...] = found.swings[::50]
    posterior = fit_player(player_model(some, bat=catalog.bat("mlb-a"), ball=BALL))
    values = {name: one.interval for name, one in posterior.learned.items()}
    assert values["bat_speed"].value / MPH == pytest.approx(71.5, abs=1.6)
    assert math.degrees(values["attack_angle"].value) == pytest.approx(8.6, abs=2.0)
    assert 4 < values["position"].value / INCH < 9  # where squared-up hits are possible
    assert 0.8 < values["position_spread"].value / INCH < 3.0
    assert 0.8 < values["offset_spread"].value / INCH < 1.8
    assert not posterior.learned["exponent"].told


@pytest.mark.parametrize(("mph", "sure"), [(0.01, False), (0.06, True)])
def test_a_gain_that_is_told_as_none_is_not_sure(advice: Advice, mph: float, sure: bool) -> None:
    """Exact: the interval of every gain begins 0.01 or 0.06 mph above zero, which are told as +0.0 and +0.1 mph."""
    gain = Interval(0.5 * MPH, mph * MPH, 0.9 * MPH)
    options = tuple(replace(option, change=gain, width_ratio=0.5, length_known=True) for option in advice.options)
    changed = replace(advice, goal=Goal(), options=options, end_loaded=gain)
    asked = {question: str(words) for question, words in answers(changed)}
    assert asked["Balanced or end-loaded?"].startswith("End-loaded" if sure else "These swings cannot tell")
    assert asked["Choke up?"].startswith("Yes" if sure else "These swings cannot tell")
    assert ("No other weight tried is surely better" in asked["Heavier or lighter?"]) == (not sure)
    assert ("none is surely better" in asked["Which bat?"]) == (not sure)
    assert (changed.surely_best is not None) == sure
    usual = tuple(replace(option, width_ratio=1.0) for option in options)
    assert replace(changed, options=usual).surely_best is None  # as sure as it may be, the swings say nothing of it


@pytest.mark.parametrize(("slower", "sign"), [(-1.0, 1), (0.4, 0), (2.0, 0)])
def test_a_bat_that_was_measured_slower_is_not_called_surely_better(advice: Advice, slower: float, sign: int) -> None:
    """Exact: the model expects 0.5 mph more of the second bat for sure; it was measured ``slower`` mph slower, +-1."""
    gain, own = Interval(0.5 * MPH, 0.3 * MPH, 0.7 * MPH), advice.posterior.model.bats[0].bat
    second = next(option for option in advice.options if option.candidate.family == "catalogue")
    measured = Interval(-slower * MPH, -(slower + 1) * MPH, (1 - slower) * MPH)
    pair = BatPair(second.candidate.bat.name, own.name, gain, 1.0, measured, Goal())
    told = replace(advice, goal=Goal(), options=(replace(second, change=gain),), pairs=(pair,))
    assert told.sign_of(told.options[0]) == sign
    assert (told.surely_best is not None) == (sign > 0)


def test_off_a_tee_the_ball_is_at_rest_and_no_pitch(advice: Advice) -> None:
    assert pitch_words(replace(advice, pitch_speed=0.0).pitch_speed).read(US) == "ball at rest"
    swing = PlayerSwing(2, 64 * MPH, 99 * MPH, 0.0, None, None, None, "")
    assert "than any bat gives at 64.0 mph off a tee" in fault_of(swing, OWN.length)

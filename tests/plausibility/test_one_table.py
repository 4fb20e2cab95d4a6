"""Every door gives the same verdict on a value: the command line, Python, tables of swings and seasons, the page."""

from __future__ import annotations

import warnings
from collections.abc import Callable
from dataclasses import replace
from functools import partial

import polars as pl
import pytest
from pydantic import ValidationError

import sweetspot
from sweetspot import catalog
from sweetspot.catalog.sports import sport_names
from sweetspot.errors import InputError, UnusualWarning
from sweetspot.motion.swing import Pitch, Swing
from sweetspot.plausibility import bounds, insisting, parse, verdict
from sweetspot.plausibility.table import MAX_SPEED, SPEEDS, TABLE
from sweetspot.player.player_swing import PlayerSwing, fault_of
from sweetspot.seasons.rows import POSSIBLE, _near
from sweetspot.units import MPH
from sweetspot.web.bats import ball_of
from sweetspot.web.controls import SwingState, SwungState, ViewState
from sweetspot.web.errors import FieldError
from sweetspot.web.views.flight_state import FlightState
from sweetspot.web.views.optimum import OptimumState
from sweetspot.web.views.player import PlayerState

Run = Callable[..., tuple[int, str, str]]
RECORDS = [(quantity, sport) for quantity, sports in TABLE.items() for sport in sports]
JUST = 1e-3
"""mph, how far beside a bound is tried."""
BESIDE = [
    (quantity, end + side * JUST)
    for quantity in ("bat_speed", "pitch_speed", "exit_speed")
    for end in (bounds(quantity, "baseball").low, bounds(quantity, "baseball").high)
    for side in (-1, 1)
]
HIT = ("hit", "r161-ash", "--at", "6in-from-tip")


@pytest.mark.parametrize(("quantity", "sport"), RECORDS)
def test_bounds_hold_at_their_ends_and_not_beyond(quantity: str, sport: str) -> None:
    record = bounds(quantity, sport)
    low, high = record.fine
    width = high - low
    assert record.verdict(low) == record.verdict(high) == "fine"
    assert {record.verdict(low - 1e-3 * width), record.verdict(high + 1e-3 * width)} <= {"unusual", "impossible"}
    assert record.possible[0] <= record.low < record.high <= record.possible[1]


def test_every_sport_has_its_own_exit_speeds() -> None:
    assert set(SPEEDS["exit_speed"]) - {""} == set(sport_names())


def accepted(action: Callable[[], object]) -> bool:
    """Return whether an action neither refuses nor warns of what it is given."""
    with warnings.catch_warnings():
        warnings.simplefilter("error", UnusualWarning)
        try:
            action()
        except (InputError, ValidationError, UnusualWarning):
            return False
    return True


def swing_of(quantity: str, value: float) -> PlayerSwing:
    nothing = PlayerSwing(2, None, None, None, None, None, None, "")
    return replace(nothing, **{quantity: value})  # type: ignore[arg-type]


def in_season(quantity: str, value: float) -> bool:
    if quantity == "exit_speed":
        return bool(pl.select(_near(pl.lit(value), "exit_speed")).item())
    low, high = POSSIBLE["plate_speed" if quantity == "pitch_speed" else quantity]
    return low <= value <= high


PAGES: dict[str, tuple[type[ViewState], ...]] = {
    "bat_speed": (SwingState,),
    "pitch_speed": (SwingState, PlayerState),
    "exit_speed": (FlightState, OptimumState),
}


@pytest.mark.parametrize(("quantity", "mph"), BESIDE)
def test_every_door_gives_the_same_verdict(quantity: str, mph: float) -> None:
    fine = verdict(quantity, mph * MPH, "baseball") == "fine"
    option = f"--{quantity.replace('_', '-')}"
    assert accepted(lambda: parse(f"{mph} mph", "speed", option, sport="baseball")) == fine
    assert (fault_of(swing_of(quantity, mph * MPH), 0.84) == "") == fine
    sliders = PAGES[quantity] if quantity != "pitch_speed" or mph > 100 else ()  # those of pitches begin at 0, a tee
    for state in sliders:
        field = "given_pitch_mph" if state is PlayerState else f"{quantity}_mph"
        assert accepted(partial(state, **{field: mph})) == fine


@pytest.mark.parametrize("mph", [mph for quantity, mph in BESIDE if quantity == "exit_speed"])
def test_a_season_gives_the_same_verdict_on_exit_speeds(mph: float) -> None:
    """Fast bats and pitches of a season are doubted by the column instead."""
    fine = verdict("exit_speed", mph * MPH, "baseball") == "fine"
    assert in_season("exit_speed", mph * MPH) == fine


@pytest.mark.parametrize(("quantity", "mph"), [one for one in BESIDE if one[0] != "exit_speed"])
def test_the_command_line_and_its_python_agree(run: Run, quantity: str, mph: float) -> None:
    fine = verdict(quantity, mph * MPH, "baseball") == "fine"
    assert (run(*HIT, f"--{quantity.replace('_', '-')}", f"{mph}mph")[0] == 0) == fine


@pytest.mark.parametrize("quantity", ["bat_speed", "pitch_speed"])
@pytest.mark.parametrize("beside", [-JUST, JUST])
def test_a_season_has_no_impossible_speed(quantity: str, beside: float) -> None:
    assert in_season(quantity, MAX_SPEED + beside) == (beside < 0)


@pytest.mark.parametrize("quantity", ["bat_speed", "pitch_speed"])
def test_nobody_can_insist_on_what_is_impossible(run: Run, quantity: str) -> None:
    option, too_fast = f"--{quantity.replace('_', '-')}", MAX_SPEED + 1
    code, out, said = run(*HIT, option, f"{too_fast}m/s", "--force")
    assert code == 2 and not out and "possible is 0 to 70 m/s" in said
    with insisting():
        assert "possible is 0 to 157 mph" in fault_of(swing_of(quantity, too_fast), 0.84)
        assert not fault_of(swing_of(quantity, 60.0), 0.84)
        with pytest.raises(ValueError, match="possible is"):
            Pitch(speed=too_fast) if quantity == "pitch_speed" else Swing(bat_speed=too_fast, measured_at=0.7)


RALLY = ("hit", "pickleball-paddle", "--at", "4.4in-from-tip")
BAT_SPORTS = {"baseball", "youth-baseball", "softball", "slow-pitch"}


@pytest.mark.parametrize("name", catalog.ball_names())
def test_every_ball_of_the_catalogue_is_fine(name: str) -> None:
    ball = catalog.ball(name)
    assert verdict("ball_restitution", ball.restitution.reference, ball.sport) == "fine"


@pytest.mark.parametrize("sport", sport_names())
def test_the_usual_stroke_of_every_sport_is_fine_by_far(sport: str) -> None:
    stroke = catalog.sport(sport).stroke
    bat, ball = stroke.swing_speed.value, stroke.ball_speed.value
    for quantity, speed in (("bat_speed", bat), ("pitch_speed", ball), ("closing_speed", bat + ball)):
        assert verdict(quantity, 1.2 * speed, sport) == "fine"


@pytest.mark.parametrize(
    ("given", "words"),
    [
        ({"ball_cor": 0.8}, "cor was given as 0.8; usual is 0.6 to 0.75 in pickleball"),
        (
            {"bat_speed": "60 mph", "pitch_speed": "80 mph"},
            "closing speed was given as 62.59 m/s; usual is 0 to",
        ),
    ],
)
def test_what_no_ball_and_no_rally_has_is_refused_by_all(run: Run, given: dict[str, object], words: str) -> None:
    options = [part for name, value in given.items() for part in (f"--{name.replace('_', '-')}", str(value))]
    code, out, said = run(*RALLY, *options)
    assert code == 2 and not out and words in said
    assert run(*RALLY, *options, "--force")[0] == 0
    with pytest.raises(InputError, match=words):
        sweetspot.hit("pickleball-paddle", at="4.4in-from-tip", **given)  # type: ignore[arg-type]
    with insisting():
        assert sweetspot.hit("pickleball-paddle", at="4.4in-from-tip", **given).contact_time  # type: ignore[arg-type]


def test_the_page_refuses_a_ball_that_nobody_plays_with() -> None:
    assert ball_of(SwungState(ball_cor=0.55)).restitution.reference == 0.55
    with pytest.raises(FieldError, match=r"usual is 0.38 to 0.62 in baseball"):
        ball_of(SwungState(ball_cor=0.8))


def test_speeds_of_another_sport_are_told_of_in_python() -> None:
    with pytest.warns(UnusualWarning, match="usual is 1 to 90 mph"):
        sweetspot.hit("pickleball-paddle", at="4.4in-from-tip", bat_speed=42.0, pitch_speed=5.0)

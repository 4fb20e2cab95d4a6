"""Which bat is named the best, and what is told as everybody's and not as this player's own."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from sweetspot import catalog
from sweetspot.catalog.aerodynamic_laws import aerodynamics
from sweetspot.equipment.bat import Bat
from sweetspot.flight.air import Air
from sweetspot.numerics.interval import REACH, Interval
from sweetspot.player.advice import Advice, advise
from sweetspot.player.bat_pairs import MeasuredBat
from sweetspot.player.best_bat import bat_choice
from sweetspot.player.expected_gain import Expectation, expectation
from sweetspot.player.goal import Goal
from sweetspot.player.model import player_model
from sweetspot.player.posterior import fit_player
from sweetspot.player.prior import NAMES, fixed, natural
from sweetspot.player.simulate import simulated_swings
from sweetspot.player.unlike_bats import liveliness
from sweetspot.reports.player.decision import lead_paragraphs
from sweetspot.reports.quantities import US
from sweetspot.reports.sentences import read
from sweetspot.units import INCH, MPH, OUNCE

OWN, HEAVY, BALL = catalog.bat("r161-ash"), catalog.bat("mlb-a"), catalog.ball()
LEADED = OWN.weighted(position=OWN.length - INCH, mass=4 * OUNCE).replaced(name="leaded")
PITCH = 60 * MPH


def advice_of(*, bats: int, count: int, exponent: float = 0.29, other: Bat = HEAVY) -> Advice:
    """Return the advice for a usual player with this exponent, who swung the own bat, and a second one or not."""
    player = natural(np.zeros(10))
    player[NAMES.index("exponent")] = exponent
    swung = [OWN, other][:bats]
    swings = simulated_swings(player, bats=swung, ball=BALL, count=count, pitch_speed=PITCH, seed=3)
    model = player_model(swings, bat=OWN, ball=BALL, others={other.name: other})
    return advise(fit_player(model), goal=Goal(), aerodynamics=aerodynamics(), air=Air(), others=[HEAVY])


@given(st.lists(st.integers(0, 3), min_size=20, max_size=20), st.integers(2, 4))
def test_chances_add_to_one_and_are_parts_of_the_draws(best: list[int], bats: int) -> None:
    """Exact: of every draw one bat is the best by a metre a second."""
    gained = {str(bat): np.array([float(index % bats == bat) for index in best]) for bat in range(bats)}
    choice = bat_choice(gained, {name: np.arange(4.0) * number for number, name in enumerate(gained)})
    assert choice is not None
    assert sum(bat.chance for bat in choice.bats) == pytest.approx(1.0)
    for bat in choice.bats:
        assert bat.chance == pytest.approx(np.mean([str(index % bats) == bat.name for index in best]))
    assert [bat.chance for bat in choice.bats] == sorted((bat.chance for bat in choice.bats), reverse=True)


def test_what_everybody_has_is_not_named() -> None:
    """Exact: the lead is sure, and as wide as anybody's: the swings say nothing."""
    sure = {"a": np.zeros(9), "b": np.linspace(1, 2, 9)}
    same, wider = bat_choice(sure, sure), bat_choice(sure, {"a": np.zeros(9), "b": np.linspace(-1, 2, 9)})
    assert same is not None and same.best is None and not same.own
    assert wider is not None and wider.best is not None and wider.best.chance == 1.0


def test_one_bat_tells_nothing_of_another_weight() -> None:
    advice = advice_of(bats=1, count=60)
    weights = [option for option in advice.options if option.candidate.family in ("weight", "choke", "catalogue")]
    assert len(weights) > 8 and not any(option.own for option in weights)
    assert advice.surely_best is None and advice.named_best is None
    first, everybody = (read(words, US) for words in lead_paragraphs(advice))
    assert first.startswith("Which bat is best for this player these swings cannot tell: all were made with one bat")
    assert "Worth training, by these swings: " in first
    assert everybody.startswith("For everybody, not by these swings: ")


def test_length_that_was_not_swung_is_not_known() -> None:
    """The other bat is an inch longer: one that nobody swung has no verdict, however sure a law is."""
    advice = advice_of(bats=1, count=20)
    (longer,) = (option for option in advice.options if option.candidate.family == "catalogue")
    assert not longer.length_known and advice.sign_of(longer) == 0 and advice.usual_sign(longer) == 0
    assert advice.choice is None  # there is no second bat whose length was swung
    (longer,) = (option for option in advice_of(bats=2, count=20).options if option.candidate.family == "swung")
    assert longer.length_known


def test_two_bats_tell_players_apart() -> None:
    """A player whom weight does not slow is told to swing heavier than one whom it slows much."""
    heavier = []
    for exponent in (0.12, 0.45):
        advice = advice_of(bats=2, count=200, exponent=exponent, other=LEADED)
        (option,) = (option for option in advice.options if option.candidate.key == "weight+3oz")
        assert option.own
        heavier.append(option)
    strong, weak = heavier
    assert strong.change.low > weak.change.high


def measured_means(asked: Expectation, difference: float, error: float) -> list[MeasuredBat]:
    """Return own and heavy bat measured, the heavy one's mean exit speed that much greater."""
    half = REACH * error
    means = [Interval(value, value - half, value + half) for value in (40.0, 40.0 + difference)]
    return [MeasuredBat(table.bat, 9, None, mean) for table, mean in zip(asked.model.bats, means, strict=True)]


def test_a_measured_difference_tells_how_lively_a_bat_is() -> None:
    """Exact: measured without error, the model's expectation becomes what was measured; not at all, it stays."""
    asked = expectation(advice_of(bats=2, count=20).posterior, goal=Goal(), pitch_speed=PITCH, carries=None, seed=1)
    own, other = asked.model.bats
    expected = asked.of(other) - asked.of(own)
    for difference in (-3.0 * MPH, 2.0 * MPH):
        found = liveliness(asked, measured_means(asked, difference, 1e-9)).of(HEAVY.name)
        # a ball met off the best place or the axis shows a part of a bat's liveliness only
        more = asked.of(other, livelier=found) - asked.of(own)
        assert np.mean((more - expected) / (difference - expected)) == pytest.approx(0.9, abs=0.1)
    known, unknown = (liveliness(asked, swung).of(HEAVY.name) for swung in (measured_means(asked, 5.0, 1e6), ()))
    assert known == pytest.approx(unknown, abs=1e-6)
    assert float(np.std(unknown)) == pytest.approx(2**0.5 * fixed("bat_description"), rel=0.2)


def test_the_own_bat_is_one_of_several() -> None:
    """Two bats that were never swung differ from the own one alike, for the own one may be dead: r is a half."""
    asked = expectation(advice_of(bats=2, count=20).posterior, goal=Goal(), pitch_speed=PITCH, carries=None, seed=1)
    found = liveliness(asked)
    assert np.corrcoef(found.of("a"), found.of("b"))[0, 1] == pytest.approx(0.5, abs=0.15)
    # a heavy bat that gave much more says that the own one is dead, and so that others are livelier beside it
    surprise = liveliness(asked, measured_means(asked, 5.0, 0.05))
    gain = np.mean(surprise.of(HEAVY.name) - found.of(HEAVY.name))
    assert np.mean(surprise.of("a") - found.of("a")) == pytest.approx(gain / 2, rel=0.05)


def test_without_the_own_bat_measured_nothing_is_learned() -> None:
    asked = expectation(advice_of(bats=2, count=20).posterior, goal=Goal(), pitch_speed=PITCH, carries=None, seed=1)
    assert liveliness(asked, measured_means(asked, 5.0, 0.05)[1:]).beside == {}

"""Whether a player's advice can be trusted: ``python -m studies.player_advice``, four minutes of a core.

The players are made up and their truth is known: from light to heavy swingers and from tip to handle hitters, as the
prior has them, with five bats of one outline from 27 to 35 oz. Each single bat is livelier or deader than described, as
much as `bat_description` says. They swing the lightest only, the lightest and the heaviest, or all five. Of the bats
that are named the best so many should be the best as their stated chances promise, to five points; and the
advice should differ between players as their truths do.
"""

from __future__ import annotations

import argparse
from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cache
from itertools import pairwise

import numpy as np
from scipy.stats import spearmanr

from sweetspot import catalog
from sweetspot.catalog.aerodynamic_laws import aerodynamics
from sweetspot.catalog.scaled_implements import Measures, scaled_to
from sweetspot.equipment.bat import Bat
from sweetspot.flight.air import Air
from sweetspot.numerics.arrays import Array
from sweetspot.player.advice import Advice, advise
from sweetspot.player.bat_response import response_of
from sweetspot.player.expected_gain import Expectation
from sweetspot.player.goal import Goal
from sweetspot.player.model import player_model
from sweetspot.player.player_swing import PlayerSwing
from sweetspot.player.posterior import fit_player
from sweetspot.player.prior import NAMES, fixed, natural, prior_draws
from sweetspot.player.simulate import simulated_swings
from sweetspot.units import MPH, OUNCE

WEIGHTS = (27.0, 29.0, 31.0, 33.0, 35.0)
"""oz; the player's own bat first."""
SWUNG = {1: (0,), 2: (0, 4), 5: (0, 1, 2, 3, 4)}
"""Bats of these that are swung, by how many."""
PITCH = 60 * MPH
TRUE_SWINGS = 20_000
"""Swings that the truth is the mean of."""
CHANCES = (0.0, 0.35, 0.45, 0.6, 0.8, 1.01)
"""Ends of the stretches of stated chances that are compared with what came true."""
SHIFT = NAMES.index("efficiency_shift")


@dataclass(frozen=True)
class Outcome:
    """One player with so many swings: what was advised, and what is true.

    ``named``, ``chance``: the bat named the best, "" where the swings cannot tell, and the chance of the likeliest.
    ``likeliest``, ``best``: the likeliest bat, and the best one. ``heavier``, ``true_heavier``: m/s, of 3 oz more.
    """

    bats: int
    count: int
    named: str
    likeliest: str
    chance: float
    best: str
    heavier: float
    true_heavier: float


@cache
def five_bats() -> tuple[Bat, ...]:
    """Return the five bats, the player's own first."""
    own = catalog.bat("r161-ash")
    bats = []
    for ounces in WEIGHTS:
        bat, _ = scaled_to(own, Measures(mass=ounces * OUNCE))
        assert isinstance(bat, Bat)
        bats.append(bat.replaced(name=f"{ounces:g} oz"))
    return tuple(bats)


def swings_of(player: Array, livelier: Array, bats: Sequence[int], *, count: int, seed: int) -> list[PlayerSwing]:
    """Return swings of a player, shape (10,) in SI, who takes the bats in turn; ``livelier``: of each, in q."""
    swings: list[PlayerSwing] = []
    for place, index in enumerate(bats):
        of_bat = player.copy()
        of_bat[SHIFT] += livelier[index]
        many = len(range(place, count, len(bats)))
        bat = five_bats()[index]
        # the own bat comes first in a simulation: its turns are left out where the other is swung
        both = [five_bats()[0], bat] if index else [bat]
        drawn = simulated_swings(
            of_bat, bats=both, ball=catalog.ball(), count=many * len(both), pitch_speed=PITCH, seed=seed + 17 * index
        )
        swings += [swing for swing in drawn if (swing.bat == bat.name) == bool(index)]
    return [replace(swing, row=row) for row, swing in enumerate(swings, start=2)]


def outcome(standard: Array, *, bats: int, count: int, seed: int) -> Outcome:
    """Return what one player is advised from so many swings with so many bats, and the truth."""
    player, random = natural(standard), np.random.default_rng(seed)
    single = fixed("bat_description") * random.standard_normal(len(WEIGHTS))
    livelier = single - single[0]  # the own bat's own is in the player's efficiency shift
    swings = swings_of(player, livelier, SWUNG[bats], count=count, seed=seed)
    others = {bat.name: bat for bat in five_bats()[1:]}
    model = player_model(swings, bat=five_bats()[0], ball=catalog.ball(), others=others)
    advice = advise(
        fit_player(model, seed=seed),
        goal=Goal(),
        aerodynamics=aerodynamics(),
        air=Air(),
        others=five_bats()[1:],
        pitch_speed=PITCH,
    )
    truth = true_expectation(advice, player, seed)
    tables = [response_of(bat, ball=model.ball, axis=model.law.axis) for bat in five_bats()]
    goals = [float(truth.of(table, livelier=np.array([more]))[0]) for table, more in zip(tables, livelier, strict=True)]
    (heavier,) = (option for option in advice.options if option.candidate.key == "weight+3oz")
    table = response_of(heavier.candidate.bat, ball=model.ball, axis=model.law.axis, like=model.bats[0])
    assert advice.choice is not None
    first = advice.choice.bats[0]
    return Outcome(
        bats,
        count,
        named=advice.named_best.name if advice.named_best else "",
        likeliest=first.name,
        chance=first.chance,
        best=five_bats()[int(np.argmax(goals))].name,
        heavier=heavier.change.value,
        true_heavier=float(truth.of(table)[0] - truth.of(model.bats[0])[0]),
    )


def true_expectation(advice: Advice, player: Array, seed: int) -> Expectation:
    """Return the question asked of the true player."""
    scatter = np.random.default_rng(seed).standard_normal((4, 1, TRUE_SWINGS))
    return Expectation(advice.posterior.model, player[None, :], Goal(), PITCH, None, scatter)


def main(arguments: Sequence[str] | None = None) -> None:
    """Print how often named bats are the best, and how well advice follows the truth."""
    options = argparse.ArgumentParser(description=__doc__)
    options.add_argument("--players", type=int, default=300)
    options.add_argument("--swings", type=int, nargs="+", default=[200])
    options.add_argument("--bats", type=int, nargs="+", default=[2], choices=sorted(SWUNG))
    options.add_argument("--seed", type=int, default=5)
    given = options.parse_args(arguments)
    players = prior_draws(given.players, seed=given.seed)
    everything: list[Outcome] = []
    for bats in given.bats:
        for count in given.swings:
            outcomes = [
                outcome(player, bats=bats, count=count, seed=1000 * given.seed + number)
                for number, player in enumerate(players)
            ]
            everything += outcomes
            print(f"{bats} bats, {count:3} swings: {summary(outcomes)}", flush=True)
    print(f"all: {summary(everything)}")
    for low, high in pairwise(CHANCES):
        some = [result for result in everything if low <= result.chance < high]
        if some:
            right = np.mean([result.likeliest == result.best for result in some])
            print(f"chance {low:.2f} to {high:.2f}: {len(some)}, right {right:.2f}, promised {_mean_chance(some):.2f}")


def _mean_chance(outcomes: Sequence[Outcome]) -> float:
    return float(np.mean([result.chance for result in outcomes]))


def summary(outcomes: Sequence[Outcome]) -> str:
    """Return how often a bat is named and right, the likeliest is right, and the rank correlation of 3 oz more."""
    named = [one for one in outcomes if one.named]
    right = np.mean([one.named == one.best for one in named]) if named else float("nan")
    promised = _mean_chance(named) if named else float("nan")
    likeliest = np.mean([one.likeliest == one.best for one in outcomes])
    chance = _mean_chance(outcomes)
    rank = spearmanr([one.heavier for one in outcomes], [one.true_heavier for one in outcomes]).statistic
    return (
        f"named {len(named)} of {len(outcomes)}, right {right:.2f}, promised {promised:.2f}; likeliest right "
        f"{likeliest:.2f}, promised {chance:.2f}; 3 oz more, rank correlation {rank:.2f}"
    )


if __name__ == "__main__":
    main()

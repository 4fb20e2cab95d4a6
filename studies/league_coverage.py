"""What partial pooling does to a made-up league: ``python -m studies.league_coverage --players 100 --swings 40``.

Players of one league with known truth are fitted from half of their swings, alone and pooled. Told are how often the 50
and 90 % intervals hold the truth, how far both fits are from it, and how well both foretell the mean exit speed of
the other half of the swings. ``--simulator full`` takes full collisions in space, of which the fit's model knows only
the rule (`studies/player_coverage.py`); ``--simulator own`` takes the fit's own rules, for which intervals must hold.
"""

from __future__ import annotations

import argparse
from collections.abc import Sequence

import numpy as np

from studies.player_coverage import PITCH, swings_of
from sweetspot import catalog
from sweetspot.numerics.arrays import Array
from sweetspot.player.expected_gain import expectation
from sweetspot.player.goal import Goal
from sweetspot.player.model import player_model
from sweetspot.player.player_swing import PlayerSwing
from sweetspot.player.posterior import PlayerPosterior, fit_player, own_share, population_of, refitted
from sweetspot.player.prior import NAMES, natural, standardised
from sweetspot.player.simulate import simulated_swings
from sweetspot.units import MPH

MEAN = np.array([0.35, 0.2, 0.0, -0.2, 0.3, 0.1, 0.0, 0.2, 0.4, 0.2])
SPREAD = np.array([0.35, 0.4, 0.6, 0.5, 0.5, 0.5, 0.5, 0.6, 0.3, 0.5])
"""Of the made-up league, in standard parameters: neither mean nor spread is the prior's."""


def made(place: Array, count: int, seed: int, simulator: str) -> tuple[PlayerSwing, ...]:
    """Return swings of one player."""
    if simulator == "full":
        return swings_of(natural(place), count=count, seed=seed)
    bat = catalog.bat("r161-ash")
    return simulated_swings(natural(place), bats=[bat], ball=catalog.ball(), count=count, pitch_speed=PITCH, seed=seed)


def foretold(fit: PlayerPosterior) -> float:
    """Return the mean exit speed that a fit expects, m/s."""
    asked = expectation(fit, goal=Goal(), pitch_speed=PITCH, carries=None, seed=1)
    return float(asked.of(fit.model.bats[0]).mean())


def held(fits: list[PlayerPosterior], truth: Array, part: float) -> Array:
    """Return by parameter how often the intervals that promise a part hold the truth."""
    draws = np.array([np.quantile(fit.draws, (0.5 - part / 2, 0.5 + part / 2), axis=0) for fit in fits])
    return np.asarray(np.mean((draws[:, 0] <= truth) & (truth <= draws[:, 1]), axis=0))


def main(arguments: Sequence[str] | None = None) -> None:
    """Print coverage and errors, alone and pooled."""
    options = argparse.ArgumentParser(description=__doc__)
    options.add_argument("--players", type=int, default=100)
    options.add_argument("--swings", type=int, default=40, help="of each player in the half that is fitted")
    options.add_argument("--simulator", choices=("full", "own"), default="full")
    given = options.parse_args(arguments)
    random = np.random.default_rng(17)
    standard = MEAN + SPREAD * random.standard_normal((given.players, len(NAMES)))
    alone, other = [], []
    for number, place in enumerate(standard):
        swings = made(place, 2 * given.swings, number, given.simulator)
        alone.append(fit_player(player_model(swings[::2], bat=catalog.bat("r161-ash"), ball=catalog.ball())))
        other.append(float(np.mean([one.exit_speed for one in swings[1::2] if one.exit_speed is not None])))
    league = population_of(alone)
    assert league is not None, "too few players for a league"
    pooled = [refitted(fit, league) for fit in alone]
    truth = natural(standard)
    bars = {kind: [held(fits, truth, part) for part in (0.5, 0.9)] for kind, fits in (("a", alone), ("p", pooled))}
    error = {
        kind: np.sqrt(
            np.mean((np.array([standardised(fit.draws).mean(axis=0) for fit in fits]) - standard) ** 2, axis=0)
        )
        for kind, fits in (("a", alone), ("p", pooled))
    }
    print(f"{'':18} held alone  pooled      error alone pooled  own share")
    for index, name in enumerate(NAMES):
        share = np.mean([own_share(fit, league)[name] for fit in pooled])
        print(
            f"{name:18} {bars['a'][0][index]:.2f} {bars['a'][1][index]:.2f}   {bars['p'][0][index]:.2f} "
            f"{bars['p'][1][index]:.2f}   {error['a'][index]:8.3f} {error['p'][index]:8.3f}   {share:.2f}"
        )
    for kind, words in (("a", "alone"), ("p", "pooled")):
        print(f"{words}: 50 % hold {bars[kind][0].mean():.3f}, 90 % hold {bars[kind][1].mean():.3f}, "
              f"error {np.sqrt((error[kind] ** 2).mean()):.3f} of the prior's deviation")  # fmt: skip
    for words, fits in (("alone", alone), ("pooled", pooled)):
        apart = (np.array([foretold(fit) for fit in fits]) - other) / MPH
        print(
            f"{words}: mean exit speed of the other half foretold to {apart.std():.3f} mph (bias {apart.mean():+.2f})"
        )


if __name__ == "__main__":
    main()

"""Whether a plan of swings reaches its stated error: ``python -m studies.plan_coverage --players 100``.

Players are made up as the prior has them; each swings the plan batch by batch, with its own bat and the same with lead,
until the fit says stop. Of an error that promises 90 % the truth should be within it in 85 to 95 % of the runs.
"""

from __future__ import annotations

import argparse
from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from sweetspot import catalog
from sweetspot.answers.plan_swings import after
from sweetspot.numerics.arrays import Array
from sweetspot.player.model import player_model
from sweetspot.player.planning import Aim, SwingPlan, SwingScatter, swing_plan
from sweetspot.player.player_swing import PlayerSwing
from sweetspot.player.posterior import fit_player
from sweetspot.player.prior import NAMES, fixed, natural, prior_draws
from sweetspot.player.simulate import simulated_swings
from sweetspot.units import INCH, MPH

PITCH = 60 * MPH
WITHIN: dict[Aim, float] = {"exponent": 0.08, "position": 0.5 * INCH}


def run(player: Array, plan: SwingPlan, *, within: float, batch: int, most: int, seed: int) -> tuple[float, int, bool]:
    """Return by how much the estimate is off the truth when a player stops, after how many swings, and whether he did.

    ``player``: shape (10,), SI. ``batch``: swings after which is asked. ``most``: swings after which a player gives up.
    """
    swings: list[PlayerSwing] = []
    truth = float(player[NAMES.index(plan.aim)])
    random = np.random.default_rng(seed)
    while True:
        drawn = simulated_swings(
            player,
            bats=plan.bats,
            ball=catalog.ball(),
            count=batch,
            pitch_speed=PITCH,
            seed=int(random.integers(1 << 31)),
        )
        swings += [_marked(swing, player, random) for swing in drawn] if plan.aim == "position" else drawn
        model = player_model(
            swings, bat=plan.bats[0], ball=catalog.ball(), others={bat.name: bat for bat in plan.bats[1:]}
        )
        posterior = fit_player(model, seed=seed)
        found = posterior.learned[plan.aim].interval
        if not after(plan, posterior, within).further(found.half_width, within):
            return found.value - truth, len(swings), True
        if len(swings) >= most:
            return found.value - truth, len(swings), False


def _marked(swing: PlayerSwing, player: Array, random: np.random.Generator) -> PlayerSwing:
    """Return a swing with the place of the ball's mark and nothing else about the ball, so that both agree."""
    mean, spread = (float(player[NAMES.index(name)]) for name in ("position", "position_spread"))
    place = mean + spread * random.standard_normal() + fixed("position_noise") * random.standard_normal()
    return replace(swing, exit_speed=None, launch_angle=None, position=float(max(place, 0.0)))


def main(arguments: Sequence[str] | None = None) -> None:
    """Print in how many of the runs the truth is within the stated error."""
    options = argparse.ArgumentParser(description=__doc__)
    options.add_argument("--players", type=int, default=100)
    options.add_argument("--batch", type=int, default=20)
    options.add_argument("--most", type=int, default=400)
    options.add_argument("--find", nargs="+", default=["exponent", "position"], choices=list(WITHIN))
    options.add_argument("--seed", type=int, default=3)
    given = options.parse_args(arguments)
    players = natural(prior_draws(given.players, seed=given.seed))
    for aim in given.find:
        within = WITHIN[aim]
        plan = swing_plan(
            [catalog.bat("r161-ash")], aim=aim, within=within, law=catalog.swing_law(), scatter=SwingScatter.usual()
        )
        ends = [
            run(player, plan, within=within, batch=given.batch, most=given.most, seed=1000 * given.seed + number)
            for number, player in enumerate(players)
        ]
        stopped = [(abs(error), count) for error, count, done in ends if done]
        held = np.mean([error <= within for error, _ in stopped]) if stopped else float("nan")
        swings = np.median([count for _, count in stopped]) if stopped else float("nan")
        print(
            f"{aim}: planned {len(plan.order)} swings, stopped {len(stopped)} of {len(ends)}, after {swings:.0f} in "
            f"the median; truth within the error in {held:.2f}",
            flush=True,
        )


if __name__ == "__main__":
    main()

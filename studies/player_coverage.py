"""How often a player's intervals hold the truth: ``python -m studies.player_coverage --players 100``.

The players are made up by another simulator than the fit's own: every swing is an oblique collision in space with a
pitch of its own speed, descent and spin and a tilt of its own, no table is read, and bat speeds have a tail of
protective swings. Their parameters are drawn from the prior. Of intervals that promise 90 % between 88 and 92 should
hold the truth.
"""

from __future__ import annotations

import argparse
from collections.abc import Sequence

import numpy as np

from sweetspot import catalog
from sweetspot.collision.hit_in_space import Contact, strikes
from sweetspot.dynamics.reduction import reduced_bat
from sweetspot.motion.ball_motion import BallMotions
from sweetspot.motion.swing import SPEED_FROM_TIP
from sweetspot.motion.swing_path import Swings, path_axes, steep_enough
from sweetspot.numerics.arrays import Array
from sweetspot.player.model import player_model
from sweetspot.player.player_swing import PlayerSwing
from sweetspot.player.posterior import fit_player
from sweetspot.player.prior import NAMES, fixed, natural, prior_draws
from sweetspot.units import DEGREE, INCH, MPH, RPM

PITCH, PITCH_SPREAD = 82 * MPH, 5 * MPH
DESCENT_SPREAD, TILT_SPREAD = 1.6 * DEGREE, 6.7 * DEGREE
PITCH_SPIN, PITCH_SPIN_SPREAD = 700 * RPM, 900 * RPM
ANGLE_ERROR, SPEED_ERROR = 1 * DEGREE, 1 * MPH
PROTECTIVE, SLOWER = 0.05, 10 * MPH
"""Part of swings that are meant to reach the ball and no more, and by how much they are slower on average."""
FARTHEST, STEEPEST = 14 * INCH, 60 * DEGREE
"""m from the tip, and launch angle, up to which hits are in the file."""


def swings_of(
    theta: Array, *, count: int, seed: int, protective: float = PROTECTIVE, unsteady: float = 1.0
) -> tuple[PlayerSwing, ...]:
    """Return swings of one made-up player with an ash bat.

    Parameters
    ----------
    protective : part of swings that are slower.
    unsteady : times the scatter of tilt, descent and spin.
    """
    value = dict(zip(NAMES, (float(one) for one in theta), strict=True))
    random = np.random.default_rng(seed)
    bat, ball, many = catalog.bat("r161-ash"), catalog.ball(), 8 * count
    draw = random.standard_normal
    speed = value["bat_speed"] + value["bat_speed_spread"] * draw(many)
    speed -= np.where(random.random(many) < protective, SLOWER * random.exponential(size=many), 0.0)
    attack = value["attack_angle"] + fixed("attack_angle_spread") * draw(many)
    tilt = fixed("swing_tilt") + unsteady * TILT_SPREAD * draw(many)
    place = value["position"] + value["position_spread"] * draw(many)
    above = value["offset"] + value["offset_spread"] * draw(many)
    pitch = PITCH + PITCH_SPREAD * draw(many)
    descent = fixed("pitch_descent") + unsteady * DESCENT_SPREAD * draw(many)
    backspin = PITCH_SPIN + unsteady * PITCH_SPIN_SPREAD * draw(many)
    fine = (place > 0) & (place < FARTHEST) & (speed > 20 * MPH)
    there = speed * (bat.length - bat.choke - place) / (bat.length - bat.choke - SPEED_FROM_TIP)
    plane = np.array([steep_enough(float(one), float(up)) for one, up in zip(tilt, attack, strict=True)])
    axes = path_axes(attack[fine], 0.0, tilt=plane[fine], left=False)
    ahead = np.stack([np.zeros(many), -np.cos(descent), -np.sin(descent)], axis=-1)
    spin = np.stack([-backspin, np.zeros(many), np.zeros(many)], axis=-1)  # lifts a ball that comes in along -y
    done = strikes(
        reduced_bat(bat, ball=ball),
        ball=ball,
        swings=Swings(there[fine], axes),
        pitches=BallMotions(velocity=(pitch[:, None] * ahead)[fine], spin=spin[fine]),
        contact=Contact(bat.length - place[fine], above[fine]),
    )
    launch = np.arctan2(done.velocity[:, 2], np.hypot(done.velocity[:, 0], done.velocity[:, 1]))
    head_on = np.cos(np.clip(launch - attack[fine], -1.5, 1.5))
    out = done.exit_speed + value["efficiency_shift"] * (pitch + there)[fine] * np.maximum(head_on, 0.2)
    kept = np.isfinite(out) & (done.velocity[:, 1] > 0) & (np.abs(launch) < STEEPEST)
    rows = np.flatnonzero(kept)[:count]
    return tuple(
        PlayerSwing(
            row=number + 2, bat_speed=float(speed[fine][i] + SPEED_ERROR * draw()),
            exit_speed=float(out[i] + value["exit_noise"] * draw()), pitch_speed=float(pitch[fine][i]),
            launch_angle=float(launch[i] + ANGLE_ERROR * draw()),
            attack_angle=float(attack[fine][i] + ANGLE_ERROR * draw()), position=None, bat="",
        )
        for number, i in enumerate(rows)
    )  # fmt: skip


def main(arguments: Sequence[str] | None = None) -> None:
    """Print, for every parameter, how many of the intervals held the truth."""
    options = argparse.ArgumentParser(description=__doc__)
    options.add_argument("--players", type=int, default=100)
    options.add_argument("--swings", type=int, default=80)
    options.add_argument("--protective", type=float, default=PROTECTIVE, help="part of swings that are slower")
    options.add_argument("--unsteady", type=float, default=1.0, help="times the scatter of tilt, descent and spin")
    options.add_argument("--seed", type=int, default=11, help="of the players and of their swings")
    given = options.parse_args(arguments)
    inside = np.zeros((given.players, len(NAMES)), bool)
    rank = np.zeros((given.players, len(NAMES)))
    apart = np.zeros((given.players, len(NAMES)))
    for player, standard in enumerate(prior_draws(given.players, seed=given.seed)):
        theta = natural(standard)
        swings = swings_of(theta, count=given.swings, seed=1000 * given.seed + player,
                          protective=given.protective, unsteady=given.unsteady)  # fmt: skip
        # a seed of its own: with one for all, the draws' own error would be the same for every player
        found = fit_player(player_model(swings, bat=catalog.bat("r161-ash"), ball=catalog.ball()), seed=player)
        low, high = np.quantile(found.draws, (0.05, 0.95), axis=0)
        inside[player] = (low <= theta) & (theta <= high)
        rank[player] = (found.draws < theta).mean(axis=0)
        apart[player] = (found.draws.mean(axis=0) - theta) / found.draws.std(axis=0)
    for number, name in enumerate(NAMES):
        print(
            f"{name:18} held {inside[:, number].mean():.2f}  mean rank {rank[:, number].mean():.2f}  off by "
            f"{apart[:, number].mean():+.2f} +- {apart[:, number].std():.2f} of its own deviation"
        )
    print(f"all {inside.mean():.3f}")


if __name__ == "__main__":
    main()

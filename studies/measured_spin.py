"""Compare the collision with measured spin of hits: ``python -m studies.measured_spin ../shared/data``.

A college club's hits have spin rate and axis, and so have the pitches. Two things are asked.

All that a bat does to a ball acts at one point of its surface, so with the pitch and the launch measured the change of
spin is -(5 / 2r) n x (v' - v): it says where on the ball the bat touched, and what part of the blow was friction, with
no bat known. And the lines of backspin and sidespin of a made-up league of full collisions stand beside those of rate
and axis, with friction, its restitution and the barrel's tilt changed one at a time.
"""

from __future__ import annotations

import argparse
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import polars as pl

from studies.air_law import COLLEGE, Array, Balls, college_balls, college_rows, lines_by_rates
from sweetspot import catalog
from sweetspot.collision.oblique_contact import FRICTION, TANGENTIAL_RESTITUTION, Friction
from sweetspot.motion.ball_motion import spin_axes
from sweetspot.units import DEGREE, FOOT, INCH, MPH, RPM
from sweetspot.validation.computations.space import simulated_league

ROUNDS = 20
BAT = "r161-ash"
VARIED: Mapping[str, tuple[Friction, float]] = {
    "as it is": (Friction(), 31.9),
    "e_x 0": (Friction(FRICTION, 0.0), 31.9),
    "e_x 0.15": (Friction(FRICTION, 0.15), 31.9),
    "e_x 0.45": (Friction(FRICTION, 0.45), 31.9),
    "friction 0.1": (Friction(0.10, TANGENTIAL_RESTITUTION), 31.9),
    "friction 0.4": (Friction(0.40, TANGENTIAL_RESTITUTION), 31.9),
    "tilt 27 deg": (Friction(), 27.0),
    "tilt 37 deg": (Friction(), 37.0),
}
"""What is changed, and the mean tilt of the swings, deg."""


@dataclass(frozen=True)
class Touch:
    """What the change of a ball's spin says of the blow, shape (n,).

    Parameters
    ----------
    friction : tangential over normal impulse.
    gyrospin : of the hit about its way, rad/s, so that the blow acts at one point.
    below, aside : by how much the line of centres points less upward and more to the right than the blow, rad.
    """

    friction: Array
    gyrospin: Array
    below: Array
    aside: Array


def touch(velocity: Array, *, pitch: Array, pitch_spin: Array, rate: Array, axis: Array, radius: float) -> Touch:
    """Return where balls were touched.

    Parameters
    ----------
    velocity, pitch : of the ball after and before the bat, m/s, shape (n, 3).
    pitch_spin : rad/s, shape (n, 3), all of it taken as active.
    rate, axis : of the hit's spin, rad/s and rad from the direction that pure backspin has, shape (n,).
    radius : of the ball, m.
    """
    speed = np.linalg.norm(velocity, axis=-1)
    angle = np.arcsin(velocity[:, 2] / speed)
    axes = spin_axes(angle, np.arctan2(velocity[:, 0], velocity[:, 1]))
    change = velocity - pitch
    size = np.linalg.norm(change, axis=-1)
    along = change / size[:, None]
    gyro = np.zeros(len(speed))
    for _ in range(ROUNDS):  # the rate has the gyrospin in it
        active = np.sqrt(np.maximum(rate**2 - gyro**2, 0.0))
        across = (active * np.cos(axis))[:, None] * axes[0] - (active * np.sin(axis))[:, None] * axes[1]
        gyro = -((across - pitch_spin) * along).sum(-1) / (axes[2] * along).sum(-1)
        gyro = np.clip(gyro, -rate, rate)
    turned = across + gyro[:, None] * axes[2] - pitch_spin
    sine = np.minimum(np.linalg.norm(turned, axis=-1) * 2 * radius / (5 * size), 1.0)
    toward = np.cross(along, -turned)
    toward /= np.linalg.norm(toward, axis=-1, keepdims=True)
    normal = np.sqrt(1 - sine**2)[:, None] * along + sine[:, None] * toward
    return Touch(
        friction=sine / np.sqrt(1 - sine**2),
        gyrospin=gyro,
        below=np.arcsin(along[:, 2]) - np.arcsin(normal[:, 2]),
        aside=np.arctan2(normal[:, 0], normal[:, 1]) - np.arctan2(along[:, 0], along[:, 1]),
    )


def touched(table: pl.DataFrame, balls: Balls) -> tuple[Touch, np.ndarray]:
    """Return where the hits of a club's table were touched, and which rows have all that it takes."""

    def column(name: str) -> Array:
        return np.asarray(table[name].cast(pl.Float64).fill_null(np.nan).to_numpy(), float)

    time = column("ZoneTime")
    pitch = FOOT * np.stack(
        [column(f"PitchTrajectory{axis}c1") + 2 * column(f"PitchTrajectory{axis}c2") * time for axis in "ZXY"], axis=-1
    )
    tilt = column("SpinAxis") * DEGREE
    lift = np.stack([np.sin(tilt), np.zeros(len(tilt)), -np.cos(tilt)], axis=-1)
    pitch_spin = column("SpinRate")[:, None] * RPM * np.cross([0.0, -1.0, 0.0], lift)
    axis = column("HitSpinAxis") * DEGREE - np.pi
    velocity = balls.speed[:, None] * spin_axes(balls.angle, balls.direction)[2]
    whole = np.isfinite(pitch_spin).all(axis=-1) & np.isfinite(pitch).all(axis=-1) & np.isfinite(balls.backspin)
    rate = np.hypot(balls.backspin, balls.sidespin)
    return touch(
        velocity[whole], pitch=pitch[whole], pitch_spin=pitch_spin[whole], rate=rate[whole], axis=axis[whole],
        radius=catalog.ball().radius,
    ), whole  # fmt: skip


def lines_of(friction: Friction, tilt: float, count: int) -> tuple[Array, Array]:
    """Return the lines of spin of a made-up league of right-handers, as `lines_by_rates` writes them."""
    hits = simulated_league(BAT, left_handed=0.0, count=count, friction=friction, mean_tilt=tilt * DEGREE)
    rows = (hits.launch_angle > 10 * DEGREE) & (hits.launch_angle < 45 * DEGREE) & (hits.exit_speed > 75 * MPH)
    known = np.stack([np.ones_like(hits.spray), hits.launch_angle / DEGREE - 27, hits.spray / DEGREE], axis=-1)[rows]
    back, side = (
        np.asarray(np.linalg.lstsq(known, spin[rows] / RPM, rcond=None)[0], float)
        for spin in (hits.backspin, hits.sidespin)
    )
    return back, side


def places(balls: Balls) -> None:
    """Print how the launch direction goes with the place of contact in space, and what is left of the exit speed."""
    out, right = balls.start[:, 1] / INCH, balls.side * balls.start[:, 0] / INCH  # right: away from a right-hander
    pull = -balls.side * balls.direction / DEGREE
    good = np.isfinite(out) & np.isfinite(right)
    known = np.stack([np.ones(good.sum()), out[good] - np.median(out[good]), right[good]], axis=-1)
    for name, values in (("direction to the pull side, deg", pull), ("exit speed, mph", balls.speed / MPH)):
        answer, left, *_ = np.linalg.lstsq(known, values[good], rcond=None)
        spread = np.sqrt(left[0] / (len(known) - 3))
        errors = spread * np.sqrt(np.diag(np.linalg.inv(known.T @ known)))
        print(
            f"  {name}: {answer[1]:+.2f} +- {errors[1]:.2f} an inch farther out in front, "
            f"{answer[2]:+.2f} +- {errors[2]:.2f} an inch farther from the batter; left over {spread:.1f}"
        )


def main(arguments: Sequence[str] | None = None) -> None:
    """Read, ask, compare."""
    options = argparse.ArgumentParser(description=__doc__)
    options.add_argument("folder", type=Path, nargs="?", help="folder of the public tables; none: only the collision")
    options.add_argument("--count", type=int, default=60_000, help="made-up swings of each league")
    given = options.parse_args(arguments)
    print(
        "backspin at 27 deg, per deg of launch, of spray to the opposite side; sidespin of a right-hander likewise, rpm"
    )
    if given.folder is not None:
        table = college_rows(given.folder / COLLEGE)
        balls = college_balls(table)
        (back, about), (side, around) = lines_by_rates(balls)
        cells = [
            f"{value:.0f} +- {error:.0f}"
            for value, error in zip([*back, *side[:3]], [*about, *around[:3]], strict=True)
        ]
        print(f"  {'measured':14}", "  ".join(cells))
    for name, (friction, tilt) in VARIED.items():
        back, side = lines_of(friction, tilt, given.count)
        print(f"  {name:14}", "  ".join(f"{value:.0f}" for value in (*back, *side)))
    if given.folder is None:
        return
    found, whole = touched(table, balls)
    parts = ", ".join(f"{part} % below {np.percentile(found.friction, part):.3f}" for part in (5, 25, 50, 75, 95))
    print(f"the blow of {whole.sum()} hits, tangential over normal impulse: {parts}")
    print(f"  above the friction in use, {FRICTION:g}: {100 * np.mean(found.friction > FRICTION):.0f} %")
    low, middle, high = np.percentile(found.gyrospin, (25, 50, 75)) / RPM
    print(f"  gyrospin, rpm: median {middle:+.0f}, middle half {low:+.0f} to {high:+.0f}")
    print(f"  line of centres above the blow: {-np.median(found.below) / DEGREE:.1f} deg in the middle")
    print("contact in space:")
    places(balls)


if __name__ == "__main__":
    main()

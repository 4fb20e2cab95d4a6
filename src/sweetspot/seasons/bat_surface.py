"""One bat's answers to every swing, tabled once: a ball in play becomes a look-up.

Seen from the bat, hits differ in four numbers only: how fast ball and bat close, how the ball spins about the bat's
axis, where along the bat it is met, and at which angle to its own way the line of centres stands. So the table holds
the velocity after the hit in that frame, and every swing and pitch in the plane across the bat's axis is got from it
exactly, by adding the bat's own velocity. What the ball moves along the bat is kept in part and added.

What the table says is compared with the collision kernel at hits that are no nodes of it, and its axes are halved
until it agrees (`SPEED_ERROR`, `ANGLE_ERROR`); it is kept on disk under the fingerprint of all that it comes from.
"""

from __future__ import annotations

import hashlib
from contextlib import suppress
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np

from sweetspot.collision.hit_in_space import Contact, Strikes, strikes
from sweetspot.dynamics.reduction import ReducedBat, reduced_bat
from sweetspot.equipment.ball import Ball
from sweetspot.equipment.bat import Bat
from sweetspot.errors import InputError
from sweetspot.motion.ball_motion import BallMotions
from sweetspot.motion.swing import SPEED_FROM_TIP
from sweetspot.motion.swing_path import Swings, path_axes
from sweetspot.numerics.arrays import Array
from sweetspot.numerics.kernel_cache import fingerprint, kernel_folder
from sweetspot.numerics.whole_files import written_whole
from sweetspot.seasons.surface_kernel import Axes, fill_ceilings, look_up
from sweetspot.units import INCH, MPH, RPM

AXES = (
    np.linspace(35.0, 75.0, 5),
    np.linspace(-0.2, 0.2, 9),
    np.linspace(0.0, 18.0, 73) * INCH,
    np.radians(np.linspace(-69.0, 69.0, 93)),
)
"""Nodes before any is halved: closing speed (m/s), spin factor, m from the tip, rad of the line of centres. Balls that
jam a batter are met 14 in from the tip and more: there a hit is worth half of the best one."""
RATIOS, SLANTS, SPEEDS = (
    np.linspace(0.0, 2.4, 13),
    np.radians([-15.0, 0.0, 15.0, 30.0]),
    np.array([45.0, 65.0, 85.0]) * MPH,
)
"""Nodes of the ceiling: pitch speed over bat speed, rad between the pitch's way and the bat's, bat speed."""
SPEED_ERROR, ANGLE_ERROR = 0.1 * MPH, np.radians(0.1)
"""Bounds on the error of 95 of 100 hits by the kernel."""
TRIED = 4000
"""Hits that the table is compared with the kernel at."""
MOST_NODES = 1_000_000
"""Beyond which halving stops."""
BAT_SHARE = 0.45
"""Of the closing speed, that the bat has in the hits of the table; only how fast its surface turns depends on it."""
VERSION = 2


@dataclass(frozen=True)
class BatSurface:
    """A bat's answers.

    Parameters
    ----------
    bat : the bat.
    key : fingerprint of everything the table comes from.
    axes : nodes of closing speed (m/s), spin factor, place (m from the tip) and angle (rad); see `AXES`.
    after : velocity after the hit over the closing speed, in the bat's frame: along the ball's own way back, and across
        it upwards; shape (nodes of each axis, 2), NaN beyond the reach of a hit.
    reach : m, radii of ball and bat together at each place.
    arm : bat speed at each place over that where it is measured.
    along : what the ball keeps of its speed along the bat, and what the turning bat adds to it per bat speed.
    ceiling : greatest exit speed over bat speed, shape (speeds, ratios, slants).
    best_place : m from the tip where that is, same shape.
    speed_error, angle_error : what 95 of 100 hits miss the kernel's answers by, m/s and rad.
    """

    bat: Bat
    key: str
    axes: Axes
    after: Array
    reach: Array
    arm: Array
    along: tuple[float, float]
    ceiling: Array
    best_place: Array
    speed_error: float
    angle_error: float

    @property
    def table(self) -> tuple[Axes, Array, Array, Array]:
        """The kernels' table: axes, velocities after the hit, reach and arm."""
        return self.axes, self.after, self.reach, self.arm


def surface_of(bat: Bat, *, ball: Ball) -> BatSurface:
    """Return a bat's table, from the disk where it was made before.

    Raises
    ------
    InputError
        when the bat does not send the ball back on its barrel.
    """
    key = surface_key(bat, ball)
    loaded = _loaded(bat, key)
    if loaded is not None:
        return loaded
    model = reduced_bat(bat, ball=ball)
    made = _measured(_made(bat, model, ball, key, AXES), model, ball)
    while _misfit(made) > 1 and made.after.size < MOST_NODES:
        finer = [_halved(made.axes, axis) for axis in range(len(made.axes))]
        tried = [_measured(_made(bat, model, ball, key, axes), model, ball) for axes in finer]
        better = min(tried, key=_misfit)
        if _misfit(better) >= 0.98 * _misfit(made):
            break
        made = better
    _keep(made)
    return made


def surface_key(bat: Bat, ball: Ball) -> str:
    """Return the fingerprint of everything that a table comes from: bat, ball, the physics' own text, and the axes."""
    digest = hashlib.blake2b(digest_size=16)
    for part in (VERSION, bat.model_dump_json(), ball.model_dump_json(), fingerprint(strikes), fingerprint(_made)):
        digest.update(str(part).encode())
    for nodes in (*AXES, RATIOS, SLANTS, SPEEDS):
        digest.update(nodes.tobytes())
    return digest.hexdigest()


def exit_speeds(
    surface: BatSurface, *, bat_speed: Array, pitch: tuple[Array, Array], tangent: Array, turned: Array, place: Array,
) -> tuple[Array, Array]:  # fmt: skip
    """Return exit speed (m/s) in the plane and offset (m) of hits that leave in given directions, NaN where none does.

    Parameters
    ----------
    bat_speed : m/s where it is measured, shape (n,).
    pitch : m/s of the pitch along the bat's path (negative: it comes) and square to it upwards.
    tangent : m/s, spin of the pitch about the bat's axis, towards the tip, times the ball's radius.
    turned : rad by which the ball leaves the bat's path.
    place : m from the tip.
    """
    given = np.ascontiguousarray(np.broadcast_arrays(bat_speed, *pitch, tangent, turned, place), float)
    fast, above = np.empty((2, given.shape[1]))
    look_up(*surface.table, given, fast, above)
    return fast, above


def _misfit(surface: BatSurface) -> float:
    return float(max(surface.speed_error / SPEED_ERROR, surface.angle_error / ANGLE_ERROR))


def _halved(axes: Axes, axis: int) -> Axes:
    first, second, third, fourth = (
        np.sort(np.concatenate([nodes, (nodes[1:] + nodes[:-1]) / 2])) if number == axis else nodes
        for number, nodes in enumerate(axes)
    )
    return first, second, third, fourth


def _hit(
    model: ReducedBat[Bat], ball: Ball, *, there: Array, pitch: tuple[Array, Array, Array], spin: Array, place: Array,
    offset: Array,
) -> Strikes:  # fmt: skip
    """Return hits of a level bat that moves straight out with the speed ``there`` at the place of contact."""
    return strikes(
        model,
        ball=ball,
        swings=Swings(there, path_axes(0.0, 0.0, tilt=0.0, left=False), model.bat.choke),
        pitches=BallMotions(velocity=np.stack(pitch, axis=-1), spin=np.stack([spin, 0 * spin, 0 * spin], axis=-1)),
        contact=Contact(model.bat.length - place, offset),
    )


def _made(
    bat: Bat, model: ReducedBat[Bat], ball: Ball, key: str, axes: tuple[Array, Array, Array, Array]
) -> BatSurface:
    reach = ball.radius + model.bat.diameter_at(bat.length - axes[2]) / 2
    closing, factor, place, _ = (values.ravel() for values in np.meshgrid(*axes, indexing="ij"))
    offset = np.tile(np.outer(reach, np.sin(axes[3])).ravel(), len(axes[0]) * len(axes[1]))
    there = BAT_SHARE * closing
    coming = (0 * there, there - closing, 0 * there)
    struck = _hit(
        model, ball, there=there, pitch=coming, spin=factor * closing / ball.radius, place=place, offset=offset
    )
    after = np.stack([struck.velocity[:, 1] - there, struck.velocity[:, 2]], axis=-1) / closing[:, None]
    after = after.reshape(*(len(nodes) for nodes in axes), 2)
    if not np.isfinite(after[..., len(axes[3]) // 2, 0]).any():
        raise InputError(f"{bat.name} does not send the ball back on its barrel; check its wall")
    arm = bat.length - bat.choke
    surface = BatSurface(
        bat, key, axes, after, reach, (arm - axes[2]) / (arm - SPEED_FROM_TIP), _along(model, ball),
        np.empty((len(SPEEDS), len(RATIOS), len(SLANTS))), np.empty((len(SPEEDS), len(RATIOS), len(SLANTS))), 0.0, 0.0,
    )  # fmt: skip
    fill_ceilings(surface.axes, after, surface.arm, (SPEEDS, RATIOS, SLANTS), surface.ceiling, surface.best_place)
    return surface


def _along(model: ReducedBat[Bat], ball: Ball) -> tuple[float, float]:
    """Return the part of its speed along the bat that a ball keeps, and its gain of it per bat speed."""
    unit = np.ones(1)

    def leaving(along: float) -> float:
        struck = _hit(model, ball, there=30 * unit, pitch=(along * unit, -38 * unit, -4 * unit), spin=0 * unit,
                      place=SPEED_FROM_TIP * unit, offset=0 * unit)  # fmt: skip
        return float(struck.velocity[0, 0])

    return (leaving(3.0) - leaving(0.0)) / 3.0, leaving(0.0) / 30.0


def _measured(surface: BatSurface, model: ReducedBat[Bat], ball: Ball) -> BatSurface:
    errors = surface_errors(surface, model, ball)
    return replace(surface, speed_error=errors[0], angle_error=errors[1])


def surface_errors(surface: BatSurface, model: ReducedBat[Bat], ball: Ball, *, seed: int = 1) -> tuple[float, float]:
    """Return the 95 % errors of the kernel's exit speed (m/s) and angle (rad) over random hits.

    Hits are as balls in play are: 45 to 85 mph of bat speed, pitches of 0.8 to 1.6 times that from -10 to 35 degrees
    above the bat's path with up to 2500 rpm, met 1 to 16 in from the tip, leaving the bat's path by up to 50 degrees.
    """
    rng = np.random.default_rng(seed)
    speed, ratio = rng.uniform(45 * MPH, 85 * MPH, TRIED), rng.uniform(0.8, 1.6, TRIED)
    slant, spin = np.radians(rng.uniform(-10, 35, TRIED)), RPM * rng.uniform(-2500, 2500, TRIED)
    place = rng.uniform(1 * INCH, 16 * INCH, TRIED)
    offset = rng.uniform(-0.8, 0.8, TRIED) * np.interp(place, surface.axes[2], surface.reach)
    ahead, up = -ratio * speed * np.cos(slant), -ratio * speed * np.sin(slant)
    there = speed * np.interp(place, surface.axes[2], surface.arm)
    struck = _hit(model, ball, there=there, pitch=(0 * speed, ahead, up), spin=spin, place=place, offset=offset)
    turned = np.arctan2(struck.velocity[:, 2], struck.velocity[:, 1])
    left = np.hypot(struck.velocity[:, 1], struck.velocity[:, 2])
    look_up_at = partial(
        exit_speeds, surface, bat_speed=speed, pitch=(ahead, up), tangent=ball.radius * spin, place=place
    )
    fast, above = look_up_at(turned=turned)
    _, further = look_up_at(turned=turned + 0.01)
    with np.errstate(invalid="ignore", divide="ignore"):
        missed = (above - offset) / ((further - above) / 0.01)
    solved = np.isfinite(fast) & np.isfinite(missed) & (np.abs(turned) < np.radians(50))
    return (
        float(np.quantile(np.abs(fast - left)[solved], 0.95)),
        float(np.quantile(np.abs(missed)[solved], 0.95)),
    )


FIELDS = ("after", "reach", "arm", "ceiling", "best_place")


def _file(key: str) -> Path | None:
    folder = kernel_folder()
    return None if folder is None else folder / "bats" / f"{key}.npz"


def _loaded(bat: Bat, key: str) -> BatSurface | None:
    path = _file(key)
    if path is None:
        return None
    try:
        with np.load(path) as arrays:
            axes = (arrays["axis0"], arrays["axis1"], arrays["axis2"], arrays["axis3"])
            numbers = arrays["numbers"].tolist()
            tables = {name: arrays[name] for name in FIELDS}
    except (OSError, ValueError, KeyError, EOFError):
        return None
    return BatSurface(bat=bat, key=key, axes=axes, along=(numbers[0], numbers[1]), speed_error=numbers[2],
                      angle_error=numbers[3], **tables)  # fmt: skip


def _keep(surface: BatSurface) -> None:
    path = _file(surface.key)
    if path is None:
        return
    held: dict[str, Any] = {f"axis{number}": nodes for number, nodes in enumerate(surface.axes)}
    held["numbers"] = np.array([*surface.along, surface.speed_error, surface.angle_error])
    with suppress(OSError), written_whole(path) as file:
        np.savez(file, **held, **{name: getattr(surface, name) for name in FIELDS})

"""The hits of one bat with one ball, computed once over place and closing speed and then looked up.

Along the line of centres a hit is fixed by the place and the closing speed, and so is what the bat's surface gives to
friction. These are tabled; the frame of the hit, friction and spin are computed for every hit, so that the change
from gripping to slipping is exact. Between nodes lies the cubic through the nearest four, in the place and in the
square root of the closing speed, in which hits are smoothest.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from numpy.typing import ArrayLike, NDArray

from sweetspot.collision.hit_in_space import Contact, meetings, strikes
from sweetspot.collision.kernel import hits_with_motion
from sweetspot.collision.oblique_contact import (
    USUAL_FRICTION,
    Friction,
    Launch,
    SurfaceMobility,
    bat_give,
    launch,
)
from sweetspot.dynamics.reduction import ReducedBat, reduced_bat
from sweetspot.equipment.ball import Ball
from sweetspot.equipment.bat import Bat
from sweetspot.motion.ball_motion import BallMotion, BallMotions
from sweetspot.motion.swing_path import Swings, path_axes
from sweetspot.numerics.arrays import Array, IntArray
from sweetspot.units import INCH, RPM

STEP = INCH / 4
"""m between the places that are tabled, from the tip to the knob."""
ROOTS = np.linspace(math.sqrt(2.0), 10.0, 13)
"""Square roots of the closing speeds that are tabled, m/s: 2 to 100; beyond them the nearest counts."""
SPEED_ERROR = 0.015
"""m/s, 0.03 mph: 99 of 100 hits as balls in play are, 1 to 14 in from the tip, miss the kernel by less."""
TRIED = 4000
"""Hits that a table is compared with the kernel at."""
TABLES = 64
"""Bats whose table a process keeps."""


@dataclass(frozen=True, eq=False)
class ContactTable:
    """One bat's hits.

    Parameters
    ----------
    model : the bat reduced to what a collision needs.
    values : collision efficiency and the four mobilities of `SurfaceMobility`, shape (places, closing speeds, 5).
    smooth : whether between four nodes either way, from these on, the ball is touched once: where it is touched again
        hits change in a jump, and are computed by the kernel; shape (places - 3, closing speeds - 3).
    """

    model: ReducedBat[Bat]
    ball: Ball
    values: Array
    smooth: NDArray[np.bool_]

    @property
    def bat(self) -> Bat:
        """The bat."""
        return self.model.bat

    def efficiency(self, from_tip: ArrayLike, closing_speed: ArrayLike) -> Array:
        """Return collision efficiency at places (m from the tip) and closing speeds (m/s), nan where there is none."""
        places, speeds = np.broadcast_arrays(from_tip, closing_speed)
        found = self._look_up(self.bat.length - places.ravel(), speeds.ravel())
        return np.asarray(found[0]).reshape(places.shape)

    def launches(
        self,
        *,
        swings: Swings,
        pitches: BallMotion | BallMotions,
        contact: Contact,
        friction: Friction = USUAL_FRICTION,
    ) -> Launch:
        """Return the motion of many balls after the hit, nan where there is none; takes what `strikes` takes."""
        meets = meetings(self.bat, ball=self.ball, swings=swings, pitches=pitches, contact=contact)
        efficiency, *give = self._look_up(meets.position, meets.closing)
        return launch(
            meets.frame,
            ball=self.ball,
            pitch=meets.pitches,
            surface_velocity=meets.surface_velocity,
            normal_impulse=self.ball.mass * meets.closing * (1 + efficiency),
            give=SurfaceMobility(*give),
            friction=friction,
        )

    def _look_up(self, position: Array, closing: Array) -> Array:
        """Return efficiency and mobilities at n places (m from the knob end) and closing speeds, shape (5, n)."""
        meets = closing > 0
        root = np.sqrt(np.where(meets, closing, ROOTS[0] ** 2))
        row, rows = _cubic((self.bat.length - position) / STEP, len(self.values))
        column, columns = _cubic((root - ROOTS[0]) / (ROOTS[1] - ROOTS[0]), len(ROOTS))
        flat, total = self.values.reshape(-1, self.values.shape[2]), np.zeros((len(root), self.values.shape[2]))
        for i in range(4):
            for j in range(4):
                total += (rows[i] * columns[j])[:, None] * flat[(row + i) * len(ROOTS) + column + j]
        total[~meets] = np.nan
        rough = np.flatnonzero(meets & ~self.smooth[row, column])
        if len(rough):
            total[rough] = _computed(self.model, self.ball, position[rough], closing[rough])[0]
        return total.T


def _cubic(at: Array, count: int) -> tuple[IntArray, tuple[Array, ...]]:
    """Return the first of the nearest four nodes and Lagrange's weights of these; beyond the ends those of the end."""
    at = np.clip(at, 0.0, count - 1.0)
    first = np.clip(at.astype(np.int64) - 1, 0, count - 4)
    a, b, c, d = (at - first - node for node in range(4))
    return first, (-b * c * d / 6, a * c * d / 2, -a * b * d / 2, a * b * c / 6)


def _computed(model: ReducedBat[Bat], ball: Ball, position: Array, closing: Array) -> tuple[Array, NDArray[np.bool_]]:
    """Return efficiency and mobilities of n hits by the kernel, shape (n, 5), and whether the ball is touched once."""
    impacts = hits_with_motion(model.modes, ball=ball, position=position, closing_speed=closing)
    give = bat_give(
        model.modes,
        model.body,
        position=position,
        radius=model.bat.diameter_at(position) / 2,
        velocity=impacts.velocity,
        normal_impulse=ball.mass * closing * (1 + impacts.collision_efficiency),
    )
    return np.stack([impacts.collision_efficiency, *give], axis=-1), impacts.touches == 1


@lru_cache(maxsize=TABLES)
def tabled_bat(bat: Bat, *, ball: Ball) -> ContactTable:
    """Return the table of a bat's hits with a ball.

    >>> from sweetspot import catalog
    >>> table = tabled_bat(catalog.bat("r161-ash"), ball=catalog.ball())
    >>> table.efficiency(6 * INCH, [60.0, 70.0]).round(3)
    array([0.226, 0.215])
    """
    model = reduced_bat(bat, ball=ball)
    from_tip = STEP * np.arange(math.floor(bat.length / STEP) + 1)
    place, closing = (values.ravel() for values in np.meshgrid(bat.length - from_tip, ROOTS**2, indexing="ij"))
    values, once = _computed(model, ball, place, closing)
    shape = len(from_tip), len(ROOTS)
    smooth = np.lib.stride_tricks.sliding_window_view(once.reshape(shape), (4, 4)).all(axis=(2, 3))
    return ContactTable(model, ball, values.reshape(*shape, -1), np.asarray(smooth))


def table_errors(table: ContactTable, *, part: float = 0.95) -> tuple[float, float]:
    """Return by how much a part of the hits that balls in play are miss the kernel, in speed (m/s) and direction (rad).

    Hits are drawn: 1 to 14 in from the tip, off a tee or pitched, above and below the axis, with any spin.
    """
    rng, bat = np.random.default_rng(2), table.bat
    place, down = bat.length - rng.uniform(1, 14, TRIED) * INCH, np.radians(rng.uniform(2, 12, TRIED))
    pitch, along = rng.uniform(0, 45, TRIED), rng.normal(0, 2, TRIED)
    attack, tilt = rng.uniform(-0.3, 0.5, TRIED), rng.uniform(0.55, 0.9, TRIED)
    swings = Swings(rng.uniform(18, 38, TRIED), path_axes(attack, 0.0, tilt=tilt, left=False), bat.choke)
    pitches = BallMotions(
        velocity=np.stack([along, -pitch * np.cos(down), -pitch * np.sin(down)], axis=-1),
        spin=rng.normal(0, 1500 * RPM, (TRIED, 3)),
    )
    contact = Contact(place, rng.uniform(-0.85, 0.85, TRIED) * (table.ball.radius + bat.diameter_at(place) / 2))
    true = strikes(table.model, ball=table.ball, swings=swings, pitches=pitches, contact=contact).velocity
    tabled = table.launches(swings=swings, pitches=pitches, contact=contact).velocity
    fast, read = np.linalg.norm(true, axis=-1), np.linalg.norm(tabled, axis=-1)
    turned = np.linalg.norm(np.cross(true, tabled), axis=-1) / (fast * read)
    return float(np.nanquantile(np.abs(read - fast), part)), float(np.nanquantile(turned, part))

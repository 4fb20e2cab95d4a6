"""The patch through which the ball pushes: how large it is, and what depends on its size.

The ball pushes over a round patch of radius a with the pressure of a Hertz contact, 1 - (r/a)^2 under the root. Short
waves of the surface average out under it, so a surface is stiffer under a larger patch. Hertz has a^2 = R u; a ball
that is pressed harder spreads its push more, so the patch goes with the speed of the hit.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from sweetspot.equipment.ball import Ball, peak_compression
from sweetspot.numerics.arrays import Array
from sweetspot.numerics.piecewise import Piecewise

PATCH_SPEED = 60.0
"""m/s on a rigid wall, about what presses the ball as a hit at game speed does."""
PATCH_COMPRESSION = 0.91
"""Part of the peak compression at which the patch is taken: the mean over a hit weighted with F^2, as the energy in a
spring is; 0.90 for the baseball on a rigid wall, 0.88 to 0.91 between the ends of its law. A patch that grows and
shrinks with the compression, a^2 = R u at every moment, gives the same q as one fixed
there within 0.003 on single walls and composites, and 0.0065 on the double wall, which is so soft that the ball is
pressed less than on a rigid wall (tests/dynamics/test_patch.py)."""
PATCH_SPREAD = (0.83, 1.25)
"""Between which the patch's radius lies over that of Hertz on a flat surface: an ellipse of Hertz on a round barrel of
33 mm has the mean radius (1 / (1 + R / 33 mm))^(1/4), 0.83, of that; the ball's own cap cut off flat,
sqrt(2 R u - u^2), has 1.21 to 1.25 of it in tests at 136 mph and above. Limits of what shape a ball can take, no
standard deviation."""
RECOIL = 0.235
"""m / M_eff of a bat's barrel where it hits best: a bat at rest presses the ball as a rigid wall does at the closing
speed over sqrt(1 + RECOIL) [russell_impulse, as in the ball's peak force]."""
RATIOS = np.sqrt(np.linspace(0.4**2, 1.25**2, 4))
"""Radii of the tables over that at `PATCH_SPEED`, even in their squares: hits of 7 to 120 m/s with a baseball."""
OTHERS = np.array([[other for other in range(len(RATIOS)) if other != row] for row in range(len(RATIOS))])
"""For each of the tables the others, as Lagrange's weights multiply them."""


def contact_patch(ball: Ball, closing_speed: float | None = None) -> float:
    """Return the radius in m of the round patch through which the ball pushes, a = sqrt(R u) (Hertz).

    Parameters
    ----------
    closing_speed : m/s of a hit on a bat at rest, > 0; u is `PATCH_COMPRESSION` of the peak compression on a rigid wall
        that presses the ball as hard. None: on such a wall at `PATCH_SPEED`.
    """
    speed = PATCH_SPEED if closing_speed is None else closing_speed / math.sqrt(1 + RECOIL)
    return float(np.sqrt(ball.radius * PATCH_COMPRESSION * peak_compression(ball, speed)))


@dataclass(frozen=True)
class PatchLaw:
    """The radius of the patch by closing speed, a = reference (v / reference_speed)^power, between two limits.

    Parameters
    ----------
    reference : m at ``reference_speed``, the closing speed in m/s of a hit on a bat at rest.
    power : 1 / (n + 1) for a ball of force k u^n; of one with a damper the patch is up to 4 % larger than that at 10
        m/s, as a damper takes less of a slow blow.
    """

    reference: float
    reference_speed: float
    power: float

    @cached_property
    def radii(self) -> Array:
        """Radii in m for which tables are made, increasing."""
        return self.reference * RATIOS

    def radius_at(self, closing_speed: Array | float) -> Array:
        """Return the radius in m, as far as tables reach; the least for a speed that is none."""
        speed = np.fmax(closing_speed, 0.0)
        radius = self.reference * (speed / self.reference_speed) ** self.power
        return np.asarray(np.minimum(np.maximum(radius, self.radii[0]), self.radii[-1]))

    def weights_at(self, closing_speed: Array | float | None) -> Array:
        """Return Lagrange's weights of tables of ``radii``, in the square of the radius, shape (..., radii).

        Parameters
        ----------
        closing_speed : m/s, shape (...); None: that of ``reference``.
        """
        return self._nominal if closing_speed is None else self.weights_of(self.radius_at(closing_speed))

    def weights_of(self, radius: Array) -> Array:
        """Return Lagrange's weights for radii in m of shape (...), shape (..., radii)."""
        apart = radius[..., None] ** 2 - self._squares
        return np.asarray(apart[..., OTHERS].prod(axis=-1) / self._between)

    @cached_property
    def _nominal(self) -> Array:
        """The weights for ``reference``."""
        return self.weights_of(np.asarray(self.reference))

    @cached_property
    def _squares(self) -> Array:
        return self.radii**2

    @cached_property
    def _between(self) -> Array:
        """Denominators of Lagrange's weights."""
        return np.asarray((self._squares[:, None] - self._squares[OTHERS]).prod(axis=-1))


def patch_law(ball: Ball, *, factor: float = 1.0) -> PatchLaw:
    """Return the dependence of a ball's patch on the closing speed.

    Parameters
    ----------
    factor : on its radius, > 0; 1 is Hertz on a flat surface.
    """
    return PatchLaw(factor * contact_patch(ball), PATCH_SPEED * math.sqrt(1 + RECOIL), 1 / (ball.exponent + 1))


@dataclass(frozen=True)
class ByPatch:
    """Functions of position along a bat that depend on the patch.

    Parameters
    ----------
    law : which radii ``tables`` has, and which a hit has.
    tables : polynomials in position, m, with values of shape (radii, ...).
    """

    law: PatchLaw
    tables: Piecewise

    def __call__(self, position: Array, closing_speed: Array | float | None = None) -> Array:
        """Return values of shape (n, ...) at positions of shape (n,).

        Parameters
        ----------
        closing_speed : m/s, shape (n,) or one for all; None: that of `PATCH_SPEED`.
        """
        return self.weighted(position, self.law.weights_at(closing_speed))

    def beyond_nominal(self, position: Array, closing_speed: Array | float) -> Array:
        """Return by how much the values differ from those at `PATCH_SPEED`; see `__call__`."""
        return self.weighted(position, self.law.weights_at(closing_speed) - self.law.weights_at(None))

    def weighted(self, position: Array, weights: Array) -> Array:
        """Return the tables' sum with weights of shape (n, radii), or (radii,) for all places.

        Rows of positions that are all alike are looked up once.
        """
        if np.ndim(position) == 2 and len(position) > 1 and (position == position[0]).all():
            row = np.asarray(self.tables(position[0]))
            by_place = weights.swapaxes(0, 1) if weights.ndim == 3 else weights[None, None, :]
            sums = np.matmul(by_place, row.reshape((*row.shape[:2], -1))).swapaxes(0, 1)
            return np.broadcast_to(sums, (*position.shape, sums.shape[-1])).reshape((*position.shape, *row.shape[2:]))
        values = np.asarray(self.tables(position))
        places = np.shape(position)
        by_radius = values.reshape((*places, len(RATIOS), -1))
        sums = np.asarray(np.einsum("...k,...km->...m", weights, by_radius))
        return sums.reshape((*places, *values.shape[len(places) + 1 :]))

    def nominal(self) -> Piecewise:
        """Return the polynomials at `PATCH_SPEED`."""
        weights = self.law.weights_at(None)
        return Piecewise(np.tensordot(self.tables.coefficients, weights, axes=(2, 0)), self.tables.ends)


def transform(phase: Array) -> Array:
    """Return 3 (sin s - s cos s) / s^3, the transform of a Hertz pressure: the mean of cos(k y) under it at s = k a.

    1 for long waves, near 0 for waves shorter than the patch: short waves do not feel the push.

    >>> bool(transform(np.array(0.0)) == 1)
    True
    """
    safe = np.maximum(phase, 1e-2)
    exact = 3 * (np.sin(safe) - safe * np.cos(safe)) / (safe * safe * safe)
    return np.asarray(np.where(phase < 1e-2, 1 - phase**2 / 10, exact))

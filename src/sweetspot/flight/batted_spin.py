"""The spin that batted baseballs usually leave with, for when it was not measured."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import ArrayLike

from sweetspot.errors import InputError
from sweetspot.numerics.arrays import Array
from sweetspot.units import DEGREE, RPM


@dataclass(frozen=True)
class SpinLine:
    """The spin that hits have on average, a line through what single balls scatter about widely.

    ``backspin``: rpm, rpm per degree of launch angle, rpm per degree of spray to the opposite side. ``sidespin``: rpm
    at `MIDDLE_ANGLE`, rpm per degree of spray, rpm per degree of launch angle above that.
    """

    backspin: tuple[float, float, float]
    sidespin: tuple[float, float, float] = (-849.0, -94.0, 0.0)


SHEET = SpinLine(backspin=(-763.0, 120.0, 21.0))
"""That of the trajectory calculator, with which its law of drag and lift was drawn up [nathan_calculator]."""
TRACKED = SpinLine(backspin=(-1070.0, 129.0, 21.0), sidespin=(-980.0, -96.0, -24.0))
"""Fitted with drag and lift to flights and to measured spin at once (`studies.air_law`): backspin 2413 +- 60 at 27 deg,
129 +- 6 per degree, 21 +- 3 with spray; sidespin -980 +- 100, -96 +- 6 with spray, -24 +- 17 with launch angle
[trackman_college2025, savant_2022rays]. Rates and axes of the college hits alone say 2517 +- 88, 109 +- 7, 15 +- 3;
-923 +- 116, -87 +- 5, -11 +- 11. It is the spin that flies a ball as far as balls hit so fly on average: liners lose
more by a lack of spin than they win by as much more, so below 20 deg it is some 250 rpm less than their mean spin."""
NO_SPIN = SpinLine(backspin=(0.0, 0.0, 0.0), sidespin=(0.0, 0.0, 0.0))
"""Of balls whose usual spin was never measured, as softballs'."""

MIDDLE_ANGLE = 27.0
"""deg, about the mean of the balls from which the published sidespin comes."""
SLICED_ANGLES = (15.0, 45.0)
"""deg, launch angles between which the sidespin was seen to change; beyond it is that of the nearest."""
USUAL_ANGLES = (-15.0, 50.0)
"""deg; the line comes from balls that fly [nathan_calculator], and gives topspin to those hit down. Beyond, pop-ups and
choppers spin as it happens: the line would give 6,700 rpm at 60 deg."""


SCATTER_ANGLES, BACKSPIN_SCATTERS = (22.0, 26.0), (750.0, 500.0)
"""Standard deviations of backspin about the usual line, rpm: of liners, below the first launch angle in deg, and of
flies, above the second. Rates and axes of the college hits scatter so (850 to 1,040 rpm and 510, robustly), hang times
of tracked balls ask 690 at 15 to 18 deg and 820 at 18 to 22 [trackman_college2025]."""
USUAL_SPRAYS = (-60.0, 60.0)
"""deg from centre field; it comes from balls that were fair or nearly so, and at 90 deg would give 10,600 rpm."""


def check_usual_spin(launch_angle: float, spray: float = 0.0, *, given: bool) -> None:
    """Refuse to guess the spin of a ball launched as the usual spin was never measured; not where it is ``given``."""
    for what, angle, (low, high) in (("launch angle", launch_angle, USUAL_ANGLES), ("spray", spray, USUAL_SPRAYS)):
        if not given and not low - 1e-9 <= angle / DEGREE <= high + 1e-9:
            raise InputError(
                f"the {what} is {angle / DEGREE:.4g} deg, and what spin hits usually have is known for {low:g} to "
                f"{high:g} deg only; give the spin: --backspin and --sidespin, in Python backspin and sidespin"
            )


def batted_ball_spin(
    launch_angle: ArrayLike,
    spray: ArrayLike,
    *,
    bats: Literal["right", "left"] | ArrayLike = "right",
    line: SpinLine = TRACKED,
) -> tuple[Array, Array]:
    """Return (backspin, sidespin) in rad/s that baseballs hit in a direction have on average.

    backspin = -1070 + 129 theta + 21 s phi, sidespin = -(980 + 24 (theta - 27)) s - 96 phi, in rpm and degrees,
    s = 1 for a right-handed batter and -1 for a left-handed one, theta in the sidespin between 15 and 45: `TRACKED`.
    The trajectory calculator has -763 + 120 theta + 21 s phi and -849 s - 94 phi [nathan_calculator]. Balls to the
    opposite field are sliced; with the barrel hanging below the hands even a ball to centre bends to the opposite
    side, the more the higher it is hit.

    Parameters
    ----------
    launch_angle : theta, rad.
    spray : phi, rad from centre field, positive to right field.
    bats : "right" or "left"; or an array of these words.
    line : another line, such as `SHEET`.

    >>> back, side = batted_ball_spin(28 * DEGREE, 0.0)
    >>> round(float(back / RPM)), round(float(side / RPM))
    (2542, -1004)
    """
    elevation, direction = np.asarray(launch_angle, float) / DEGREE, np.asarray(spray, float) / DEGREE
    side = np.where(np.asarray(bats) == "left", -1.0, 1.0)
    back = line.backspin[0] + line.backspin[1] * elevation + line.backspin[2] * side * direction
    always, with_spray, with_angle = line.sidespin
    higher = np.clip(elevation, *SLICED_ANGLES) - MIDDLE_ANGLE
    return np.asarray(RPM * back), np.asarray(RPM * ((always + with_angle * higher) * side + with_spray * direction))


def backspin_scatter(launch_angle: ArrayLike) -> Array:
    """Return the standard deviation of backspin about the usual line, rad/s: liners scatter more than flies.

    ``launch_angle``: rad.

    >>> (backspin_scatter(np.radians([10, 24, 30])) / RPM).round(6)
    array([750., 625., 500.])
    """
    return np.asarray(RPM * np.interp(np.asarray(launch_angle, float) / DEGREE, SCATTER_ANGLES, BACKSPIN_SCATTERS))

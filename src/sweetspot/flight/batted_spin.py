"""The spin that batted baseballs usually leave with, for when it was not measured."""

from __future__ import annotations

from typing import Literal

import numpy as np
from numpy.typing import ArrayLike

from sweetspot.errors import InputError
from sweetspot.numerics.arrays import Array
from sweetspot.units import DEGREE, RPM

BACKSPIN = (-763.0, 120.0, 21.0)
"""rpm, rpm per degree of launch angle, rpm per degree of spray to the opposite side [nathan_calculator]."""
SIDESPIN = (-849.0, -94.0)
"""rpm, rpm per degree of spray [nathan_calculator]."""


USUAL_ANGLES = (-15.0, 50.0)
"""deg; the line comes from balls that fly [nathan_calculator], and gives topspin to those hit down. Beyond, pop-ups and
choppers spin as it happens: the line would give 6,400 rpm at 60 deg."""


def check_usual_spin(launch_angle: float, *, known: bool) -> None:
    """Refuse to guess the spin of a ball launched as the usual spin was never measured; ``known``: it need not be."""
    low, high = USUAL_ANGLES
    if not known and not low - 1e-9 <= launch_angle / DEGREE <= high + 1e-9:
        raise InputError(
            f"launch_angle is {launch_angle / DEGREE:.4g} deg, and what spin hits usually have is known for {low:g} to "
            f"{high:g} deg only; give backspin and sidespin"
        )


def batted_ball_spin(
    launch_angle: ArrayLike, spray: ArrayLike, *, bats: Literal["right", "left"] | ArrayLike = "right"
) -> tuple[Array, Array]:  # fmt: skip
    """Return (backspin, sidespin) in rad/s that baseballs hit in a direction have on average.

    backspin = -763 + 120 theta + 21 s phi, sidespin = -849 s - 94 phi, in rpm and degrees, s = 1 for a right-handed
    batter and -1 for a left-handed one [nathan_calculator]: a line through what single balls scatter about widely.
    Balls to the opposite field are cut under and sliced; with the barrel hanging below the hands even a ball to centre
    bends to the opposite side.

    Parameters
    ----------
    launch_angle : theta, rad.
    spray : phi, rad from centre field, positive to right field.
    bats : "right" or "left"; or an array of these words.

    >>> back, side = batted_ball_spin(28 * DEGREE, 0.0)
    >>> round(float(back / RPM)), round(float(side / RPM))
    (2597, -849)
    """
    elevation, direction = np.asarray(launch_angle, float) / DEGREE, np.asarray(spray, float) / DEGREE
    side = np.where(np.asarray(bats) == "left", -1.0, 1.0)
    back = BACKSPIN[0] + BACKSPIN[1] * elevation + BACKSPIN[2] * side * direction
    return np.asarray(RPM * back), np.asarray(RPM * (SIDESPIN[0] * side + SIDESPIN[1] * direction))

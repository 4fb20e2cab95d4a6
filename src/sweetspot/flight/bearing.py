"""Where a ball came down is not where it was hit to: side spin and wind bend its path on the way.

Tracked directions (Statcast's ``hc_x`` and ``hc_y``) are bearings of the place where a ball came down or was picked up.
Read as launch directions they put a third of real home runs foul in a model, and the distance is off by up to 25 ft
across the field; the launch direction has to be solved for.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Literal

import numpy as np
from numpy.typing import ArrayLike

from sweetspot.flight.batted_spin import TRACKED, SpinLine, batted_ball_spin
from sweetspot.flight.conditions import FlightConditions
from sweetspot.flight.kernel import Flights, flights
from sweetspot.motion.ball_motion import USUAL_CONTACT, BallMotions, spin_axes
from sweetspot.numerics.arrays import Array

ROUNDS = 30
"""Most corrections of the launch direction; three or four are enough for balls that are hit."""
CLOSE = 1e-6
"""rad by which the bearing may miss: less than 0.2 mm at 150 m."""
LARGEST_CORRECTION = 0.5
"""rad a round."""
HOME_X, HOME_Y = 125.42, 198.27
"""Statcast's map coordinates of home plate [poulsen_hr_rdd]."""


def bearing_of_place(hc_x: ArrayLike, hc_y: ArrayLike) -> Array:
    """Return the bearing in rad of a place on Statcast's map, from centre field, positive to right field.

    The map's y grows towards the plate [poulsen_hr_rdd]. A bearing is no launch direction: see `launched_to`.

    >>> float(np.degrees(bearing_of_place(125.42 + 50, 198.27 - 50)).round(9))
    45.0
    """
    right = np.asarray(hc_x, float) - HOME_X
    return np.asarray(np.arctan2(right, HOME_Y - np.asarray(hc_y, float)))


def launched_to(
    bearing: ArrayLike,
    *,
    exit_speed: ArrayLike,
    launch_angle: ArrayLike,
    conditions: FlightConditions,
    bats: Literal["right", "left"] | ArrayLike = "right",
    spins: SpinLine | tuple[ArrayLike | None, ArrayLike | None] = TRACKED,
    position: ArrayLike = USUAL_CONTACT,
) -> tuple[Array, Flights]:
    """Return the launch directions of balls that come down in given directions, and their flights.

    The direction is moved by what the landing misses, with the slope learnt on the way (secants), to `CLOSE`.

    Parameters
    ----------
    bearing : rad, shape (n,) or a number, direction from the plate's tip of where the ball comes down.
    exit_speed, launch_angle : m/s and rad, of shapes that fit.
    bats : "right" or "left", or an array of these words; only the usual spin asks.
    conditions : as for `flights`.
    spins : back and side spin, rad/s, None: what balls launched so usually have, see `batted_ball_spin`; or the line of
        usual spin, such as `SHEET` with the trajectory calculator's law.
    position : m, shape (3,), where the ball leaves the bat.

    Returns
    -------
    tuple
        launch direction in rad, shape (n,), NaN where no direction was found, and `Flights` of the same rows.
    """
    wanted, speed, up, words = np.broadcast_arrays(
        *(np.atleast_1d(np.asarray(values)) for values in (bearing, exit_speed, launch_angle, bats))
    )
    line, given_spins = (spins, (None, None)) if isinstance(spins, SpinLine) else (TRACKED, spins)
    given = [None if spin is None else np.broadcast_to(np.asarray(spin, float), wanted.shape) for spin in given_spins]

    def flown(spray: Array) -> tuple[Array, Flights]:
        usual = batted_ball_spin(up, spray, bats=words, line=line)
        back, side = (default if chosen is None else chosen for default, chosen in zip(usual, given, strict=True))
        axes = spin_axes(up, spray)
        result = flights(
            BallMotions(
                velocity=speed[:, None] * axes[2],
                spin=back[:, None] * axes[0] + side[:, None] * axes[1],
                position=position,
            ),
            conditions,
        )
        miss = result.bearing - wanted
        return np.arctan2(np.sin(miss), np.cos(miss)), result

    return _where_nothing_is_missed(flown, np.array(wanted, float))


def _where_nothing_is_missed(flown: Callable[[Array], tuple[Array, Flights]], spray: Array) -> tuple[Array, Flights]:
    """Return the directions, from some to begin with, that miss by no more than `CLOSE`, else NaN; and their flights.

    ``flown``: of launch directions in rad, shape (n,), by how much the landings miss, rad, and the flights.
    """
    miss, result = flown(spray)
    slope = np.ones_like(spray)
    for _ in range(ROUNDS):
        if not (np.abs(miss) > CLOSE).any():
            break
        step = np.clip(np.nan_to_num(-miss / slope), -LARGEST_CORRECTION, LARGEST_CORRECTION)
        before = miss
        spray = spray + step
        miss, result = flown(spray)
        learnt = np.divide(miss - before, step, out=slope.copy(), where=np.abs(step) > CLOSE)
        slope = np.where(np.isfinite(learnt) & (learnt > 0.2) & (learnt < 5), learnt, 1.0)
    return np.where(np.abs(miss) <= CLOSE, spray, np.nan), result

"""Where the search for a ball's launch direction begins: how far balls bend on their way, from one table."""

from __future__ import annotations

from functools import lru_cache

import numpy as np

from sweetspot.equipment.ball import Ball
from sweetspot.flight.aerodynamics import Aerodynamics
from sweetspot.flight.air import Air
from sweetspot.flight.carry_scatter import ANGLES, SPEEDS, usual_launch
from sweetspot.flight.conditions import FlightConditions
from sweetspot.flight.kernel import flights
from sweetspot.numerics.arrays import Array
from sweetspot.season.balls import Balls
from sweetspot.units import DEGREE

SPRAYS: Array = np.arange(-110.0, 111.0, 5.0) * DEGREE
BEARINGS: Array = np.arange(-90.0, 91.0, 5.0) * DEGREE


def first_directions(
    balls: Balls, bearing: Array, *, ball: Ball, aerodynamics: Aerodynamics, air: Air, density: Array
) -> Array:  # fmt: skip
    """Return about which way balls set out that come down in some direction, rad; bends go with the air's density.

    Parameters
    ----------
    bearing : where they come down, rad from centre field, shape (n,); 0 where it is not known.
    ball, aerodynamics, air : of the table.
    density : of the air that each ball flies through, kg/m^3, shape (n,).
    """
    from scipy.interpolate import RegularGridInterpolator

    side = np.where(balls.left, -1.0, 1.0)  # a left-handed batter's ball is a right-handed one's in a mirror
    asked = (balls.exit_speed, balls.launch_angle, side * bearing)
    places = np.stack([np.clip(np.nan_to_num(values), nodes[0], nodes[-1])
                       for values, nodes in zip(asked, (SPEEDS, ANGLES, BEARINGS), strict=True)], axis=1)  # fmt: skip
    bends = RegularGridInterpolator((SPEEDS, ANGLES, BEARINGS), _bends(ball, aerodynamics, air))(places)
    return np.asarray(bearing + side * bends * density / air.density)


@lru_cache(maxsize=8)
def _bends(ball: Ball, aerodynamics: Aerodynamics, air: Air) -> Array:
    """Return launch direction less bearing of right-handed batters' balls, shape (speeds, angles, bearings)."""
    speed, angle, spray = (grid.ravel() for grid in np.meshgrid(SPEEDS, ANGLES, SPRAYS, indexing="ij"))
    launch = usual_launch(speed, angle, spray, left=np.zeros(len(speed), bool))
    flown = flights(launch, FlightConditions(ball=ball, aerodynamics=aerodynamics, air=air))
    landed = np.unwrap(np.nan_to_num(flown.bearing).reshape(-1, len(SPRAYS)), axis=1)
    found = np.array([np.interp(BEARINGS, line, SPRAYS - line) for line in landed])
    return found.reshape(len(SPEEDS), len(ANGLES), len(BEARINGS))

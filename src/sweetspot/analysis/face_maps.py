"""Hits all over a face: what every place on a racket, blade or club does, along it and across it."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from sweetspot.analysis.position_scan import sting
from sweetspot.collision.closed_form import exit_speed
from sweetspot.collision.kernel import hits_with_motion
from sweetspot.dynamics.hands import held_modes
from sweetspot.dynamics.reduction import ReducedBat
from sweetspot.equipment.face import FaceOutline
from sweetspot.equipment.implement import Implement
from sweetspot.errors import InputError
from sweetspot.motion.swing import Conditions
from sweetspot.numerics.arrays import Array

COLUMNS, ROWS = 40, 30
"""Places along the face and across it."""


@dataclass(frozen=True)
class FaceMap:
    """Hits on a grid over a face under the same swing; nan off the face.

    Parameters
    ----------
    position, lateral : m from the butt end and m across from the line, shapes (columns,) and (rows,), increasing.
    collision_efficiency : q, shape (rows, columns).
    exit_speed : m/s at the struck place, shape (rows, columns).
    sting : m/s, vibration at the hands, shape (rows, columns).
    """

    outline: FaceOutline
    position: Array
    lateral: Array
    collision_efficiency: Array
    exit_speed: Array
    sting: Array

    def best(self) -> tuple[float, float]:
        """Return position and lateral place in m of the grid's greatest exit speed."""
        row, column = np.unravel_index(int(np.nanargmax(self.exit_speed)), self.exit_speed.shape)
        return float(self.position[column]), float(self.lateral[row])


def face_map(
    reduced: ReducedBat[Implement], conditions: Conditions, *, columns: int = COLUMNS, rows: int = ROWS
) -> FaceMap:
    """Return hits on a grid over the face of a racket, blade or club.

    The implement turns about one axis across the line, so that its speed does not depend on the lateral place. Exit
    speed is the ball's along the path of the struck place; hits beside the line also turn the face, which sends the
    ball off at an angle: that is left out.

    ``columns``, ``rows``: places along and across, in the middle of equal strips of the outline, >= 2.
    """
    outline = reduced.bat.outline
    if outline is None or reduced.bat.face is None:
        raise InputError(
            f"{reduced.bat.name} is round and has no face to map; give a racket, a cricket bat, a club or a stick"
        )
    if min(columns, rows) < 2:
        raise InputError(f"a map of {columns} by {rows} places was asked for; allowed is 2 by 2 or more")
    position = outline.start + (outline.end - outline.start) * (np.arange(columns) + 0.5) / columns
    lateral = outline.width * ((np.arange(rows) + 0.5) / rows - 0.5)
    places, across = np.meshgrid(position, lateral)
    inside = outline.holds(places, across)
    swing, ball = conditions.swing, conditions.ball
    bat_speed = swing.angular_speed * (places[inside] - swing.pivot)
    modes = held_modes(reduced.modes, conditions.hands)
    closing = conditions.pitch.speed + bat_speed
    outcome = hits_with_motion(modes, ball=ball, position=places[inside], lateral=across[inside], closing_speed=closing)
    efficiency = outcome.collision_efficiency
    speed = exit_speed(efficiency, ball_speed=conditions.pitch.speed, bat_speed=bat_speed)
    felt = sting(modes, hands=conditions.hands, displacement=outcome.displacement, velocity=outcome.velocity)
    return FaceMap(outline, position, lateral, *(_on_grid(values, inside) for values in (efficiency, speed, felt)))


def _on_grid(values: Array, inside: NDArray[np.bool_]) -> Array:
    grid = np.full(inside.shape, np.nan)
    grid[inside] = values
    return grid

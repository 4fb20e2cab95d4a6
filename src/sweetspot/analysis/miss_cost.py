"""What a miss costs, and how sure that is: by our law of the ball, and by one that loses its energy in another way.

Two balls that bounce alike from a wall need not do so from a bat that bends away beneath them. `Hysteretic` loses by
how far the ball is pressed, `HuntCrossley` by how fast. What is known speaks for the first (see the page of the ball),
but no measurement along a bat has settled it, so the second stands for what could be different.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from sweetspot.analysis.bat_analysis import Analysis, exit_speed_of, hit_at
from sweetspot.analysis.sweet_spot import miss_cost
from sweetspot.collision.contact_law import HuntCrossley
from sweetspot.dynamics.rigid import effective_mass
from sweetspot.equipment.implement import Implement
from sweetspot.numerics.arrays import Array
from sweetspot.numerics.parabola import top

SPACING = 0.01
"""m between the places that are tried with the other law."""
BEYOND = 0.06
"""m by which the other law's best place may lie elsewhere."""


class Loss(NamedTuple):
    """Exit speed lost, m/s: by our law, and the ends of the interval that both laws span; nan where nothing is hit."""

    value: float
    low: float
    high: float


class ViscousScan(NamedTuple):
    """Hits with `HuntCrossley` around the best place: m from the knob end and m/s, shape (places,)."""

    position: Array
    exit_speed: Array


def miss_costs(analysis: Analysis[Implement], distances: tuple[float, ...]) -> list[tuple[Loss, Loss]]:
    """Return for each distance (m) what hitting so much nearer the hands and nearer the tip than the best place costs.

    Each law's cost counts from its own best place.
    """
    other = viscous_scan(analysis, reach=max(distances))
    index, shift, best = top(other.exit_speed)
    place = float(other.position[index] + shift * (other.position[1] - other.position[0]))
    costs = []
    for distance in distances:
        ours = miss_cost(analysis.scan, distance)
        theirs = [best - float(np.interp(place + way * distance, *other, left=np.nan, right=np.nan)) for way in (-1, 1)]
        inside, outside = (Loss(one, *_span(one, two)) for one, two in zip(ours, theirs, strict=True))
        costs.append((inside, outside))
    return costs


def _span(one: float, two: float) -> tuple[float, float]:
    """Return the lower and the higher of two costs; where the second law's place is off the bat, the first alone."""
    return (one, one) if np.isnan(two) else (min(one, two), max(one, two))


def viscous_scan(analysis: Analysis[Implement], *, reach: float) -> ViscousScan:
    """Return hits under the same conditions with a ball that loses by speed, as lively on a wall as ours.

    Its damper is chosen for the speed on a wall at which as much energy would be stored, v / sqrt(1 + r).

    Parameters
    ----------
    reach : m to either side of our best place, beyond which another `BEYOND` is tried.
    """
    best, given = analysis.sweet_spots.max_exit_speed, analysis.conditions
    low = max(float(analysis.scan.position[0]), best - reach - BEYOND)
    high = min(float(analysis.scan.position[-1]), best + reach + BEYOND)
    places = np.linspace(low, high, max(4, round((high - low) / SPACING) + 1))
    speeds = []
    for place in places:
        recoil = given.ball.mass / effective_mass(analysis.body, float(place))
        closing = given.pitch.speed + given.swing.speed_at(float(place))
        law = HuntCrossley.for_speed(given.ball, closing / (1 + recoil) ** 0.5)
        speeds.append(exit_speed_of(hit_at(float(place), modes=analysis.modes, conditions=given, law=law), given))
    return ViscousScan(places, np.array(speeds))

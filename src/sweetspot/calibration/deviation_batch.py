"""Weight, balance and moment of inertia of many bats that deviate from one description, worked out side by side.

Differences of what scale, balance and pendulum say need a dozen such bats at a time; see `posterior`.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache

import numpy as np

from sweetspot.calibration.unknowns import Unknown, barrel_parts
from sweetspot.dynamics.beam import BeamModel, density_scale
from sweetspot.dynamics.rigid import RigidBody
from sweetspot.equipment.bat import Bat
from sweetspot.numerics.arrays import Array
from sweetspot.numerics.gauss_legendre import quadrature


def deviated_bodies(beam: BeamModel, unknowns: Sequence[Unknown], deviations: Array) -> list[RigidBody] | None:
    """Return the rigid bodies of bats with these deviations from a bat's beam, shape (bats, n).

    They are those of `deviated`, to rounding. None: the bat is hollow, or no bat with an outline of stations.
    """
    bat = beam.bat
    if not isinstance(bat, Bat) or bat.shell is not None or bat.profile is None:
        return None
    by = {one.name: deviations[:, index] for index, one in enumerate(unknowns)}
    nothing = np.zeros(len(deviations))
    edges = bat.breakpoints()
    places, weights = quadrature(edges)
    widths = np.array([diameter for _, diameter in bat.profile])
    if "handle" in by:
        part = barrel_parts(bat.profile, bat.length)
        widths = widths * np.exp(np.outer(by["handle"], 1 - part) + np.outer(by["barrel"], part))
    outer = np.atleast_2d(widths) @ _between(tuple(place for place, _ in bat.profile), edges) / 2
    drawn = density_scale(beam, places) / beam.density_factor
    more = by.get("density_gradient", nothing)[:, None] * (2 * places / bat.length - 1)
    scale = beam.density_factor * np.exp(by.get("density", nothing))[:, None] * (drawn + more)
    at = bat.section_within(places, outer, scale)
    first, second = at.mass * places, at.mass * places**2 + at.rotary_inertia
    parts = at.mass, first, second, at.roll_inertia
    mass, balance, turning, roll = (np.sum(weights * values, axis=1) for values in parts)
    balance, turning = balance + beam.unplaced[0], turning + beam.unplaced[1]
    own, knob = len(bat.lumps()), np.exp(by.get("knob_mass", nothing))
    for index, lump in enumerate(beam.point_masses):
        heavy = lump.mass * knob if index < own and lump.position == 0 else lump.mass + nothing
        mass, balance, turning = mass + heavy, balance + heavy * lump.position, turning + heavy * lump.position**2
        turning, roll = turning + lump.moi, roll + lump.roll_moi
    rows = zip(mass.tolist(), balance.tolist(), turning.tolist(), roll.tolist(), strict=True)
    return [RigidBody(one, first / one, second - first**2 / one, axial) for one, first, second, axial in rows]


@lru_cache(maxsize=16)
def _between(stations: tuple[float, ...], edges: tuple[float, ...]) -> Array:
    """Return how much of every station's value each place of the integration has, shape (stations, places)."""
    places, _ = quadrature(edges)
    return np.array([np.interp(places, stations, unit) for unit in np.eye(len(stations))])

"""Where a bat hits best: every meaning of "sweet spot", each its own function, and the zone.

All positions are metres from the knob end. They differ because they answer different questions; the docs' page on
the sweet spot says which is which.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from sweetspot.analysis.position_scan import Scan
from sweetspot.dynamics.modes import Modes
from sweetspot.dynamics.rigid import RigidBody, centre_of_percussion
from sweetspot.errors import InputError
from sweetspot.motion.swing import Conditions
from sweetspot.numerics.arrays import Array
from sweetspot.numerics.interpolants import top
from sweetspot.units import INCH, MPH

ZONE_LOSS = 3 * MPH
"""m/s of exit speed that the sweet zone may lose against the best point."""
NARROWEST = 0.5 * INCH
"""m; what a place must hold over to count as a place to hit: a batter meets the ball no better than that."""
ZONE_STING = 0.5
"""Part of the mean vibration at the hands that the sweet zone must stay below."""


@dataclass(frozen=True)
class SweetSpots:
    """All of them, m from the knob end; ``zone`` is (start, end), or None where no place meets both conditions."""

    center_of_percussion: float
    node_1: float
    node_2: float
    max_collision_efficiency: float
    max_exit_speed: float
    min_sting: float
    zone: tuple[float, float] | None


def sweet_spots(scan: Scan, *, body: RigidBody, modes: Modes, conditions: Conditions) -> SweetSpots:
    """Return every definition's answer for one bat and swing."""
    return SweetSpots(
        center_of_percussion=centre_of_percussion(body, pivot=conditions.hands.position),
        node_1=barrel_node(modes, harmonic=1),
        node_2=barrel_node(modes, harmonic=2),
        max_collision_efficiency=max_collision_efficiency(scan, body=body),
        max_exit_speed=max_exit_speed(scan),
        min_sting=min_sting(scan, body=body),
        zone=sweet_zone(scan),
    )


def barrel_node(modes: Modes, *, harmonic: int) -> float:
    """Return the node of a bending mode nearest to the tip: a ball there does not excite that mode."""
    for index in modes.of_family("bending"):
        if modes.harmonics[index] == harmonic:
            return float(modes.nodes(index)[-1])
    raise InputError(f"bending mode {harmonic} was not computed; ask for more modes")


def max_collision_efficiency(scan: Scan, *, body: RigidBody) -> float:
    """Return the place of greatest collision efficiency: the best place on a bat at rest.

    Only places beyond the balance point count: a slender handle swings back against the ball, and may return it as
    fast.
    """
    outer = scan.position > body.balance_point
    return _top(scan.position[outer], scan.collision_efficiency[outer])


def max_exit_speed(scan: Scan) -> float:
    """Return the place of greatest exit speed for this swing: further out than greatest q, as the tip moves faster."""
    return _top(scan.position, exit_speed_without_spikes(scan))


def exit_speed_without_spikes(scan: Scan) -> Array:
    """Return exit speeds in m/s, shape (positions,), without peaks too narrow to hit.

    Where a whippy bat swings back and pushes the ball a second time, the curve has spikes of a few millimetres. A speed
    counts as far as it lies at most `ZONE_LOSS` above what half an inch of bat around it holds.

    >>> from sweetspot import analyse, catalog, standard_conditions
    >>> scan = analyse(catalog.bat(), standard_conditions(catalog.bat())).scan
    >>> barrel = scan.position > 0.6  # m from the knob end; nearer the hands a handle may swing back
    >>> bool((exit_speed_without_spikes(scan) == scan.exit_speed)[barrel].all())
    True
    """
    return without_spikes(scan.exit_speed, step=float(scan.position[1] - scan.position[0]))


def without_spikes(speed: Array, *, step: float) -> Array:
    """Return speeds, shape (..., positions), ``step`` m apart, without peaks too narrow to hit."""
    window = max(3, 2 * round(NARROWEST / step / 2) + 1)
    speeds = np.where(np.isnan(speed), -np.inf, speed)
    return np.minimum(speed, _opened(speeds, window) + ZONE_LOSS)


def _opened(values: Array, window: int) -> Array:
    """Return values without peaks narrower than a window of an odd number of them: the greatest of the least ones."""
    count = values.shape[-1]
    for extreme in (np.minimum, np.maximum):
        ends = (np.repeat(values[..., end], window // 2, axis=-1) for end in (slice(1), slice(-1, None)))
        padded = np.concatenate([next(ends), values, next(ends)], axis=-1)
        values = padded[..., :count]
        for shift in range(1, window):
            values = extreme(values, padded[..., shift : shift + count])
    return values


def min_sting(scan: Scan, *, body: RigidBody) -> float:
    """Return the place on the barrel of least vibration at the hands: between the nodes of modes 1 and 2.

    Places within half an inch of either end of the scan are left out: on a racket the ball is on the frame there.
    """
    ends = scan.position[0] + NARROWEST, scan.position[-1] - NARROWEST
    barrel = (scan.position > body.balance_point) & (scan.position > ends[0]) & (scan.position < ends[1])
    return _top(scan.position[barrel], -scan.sting[barrel])


def sweet_zone(scan: Scan, *, loss: float = ZONE_LOSS, sting: float = ZONE_STING) -> tuple[float, float] | None:
    """Return the stretch around the best point that loses little speed and stings little, or None.

    ``loss``: m/s that the exit speed may lie below its best. ``sting``: part of the scan's mean sting that must not be
    reached.
    """
    held = exit_speed_without_spikes(scan)
    least = np.nanmax(held) - loss
    places = np.linspace(scan.position[0], scan.position[-1], 20 * len(held))
    speed = np.interp(places, scan.position, held)
    felt = np.interp(places, scan.position, scan.sting)
    good = (speed >= least) & (felt < sting * np.nanmean(scan.sting))
    edges = np.flatnonzero(np.diff(np.concatenate([[False], good, [False]]).astype(int)))
    if len(edges) == 0:
        return None
    runs = [(float(places[start]), float(places[stop - 1])) for start, stop in edges.reshape(-1, 2)]
    best = _top(scan.position, held)
    return min(runs, key=lambda run: max(run[0] - best, best - run[1], 0.0))


def miss_cost(scan: Scan, distance: float) -> tuple[float, float]:
    """Return the exit speed in m/s lost by hitting ``distance`` m nearer the knob and nearer the tip than the best.

    Beyond the tip there is no bat, and beyond a face nothing to hit with: the value is then nan.
    """
    held = exit_speed_without_spikes(scan)
    best = _top(scan.position, held)
    top = float(np.interp(best, scan.position, held))
    inside = float(np.interp(best - distance, scan.position, held, left=np.nan))
    outside = float(np.interp(best + distance, scan.position, held, right=np.nan))
    return top - inside, top - outside


def _top(position: Array, value: Array) -> float:
    """Return the position of the maximum of an evenly sampled curve."""
    index, shift, _ = top(value)
    return float(position[index] + shift * (position[1] - position[0]))

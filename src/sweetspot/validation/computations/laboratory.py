"""The bat test: a ball fired at a bat at rest that turns in a clamp 6 in from the knob end."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache

import numpy as np
from numpy.typing import NDArray

from sweetspot import catalog
from sweetspot.collision.closed_form import bbcor, exit_speed
from sweetspot.collision.kernel import hits
from sweetspot.dynamics.hands import held_modes
from sweetspot.motion.swing import Hands
from sweetspot.numerics.constants import STANDARD_AXIS
from sweetspot.units import INCH
from sweetspot.validation.computations import shared

CLAMP = STANDARD_AXIS
CLAMP_MASS, CLAMP_STIFFNESS = 1e4, 1e9
"""kg and N/m; heavy and stiff enough to hold its place still, free to turn."""
NEAR, FAR, HITS = 2 * INCH, 10 * INCH, 81
"""Places of the test from the tip, a tenth of an inch apart."""


@dataclass(frozen=True)
class BatTestCurves:
    """Places from the tip in m, q and BBCOR there."""

    from_tip: NDArray[np.float64]
    efficiency: NDArray[np.float64]
    bbcor: NDArray[np.float64]


@cache
def bat_test(bat: str, closing_speed: float) -> BatTestCurves:
    """Return the test of a catalogue bat along its barrel."""
    ball, body = catalog.ball(), shared.body(bat)
    clamp = Hands(position=CLAMP, spacing=0.0, mass=CLAMP_MASS, stiffness=CLAMP_STIFFNESS)
    clamped = held_modes(shared.free_modes(bat), clamp)
    from_tip = np.linspace(NEAR, FAR, HITS)
    places = shared.length(bat) - from_tip
    efficiency = hits(clamped, ball=ball, position=places, closing_speed=closing_speed).collision_efficiency
    measured = [bbcor(q, body=body, ball=ball, position=place) for q, place in zip(efficiency, places, strict=True)]
    return BatTestCurves(from_tip, efficiency, np.array(measured))


def laboratory_bbcor(*, bat: str, closing_speed: float) -> float:
    """Return BBCOR at the place where it is greatest."""
    return float(bat_test(bat, closing_speed).bbcor.max())


def laboratory_efficiency(*, bat: str, closing_speed: float) -> float:
    """Return q at the place where it is greatest."""
    return float(bat_test(bat, closing_speed).efficiency.max())


def laboratory_exit_speed(*, bat: str, ball_speed: float, bat_speed: float) -> float:
    """Return the greatest exit speed of a moving bat by the test's rule.

    ``bat_speed`` is 6 in from the tip; the bat turns about the clamp.
    """
    test = bat_test(bat, ball_speed + bat_speed)
    swing = bat_speed * (shared.length(bat) - test.from_tip - CLAMP) / (shared.length(bat) - 6 * INCH - CLAMP)
    return float(exit_speed(test.efficiency, ball_speed=ball_speed, bat_speed=swing).max())


def laboratory_bbcor_spread(*, bats: list[str], closing_speed: float) -> float:
    """Return the difference between the greatest and the smallest BBCOR of some bats."""
    ratios = [laboratory_bbcor(bat=bat, closing_speed=closing_speed) for bat in bats]
    return max(ratios) - min(ratios)


def laboratory_besr_rise(*, bats: list[str], closing_speed: float) -> float:
    """Return how much BESR = q + 1/2 is greater for the last of some bats than for the first."""
    first, *_, last = [laboratory_efficiency(bat=bat, closing_speed=closing_speed) for bat in bats]
    return last - first

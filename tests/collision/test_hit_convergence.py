"""The coupled collision: orders of convergence in the time step, the ledger's closure, the number of modes."""

from __future__ import annotations

import math

import numpy as np
import pytest
from numpy.typing import ArrayLike, NDArray

from sweetspot import catalog
from sweetspot.collision import coupled, kernel
from sweetspot.collision.coupled import hit
from sweetspot.collision.kernel import hits
from sweetspot.dynamics.beam import beam_model
from sweetspot.dynamics.bending import bending_modes
from sweetspot.dynamics.modes import Modes

Array = NDArray[np.float64]

BALL = catalog.ball()
LINE = beam_model(catalog.bat("r161-ash"))
MODES = bending_modes(LINE)
PLACES = (0.45, 0.60, 0.68, 0.75, 0.82)
PITCH = 40.0
"""m/s; exit speeds below are for this pitch."""


def order(steps: ArrayLike, errors: ArrayLike) -> float:
    """Return the slope of log error against log step: the order of convergence."""
    return float(np.polyfit(np.log(np.asarray(steps, float)), np.log(np.abs(np.asarray(errors, float))), 1)[0])


def rms(values: ArrayLike) -> float:
    return float(np.sqrt(np.mean(np.asarray(values, float) ** 2)))


def exit_speed(modes: Modes, *, places: Array, closing: Array, step: float) -> Array:
    """Return exit speeds in m/s: q * pitch + (1 + q) * (closing - pitch)."""
    q = hits(modes, ball=BALL, position=places, closing_speed=closing, step=step).collision_efficiency
    return np.asarray(q * PITCH + (1 + q) * (closing - PITCH))


def game_hits(count: int) -> tuple[Array, Array]:
    """Return positions (m) and closing speeds (m/s) spread over barrel and game."""
    generator = np.random.default_rng(20)
    return generator.uniform(0.60, 0.82, count), generator.uniform(60.0, 80.0, count)


def test_exit_speed_converges_at_more_than_second_order() -> None:
    # Between two (leapfrog) and four (corrected kicks): the force's kink at its peak leaves about three.
    places, closing = game_hits(300)
    converged = exit_speed(MODES, places=places, closing=closing, step=0.05e-6)
    steps = np.array([8.0, 4.0, 2.0, 1.0, 0.5]) * 1e-6
    errors = [rms(exit_speed(MODES, places=places, closing=closing, step=step) / converged - 1) for step in steps]
    assert 2.3 < order(steps, errors) < 4.2


@pytest.mark.parametrize(("step", "allowed"), [(coupled.STEP, 1e-5), (kernel.STEP, 1e-4)])
def test_exit_speed_at_the_default_steps(step: float, allowed: float) -> None:
    places, closing = game_hits(3000)
    converged = exit_speed(MODES, places=places, closing=closing, step=0.5e-6)
    found = exit_speed(MODES, places=places, closing=closing, step=step)
    assert np.abs(found / converged - 1).max() < allowed


@pytest.mark.parametrize("place", PLACES)
@pytest.mark.parametrize("closing", [1.0, 10.0, 40.0, 60.0, 80.0])
def test_ledger_closes_at_the_default_step(place: float, closing: float) -> None:
    ledger = hit(MODES, ball=BALL, position=place, closing_speed=closing).energy
    assert abs(ledger.imbalance) < 1e-4


@pytest.mark.parametrize("closing", [5.0, 70.0])
def test_ledger_closes_at_second_order(closing: float) -> None:
    # The slope comes up to 2 from below: heat is a trapezoidal sum, whose start (F ~ u^1.5) adds a term of order 2.5.
    steps = np.array([4.0, 2.0, 1.0, 0.5]) * 1e-6
    imbalances = [
        rms([hit(MODES, ball=BALL, position=x, closing_speed=closing, step=h).energy.imbalance for x in PLACES])
        for h in steps
    ]
    assert order(steps, imbalances) > 1.9
    assert order(steps[-2:], imbalances[-2:]) > 1.93


def test_twelve_modes_are_enough_on_the_barrel() -> None:
    # Exit speed rises slowly with ever shorter waves (a point blow feels them all), so the last bit of compliance is
    # missed: against 30 modes, whose waves are as short as the patch of contact is wide, under 0.3 %.
    many = bending_modes(LINE, count=30, elements=40)
    places = np.linspace(0.60, 0.80, 21)
    closing = np.full_like(places, 71.0)

    def with_modes(count: int) -> Array:
        return exit_speed(many.kept(list(range(2 + count))), places=places, closing=closing, step=2e-6)

    full = with_modes(30)
    missing = {count: float(np.abs(with_modes(count) / full - 1).max()) for count in (6, 12, 20)}
    assert missing[12] < 3e-3
    assert missing[20] < missing[12] < missing[6]


def test_release_is_found_between_steps() -> None:
    # Found at the first step past it, release would miss by a step; as a root it converges with the motion itself.
    def release(step: float) -> float:
        return hit(MODES, ball=BALL, position=0.7, closing_speed=70.0, step=step).release_time

    converged = release(0.25e-6)
    assert abs(release(4e-6) - converged) < 0.02 * 4e-6
    assert math.isclose(release(8e-6), converged, rel_tol=1e-4)

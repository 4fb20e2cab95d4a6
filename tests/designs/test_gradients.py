"""Slopes of a design against derivatives that take no difference, and the order at which differences converge."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.linalg import eigh

from sweetspot.designs.local_search import STEP, gradient
from sweetspot.designs.measures import Bench
from sweetspot.designs.turned import _ROUND, HANDLES, SAMPLES, STATIONS, TurnedSpace, knob_of
from sweetspot.dynamics.beam import beam_model
from sweetspot.equipment.bat import Bat
from sweetspot.numerics.arrays import Array
from sweetspot.numerics.constants import STANDARD_AXIS
from sweetspot.units import INCH
from tests.dense_bending import mesh_matrices

TINY = 1e-30


def ends_of(bench: Bench) -> tuple[Array, Array]:
    variables = bench.space.variables
    return np.array([one.low for one in variables]), np.array([one.high for one in variables])


@pytest.fixture(scope="module")
def numbers(bench: Bench) -> Array:
    """A bat without corners: no diameter equals its neighbour, and there is no cup."""
    low, high = ends_of(bench)
    found = bench.space.start + 0.03 * (high - low) * np.sin(1.7 * np.arange(len(low)))
    found[len(HANDLES)] = 0.0
    return np.asarray(found)


def slopes_of(place: Array, value: Array) -> Array:
    """Return the slopes at the nodes of Fritsch and Carlson's cubics, complex ones too."""
    step, rise = np.diff(place), np.diff(value) / np.diff(place)
    slope = np.zeros(len(value), complex)
    for i in range(1, len(value) - 1):
        if rise[i - 1].real * rise[i].real > 0:
            first, second = 2 * step[i] + step[i - 1], step[i] + 2 * step[i - 1]
            slope[i] = (first + second) / (first / rise[i - 1] + second / rise[i])
    for end, a, b, h, k in ((0, rise[0], rise[1], step[0], step[1]), (-1, rise[-1], rise[-2], step[-1], step[-2])):
        out = ((2 * h + k) * a - h * b) / (h + k)
        if out.real * a.real <= 0:
            out = 0
        elif a.real * b.real < 0 and abs(out.real) > 3 * abs(a.real):
            out = 3 * a
        slope[end] = out
    return slope


def curve(diameters: Array) -> Array:
    slope, step = slopes_of(HANDLES, diameters), np.diff(HANDLES)
    cell = np.clip(np.searchsorted(HANDLES, SAMPLES, side="right") - 1, 0, len(HANDLES) - 2)
    t, h = (SAMPLES - HANDLES[cell]) / step[cell], step[cell]
    return np.asarray(
        (2 * t**3 - 3 * t**2 + 1) * diameters[cell]
        + (t**3 - 2 * t**2 + t) * h * slope[cell]
        + (3 * t**2 - 2 * t**3) * diameters[cell + 1]
        + (t**3 - t**2) * h * slope[cell + 1]
    )


def weighed(space: TurnedSpace, numbers: Array) -> dict[str, complex]:
    """Return mass, balance point and moment of inertia of a bat without a cup, by cones, of complex numbers too."""
    diameters = numbers[: len(HANDLES)]
    head = space.outlines(numbers.real[None]).diameter[0, : len(STATIONS) - len(SAMPLES) - len(_ROUND)]
    assert head.max() == pytest.approx(knob_of(space.present))
    place = STATIONS * space.present.length
    width = np.concatenate([head, curve(diameters), diameters[-1] * np.array([part for _, part in _ROUND])])
    x, h = np.polynomial.legendre.leggauss(4)[0] / 2 + 0.5, np.diff(place)
    weights = np.polynomial.legendre.leggauss(4)[1] / 2
    at = place[:-1, None] + h[:, None] * x
    wide = width[:-1, None] + np.diff(width)[:, None] * x
    piece = space.material.density * numbers[-1] * np.pi / 4 * wide**2 * h[:, None] * weights
    mass = piece.sum()
    turning = (piece * ((at - STANDARD_AXIS) ** 2 + wide**2 / 16)).sum()  # a disc about its own diameter
    return {"mass": mass, "balance_point": (piece * at).sum() / mass, "moi": turning}


def test_weights_follow_the_numbers_as_complex_steps_say(bench: Bench, numbers: Array) -> None:
    """Im f(x + i h) / h has no difference in it (Squire and Trapp): to 1e-6 of the steepest, for every diameter."""
    space = bench.space
    assert isinstance(space, TurnedSpace)
    low, high = ends_of(bench)
    for name, value in weighed(space, numbers.astype(complex)).items():
        assert bench.measured(numbers).values[name][0] == pytest.approx(value.real, rel=1e-9)
        exact = np.array([weighed(space, numbers + 1j * TINY * one)[name].imag / TINY for one in np.eye(len(numbers))])
        found = gradient(bench, numbers, name)
        away = np.abs((found - exact) * (high - low))
        away[len(HANDLES)] = 0.0  # the cup, which is left out here
        assert away.max() < 1e-6 * np.abs(exact * (high - low)).max()


def test_frequency_follows_the_numbers_as_perturbed_modes_say(bench: Bench, numbers: Array) -> None:
    """d omega^2 = phi' (dK - omega^2 dM) phi / phi' M phi: the mode itself stays, by the readable matrices; to 1e-6."""
    space = bench.space
    assert isinstance(space, TurnedSpace)
    low, high = ends_of(bench)

    def matrices(row: Array) -> tuple[Array, Array]:
        bat = space.made(row, "made")
        assert isinstance(bat, Bat)
        return mesh_matrices(beam_model(bat))[:2]

    stiffness, inertia = matrices(numbers)
    square, shape = eigh(stiffness, inertia, subset_by_index=[2, 2])
    omega, mode = float(np.sqrt(square[0])), shape[:, 0]
    steps = 1e-5 * (high - low)
    found, exact = gradient(bench, numbers, "frequency"), np.zeros(len(numbers))
    for index in (2, 5, 7, 9, 10, len(numbers) - 1):
        (more, heavier), (less, lighter) = (
            matrices(numbers + way * steps[index] * np.eye(len(numbers))[index]) for way in (1, -1)
        )
        change = mode @ ((more - less) - square[0] * (heavier - lighter)) @ mode / (2 * steps[index])
        exact[index] = change / (2 * omega) / (2 * np.pi)
        assert (found - exact)[index] * (high - low)[index] == pytest.approx(
            0.0, abs=1e-6 * np.abs(found * (high - low)).max()
        )


@pytest.mark.parametrize("measure", ["exit_speed", "zone", "sting", "best", "swing_time"])
def test_differences_converge_at_second_order(bench: Bench, numbers: Array, measure: str) -> None:
    """Half the step, a quarter of the error; at the step of the search it is below 1e-5 of the steepest slope."""
    cupped = numbers.copy()
    cupped[len(HANDLES)] = 0.3 * INCH
    low, high = ends_of(bench)
    steps = (1.2e-2, 6e-3, 3e-3, STEP)  # finer ones meet the rounding of the best place
    coarse, middle, fine, used = (gradient(bench, cupped, measure, step=step) * (high - low) for step in steps)
    limit = (4 * fine - middle) / 3
    steepest = np.abs(limit).max()
    worst = np.abs(coarse - limit).argmax()
    assert (coarse - limit)[worst] / (middle - limit)[worst] == pytest.approx(4.0, abs=0.3)
    assert np.abs(used - limit).max() < 1e-5 * steepest

"""Bending modes against exact beams, against an independent assembly, and their order of convergence."""

from __future__ import annotations

import math

import numpy as np
import pytest
import scipy.linalg
from numpy.typing import ArrayLike, NDArray
from scipy.optimize import brentq

from sweetspot import catalog
from sweetspot.dynamics.batch.mesh import ELEMENTS
from sweetspot.dynamics.beam import beam_model
from sweetspot.dynamics.reduction import bending_modes
from sweetspot.equipment.bat import Bat
from sweetspot.equipment.material import Material
from sweetspot.equipment.section import shear_coefficient

Array = NDArray[np.float64]

WOOD = Material(name="test wood", density=670.0, longitudinal_modulus=15.3e9, shear_modulus=1.0e9, poisson_ratio=0.44)
EULER_ROOTS = (4.730041, 7.853205, 10.995608)
"""exact: cos(b) cosh(b) = 1, the free-free thin beam."""
STIFF_IN_SHEAR = WOOD.replaced(shear_modulus=1e12)
"""Leaves rotary inertia as the only difference from a thin beam; stiffer still, rounding would show."""


def cone(*, length: float, knob: float, tip: float, material: Material = WOOD) -> Bat:
    """Return a bare conical bat: a bat with two stations (m)."""
    return Bat(name="cone", length=length, material=material, profile=((0.0, knob), (length, tip)))


def order(steps: ArrayLike, errors: ArrayLike) -> float:
    """Return the slope of log error against log step: the order of convergence."""
    return float(np.polyfit(np.log(np.asarray(steps, float)), np.log(np.abs(np.asarray(errors, float))), 1)[0])


def timoshenko_free_free(*, length: float, diameter: float, material: Material, count: int) -> Array:
    """Return the lowest frequencies (Hz) of a uniform free-free Timoshenko beam from its frequency equation.

    Motions symmetric and antisymmetric about the middle are combinations of cos/sin(a x) and cosh/sinh(b x) with a, b
    from the beam's characteristic equation; no moment and no shear at the ends leaves one 2 x 2 determinant each.
    """
    area, second = math.pi * diameter**2 / 4, math.pi * diameter**4 / 64
    assert material.poisson_ratio is not None
    shear = float(shear_coefficient(np.array(0.0), material.poisson_ratio)) * material.shear * area
    bending = material.longitudinal_modulus * second
    mass, rotary = material.density * area, material.density * second

    def determinant(omega: float, symmetric: bool) -> float:
        square, middle = shear * bending, (shear * rotary + mass * bending) * omega**2
        last = mass * omega**2 * (rotary * omega**2 - shear)
        root = math.sqrt(middle**2 - 4 * square * last)
        a, b = math.sqrt((middle + root) / (2 * square)), math.sqrt((root - middle) / (2 * square))
        c, half = mass * omega**2 / shear, length / 2
        tanh = math.tanh(b * half)
        if symmetric:
            return (c - a**2) * math.cos(a * half) * tanh / b - (b**2 + c) * math.sin(a * half) / a
        return (c - a**2) * math.sin(a * half) / (b * tanh) + (b**2 + c) * math.cos(a * half) / a

    grid = np.linspace(1e-3, 0.999, 8001) * math.sqrt(shear / rotary)  # up to the cut-off of shear waves
    found: list[float] = []
    for symmetric in (True, False):
        signs = np.sign([determinant(omega, symmetric) for omega in grid])
        found += [
            brentq(determinant, grid[left], grid[left + 1], args=(symmetric,), xtol=1e-12, rtol=1e-15)
            for left in np.flatnonzero(signs[1:] != signs[:-1])
        ]
    return np.sort(found)[:count] / (2 * math.pi)


def thin_beam(bat: Bat, *, elements: int, count: int) -> Array:
    """Return the lowest frequencies (Hz) of a free-free Euler-Bernoulli bat from cubic Hermite elements."""
    size, material = bat.length / elements, bat.material
    stiffness, inertia = np.zeros((2, 2 * elements + 2, 2 * elements + 2))
    points, weights = np.polynomial.legendre.leggauss(8)
    for element in range(elements):
        dofs = slice(2 * element, 2 * element + 4)
        for point, weight in zip((points + 1) / 2, weights / 2, strict=True):
            radius = float(bat.diameter_at((element + point) * size)) / 2
            s, rest = point, 1 - point
            value = np.array([rest**2 * (1 + 2 * s), size * s * rest**2, s**2 * (3 - 2 * s), -size * s**2 * rest])
            curvature = np.array([12 * s - 6, size * (6 * s - 4), 6 - 12 * s, size * (6 * s - 2)]) / size**2
            bending = material.longitudinal_modulus * math.pi * radius**4 / 4
            stiffness[dofs, dofs] += weight * size * bending * np.outer(curvature, curvature)
            inertia[dofs, dofs] += weight * size * material.density * math.pi * radius**2 * np.outer(value, value)
    squares = scipy.linalg.eigh(stiffness, inertia, eigvals_only=True)
    return np.asarray(np.sqrt(squares[2 : count + 2])) / (2 * math.pi)


def frequencies(bat: Bat, *, elements: int = ELEMENTS, count: int = 12) -> Array:
    return bending_modes(beam_model(bat), count=count, elements=elements).frequency[2:]


@pytest.mark.parametrize("diameter", [0.025, 0.045, 0.065])
def test_uniform_beam_has_the_exact_timoshenko_frequencies(diameter: float) -> None:
    exact = timoshenko_free_free(length=0.84, diameter=diameter, material=WOOD, count=12)
    bat = cone(length=0.84, knob=diameter, tip=diameter)
    assert frequencies(bat, elements=60) == pytest.approx(exact, rel=1e-6)
    assert frequencies(bat)[:5] == pytest.approx(exact[:5], rel=2e-5)


def test_frequencies_converge_at_sixth_order() -> None:
    # Twice the order of the cubic rotation; the quartic deflection alone would give eight.
    exact = timoshenko_free_free(length=0.84, diameter=0.045, material=WOOD, count=3)
    meshes = np.array([6, 8, 12, 16])
    bat = cone(length=0.84, knob=0.045, tip=0.045)
    errors = np.array([frequencies(bat, elements=elements, count=3) / exact - 1 for elements in meshes])
    assert np.all(errors > 0)  # a conforming element with exact integrals is never too soft
    for mode in range(3):
        assert 5.7 < order(1 / meshes, errors[:, mode]) < 6.5


def test_thin_limit_has_the_euler_roots() -> None:
    # Rotary inertia lowers the roots with the square of the diameter; two diameters leave only its square's square.
    def roots(diameter: float) -> Array:
        bat = cone(length=1.3, knob=diameter, tip=diameter, material=STIFF_IN_SHEAR)
        speed = math.sqrt(STIFF_IN_SHEAR.longitudinal_modulus / STIFF_IN_SHEAR.density) * diameter / 4
        return np.sqrt(2 * math.pi * frequencies(bat, elements=24, count=3) / speed) * bat.length

    assert (4 * roots(0.01) - roots(0.02)) / 3 == pytest.approx(EULER_ROOTS, rel=1e-6)


def test_conical_beam_in_the_thin_limit_is_the_hermite_one() -> None:
    def scaled(diameter: float) -> Array:
        bat = cone(length=1.3, knob=diameter, tip=2 * diameter, material=STIFF_IN_SHEAR)
        return frequencies(bat, elements=24, count=5) / diameter

    thin = thin_beam(cone(length=1.3, knob=0.01, tip=0.02), elements=80, count=5) / 0.01
    # The stiff shear terms of so thin a beam leave 5e-6 of rounding in the lowest mode.
    assert (4 * scaled(0.005) - scaled(0.01)) / 3 == pytest.approx(thin, rel=1e-5)


def test_shear_and_rotary_inertia_only_lower_a_bat() -> None:
    bat = cone(length=0.84, knob=0.025, tip=0.065)
    lowering = frequencies(bat, count=6) / thin_beam(bat, elements=60, count=6)
    assert np.all(lowering < 1)
    assert np.all(np.diff(lowering) < 0)


def test_conical_beam_converges_to_a_refined_one_at_sixth_order() -> None:
    bat = cone(length=0.84, knob=0.025, tip=0.065)
    refined = frequencies(bat, elements=64, count=5)
    meshes = np.array([8, 12, 16, 24])
    errors = np.array([frequencies(bat, elements=elements, count=5) / refined - 1 for elements in meshes])
    for mode in range(5):
        assert 5.7 < order(1 / meshes, errors[:, mode]) < 6.5


@pytest.mark.parametrize("name", catalog.bat_names())
def test_every_catalogue_bat_is_converged_at_the_default_mesh(name: str) -> None:
    bat = catalog.bat(name)
    refined, default = frequencies(bat, elements=64), frequencies(bat)
    assert default[:5] == pytest.approx(refined[:5], rel=1e-4)
    assert default == pytest.approx(refined, rel=5e-4)  # up to mode 12: 13.8 kHz of the composite bat is 4.5e-4 high


def test_a_weight_inside_an_element_lowers_each_mode_as_rayleigh_says() -> None:
    # exact to first order in the weight: d(omega^2) / omega^2 = -mass * shape(place)^2
    light = 1e-5
    for place in (0.1234, 0.5, 0.84):
        bat = cone(length=0.84, knob=0.045, tip=0.045)
        bare = bending_modes(beam_model(bat), count=4, elements=40)
        loaded = frequencies(bat.weighted(position=place, mass=light), count=4, elements=40)
        change = (loaded / bare.frequency[2:]) ** 2 - 1
        expected = -light * bare.shape_at(place)[2:] ** 2
        assert change == pytest.approx(expected, rel=2e-3, abs=1e-8)


def test_weights_do_not_depend_on_each_other_or_on_what_was_asked_before() -> None:
    bat = cone(length=0.84, knob=0.045, tip=0.045)
    one_way = bat.weighted(position=0.1, mass=0.05).weighted(position=0.7, mass=0.02)
    other_way = bat.weighted(position=0.7, mass=0.02).weighted(position=0.1, mass=0.05)
    first = frequencies(one_way)
    assert frequencies(other_way) == pytest.approx(first, rel=1e-9)
    assert frequencies(one_way) == pytest.approx(first, rel=1e-12)


def test_stations_a_rounding_error_apart_are_one() -> None:
    """Exact: the same outline, so the same modes."""
    plain = Bat(name="one", length=0.84, material=WOOD, profile=((0.0, 0.03), (0.4, 0.04), (0.84, 0.06)))
    again = plain.replaced(profile=((0.0, 0.03), (0.4, 0.04), (0.4 + 1e-15, 0.04), (0.84, 0.06)))
    assert frequencies(again) == pytest.approx(frequencies(plain), rel=1e-9)

"""Knob and end cap of a hollow bat have a depth: mass, balance, moment of inertia and tones.

Expected values: exact solutions of an Euler-Bernoulli beam whose mass per length is stepped, by its determinant, and
the moments of solid cylinders.
"""

from __future__ import annotations

import numpy as np
import pytest
from numpy.typing import NDArray
from scipy.optimize import brentq

from sweetspot import catalog
from sweetspot.calibration.unknowns import described, deviated, unknowns_of
from sweetspot.dynamics.beam import beam_model
from sweetspot.dynamics.reduction import bending_frequencies
from sweetspot.dynamics.rigid import rigid_body
from sweetspot.equipment.bat import Bat
from sweetspot.errors import InputError

LENGTH, RADIUS, WALL = 1.3, 0.004, 0.001
METAL = catalog.bat("single-wall").material


def tube(**ends: float) -> Bat:
    """Return a tube so slender that its shear and the rotation of its sections lower these tones by 1e-3 or less."""
    wall = ((0.0, WALL), (LENGTH, WALL))
    profile = ((0.0, 2 * RADIUS), (LENGTH, 2 * RADIUS))
    return Bat(name="tube", length=LENGTH, material=METAL, profile=profile, shell={"wall": wall, **ends})


def stepped_tones(loads: list[tuple[float, float]], count: int) -> list[float]:
    """Return the tones in Hz of the slender tube with more mass (over m, in kg/m) at its start and its end."""
    inner = RADIUS - WALL
    per_length = METAL.density * np.pi * (RADIUS**2 - inner**2)
    stiffness = METAL.longitudinal_modulus * np.pi / 4 * (RADIUS**4 - inner**4)
    (first, more), (last, rest) = loads
    widths = (first, LENGTH - first - last, last)
    masses = (per_length + more, per_length, per_length + rest)

    def carried(wave: float, width: float) -> NDArray[np.float64]:
        """Return the matrix that takes w, w', w'', w''' of a beam from one end of a part to the other."""
        roots = wave * np.array([1, -1, 1j, -1j])
        vander = np.vander(roots, 4, increasing=True).T
        return np.asarray((vander * np.exp(roots * width) @ np.linalg.inv(vander)).real)

    def misfit(omega: float) -> float:
        whole = np.eye(4)
        for width, mass in zip(widths, masses, strict=True):
            if width:
                whole = carried((mass * omega**2 / stiffness) ** 0.25, width) @ whole
        return float(np.linalg.det(whole[2:, :2]))  # free ends: neither moment nor force

    tones: list[float] = []
    grid = 2 * np.pi * np.arange(2.0, 400.0, 0.5)
    values = [misfit(omega) for omega in grid]
    for low, high, before, after in zip(grid, grid[1:], values, values[1:], strict=False):
        if before * after < 0 and len(tones) < count:
            tones.append(brentq(misfit, low, high) / (2 * np.pi))
    return tones


def test_tones_are_those_of_a_beam_whose_mass_is_spread_over_the_depth() -> None:
    knob, cap, depth = 0.008, 0.004, 0.03
    made = tube(knob_mass=knob, knob_depth=depth, end_cap_mass=cap, end_cap_depth=depth)
    bare = np.array(stepped_tones([(0.0, 0.0), (0.0, 0.0)], 3))
    exact = np.array(stepped_tones([(depth, knob / depth), (depth, cap / depth)], 3)) / bare
    plain = bending_frequencies(beam_model(tube()), count=3)  # what shear takes is the same in both
    assert plain == pytest.approx(bare, rel=2e-3)
    assert bending_frequencies(beam_model(made), count=3) / plain == pytest.approx(exact, rel=2e-4)
    at_the_ends = tube(knob_mass=knob, knob_depth=0, end_cap_mass=cap, end_cap_depth=0)
    lower = bending_frequencies(beam_model(at_the_ends), count=3) / plain
    assert np.all(lower < exact * 0.99)  # what the depth is worth: far more than the tolerance


def test_without_depth_they_sit_at_the_very_ends() -> None:
    """A disc of no depth is a point mass with its own moment of inertia, 1e-4 of a bat's."""
    alloy = catalog.bat("college-alloy")
    assert alloy.shell is not None
    depths = (0.0, 1e-5)
    thin, thinner = (
        beam_model(alloy.replaced(shell=alloy.shell.replaced(knob_depth=depth, end_cap_depth=depth)))
        for depth in reversed(depths)
    )
    knob, cap = thinner.point_masses[1], thinner.point_masses[-1]
    assert (knob.position, cap.position) == (0.0, alloy.length)
    assert knob.moi == pytest.approx(knob.mass * (0.85 * 0.0254) ** 2 / 4)  # the outline is 1.7 in wide there
    assert bending_frequencies(thin, count=3) == pytest.approx(bending_frequencies(thinner, count=3), rel=1e-4)


def test_mass_stays_and_balance_and_moment_follow() -> None:
    ends = {"knob_mass": 0.06, "end_cap_mass": 0.02}
    deep = rigid_body(beam_model(tube(**ends, knob_depth=0.04, end_cap_depth=0.02)))
    bare = rigid_body(beam_model(tube()))
    assert deep.mass == pytest.approx(bare.mass + 0.08, rel=1e-12)
    moved = bare.mass * LENGTH / 2 + 0.06 * 0.02 + 0.02 * (LENGTH - 0.01)
    assert deep.balance_point == pytest.approx(moved / deep.mass, rel=1e-12)
    of_knob = 0.06 * (RADIUS**2 / 4 + 0.04**2 / 12 + 0.02**2)
    of_cap = 0.02 * ((RADIUS - WALL) ** 2 / 4 + 0.02**2 / 12 + (LENGTH - 0.01) ** 2)
    assert deep.moi(0.0) == pytest.approx(bare.moi(0.0) + of_knob + of_cap, rel=1e-12)


def test_a_depth_that_was_measured_is_not_in_doubt() -> None:
    alloy = catalog.bat("college-alloy")
    assert alloy.shell is not None
    names = [unknown.name for unknown in unknowns_of(alloy)]
    assert {"knob_depth", "end_depth"} <= set(names)
    measured = alloy.replaced(shell=alloy.shell.replaced(knob_depth=0.025, end_cap_depth=0.012))
    assert not {"knob_depth", "end_depth"} & {unknown.name for unknown in unknowns_of(measured)}
    deviations = np.array([np.log(1.25) * (name == "knob_depth") for name in names])
    deeper = deviated(described(alloy), unknowns_of(alloy), deviations).bat
    assert isinstance(deeper, Bat) and deeper.shell is not None
    assert deeper.shell.depths == pytest.approx((0.025, 0.010))


def test_a_plug_as_long_as_a_handle_is_refused() -> None:
    with pytest.raises(InputError, match=r"the end cap is 0.5 m .19.69 in. deep"):
        tube(end_cap_mass=0.02, end_cap_depth=0.5)

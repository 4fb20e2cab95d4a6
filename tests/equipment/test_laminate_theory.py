"""Classical laminate theory against its exact limits and a textbook's laminate."""

from __future__ import annotations

import math
from itertools import product

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from sweetspot.equipment.laminate import (
    Laminate,
    Ply,
    effective_moduli,
    laminate_stiffness,
    ply_stiffness,
    rotated,
    sheet,
)
from sweetspot.equipment.material import Material

METAL = Material(name="metal", family="metal", density=2800, longitudinal_modulus=71e9, poisson_ratio=0.33)
GRAPHITE = Material(
    name="graphite-epoxy", family="laminate", density=1600, longitudinal_modulus=181e9, transverse_modulus=10.3e9,
    shear_modulus=7.17e9, poisson_ratio=0.28,
)  # fmt: skip
ANGLES = st.floats(-90, 90)


def laid(*degrees: float, thickness: float = 1e-3) -> Laminate:
    return Laminate(
        plies=tuple(Ply(material=GRAPHITE, angle=math.radians(angle), thickness=thickness) for angle in degrees)
    )


def test_an_isotropic_sheet_is_exact() -> None:
    """A = E h / (1 - nu^2) [[1, nu, 0], [nu, 1, 0], [0, 0, (1 - nu) / 2]], D = A h^2 / 12, B = 0."""
    height, nu = 0.003, 0.33
    exact = 71e9 * height / (1 - nu**2) * np.array([[1, nu, 0], [nu, 1, 0], [0, 0, (1 - nu) / 2]])
    plate = sheet(METAL, np.array(height))
    assert np.allclose(plate.stretching, exact, rtol=1e-14)
    assert np.allclose(plate.bending, exact * height**2 / 12, rtol=1e-14)
    assert not plate.coupling.any()


def test_plies_of_one_metal_are_one_sheet_whatever_their_angle() -> None:
    plies = tuple(Ply(material=METAL, angle=angle, thickness=1e-3) for angle in (0.0, 0.7, -1.2))
    laminate, whole = laminate_stiffness(Laminate(plies=plies)), sheet(METAL, np.array(3e-3))
    assert np.allclose(laminate.stretching, whole.stretching, rtol=1e-12, atol=1e-3)
    assert np.allclose(laminate.bending, whole.bending, rtol=1e-12, atol=1e-9)
    assert np.abs(laminate.coupling).max() < 1e-9 * whole.stretching[0, 0] * 3e-3


def test_a_quarter_turn_swaps_the_axes() -> None:
    own, turned = ply_stiffness(GRAPHITE), rotated(ply_stiffness(GRAPHITE), math.pi / 2)
    assert np.allclose(turned, own[np.ix_([1, 0, 2], [1, 0, 2])], rtol=1e-12, atol=1e-3)


@settings(max_examples=30)
@given(ANGLES)
def test_turning_is_that_of_the_stiffness_tensor(degrees: float) -> None:
    """Q' as the fourth-order tensor turned index by index: C'_ijkl = R_ip R_jq R_kr R_ls C_pqrs."""
    angle = math.radians(degrees)
    place = {(0, 0): 0, (1, 1): 1, (0, 1): 2, (1, 0): 2}
    own = ply_stiffness(GRAPHITE)
    tensor = np.zeros((2, 2, 2, 2))
    for i, j, k, m in product(range(2), repeat=4):
        tensor[i, j, k, m] = own[place[i, j], place[k, m]]
    turn = np.array([[math.cos(angle), -math.sin(angle)], [math.sin(angle), math.cos(angle)]])
    turned = np.einsum("ip,jq,kr,ls,pqrs->ijkl", turn, turn, turn, turn, tensor)
    pairs = [(0, 0), (1, 1), (0, 1)]
    expected = np.array([[turned[(*row, *column)] for column in pairs] for row in pairs])
    assert np.allclose(rotated(own, angle), expected, rtol=1e-10, atol=1.0)


def test_the_textbook_laminate() -> None:
    """[0/30/-45] of 5 mm plies, every digit printed; the book lists plies the other way, z downwards [kaw2006]."""
    plate = laminate_stiffness(laid(0, 30, -45, thickness=5e-3))
    a = [[1.739e9, 3.884e8, 5.663e7], [3.884e8, 4.533e8, -1.141e8], [5.663e7, -1.141e8, 4.525e8]]
    b = [[-3.129e6, 9.855e5, -1.072e6], [9.855e5, 1.158e6, -1.072e6], [-1.072e6, -1.072e6, 9.855e5]]
    d = [[3.343e4, 6.461e3, -5.240e3], [6.461e3, 9.320e3, -5.596e3], [-5.240e3, -5.596e3, 7.663e3]]
    for found, printed in ((plate.stretching, a), (plate.coupling, b), (plate.bending, d)):
        assert np.allclose(found, printed, rtol=5e-4)


@settings(max_examples=20)
@given(st.lists(ANGLES, min_size=1, max_size=4))
def test_a_symmetric_laminate_does_not_couple(angles: list[float]) -> None:
    plate = laminate_stiffness(laid(*angles, *reversed(angles)))
    assert np.abs(plate.coupling).max() < 1e-12 * np.abs(plate.stretching).max()


def test_quasi_isotropic() -> None:
    """A of [0/45/-45/90]s is isotropic with the invariants U1, U4 of Q: A11 = U1 h, A12 = U4 h, exact."""
    plate = laminate_stiffness(laid(0, 45, -45, 90, 90, -45, 45, 0))
    (q11, q12, _), (_, q22, _), (*_, q66) = ply_stiffness(GRAPHITE)
    u1, u4 = (3 * q11 + 3 * q22 + 2 * q12 + 4 * q66) / 8, (q11 + q22 + 6 * q12 - 4 * q66) / 8
    exact = 8e-3 * np.array([[u1, u4, 0], [u4, u1, 0], [0, 0, (u1 - u4) / 2]])
    assert np.allclose(plate.stretching, exact, rtol=1e-12, atol=1.0)
    assert plate.bending[0, 0] > 1.5 * plate.bending[1, 1]  # the order of plies still counts in bending


@settings(max_examples=30)
@given(st.lists(ANGLES, min_size=1, max_size=6), st.floats(1e-4, 1e-2))
def test_stiffness_is_positive_and_scales_with_the_wall(angles: list[float], height: float) -> None:
    laminate = laid(*angles)
    plate, unit = laminate_stiffness(laminate, height), laminate_stiffness(laminate, 1.0)
    whole = np.block([[unit.stretching, unit.coupling], [unit.coupling, unit.bending]])
    assert np.linalg.eigvalsh(whole).min() > 0
    assert np.allclose(plate.bending, unit.bending * height**3, rtol=1e-12)
    found = effective_moduli(laminate)
    for modulus in (found.axial, found.hoop, found.shear):
        assert 7.17e9 * 0.9 < modulus < 181e9 * 1.001  # between the softest and the stiffest of one ply


def test_effective_moduli_of_one_ply_and_one_metal() -> None:
    one = effective_moduli(laid(0))
    assert (one.axial, one.hoop, one.shear, one.poisson_ratio) == pytest.approx((181e9, 10.3e9, 7.17e9, 0.28))
    across = effective_moduli(laid(90))
    assert (across.axial, across.hoop) == pytest.approx((10.3e9, 181e9))
    metal = effective_moduli(Laminate(plies=(Ply(material=METAL, angle=0.4, thickness=1e-3),)))
    assert (metal.axial, metal.shear) == pytest.approx((71e9, 71e9 / 2.66))


def test_seen_from_elsewhere() -> None:
    """Two halves, each moved to the common middle, are the whole sheet: the parallel-axis theorem."""
    half, whole = sheet(METAL, np.array(0.001)), sheet(METAL, np.array(0.002))
    both = half.seen_from(np.array(0.0005)) + half.seen_from(np.array(-0.0005))
    assert np.allclose(both.bending, whole.bending, rtol=1e-12)
    assert np.allclose(both.coupling, 0, atol=1e-9)

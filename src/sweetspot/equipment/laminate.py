"""Laminates: plies of fibre-reinforced material, one on the other, each with its own angle.

Stiffness of thin sheets and laminates: classical laminate theory.

Coordinates are (axial, hoop, shear) with the engineering shear strain; z points outwards from the middle surface.
Forces and moments per width follow from strain and curvature of that surface:
N = A strain + B curvature, M = B strain + D curvature [jones1999].
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cache
from typing import Annotated

import numpy as np
from pydantic import Field, model_validator

from sweetspot.equipment.base import Positive, Validated
from sweetspot.equipment.material import Material
from sweetspot.numerics.arrays import Array


class Ply(Validated):
    """One layer of a laminate.

    Parameters
    ----------
    material : with its longitudinal axis along the fibres.
    angle : rad from the bat's axis to the fibres, -pi/2 to pi/2; turning from axial towards hoop is positive.
    thickness : m, > 0; only its share of the laminate counts where a wall's thickness is given.
    """

    material: Material
    angle: Annotated[float, Field(ge=-math.pi / 2 - 1e-9, le=math.pi / 2 + 1e-9)] = 0.0
    thickness: Positive


class Laminate(Validated):
    """Plies bonded to each other, listed from the inside of the barrel outwards.

    Raises `InputError` when there is no ply.
    """

    plies: tuple[Ply, ...]

    @model_validator(mode="after")
    def _has_plies(self) -> Laminate:
        if not self.plies:
            raise ValueError("a laminate has no plies; give at least one with material, angle and thickness")
        return self

    @property
    def thickness(self) -> float:
        """Sum of the plies' thicknesses in m."""
        return math.fsum(ply.thickness for ply in self.plies)

    @property
    def density(self) -> float:
        """Mean density in kg/m^3, by thickness."""
        return math.fsum(ply.material.density * ply.thickness for ply in self.plies) / self.thickness


@dataclass(frozen=True)
class Plate:
    """Stiffness of a sheet about one of its surfaces, matrices of shape (..., 3, 3).

    Parameters
    ----------
    stretching : A, N/m.
    coupling : B, N.
    bending : D, N m.
    """

    stretching: Array
    coupling: Array
    bending: Array

    def __add__(self, other: Plate) -> Plate:
        """Return two sheets that share strain and curvature: stiffnesses add."""
        return Plate(self.stretching + other.stretching, self.coupling + other.coupling, self.bending + other.bending)

    def seen_from(self, offset: Array) -> Plate:
        """Return the stiffness about a surface from which this one lies ``offset`` m outwards.

        B' = B + e A, D' = D + 2 e B + e^2 A, with z' = z + e.
        """
        shift = np.asarray(offset)[..., None, None]
        return Plate(
            self.stretching,
            self.coupling + shift * self.stretching,
            self.bending + 2 * shift * self.coupling + shift**2 * self.stretching,
        )


@dataclass(frozen=True)
class Moduli:
    """Effective properties of a laminate as one sheet pulled along its axes, free to contract.

    Parameters
    ----------
    axial, hoop, shear : Pa.
    poisson_ratio : hoop contraction over axial stretch.
    """

    axial: float
    hoop: float
    shear: float
    poisson_ratio: float


def ply_stiffness(material: Material) -> Array:
    """Return Q of a sheet of this material in its own axes, plane stress, Pa, shape (3, 3).

    Q11 = E1 / (1 - nu12 nu21), Q22 = E2 / (1 - nu12 nu21), Q12 = nu12 Q22, Q66 = G12, nu21 = nu12 E2 / E1
    [jones1999].

    >>> from sweetspot.equipment.material import Material
    >>> metal = Material(name="metal", density=1.0, longitudinal_modulus=0.75, poisson_ratio=0.25)
    >>> bool(np.allclose(ply_stiffness(metal), [[0.8, 0.2, 0.0], [0.2, 0.8, 0.0], [0.0, 0.0, 0.3]]))
    True
    """
    along, across, poisson = material.longitudinal_modulus, material.across, material.poisson
    rest = 1 - poisson**2 * across / along  # > 0: Material refuses anything else
    both = poisson * across / rest
    return np.array([[along / rest, both, 0.0], [both, across / rest, 0.0], [0.0, 0.0, material.shear]])


def rotated(stiffness: Array, angle: float) -> Array:
    """Return Q in the bat's axes of a ply whose fibres lie at ``angle`` rad from the bat's axis.

    Q' = T Q T^t, where T turns stresses from the ply's axes to the bat's [jones1999].
    """
    c, s = math.cos(angle), math.sin(angle)
    turn = np.array([[c * c, s * s, -2 * c * s], [s * s, c * c, 2 * c * s], [c * s, -c * s, c * c - s * s]])
    return np.asarray(turn @ stiffness @ turn.T)


def sheet(material: Material, thickness: Array) -> Plate:
    """Return the stiffness of a homogeneous sheet about its middle: A = Q h, B = 0, D = Q h^3 / 12.

    Parameters
    ----------
    thickness : m, any shape; the matrices get two more axes.
    """
    stiffness, height = ply_stiffness(material), np.asarray(thickness)[..., None, None]
    return Plate(stiffness * height, np.zeros_like(stiffness * height), stiffness * height**3 / 12)


def laminate_stiffness(laminate: Laminate, thickness: Array | float | None = None) -> Plate:
    """Return the stiffness of a laminate about its middle surface, plies scaled to a total thickness.

    A = sum Q' (z2 - z1), B = sum Q' (z2^2 - z1^2) / 2, D = sum Q' (z2^3 - z1^3) / 3 [jones1999].

    Parameters
    ----------
    thickness : m, any shape; None: the plies' own thicknesses.
    """
    unit = _unit_laminate(laminate)
    height = np.asarray(laminate.thickness if thickness is None else thickness)[..., None, None]
    return Plate(unit.stretching * height, unit.coupling * height**2, unit.bending * height**3)


def effective_moduli(laminate: Laminate) -> Moduli:
    """Return the in-plane moduli of a laminate from the inverse a of A: E = 1 / (h a11), G = 1 / (h a66).

    A round tube cannot curl, so its coupling B is left out; shear that goes with stretching in an unbalanced
    laminate is free, as in a tube that may twist.
    """
    inverse = np.linalg.inv(_unit_laminate(laminate).stretching)
    return Moduli(
        axial=float(1 / inverse[0, 0]),
        hoop=float(1 / inverse[1, 1]),
        shear=float(1 / inverse[2, 2]),
        poisson_ratio=float(-inverse[0, 1] / inverse[0, 0]),
    )


@cache
def _unit_laminate(laminate: Laminate) -> Plate:
    """Return the stiffness of a laminate scaled to a thickness of 1 m."""
    edges = np.cumsum([0.0, *(ply.thickness for ply in laminate.plies)]) / laminate.thickness - 0.5
    turned = np.array([rotated(ply_stiffness(ply.material), ply.angle) for ply in laminate.plies])

    def summed(power: int) -> Array:
        return np.asarray(np.einsum("p,pij->ij", np.diff(edges**power) / power, turned))

    return Plate(summed(1), summed(2), summed(3))

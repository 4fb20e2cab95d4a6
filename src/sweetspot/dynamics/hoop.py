"""Hoop modes of a hollow barrel: a thin shell of revolution, one circumferential harmonic at a time.

For harmonic n the wall moves by u = U(x) cos(n theta) along the bat, v = V(x) sin(n theta) around it and
w = W(x) cos(n theta) outwards, theta measured from where the ball hits. Sanders' strains of a cylinder of the local
radius R(x) [sanders1959]:

    e_x = U', e_t = (n V + W) / R, g = V' - n U / R,
    k_x = -W'', k_t = (n^2 W + n V) / R^2, k_xt = (2 n W' + 3/2 V' + n U / (2 R)) / R.

The slope of the taper is left out, as is rotary inertia of the wall.
"""

from __future__ import annotations

import logging
from functools import cache
from typing import Any

import numpy as np
from scipy.interpolate import CubicHermiteSpline, CubicSpline, PPoly
from skfem import Basis, ElementLineHermite, ElementLinePp, MeshLine

from sweetspot.dynamics.beam import BeamModel, line_of_bat
from sweetspot.dynamics.modes import Family, Modes
from sweetspot.dynamics.wall import wall_stiffness
from sweetspot.equipment.ball import Ball
from sweetspot.numerics.arrays import Array
from sweetspot.numerics.eigen import lowest

HARMONICS = (2, 3, 4, 5)
AXIAL_MODES = 6
"""Modes kept per harmonic, lowest first."""
ELEMENTS = 24
STIFF_TAPER = 0.5
"""Part of the barrel's radius at which the shell counts as held round: there it rings four times as high."""
PATCH_SPEED = 60.0
"""m/s, the wall speed whose contact patch stands for all hits at game speed."""
PATCH_COMPRESSION = 0.75
"""Part of the peak compression at which the patch is taken: about the force-weighted mean."""
GRID = 161
EVEN_PART = np.ones((6, 6))
EVEN_PART[np.ix_([0, 1, 3, 4], [2, 5])] = EVEN_PART[np.ix_([2, 5], [0, 1, 3, 4])] = 0
"""Leaves out what couples stretching to shear: it would mix cos and sin of one harmonic. Zero for balanced walls."""


def contact_patch(ball: Ball) -> float:
    """Return the radius in m of the round patch through which the ball pushes, a = sqrt(R u) (Hertz).

    u is `PATCH_COMPRESSION` of the peak compression on a rigid wall at `PATCH_SPEED`.
    """
    energy = ball.mass * PATCH_SPEED**2 / 2
    peak = ((ball.exponent + 1) * energy / ball.stiffness) ** (1 / (ball.exponent + 1))
    return float(np.sqrt(ball.radius * PATCH_COMPRESSION * peak))


def patch_mean(wave_number: float, patch: float) -> float:
    """Return the mean of cos(k y) under a round Hertz patch of radius a: 3 (sin ka - ka cos ka) / (ka)^3.

    1 for long waves, near 0 for waves shorter than the patch: short waves do not feel the push.
    """
    phase = wave_number * patch
    if phase < 1e-2:
        return 1 - phase**2 / 10
    return float(3 * (np.sin(phase) - phase * np.cos(phase)) / phase**3)


def patch_mean_around(line: BeamModel, *, harmonic: int, patch: float) -> float:
    """Return the mean of cos(n theta) under the ball: what a hoop mode's shape holds of the wall's own motion there."""
    return patch_mean(harmonic / _barrel_radius(line), patch)


def hoop_modes(
    line: BeamModel,
    *,
    patch: float,
    harmonics: tuple[int, ...] = HARMONICS,
    axial_modes: int = AXIAL_MODES,
    elements: int = ELEMENTS,
) -> Modes:
    """Return the hoop modes of a hollow bat's barrel, with shapes averaged over the ball's patch.

    Parameters
    ----------
    line : a bat with a shell.
    patch : radius in m of the contact patch, > 0 (`contact_patch`).
    harmonics : circumferential harmonics, each >= 2; 0 and 1 are breathing and bending.
    axial_modes : modes kept per harmonic.
    elements : finite elements from the taper to the tip.

    Notes
    -----
    An end cap holds the tip round (w = v = 0): a plug's stiffness in its plane is tens of times the wall's. Without
    a cap the tip is free. At the handle's end the taper holds it round. Damping is the material's ratio.
    """
    start, end = barrel_range(line)
    mesh = MeshLine(np.linspace(start, end, elements + 1))
    found = [_one_harmonic(line, mesh, n, axial_modes, capped=is_capped(line)) for n in harmonics]
    return felt_by_ball(line, found, patch=patch, harmonics=harmonics)


def felt_by_ball(
    line: BeamModel, found: list[tuple[Array, CubicHermiteSpline]], *, patch: float, harmonics: tuple[int, ...]
) -> Modes:
    """Return modes of the wall as the ball feels them through its patch, in rising order.

    Parameters
    ----------
    found : for every harmonic omega^2 (count,) and the mass-normalised outward shapes W(x), one column per mode.
    """
    start, end = barrel_range(line)
    omega = np.sqrt(np.concatenate([squares for squares, _ in found]))
    grid = np.linspace(start, end, GRID)
    together = np.concatenate([shape.c for _, shape in found], axis=2)
    radius, counts = _barrel_radius(line), [len(squares) for squares, _ in found]
    felt_around = np.repeat([patch_mean(n / radius, patch) for n in harmonics], counts)
    shapes = _felt(grid, PPoly.construct_fast(together, found[0][1].x), patch) * felt_around
    count = len(omega)
    order = np.argsort(omega)
    families: list[Family] = ["hoop"] * count
    numbers = np.repeat(harmonics, counts)[order]
    return Modes(
        families=tuple(families),
        harmonics=tuple(int(number) for number in numbers),
        frequency=omega[order] / (2 * np.pi),
        damping_rate=2 * line.bat.damping_ratio * omega[order],
        shapes=_over_the_whole_bat(grid, shapes[:, order], line.bat.length),
        rigid_part=np.zeros((2, count)),
        dashpots=np.zeros((0, count)),
    )


def barrel_range(line: BeamModel) -> tuple[float, float]:
    """Return (start, end) in m of the part of a hollow bat that can ring in hoop modes."""
    bat = line_of_bat(line)
    places = np.linspace(0, bat.length, 2001)
    beyond_knob = places > bat.length / 4
    wide = bat.diameter_at(places) / 2 >= STIFF_TAPER * _barrel_radius(line)
    return float(places[beyond_knob & wide][0]), bat.length


def _barrel_radius(line: BeamModel) -> float:
    bat = line_of_bat(line)
    return float(np.max(bat.diameter_at(np.linspace(bat.length / 2, bat.length, 401)))) / 2


def is_capped(line: BeamModel) -> bool:
    """Return whether an end cap holds the tip round."""
    shell = line_of_bat(line).shell
    return shell is not None and shell.end_cap_mass > 0


def _one_harmonic(line: BeamModel, mesh: Any, n: int, count: int, *, capped: bool) -> tuple[Array, CubicHermiteSpline]:
    """Return omega^2 (count,) and the mass-normalised outward shapes W(x), one column per mode."""
    logging.getLogger("skfem").setLevel(logging.ERROR)  # its hint about faster low orders does not apply here
    outward = Basis(mesh, ElementLineHermite(), intorder=8)  # a new one each time: it remembers its mesh
    plane = Basis(mesh, ElementLinePp(3), quadrature=outward.quadrature)
    place = outward.global_coordinates()[0]
    wall = wall_stiffness(line, place)
    strain, motion = _strain(plane, outward, wall.mean_radius, n), _motion(plane, outward)
    law = np.block([[wall.stretching, wall.coupling], [wall.coupling, wall.bending]]) * EVEN_PART
    weight = np.pi * wall.mean_radius * outward.dx
    stress = np.einsum("eqab,bjeq->ajeq", law * weight[..., None, None], strain)
    stiffness = np.einsum("aieq,ajeq->eij", strain, stress, optimize=True)
    inertia = np.einsum("aieq,ajeq->eij", motion, motion * (weight * wall.mass_per_area), optimize=True)
    dofs = np.concatenate([plane.element_dofs, plane.element_dofs + plane.N, outward.element_dofs + 2 * plane.N]).T
    free = _free_dofs(plane, outward, capped=capped)
    squares, vectors = lowest(
        _assembled(stiffness, dofs)[np.ix_(free, free)], _assembled(inertia, dofs)[np.ix_(free, free)],
        first=0, last=count - 1,
    )  # fmt: skip
    full = np.zeros((dofs.max() + 1, count))
    full[free] = vectors
    values, slopes = (full[2 * plane.N + nodal] for nodal in outward.nodal_dofs)
    return squares, CubicHermiteSpline(mesh.p[0], values, slopes)


def _strain(plane: Any, outward: Any, radius: Array, n: int) -> Array:
    """Return each basis function's six strains, shape (6, functions, elements, points)."""
    p, p1 = (np.array([part(f[0]) for f in plane.basis]) for part in (_value, _slope))
    w, w1, w2 = (np.array([part(f[0]) for f in outward.basis]) for part in (_value, _slope, _bend))
    zero = np.zeros_like(p)
    of_u = [p1, zero, -n * p / radius, zero, zero, n * p / (2 * radius**2)]
    of_v = [zero, n * p / radius, p1, zero, n * p / radius**2, 1.5 * p1 / radius]
    of_w = [np.zeros_like(w), w / radius, np.zeros_like(w), -w2, n**2 * w / radius**2, 2 * n * w1 / radius]
    return np.array([np.concatenate(fields) for fields in zip(of_u, of_v, of_w, strict=True)])


def _motion(plane: Any, outward: Any) -> Array:
    """Return each basis function's displacements (u, v, w), shape (3, functions, elements, points)."""
    p, w = (np.array([_value(f[0]) for f in basis.basis]) for basis in (plane, outward))
    motion = np.zeros((3, 2 * len(p) + len(w), *p.shape[1:]))
    motion[0, : len(p)], motion[1, len(p) : 2 * len(p)], motion[2, 2 * len(p) :] = p, p, w
    return motion


def _value(field: Any) -> Array:
    return np.asarray(field)


def _slope(field: Any) -> Array:
    return np.asarray(field.grad[0])


def _bend(field: Any) -> Array:
    return np.asarray(field.hess[0][0])


def _assembled(local: Array, dofs: Any) -> Array:
    matrix = np.zeros((dofs.max() + 1, dofs.max() + 1))
    np.add.at(matrix, (dofs[:, :, None], dofs[:, None, :]), local)
    return matrix


def _free_dofs(plane: Any, outward: Any, *, capped: bool) -> Any:
    """Return the degrees of freedom left when v and w are held at the taper and, with a cap, at the tip."""
    nodes = [0, -1] if capped else [0]
    held = [plane.N + plane.nodal_dofs[0][nodes], 2 * plane.N + outward.nodal_dofs[0][nodes]]
    return np.setdiff1d(np.arange(2 * plane.N + outward.N), np.concatenate(held))


@cache
def _felt_rule() -> tuple[Array, Array]:
    nodes, weights = np.polynomial.legendre.leggauss(8)
    return nodes, weights


def _felt(grid: Array, shape: PPoly, patch: float) -> Array:
    """Return shapes averaged along the bat over the patch, with weight 1 - (s / a)^2, cut off at the tip."""
    nodes, weights = _felt_rule()
    weights = weights * (1 - nodes**2)
    places = np.clip(grid[:, None] + patch * nodes, grid[0], grid[-1])
    return np.asarray(np.einsum("gnm,n->gm", shape(places), weights / weights.sum()))


def _over_the_whole_bat(grid: Array, shapes: Array, length: float) -> PPoly:
    """Return the shapes as polynomials from the knob to the tip, zero before the taper."""
    spline = CubicSpline(grid, shapes)
    edges = np.concatenate([[0.0], grid[:-1], [length]])
    nothing = np.zeros((4, 1, shapes.shape[1]))
    return PPoly.construct_fast(np.concatenate([nothing, spline.c], axis=1), edges)

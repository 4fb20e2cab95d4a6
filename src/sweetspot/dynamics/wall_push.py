"""The ball's patch pushing on a barrel's wall: what its pressure does in every harmonic of the way around.

Every part of the patch is pushed along the ball's path: outwards by cos(theta) and around by -sin(theta).
"""

from __future__ import annotations

import numpy as np

from sweetspot.dynamics.beam import bat_of_beam
from sweetspot.dynamics.shell_elements import ShellElements, outward_functions, plane_functions
from sweetspot.dynamics.shell_kernel import Pushes
from sweetspot.dynamics.wall import wall_stiffness
from sweetspot.numerics.arrays import Array

NODES, WEIGHTS = np.polynomial.legendre.leggauss(12)
"""Where along the bat, from -1 to 1 of the patch's radius, it pushes."""


def wall_pushes(shell: ShellElements, places: Array, radii: Array) -> Pushes:
    """Return pushes of 1 N through round patches at places, one after the other for every radius.

    Parameters
    ----------
    places : m from the knob end, shape (places,).
    radii : of the patch, m, shape (radii,).
    """
    outer = np.asarray(bat_of_beam(shell.beam).diameter_at(places)) / 2
    middle = wall_stiffness(shell.beam, places).mean_radius
    lift = ((outer - middle) / middle)[:, None]
    point = np.clip(places[:, None] + radii[:, None, None] * NODES, shell.edges[0], shell.edges[-1])
    element = np.clip(np.searchsorted(shell.edges, point, side="right") - 1, 0, len(shell.edges) - 2)
    size = np.diff(shell.edges)[element]
    t = (point - shell.edges[element]) / size
    orders = np.unique(np.concatenate([shell.harmonics - 1, shell.harmonics + 1]))
    span = radii[:, None] * np.sqrt(1 - NODES[len(NODES) // 2 :] ** 2)  # as wide before the patch's middle as after it
    waves = orders[:, None, None, None] / outer[:, None]
    weights = WEIGHTS[len(NODES) // 2 :] * radii[:, None, None]
    across = weights * _across(waves, span[:, None, :], radii[:, None, None])
    before, after = (across[np.searchsorted(orders, shell.harmonics + side)] for side in (-1, 1))
    around, n = (after - before) / 2, shell.harmonics[:, None, None, None]
    outwards = (before + after) / 2 + around * n * lift
    points, forces = (-1, len(NODES)), (len(shell.harmonics), -1, len(NODES))

    def mirrored(force: Array) -> Array:
        return np.concatenate([force[..., ::-1], force], axis=-1).reshape(forces)

    return Pushes(
        element.reshape(points),
        plane_functions(t).reshape(*points, 4),
        outward_functions(t, size).reshape(*points, 4),
        mirrored(around * (1 + lift)),
        mirrored(outwards),
    )


def _across(wave: Array, span: Array, radius: Array) -> Array:
    """Return the integral of a Hertz pressure of 1 N across the bat times cos(q y), N/m.

    3 / (2 pi a^3) int sqrt(c^2 - y^2) cos(q y) dy = 3 c J_1(q c) / (2 a^3 q), with c the half width there.

    Parameters
    ----------
    wave : q in 1/m.
    span : c in m.
    radius : a in m.
    """
    from scipy.special import j1  # here: only hollow barrels need it

    phase = wave * span
    ratio = np.where(phase < 1e-6, 0.5, j1(phase) / np.where(phase < 1e-6, 1.0, phase))
    return np.asarray(1.5 / radius**3 * span**2 * ratio)

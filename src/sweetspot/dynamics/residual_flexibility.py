"""Static compliance of a freely hung beam, and the residual of it that a few modes leave out.

A push on a free beam speeds it up as a rigid body; the forces of inertia balance the push, and between them the beam is
bent and sheared. Bending moment B and shear force V follow from equilibrium alone, so the compliance at x is exactly

    G(x) = int B^2 / EI + V^2 / (kappa G A) over the beam, for a push of 1 N at x,

which is the sum of s_i(x)^2 / omega_i^2 over all its modes. The modes beyond those that are followed in time are faster
than any push by a ball: they deflect without delay, by the rest of G (static correction, or residual flexibility).
"""

from __future__ import annotations

import numpy as np

from sweetspot.numerics.arrays import Array, IntArray
from sweetspot.numerics.piecewise import Piecewise, cubic_spline

CELLS = 1440
"""Finest slices of the beam; the error of what twelve modes leave out is then below 1 % on the barrel of a wood bat."""
PLACES = 121
JUST_INSIDE = 1e-6
"""Part of a piece's width from its ends at which its stiffness is asked, as sections may jump there."""
JOINT = 2.0
"""By what factor bending stiffness must jump for a joint: there, where a club's shaft enters its head, the compliance
has a corner, and one smooth curve past it was wrong by three quarters at the edge of the face, and q by 8e-4."""
LEAST = 4
"""Places at least on either side of a joint, as many as a cubic has coefficients."""


def extrapolated(fine: Array, coarse: Array) -> Array:
    """Return the limit of sums over ever more slices (Richardson), from those over some and over half as many."""
    return (4 * fine - coarse) / 3


def just_inside(left: Array, width: Array) -> Array:
    """Return places in m next to the left and the right ends of pieces, shape (2, pieces)."""
    return np.asarray(left + width * np.array([[JUST_INSIDE], [1 - JUST_INSIDE]]))


def joints(left: Array, bending_stiffness: Array, owner: IntArray, *, beams: int) -> Array:
    """Return the place of each beam's largest jump in bending stiffness, m from the knob end; nan: no joint (`JOINT`).

    Parameters
    ----------
    left : where every piece begins, m, beam after beam, shape (pieces,).
    bending_stiffness : EI in N m^2 at their left and their right ends, shape (2, pieces).
    owner : whose every piece is, shape (pieces,).

    >>> joints(np.array([0.0, 0.3, 0.6]), np.array([[1.0, 1.1, 9.0], [1.0, 1.1, 9.0]]), np.zeros(3, int), beams=1)
    array([0.6])
    """
    jump = np.abs(np.log(bending_stiffness[0, 1:] / bending_stiffness[1, :-1]))
    jumps_at = np.flatnonzero((owner[1:] == owner[:-1]) & (jump > np.log(JOINT)))
    where = np.full(beams, np.nan)
    for piece in jumps_at[np.argsort(jump[jumps_at], kind="stable")]:  # the largest last
        where[owner[piece]] = left[piece + 1]
    return where


def sample_places(length: Array, joint: Array) -> tuple[Array, IntArray]:
    """Return the `PLACES` at which beams are asked, m, shape (beams, places), and which of them is a joint's; 0: none.

    They are even from end to end, or from either end to the joint.

    Parameters
    ----------
    length, joint : m, shape (beams,); nan for no joint.
    """
    parts = np.linspace(0.0, 1.0, PLACES)
    places, corner = length[:, None] * parts, np.zeros(len(length), np.int64)
    for beam in np.flatnonzero(np.isfinite(joint)):
        nearest = round(float(joint[beam] / length[beam]) * (PLACES - 1))
        corner[beam] = min(max(nearest, LEAST - 1), PLACES - LEAST)
        places[beam] = np.interp(parts, [0.0, parts[corner[beam]], 1.0], [0.0, joint[beam], length[beam]])
    return places, corner


def with_corner(places: Array, values: Array, corner: int) -> Piecewise:
    """Return the cubic spline through points, or two that meet at the one with the number ``corner`` above 0."""
    if corner == 0:
        return cubic_spline(places, values)
    sides = [cubic_spline(places[side], values[side]) for side in (slice(corner + 1), slice(corner, None))]
    return Piecewise(np.concatenate([side.coefficients for side in sides], axis=1), places)

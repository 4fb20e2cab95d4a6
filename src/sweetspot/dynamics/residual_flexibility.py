"""How far a freely hung beam gives way under a slow push, and what of that a few modes leave out.

A push on a free beam speeds it up as a rigid body; the forces of inertia balance the push, and between them the beam is
bent and sheared. Bending moment B and shear force V follow from equilibrium alone, so the compliance at x is exactly

    G(x) = int B^2 / EI + V^2 / (kappa G A) over the beam, for a push of 1 N at x,

which is the sum of s_i(x)^2 / omega_i^2 over all its modes. The modes beyond those that are followed in time are faster
than any push by a ball: they give way at once, by what is left of G (static correction, or residual flexibility).
"""

from __future__ import annotations

from itertools import pairwise

import numpy as np

from sweetspot.dynamics.beam import BeamModel, section
from sweetspot.numerics.arrays import Array
from sweetspot.numerics.piecewise import Piecewise, cubic_spline

CELLS = 1440
"""Finest slices of the beam; the error of what twelve modes leave out is then below 1 % on the barrel of a wood bat."""
PLACES = 121


def static_compliance(line: BeamModel, position: Array, *, cells: int = CELLS) -> Array:
    """Return G in m/N at positions in m: displacement under a slow push there, rigid motion left out.

    Parameters
    ----------
    position : m from the knob end, shape (n,).
    cells : slices at least, >= 2. The error of the sums over slices falls with their square, so what half as many
        give tells most of it (Richardson's extrapolation).
    """
    fine, coarse = (_sliced(line, position, cells=number) for number in (cells, cells // 2))
    return extrapolated(fine, coarse)


def extrapolated(fine: Array, coarse: Array) -> Array:
    """Return what sums over endlessly many slices would be, from those over some and over half as many."""
    return (4 * fine - coarse) / 3


def _sliced(line: BeamModel, position: Array, *, cells: int) -> Array:
    """Return sums over slices for `static_compliance`."""
    given = np.asarray(position, float)
    edges = np.union1d(_edges(line.bat.breakpoints(), line.bat.length / cells), given)
    middle, width = (edges[1:] + edges[:-1]) / 2, np.diff(edges)
    at = section(line, middle)
    lumps = np.array([(lump.position, lump.mass, lump.moi) for lump in line.point_masses]).reshape(-1, 3)
    # of the sections themselves, so that push and inertia balance exactly
    mass = float(at.mass @ width + lumps[:, 1].sum())
    centre = float((at.mass * middle) @ width + lumps[:, 0] @ lumps[:, 1]) / mass

    def before(per_slice: Array, of_lumps: Array) -> Array:
        """Return the integral from the knob to the middle of each slice, with the point masses passed."""
        whole = per_slice * width
        return np.asarray(np.cumsum(whole) - whole / 2 + (lumps[:, 0] <= middle[:, None]) @ of_lumps)

    arm, lump_arm = middle - centre, lumps[:, 0] - centre
    inertia = before(at.mass, lumps[:, 1])
    moment = before(at.mass * arm, lumps[:, 1] * lump_arm)
    spread, lump_spread = (
        at.mass * (arm**2 + width**2 / 12) + at.rotary_inertia, lumps[:, 1] * lump_arm**2 + lumps[:, 2],
    )  # fmt: skip
    turning, moi = before(spread, lump_spread), float(spread @ width + lump_spread.sum())
    places = given[:, None]
    beyond = places < middle
    turn = (places - centre) / moi
    shear = beyond - inertia / mass - moment * turn
    bending = beyond * (places - middle) - (moment - arm * inertia) / mass - (turning - arm * moment) * turn
    return np.asarray((bending**2 / at.bending_stiffness + shear**2 / at.shear_stiffness) @ width)


def left_out(line: BeamModel, *, shapes: Piecewise, omega: Array, softening: float = 1.0) -> Piecewise:
    """Return the compliance in m/N by position that elastic modes leave out: G - sum_i s_i^2 / omega_i^2.

    Parameters
    ----------
    shapes, omega : of the modes that are kept, without the rigid motions, 1/sqrt(kg) and rad/s.
    softening : factor on G for a beam whose stiffness was scaled by its inverse.
    """
    places = np.linspace(0.0, line.bat.length, PLACES)
    kept = np.asarray(shapes(places)) ** 2 @ omega**-2.0
    return cubic_spline(places, softening * static_compliance(line, places) - kept)


def _edges(breakpoints: tuple[float, ...], size: float) -> Array:
    """Return every breakpoint and between them equal slices no longer than ``size``."""
    parts = [max(1, int(np.ceil((right - left) / size))) for left, right in pairwise(breakpoints)]
    pieces = [np.linspace(*ends, count + 1)[1:] for ends, count in zip(pairwise(breakpoints), parts, strict=True)]
    return np.concatenate([[breakpoints[0]], *pieces])

"""A bat's tabled hits, looked up: the compiled loops of `contact_table`."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from sweetspot.collision.oblique_contact import SPHERE
from sweetspot.numerics.arrays import Array
from sweetspot.numerics.kernel_cache import compiled, inner

TERMS = (5, 6)
"""Of a cell's polynomial, along the barrel and in the root of the closing speed."""
ALONG, RISING = TERMS
UNSCALED = {"contract", "nsz"}


class Lookup(NamedTuple):
    """A bat's table as the loops read it.

    Cells are `PIECES` equal pieces of the barrel from the tip times bands of the root of the closing speed; in a cell
    place and root go from -1 to 1.

    Parameters
    ----------
    efficiency : coefficients of the collision efficiency q, shape (pieces, bands, 5, 6).
    give : of the bat's own mobilities, normal, around and tilting (`spring_mobilities`), shape (pieces, bands, 3,
        5, 6).
    certified : whether a cell is used, shape (pieces, bands).
    per_metre : pieces in a metre of the barrel.
    roots : ends of the bands, sqrt(m/s).
    length : of the bat, m.
    stations, radii : m from the knob end and m.
    ball_mass, ball_radius : kg and m.
    per_mass, per_moi, per_roll : of the rigid bat, 1/kg and 1/(kg m^2), about its centre and its axis.
    """

    efficiency: Array
    give: Array
    certified: NDArray[np.bool_]
    per_metre: float
    roots: tuple[float, float, float, float]
    length: float
    stations: Array
    radii: Array
    ball_mass: float
    ball_radius: float
    per_mass: float
    per_moi: float
    per_roll: float


@compiled(nogil=True, error_model="numpy", fastmath=UNSCALED, _nrt=False)
def fill_efficiency(table: Lookup, from_tip: Array, closing: Array, efficiency: Array, left: NDArray[np.bool_]) -> None:
    """Fill the collision efficiencies of n hits, and which of them are left to the kernel.

    ``from_tip``, ``closing``: m and m/s, shape (n,); where ball and bat do not meet there is no efficiency.
    """
    for row in range(len(from_tip)):
        efficiency[row], left[row] = math.nan, False
        if closing[row] > 0:
            piece, band, place, root = cell_of(table, from_tip[row], closing[row])
            if piece < 0:
                left[row] = True
            else:
                efficiency[row] = value_of(table.efficiency[piece, band], place, root)


@inner(forceinline=True, error_model="numpy", fastmath=UNSCALED, _nrt=False)
def cell_of(table: Lookup, from_tip: float, closing: float) -> tuple[int, int, float, float]:
    """Return piece and band of a hit, -1 where the table does not answer, and place and root in the cell, -1 to 1."""
    at = from_tip * table.per_metre
    root = math.sqrt(closing)
    if not (0.0 <= at <= len(table.certified) and table.roots[0] <= root <= table.roots[3]):
        return -1, 0, 0.0, 0.0
    piece = min(int(at), len(table.certified) - 1)
    band, within = band_of(table.roots, root)
    if not table.certified[piece, band]:
        return -1, 0, 0.0, 0.0
    return piece, band, 2.0 * (at - piece) - 1.0, within


@inner(forceinline=True, error_model="numpy", fastmath=UNSCALED, _nrt=False)
def band_of(roots: tuple[float, float, float, float], root: float) -> tuple[int, float]:
    """Return the band in which a root of a closing speed lies, and where in it, -1 to 1."""
    first, second, third, fourth = roots
    band = int(root > second) + int(root > third)
    low = first if band == 0 else second if band == 1 else third
    high = second if band == 0 else third if band == 1 else fourth
    return band, (2.0 * root - low - high) / (high - low)


@inner(forceinline=True, error_model="numpy", fastmath=UNSCALED, _nrt=False)
def value_of(terms: Array, place: float, root: float) -> float:
    """Return a cell's polynomial, coefficients of shape `TERMS`, by Horner's rule."""
    total = 0.0
    for row in range(ALONG):  # a loop that counts downwards is not unrolled
        i = ALONG - 1 - row
        inside = terms[i, RISING - 1]
        for column in range(RISING - 1):
            inside = inside * root + terms[i, RISING - 2 - column]
        total = total * place + inside
    return total


@inner(forceinline=True, error_model="numpy", fastmath=UNSCALED, _nrt=False)
def rubbed(
    slips: tuple[float, float],
    give: tuple[float, float, float, float],
    ball_mass: float,
    before: float,
    friction: tuple[float, float],
) -> tuple[float, float, float]:
    """Return the impulses in N s along the line of centres, around the bat and along it of one hit with friction.

    `oblique_contact.contact_impulses`, plain arithmetic.

    ``slips``: m/s of the bat's surface past the ball, around and along. ``give``: normal, around, along and coupling
    of a `SurfaceMobility`. ``before``: N s without friction. ``friction``: its coefficient, and 1 + e_x.
    """
    limit, returned = friction
    sphere = (1 + 1 / SPHERE) / ball_mass
    raised = give[3] / (1 / ball_mass + give[0])
    around = returned * slips[0] / (sphere + give[1])
    along = (returned * slips[1] + give[3] * before) / (sphere + give[2] - give[3] * raised)
    push, size = before + raised * along, math.sqrt(around * around + along * along)
    if size > limit * push:
        push = before / (1 - limit * raised * along / size)
        part = limit * push / size
        return push, around * part, along * part
    return push, around, along


@inner(error_model="numpy", _nrt=False)
def radius_at(table: Lookup, place: float) -> float:
    """Return the bat's radius at a place in m from the knob end, m."""
    low, high = 0, len(table.stations) - 1
    while high - low > 1:
        middle = (low + high) // 2
        if table.stations[middle] <= place:
            low = middle
        else:
            high = middle
    part = (place - table.stations[low]) / (table.stations[high] - table.stations[low])
    part = min(max(part, 0.0), 1.0)
    return float(table.radii[low] + part * (table.radii[high] - table.radii[low]))


@compiled(nogil=True, error_model="numpy", fastmath=UNSCALED, _nrt=False)
def fill_launches(
    table: Lookup,
    hits: tuple[Array, Array, Array, float],
    vectors: tuple[Array, Array, Array, Array, Array],
    friction: tuple[float, float],
    filled: tuple[Array, Array, NDArray[np.bool_]],
) -> None:
    """Fill velocity and spin of n balls after the hit (`hit_in_space.strikes`), and which are left to the kernel.

    ``hits``: bat speed at the contact (m/s), place (m from the knob end), offset (m), shape (n,); and the pivot, m.
    ``vectors``: the swing's directions forward, up and to the tip, the ball's velocity and spin, shape (n, 3).
    ``friction``: its coefficient, and 1 + e_x. ``filled``: m/s and rad/s, shape (n, 3), nan without a hit; and left.
    """
    speeds, places, offsets, pivot = hits
    forwards, ups, tips, comings, spins = vectors
    velocity, spin, left = filled
    for row in range(len(speeds)):
        left[row] = False
        for axis in range(3):
            velocity[row, axis] = spin[row, axis] = math.nan
        radius = radius_at(table, places[row])
        reach = table.ball_radius + radius
        sine = offsets[row] / reach
        if not abs(sine) < 1:
            continue
        cosine = math.sqrt(1 - sine * sine)
        fx, fy, fz = forwards[row, 0], forwards[row, 1], forwards[row, 2]
        ux, uy, uz = ups[row, 0], ups[row, 1], ups[row, 2]
        tx, ty, tz = tips[row, 0], tips[row, 1], tips[row, 2]
        nx, ny, nz = cosine * fx + sine * ux, cosine * fy + sine * uy, cosine * fz + sine * uz
        ax, ay, az = cosine * ux - sine * fx, cosine * uy - sine * fy, cosine * uz - sine * fz
        vx, vy, vz = comings[row, 0], comings[row, 1], comings[row, 2]
        there = speeds[row]
        sx, sy, sz = there * fx - vx, there * fy - vy, there * fz - vz
        closing = sx * nx + sy * ny + sz * nz
        if not closing > 0:
            continue
        piece, band, place, root = cell_of(table, table.length - places[row], closing)
        if piece < 0:
            left[row] = True
            continue
        before = table.ball_mass * closing * (1 + value_of(table.efficiency[piece, band], place, root))
        normal = value_of(table.give[piece, band, 0], place, root)
        around = value_of(table.give[piece, band, 1], place, root)
        tilting = value_of(table.give[piece, band, 2], place, root)
        give = (
            normal,
            around + radius * radius * table.per_roll,
            table.per_mass + radius * radius * table.per_moi,
            radius * tilting,
        )
        arm = places[row] - pivot
        turning = there / arm * radius if arm > 0 else 0.0
        kx, ky, kz = ty * fz - tz * fy, tz * fx - tx * fz, tx * fy - ty * fx  # axis that the swing turns about
        wx, wy, wz = spins[row, 0], spins[row, 1], spins[row, 2]
        size = table.ball_radius
        # the bat's surface past the ball's, which turns by omega x (-r n)
        px = sx + turning * (ky * nz - kz * ny) + size * (wy * nz - wz * ny)
        py = sy + turning * (kz * nx - kx * nz) + size * (wz * nx - wx * nz)
        pz = sz + turning * (kx * ny - ky * nx) + size * (wx * ny - wy * nx)
        slips = (px * ax + py * ay + pz * az, px * tx + py * ty + pz * tz)
        push, swept, dragged = rubbed(slips, give, table.ball_mass, before, friction)
        gx, gy, gz = swept * ax + dragged * tx, swept * ay + dragged * ty, swept * az + dragged * tz
        velocity[row, 0] = vx + (push * nx + gx) / table.ball_mass
        velocity[row, 1] = vy + (push * ny + gy) / table.ball_mass
        velocity[row, 2] = vz + (push * nz + gz) / table.ball_mass
        turn = -size / (SPHERE * table.ball_mass * size * size)
        spin[row, 0] = wx + turn * (ny * gz - nz * gy)
        spin[row, 1] = wy + turn * (nz * gx - nx * gz)
        spin[row, 2] = wz + turn * (nx * gy - ny * gx)

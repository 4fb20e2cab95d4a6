"""Hoop modes of a hollow barrel, felt through the ball's patch, and what of the wall's give they leave out.

Compliance of a hollow barrel as a breathing and as a shifted ring: harmonics 0 and 1 of a long tube.

Both die out within a centimetre or two, so the barrel counts as a long tube of the local wall: one wave along it,
cos(k x), at a time, Sanders' strains, integrated over k. Of harmonic 1 the tube as a beam is taken away, which the
bending modes hold: with the pressure's transform P and the tube's bending and shear compliances B and S for slow waves

    c = (1/pi) int_0^inf (h_0(k) + h_1(k) - P(0, k)^2 (B / k^4 + S / k^2)) dk - K,

K being the deficit of a beam's compliance under the patch from that at one point, as in `local_compliance`.

The ball's patch pushing on a barrel's wall: what its pressure does in every harmonic of the way around.

Every part of the patch is pushed along the ball's path: outwards by cos(theta) and around by -sin(theta).
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.polynomial.legendre import leggauss

from sweetspot.dynamics.beam import BeamModel, bat_of_beam
from sweetspot.dynamics.local_compliance import blunting
from sweetspot.dynamics.modes import Family, Modes, Surface
from sweetspot.dynamics.patch import ByPatch, PatchLaw, transform
from sweetspot.dynamics.shell_elements import (
    EVEN_PART,
    Pushes,
    ShellElements,
    Solved,
    barrel_elements,
    outward_functions,
    plane_functions,
    solved_walls,
)
from sweetspot.dynamics.wall import WallSection, wall_stiffness
from sweetspot.errors import InputError
from sweetspot.numerics.arrays import Array
from sweetspot.numerics.piecewise import Piecewise, cubic_spline
from sweetspot.numerics.special import bessel_j1
from sweetspot.units import INCH

SLOWEST = 0.12
"""k R below which the tube is a beam."""
EDGES = np.concatenate([np.linspace(SLOWEST, 1.0, 6), np.linspace(1.5, 14.0, 16)])
"""k R between which the integral is taken piece by piece; beyond them the patch no longer pushes."""
GAUSS = leggauss(8)
SLOWER = 0.02
"""k R at which the tube's bending compliance is read off."""


def local_compliance(wall: WallSection, *, outer: Array, radii: Array) -> Array:
    """Return c in m/N at the places of a wall under patches, shape (places, radii).

    Parameters
    ----------
    outer : radius of the outside there, m, shape (places,).
    radii : of the ball's contact, m, > 0, shape (radii,).
    """
    law = _law(wall)
    middle = wall.mean_radius[:, None]
    waves, weights = _waves(middle)
    bending, shearing = _beam(law, middle, outer[:, None])
    tube = sum(work(law, waves, middle, outer[:, None], radii) for work in (_breathing, _shifting))
    beam = transform(radii[:, None, None] * waves) ** 2 * (bending / waves**4 + shearing / waves**2)
    blunt = blunting(radii, bending=bending, shearing=shearing)
    return np.asarray(np.sum((tube - beam) * weights, axis=-1).T / np.pi - blunt)


def _law(wall: WallSection) -> Array:
    """Return the stiffness of a wall against its six strains, shape (places, 6, 6)."""
    return np.block([[wall.stretching, wall.coupling], [wall.coupling, wall.bending]]) * EVEN_PART


def _waves(middle: Array) -> tuple[Array, Array]:
    """Return waves along tubes of mean radii (places, 1) in 1/m, and the weights with which they are integrated."""
    nodes, weights = GAUSS
    half, centre = np.diff(EDGES) / 2, (EDGES[1:] + EDGES[:-1]) / 2
    waves = np.concatenate([[SLOWEST], (centre[:, None] + half[:, None] * nodes).ravel()]) / middle
    return waves, np.concatenate([[SLOWEST], (half[:, None] * weights).ravel()]) / middle  # constant below the slowest


def _beam(law: Array, middle: Array, outer: Array) -> tuple[Array, Array]:
    """Return B in 1/(N m^2) and S in 1/N of the tube under slow waves, pushed at a point; shapes (places, 1)."""
    slow = np.array([SLOWER, SLOWEST]) / middle
    give = _shifting(law, slow, middle, outer, np.zeros(1))[0]
    both = np.linalg.solve(np.stack([slow**-4.0, slow**-2.0], axis=-1), give[..., None])
    return both[:, 0], both[:, 1]


def _breathing(law: Array, waves: Array, middle: Array, outer: Array, radii: Array) -> Array:
    """Return the work of harmonic 0 under pressures of 1 N along the ball's path, m/N times 1/m, by wave.

    Parameters
    ----------
    law : stiffnesses of the wall, shape (places, 6, 6).
    waves : k in 1/m, shape (places, waves).
    middle, outer : radii of the wall's middle and of the outside, m, shape (places, 1).
    radii : of the patches, m, shape (radii,); the answer has shape (radii, places, waves).
    """
    strain = np.zeros((len(waves), 6, 2, waves.shape[1]))  # of (U sin kx, W cos kx); there is no twist
    strain[:, 0, 0] = waves
    strain[:, 1, 1], strain[:, 3, 1] = 1 / middle, waves**2
    outwards = transform(radii[:, None, None] * np.hypot(1 / outer, waves))
    return _work(2 * law, strain, middle, np.stack([np.zeros_like(outwards), outwards]))


def _shifting(law: Array, waves: Array, middle: Array, outer: Array, radii: Array) -> Array:
    """Return the work of harmonic 1; see `_breathing`.

    With R the middle's radius the unknowns are U + k R V, V + W and (k R)^2 W instead of U sin kx, V cos kx and
    W cos kx: a section that is only shifted, which costs nothing, is then one of them alone, and rounding does not
    drown it.
    """
    turn = waves * middle
    strain = np.zeros((len(waves), 6, 3, waves.shape[1]))
    strain[:, 0, 0], strain[:, 0, 1], strain[:, 0, 2] = waves, -waves * turn, 1 / middle
    strain[:, 1, 1], strain[:, 2, 0] = 1 / middle, -1 / middle
    strain[:, 3, 2], strain[:, 4, 1] = 1 / middle**2, 1 / middle**2
    strain[:, 5, 0], strain[:, 5, 1] = 1 / (2 * middle**2), -2 * waves / middle
    before, after = (transform(radii[:, None, None] * np.hypot(m / outer, waves)) for m in (0, 2))
    around = (after - before) / 2 * outer / middle
    return _work(law, strain, middle, np.stack([np.zeros_like(before), around, before / turn**2]))


def _work(law: Array, strain: Array, middle: Array, push: Array) -> Array:
    """Return p^T K^-1 p of a ring of wall, one unknown after the other eliminated.

    Parameters
    ----------
    strain : by unknown, shape (places, 6, unknowns, waves).
    push : by unknown, shape (unknowns, radii, places, waves).
    """
    stress = (law @ strain.reshape(*law.shape[:2], -1)).reshape(strain.shape)
    stiffness = np.einsum("piuw,pivw->uvpw", strain, stress) * np.pi * middle
    work = np.zeros(push.shape[1:])
    while len(push):
        share = stiffness[1:, 0] / stiffness[0, 0]
        work += push[0] ** 2 / stiffness[0, 0]
        push = push[1:] - share[:, None] * push[0]
        stiffness = stiffness[1:, 1:] - share[:, None] * stiffness[0, 1:]
    return work


NODES, WEIGHTS = np.polynomial.legendre.leggauss(12)
"""Places of the pushes along the bat, from -1 to 1 of the patch's radius."""


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
    phase = wave * span
    ratio = np.where(phase < 1e-6, 0.5, bessel_j1(phase) / np.where(phase < 1e-6, 1.0, phase))
    return np.asarray(1.5 / radius**3 * span**2 * ratio)


HARMONICS = (2, 3, 4)
STATIC_HARMONICS = (5, 6, 7, 8)
"""Faster than any push by a ball: they deflect without delay."""
AXIAL_MODES = 5
"""Modes kept per harmonic, lowest first."""
ELEMENTS = 24
STIFF_TAPER = 0.5
"""Part of the barrel's radius at which the shell counts as held round: there it rings four times as high."""
GRID = 97
LOCAL_PLACES = 7


def hoop_modes(
    beam: BeamModel,
    *,
    law: PatchLaw,
    harmonics: tuple[int, ...] = HARMONICS,
    axial_modes: int = AXIAL_MODES,
    elements: int = ELEMENTS,
) -> Modes:
    """Return the hoop modes of a hollow bat's barrel, with shapes averaged over the ball's patch.

    What they leave out of the wall's give under a slow push is in `Modes.compliances`: higher axial modes, harmonics 5
    to 8, and the wall's compliance as a breathing and a shifted ring.

    Parameters
    ----------
    beam : a bat with a shell.
    law : how the ball's patch goes with the closing speed (`patch_law`).
    harmonics : circumferential harmonics that are followed in time, each >= 2.
    axial_modes : modes kept per harmonic.
    elements : finite elements from the taper to the tip, at least.

    Notes
    -----
    An end cap holds the tip round (w = v = 0): a plug's stiffness in its plane is tens of times the wall's. Without
    a cap the tip is free. At the handle's end the taper holds it round. Damping is the material's ratio.

    >>> from sweetspot import beam_model, catalog, hoop_modes
    >>> from sweetspot.dynamics.patch import patch_law
    >>> line, ball = beam_model(catalog.bat("single-wall")), catalog.ball()
    >>> round(hoop_modes(line, law=patch_law(ball)).frequency.min())  # Hz
    1989
    """
    start, end = barrel_range(beam)
    grid = np.linspace(start, end, GRID)
    shell = barrel_elements(
        beam, (*harmonics, *STATIC_HARMONICS), start=start, elements=elements, capped=is_capped(beam)
    )
    solved = _solved(shell, wall_pushes(shell, grid, law.radii), followed=len(harmonics), modes=axial_modes)
    omega = np.sqrt(solved.squares.ravel())
    order = np.argsort(omega)
    by_patch = (len(law.radii), GRID)
    left_out = solved.give.sum(axis=0) - np.einsum("npm,nm->p", solved.felt**2, 1 / solved.squares)
    left_out = left_out.reshape(by_patch).T + _local(beam, grid, law.radii)
    shapes = solved.felt.transpose(1, 0, 2).reshape(*by_patch, -1)[..., order].swapaxes(0, 1)
    felt = ByPatch(law, _over_the_whole_bat(grid, shapes, beam.bat.length))
    families: list[Family] = ["hoop"] * len(omega)
    return Modes(
        families=tuple(families),
        harmonics=tuple(int(number) for number in np.repeat(harmonics, axial_modes)[order]),
        frequency=omega[order] / (2 * np.pi),
        damping_rate=2 * beam.bat.damping_ratio * omega[order],
        shapes=felt.nominal(),
        rigid_part=np.zeros((2, len(omega))),
        dashpots=np.zeros((0, len(omega))),
        surface=Surface(OtherPatch(felt), np.eye(len(omega))),
        compliances=(ByPatch(law, _over_the_whole_bat(grid, left_out, beam.bat.length)),),
    )


PRESSED = 0.006
"""m, radius of the patch through which a tester's jaw presses on a barrel [our choice]; 4 mm give 5 % less stiffness,
9 mm 8 % more."""
SQUEEZED = tuple(range(2, 17, 2))
"""Even harmonics of a squeezed barrel; those up to 8 give 1 % less."""


def barrel_compression(beam: BeamModel, *, from_tip: float, patch: float = PRESSED) -> float:
    """Return the stiffness in N/m of a hollow barrel that is squeezed across a diameter, as leagues' testers do.

    Under one push F the wall below it gives c_n F in harmonic n, and the wall opposite (-1)^n c_n F. Of two pushes
    from opposite sides the odd harmonics cancel and the even ones double; both sides come in, so the diameter shrinks
    by 4 F (c_0 + c_2 + c_4 + ...).

    Parameters
    ----------
    from_tip : m, where it is squeezed; leagues do so 6 in from the barrel's end.
    patch : m, radius of either jaw's contact.

    >>> from sweetspot import beam_model, catalog
    >>> squeezed = barrel_compression(beam_model(catalog.bat("slow-pitch")), from_tip=0.1524)
    >>> round(squeezed * 0.00127 / 4.448)  # lbf for 0.050 in
    805
    """
    place, radii = np.array([beam.bat.length - from_tip]), np.array([patch])
    shell = barrel_elements(beam, SQUEEZED, start=barrel_range(beam)[0], elements=ELEMENTS, capped=is_capped(beam))
    wall = wall_stiffness(beam, place)
    middle = wall.mean_radius[:, None]
    waves, weights = _waves(middle)
    outer = np.asarray(bat_of_beam(beam).diameter_at(place))[:, None] / 2
    breathing = np.sum(_breathing(_law(wall), waves, middle, outer, radii) * weights) / np.pi
    oval = _solved(shell, wall_pushes(shell, place, radii), followed=1, modes=1).give.sum()
    return float(1 / (4 * (breathing + oval)))


SQUEEZED_AT, SQUEEZED_BY = 6 * INCH, 0.05 * INCH
"""m from the tip, and m by which a diameter shrinks: how leagues tell a barrel's compression [barrel_designer]."""


def squeezing_force(beam: BeamModel) -> float:
    """Return the force in N for which leagues' testers know a hollow barrel; see `barrel_compression`.

    >>> from sweetspot import beam_model, catalog
    >>> round(squeezing_force(beam_model(catalog.bat("slow-pitch"))))
    3579
    """
    return barrel_compression(beam, from_tip=SQUEEZED_AT) * SQUEEZED_BY


@dataclass(frozen=True)
class OtherPatch:
    """Correction to the shapes of hoop modes for a patch of another size than the nominal; see `Surface.basis`."""

    felt: ByPatch

    def __call__(self, position: Array, lateral: Array, closing_speed: Array | float | None) -> Array:  # noqa: ARG002 - round
        """Return the difference, 1/sqrt(kg), shape (..., modes)."""
        if closing_speed is None:
            return np.zeros((*np.shape(position), self.felt.tables.coefficients.shape[-1]))
        return self.felt.beyond_nominal(position, closing_speed)


def _solved(shell: ShellElements, pushes: Pushes, *, followed: int, modes: int) -> Solved:
    """Return ``modes`` modes of the first ``followed`` harmonics, and the compliance of all harmonics under pushes."""
    count = len(pushes.element)
    solved = Solved(
        np.empty((followed, modes)), np.empty((followed, count, modes)), np.empty((len(shell.harmonics), count))
    )
    if not solved_walls(shell.stiffness, shell.inertia, shell.held, pushes, solved):
        raise InputError(
            f"the wall of {shell.beam.bat.name} cannot be solved: its stiffness or mass is not positive; check its "
            "thickness and material"
        )
    return solved


def _local(beam: BeamModel, grid: Array, radii: Array) -> Array:
    """Return the give in harmonics 0 and 1 at places in m under patches, shape (places, radii)."""
    places = np.linspace(grid[0], grid[-1], LOCAL_PLACES)
    outer = np.asarray(bat_of_beam(beam).diameter_at(places)) / 2
    local = local_compliance(wall_stiffness(beam, places), outer=outer, radii=radii)
    return np.stack([np.interp(grid, places, values) for values in local.T], axis=1)


def ring_felt(beam: BeamModel, *, harmonic: int, patch: float) -> float:
    """Return the share of the motion under its middle that a patch feels of a ring bent without stretching.

    Parameters
    ----------
    harmonic : n >= 2 of w = W cos(n theta), v = -W / n sin(n theta).
    patch : radius in m.
    """
    before, after = transform(np.array([harmonic - 1, harmonic + 1]) * patch / _barrel_radius(beam))
    return float((before + after) / 2 - (after - before) / (2 * harmonic))


def barrel_range(beam: BeamModel) -> tuple[float, float]:
    """Return (start, end) in m of the part of a hollow bat that can ring in hoop modes."""
    bat = bat_of_beam(beam)
    places = np.linspace(0, bat.length, 2001)
    beyond_knob = places > bat.length / 4
    wide = bat.diameter_at(places) / 2 >= STIFF_TAPER * _barrel_radius(beam)
    return float(places[beyond_knob & wide][0]), bat.length


def hoop_frequency(beam: BeamModel) -> float:
    """Return the frequency in Hz of the lowest hoop mode of a hollow bat's barrel."""
    shell = barrel_elements(beam, HARMONICS[:1], start=barrel_range(beam)[0], elements=ELEMENTS, capped=is_capped(beam))
    nowhere = wall_pushes(shell, np.empty(0), np.empty(0))
    return float(np.sqrt(_solved(shell, nowhere, followed=1, modes=1).squares[0, 0]) / (2 * np.pi))


def _barrel_radius(beam: BeamModel) -> float:
    bat = bat_of_beam(beam)
    return float(np.max(bat.diameter_at(np.linspace(bat.length / 2, bat.length, 401)))) / 2


def is_capped(beam: BeamModel) -> bool:
    """Return whether something closes the tip of a hollow bat."""
    shell = bat_of_beam(beam).shell
    return shell is not None and shell.end_cap_mass > 0


def _over_the_whole_bat(grid: Array, values: Array, length: float) -> Piecewise:
    """Return values (places, ...) as polynomials from the knob to the tip, zero before the taper."""
    spline = cubic_spline(grid, values)
    edges = np.concatenate([[0.0], grid[:-1], [length]])
    nothing = np.zeros((4, 1, *values.shape[1:]))
    return Piecewise(np.concatenate([nothing, spline.coefficients], axis=1), edges)

"""Hoop modes of a hollow barrel, felt through the ball's patch, and what of the wall's give they leave out."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from sweetspot.dynamics.beam import BeamModel, bat_of_beam
from sweetspot.dynamics.long_tube import local_compliance
from sweetspot.dynamics.modes import Family, Modes, Surface
from sweetspot.dynamics.patch import ByPatch, PatchLaw, transform
from sweetspot.dynamics.shell_elements import ShellElements, barrel_elements
from sweetspot.dynamics.shell_kernel import Pushes, Solved, solved_walls
from sweetspot.dynamics.wall import wall_stiffness
from sweetspot.dynamics.wall_push import wall_pushes
from sweetspot.errors import InputError
from sweetspot.numerics.arrays import Array
from sweetspot.numerics.piecewise import Piecewise, cubic_spline

HARMONICS = (2, 3, 4)
STATIC_HARMONICS = (5, 6, 7, 8)
"""Faster than any push by a ball: they give way at once."""
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
    to 8, and what the wall gives way as a breathing and a shifted ring (`long_tube`).

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
    1990
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


@dataclass(frozen=True)
class OtherPatch:
    """What a patch of another size than the nominal one adds to the shapes of hoop modes; see `Surface.basis`."""

    felt: ByPatch

    def __call__(self, position: Array, lateral: Array, closing_speed: Array | float | None) -> Array:  # noqa: ARG002 - round
        """Return the difference, 1/sqrt(kg), shape (..., modes)."""
        if closing_speed is None:
            return np.zeros((*np.shape(position), self.felt.tables.coefficients.shape[-1]))
        return self.felt.beyond_nominal(position, closing_speed)


def _solved(shell: ShellElements, pushes: Pushes, *, followed: int, modes: int) -> Solved:
    """Return so many modes of the first harmonics that are followed, and what all harmonics give way under pushes."""
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
    return np.stack([np.interp(grid, places, one) for one in local.T], axis=1)


def ring_felt(beam: BeamModel, *, harmonic: int, patch: float) -> float:
    """Return how much of the motion under its middle a patch feels of a ring that is bent without stretching.

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

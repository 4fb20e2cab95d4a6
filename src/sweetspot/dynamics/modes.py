"""The one list of motions that a collision sees: rigid motions and vibrations alike."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, field
from functools import cached_property
from typing import Literal

import numpy as np
from numpy.typing import ArrayLike

from sweetspot.dynamics.over_face import OverFace
from sweetspot.dynamics.patch import ByPatch
from sweetspot.equipment.ball import Ball, peak_compression
from sweetspot.errors import InputError
from sweetspot.numerics.arrays import Array
from sweetspot.numerics.notebook_display import ShownInNotebooks
from sweetspot.numerics.piecewise import Piecewise

Family = Literal["rigid", "bending", "hoop", "face", "hand"]


ASKED = np.linspace(0.4, 1.0, 25)
"""Parts of the length at which the surface is asked how light it is."""


@dataclass(frozen=True)
class Surface:
    """Motion of the struck surface that depends on more than the place along it.

    That is the place across a face that deflects or a turning blade, or the patch that a fast ball presses.

    It moves outwards by ``basis_k(x, y) weights_ki q_i``, over and above the line's own motion.

    Parameters
    ----------
    basis : k functions of position and lateral place, m and m of shape (...), and of the closing speed in m/s, of that
        shape, one for all or None, to 1/sqrt(kg) of shape (..., k); all are zero off the face.
    weights : how much of each function is in each mode, shape (k, n).
    """

    basis: Callable[[Array, Array, Array | float | None], Array]
    weights: Array

    def mixed(self, vectors: Array) -> Surface:
        """Return the same surface for modes that are mixtures of these, one column each."""
        return Surface(self.basis, self.weights @ vectors)


@dataclass(frozen=True, repr=False)
class Modes(ShownInNotebooks):
    """Motions of a bat, each normalised to 1 kg of modal mass.

    Mode i moves the bat's line by ``q_i(t) shape_i(x)`` and obeys
    q_i'' + damping_rate_i q_i' + sum_k d_ki (d_k . q') + (2 pi frequency_i)^2 q_i = shape_i(x_hit) F.

    Parameters
    ----------
    families : "rigid", "bending", "hoop", "face" (strings, rubber, a club's plate) or "hand" (the hands' own motion
        on their flesh), one per mode.
    harmonics : 1, 2, ... within the family; 0 for rigid motions.
    frequency : Hz, shape (n,); 0 for rigid motions.
    damping_rate : 2 zeta omega in 1/s, shape (n,).
    shapes : displacement shapes as polynomials in position, 1/sqrt(kg), n columns.
    dashpots : d_k, dampers that couple modes, orthogonal rows, sqrt(1/s), shape (k, n); none on a free bat.
    rigid_part : how much of each mode is translation (row 0), rotation (row 1) and, with a face, roll (row 2) of the
        free bat, shape (2, n) or (3, n).
    surface : what depends on the place across the face; None: nothing does.
    compliances : instantaneous, under the ball, without a motion of their own, m/N by position: waves too fast to be
        modes here, and the dent that the ball presses into the surface. They add up.
    """

    families: tuple[Family, ...]
    harmonics: tuple[int, ...]
    frequency: Array
    damping_rate: Array
    shapes: Piecewise
    rigid_part: Array
    dashpots: Array
    surface: Surface | None = None
    compliances: tuple[Piecewise | ByPatch | OverFace, ...] = field(default=(), repr=False)

    def __len__(self) -> int:
        return len(self.families)

    def __repr__(self) -> str:
        """Return the number of motions of each family."""
        counts = ", ".join(f"{self.families.count(family)} {family}" for family in dict.fromkeys(self.families))
        return f"<Modes: {counts}>"

    @property
    def angular_frequency(self) -> Array:
        """Angular frequencies in rad/s, shape (n,)."""
        return 2 * np.pi * self.frequency

    @property
    def damping_ratio(self) -> Array:
        """Fractions of critical damping, shape (n,); 0 for rigid motions."""
        omega = self.angular_frequency
        return np.divide(self.damping_rate, 2 * omega, out=np.zeros_like(omega), where=omega > 0)

    def shape_at(
        self, position: ArrayLike, lateral: ArrayLike = 0.0, *, closing_speed: ArrayLike | None = None
    ) -> Array:
        """Return the shapes at positions in m: shape (..., n) for positions of shape (...).

        Parameters
        ----------
        lateral : m across the face from the line, of the same shape or one for all.
        closing_speed : m/s of the hit that feels them, of the same shape or one for all: fast balls press a larger
            patch. None: as at game speed.
        """
        places = np.asarray(position, float)
        along = np.asarray(self.shapes(places))
        if self.surface is None:
            return along
        across = np.asarray(lateral, float)
        if across.shape != places.shape:
            across = np.broadcast_to(across, places.shape)
        speed = None if closing_speed is None else np.asarray(closing_speed, float)
        return along + self.surface.basis(places, across, speed) @ self.surface.weights

    def compliance_at(
        self, position: ArrayLike, lateral: ArrayLike = 0.0, *, closing_speed: ArrayLike | None = None
    ) -> Array:
        """Return the instantaneous compliance in m/N of the surface at positions in m, of their shape; at least 0.

        Parameters
        ----------
        lateral : m across the face from the line, as `shape_at` takes it; it counts where the whole face is a plate.
        """
        return np.maximum(self.give_at(position, lateral, closing_speed=closing_speed), 0.0)

    def give_at(
        self, position: ArrayLike, lateral: ArrayLike = 0.0, *, closing_speed: ArrayLike | None = None
    ) -> Array:
        """Return the same without the bound at zero, to be added to that of other motions.

        A hollow barrel's own part is the excess of its wall's compliance over that of the beam of the bending modes
        (a long tube): below zero where the wall is stiff and thick. Only with the beam's does it make a give, and where
        the wall is no long tube, some millimetres from a capped tip and at the taper, even that may come out below
        zero: by 1e-8 m/N at most in 400 random bats, which moves q by 1e-3 there and nowhere else.
        """
        places = np.asarray(position, float)
        speed = None if closing_speed is None else np.asarray(closing_speed, float)
        total = np.zeros_like(places)
        for give in self.compliances:
            match give:
                case ByPatch():
                    total = total + give(places, speed)
                case OverFace():
                    total = total + give(places, np.broadcast_to(np.asarray(lateral, float), places.shape))[..., 0]
                case _:
                    total = total + np.asarray(give(places))
        return np.asarray(total)

    def slope_at(self, position: ArrayLike) -> Array:
        """Return the slopes of the shapes along the line, 1/(sqrt(kg) m): shape (..., n) for positions (...)."""
        return np.asarray(self._slopes(np.asarray(position, float)))

    @cached_property
    def liveliest(self) -> tuple[float, float]:
        """Extremes of the surface: the greatest sum of squared shapes, 1/kg, and the least compliance, m/N."""
        first, last = self.shapes.ends[0], self.shapes.ends[-1]
        places = first + ASKED * (last - first)
        return float((self.shape_at(places) ** 2).sum(axis=-1).max()), float(self.compliance_at(places).min())

    @cached_property
    def for_steps(self) -> dict[float, tuple[Array, ...]]:
        """Cache of the time solvers: constants of these motions by step in s."""
        return {}

    @cached_property
    def _slopes(self) -> Piecewise:
        return self.shapes.derivative()

    def nodes(self, mode: int) -> Array:
        """Return the positions in m where mode ``mode`` (its index in the list) stands still, from the knob up."""
        if mode not in self._nodes:
            self._nodes[mode] = self._roots(mode)
        return self._nodes[mode]

    @cached_property
    def _nodes(self) -> dict[int, Array]:
        """Those found so far: the same modes are asked for their nodes with every swing."""
        return {}

    def _roots(self, mode: int) -> Array:
        alone = Piecewise(self.shapes.coefficients[:, :, mode], self.shapes.ends)
        places = alone.roots()
        return places[np.abs(alone(places, 1)) > 0]

    def of_family(self, family: Family) -> list[int]:
        """Return the indices of the modes of one family, lowest frequency first."""
        return [index for index, name in enumerate(self.families) if name == family]

    def selected(self, indices: list[int]) -> Modes:
        """Return some of the modes, for example the rigid motions alone, without instantaneous compliances."""
        return Modes(
            tuple(self.families[index] for index in indices),
            tuple(self.harmonics[index] for index in indices),
            self.frequency[indices],
            self.damping_rate[indices],
            Piecewise(self.shapes.coefficients[:, :, indices], self.shapes.ends),
            self.rigid_part[:, indices],
            self.dashpots[:, indices],
            None if self.surface is None else Surface(self.surface.basis, self.surface.weights[:, indices]),
        )


def joined(first: Modes, second: Modes) -> Modes:
    """Return the modes of both lists, one after the other, as one list over the same bat; one may have a surface."""
    edges = np.union1d(first.shapes.ends, second.shapes.ends)
    degree = max(len(first.shapes.coefficients), len(second.shapes.coefficients)) - 1
    shapes = np.concatenate([_refined(modes.shapes, edges, degree) for modes in (first, second)], axis=2)
    zeros = [np.zeros((len(other.dashpots), len(modes))) for modes, other in ((second, first), (first, second))]
    return Modes(
        families=first.families + second.families,
        harmonics=first.harmonics + second.harmonics,
        frequency=np.concatenate([first.frequency, second.frequency]),
        damping_rate=np.concatenate([first.damping_rate, second.damping_rate]),
        shapes=Piecewise(shapes, edges),
        rigid_part=_side_by_side(first.rigid_part, second.rigid_part),
        dashpots=np.block([[first.dashpots, zeros[0]], [zeros[1], second.dashpots]]),
        surface=_joined_surface(first, second),
        compliances=first.compliances + second.compliances,
    )


def _side_by_side(left: Array, right: Array) -> Array:
    """Return two matrices side by side, the one with fewer rows filled up with zeros."""
    rows = max(len(left), len(right))
    return np.hstack([np.pad(part, ((0, rows - len(part)), (0, 0))) for part in (left, right)])


def _joined_surface(first: Modes, second: Modes) -> Surface | None:
    if first.surface is not None:
        return first.surface.mixed(np.eye(len(first), len(first) + len(second)))
    if second.surface is not None:
        return second.surface.mixed(np.eye(len(second), len(first) + len(second), k=len(first)))
    return None


def _refined(shapes: Piecewise, edges: Array, degree: int) -> Array:
    """Return the same polynomials on more pieces: Taylor coefficients at the left end of each piece."""
    left = edges[:-1]
    terms = [shapes.derivative(order)(left) / math.factorial(order) for order in range(degree, 0, -1)]
    return np.array([*terms, shapes(left)])


def tapped(modes: Modes, *, position: float, duration: float) -> Array:
    """Return the speed in which every mode is left per impulse of a half-sine tap, 1/sqrt(kg), shape (n,).

    Mode i is left with s_i(x) J G(omega_i), G(omega) = |cos(omega T / 2)| / |1 - (omega T / pi)^2|: slow modes take the
    whole impulse J, modes much faster than the tap hardly any. Damping during the tap is left out.

    Parameters
    ----------
    position : m from the knob end.
    duration : T in s, >= 0; 0 is a blow of no duration, which excites every mode alike.

    >>> from sweetspot import catalog, beam_model
    >>> from sweetspot.dynamics.reduction import bending_modes
    >>> modes = bending_modes(beam_model(catalog.bat("r161-ash")))
    >>> bool(tapped(modes, position=0.7, duration=0.0)[0] == modes.shape_at(0.7)[0])
    True
    """
    if not (np.isfinite(duration) and duration >= 0):
        raise InputError(f"tap lasts {duration:g} s; allowed is 0 or more")
    return np.asarray(modes.shape_at(position) * half_sine_gain(modes.angular_frequency * duration / np.pi))


def half_sine_gain(ratio: Array) -> Array:
    """Return |cos(pi r / 2)| / |1 - r^2| for r = omega T / pi: 1 for slow motions, pi / 4 where half a period is T."""
    ratio = np.asarray(ratio, float)
    near = np.abs(ratio - 1) < 1e-6
    safe = np.where(near, 2.0, ratio)
    return np.where(near, np.pi / 4, np.abs(np.cos(np.pi * safe / 2) / (1 - safe**2)))


AHEAD = 2.0
"""Highest bending mode over the frequency at which ball and face swing against each other: q is then within 2e-4 of
that with eighty modes on a badminton racket, the slowest to converge."""
MOST_MODES = 48
WALL_SPEED = 30.0
"""m/s on a rigid wall, where the ball's steepness is taken; it changes little with speed."""
PLACES = np.linspace(0.4, 1.0, 25)
"""Parts of the length at which the surface is asked how light it is."""


def excited_frequency(bending: Modes, face: Modes, ball: Ball) -> float:
    """Return the frequency in Hz that the highest bending mode must reach beside this face.

    A hard ball of a few grams on light strings is over before a slender shaft's twelfth mode has swung once.

    Parameters
    ----------
    bending : the lowest `MODES`, and the rigid motions.
    """
    together = joined(bending, face)
    places = PLACES * bending.shapes.ends[-1]
    inverse_mass = 1 / ball.mass + float((together.shape_at(places) ** 2).sum(axis=-1).max())
    return AHEAD * math.sqrt(_steepness(ball) * inverse_mass) / (2 * math.pi)


def _steepness(ball: Ball) -> float:
    """Return dF/du in N/m where the ball turns, on a rigid wall at `WALL_SPEED`: n k U^(n-1)."""
    peak = peak_compression(ball, WALL_SPEED)
    return float(ball.exponent * ball.stiffness * peak ** (ball.exponent - 1))

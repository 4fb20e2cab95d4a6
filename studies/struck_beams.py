"""Beams of round section by finite elements of their own, free or held by hands, for made-up taps.

Timoshenko elements of two nodes with the shear taken at the middle and masses at the nodes: nothing is shared with
`sweetspot.dynamics`. Hands are masses, springs and dampers spread over the handle.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Self

import numpy as np
import scipy.linalg
from numpy.typing import NDArray

Array = NDArray[np.float64]
ELEMENTS = 240
MODES = 14
"""Of the free beam, in which a held one moves."""
HIGHEST = 5500.0
"""Hz up to which modes are kept."""
ROOTS = (4.730040745, 7.853204624, 10.995607838, 14.137165491)
"""Of a uniform free beam."""


@dataclass(frozen=True)
class Grip:
    """A hand: places from the knob end in m between which it holds; kg, N/m and N s/m."""

    low: float
    high: float
    mass: float
    stiffness: float
    damping: float


FREE = Grip(0.0, 0.1, 0.0, 0.0, 0.0)
GRIPS = {
    "free": FREE,
    "fingers": Grip(0.0, 0.03, 0.005, 1e3, 2.0),
    "light": Grip(0.03, 0.10, 0.010, 5e3, 15.0),
    "hand": Grip(0.03, 0.11, 0.030, 1.5e4, 60.0),
    "hands": Grip(0.02, 0.20, 0.060, 4e4, 150.0),
    "table": Grip(0.25, 0.30, 0.0, 2e4, 2.0),
    "vice": Grip(0.0, 0.10, 0.0, 1e6, 5.0),
}
"""A hand's bones are slow; the handle feels their skin, 10 to 30 kN/m and 50 to 150 N s/m a hand, and what goes with it
(assumed). Two fingers and a light hand are less; a folded towel on a table and a vice do not lose much."""


@dataclass(frozen=True)
class Beam:
    """A free beam that was solved.

    Parameters
    ----------
    places : of its nodes, m from the knob end.
    modes : deflections as columns, 1/sqrt(kg): two rigid motions, then bending.
    solved : Hz of all bending modes.
    mass, balance_point, moi_cm : kg, m from the knob end, kg m^2 about the balance point.
    """

    places: Array
    modes: Array
    solved: Array
    mass: float
    balance_point: float
    moi_cm: float

    @classmethod
    def solid(
        cls, outline: Array, *, density: float, modulus: float, shear: float, gradient: float = 0.0, knob: float = 0.0
    ) -> Self:
        """Return a turned bat; outline holds places and diameters, m.

        Parameters
        ----------
        gradient : how much denser it is at the tip than in its middle, and lighter at the knob end.
        knob : kg of tape at the knob end.
        """
        places = np.linspace(0.0, outline[-1, 0], ELEMENTS + 1)
        middle = (places[1:] + places[:-1]) / 2
        radius = np.interp(middle, *outline.T) / 2
        area, inertia = np.pi * radius**2, np.pi * radius**4 / 4
        heavy = density * (1 + gradient * (2 * middle / places[-1] - 1))
        return cls._solved(places, heavy * area, heavy * inertia, modulus * inertia, 6 / 7 * shear * area, (knob, 0.0))

    @classmethod
    def tube(
        cls, outline: Array, *, walls: tuple[float, float], ends: tuple[float, float], depths: tuple[float, float]
    ) -> Self:
        """Return a bat of aluminium with walls of handle and barrel in m, knob and end cap in kg and how deep in m."""
        places = np.linspace(0.0, outline[-1, 0], ELEMENTS + 1)
        middle = (places[1:] + places[:-1]) / 2
        length = places[-1]
        outer = np.interp(middle, *outline.T) / 2
        inner = outer - np.interp(middle, [0.38 * length, 0.75 * length], walls)
        area, inertia = np.pi * (outer**2 - inner**2), np.pi * (outer**4 - inner**4) / 4
        plugs = outer[int(np.argmin(np.abs(middle - depths[0] / 2)))], inner[-1]
        shear = 0.53 * 26.7e9 * area
        return cls._solved(places, 2800 * area, 2800 * inertia, 71e9 * inertia, shear, ends, depths, plugs)

    @classmethod
    def _solved(
        cls, places: Array, heavy: Array, turning: Array, bending: Array, shearing: Array,
        ends: tuple[float, float] = (0.0, 0.0), depths: tuple[float, float] = (0.0, 0.0),
        plugs: tuple[float, float] = (0.0, 0.0),
    ) -> Self:  # fmt: skip
        size, step = len(places), float(places[1] - places[0])
        stiff, weight = np.zeros((2 * size, 2 * size)), np.zeros(2 * size)  # deflections, then rotations
        for index in range(size - 1):
            both = [index, index + 1, size + index, size + index + 1]
            slope = np.array([-1 / step, 1 / step, -0.5, -0.5])
            turn = np.array([0.0, 0.0, -1 / step, 1 / step])
            stiff[np.ix_(both, both)] += step * (
                shearing[index] * np.outer(slope, slope) + bending[index] * np.outer(turn, turn)
            )
            weight[both] += step / 2 * np.array([heavy[index], heavy[index], turning[index], turning[index]])
        filled = [places <= depths[0], places >= places[-1] - depths[1]]
        for mass, plug, nodes in zip(ends, plugs, filled, strict=True):
            weight[:size][nodes] += mass / np.count_nonzero(nodes)
            weight[size:][nodes] += mass * plug**2 / 4 / np.count_nonzero(nodes)  # of a disc about its diameter
        squares, shapes = scipy.linalg.eigh(stiff, np.diag(weight), subset_by_index=(0, MODES + 1))
        frequency = np.sqrt(np.maximum(squares[2:], 0)) / (2 * np.pi)
        point = weight[:size]
        total = float(np.sum(point))
        balance = float(point @ places) / total
        about = float(point @ (places - balance) ** 2 + np.sum(weight[size:]))
        return cls(places, shapes[:size], frequency, total, balance, about)

    @property
    def frequency(self) -> Array:
        """Hz of the bending modes that are kept."""
        return self.solved[self.solved < HIGHEST]

    def shape(self, part: float) -> Array:
        """Return the deflection of the kept modes at a part of the length."""
        return np.array(
            [np.interp(part * self.places[-1], self.places, one) for one in self.modes.T[2 : 2 + len(self.frequency)]]
        )


def shaken(beam: Beam, damping: Array, grip: Grip) -> tuple[Array, Array]:
    """Return frequency and damping of a beam's bending modes when it is held.

    Parameters
    ----------
    damping : ratios of the free modes.
    """
    count = 2 + len(beam.frequency)
    shapes = beam.modes[:, :count]
    natural = 2 * np.pi * np.concatenate([[0.0, 0.0], beam.frequency])
    touched = shapes[(beam.places >= grip.low) & (beam.places <= grip.high)]
    pressed = touched.T @ touched / len(touched)
    mass = np.eye(count) + grip.mass * pressed
    lost = np.diag(2 * np.concatenate([[0.0, 0.0], damping]) * natural) + grip.damping * pressed
    spring = np.diag(natural**2) + grip.stiffness * pressed
    inverse = np.linalg.inv(mass)
    state = np.block([[np.zeros((count, count)), np.eye(count)], [-inverse @ spring, -inverse @ lost]])
    values, vectors = np.linalg.eig(state)
    frequency, ratio = [], []
    for index in range(2, count):  # the held mode that is most of it
        share = np.abs(vectors[index]) / np.linalg.norm(vectors[:count], axis=0)
        best = int(np.argmax(share * (values.imag > 0)))
        frequency.append(abs(values[best].imag) / (2 * np.pi))
        ratio.append(-values[best].real / abs(values[best]))
    return np.array(frequency), np.array(ratio)


def ring_frequency(diameter: float, wall: float, *, harmonic: int) -> float:
    """Return Hz of a long tube of aluminium: n (n^2 - 1) / sqrt(n^2 + 1) sqrt(E h^2 / (12 (1 - nu^2) rho)) / R^2."""
    radius, factor = (diameter - wall) / 2, harmonic * (harmonic**2 - 1) / np.sqrt(harmonic**2 + 1)
    return float(factor * np.sqrt(71e9 * wall**2 / (12 * (1 - 0.33**2) * 2800)) / radius**2 / (2 * np.pi))


def free_shapes(part: float) -> Array:
    """Return the deflections of a uniform free beam's first modes at a part of its length."""
    shapes = []
    for root in ROOTS:
        ratio = (np.cosh(root) - np.cos(root)) / (np.sinh(root) - np.sin(root))
        place = root * part
        shapes.append(np.cosh(place) + np.cos(place) - ratio * (np.sinh(place) + np.sin(place)))
    return np.array(shapes)

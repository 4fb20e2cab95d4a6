"""The numbers of one implement and ball with which a file computes any hit along it, as `collision.kernel` does.

What a collision sees of an implement are its modes' shapes and its surface's give at the place that is hit. They are
taken at a row of places: those of `position_scan`, from which sweet spots are read, and those at which the file lets
the ball be put. What depends on the patch that the ball presses is taken at the radii of its tables (`PatchLaw.radii`),
between which it is a polynomial, and a hollow barrel's wall has cubic pieces along the bat, so that nothing is lost.
"""

from __future__ import annotations

import math
from base64 import b64encode
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from sweetspot.analysis.bat_analysis import check_conditions
from sweetspot.analysis.position_scan import Scan, scan, velocity_weight
from sweetspot.analysis.sweet_spot import max_exit_speed
from sweetspot.collision.free_motion import modal_propagator_of
from sweetspot.collision.kernel import STEP, numbers_of, steps_of
from sweetspot.collision.time_step import contact_step, give_of_steps
from sweetspot.dynamics.hoop import OtherPatch
from sweetspot.dynamics.modes import Modes
from sweetspot.dynamics.patch import patch_law
from sweetspot.dynamics.reduction import ReducedBat
from sweetspot.equipment.ball import Ball
from sweetspot.equipment.implement import Implement
from sweetspot.motion.swing import Conditions
from sweetspot.numerics.arrays import Array
from sweetspot.numerics.constants import STANDARD_AXIS
from sweetspot.uncertainty.drawn_hits import draws_of
from sweetspot.uncertainty.sources import Sources, one_by_one
from sweetspot.units import INCH

GRID = 0.1 * INCH
"""m between the places at which the file's ball can be put."""
REACH = 180
"""Steps of it from the tip, 18 in: a bat's handle begins about there."""
FILM_PLACES = 61
"""Places along the implement at which the film needs its shapes."""
SLOWEST, ROOTS = 6.7, 8
"""m/s, closing speed from which intervals are known, and nodes of their polynomials in the root of the speed; below it
the patch of the ball does not shrink any more and hits are of no game."""


@dataclass(frozen=True)
class PackedArray:
    """An array as text: its shape, and its numbers as base64 of so many bytes each, the least byte first.

    Four bytes are a float32; fewer than eight are the upper ones of a float64, of which five are good to 2e-9.
    """

    shape: tuple[int, ...]
    size: int
    base64: str

    @classmethod
    def of(cls, values: Array, *, size: int) -> PackedArray:
        """Return an array as text."""
        if size == np.dtype(np.float32).itemsize:
            return cls(values.shape, size, b64encode(np.ascontiguousarray(values, "<f4").tobytes()).decode())
        dropped = 8 * (np.dtype(float).itemsize - size)
        whole = np.ascontiguousarray(values, "<f8").view("<i8") + (1 << dropped >> 1)  # to the nearest
        parts = whole.view(np.uint8).reshape(*values.shape, -1)[..., -size:]
        return cls(values.shape, size, b64encode(np.ascontiguousarray(parts).tobytes()).decode())


@dataclass(frozen=True)
class PatchNumbers:
    """How the radius of the ball's patch goes with the closing speed; see `PatchLaw`."""

    reference: float
    reference_speed: float
    power: float
    radii: Array


@dataclass(frozen=True, kw_only=True)
class WallNumbers:
    """Shapes of the modes of a hollow barrel's wall under patches of every radius, by place; they are zero elsewhere.

    Parameters
    ----------
    modes : their numbers.
    ends : m from the knob end, of cubic pieces.
    values, slopes : at these ends, shape (ends, radii, modes), 1/sqrt(kg) and that per m.
    """

    modes: tuple[int, ...]
    ends: Array
    values: PackedArray
    slopes: PackedArray


@dataclass(frozen=True, kw_only=True)
class KernelNumbers:
    """What the kernel needs of the modes; see `BatNumbers`. ``damping_rate``: 2 zeta omega in 1/s."""

    omega: Array
    step_give: Array
    drift: Array
    damping_rate: Array


@dataclass(frozen=True, kw_only=True)
class PlaceNumbers:
    """Numbers of every place, shape (n, ...), in m from the knob end.

    Parameters
    ----------
    scanned : how many of them, the first ones, are those of the scan.
    grid : from the tip in steps of `GRID`, the first and the last step of the others.
    fixed : numbers of the modes whose shapes do not depend on the patch, and ``shapes`` theirs, shape (n, fixed).
    give : m/N at every radius of the patch, shape (n, radii).
    """

    scan_start: float
    scan_end: float
    scanned: int
    grid: tuple[int, int]
    fixed: tuple[int, ...]
    shapes: PackedArray
    give: PackedArray


@dataclass(frozen=True, kw_only=True)
class MotionNumbers:
    """What is read from the motion of the modes after the hit.

    Parameters
    ----------
    families : of every mode.
    rigid_part : see `Modes`; rows for translation, rotation and roll.
    felt : of the squared speed of every mode, what both hands feel in the mean; see `position_scan.sting`.
    places, film_shapes : m, and of every mode but those of a wall, shape (modes, places).
    hand_shape : of every mode at the top hand.
    push, turn : of every mode, what it moves the balance point (m) and turns the implement (rad).
    """

    families: tuple[str, ...]
    rigid_part: Array
    felt: Array
    places: Array
    film_modes: tuple[int, ...]
    film_shapes: PackedArray
    hand_shape: Array
    push: Array
    turn: Array


@dataclass(frozen=True, kw_only=True)
class DoubtNumbers:
    """One standard deviation of q, from what is not known of implement and ball, at every place that can be hit.

    Polynomials through ``values``, shape (n, nodes), at Chebyshev's nodes in the root of the closing speed between two
    ends in m/s.
    """

    slowest: float
    fastest: float
    values: PackedArray


@dataclass(frozen=True, kw_only=True)
class BodyNumbers:
    """The rigid implement: its mass, and moments of inertia about its centre, the top hand and a laboratory's clamp."""

    mass: float
    balance_point: float
    moi_cm: float
    moi_hands: float
    clamp: float
    moi_clamp: float


@dataclass(frozen=True, kw_only=True)
class OfflineNumbers:
    """Everything that a file computes with; SI.

    Parameters
    ----------
    turned_about, measured_at : m from the knob end: of the swing.
    """

    length: float
    body: BodyNumbers
    turned_about: float
    measured_at: float
    hands: tuple[float, ...]
    ball: Mapping[str, float | Mapping[str, float]]
    ball_radius: float
    steps: Mapping[str, float]
    patch: PatchNumbers
    kernel: KernelNumbers
    places: PlaceNumbers
    wall: WallNumbers | None
    motion: MotionNumbers
    doubt: DoubtNumbers | None


@dataclass(frozen=True)
class OfflineBat:
    """An implement and its swing, of which a file is made.

    ``sources``: what is not known of it and of the ball; None: nothing is said of that.
    """

    reduced: ReducedBat[Implement]
    conditions: Conditions
    sources: Sources | None = None

    @cached_property
    def scan(self) -> Scan:
        """The hits along it under its swing."""
        check_conditions(self.reduced, self.conditions)
        return scan(self.reduced, self.conditions)

    @property
    def scanned(self) -> Array:
        """Places of the scan, m from the knob end."""
        return self.scan.position

    @property
    def best_from_tip(self) -> float:
        """The place that hits fastest, m from the tip."""
        return self.reduced.bat.length - max_exit_speed(self.scan)

    @cached_property
    def grid(self) -> tuple[int, int]:
        """The first and the last of the places at which the ball can be put, in steps of `GRID` from the tip."""
        tip, slack = self.reduced.bat.length, GRID / 100
        nearest, farthest = (tip - float(self.scanned[end]) for end in (-1, 0))
        return math.ceil((nearest - slack) / GRID), min(REACH, math.floor((farthest + slack) / GRID))

    @cached_property
    def hit_places(self) -> Array:
        """Places at which the ball can be put, m from the knob end, from the tip inwards."""
        first, last = self.grid
        return np.asarray(self.reduced.bat.length - np.arange(first, last + 1) / 10 * INCH)

    def numbers(self, *, fastest: float) -> OfflineNumbers:
        """Return its numbers; ``fastest``: closing speed in m/s up to which intervals are needed."""
        bat, body, modes, conditions = self.reduced.bat, self.reduced.body, self.reduced.modes, self.conditions
        ball, swing = conditions.ball, conditions.swing
        step = contact_step(modes, ball, longest=STEP)
        law = patch_law(ball)
        omega = modes.angular_frequency
        return OfflineNumbers(
            length=bat.length,
            body=BodyNumbers(
                mass=body.mass,
                balance_point=body.balance_point,
                moi_cm=body.moi_cm,
                moi_hands=body.moi(conditions.hands.position),
                clamp=STANDARD_AXIS,
                moi_clamp=body.moi(STANDARD_AXIS),
            ),
            turned_about=swing.pivot,
            measured_at=swing.measured_at,
            hands=conditions.hands.places,
            ball=_ball(ball),
            ball_radius=ball.radius,
            steps=steps_of(ball, step)._asdict(),
            patch=PatchNumbers(law.reference, law.reference_speed, law.power, law.radii),
            kernel=KernelNumbers(
                omega=omega,
                step_give=give_of_steps(omega, step),
                drift=modal_propagator_of(modes, step),
                damping_rate=modes.damping_rate,
            ),
            places=self._places(),
            wall=_wall(modes),
            motion=self._motion(),
            doubt=None if self.sources is None else self._doubt(self.sources, fastest),
        )

    def _places(self) -> PlaceNumbers:
        modes, places = self.reduced.modes, np.concatenate([self.scanned, self.hit_places])
        law, wall = patch_law(self.conditions.ball), modes.of_family("hoop")
        fixed = [mode for mode in range(len(modes)) if mode not in wall]
        middle = np.zeros_like(places)
        speeds = law.reference_speed * (law.radii / law.reference) ** (1 / law.power)
        gives = [modes.give_at(places, middle, closing_speed=np.full_like(places, speed)) for speed in speeds]
        return PlaceNumbers(
            scan_start=float(self.scanned[0]),
            scan_end=float(self.scanned[-1]),
            scanned=len(self.scanned),
            grid=self.grid,
            fixed=tuple(fixed),
            shapes=PackedArray.of(modes.shape_at(places)[:, fixed], size=5),
            give=PackedArray.of(np.stack(gives, axis=1), size=4),
        )

    def _motion(self) -> MotionNumbers:
        bat, body, modes, hands = self.reduced.bat, self.reduced.body, self.reduced.modes, self.conditions.hands
        felt = velocity_weight(modes.frequency) ** 2 * (modes.shape_at(np.array(hands.places)) ** 2).mean(axis=0) / 2
        line = [index for index, family in enumerate(modes.families) if family != "hoop"]
        places = np.linspace(0, bat.length, FILM_PLACES)
        push, turn = modes.rigid_part[:2]
        return MotionNumbers(
            families=modes.families,
            rigid_part=modes.rigid_part,
            felt=felt,
            places=places,
            film_modes=tuple(line),
            film_shapes=PackedArray.of(modes.shape_at(places)[:, line].T, size=4),
            hand_shape=modes.shape_at(np.array(hands.position)),
            push=push / np.sqrt(body.mass),
            turn=turn / np.sqrt(body.moi_cm),
        )

    def _doubt(self, sources: Sources, fastest: float) -> DoubtNumbers:
        count = len(sources.names)
        draws = draws_of(self.reduced.beam, self.conditions, sources, count=2 * count, normal=one_by_one(count))
        nodes = np.cos((2 * np.arange(ROOTS) + 1) * np.pi / (2 * ROOTS))
        low, high = np.sqrt(SLOWEST), np.sqrt(fastest)
        closing = ((low + high + nodes * (high - low)) / 2) ** 2
        places, speeds = (np.ravel(values) for values in np.broadcast_arrays(self.hit_places[:, None], closing))
        efficiency = draws.struck(places[None, :], speeds[None, :]).collision_efficiency[1:]
        up, down = efficiency.reshape(2, count, *efficiency.shape[1:])
        error = np.sqrt(np.sum(((up - down) / 2) ** 2, axis=0)).reshape(-1, ROOTS)
        return DoubtNumbers(slowest=SLOWEST, fastest=fastest, values=PackedArray.of(error, size=4))


def _ball(ball: Ball) -> dict[str, float | Mapping[str, float]]:
    numbers = numbers_of(ball)
    return {**numbers._asdict(), "restitution": numbers.restitution._asdict()}


def _wall(modes: Modes) -> WallNumbers | None:
    """Return the shapes of a wall's modes; only they depend on the patch that the ball presses."""
    wall = modes.of_family("hoop")
    if modes.surface is None or not wall:
        return None
    basis, weights = modes.surface.basis, modes.surface.weights
    assert isinstance(basis, OtherPatch)
    tables = basis.felt.tables
    pieces = np.flatnonzero(tables.coefficients.any(axis=(0, 2, 3)))
    ends = tables.ends[pieces[0] : pieces[-1] + 2]
    inside = np.append(ends[:-1], np.nextafter(ends[-1], ends[0]))  # beyond the first there is none
    values, slopes = (np.asarray(tables(inside, order)) @ weights[:, wall] for order in (0, 1))
    return WallNumbers(
        modes=tuple(wall), ends=ends, values=PackedArray.of(values, size=4), slopes=PackedArray.of(slopes, size=4)
    )

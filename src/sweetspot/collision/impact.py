"""The result of a hit, with its verdict and where the energy went."""

from __future__ import annotations

from dataclasses import dataclass
from enum import IntEnum

import numpy as np
from numpy.typing import NDArray

from sweetspot.dynamics.modes import Modes
from sweetspot.numerics.arrays import Array
from sweetspot.numerics.notebook_display import ShownInNotebooks

CONTACT_FORCE = 0.01
"""Part of the peak force at which contact counts as over; a ball that is nearly free presses hardly at all."""


class Outcome(IntEnum):
    """Outcome of a hit; a batch carries one per row."""

    SEPARATED = 0
    STILL_IN_CONTACT = 1
    NO_CONTACT = 2
    MISS = 3

    @property
    def sentence(self) -> str:
        """The outcome in words."""
        return {
            Outcome.SEPARATED: "ball and bat have separated",
            Outcome.STILL_IN_CONTACT: "ball and bat were still in contact at the time limit",
            Outcome.NO_CONTACT: "the bat does not reach the ball: their closing speed is not above zero",
            Outcome.MISS: "a miss: the ball passes the bat above or below",
        }[self]


@dataclass(frozen=True)
class EnergyLedger:
    """Energy balance, J, in the frame of the undisturbed bat (as in a laboratory that fires at a bat at rest).

    Parameters
    ----------
    incoming : of the ball.
    ball : kinetic energy of the ball leaving.
    heat : lost in the ball.
    translation, rotation : rigid motion given to the bat.
    bending, hoop, face : left vibrating in the bat (hands' springs and masses count as bending) and in the strings,
        rubber or plate of its face. Roll counts as rotation.
    damping : lost in the bat and the hands during contact.
    """

    incoming: float
    ball: float
    heat: float
    translation: float
    rotation: float
    bending: float
    hoop: float
    damping: float
    face: float = 0.0

    @property
    def imbalance(self) -> float:
        """Relative residual of the energy balance: the error of the time steps."""
        parts = (
            self.ball,
            self.heat,
            self.translation,
            self.rotation,
            self.bending,
            self.hoop,
            self.damping,
            self.face,
        )
        return sum(parts) / self.incoming - 1 if self.incoming else 0.0


@dataclass(frozen=True, repr=False)
class Impact(ShownInNotebooks):
    """One hit.

    Parameters
    ----------
    outcome : how it ended; every number below is nan where it has no meaning.
    position : m from the knob end.
    closing_speed : m/s, ball plus bat at the point of impact.
    collision_efficiency : q, the rebound speed from a bat at rest over the closing speed.
    contact_time : s, from touch until the force has fallen to 1 % of its peak for good: what a gauge sees.
    release_time : s, from touch until the ball is free.
    peak_force : N.
    peak_compression : m, of the ball.
    energy : the ledger.
    displacement, velocity : of every mode at release, shape (n,), sqrt(kg) m and sqrt(kg) m/s.
    times, force, compression, impulse : history during contact, s, N, m, N s, shape (steps,); ``impulse`` is what each
        kick gave, the force times the step but for the step's correction.
    approach : what ball and surface together are pressed in, m, as the kicks see it, shape (steps,).
    lateral : m across the face from the bat's line.
    unrecovered : the same hit by a ball that forgets nothing while it is free (`ContactLaw`); None: it is touched once.
    """

    outcome: Outcome
    position: float
    closing_speed: float
    collision_efficiency: float
    contact_time: float
    release_time: float
    peak_force: float
    peak_compression: float
    energy: EnergyLedger
    displacement: Array
    velocity: Array
    times: Array
    force: Array
    compression: Array
    impulse: Array
    approach: Array
    lateral: float = 0.0
    unrecovered: Impact | None = None

    @property
    def touches(self) -> int:
        """Number of touches: more than one where the bat caught up with the ball."""
        pressed = self.force > 0
        return int(np.count_nonzero(pressed[1:] & ~pressed[:-1]))

    @property
    def presses(self) -> int:
        """Number of times that the ball was pressed, with less than 1 % of the greatest force in between.

        More than once too where the bat caught up with a ball that was nearly gone and had touched it all the time.
        """
        pressed = self.force >= CONTACT_FORCE * np.max(self.force, initial=0.0)
        return int(np.count_nonzero(pressed[1:] & ~pressed[:-1]))

    @property
    def first_touch_efficiency(self) -> float | None:
        """Q of a ball that leaves for good after its first touch; None where it is pressed only once.

        1 + q is in proportion to the impulse, so it is that of the touch over that of the whole hit.
        """
        if self.presses < 2:
            return None
        pressed = self.force >= CONTACT_FORCE * np.max(self.force)
        start = int(np.argmax(pressed))
        end = start + int(np.argmin(pressed[start:]))
        return float((1 + self.collision_efficiency) * self.impulse[:end].sum() / self.impulse.sum() - 1)

    @property
    def unrecovered_gain(self) -> float:
        """Excess speed, m/s along the line of centres, of a ball that has not recovered; 0 if touched once."""
        if self.unrecovered is None:
            return 0.0
        return self.closing_speed * (self.unrecovered.collision_efficiency - self.collision_efficiency)

    def __repr__(self) -> str:
        return (
            f"<Impact at {self.position:.4f} m: {self.outcome.name.lower()}, q = {self.collision_efficiency:.4f}, "
            f"contact {1e3 * self.contact_time:.3f} ms, peak force {self.peak_force:.0f} N>"
        )


@dataclass(frozen=True, repr=False)
class Impacts(ShownInNotebooks):
    """Many hits; every array has one row per hit, and rows without a meaning are nan (see `outcome`).

    Parameters
    ----------
    touches : how many times each ball was touched; more than once where the bat caught up with it.
    """

    outcome: NDArray[np.int64]
    collision_efficiency: Array
    contact_time: Array
    release_time: Array
    peak_force: Array
    peak_compression: Array
    touches: Array
    displacement: Array
    velocity: Array

    def __len__(self) -> int:
        return len(self.outcome)

    def __repr__(self) -> str:
        """Return the number of hits and of those that left the bat."""
        return f"<{self.outcome.size} hits, {int(np.sum(self.outcome == Outcome.SEPARATED))} separated>"


def bat_energy(modes: Modes, displacement: Array, velocity: Array) -> tuple[Array, Array, Array, Array, Array]:
    """Return translation, rotation, bending, hoop and face energy in J of a bat in its modes, each of shape (...).

    Parameters
    ----------
    displacement, velocity : of every mode, shape (..., n): of one moment or of many.
    """
    each = (velocity**2 + (modes.angular_frequency * displacement) ** 2) / 2
    rigid = (velocity @ modes.rigid_part.T) ** 2 / 2
    translation, rotation = rigid[..., 0], rigid[..., 1:].sum(axis=-1)
    walls = (modes.of_family(family) for family in ("hoop", "face"))
    hoop, face = (each[..., members].sum(axis=-1) if members else np.zeros(each.shape[:-1]) for members in walls)
    return translation, rotation, each.sum(axis=-1) - translation - rotation - hoop - face, hoop, face

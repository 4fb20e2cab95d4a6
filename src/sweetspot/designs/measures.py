"""Measures of every bat of a search: sizes, weights, and its results for this batter."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np

from sweetspot.analysis.certification.simulated_test import BPF_SPEED, bpf, swung_test
from sweetspot.analysis.position_scan import stings
from sweetspot.analysis.sweet_spot import ZONE_LOSS
from sweetspot.collision.closed_form import restitution_from_efficiency
from sweetspot.collision.kernel import STEP, struck
from sweetspot.collision.time_step import contact_step
from sweetspot.designs.batter import FROM_TIP, WIDTHS, Batter, off_centre, retained_at_widths
from sweetspot.designs.durability import BatterHits, Handles, StrainLimits, strain_limits_of, strain_margins
from sweetspot.designs.variables import Space
from sweetspot.dynamics.batch.bending import BendingBatch
from sweetspot.dynamics.batch.reduction import ReducedBats
from sweetspot.equipment.bat import Bat
from sweetspot.errors import InputError
from sweetspot.motion.swing import Conditions
from sweetspot.motion.swing_law import SwingLaw
from sweetspot.numerics.arrays import Array, IntArray
from sweetspot.numerics.constants import STANDARD_AXIS
from sweetspot.numerics.interpolants import tops
from sweetspot.units import INCH, OUNCE

if TYPE_CHECKING:
    from scipy.interpolate import PchipInterpolator

NO_SHAPES: Mapping[str, Array] = {}
SWING_TIME = 0.15
"""s from the start of a swing to contact, with the present bat (assumed; only differences of bats are asked for)."""


@dataclass(frozen=True)
class Measure:
    """Something measured on a bat.

    ``better``: 1: more is better; -1: less is; 0: neither. ``grain``: SI; differences below it do not matter to
    anybody, and limits are kept to it. ``needs_hits``: whether it takes a collision, not only a drawing.
    """

    label: str
    scale: str
    better: int
    grain: float
    needs_hits: bool = False


MEASURES: Mapping[str, Measure] = {
    "exit_speed": Measure("exit speed over this batter's contacts", "speed", 1, 0.02, True),
    "best": Measure("greatest exit speed", "speed", 1, 0.02, True),
    "best_from_tip": Measure("best place, from the tip", "place", 0, 0.001, True),
    "zone": Measure("width of the fast zone", "place", 1, 0.001, True),
    "sting": Measure("vibration at the hands over these contacts", "vibration", -1, 0.02, True),
    "bat_speed": Measure("bat speed", "speed", 0, 0.01),
    "swing_time": Measure("time to contact", "contact", -1, 1e-4),
    "mass": Measure("mass", "mass", 0, 0.0001),
    "balance_point": Measure("balance point", "length", 0, 0.0005),
    "moi": Measure("moment of inertia", "moi", 0, 2e-5),
    "length": Measure("length", "length", 0, 1e-5),
    "diameter": Measure("greatest diameter", "length", 0, 1e-5),
    "handle": Measure("smallest diameter of the grip", "length", 0, 1e-5),
    "cup_depth": Measure("depth of the cup", "length", 0, 1e-5),
    "cup_diameter": Measure("width of the cup", "length", 0, 1e-5),
    "knob": Measure("diameter of the knob", "length", 0, 1e-5),
    "blade_width": Measure("width of the blade", "length", 0, 1e-5),
    "blade_depth": Measure("depth of the blade", "length", 0, 1e-5),
    "blade_edge": Measure("thickness of the edges", "length", 0, 1e-5),
    "slope": Measure("steepest slope of the outline", "ratio", 0, 1e-3),
    "bend": Measure("sharpest bend of the outline", "curvature", 0, 1e-2),
    "waist": Measure("waist between two swellings", "length", 0, 1e-4),
    "density": Measure("density of the wood, over its species' mean", "ratio", 0, 1e-4),
    "bbcor": Measure("greatest BBCOR, in the test", "ratio", 0, 5e-4, True),
    "bpf": Measure("greatest BPF, in the test", "ratio", 0, 1e-3, True),
    "durability": Measure("durability: strain borne over the greatest", "ratio", 1, 0.005, True),
    "drop": Measure("drop: inches less ounces", "ratio", 0, 0.005),
    "frequency": Measure("first bending frequency", "frequency", 0, 0.5, True),
}


@dataclass(frozen=True)
class MeasuredDesigns:
    """Many bats, measured.

    ``values``: by measure, shape (n,). ``curve``: exit speed in m/s at `FROM_TIP` for a ball met in the middle, shape
    (n, places). ``worth``: the same with this batter's scatter above and below the axis, shape (n, places).
    """

    values: Mapping[str, Array]
    curve: Array
    worth: Array

    def __len__(self) -> int:
        return len(self.curve)

    def rows(self, index: Sequence[int] | IntArray) -> MeasuredDesigns:
        """Return some of the bats."""
        chosen = np.asarray(index, int)
        values = {name: value[chosen] for name, value in self.values.items()}
        return MeasuredDesigns(values, self.curve[chosen], self.worth[chosen])

    def followed_by(self, others: MeasuredDesigns) -> MeasuredDesigns:
        """Return these bats and then others."""
        values = {name: np.concatenate([value, others.values[name]]) for name, value in self.values.items()}
        both = ((self.curve, others.curve), (self.worth, others.worth))
        return MeasuredDesigns(values, *map(np.concatenate, both))


@dataclass(frozen=True)
class Bench:
    """Everything that stays the same while bats change: batter, ball, hands, and the losses of off-centre hits.

    Parameters
    ----------
    moi_now : kg m^2 of the present bat about the swing law's axis.
    sine, retained : sine of the line of centres' angle, and the part of the exit speed that is left.
    step : s of time in a hit.
    tested : whether every bat is also fired at as in the tests of BBCOR and BPF.
    breaking : what strains are held against where durability is asked for; None: it is not.
    """

    space: Space
    batter: Batter
    conditions: Conditions
    moi_now: float
    sine: Array
    retained: Array
    step: float = STEP
    tested: bool = False
    breaking: StrainLimits | None = None

    def measured(self, numbers: Array) -> MeasuredDesigns:
        """Return everything about the bats of many rows of numbers, shape (n, variables)."""
        numbers = np.atleast_2d(numbers)
        shapes = self.space.shapes(numbers)
        bats = self.space.reduced(numbers, ball=self.conditions.ball)
        position = bats.bending.length[:, None] - FROM_TIP
        widths = self.space.widths_at(numbers, position)
        if self.breaking is None:
            return self.of_bats(bats, widths, shapes=shapes)
        along = np.tile(self.breaking.position, (len(numbers), 1))
        handles = Handles(self.space.beams(numbers), self.space.widths_at(numbers, along))
        return self.of_bats(bats, widths, shapes=shapes, handles=handles)

    def of_bats(
        self,
        bats: ReducedBats,
        widths: Array,
        *,
        shapes: Mapping[str, Array] = NO_SHAPES,
        handles: Handles | None = None,
    ) -> MeasuredDesigns:
        """Return everything about bats that are reduced already.

        ``widths``: their diameters at `FROM_TIP`, m, shape (n, places). ``handles``: of the same bats; None: durability
        is left out.
        """
        ball, pitch = self.conditions.ball, self.batter.pitch_speed
        bending, pivot = bats.bending, self.conditions.swing.pivot
        position = bending.length[:, None] - FROM_TIP
        ratio, turning = self.speed_ratio(bats), self.turning_speed(bats)
        speed = turning[:, None] * (position - pivot)
        impacts = struck(
            bats, ball=ball, position=position, closing_speed=pitch + speed, step=self.step, keep_motion=True
        )
        efficiency = np.where(np.isfinite(impacts.collision_efficiency), impacts.collision_efficiency, -1.0)
        curve = efficiency * pitch + (1 + efficiency) * speed
        worth = np.maximum(curve, 0.0) * self.retained_of(widths)
        steps, best = tops(curve)
        values = dict(shapes) | {
            "exit_speed": worth @ self.batter.weight,
            "best": best,
            "best_from_tip": FROM_TIP[0] + steps * (FROM_TIP[1] - FROM_TIP[0]),
            "zone": _zone(curve, best - ZONE_LOSS),
            "sting": stings(bats, impacts, hands=self.conditions.hands) @ self.batter.weight,
            "bat_speed": turning * (bending.length - self.batter.speed_from_tip - pivot),
            "swing_time": SWING_TIME / ratio,
            **weights_of(bending),
        }
        if self.tested:
            game = swung_test(self.space.present, ball).closing_speed
            fast, slow = (self._fired(bats, position, test_speed) for test_speed in (game, BPF_SPEED))
            values |= {"bbcor": fast, "bpf": bpf(1.0, ball_restitution=ball.restitution.at(BPF_SPEED)) * slow}
        if self.breaking is not None and handles is not None:
            hits = BatterHits(impacts, position, pitch + speed, ball.mass)
            values["durability"] = strain_margins(self.breaking, handles, bats, hits)
        return MeasuredDesigns(values, curve, worth)

    def _fired(self, bats: ReducedBats, position: Array, speed: float) -> Array:
        """Return the greatest ball-bat restitution of bats at rest that turn about the clamp, shape (n,)."""
        ball = self.conditions.ball
        fired = struck(bats, ball=ball, position=position, closing_speed=0 * position + speed, step=self.step)
        recoil = ball.mass * (position - STANDARD_AXIS) ** 2 / bats.bending.moi(STANDARD_AXIS)[:, None]
        return tops(restitution_from_efficiency(fired.collision_efficiency, recoil=recoil))[1]

    def speed_ratio(self, bats: ReducedBats, exponent: float | None = None) -> Array:
        """Return angular speed over that with the present bat, shape (n,)."""
        law = self.batter.law
        if law is None:
            return np.ones(len(bats))
        moi = bats.bending.moi(self.space.present.choke + law.axis)
        return speed_ratios(law, moi, self.moi_now, exponent)

    def turning_speed(self, bats: ReducedBats) -> Array:
        """Return the angular speed at which the batter turns bats, rad/s, shape (n,)."""
        arm = self.space.present.length - self.batter.speed_from_tip - self.conditions.swing.pivot
        return self.speed_ratio(bats) * self.batter.bat_speed / arm

    def retained_of(self, widths: Array) -> Array:
        """Return the part of the exit speed that this batter's scatter about the axis leaves, of the widths' shape."""
        return np.asarray(self._keeping(np.minimum(widths, self._keeping.x[-1])))

    @cached_property
    def _keeping(self) -> PchipInterpolator:
        from scipy.interpolate import PchipInterpolator

        return PchipInterpolator(
            WIDTHS, retained_at_widths(self.sine, self.retained, batter=self.batter, ball=self.conditions.ball)
        )


def weights_of(bending: BendingBatch) -> dict[str, Array]:
    """Return mass, balance point, moment of inertia and drop of many bats, by measure."""
    weights = {
        "mass": bending.mass,
        "balance_point": bending.balance_point,
        "moi": bending.moi(STANDARD_AXIS),
        "drop": bending.length / INCH - bending.mass / OUNCE,
    }
    return weights | ({"frequency": bending.frequency[:, 0]} if bending.omega.shape[1] else {})


def speed_ratios(law: SwingLaw, moi: Array, reference: float, exponent: float | None = None) -> Array:
    """Return angular speeds over that with the reference's moment of inertia (kg m^2), of the shape of ``moi``."""
    return np.array([law.speed_ratio(float(each), reference_moi=reference, exponent=exponent) for each in moi])


def bench_of(space: Space, batter: Batter, conditions: Conditions, *, durable: bool = False) -> Bench:
    """Return the bench on which the bats of a space are measured for a batter."""
    from sweetspot.dynamics.beam import beam_model
    from sweetspot.dynamics.rigid import rigid_body

    present = space.present
    beam = beam_model(present)
    body = rigid_body(beam)
    if body.mass <= conditions.ball.mass:
        raise InputError(f"{present.name} weighs {body.mass:.4g} kg, no more than the ball; give a heavier one")
    axis = present.choke + (0.0 if batter.law is None else batter.law.axis)
    sine, retained = (
        off_centre(present, conditions.ball, batter)
        if isinstance(present, Bat)
        else (
            np.array([0.0, 1e9]),
            np.array([1.0, 1.0]),  # a flat face keeps everything wherever it is met
        )
    )
    step = STEP
    if present.face is not None or (isinstance(present, Bat) and present.shell is not None):
        from sweetspot.dynamics.batch.reduction import reduced_beams

        step = contact_step(reduced_beams([beam], ball=conditions.ball).modes(0), conditions.ball, longest=STEP)
    hollow = isinstance(present, Bat) and present.shell is not None
    if durable and not isinstance(present, Bat):
        raise InputError(f"{present.name} is no bat with a round handle; its durability is not computed. Leave it out")
    built = space.made(space.start, present.name) if durable else None
    breaking = strain_limits_of(built, batter) if isinstance(built, Bat) else None
    return Bench(space, batter, conditions, body.moi(axis), sine, retained, step, tested=hollow, breaking=breaking)


def _zone(curve: Array, least: Array) -> Array:
    """Return the length over which every curve over `FROM_TIP` lies above a speed, m, shape (n,).

    Between the places the curves are piecewise cubics that never overshoot, so the width changes without steps.
    """
    from scipy.interpolate import PchipInterpolator, PPoly

    cubics = PchipInterpolator(FROM_TIP, curve - least[:, None], axis=1).c  # (4, places - 1, n)
    widths = []
    for row in range(len(curve)):
        above = PPoly(cubics[..., row], FROM_TIP)
        ends = np.concatenate([FROM_TIP[:1], above.roots(extrapolate=False), FROM_TIP[-1:]])
        widths.append(np.diff(ends)[above((ends[1:] + ends[:-1]) / 2) > 0].sum())
    return np.array(widths)

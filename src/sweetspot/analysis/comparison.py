"""Bats side by side, in the hands of one player: what each gains or loses, and how surely.

The first bat is the reference: the swing is known with it. Another bat is swung with the same effort (slower or
faster as its moment of inertia says) or at the same speed. So is a bat that was changed, or is choked up, beside the
bat that it was.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import partial
from typing import Generic

import numpy as np

from sweetspot.analysis.bat_analysis import Analysis, analyse_reduced
from sweetspot.collision.closed_form import exit_speed
from sweetspot.collision.kernel import hits
from sweetspot.dynamics.beam import beam_model
from sweetspot.dynamics.modes import Modes
from sweetspot.dynamics.reduction import Given, ReducedBat, Tool_co, reduced_bat
from sweetspot.dynamics.rigid import RigidBody, rigid_body
from sweetspot.equipment.bat import Bat
from sweetspot.equipment.implement import Implement
from sweetspot.errors import InputError
from sweetspot.motion.swing import Conditions
from sweetspot.motion.swing_law import SwingLaw, turned_faster
from sweetspot.numerics.arrays import Array
from sweetspot.numerics.interpolants import peak
from sweetspot.numerics.interval import Interval
from sweetspot.numerics.notebook_display import ShownInNotebooks
from sweetspot.plausibility import insisted
from sweetspot.plausibility.table import MAX_SPEED

ACCURACY = 1e-9
"""m/s of exit speed to which a break-even bat speed is found."""
LAST_STEP = 1e-6
"""m/s of bat speed below which a step is not tried: the slope that it follows is known to far better than 1e-3."""
TRIALS = 30
USUAL_SLOPE = 1.2
"""About 1 + q: exit speed gained by bat speed, where no two swings tell."""


@dataclass(frozen=True)
class Compared(Generic[Tool_co]):
    """One bat of a comparison.

    Parameters
    ----------
    collision_efficiency, bbcor : the greatest on the barrel, at the closing speed of this swing.
    bat_speed : m/s where the swing is measured, equally far from the tip for all bats.
    exit_speed : m/s, the greatest along the bat.
    change : m/s of ``exit_speed`` against the reference's.
    break_even : m/s of bat speed with which the bat's greatest exit speed is the reference's; nan where none would do.
    """

    label: str
    analysis: Analysis[Tool_co]
    collision_efficiency: float
    bbcor: float
    bat_speed: Interval
    exit_speed: Interval
    change: Interval
    break_even: float

    def exit_speed_from_tip(self, distances: Array) -> Array:
        """Return the exit speed in m/s of hits ``distances`` m from the tip; nan beyond the scan."""
        scan = self.analysis.scan
        places = self.analysis.bat.length - distances
        return np.interp(places, scan.position, scan.exit_speed, left=np.nan, right=np.nan)


@dataclass(frozen=True, repr=False)
class Comparison(ShownInNotebooks, Generic[Tool_co]):
    """Bats side by side, the reference first; ``law`` is None when all are swung at the same speed.

    The intervals hold the spread of the law's exponent and nothing else.

    ``compared``: every bat with its analysis, bat speed, exit speed and change, the reference first.
    """

    compared: tuple[Compared[Tool_co], ...]
    law: SwingLaw | None

    def __repr__(self) -> str:
        """Return the labels of the compared bats."""
        return f"<Comparison of {', '.join(compared.label for compared in self.compared)}>"

    @property
    def reference(self) -> Compared[Tool_co]:
        """The bat that the others are measured against."""
        return self.compared[0]


def compare(
    bats: Sequence[Given], *, conditions: Conditions, law: SwingLaw | None, labels: Sequence[str] | None = None
) -> Comparison[Given]:
    """Return any number of bats under one player's swing.

    ``conditions``: of the first bat. The others are hit by the same pitch; their pivot and hands move with their grip,
    and their speed is measured equally far from the tip.
    ``law``: of bat speed against moment of inertia, as `catalog.swing_law` has them: the same effort for every bat.
    None: the same bat speed at the measured place. ``labels``: one per bat; None: their names.

    >>> from sweetspot import catalog, standard_conditions
    >>> from sweetspot.analysis.comparison import compare
    >>> bats = [catalog.bat("r161-ash"), catalog.bat("corked-r161")]
    >>> comparison = compare(bats, conditions=standard_conditions(bats[0]), law=catalog.swing_law())
    >>> corked = comparison.compared[1]
    >>> round(corked.bat_speed.value, 1), round(corked.change.value, 1)  # m/s: swung faster, and what the ball loses
    (32.2, -0.3)
    """
    _check_alike(bats)
    reductions = [reduced_bat(bat, ball=conditions.ball) for bat in bats]
    return compare_reduced(reductions, conditions=conditions, law=law, labels=labels)


def _check_alike(bats: Sequence[Implement]) -> None:
    """Refuse implements of different sports, unless all are round bats, or ``--force`` is given."""
    strangers = [bat for bat in bats if type(bat) is not type(bats[0]) or bat.sport != bats[0].sport]
    if strangers and not insisted() and not all(isinstance(bat, Bat) for bat in bats):
        first, other = bats[0], strangers[0]
        raise InputError(
            f"{first.name} is of {first.sport} and {other.name} of {other.sport}; both would be hit by the ball of the "
            "first. Compare implements of one sport, or add --force if it is intended"
        )


def compare_reduced(
    reductions: Sequence[ReducedBat[Given]],
    *,
    conditions: Conditions,
    law: SwingLaw | None,
    labels: Sequence[str] | None = None,
) -> Comparison[Given]:
    """Return any number of bats, whose modes are known already, under one player's swing; see `compare`."""
    if not reductions:
        raise InputError("no bat was given; give at least one, and two to compare them")
    if labels is not None and len(labels) != len(reductions):
        raise InputError(f"{len(labels)} labels were given for {len(reductions)} bats; give one for each")
    first = reductions[0]
    rows: list[Compared[Given]] = []
    names = labels or [reduced.bat.name for reduced in reductions]
    for reduced, label in zip(reductions, names, strict=True):
        bat, reference = reduced.bat, first.bat
        ratios = Interval(1.0, 1.0, 1.0) if law is None else speed_ratios(law, bat, reduced.body, reference, first.body)
        every = [None if law is None else ratio for ratio in (ratios.value, ratios.low, ratios.high)]
        of_ratio = {
            ratio: swung_conditions(bat, reference=reference, conditions=conditions, ratio=ratio)
            for ratio in set(every)  # the reference's are one
        }
        swung = [of_ratio[ratio] for ratio in every]
        rows.append(_compared(label, analyse_reduced(reduced, swung[0]), swung, rows[0] if rows else None))
    return Comparison(tuple(rows), law)


def speed_ratios(
    law: SwingLaw, bat: Implement, body: RigidBody, reference: Implement, reference_body: RigidBody
) -> Interval:
    """Return omega / omega_0 of a bat against the reference with the law's 90 % interval.

    The moment of inertia is taken about the law's axis, counted from the bottom of each bat's grip.
    """
    moi, reference_moi = body.moi(bat.choke + law.axis), reference_body.moi(reference.choke + law.axis)
    exponents = law.exponents
    ratios = [
        law.speed_ratio(moi, reference_moi=reference_moi, exponent=power)
        for power in (exponents.value, exponents.low, exponents.high)
    ]
    return Interval(ratios[0], min(ratios), max(ratios))


def swung_conditions(
    bat: Implement, *, reference: Implement, conditions: Conditions, ratio: float | None
) -> Conditions:
    """Return the conditions of another bat in the same player's hands.

    ``ratio``: of the angular speeds; None: the same bat speed where it is measured.
    """
    moved = bat.choke - reference.choke
    swing, hands = conditions.swing, conditions.hands
    pivot = swing.pivot + moved
    measured_at = (
        swing.measured_at if bat.length == reference.length else bat.length - reference.length + swing.measured_at
    )
    if ratio is None:
        swung = swing.replaced(measured_at=measured_at, pivot=pivot)
    else:
        swung = turned_faster(swing, ratio, measured_at=measured_at, pivot=pivot)
    return conditions.replaced(swing=swung, hands=hands.replaced(position=hands.position + moved))


def best_exit_speeds(modes: Modes, positions: Array, swung: Sequence[Conditions]) -> list[float]:
    """Return the greatest exit speed in m/s of hits at ``positions`` (m from the knob end, increasing), swing by swing.

    All swings meet the same ball.
    """
    bat_speeds = [bat.swing.angular_speed * (positions - bat.swing.pivot) for bat in swung]
    pitches = [bat.pitch.speed for bat in swung]
    closing = np.concatenate([pitch + speed for pitch, speed in zip(pitches, bat_speeds, strict=True)])
    outcome = hits(modes, ball=swung[0].ball, position=np.tile(positions, len(swung)), closing_speed=closing)
    shared = np.split(outcome.collision_efficiency, len(swung))
    return [
        peak(exit_speed(efficiency, ball_speed=pitch, bat_speed=speed))
        for efficiency, pitch, speed in zip(shared, pitches, bat_speeds, strict=True)
    ]


def _break_even_speed(
    best: Callable[[Sequence[Conditions]], list[float]],
    *,
    swung: Sequence[Conditions],
    exits: Interval,
    exit_speed: float,
) -> float:
    """Return the bat speed in m/s, where the swing measures it, that gives this greatest exit speed; nan where none.

    The secant method, from the most likely, slowest and fastest swing with their greatest exit speeds.
    """
    speeds = [conditions.swing.bat_speed for conditions in swung]
    apart, speed, miss = max(speeds) - min(speeds), speeds[0], exits.value - exit_speed
    slope = (exits.high - exits.low) / apart if apart else USUAL_SLOPE
    for _ in range(TRIALS):
        step = -miss / slope
        if abs(miss) < ACCURACY or not 0 < speed + step <= MAX_SPEED:
            break
        if abs(step) < LAST_STEP:
            return speed + step
        faster = swung[0].replaced(swing=swung[0].swing.replaced(bat_speed=speed + step))
        after = best([faster])[0] - exit_speed
        slope, speed, miss = (after - miss) / step, speed + step, after
    return speed if abs(miss) < ACCURACY else math.nan


def _compared(
    label: str, analysis: Analysis[Given], swung: list[Conditions], reference: Compared[Given] | None
) -> Compared[Given]:
    body, along = analysis.body, analysis.scan
    outer = along.position > body.balance_point
    best = partial(best_exit_speeds, analysis.modes, along.position[outer])
    fastest = peak(along.exit_speed[outer])
    alike = all(bat.swing == swung[0].swing for bat in swung)  # the reference's are, and all at the same speed
    exits = Interval(fastest, fastest, fastest) if alike else Interval(fastest, *best(swung[1:]))
    reference_speed = exits.value if reference is None else reference.exit_speed.value
    return Compared(
        label=label,
        analysis=analysis,
        collision_efficiency=peak(along.collision_efficiency[outer]),
        bbcor=peak(along.bbcor[outer]),
        bat_speed=Interval(*(conditions.swing.bat_speed for conditions in swung)),
        exit_speed=exits,
        change=exits.shifted(-reference_speed),
        break_even=_break_even_speed(best, swung=swung, exits=exits, exit_speed=reference_speed),
    )


@dataclass(frozen=True)
class ChangedBat:
    """A changed bat beside the bat that it was.

    ``before``, ``body_before``: the bat that the player's speed is known with. ``law``: how bat speed depends on the
    bat's moment of inertia.
    """

    bat: Implement
    body: RigidBody
    before: Implement
    body_before: RigidBody
    law: SwingLaw

    @classmethod
    def of(cls, bat: Implement, *, law: SwingLaw) -> ChangedBat:
        """Return a bat paired with what it was before it was changed, by its own description."""
        before = bat.before_changes()
        return cls(bat, rigid_body(beam_model(bat)), before, rigid_body(beam_model(before)), law)

    @property
    def ratio(self) -> float:
        """Angular speed of the changed bat over that of the bat as it was, with the same effort."""
        return speed_ratios(self.law, self.bat, self.body, self.before, self.body_before).value

    def with_same_effort(self, conditions: Conditions) -> Conditions:
        """Return the conditions of the same player's swing of the changed bat.

        ``conditions``: with the pivot and hands of the changed bat's grip, and the bat speed of the bat as it was.
        """
        swing, grip = conditions.swing, self.bat.choke - self.before.choke
        gripped = swing.replaced(pivot=swing.pivot - grip)
        turned = turned_faster(gripped, self.ratio, measured_at=swing.measured_at, pivot=swing.pivot)
        return conditions.replaced(swing=turned)

    def speed_before(self, conditions: Conditions) -> float:
        """Return the bat speed in m/s of the bat as it was, from the changed bat's swing with the same effort."""
        swing, grip = conditions.swing, self.bat.choke - self.before.choke
        return swing.angular_speed / self.ratio * (swing.measured_at - swing.pivot + grip)

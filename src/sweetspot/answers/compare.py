"""Implements side by side in one player's hands: what each gains or loses, how surely, and which keep the rules."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from types import MappingProxyType
from typing import Annotated

import numpy as np

from sweetspot.analysis.bat_analysis import Analysis
from sweetspot.analysis.comparison import Compared, Comparison, compare
from sweetspot.analysis.strain import breaking_speed, damage
from sweetspot.answers.answer import Answer, DrawnAnswer, Uncertainty, uncertainty_of
from sweetspot.answers.certify import CertifyAnswer
from sweetspot.answers.conditions import HitConditions, MassProperties, hit_conditions, mass_columns, mass_properties
from sweetspot.answers.handling import Handling, HitBeside, handling_of, hits_beside
from sweetspot.answers.kept_rules import RulesKept, certificate_of_sport, rules_kept
from sweetspot.answers.paddle_numbers import PaddleFace, paddle_in_doubt
from sweetspot.answers.records import (
    INTERNAL,
    NESTED,
    Columns,
    Frequency,
    Length,
    MomentOfInertia,
    Ratio,
    Speed,
    with_intervals,
)
from sweetspot.answers.worth_measuring import WorthMeasuring, worth_measuring_of
from sweetspot.collision.coupled import hit
from sweetspot.dynamics.modes import Family
from sweetspot.equipment.bat import Bat
from sweetspot.equipment.implement import Implement
from sweetspot.motion.swing import Conditions
from sweetspot.motion.swing_law import SwingLaw
from sweetspot.numerics.arrays import Array
from sweetspot.numerics.interval import Curve, Number
from sweetspot.uncertainty.comparison_draws import (
    AMOUNT,
    LAW,
    DrawnBat,
    DrawnComparison,
    Ends,
    drawn_comparison,
    linear_comparison,
    names_of_bats,
    narrowings_of_changes,
)
from sweetspot.uncertainty.intervals import linear_reach, reach_of_draws
from sweetspot.uncertainty.sources import DRAWS, Sources
from sweetspot.units import INCH, MPH
from sweetspot.units.dimensions import LENGTH, SPEED

ALIKE = "none: everything is just as described"
LINEAR = "90 %, by straight lines, of all that is not known: bats, ball, swing, swing law"
DRAWN = "90 % of draws of all that is not known: bats, ball, swing, swing law"
"""What intervals hold where no sources are given, without draws (`linear_comparison`), and with them."""

JAMMED, USUAL_CLOSING = 12 * INCH, 150 * MPH
"""m from the tip, of a hit that breaks bats [our choice], and the closing speed in m/s from which its breaking speed is
sought, whatever it is."""

SpeedWithEnds = Annotated[Number, SPEED, NESTED]


@dataclass(frozen=True)
class EffortLaw:
    """The law by which bats are swung with the same effort; see `SwingLaw`.

    ``axis_from_grip``: where the moment of inertia counts, from the bottom of the grip. ``lightest_moi``: below which a
    bat is swung no faster.
    """

    name: str
    exponent: Annotated[Number, NESTED]
    axis_from_grip: Length
    lightest_moi: MomentOfInertia


@dataclass(frozen=True)
class ComparedCurves:
    """Exit speed along one implement, from the knob end, arrays of shape (n,).

    ``change``: against the first one, equally far from the tip; nan where nothing of the kind is known.
    """

    position: Annotated[Array, LENGTH]
    exit_speed: Annotated[Curve, SPEED]
    change: Annotated[Curve, SPEED, INTERNAL]


@dataclass(frozen=True, kw_only=True)
class ComparedBat:
    """One implement of a comparison, the first one being the reference; see `Compared`.

    Parameters
    ----------
    bending_1, hoop_1 : the lowest tones of bending and of the wall; nan where it has none.
    max_collision_efficiency, max_bbcor : the greatest on the barrel.
    bat_speed, exit_speed : where the swing is measured, and the greatest along it.
    change, swung_faster : exit speed and bat speed against the reference's.
    break_even_bat_speed : with which the ball leaves as fast as from the reference; nan where none would do.
    max_exit_speed : the best place, from the knob end.
    handling, off_center : of rackets, see `Handling`; hits beside the middle of what has a flat face.
    paddle : numbers of a paddle, with what it does in the test of its rules; None: not asked, or no paddle.
    breaking_speed : closing speed from which on a hit 12 in from the tip breaks the handle of a wooden bat; nan: not of
        wood, not known, or not asked, as in `compare_of`. See `sweetspot.analysis.strain.breaking_speed`.
    rules : whether it keeps those of its own sport; None: that was not asked, or it has none.
    worth_measuring : what would narrow the interval of the change, without draws.
    """

    label: str
    bat: MassProperties
    bending_1: Frequency
    hoop_1: Frequency
    max_collision_efficiency: Ratio
    max_bbcor: Ratio
    bat_speed: SpeedWithEnds
    exit_speed: SpeedWithEnds
    change: SpeedWithEnds
    break_even_bat_speed: Speed
    max_exit_speed: Length
    zone: Annotated[tuple[float, float] | None, LENGTH]
    scan: ComparedCurves
    breaking_speed: Speed = float("nan")
    rules: RulesKept | None = None
    handling: Handling | None = None
    paddle: PaddleFace | None = None
    off_center: tuple[HitBeside, ...] = ()
    worth_measuring: tuple[WorthMeasuring, ...] = ()
    swung_faster: Annotated[Speed, INTERNAL]
    compared: Annotated[Compared[Implement], INTERNAL]
    certificate: Annotated[CertifyAnswer | None, INTERNAL] = None


@dataclass(frozen=True)
class BatGain:
    """How much faster than from the first bat the ball leaves, and how probable it is that it does."""

    label: str
    exit_speed_gain: Speed
    faster_probability: float


@dataclass(frozen=True)
class ComparisonUncertainty(Uncertainty):
    """The intervals of a comparison, and the probability of each bat's gain over the first."""

    gains: tuple[BatGain, ...]


@dataclass(frozen=True, kw_only=True)
class CompareAnswer(Answer):
    """Implements side by side.

    Parameters
    ----------
    reference : label of the first.
    same : what is the same for all of them: "effort" or "speed".
    interval : what the intervals hold.
    conditions : of the first.
    uncertainty : of the last one's change, where draws were made.
    sources : what is not known, one by one; none: no intervals were asked.
    """

    reference: str
    same: str
    swing_law: EffortLaw | None
    interval: str
    bats: tuple[ComparedBat, ...]
    conditions: HitConditions
    uncertainty: ComparisonUncertainty | None = None
    comparison: Annotated[Comparison[Implement], INTERNAL]
    sources: Annotated[tuple[Sources, ...], INTERNAL] = ()


@dataclass(frozen=True)
class CompareQuestion:
    """A comparison that is asked for.

    Parameters
    ----------
    conditions, law, labels : see `compare`.
    sources : what is not known, one by one; None: no intervals.
    drawn : whether the intervals come from draws, with what they come from; else every source is one standard deviation
        up and down.
    rules : whether bats are held against the rules of their own sport.
    draws : a power of two.
    ends : of each, what it is at both ends of what cannot be known of how it was changed; None: all is known.
    """

    implements: Sequence[Implement]
    conditions: Conditions
    law: SwingLaw | None
    labels: Sequence[str] | None = None
    sources: Sequence[Sources] | None = None
    drawn: bool = False
    rules: bool = False
    draws: int = field(default=DRAWS, kw_only=True)
    ends: Sequence[tuple[Implement, Implement] | None] = field(default=(), kw_only=True)


def compare_answer(question: CompareQuestion) -> CompareAnswer:
    """Return implements side by side.

    Raises
    ------
    InputError
        without one, of different sports, or when one of them or its swing is refused; see `compare`.
    """
    comparison = compare(question.implements, conditions=question.conditions, law=question.law, labels=question.labels)
    ends = {number: _ends(question, both) for number, both in enumerate(question.ends) if both is not None}
    answer = compare_of(comparison, question.sources, drawn=question.drawn, draws=question.draws, ends=ends)
    doubts = [None] * len(answer.bats) if question.sources is None else [each.doubt for each in question.sources]
    bats = (
        replace(
            bat,
            breaking_speed=_breaking_speed(bat.compared.analysis),
            paddle=paddle_in_doubt(bat.compared.analysis.bat, bat.compared.analysis.body, doubt),
        )
        for bat, doubt in zip(answer.bats, doubts, strict=True)
    )
    answer = replace(answer, bats=tuple(bats))
    return _with_rules(answer) if question.rules else answer


def _ends(
    question: CompareQuestion, both: tuple[Implement, Implement]
) -> tuple[Compared[Implement], Compared[Implement]]:
    """Return a changed implement at both ends of how far it may have been changed, beside the first."""
    found = compare([question.implements[0], *both], conditions=question.conditions, law=question.law)
    _, low, high = found.compared
    return low, high


def compare_of(
    comparison: Comparison[Implement],
    sources: Sequence[Sources] | None = None,
    *,
    drawn: bool = False,
    draws: int = DRAWS,
    ends: Ends = MappingProxyType({}),
) -> CompareAnswer:
    """Return the answer of a comparison; see `CompareQuestion`. ``ends``: see there, by number of the implement."""
    plain = _described(comparison)
    if sources is None:
        return plain
    plain = replace(plain, sources=tuple(sources))
    if not drawn:
        straight = linear_comparison(comparison, sources, ends)
        sure = with_intervals(replace(plain, interval=LINEAR), _columns(straight), linear_reach)
        narrower = narrowings_of_changes(straight, comparison, sources)
        bats = (
            replace(bat, worth_measuring=worth_measuring_of(each, [plain.reference, bat.label]))
            for bat, each in zip(sure.bats, narrower, strict=True)
        )
        return replace(sure, bats=tuple(bats))
    found = drawn_comparison(comparison, sources, count=draws, ends=ends)
    sure = with_intervals(replace(plain, interval=DRAWN), _columns(found), reach_of_draws)
    return replace(sure, uncertainty=_uncertainty(sure, found))


def _described(comparison: Comparison[Implement]) -> CompareAnswer:
    """Return a comparison of implements just as they are described."""
    law, reference = comparison.law, comparison.reference
    return CompareAnswer(
        reference=reference.label,
        same="speed" if law is None else "effort",
        swing_law=None if law is None else EffortLaw(law.name, law.exponents, law.axis, law.lightest_moi),
        interval=ALIKE,
        bats=tuple(_compared_bat(each, reference) for each in comparison.compared),
        conditions=hit_conditions(reference.analysis.conditions),
        comparison=comparison,
    )


def _compared_bat(bat: Compared[Implement], reference: Compared[Implement]) -> ComparedBat:
    analysis, scan, first = bat.analysis, bat.analysis.scan, reference.analysis
    there = scan.position + (first.bat.length - analysis.bat.length)  # equally far from the tip
    before = np.interp(there, first.scan.position, first.scan.exit_speed, left=np.nan, right=np.nan)
    return ComparedBat(
        label=bat.label,
        bat=mass_properties(analysis.bat, analysis.body),
        bending_1=_lowest(bat, "bending"),
        hoop_1=_lowest(bat, "hoop"),
        max_collision_efficiency=bat.collision_efficiency,
        max_bbcor=bat.bbcor,
        bat_speed=bat.bat_speed.value,
        exit_speed=bat.exit_speed.value,
        change=bat.change.value,
        break_even_bat_speed=bat.break_even,
        max_exit_speed=analysis.sweet_spots.max_exit_speed,
        zone=analysis.sweet_spots.zone,
        handling=handling_of(analysis.bat, analysis.body),
        off_center=hits_beside(analysis.bat, analysis.body, analysis.modes, analysis.conditions),
        scan=ComparedCurves(scan.position, scan.exit_speed, scan.exit_speed - before),
        swung_faster=bat.bat_speed.value - reference.bat_speed.value,
        compared=bat,
    )


def _breaking_speed(analysis: Analysis[Implement]) -> float:
    """Return the closing speed in m/s from which on a jammed hit breaks a wooden bat; nan where it is not known."""
    bat, ball = analysis.bat, analysis.conditions.ball
    if not isinstance(bat, Bat) or bat.shell is not None or bat.length <= JAMMED:
        return float("nan")
    beam, modes = analysis.beam, analysis.modes
    impact = hit(modes, ball=ball, position=bat.length - JAMMED, closing_speed=USUAL_CLOSING)
    found = breaking_speed(impact, damage(impact, beam=beam, modes=modes), beam=beam, modes=modes, ball=ball)
    return float("nan") if found is None else found[0]


def _lowest(bat: Compared[Implement], family: Family) -> float:
    """Return the lowest frequency in Hz of a family of modes; nan where there is none."""
    modes = bat.analysis.modes
    return min(map(float, modes.frequency[modes.of_family(family)]), default=float("nan"))


def _columns(found: DrawnComparison) -> Columns:
    """Return the sampled answers, by the fields of `CompareAnswer`."""
    return {"bats": [_columns_of(bat, first=number == 0) for number, bat in enumerate(found.bats)]}


def _columns_of(bat: DrawnBat, *, first: bool) -> Columns:
    columns: dict[str, Array | Columns] = {
        "bat": mass_columns(bat.draws) if bat.draws.sources.unknowns else {},
        "max_collision_efficiency": bat.max_collision_efficiency,
        "max_bbcor": bat.max_bbcor,
        "bat_speed": bat.bat_speed,
        "exit_speed": bat.exit_speed,
        "change": bat.change,
        "scan": {"exit_speed": bat.exit_speed_along} | ({} if first else {"change": bat.change_along}),
        "swung_faster": bat.swung_faster,
    }
    more = {"break_even_bat_speed": bat.break_even, "bending_1": bat.bending_1}
    return {**columns, **{name: column for name, column in more.items() if column is not None}}


def _uncertainty(answer: CompareAnswer, found: DrawnComparison) -> ComparisonUncertainty:
    """Return the probabilities of the gains, and the sources of the last bat's change, or else of the exit speed."""
    last = len(found.bats) - 1
    main = "change" if last else "exit_speed"
    labels = names_of_bats(answer.comparison)
    of_bats = {label: each.bat_where for label, each in zip(labels, answer.sources, strict=True)}
    others = {other.name: other.where for other in answer.sources[0].others}
    others |= {AMOUNT.format(label=label): "the range of its amount" for label in labels}
    sampled = uncertainty_of(
        DrawnAnswer(found.normal, _columns(found)),
        of=f"bats.{last}.{main}",
        names=found.names,
        sources={**of_bats, **others, LAW: "spread of its exponent in the catalogue"},
    )
    gains = tuple(
        BatGain(bat.label, bat.change, chance_above_zero(drawn.change))
        for bat, drawn in zip(answer.bats[1:], found.bats[1:], strict=True)
    )
    return ComparisonUncertainty(**vars(sampled), gains=gains)


def chance_above_zero(values: Array) -> float:
    """Return the part of the draws above zero, the first left out; of those at zero one half."""
    drawn = values[1:]
    return float(np.mean(drawn > 0) + np.mean(drawn == 0) / 2)


def _with_rules(answer: CompareAnswer) -> CompareAnswer:
    """Return a comparison whose bats are held against the rules of their own sport."""
    bats = []
    for bat in answer.bats:
        implement = bat.compared.analysis.bat
        certificate = certificate_of_sport(implement) if isinstance(implement, Bat) else None
        rules = None if certificate is None else rules_kept(certificate)
        bats.append(replace(bat, rules=rules, certificate=certificate))
    return replace(answer, bats=tuple(bats))

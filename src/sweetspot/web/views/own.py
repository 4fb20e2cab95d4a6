"""Own bat: from a scale, a balance point, a pendulum and a tap to the bat that one has in hand, and how sure it is.

Rackets, cricket bats, clubs and sticks go the same way, by weight, balance, swing weight and the first tone.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from shlex import quote
from typing import Literal, get_args

from sweetspot.analysis.certification.rules import Finding, check_rules, construction_findings
from sweetspot.answers.calibrate import CalibrateAnswer
from sweetspot.answers.certify import RuleCheck, rule_check
from sweetspot.answers.conditions import MassProperties, mass_properties
from sweetspot.answers.records import MomentOfInertia
from sweetspot.calibration.measurements import MeasuredKind, predicted
from sweetspot.calibration.unknowns import described as beam_of
from sweetspot.catalog.rules import league, usual_league
from sweetspot.designs.variables import sizes_of
from sweetspot.dynamics.beam import beam_model
from sweetspot.dynamics.rigid import RigidBody, moi_doubt, rigid_body
from sweetspot.dynamics.swing_weight import pendulum_period
from sweetspot.equipment.bat import Bat
from sweetspot.equipment.implement import Implement
from sweetspot.equipment.sport import Terms
from sweetspot.numerics.interval import REACH
from sweetspot.reports.calibration.document import (
    SCALE_OF,
    VALUES,
    assumption_words,
    budget_words,
    called,
    contradictions,
    density_words,
    moi_words,
    parts_of,
    source_words,
    unknown_words,
)
from sweetspot.reports.calibration.page_words import own_headline, should_words, unfitted_words
from sweetspot.reports.sentences import Sentence, say
from sweetspot.reports.sport_words import words_of
from sweetspot.units import INCH, OUNCE, OUNCE_INCH_SQUARED
from sweetspot.units.dimensions import System
from sweetspot.web.bat_bounds import Range
from sweetspot.web.documents import Sentences, in_both_systems, in_either_system
from sweetspot.web.drawings import BenchBat, bench_bat
from sweetspot.web.errors import FieldError, about
from sweetspot.web.recipes import BAT_FILE, bat_name, bat_text, option
from sweetspot.web.view import View
from sweetspot.web.views.own_state import (
    FARTHEST_PIVOT,
    OwnState,
    ToneName,
    answer_of,
    measurements_of,
    name_of,
    own_of,
    pivot_of,
    unknown_of,
)
from sweetspot.web.views.own_tap import ExpectedTone, expected_tones, expected_words, tap

MeasuredField = Literal["weighed_oz", "balanced_in", "pendulum_ms", "swing_weight_oz_in2", "pivot_in"]
FIELDS: dict[MeasuredKind, MeasuredField] = {
    "mass": "weighed_oz",
    "balance_point": "balanced_in",
    "period": "pendulum_ms",
    "moi": "swing_weight_oz_in2",
}
"""The control of each kind of measurement that has one."""
LEAST_SHARE = 0.02
"""Part of a doubt below which its source is not listed."""
LEFT_OUT, PENDULUM = re.compile(r"--leave-out '[^']*'"), " and give --pendulum"
"""Advice about options that only the command line has."""


@dataclass(frozen=True, kw_only=True)
class OtherTool(MassProperties):
    """An implement of another sport, which has no drawing, and how far from its tip it can be tapped."""

    outline: None
    bounds: Mapping[str, Range]


@dataclass(frozen=True, kw_only=True)
class FittedTool(MassProperties):
    """The fitted implement; its swing weight about the axis of its sport, and half the 90 % interval of that."""

    swing_weight: MomentOfInertia
    swing_weight_half: MomentOfInertia


@dataclass(frozen=True)
class OwnValue:
    """A value of the fitted implement and half its 90 % interval, SI."""

    name: str
    label: Mapping[System, str]
    scale: str
    value: float
    half: float
    known_from: str


@dataclass(frozen=True)
class OwnUnknown:
    """What was not known: half its interval before and after the measurements, as parts of it, and its sources."""

    name: str
    label: str
    before: float
    off: float
    after: float
    budget: tuple[tuple[str, float], ...]


@dataclass(frozen=True, kw_only=True)
class OwnMeasurement:
    """A measurement beside what the fitted implement says to it.

    Parameters
    ----------
    field : its control, where it has one.
    scale, digits : how value, half of its interval and ``fitted`` are shown.
    counts : whether it is not left out; ``sigma`` is how far it then lies from all others.
    fitted : what the fit gives; None while the measurements contradict each other.
    should, beside : what it should be, where it alone contradicts the others, and that in words.
    tone, right_tone : the mode of a tone, and the one that the others take it for.
    """

    name: str
    field: MeasuredField | None
    scale: str
    digits: int
    value: float
    half: float
    counts: bool
    sigma: float | None
    fitted: float | None
    should: float | None
    beside: Mapping[System, str] | None
    tone: ToneName | None
    right_tone: ToneName | None


@dataclass(frozen=True, kw_only=True)
class OwnAnswer:
    """What the measurements allow: values with intervals, residuals, contradictions and rules.

    Parameters
    ----------
    bat, words : the implement as described, and the vocabulary of its sport.
    guesses : what the measurements are expected to be, the controls' values until something was measured.
    headline : its weight, balance and swing weight now, and whether the measurements agree.
    values : of the fit; without one, ``unfitted`` says why.
    expected, expected_words : the tones of a free one as described.
    """

    bat: BenchBat | OtherTool
    words: Terms
    grip_end: str
    fitted: FittedTool
    guesses: Mapping[MeasuredField, float | None]
    expected: tuple[ExpectedTone, ...]
    expected_words: Mapping[System, str]
    headline: Mapping[System, str]
    values: tuple[OwnValue, ...]
    unfitted: str
    unknowns: tuple[OwnUnknown, ...]
    measurements: tuple[OwnMeasurement, ...]
    contradictions: Sentences
    budget: Sentences
    rules: tuple[RuleCheck, ...]


@dataclass(frozen=True)
class WrittenBat:
    """The text of a bat's file; None: nothing was measured."""

    toml: str | None = None


def answer(state: OwnState) -> OwnAnswer:
    """Return the bat that the measurements allow: values with intervals, residuals, contradictions and rules.

    While measurements contradict each other, no bat is fitted: the values are those of the bat as described.
    """
    described, _ = unknown_of(state)
    found = answer_of(state)
    agreeing = found if found is not None and found.consistent else None
    with about("weighed_oz" if state.balanced_in is None else "balanced_in"):
        tool = described if agreeing is None else agreeing.implement
    body, described_body = rigid_body(beam_model(tool)), rigid_body(beam_model(described))
    budget = []
    if agreeing is not None:
        budget = [budget_words(agreeing), *moi_words(agreeing), *density_words(agreeing), *assumption_words(agreeing)]
    terms, axis = words_of(described.sport), described.swing_axis
    masses = vars(mass_properties(tool, body))
    fitted = FittedTool(**masses, swing_weight=body.moi(axis), swing_weight_half=REACH * moi_doubt(tool, body, axis))
    tones = expected_tones(state)
    return OwnAnswer(
        bat=_picture(state, described, described_body),
        words=terms,
        grip_end=described.grip_end,
        fitted=fitted,
        guesses=_guesses(described_body, state, described),
        expected=tones,
        expected_words=expected_words(tones),
        headline=in_either_system(own_headline(tool, body, axis, found)),
        values=() if agreeing is None else _values(agreeing),
        unfitted=unfitted_words(terms, found),
        unknowns=() if agreeing is None else _unknowns(agreeing),
        measurements=tuple(_residuals(state, described, found)),
        contradictions=_on_the_page(contradictions(found) if found is not None else []),
        budget=_on_the_page(budget),
        rules=_rules(state, tool, body, agreeing),
    )


def _on_the_page(sentences: list[Sentence]) -> Sentences:
    """Return sentences without what they say of the command line's options."""
    read = in_both_systems(sentences).items()
    return {
        system: [LEFT_OUT.sub("leave it out", words).replace(PENDULUM, "") for words in texts] for system, texts in read
    }


def _picture(state: OwnState, described: Implement, body: RigidBody) -> BenchBat | OtherTool:
    if state.implement is None and isinstance(described, Bat):
        return bench_bat(state, described)
    tapped = {"tap_from_tip_in": (0.0, described.length / INCH)}
    return OtherTool(**vars(mass_properties(described, body)), outline=None, bounds=tapped)


def _guesses(body: RigidBody, state: OwnState, described: Implement) -> dict[MeasuredField, float | None]:
    pivot = pivot_of(state, described)
    period = None
    if pivot <= FARTHEST_PIVOT * body.balance_point:
        period = 1e3 * pendulum_period(body.moi(pivot), mass=body.mass, balance_point=body.balance_point, pivot=pivot)
    values = body.mass / OUNCE, body.balance_point / INCH, period, body.moi(pivot) / OUNCE_INCH_SQUARED, pivot / INCH
    return dict(zip(get_args(MeasuredField), values, strict=True))


def _values(found: CalibrateAnswer) -> tuple[OwnValue, ...]:
    bat = found.posterior.beam.bat
    rows = [(name, called(name, bat), VALUES[name][1], value) for name, value in found.bat.by_name.items()]
    if found.damping_ratio is not None:
        rows.append(("damping", "damping", "share", found.damping_ratio))
    return tuple(
        OwnValue(
            name,
            in_either_system(say("{label}", label=label)),
            scale,
            value=value.value.value,
            half=value.value.half_width,
            known_from=value.kind,
        )
        for name, label, scale, value in rows
    )


def _unknowns(found: CalibrateAnswer) -> tuple[OwnUnknown, ...]:
    bat = found.posterior.beam.bat
    parts = ((unknown.name, *parts_of(unknown)) for unknown in found.unknowns)
    return tuple(
        OwnUnknown(
            name,
            unknown_words(name, bat),
            before=before.half_width,
            off=after.value,
            after=after.half_width,
            budget=tuple(
                (source_words(source, bat), share)
                for source, share in found.budget[name].items()
                if share >= LEAST_SHARE
            ),
        )
        for name, before, after in parts
    )


def _residuals(state: OwnState, described: Implement, found: CalibrateAnswer | None) -> Iterator[OwnMeasurement]:
    """Yield every measurement beside what the fitted bat, if there is one, says to it, and how far it lies off."""
    counted = {} if found is None else {row.name: row for row in found.measurements}
    suspects = {} if found is None else {suspect.name: suspect for suspect in found.suspects}
    beam = beam_of(described) if found is None else found.posterior.beam
    for measurement in measurements_of(state):
        row, suspect, mode = counted.get(measurement.name), suspects.get(measurement.name), measurement.mode
        scale, digits = SCALE_OF[measurement.kind]
        right = suspect.meant[0].measurement.mode if suspect is not None and suspect.meant else None
        yield OwnMeasurement(
            name=measurement.name,
            field=FIELDS.get(measurement.kind),
            scale=scale,
            digits=digits,
            value=measurement.value.value,
            half=measurement.value.half_width,
            counts=row is not None,
            sigma=None if row is None else row.off_by_sigma,
            fitted=float(predicted(beam, [measurement])[0]) if found is None or found.consistent else None,
            should=None if suspect is None else suspect.should,
            beside=in_either_system(should_words(found, suspect)) if found and suspect else None,
            tone=name_of(mode) if mode else None,
            right_tone=name_of(right) if mode and right else None,
        )


def _rules(state: OwnState, fitted: Implement, body: RigidBody, found: CalibrateAnswer | None) -> tuple[RuleCheck, ...]:
    """Return the league's rules held against the calibrated bat; a moment of inertia counts with its interval."""
    chosen = usual_league(fitted) if state.league == "usual" else state.league
    if chosen is None:
        return ()
    with about("league"):
        rules = league(chosen)
    if isinstance(fitted, Bat):
        findings = construction_findings(fitted, body=body)
        if found is not None and found.bat.moi is not None and found.bat.moi.kind == "measured":
            moi = found.bat.moi.value
            findings["moi"] = Finding(moi.value, interval=(moi.low, moi.high), interval_is="the 90 % interval")
    else:
        findings = {name: Finding(size) for name, size in sizes_of(fitted).items()}
    return tuple(rule_check(rules, check) for check in check_rules(rules, bat=fitted, findings=findings))


def file(state: OwnState) -> WrittenBat:
    """Return the calibrated bat's file, with the interval of every value and what was measured or assumed."""
    found = answer_of(state)
    if found is None and measurements_of(state):
        raise FieldError("weighed_oz", "nothing was measured yet; weigh, balance, swing or tap the bat first")
    if found is not None and not found.consistent:
        raise FieldError(
            "", "the measurements contradict each other; measure again, or leave one out, before the bat is kept"
        )
    return WrittenBat() if found is None else WrittenBat(found.to_toml())


def recipe(state: OwnState) -> dict[str, str]:
    """Return the command line that calibrates in the same way, and the file of the bat as described."""
    described = own_of(state)
    weight, balance, period, swing = (
        None if value is None else f"{value:.12g}{unit}±{error:.12g}{unit}"
        for value, error, unit in (
            (state.weighed_oz, state.weighed_error_oz, "oz"),
            (state.balanced_in, state.balanced_error_in, "in"),
            (None if state.pendulum_ms is None else state.pendulum_ms / 1e3, state.pendulum_error_ms / 1e3, "s"),
            (state.swing_weight_oz_in2, state.swing_weight_error_oz_in2, "oz*in^2"),
        )
    )
    parts = {
        "--mass": weight,
        "--balance-point": balance,
        "--pendulum": period,
        "--moi": swing,
        "--pivot": f"{pivot_of(state, described) / INCH:.12g}in",
        "--diameter-error": f"{100 * state.diameter_error:.12g}%" if isinstance(described, Bat) else None,
    }
    words = [f"{name} {value}" for name, value in parts.items() if value is not None]
    words += [f"--tone {name}:{hertz:.12g}Hz±{error:.12g}Hz" for name, hertz, error in state.tones]
    measured = {measurement.name for measurement in measurements_of(state)}
    words += [option("--leave-out", name) for name in state.left_out if name in measured]
    if state.implement is None:
        name, text = bat_name(state), bat_text(state)
    else:
        text = state.implement_toml or ""
        name = BAT_FILE if text else quote(state.implement)
    if measured <= {*state.left_out}:
        lines = {"note": "The command line comes once something was measured: weigh, balance, swing or tap the bat."}
    else:
        lines = {"command": f"sweetspot calibrate {name} {' '.join(words)} --out mine.toml"}
    return lines | ({"toml": text} if text else {})


VIEW = View("own", "Own bat", OwnState, answer, recipe, asides={"tap": tap, "file": file})

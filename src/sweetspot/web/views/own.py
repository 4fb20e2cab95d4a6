"""Own bat: from a scale, a balance point, a pendulum and a tap to the bat that one has in hand, and how sure it is.

Rackets, cricket bats, clubs and sticks go the same way, by weight, balance, swing weight and the first tone.
"""

from __future__ import annotations

from shlex import quote
from typing import Any

from sweetspot.analysis.certification.rules import Finding, check_rules, construction_findings
from sweetspot.answers.calibrate import CalibrateAnswer
from sweetspot.answers.certify import rule_check
from sweetspot.answers.implement import mass_properties
from sweetspot.answers.records import to_dict
from sweetspot.calibration.measurements import MeasuredKind, predicted
from sweetspot.calibration.unknowns import described as beam_of
from sweetspot.catalog.rules import league, usual_league
from sweetspot.designs.variables import sizes_of
from sweetspot.dynamics.beam import beam_model
from sweetspot.dynamics.rigid import RigidBody, moi_doubt, rigid_body
from sweetspot.dynamics.swing_weight import pendulum_period
from sweetspot.equipment.bat import Bat
from sweetspot.equipment.implement import Implement
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
from sweetspot.reports.sentences import Sentence, say
from sweetspot.reports.sport_words import words_of
from sweetspot.units import INCH, OUNCE, OUNCE_INCH_SQUARED
from sweetspot.web.bat_bounds import bounds
from sweetspot.web.documents import in_both_systems
from sweetspot.web.drawings import outline
from sweetspot.web.errors import FieldError, about
from sweetspot.web.recipes import BAT_FILE, bat_name, bat_text, option
from sweetspot.web.view import View
from sweetspot.web.views.own_state import (
    FARTHEST_PIVOT,
    OwnState,
    answer_of,
    measurements_of,
    name_of,
    own_of,
    pivot_of,
    unknown_of,
)
from sweetspot.web.views.own_tap import expected_tones, tap

FIELDS: dict[MeasuredKind, str] = {
    "mass": "weighed_oz",
    "balance_point": "balanced_in",
    "period": "pendulum_ms",
    "moi": "swing_weight_oz_in2",
}
"""The control of each kind of measurement that has one."""
LEAST_SHARE = 0.02
"""Part of a doubt below which its source is not listed."""


def answer(state: OwnState) -> dict[str, Any]:
    """Return the bat that the measurements allow: values with intervals, residuals, contradictions and rules.

    While measurements contradict each other, no bat is fitted: the values are those of the bat as described.
    """
    described, _ = unknown_of(state)
    found = answer_of(state)
    agreeing = found if found is not None and found.consistent else None
    with about("weighed_oz" if state.balanced_in is None else "balanced_in"):
        fitted = described if agreeing is None else agreeing.implement
    body, described_body = rigid_body(beam_model(fitted)), rigid_body(beam_model(described))
    budget = []
    if agreeing is not None:
        budget = [budget_words(agreeing), *moi_words(agreeing), *density_words(agreeing), *assumption_words(agreeing)]
    axis = described.swing_axis
    return {
        "bat": {**to_dict(mass_properties(described, described_body)), **_picture(state, described)},
        "tool": None if state.implement is None else {"name": described.name},
        "words": words_of(described.sport).model_dump(),
        "grip_end": described.grip_end,
        "fitted": {
            **to_dict(mass_properties(fitted, body)),
            "swing_weight_kg_m2": body.moi(axis),
            "swing_weight_half_kg_m2": REACH * moi_doubt(fitted, body, axis),
        },
        "guesses": _guesses(described_body, state, described),
        "expected": expected_tones(state),
        "values": [] if agreeing is None else _values(agreeing),
        "unknowns": [] if agreeing is None else _unknowns(agreeing),
        "measurements": _residuals(state, described, found),
        "contradictions": in_both_systems([] if found is None else contradictions(found)),
        "budget": in_both_systems(budget),
        "rules": _rules(state, fitted, body, agreeing),
    }


def _picture(state: OwnState, described: Implement) -> dict[str, Any]:
    """Return a bat's outline and how far its controls go; of anything else how far from its tip it can be tapped."""
    if state.implement is None and isinstance(described, Bat):
        return {**to_dict(outline(described)), "bounds": bounds(state, described)}
    return {"outline": None, "bounds": {"tap_from_tip_in": (0.0, described.length / INCH)}}


def _guesses(body: RigidBody, state: OwnState, described: Implement) -> dict[str, float | None]:
    """Return the measurements expected of the bat as described, the controls' values until there are measured ones."""
    pivot = pivot_of(state, described)
    period = None
    if pivot <= FARTHEST_PIVOT * body.balance_point:
        period = pendulum_period(body.moi(pivot), mass=body.mass, balance_point=body.balance_point, pivot=pivot)
    return {"weighed_oz": body.mass / OUNCE, "balanced_in": body.balance_point / INCH,
            "pendulum_ms": None if period is None else 1e3 * period,
            "swing_weight_oz_in2": body.moi(pivot) / OUNCE_INCH_SQUARED, "pivot_in": pivot / INCH}  # fmt: skip


def _values(found: CalibrateAnswer) -> list[dict[str, Any]]:
    bat = found.posterior.beam.bat
    rows = [(name, called(name, bat), VALUES[name][1], value) for name, value in found.bat.by_name.items()]
    if found.damping_ratio is not None:
        rows.append(("damping", "damping", "share", found.damping_ratio))
    return [
        {"name": name, "label": _both(label), "scale": scale, "value": value.value.value,
         "half": value.value.half_width, "known_from": value.kind}
        for name, label, scale, value in rows
    ]  # fmt: skip


def _both(words: str | Sentence) -> dict[str, str]:
    """Return words as readers of either system see them."""
    return {system: lines[0] for system, lines in in_both_systems([say("{words}", words=words)]).items()}


def _unknowns(found: CalibrateAnswer) -> list[dict[str, Any]]:
    """Return for everything that was not known how doubtful it was and is, as parts of it, and by what."""
    rows, bat = [], found.posterior.beam.bat
    for unknown in found.unknowns:
        before, after = parts_of(unknown)
        shares = [
            {"name": source_words(name, bat), "share": share}
            for name, share in found.budget[unknown.name].items()
            if share >= LEAST_SHARE
        ]
        rows.append({"name": unknown.name, "label": unknown_words(unknown.name, bat), "before": before.half_width,
                     "off": after.value, "after": after.half_width, "budget": shares})  # fmt: skip
    return rows


def _residuals(state: OwnState, described: Implement, found: CalibrateAnswer | None) -> list[dict[str, Any]]:
    """Return every measurement beside what the fitted bat, if there is one, says to it, and how far it lies off.

    One that alone contradicts the others has what they say to it, and for a tone the mode that they take it for.
    """
    counted = {} if found is None else {row.name: row for row in found.measurements}
    suspects = {} if found is None else {suspect.name: suspect for suspect in found.suspects}
    beam = beam_of(described) if found is None else found.posterior.beam
    rows = []
    for measurement in measurements_of(state):
        row, suspect, mode = counted.get(measurement.name), suspects.get(measurement.name), measurement.mode
        scale, digits = SCALE_OF[measurement.kind]
        right = suspect.meant[0].measurement.mode if suspect is not None and suspect.meant else None
        rows.append({
            "name": measurement.name, "scale": scale, "digits": digits, "value": measurement.value.value,
            "half": measurement.value.half_width, "counts": row is not None, "field": FIELDS.get(measurement.kind),
            "sigma": None if row is None else row.off_by_sigma,
            "contradicts": found is not None and measurement.name in found.contradictions,
            "fitted": float(predicted(beam, [measurement])[0]) if found is None or found.consistent else None,
            "should": None if suspect is None else suspect.should,
            "tone": name_of(mode) if mode else None, "right_tone": name_of(right) if mode and right else None,
        })  # fmt: skip
    return rows


def _rules(state: OwnState, fitted: Implement, body: RigidBody, found: CalibrateAnswer | None) -> list[dict[str, Any]]:
    """Return the league's rules held against the calibrated bat; a moment of inertia counts with its interval."""
    chosen = usual_league(fitted) if state.league == "usual" else state.league
    if chosen is None:
        return []
    with about("league"):
        rules = league(chosen)
    if isinstance(fitted, Bat):
        findings = construction_findings(fitted, body=body)
        if found is not None and found.bat.moi is not None and found.bat.moi.kind == "measured":
            moi = found.bat.moi.value
            findings["moi"] = Finding(moi.value, interval=(moi.low, moi.high), interval_is="the 90 % interval")
    else:
        findings = {name: Finding(size) for name, size in sizes_of(fitted).items()}
    return [to_dict(rule_check(rules, check)) for check in check_rules(rules, bat=fitted, findings=findings)]


def file(state: OwnState) -> dict[str, str]:
    """Return the calibrated bat's file, with the interval of every value and what was measured or assumed."""
    found = answer_of(state)
    if found is None:
        raise FieldError("weighed_oz", "nothing was measured yet; weigh, balance, swing or tap the bat first")
    if not found.consistent:
        raise FieldError(
            "", "the measurements contradict each other; measure again, or leave one out, before the bat is kept"
        )
    return {"toml": found.to_toml()}


def file_if_any(state: OwnState) -> dict[str, str]:
    """Return the calibrated bat's file; nothing where nothing was measured."""
    return file(state) if measurements_of(state) else {}


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


VIEW = View("own", "Own bat", OwnState, answer, recipe, asides={"tap": tap, "file": file_if_any})

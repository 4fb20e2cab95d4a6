"""Own bat: from a scale, a balance point, a pendulum and a tap to the bat that one has in hand, and how sure it is.

Rackets, cricket bats, clubs and sticks go the same way, by weight, balance, swing weight and the first tone.
"""

from __future__ import annotations

from collections.abc import Mapping
from shlex import quote
from typing import Any

import tomli_w

from sweetspot.analysis.certification.rules import Finding, check_rules, construction_findings
from sweetspot.answers.certify import rule_check
from sweetspot.answers.implement import mass_properties
from sweetspot.answers.records import to_dict
from sweetspot.calibration.calibrated_file import calibrated_bat, calibrated_table
from sweetspot.calibration.calibrated_values import material_values, properties
from sweetspot.calibration.contradictions import meant, suspects
from sweetspot.calibration.measured import CalibratedValue, Measured
from sweetspot.calibration.measurements import MeasuredKind, predicted
from sweetspot.calibration.posterior import Posterior
from sweetspot.calibration.unknowns import described as beam_of
from sweetspot.catalog.rules import league, usual_league
from sweetspot.design.variables import sizes_of
from sweetspot.dynamics.beam import beam_model
from sweetspot.dynamics.outline_doubt import moi_doubt
from sweetspot.dynamics.rigid import RigidBody, pendulum_period, rigid_body
from sweetspot.equipment.bat import Bat
from sweetspot.equipment.implement import Implement
from sweetspot.numerics.confidence import REACH
from sweetspot.report.calibration.document import (
    SCALE_OF,
    VALUES,
    as_part,
    budget_words,
    called,
    contradictions,
    density_words,
    moi_words,
    source_words,
    supposed_words,
    unknown_words,
)
from sweetspot.report.sentences import Sentence, say
from sweetspot.report.sport_words import words_of
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
    damping_of,
    measurements_of,
    name_of,
    own_of,
    pivot_of,
    posterior_of,
    unknown_of,
)
from sweetspot.web.views.own_tap import expected_tones, tap

FIELDS: dict[MeasuredKind, str] = {
    "mass": "weighed_oz", "balance_point": "balanced_in", "period": "pendulum_ms", "moi": "swing_weight_oz_in2"
}  # fmt: skip
"""The control of each kind of measurement that has one."""
LEAST_SHARE = 0.02
"""Part of a doubt below which its source is not listed."""


def answer(state: OwnState) -> dict[str, Any]:
    """Return the bat that the measurements allow: values with intervals, residuals, contradictions and rules.

    While measurements contradict each other, nothing is told of a fitted bat: it is the one that was described.
    """
    own, _ = unknown_of(state)
    posterior = posterior_of(state)
    told = None if posterior is None or posterior.contradictions else posterior
    with about("weighed_oz" if state.balanced_in is None else "balanced_in"):
        fitted = own if told is None else _fitted(told, state)
    body, described_body = rigid_body(beam_model(fitted)), rigid_body(beam_model(own))
    alone = {} if posterior is None else suspects(posterior)
    words = [] if posterior is None else contradictions(posterior, alone)
    known = {} if told is None else properties(told)
    budget = [] if told is None else [budget_words(told), *moi_words(told), *density_words(told), *supposed_words(told)]
    axis = own.swing_axis
    return {
        "bat": {**to_dict(mass_properties(own, described_body)), **_picture(state, own)},
        "tool": None if state.implement is None else {"name": own.name},
        "words": words_of(own).model_dump(), "grip_end": own.grip_end,
        "fitted": to_dict(mass_properties(fitted, body))
        | {"swing_weight_kg_m2": body.moi(axis), "swing_weight_half_kg_m2": REACH * moi_doubt(fitted, body, axis)},
        "guesses": _guesses(described_body, state, own),
        "expected": expected_tones(state),
        "values": [] if told is None else _values(known, told, damping_of(state)),
        "unknowns": [] if told is None else _unknowns(told),
        "measurements": _residuals(state, posterior, alone),
        "contradictions": in_both_systems(words),
        "budget": in_both_systems(budget),
        "rules": _rules(state, fitted, body, known),
    }  # fmt: skip


def _fitted(posterior: Posterior, state: OwnState) -> Implement:
    own = posterior.beam.bat
    return calibrated_bat(posterior, damping_of(state)) if isinstance(own, Bat) else own


def _picture(state: OwnState, own: Implement) -> dict[str, Any]:
    """Return a bat's outline and how far its controls go; of anything else how far from its tip it can be tapped."""
    if state.implement is None and isinstance(own, Bat):
        return {**outline(own), "bounds": bounds(state, own)}
    return {"outline": None, "bounds": {"tap_from_tip_in": (0.0, own.length / INCH)}}


def _guesses(body: RigidBody, state: OwnState, own: Implement) -> dict[str, float | None]:
    """Return what the bat as described would measure, where its controls stand until somebody has measured."""
    pivot = pivot_of(state, own)
    period = None
    if pivot <= FARTHEST_PIVOT * body.balance_point:
        period = pendulum_period(body.moi(pivot), mass=body.mass, balance_point=body.balance_point, pivot=pivot)
    return {"weighed_oz": body.mass / OUNCE, "balanced_in": body.balance_point / INCH,
            "pendulum_ms": None if period is None else 1e3 * period,
            "swing_weight_oz_in2": body.moi(pivot) / OUNCE_INCH_SQUARED, "pivot_in": pivot / INCH}  # fmt: skip


def _values(known: dict[str, CalibratedValue], posterior: Posterior, damping: Measured | None) -> list[dict[str, Any]]:
    values = {**known, **material_values(posterior)}
    rows = [
        {"name": name, "label": _both(called(name, posterior)), "scale": VALUES[name][1], "value": one.value.value,
         "half": REACH * one.value.error, "known_from": one.kind}
        for name, one in values.items()
    ]  # fmt: skip
    if damping is not None:
        rows.append({"name": "damping", "label": _both("damping"), "scale": "share", "value": damping.value,
                     "half": REACH * damping.error, "known_from": "measured"})  # fmt: skip
    return rows


def _both(words: str | Sentence) -> dict[str, str]:
    """Return words as readers of either system see them."""
    return {system: lines[0] for system, lines in in_both_systems([say("{words}", words=words)]).items()}


def _unknowns(posterior: Posterior) -> list[dict[str, Any]]:
    """Return for everything that was not known how doubtful it was and is, as parts of it, and by what."""
    rows, own = [], posterior.beam.bat
    for one in posterior.unknowns:
        off = as_part(one.name, posterior.deviation(one.name))
        before = as_part(one.name, Measured(0.0, one.spread))
        shares = [
            {"name": source_words(name, own), "share": share}
            for name, share in posterior.budget(one.name).items()
            if share >= LEAST_SHARE
        ]
        rows.append({"name": one.name, "label": unknown_words(one.name, own), "before": REACH * before.error,
                     "off": off.value, "after": REACH * off.error, "budget": shares})  # fmt: skip
    return rows


def _residuals(state: OwnState, posterior: Posterior | None, alone: Mapping[str, Posterior]) -> list[dict[str, Any]]:
    """Return every measurement beside what the fitted bat, if there is one, says to it, and how far it lies off.

    One that alone contradicts the others has what they say to it, and for a tone the mode that they take it for.
    """
    own, _ = unknown_of(state)
    pulls = {} if posterior is None else dict(zip(posterior.sources, posterior.pulls.tolist(), strict=True))
    beam = beam_of(own) if posterior is None else posterior.beam
    agree = posterior is None or not posterior.contradictions
    rows = []
    for one in measurements_of(state):
        counts, others = one.name in pulls, alone.get(one.name)
        scale, digits = SCALE_OF[one.kind]
        as_meant = meant(one, others) if others is not None and one.mode else []
        mode = as_meant[0].measurement.mode if as_meant else None
        rows.append({
            "name": one.name, "scale": scale, "digits": digits, "value": one.value.value,
            "half": REACH * one.value.error, "counts": counts, "field": FIELDS.get(one.kind),
            "sigma": pulls.get(one.name),
            "contradicts": posterior is not None and one.name in posterior.contradictions,
            "fitted": float(predicted(beam, [one])[0]) if agree else None,
            "should": None if others is None else float(predicted(others.beam, [one])[0]),
            "tone": name_of(one.mode) if one.mode else None, "right_tone": name_of(mode) if mode else None,
        })  # fmt: skip
    return rows


def _rules(
    state: OwnState, fitted: Implement, body: RigidBody, values: dict[str, CalibratedValue]
) -> list[dict[str, Any]]:
    """Return the league's rules held against the calibrated bat; a moment of inertia counts with its interval."""
    chosen = usual_league(fitted) if state.league == "usual" else state.league
    if chosen is None:
        return []
    with about("league"):
        rules = league(chosen)
    if isinstance(fitted, Bat):
        known = construction_findings(fitted, body=body)
        if "moi" in values and "moi" not in fitted.fitted:
            moi = values["moi"].value
            known["moi"] = Finding(moi.value, interval=(moi.low, moi.high), interval_is="the 90 % interval")
    else:
        known = {name: Finding(size) for name, size in sizes_of(fitted).items()}
    return [to_dict(rule_check(rules, check)) for check in check_rules(rules, bat=fitted, findings=known)]


def file(state: OwnState) -> dict[str, str]:
    """Return the calibrated bat's file, with the interval of every value and what was measured or assumed."""
    posterior = posterior_of(state)
    if posterior is None:
        raise FieldError("weighed_oz", "nothing was measured yet; weigh, balance, swing or tap the bat first")
    if posterior.contradictions:
        raise FieldError(
            "", "the measurements contradict each other; measure again, or leave one out, before the bat is kept"
        )
    return {"toml": tomli_w.dumps(calibrated_table(posterior, damping_of(state)))}


def file_if_any(state: OwnState) -> dict[str, str]:
    """Return the calibrated bat's file; nothing where nothing was measured."""
    return file(state) if measurements_of(state) else {}


def recipe(state: OwnState) -> dict[str, str]:
    """Return the command line that calibrates in the same way, and the file of the bat as described."""
    own = own_of(state)
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
        "--mass": weight, "--balance-point": balance, "--pendulum": period, "--moi": swing,
        "--pivot": f"{pivot_of(state, own) / INCH:.12g}in",
        "--diameter-error": f"{100 * state.diameter_error:.12g}%" if isinstance(own, Bat) else None,
    }  # fmt: skip
    words = [f"{name} {value}" for name, value in parts.items() if value is not None]
    words += [f"--tone {name}:{hertz:.12g}Hz±{error:.12g}Hz" for name, hertz, error in state.tones]
    measured = {one.name for one in measurements_of(state)}
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

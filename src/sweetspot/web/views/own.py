"""Own bat: from a scale, a balance point, a pendulum and a tap to the bat that one has in hand, and how sure it is."""

from __future__ import annotations

from typing import Any

import tomli_w

from sweetspot.analysis.certification.rules import Finding, check_rules, construction_findings, title
from sweetspot.calibration.calibrated_file import Value, calibrated_bat, calibrated_table, material_values, properties
from sweetspot.calibration.measured import Measured
from sweetspot.calibration.measurements import predicted
from sweetspot.calibration.posterior import Posterior
from sweetspot.calibration.unknowns import described as beam_of
from sweetspot.catalog.rules import league
from sweetspot.dynamics.beam import beam_model
from sweetspot.dynamics.outline_doubt import moi_doubt
from sweetspot.dynamics.rigid import RigidBody, pendulum_period, rigid_body
from sweetspot.equipment.bat import Bat
from sweetspot.numerics.confidence import REACH
from sweetspot.numerics.constants import STANDARD_AXIS
from sweetspot.report.bat.json import bat_json
from sweetspot.report.calibration.document import (
    SCALE_OF,
    VALUES,
    WORDS,
    budget_words,
    contradictions,
    moi_words,
    supposed_words,
)
from sweetspot.report.certification.numbers import check_json
from sweetspot.units import INCH, OUNCE
from sweetspot.web.bat_bounds import bounds
from sweetspot.web.bats import described
from sweetspot.web.documents import in_both_systems
from sweetspot.web.drawings import outline
from sweetspot.web.errors import FieldError, about
from sweetspot.web.recipes import bat_name, bat_text, option
from sweetspot.web.view import View
from sweetspot.web.views.own_state import FARTHEST_PIVOT, OwnState, bat_of, damping_of, measurements_of, posterior_of
from sweetspot.web.views.own_tap import expected_tones, tap

LEAST_SHARE = 0.02
"""Part of a doubt below which its source is not listed."""


def answer(state: OwnState) -> dict[str, Any]:
    """Return the bat that the measurements allow: values with intervals, residuals, contradictions and rules.

    While measurements contradict each other, nothing is told of a fitted bat: it is the one that was described.
    """
    own = described(state)
    bat_of(state)
    posterior = posterior_of(state)
    told = None if posterior is None or posterior.contradictions else posterior
    with about("weighed_oz" if state.balanced_in is None else "balanced_in"):
        fitted = own if told is None else calibrated_bat(told, damping_of(state))
    body, described_body = rigid_body(beam_model(fitted)), rigid_body(beam_model(own))
    words = [] if posterior is None else contradictions(posterior)
    known = {} if told is None else properties(told)
    budget = [] if told is None else [budget_words(told), *moi_words(told), *supposed_words(told)]
    return {
        "bat": {
            **bat_json(own.name, own.length, described_body), **outline(own),
            "bounds": bounds(state, own),
        },
        "fitted": bat_json(fitted.name, fitted.length, body)
        | {"moi_6in_half_kg_m2": REACH * moi_doubt(fitted, body, STANDARD_AXIS)},
        "guesses": _guesses(described_body, state),
        "expected": expected_tones(state),
        "values": [] if told is None else _values(known, told, damping_of(state)),
        "unknowns": [] if told is None else _unknowns(told),
        "measurements": _residuals(state, posterior),
        "contradictions": in_both_systems(words),
        "budget": in_both_systems(budget),
        "rules": _rules(state, (own, described_body), (fitted, body), known),
    }  # fmt: skip


def _guesses(body: RigidBody, state: OwnState) -> dict[str, float | None]:
    """Return what the bat as described would measure, where its controls stand until somebody has measured."""
    pivot = state.pivot_in * INCH
    period = None
    if pivot <= FARTHEST_PIVOT * body.balance_point:
        period = pendulum_period(body.moi(pivot), mass=body.mass, balance_point=body.balance_point, pivot=pivot)
    return {"weighed_oz": body.mass / OUNCE, "balanced_in": body.balance_point / INCH,
            "pendulum_ms": None if period is None else 1e3 * period}  # fmt: skip


def _values(known: dict[str, Value], posterior: Posterior, damping: Measured | None) -> list[dict[str, Any]]:
    values = {**known, **material_values(posterior)}
    rows = [
        {"name": name, "label": VALUES[name][0], "scale": VALUES[name][1], "value": one.value.value,
         "half": REACH * one.value.error, "known_from": one.kind}
        for name, one in values.items()
    ]  # fmt: skip
    if damping is not None:
        rows.append({"name": "damping", "label": "damping", "scale": "share", "value": damping.value,
                     "half": REACH * damping.error, "known_from": "measured"})  # fmt: skip
    return rows


def _unknowns(posterior: Posterior) -> list[dict[str, Any]]:
    """Return for everything that was not known how doubtful it was and is, as parts of it, and by what."""
    rows = []
    for one in posterior.unknowns:
        off = posterior.deviation(one.name)
        shares = [
            {"name": _source(name), "share": share}
            for name, share in posterior.budget(one.name).items()
            if share >= LEAST_SHARE
        ]
        rows.append({"name": one.name, "label": WORDS[one.name], "before": REACH * one.spread, "off": off.value,
                     "after": REACH * off.error, "budget": shares})  # fmt: skip
    return rows


def _source(name: str) -> str:
    """Return what people call a source of doubt: a measurement, or what was expected of something."""
    own = name.removeprefix("expected ")
    return name if own == name else f"{WORDS.get(own, own)} as expected"


def _residuals(state: OwnState, posterior: Posterior | None) -> list[dict[str, Any]]:
    """Return every measurement beside what the fitted bat, if there is one, says to it, and how far it lies off."""
    bat, _ = bat_of(state)
    pulls = {} if posterior is None else dict(zip(posterior.sources, posterior.pulls.tolist(), strict=True))
    line = beam_of(bat) if posterior is None else posterior.line
    agree = posterior is None or not posterior.contradictions
    rows = []
    for one in measurements_of(state):
        counts = one.name in pulls
        scale, digits = SCALE_OF[one.kind]
        rows.append({
            "name": one.name, "scale": scale, "digits": digits, "value": one.value.value,
            "half": REACH * one.value.error, "counts": counts,
            "fitted": float(predicted(line, [one])[0]) if agree else None, "sigma": pulls.get(one.name),
        })  # fmt: skip
    return rows


def _rules(
    state: OwnState, described: tuple[Bat, RigidBody], calibrated: tuple[Bat, RigidBody], values: dict[str, Value]
) -> list[dict[str, Any]]:
    """Return the league's rules held against the bat; a moment of inertia counts with its interval."""
    (own, own_body), (fitted, body) = described, calibrated
    usual = "mlb" if own.material.family == "wood" and own.shell is None else "ncaa"
    with about("league"):
        rules = league(usual if state.league == "usual" else state.league)
    known = construction_findings(fitted, body=body)
    known["solid_wood"] = construction_findings(own, body=own_body)["solid_wood"]  # without the tape
    if "moi" in values and "moi" not in fitted.fitted:
        moi = values["moi"].value
        known["moi"] = Finding(moi.value, interval=(moi.low, moi.high), interval_is="the 90 % interval")
    return [
        {**check_json(rules.key, check), "title": title(check.rule), "league_name": rules.name}
        for check in check_rules(rules, bat=fitted, findings=known)
    ]


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
    parts = {
        "--mass": None if state.weighed_oz is None else f"{state.weighed_oz:.12g}oz±{state.weighed_error_oz:.12g}oz",
        "--balance-point": None if state.balanced_in is None
        else f"{state.balanced_in:.12g}in±{state.balanced_error_in:.12g}in",
        "--pendulum": None if state.pendulum_ms is None
        else f"{state.pendulum_ms / 1e3:.12g}s±{state.pendulum_error_ms / 1e3:.12g}s",
        "--pivot": f"{state.pivot_in:.12g}in",
        "--diameter-error": f"{100 * state.diameter_error:.12g}%",
    }  # fmt: skip
    words = [f"{name} {value}" for name, value in parts.items() if value is not None]
    words += [f"--tone {name}:{hertz:.12g}Hz±{error:.12g}Hz" for name, hertz, error in state.tones]
    words += [option("--leave-out", name) for name in state.left_out]
    command = f"sweetspot calibrate {bat_name(state)} {' '.join(words)} --out mine.toml"
    return {"command": command, "toml": bat_text(state)}


VIEW = View("own", "Own bat", OwnState, answer, recipe, asides={"tap": tap, "file": file_if_any})

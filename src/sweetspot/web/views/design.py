"""Design: a bat pulled into shape for a batter, with what it weighs, whether it is allowed, and what it gains."""

from __future__ import annotations

import math
import tempfile
from collections.abc import Callable
from functools import partial
from pathlib import Path
from shlex import quote
from typing import Any, TypeVar

from sweetspot.analysis.certification.rules import Check, League, check_rules
from sweetspot.answers.certify import rule_check
from sweetspot.answers.design_question import Designed
from sweetspot.answers.implement import mass_properties
from sweetspot.answers.records import to_dict
from sweetspot.catalog.files.write import bat_toml, legible
from sweetspot.designs.batter import FROM_TIP
from sweetspot.designs.batter_files import contacts_of_file, fitted_player
from sweetspot.designs.constraints import Limit, findings_of
from sweetspot.designs.gain import CLEARLY, LIKELY, GainVerdict, gain_of
from sweetspot.designs.measures import MEASURES, MeasuredDesigns
from sweetspot.designs.pareto import Front
from sweetspot.designs.turned import HANDLES, TurnedSpace
from sweetspot.dynamics.beam import beam_model
from sweetspot.dynamics.rigid import rigid_body
from sweetspot.equipment.bat import Bat
from sweetspot.errors import SweetspotError
from sweetspot.numerics.arrays import Array
from sweetspot.numerics.interval import REACH
from sweetspot.reports.design.document import compared
from sweetspot.reports.design.sizes import drawing, tolerance_words
from sweetspot.reports.design.words import (
    effort_words,
    moved_words,
    unbounded_words,
    wall_words,
    warning_words,
    worth_words,
)
from sweetspot.reports.quantities import SCALES, SYSTEMS
from sweetspot.units import INCH
from sweetspot.web.bats import ball_of, described, reduced
from sweetspot.web.controls import BatState
from sweetspot.web.documents import in_both_systems
from sweetspot.web.drawings import ball_picture, bat_picture, moi_half, outline
from sweetspot.web.errors import FieldError, about
from sweetspot.web.jobs import LongWork
from sweetspot.web.recipes import ENOUGH, as_text, bat_name, swing_options
from sweetspot.web.view import View
from sweetspot.web.views.design_search import search
from sweetspot.web.views.design_state import (
    USUAL_LEAGUE,
    DesignState,
    ShapedBat,
    asked,
    batter_controls,
    league_of,
    limits_of,
    locks_of,
    numbers_of,
    question_of,
)
from sweetspot.web.views.player import PlayerState, batters_of, learned

Read = TypeVar("Read")
PLACES_DOUBT = 0.5 * INCH
"""m, standard deviation of where the mean contact lies, beyond what balls leave open: as on the command line."""
CLOSE = 1e-3
"""Grains by which a limit may be missed and still be called kept: rounding on the way to the page and back."""


def answer(state: DesignState) -> dict[str, Any]:
    """Return the bat that is being shaped beside the present one: sizes, weights, rules, and curves along both."""
    request = asked(state)
    space = request.bench.space
    numbers, shaped = numbers_of(state, request)
    bat, measured = _made(request, numbers, shaped=shaped)
    body = rigid_body(beam_model(bat))
    return {
        "bat": bat_picture(state, reduced(state, ball_of(state))),
        "ball": ball_picture(state, ball_of(state)),
        "key": request.key,
        "own": shaped,
        "left_out": request.left_out,
        "present": outline(_present(request)),
        "variables": [
            {
                "name": variable.name,
                "label": variable.label,
                "ending": SCALES[variable.scale].ending,
                "scale": variable.scale,
                "from_tip_m": variable.from_tip,
                "low": variable.low,
                "high": variable.high,
                "present": variable.start,
                "value": value,
            }
            for variable, value in zip(space.variables, numbers.tolist(), strict=True)
        ],
        "design": {
            **to_dict(mass_properties(bat, body)),
            **to_dict(outline(bat)),
            "moi_6in_half_kg_m2": moi_half(bat, body),
            "stations": _handles(request, numbers),
        },
        "measures": [_beside(name, measured, request.now) for name in compared(space, measured)],
        "locks": [_light(limit, measured) for limit in locks_of(state)],
        "limits": [_light(limit, measured) for limit in limits_of(state) if limit.why != "kept as it is"],
        "rules": _rules(state, request, bat, measured),
        "curves": _curves(request, measured),
    }


def _made(request: ShapedBat, numbers: Array, *, shaped: bool) -> tuple[Bat, MeasuredDesigns]:
    """Return the bat of some numbers and what it is; while nothing was changed, the present bat to the last digit."""
    space, now = request.bench.space, request.now
    if not shaped:
        return _present(request), MeasuredDesigns({**request.sizes, **now.values}, now.curve, now.worth)
    measured = request.bench.measured(numbers)
    bat = space.made(numbers, f"{space.present.name}, designed")
    assert isinstance(bat, Bat)
    return bat, measured


def _present(request: ShapedBat) -> Bat:
    present = request.bench.space.present
    assert isinstance(present, Bat)
    return present


def _handles(request: ShapedBat, numbers: Array) -> list[dict[str, float]]:
    """Return the handles that can be pulled on the picture, those of an outline; hollow bats have none."""
    space = request.bench.space
    if not isinstance(space, TurnedSpace):
        return []
    return [
        {"position_m": part * space.present.length, "diameter_m": width}
        for part, width in zip(HANDLES.tolist(), numbers[: len(HANDLES)].tolist(), strict=True)
    ]


def _beside(name: str, measured: MeasuredDesigns, now: MeasuredDesigns) -> dict[str, Any]:
    measure = MEASURES[name]
    value, before = float(measured.values[name][0]), now.values.get(name)
    present = None if before is None else float(before[0])
    return {
        "name": name,
        "label": measure.label,
        "scale": measure.scale,
        "value": value,
        "present": present,
        "change": None if present is None else value - present,
    }


def _light(limit: Limit, measured: MeasuredDesigns) -> dict[str, Any]:
    """Return whether a limit is kept, by how much it is missed, and its ends."""
    measure, value = MEASURES[limit.measure], measured.values[limit.measure]
    miss = float(limit.excess(value)[0])
    return {
        "measure": limit.measure,
        "label": measure.label,
        "scale": measure.scale,
        "least": limit.least,
        "most": limit.most,
        "why": limit.why,
        "value": float(value[0]),
        "kept": miss <= CLOSE,
        "miss": max(0.0, miss) * measure.grain,
    }


def _checks(state: DesignState, request: ShapedBat, bat: Bat, measured: MeasuredDesigns) -> list[tuple[League, Check]]:
    league = league_of(state, request)
    if league is None:
        return []
    findings = findings_of(bat, measured, like=_present(request), ball=request.bench.conditions.ball)
    return [(league, check) for check in check_rules(league, bat=bat, findings=findings)]


def _rules(state: DesignState, request: ShapedBat, bat: Bat, measured: MeasuredDesigns) -> list[dict[str, Any]]:
    return [to_dict(rule_check(league, check)) for league, check in _checks(state, request, bat, measured)]


def _curves(request: ShapedBat, measured: MeasuredDesigns) -> dict[str, Any]:
    """Return curves along the bat, knob end first, at places counted from the tip."""
    design, now = measured.curve[0, ::-1], request.now.curve[0, ::-1]
    return {
        "position_m": _present(request).length - FROM_TIP[::-1],
        "exit_speed_m_s": design,
        "present_exit_speed_m_s": now,
        "difference_m_s": design - now,
        "contacts": request.bench.batter.weight[::-1],
    }


def gain(state: DesignState) -> dict[str, Any]:
    """Return the gain of the bat in this batter's hands beside wood that differs, in words and as a band."""
    request = asked(state)
    design = _designed(state, request)
    words = [*unbounded_words(design), moved_words(design), worth_words(design), warning_words(design)]
    words += [*wall_words(design), effort_words(design)]
    tolerance = tolerance_words(design)
    every = [*words, *([] if tolerance is None else [tolerance])]
    band = REACH * design.gain.noise[::-1]
    return {
        "sentences": in_both_systems(every),
        "noise_low_m_s": -band,
        "noise_high_m_s": band,
        "expected_m_s": design.gain.expected,
        "half_interval_m_s": design.gain.doubt,
        "likely_from_m_s": LIKELY * design.gain.spread,
        "seen_from_m_s": CLEARLY * design.gain.spread,
        "words": {verdict.name.lower(): verdict.value for verdict in GainVerdict},
    }


def _designed(state: DesignState, request: ShapedBat) -> Designed:
    """Return one bat as the only one of its front, with everything around it."""
    bench = request.bench
    numbers, shaped = numbers_of(state, request)
    bat, measured = _made(request, numbers, shaped=shaped)
    front = Front(numbers[None], measured, 0, numbers[None])
    gain = gain_of(bench, numbers, measured, request.now)
    checks = tuple(check for _, check in _checks(state, request, bat, measured))
    return Designed(bench, question_of(state), front, 0, request.now, gain, bat, checks=checks, bent=None)


def files(state: DesignState) -> dict[str, Any]:
    """Return the bat's file and its drawings for the maker, in either system of units."""
    request = asked(state)
    numbers, shaped = numbers_of(state, request)
    bat, _ = _made(request, numbers, shaped=shaped)
    endings = ("svg", "dxf", "csv") if bat.shell is None else ()
    return {
        "toml": legible(bat_toml(bat), digits=ENOUGH),
        **{
            system: {ending: drawing(bat, ending, reader).decode() for ending in endings}
            for system, reader in SYSTEMS.items()
        },
    }


def batter(state: DesignState) -> dict[str, Any]:
    """Return the batter that swings, contacts or an answer of fit-player tell of: as fields of a state."""
    if state.swings_csv is None:
        return {}
    if state.swings_csv.lstrip().startswith("{"):
        values = _of_file(state.swings_csv, "fit-player.json", fitted_player)
    elif "from_tip" in state.swings_csv.partition("\n")[0].lower():
        contacts = _of_file(state.swings_csv, "contacts.csv", partial(contacts_of_file, batter=state.swings_of))
        values = {"position": contacts.mean, "position_spread": contacts.spread, "position_doubt": contacts.mean_doubt}
    else:
        names = batters_of(state.swings_csv)
        if len(names) > 1 and state.swings_of is None:
            raise FieldError(
                "swings_csv",
                f"the table has swings of {len(names)} batters; give it to the view Player, "
                "choose one there, and come back",
            )
        present = {name: getattr(state, name) for name in (*BatState.model_fields, "swings_of")}
        posterior = learned(PlayerState(**present, swings_csv=state.swings_csv))
        values = {
            name: posterior.learned[name].interval.value
            for name in ("position", "position_spread", "offset", "offset_spread", "bat_speed")
        }
        place = posterior.learned["position"].interval
        values["position_doubt"] = (place.high - place.low) / (2 * REACH)
    values["position_doubt"] = math.hypot(values["position_doubt"], PLACES_DOUBT)
    return batter_controls(values)


def _of_file(text: str, name: str, read: Callable[[Path], Read]) -> Read:
    """Return a reader's result of a text as a file; its faults are the field's."""
    with tempfile.TemporaryDirectory() as folder, about("swings_csv"):
        path = Path(folder) / name
        path.write_text(text, encoding="utf-8")
        try:
            return read(path)
        except SweetspotError as error:
            raise FieldError("swings_csv", str(error).replace(str(path), "the file")) from None


def recipe(state: DesignState) -> dict[str, str]:
    """Return the command line that searches in the same way, and the present bat's file.

    That has every digit: which bats a search finds follows from the last one.
    """
    locks = {
        "keep_mass": "mass",
        "keep_moi": "moi",
        "keep_wood": "wood",
        "keep_balance": "balance",
        "keep_grip": "grip",
    }
    keep = [word for field, word in locks.items() if getattr(state, field)] or ["nothing"]
    wants = dict.fromkeys((state.want, state.also_want))
    options = [
        *(f"--want {want.replace('_', '-')}" for want in wants),
        *(f"--keep {name}" for name in keep),
        f"--contact {state.contact_in:.12g}in",
        f"--contact-spread {state.contact_spread_in:.12g}in",
        f"--doubt {state.contact_doubt_in:.12g}in",
        f"--offset {state.miss_in:.12g}in",
        f"--offset-spread {state.miss_spread_in:.12g}in",
        f"--cup {state.deepest_cup_in:.12g}in",
        f"--seed {state.seed}",
        f"--generations {state.generations}",
        *([] if state.swing_law == "baseball" else ["--swing-law none"]),
        *([] if state.league == USUAL_LEAGUE else [f"--league {quote(state.league)}"]),
    ]
    swing = as_text(swing_options(state, beside=True))
    command = f"sweetspot design {bat_name(state)} {' '.join(options)}{swing} --out design"
    return {"command": command, "toml": bat_toml(described(state))}


VIEW = View(
    "design",
    "Design",
    DesignState,
    answer,
    recipe,
    asides={"gain": gain, "files": files, "batter": batter},
    jobs={"search": LongWork(search)},
)

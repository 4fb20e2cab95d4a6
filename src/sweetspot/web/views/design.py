"""Design: a bat pulled into shape for a batter, with what it weighs, whether it is allowed, and what it gains."""

from __future__ import annotations

import math
import tempfile
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path
from typing import Annotated, NamedTuple, TypeVar

from sweetspot.analysis.certification.rules import Check, League, check_rules
from sweetspot.answers.certify import RuleCheck, rule_check
from sweetspot.answers.conditions import MassProperties, mass_properties
from sweetspot.answers.design_question import Designed
from sweetspot.answers.records import MomentOfInertia, Speed
from sweetspot.catalog.files.write import bat_toml, legible
from sweetspot.designs.batter import FROM_TIP
from sweetspot.designs.batter_files import contacts_of_file, fitted_player
from sweetspot.designs.constraints import AS_IT_IS, Limit, findings_of
from sweetspot.designs.gain import CLEARLY, LIKELY, gain_of
from sweetspot.designs.measures import MEASURES, MeasuredDesigns
from sweetspot.designs.pareto import Front, Generation
from sweetspot.designs.turned import HANDLES, TurnedSpace
from sweetspot.designs.variables import Variable
from sweetspot.dynamics.beam import beam_model
from sweetspot.dynamics.rigid import rigid_body
from sweetspot.equipment.bat import Bat
from sweetspot.errors import SweetspotError
from sweetspot.numerics.arrays import Array
from sweetspot.numerics.interval import REACH
from sweetspot.reports.design.document import compared, drawing, tolerance_words
from sweetspot.reports.design.words import gain_words, gained_words, limit_words, weight_words
from sweetspot.reports.quantities import SCALES, SYSTEMS
from sweetspot.reports.sentences import Slot, say
from sweetspot.units import INCH
from sweetspot.units.dimensions import LENGTH, SPEED, System
from sweetspot.web.bats import ball_of, described, reduced
from sweetspot.web.controls import BatState
from sweetspot.web.documents import Sentences, in_both_systems, in_either_system
from sweetspot.web.drawings import (
    BallPicture,
    BatPicture,
    BatShape,
    Station,
    ball_picture,
    bat_picture,
    moi_half,
    outline,
)
from sweetspot.web.errors import FieldError, about
from sweetspot.web.jobs import LongWork
from sweetspot.web.recipes import ENOUGH, Ask, bat_source, options_of, swing_options
from sweetspot.web.view import View
from sweetspot.web.views.design_state import (
    LOCKS,
    USUAL_LEAGUE,
    BatterControls,
    DesignState,
    ShapedBat,
    asked,
    batter_controls,
    league_of,
    limits_of,
    locks_of,
    numbers_of,
    question_of,
    search,
)
from sweetspot.web.views.player import PlayerState, batters_of, learned

Read = TypeVar("Read")
PLACES_DOUBT = 0.5 * INCH
"""m, standard deviation of where the mean contact lies, beyond what balls leave open: as on the command line."""
CLOSE = 1e-3
"""Grains by which a limit may be missed and still be called kept: rounding on the way to the page and back."""


@dataclass(frozen=True)
class ShapedNumber:
    """One number of the bat that is being shaped, SI by ``scale``; ``key`` names its control."""

    key: str
    label: Mapping[System, str]
    scale: str
    low: float
    high: float
    value: float


@dataclass(frozen=True, kw_only=True)
class ShapedPicture(BatShape, MassProperties):
    """The bat that is being shaped; its stations are the handles that can be pulled."""

    moi_6in_half: MomentOfInertia


@dataclass(frozen=True)
class MeasureBeside:
    """A measure of the bat that is being shaped, beside the present one's; None: that has none."""

    name: str
    label: str
    scale: str
    value: float
    present: float | None
    change: float | None


@dataclass(frozen=True)
class DesignLight:
    """Whether a limit is kept, with the value and the ends in words."""

    label: str
    holds: bool
    words: Mapping[System, str]


@dataclass(frozen=True)
class DesignCurves:
    """Curves along the bat, knob end first, shape (n,): exit speeds, and how often the ball is met there."""

    position: Annotated[Array, LENGTH]
    exit_speed: Annotated[Array, SPEED]
    present_exit_speed: Annotated[Array, SPEED]
    difference: Annotated[Array, SPEED]
    contacts: Array


@dataclass(frozen=True, kw_only=True)
class DesignPicture:
    """The bat that is being shaped beside the present one: sizes, weights, rules, and curves along both.

    Parameters
    ----------
    key : of the present bat.
    shaped : whether it is another bat than the present one.
    left_out : what of the present bat no design has.
    gained : what it gains, without how sure that is.
    weighs : its weight, balance and swing weight.
    """

    bat: BatPicture
    ball: BallPicture
    key: str
    shaped: bool
    left_out: tuple[str, ...]
    present: BatShape
    variables: tuple[ShapedNumber, ...]
    design: ShapedPicture
    measures: tuple[MeasureBeside, ...]
    locks: tuple[DesignLight, ...]
    limits: tuple[DesignLight, ...]
    rules: tuple[RuleCheck, ...]
    curves: DesignCurves
    gained: Sentences
    weighs: Sentences


@dataclass(frozen=True)
class DesignWorth:
    """What the bat gains in this batter's hands beside wood that differs, in words and as a band.

    Parameters
    ----------
    noise_low, noise_high : 90 % band of what two pieces of wood differ by, along the bat.
    likely_from, seen_from : gains from which one is likely, and clear.
    """

    gained: Sentences
    sentences: Sentences
    noise_low: Annotated[Array, SPEED]
    noise_high: Annotated[Array, SPEED]
    expected: Speed
    half_interval: Speed
    likely_from: Speed
    seen_from: Speed


@dataclass(frozen=True)
class DesignFiles:
    """The bat's file, and its drawings by their endings for readers of either system."""

    toml: str
    us: Mapping[str, str]
    si: Mapping[str, str]


def answer(state: DesignState) -> DesignPicture:
    """Return the bat that is being shaped beside the present one: sizes, weights, rules, and curves along both."""
    shaped = _shaped(state)
    request, bat, measured = shaped.request, shaped.bat, shaped.measured
    space, now = request.bench.space, request.now
    body = rigid_body(beam_model(bat))
    weights, doubt = mass_properties(bat, body), moi_half(bat, body)
    shape = replace(outline(bat), stations=_handles(shaped))
    rules = tuple(rule_check(league, check) for league, check in _checks(state, shaped))
    leagues = {rule.league_name for rule in rules}  # what their lights show already
    limits = [limit for limit in limits_of(state) if limit.why != AS_IT_IS]
    gain = measured.values["exit_speed"][0] - now.values["exit_speed"][0] if shaped.changed else None
    return DesignPicture(
        bat=bat_picture(state, reduced(state, ball_of(state))),
        ball=ball_picture(state, ball_of(state)),
        key=request.key,
        shaped=shaped.changed,
        left_out=request.left_out,
        present=outline(shaped.present),
        variables=tuple(map(_number, space.variables, shaped.numbers.tolist())),
        design=ShapedPicture(**vars(shape), **vars(weights), moi_6in_half=doubt),
        measures=tuple(_beside(name, measured, now) for name in compared(space, measured)),
        locks=tuple(_light(limit, measured) for limit in locks_of(state)),
        limits=tuple(
            light for limit in limits if not (light := _light(limit, measured)).holds or limit.why not in leagues
        ),
        rules=rules,
        curves=_curves(shaped),
        gained=in_both_systems([gained_words(gain)]),
        weighs=in_both_systems([weight_words(weights, doubt / REACH)]),
    )


def _number(variable: Variable, value: float) -> ShapedNumber:
    label = variable.label[0].upper() + variable.label[1:]
    words = say(label)
    if variable.from_tip is not None:
        words = say("{label} {place} from the tip", label=label, place=Slot(variable.from_tip, "place"))
    key = f"{variable.name}{SCALES[variable.scale].ending or '_ratio'}"
    return ShapedNumber(key, in_either_system(words), variable.scale, variable.low, variable.high, value)


class _Shaped(NamedTuple):
    """The bat that is being shaped, beside the present one; ``changed``: its numbers are others."""

    request: ShapedBat
    present: Bat
    numbers: Array
    changed: bool
    bat: Bat
    measured: MeasuredDesigns


def _shaped(state: DesignState) -> _Shaped:
    """Return the bat that is being shaped; while nothing was changed, the present bat to the last digit."""
    request = asked(state)
    space, now = request.bench.space, request.now
    present = bat = space.present
    numbers, changed = numbers_of(state, request)
    measured = MeasuredDesigns({**request.sizes, **now.values}, now.curve, now.worth)
    if changed:
        measured, bat = request.bench.measured(numbers), space.made(numbers, f"{present.name}, designed")
    assert isinstance(present, Bat) and isinstance(bat, Bat)
    return _Shaped(request, present, numbers, changed, bat, measured)


def _handles(shaped: _Shaped) -> tuple[Station, ...]:
    """Return the handles that can be pulled on the picture, those of an outline; hollow bats have none."""
    if not isinstance(shaped.request.bench.space, TurnedSpace):
        return ()
    places = HANDLES * shaped.present.length
    return tuple(map(Station, places.tolist(), shaped.numbers[: len(HANDLES)].tolist()))


def _beside(name: str, measured: MeasuredDesigns, now: MeasuredDesigns) -> MeasureBeside:
    measure, value = MEASURES[name], float(measured.values[name][0])
    before = now.values.get(name)
    present = None if before is None else float(before[0])
    change = None if present is None else value - present
    return MeasureBeside(name, measure.label, measure.scale, value, present, change)


def _light(limit: Limit, measured: MeasuredDesigns) -> DesignLight:
    measure, value = MEASURES[limit.measure], measured.values[limit.measure]
    miss = float(limit.excess(value)[0])
    words = limit_words(limit, float(value[0]), beyond=miss * measure.grain if miss > CLOSE else None)
    return DesignLight(measure.label, miss <= CLOSE, in_either_system(words))


def _checks(state: DesignState, shaped: _Shaped) -> list[tuple[League, Check]]:
    league = league_of(state, shaped.request)
    if league is None:
        return []
    ball = shaped.request.bench.conditions.ball
    findings = findings_of(shaped.bat, shaped.measured, like=shaped.present, ball=ball)
    return [(league, check) for check in check_rules(league, bat=shaped.bat, findings=findings)]


def _curves(shaped: _Shaped) -> DesignCurves:
    """Return curves along the bat, knob end first, at places counted from the tip."""
    design, now = (measured.curve[0, ::-1] for measured in (shaped.measured, shaped.request.now))
    place, contacts = shaped.present.length - FROM_TIP[::-1], shaped.request.bench.batter.weight[::-1]
    return DesignCurves(place, design, now, design - now, contacts)


def gain(state: DesignState) -> DesignWorth:
    """Return the gain of the bat in this batter's hands beside wood that differs, in words and as a band."""
    shaped = _shaped(state)
    design = _designed(state, shaped)
    tolerance = tolerance_words(design)
    words = gain_words(design) + ([] if tolerance is None else [tolerance])
    gained, band = design.gain, REACH * design.gain.noise[::-1]
    return DesignWorth(
        gained=in_both_systems([gained_words(gained.expected if shaped.changed else None, gained)]),
        sentences=in_both_systems(words if shaped.changed else []),
        noise_low=-band,
        noise_high=band,
        expected=gained.expected,
        half_interval=gained.doubt,
        likely_from=LIKELY * gained.spread,
        seen_from=CLEARLY * gained.spread,
    )


def _designed(state: DesignState, shaped: _Shaped) -> Designed:
    """Return one bat as the only one of its front, with everything around it."""
    bench, now, numbers, measured = shaped.request.bench, shaped.request.now, shaped.numbers, shaped.measured
    front = Front(numbers[None], measured, Generation(0, numbers[None], measured))
    gain = gain_of(bench, numbers, measured, now)
    checks = tuple(check for _, check in _checks(state, shaped))
    return Designed(bench, question_of(state), front, 0, now, gain, shaped.bat, checks=checks, bent=None)


def files(state: DesignState) -> DesignFiles:
    """Return the bat's file and its drawings for the maker, in either system of units."""
    bat = _shaped(state).bat
    endings = ("svg", "dxf", "csv") if bat.shell is None else ()
    drawings = {
        system: {ending: drawing(bat, ending, reader).decode() for ending in endings}
        for system, reader in SYSTEMS.items()
    }
    return DesignFiles(legible(bat_toml(bat), digits=ENOUGH), drawings["us"], drawings["si"])


def batter(state: DesignState) -> BatterControls:
    """Return the batter in a table of swings or contacts or an answer of fit-player, as fields of a state."""
    if state.swings_csv is None:
        return BatterControls()
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
    keep = [field.removeprefix("keep_") for field in LOCKS if getattr(state, field)]
    options = {
        "want": [want.replace("_", "-") for want in dict.fromkeys((state.want, state.also_want))],
        "keep": keep or ["nothing"],
        **options_of(state, "contact_in", "contact_spread_in", doubt="contact_doubt_in", offset="miss_in"),
        **options_of(state, "seed", "generations", offset_spread="miss_spread_in", cup="deepest_cup_in"),
        "swing_law": None if state.swing_law == "baseball" else "none",
        "league": None if state.league == USUAL_LEAGUE else state.league,
    }
    ask = Ask("design", (bat_source(state),), options | swing_options(state, beside=True) | {"out": "design"})
    return {"command": ask.command, "toml": bat_toml(described(state))}


ASIDES = {"gain": gain, "files": files, "batter": batter}
VIEW = View("design", "Design", DesignState, answer, recipe, asides=ASIDES, jobs={"search": LongWork(search)})

"""From a state's controls to the bat, its beam and its modes, each worked out once and kept."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, fields, replace
from functools import lru_cache
from typing import TypeVar

from sweetspot import catalog
from sweetspot.analysis.bat_analysis import Analysis, analyse_reduced
from sweetspot.analysis.comparison import ChangedBat
from sweetspot.analysis.what_if import varied
from sweetspot.answers.setups import check_closing_speed, with_cor
from sweetspot.catalog.balls import ball_of_text, listed_ball
from sweetspot.catalog.bats import bat_tables
from sweetspot.catalog.files.bat import table_of_text
from sweetspot.catalog.files.read import bat_from_table, implement_from_table
from sweetspot.catalog.implements import implement_tables
from sweetspot.catalog.records import TomlTable, TomlValue, entry
from sweetspot.catalog.standard_hit import standard_conditions
from sweetspot.dynamics.beam import beam_model
from sweetspot.dynamics.reduction import ReducedBat, reduced_bat
from sweetspot.dynamics.rigid import RigidBody, rigid_body
from sweetspot.dynamics.weight_match import weighing, with_wall_factor
from sweetspot.equipment.ball import Ball
from sweetspot.equipment.bat import Bat
from sweetspot.equipment.implement import Implement
from sweetspot.errors import InputError
from sweetspot.motion.swing import SPEED_FROM_TIP, Conditions, Hands, Pitch, Swing
from sweetspot.units import INCH, MPH, OUNCE
from sweetspot.web.controls import BatState, PlacedState, SwungState, part_of
from sweetspot.web.errors import FieldError, about

NOTHING = "nothing"
"""Filling of an empty hole."""
KEPT = 256
"""Bats kept with their modes; a hollow one takes about 100 kB."""
KEPT_ANALYSES = 64
"""Bats kept with a swing and what they give, about 100 kB each."""
MOST_VALUES, LONGEST_VALUE, DEEPEST = 600, 2000, 8
"""Of an uploaded file: values, letters per value, tables inside tables."""
PLUG = 1 * INCH
PARK = "fenway-park"
"""Of those who play in the big parks."""
Swung = TypeVar("Swung", bound=SwungState)


def described(state: BatState) -> Bat:
    """Return the bat that a state's controls describe; a `FieldError` names the control that does not work."""
    bat = _changed(_unchoked(state))
    with about("choke_up_in"):
        return bat.choked_up(state.choke_up_in * INCH) if state.choke_up_in else bat


def reduced(state: BatState, ball: Ball) -> ReducedBat:
    """Return a state's bat with its beam and modes; only another bat or another make of ball works them out anew."""
    model = _reduced(_unchoked(state), _make(ball))
    return replace(model, bat=described(state)) if state.choke_up_in else model


@dataclass(frozen=True)
class UsualHit:
    """The usual hit of a bat: the values of controls that have not been moved."""

    pitch_speed_mph: float
    bat_speed_mph: float
    ball: str
    pitch: str
    swing_law: str
    league: str
    park: str


def usual(bat: Bat) -> UsualHit:
    """Return the usual hit in a bat's sport, as on the command line."""
    its = catalog.sport(bat.sport)
    pitch, speed = (round(entry.value / MPH, 6) for entry in (its.stroke.ball_speed, its.stroke.swing_speed))
    return UsualHit(pitch, speed, its.balls[0], its.pitches[0], its.swing_law, its.rules, (*its.fields, PARK)[0])


def swung(state: Swung) -> Swung:
    """Return a state with what its bat's sport usually has wherever a control is empty."""
    empty = [field.name for field in fields(UsualHit) if getattr(state, field.name, "") is None]
    if not empty:
        return state
    conditions = usual(described(state))
    return state.model_copy(update={name: getattr(conditions, name) for name in empty})


def bought_ball(state: SwungState) -> Ball:
    """Return the ball of a state's text, or of the catalogue, as bought; what a browser sends must open no file."""
    if state.ball_toml is not None:
        with about("ball_toml"):
            return _ball_of_text(state.ball_toml)
    with about("ball"):
        return listed_ball(swung(state).ball or "")


def ball_of(state: SwungState) -> Ball:
    """Return the ball as the controls say: bought with this restitution, then stored."""
    ball = bought_ball(state)
    if state.ball_cor is not None:
        with about("ball_cor"):
            ball = with_cor(ball, state.ball_cor)
    if state.ball_humidity is None and state.ball_temperature_degf is None:
        return ball
    warm = None if state.ball_temperature_degf is None else (state.ball_temperature_degf - 32) / 1.8
    with about("ball_humidity" if warm is None else "ball_temperature_degf"):
        return ball.conditioned(humidity=state.ball_humidity, temperature=warm)


def conditions_of(state: SwungState, bat: Bat) -> Conditions:
    """Return pitch, swing, hands and ball of a state; a changed bat is swung with the same effort as before."""
    given = _as_given(state, bat)
    changed = None if state.same == "speed" else changed_bat(state)
    with about("bat_speed_mph"):
        return given if changed is None else changed.with_same_effort(given)


def changed_bat(state: SwungState) -> ChangedBat | None:
    """Return a state's bat beside the one that its controls and its file changed; None: nothing was changed of it."""
    bat, held, before = described(state), _changed(_unchoked(state)), _listed(state).before_changes()
    if bat.length != before.length:  # another outline of another length is a bat of its own
        before = held
    named = getattr(state, "swing_law", None)
    if bat == before or named == "none":
        return None
    with about("swing_law"):
        law = catalog.swing_law(named or usual(bat).swing_law)
    return ChangedBat(bat, _body_of(held), before, _body_of(before), law)


def _listed(state: BatState) -> Bat:
    """Return the bat of the catalogue or of the file, with which the player's bat speed is known."""
    return _changed(part_of(_FIRST, BatState, bat=state.bat, bat_toml=state.bat_toml))


def place_of(state: PlacedState, bat: Bat, conditions: Conditions) -> float:
    """Return the place at which a state's ball meets the bat, m from the knob end; not on the hands."""
    place = bat.length - state.impact_from_tip_in * INCH
    if place < conditions.hands.position:
        most = (bat.length - conditions.hands.position) / INCH
        raise FieldError(
            "impact_from_tip_in", f"the ball would meet the hands; allowed is up to {most:.1f} in from the tip"
        )
    return place


@lru_cache(maxsize=KEPT)
def _ball_of_text(text: str) -> Ball:
    _table(text)
    return ball_of_text(text)


@lru_cache(maxsize=KEPT)
def _body_of(bat: Bat) -> RigidBody:
    return rigid_body(beam_model(bat))


def _as_given(state: SwungState, bat: Bat) -> Conditions:
    """Return the conditions with the bat speed that was given; the command line's defaults for the same options."""
    hit = standard_conditions(bat)
    pitch = hit.pitch if state.pitch_speed_mph is None else Pitch(speed=state.pitch_speed_mph * MPH)
    with about("bat_speed_mph"):
        speed = hit.swing.bat_speed if state.bat_speed_mph is None else state.bat_speed_mph * MPH
        swing = Swing(bat_speed=speed, measured_at=bat.length - SPEED_FROM_TIP, pivot=bat.choke)
    conditions = Conditions(
        pitch=pitch,
        swing=swing,
        hands=Hands(position=bat.choke + state.hands_in * INCH),
        ball=ball_of(state),
    )
    with about("bat_speed_mph"):
        check_closing_speed(conditions, bat.sport)
    return conditions


def analysed(state: SwungState) -> Analysis[Bat]:
    """Return the full answer for a state's bat and swing, worked out once for all that is asked of them."""
    return _analysed(part_of(state, SwungState))


def bat_from_text(text: str) -> Bat:
    """Return the bat of an uploaded TOML text, within limits on its size and depth; no file is opened."""
    return bat_from_table(_table(text), "the bat file")


def implement_from_text(text: str) -> Implement:
    """Return the bat, racket, club or stick of an uploaded TOML text; see `bat_from_text`."""
    return implement_from_table(_table(text), "the file")


def implement_of(name: str, text: str | None) -> Implement:
    """Return a bat, racket, club or stick: of a file's text where there is one, or the catalogue's of that name.

    What a browser sends must open no file, so that a name is one of the catalogue's alone.
    """
    if text is not None:
        with about("implement_toml"):
            return implement_from_text(text)
    with about("implement"):
        key, _ = entry(implement_tables(), name, "implement")
    return catalog.implement(key)


def _table(text: str) -> TomlTable:
    table = table_of_text(text, "the file")
    _check_extent(table)
    return table


def _check_extent(table: TomlTable) -> None:
    for count, (depth, value) in enumerate(_values(table, 0), start=1):
        if depth > DEEPEST or count > MOST_VALUES:
            raise InputError(
                f"the file holds more than {MOST_VALUES} values or {DEEPEST} tables inside each other; "
                "it needs a few lines"
            )
        if isinstance(value, str) and len(value) > LONGEST_VALUE:
            raise InputError(f"a value of the file has {len(value)} letters; allowed are {LONGEST_VALUE}")


def _values(value: TomlValue, depth: int) -> Iterator[tuple[int, TomlValue]]:
    yield depth, value
    if depth <= DEEPEST and isinstance(value, (Mapping, list)):
        for item in value.values() if isinstance(value, Mapping) else value:
            yield from _values(item, depth + 1)


def listed_bat(name: str) -> Bat:
    """Return a bat of the catalogue by its name alone: what a browser sends must open no file."""
    key, _ = entry(bat_tables(), name, "bat")
    return catalog.bat(key)


def plain(state: BatState) -> Bat:
    """Return a state's bat with its outline, before weight, holes, wall and grip are changed."""
    chosen = {name: getattr(state, name) for name in ("bat", "bat_toml", "profile_in")}
    return _changed(part_of(_FIRST, BatState, **chosen))


def _unchoked(state: BatState) -> BatState:
    """Return the bat's controls alone, without how it is held, as the key under which it is kept."""
    return part_of(state, BatState, choke_up_in=0.0)


def _make(ball: Ball) -> Ball:
    """Return the ball without its restitution, which no mode depends on."""
    return ball.replaced(name="", restitution=_ANY_RESTITUTION, reference_humidity=0.5, reference_temperature=21.0)


_ANY_RESTITUTION = catalog.ball().restitution
_FIRST = BatState()


@lru_cache(maxsize=KEPT)
def _reduced(state: BatState, ball: Ball) -> ReducedBat:
    bat = _changed(state)
    with about("bat_toml" if state.bat_toml is not None else "bat"):
        return reduced_bat(bat, ball=ball)


@lru_cache(maxsize=KEPT_ANALYSES)
def _analysed(state: SwungState) -> Analysis[Bat]:
    model = reduced(state, ball_of(state))
    with about("hands_in"):
        return analyse_reduced(model, conditions_of(state, model.bat))


@lru_cache(maxsize=KEPT)
def _changed(state: BatState) -> Bat:
    """Return the bat with every change that its controls ask for, in the order in which a workshop would make them."""
    if state.bat_toml is not None:
        with about("bat_toml"):
            bat = bat_from_text(state.bat_toml)
    else:
        with about("bat"):
            bat = listed_bat(state.bat)
    if state.profile_in is not None:
        with about("profile_in"):
            bat = bat.reshaped(tuple((place * INCH, width * INCH) for place, width in state.profile_in))
    if state.mass_oz is not None:
        with about("mass_oz"):
            mass = state.mass_oz * OUNCE
            bat = varied(bat, {"mass": mass}, fill=bat.material) if bat.shell is None else weighing(bat, mass)
            beam_model(bat)
    if state.wall_factor != 1:
        with about("wall_factor"):
            bat = with_wall_factor(bat, state.wall_factor)
    return _drilled(bat, state)


def _drilled(bat: Bat, state: BatState) -> Bat:
    if state.bore_diameter_in:
        with about("bore_diameter_in"):
            diameter, depth = state.bore_diameter_in * INCH, state.bore_depth_in * INCH
            if state.bore_fill == NOTHING:
                bat = bat.drilled(diameter=diameter, depth=depth)
            else:
                with about("bore_fill"):
                    fill = catalog.material(state.bore_fill)
                bat = bat.corked(diameter=diameter, depth=depth, fill=fill, plug=min(PLUG, depth / 2))
    if state.cup_diameter_in:
        with about("cup_diameter_in"):
            bat = bat.cupped(diameter=state.cup_diameter_in * INCH, depth=state.cup_depth_in * INCH)
    if state.weight_oz:
        place = bat.length - state.weight_from_tip_in * INCH
        if place < 0:
            raise FieldError(
                "weight_from_tip_in",
                f"the weight would sit {-place / INCH:.4g} in beyond the knob of a bat {bat.length / INCH:.4g} in long",
            )
        with about("weight_oz"):
            bat = bat.weighted(position=place, mass=state.weight_oz * OUNCE)
    return bat

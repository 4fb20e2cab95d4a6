"""The hit in slow motion: ball, bat, barrel wall and energy at a row of moments, and the wave to the hands."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import lru_cache
from typing import Annotated

import numpy as np
from pydantic import Field

from sweetspot.analysis.bat_analysis import TYPICAL_HAND, check_conditions, exit_speed_of
from sweetspot.answers.conditions import HitConditions, hit_conditions
from sweetspot.answers.hit import CollisionNumbers, collision_numbers
from sweetspot.answers.records import GRID, Energy, Length, Ratio, Speed, Time
from sweetspot.collision.one_hit import quick_hit
from sweetspot.collision.time_history import TimeHistory, arrival_time, history_of, impulse_given
from sweetspot.dynamics.hands import held_modes
from sweetspot.dynamics.hoop import HARMONICS, ring_felt
from sweetspot.dynamics.modes import Modes
from sweetspot.dynamics.patch import contact_patch
from sweetspot.dynamics.reduction import ReducedBat
from sweetspot.equipment.bat import Bat
from sweetspot.motion.swing import Conditions, Hands
from sweetspot.numerics.arrays import Array
from sweetspot.reports.hit.document import touched_again
from sweetspot.reports.page_words import (
    film_energy_names,
    film_energy_words,
    film_phases,
    film_speeds,
    force_words,
    wave_words,
)
from sweetspot.reports.sport_words import words_of
from sweetspot.units.dimensions import ANGLE, ENERGY, FORCE, LENGTH, SPEED, TIME
from sweetspot.web.bats import ball_of, conditions_of, place_of, reduced
from sweetspot.web.controls import HeldState, PlacedState
from sweetspot.web.documents import ReadDocument, Sentences, in_both_systems, page_document
from sweetspot.web.drawings import BallPicture, BatPicture, ball_picture, bat_picture
from sweetspot.web.recipes import Ask, bat_source, bat_text, place_option, setup_lines, swing_options
from sweetspot.web.view import View

PLACES = 61
"""Places along the bat at which a drawing needs its shapes."""


class HitFilmState(PlacedState, HeldState):
    """The bat, the swing, where they meet, and how the film is shown."""

    duration_ms: float = Field(4.0, ge=1.5, le=20, description="how long the film goes on after first touch")
    moment_ms: float = Field(0.6, ge=-0.5, le=20, description="moment that is shown; the answer does not depend on it")
    exaggeration: float = Field(2.0, ge=1, le=20, description="how many times larger the bat's motion is drawn")
    recoil: bool = Field(True, description="whether the drawing moves the whole bat too, or bends it alone")
    slowness: float = Field(1000.0, ge=100, le=10000, description="how many times slower than life the film plays")


FILM_FIELDS = ("moment_ms", "exaggeration", "recoil", "slowness")
"""Controls of the drawing alone."""


@dataclass(frozen=True, kw_only=True)
class FilmHit(CollisionNumbers):
    """The hit that is shown; ``release_time`` is when the ball is free."""

    release_time: Time
    touched_again: Sentences
    bat_speed: Speed
    exit_speed: Speed
    incoming_energy: Energy


@dataclass(frozen=True)
class HitFilm:
    """Ball and bat at a row of moments, shape (m,).

    How the bat's line moves is y(x, t) = sum_i shape_i(x) motion_i(t), in the direction of the push, places from the
    knob end; ``push`` and ``turn`` are the part of it that an unbending bat would show: push + turn (x - balance).
    """

    time: Annotated[Array, TIME]
    ball_travel: Annotated[Array, LENGTH]
    force: Annotated[Array, FORCE]
    compression: Annotated[Array, LENGTH]
    gap: Annotated[Array, LENGTH]
    place: Annotated[Array, LENGTH]
    shape_per_sqrt_kg: Annotated[Array, GRID]
    motion_sqrt_kg: Annotated[Array, LENGTH, GRID]
    push: Annotated[Array, LENGTH]
    turn: Annotated[Array, ANGLE]


@dataclass(frozen=True)
class HandMotion:
    """The motion of the top hand's place, and the arrival of the wave there; None: it does not arrive."""

    displacement: Annotated[Array, LENGTH]
    velocity: Annotated[Array, SPEED]
    arrival: Time | None
    impulse_given: Ratio | None


@dataclass(frozen=True)
class WallMotion:
    """The dent of a hollow barrel's wall under the ball by harmonics: inwards by dent_n(t) cos(n theta)."""

    harmonics: tuple[int, ...]
    dent: Annotated[tuple[Array, ...], LENGTH]
    radius: Length
    wall: Length


@dataclass(frozen=True)
class FilmPhase:
    """What goes on from a moment on, in words with {moment}, {pressed} and {force} where these numbers stand."""

    start: Time
    words: str


@dataclass(frozen=True, kw_only=True)
class FilmAnswer:
    """The hit and its film.

    Parameters
    ----------
    energy, energy_names : the parts of the energy that there are, and what they are called.
    energy_words : where the energy is at the end.
    speeds, force : of bat and ball where they meet, and the greatest force, in words.
    words : what the hands could still do.
    phases : earliest first.
    """

    bat: BatPicture
    ball: BallPicture
    hands: Annotated[tuple[float, ...], LENGTH]
    hit: FilmHit
    film: HitFilm
    energy: Annotated[Mapping[str, Array], ENERGY]
    energy_names: Mapping[str, str]
    energy_words: Sentences
    speeds: Sentences
    force: Sentences
    phases: tuple[FilmPhase, ...]
    top_hand: HandMotion
    hoop: WallMotion | None
    words: Sentences
    conditions: HitConditions


def answer(state: HitFilmState) -> FilmAnswer:
    """Return the hit and its film; how it is drawn makes no difference."""
    drawn = {name: HitFilmState.model_fields[name].default for name in FILM_FIELDS}
    return _answer(state.model_copy(update=drawn))


@lru_cache(maxsize=64)
def _answer(state: HitFilmState) -> FilmAnswer:
    reduced_bat, conditions, place = _asked(state)
    modes = reduced_bat.modes
    if state.held:
        hands = conditions.hands
        modes = held_modes(modes, Hands(position=hands.position, spacing=hands.spacing, **TYPICAL_HAND))
    closing = conditions.pitch.speed + conditions.swing.speed_at(place)
    impact = quick_hit(modes, ball=conditions.ball, position=place, closing_speed=closing)
    scene = history_of(impact, modes=modes, ball=conditions.ball, duration=state.duration_ms * 1e-3)
    terms = words_of(reduced_bat.bat.sport)
    again, moved = touched_again(impact, terms), _hands(scene, modes, conditions.hands.position)
    arrival = None if moved.arrival is None else float(moved.arrival)
    energy = {name: _short(part, 3) for name, part in scene.energy._asdict().items() if part.any()}
    last = film_energy_words(impact.energy.incoming, {name: float(part[-1]) for name, part in energy.items()}, terms)
    bat_speed, leaves = conditions.swing.speed_at(impact.position), exit_speed_of(impact, conditions)
    phases = film_phases(impact.release_time, arrival)
    words = wave_words(
        reduced_bat.bat.name,
        contact_time=impact.contact_time,
        arrival=arrival,
        given=None if moved.impulse_given is None else float(moved.impulse_given),
    )
    return FilmAnswer(
        bat=bat_picture(state, reduced_bat),
        ball=ball_picture(state, conditions.ball),
        hands=conditions.hands.places,
        hit=FilmHit(
            **vars(collision_numbers(impact)),
            release_time=impact.release_time,
            touched_again=in_both_systems(again),
            bat_speed=bat_speed,
            exit_speed=leaves,
            incoming_energy=impact.energy.incoming,
        ),
        film=_film(scene, modes, reduced_bat),
        energy=energy,
        energy_names=film_energy_names(energy, terms),
        energy_words=in_both_systems([last]),
        speeds=in_both_systems([film_speeds(bat_speed, conditions.pitch.speed, leaves)]),
        force=in_both_systems([force_words(impact.peak_force)]),
        phases=tuple(FilmPhase(*phase) for phase in phases),
        top_hand=moved,
        hoop=_hoop(scene, modes, reduced_bat, conditions),
        words=in_both_systems([*words, *again]),
        conditions=hit_conditions(conditions),
    )


def sure(state: HitFilmState) -> ReadDocument:
    """Return the hit of the free bat with an interval beside each number, and what they come from."""
    from sweetspot.answers.hit import HitQuestion, hit_answer
    from sweetspot.reports.hit.document import hit_document
    from sweetspot.web.how_sure import PAGE_DRAWS, sources_for

    reduced_bat, conditions, place = _asked(state)
    sources = sources_for(state, reduced_bat.bat, conditions)
    question = HitQuestion(reduced_bat.bat, conditions, place, sources=sources, draws=PAGE_DRAWS)
    return page_document(hit_document(hit_answer(question)))


def _asked(state: HitFilmState) -> tuple[ReducedBat[Bat], Conditions, float]:
    """Return the bat, its swing and the place that is hit, m from the knob end."""
    reduced_bat = reduced(state, ball_of(state))
    conditions = conditions_of(state, reduced_bat.bat)
    check_conditions(reduced_bat, conditions)
    return reduced_bat, conditions, place_of(state, reduced_bat.bat, conditions)


def _film(scene: TimeHistory, modes: Modes, reduced_bat: ReducedBat) -> HitFilm:
    """Return ball and bat at every moment, rounded to what a drawing can show."""
    impact, body = scene.impact, reduced_bat.body
    struck = modes.shape_at(impact.position, closing_speed=impact.closing_speed)
    places = np.linspace(0, reduced_bat.bat.length, PLACES)
    line = [index for index, family in enumerate(modes.families) if family != "hoop"]
    push, turn = (scene.displacement @ modes.rigid_part[:2].T).T
    return HitFilm(
        time=_short(scene.times, 9),
        ball_travel=_short(scene.travel, 6),
        force=_short(scene.force, 1),
        compression=_short(scene.compression, 7),
        gap=_short(np.maximum(scene.displacement @ struck - scene.travel, 0.0), 6),
        place=_short(places, 5),
        shape_per_sqrt_kg=_short(modes.shape_at(places)[:, line].T, 4),
        motion_sqrt_kg=_short(scene.displacement[:, line].T, 6),
        push=_short(push / np.sqrt(body.mass), 6),
        turn=_short(turn / np.sqrt(body.moi_cm), 6),
    )


def _hands(scene: TimeHistory, modes: Modes, position: float) -> HandMotion:
    shape = modes.shape_at(position)
    arrival = arrival_time(scene, modes=modes, position=position)
    given = None if arrival is None else impulse_given(scene.impact, arrival)
    return HandMotion(_short(scene.displacement @ shape, 6), _short(scene.velocity @ shape, 3), arrival, given)


def _hoop(scene: TimeHistory, modes: Modes, reduced_bat: ReducedBat, conditions: Conditions) -> WallMotion | None:
    hoop = modes.of_family("hoop")
    if not hoop or reduced_bat.bat.shell is None:
        return None
    position, closing_speed = scene.impact.position, scene.impact.closing_speed
    shape = modes.shape_at(position, closing_speed=closing_speed)
    dents = []
    for harmonic in HARMONICS:
        same = [index for index in hoop if modes.harmonics[index] == harmonic]
        felt = scene.displacement[:, same] @ shape[same]
        part = ring_felt(reduced_bat.beam, harmonic=harmonic, patch=contact_patch(conditions.ball, closing_speed))
        dents.append(_short(felt / part, 7))
    bat = reduced_bat.bat
    return WallMotion(HARMONICS, tuple(dents), float(bat.diameter_at(position)) / 2, float(bat.wall_at(position)))


def _short(values: Array, digits: int) -> Array:
    """Return numbers rounded to what a drawing can show, so that the answer is short."""
    return np.round(values, digits) + 0.0


def recipe(state: HitFilmState) -> dict[str, str]:
    """Return the lines that give the hit and its film; the command line knows no hands that weigh something."""
    python = setup_lines(state, held=state.held) + (
        "from sweetspot.collision.time_history import arrival_time, history_of\n\n"
        f"impact = hit_at(bat.length - {state.impact_from_tip_in!r} * INCH, modes=modes, conditions=conditions)\n"
        f"scene = history_of(impact, modes=modes, ball=conditions.ball, duration={state.duration_ms!r} * 1e-3)\n"
        "scene.times, scene.force, scene.energy.bending  # s, N, J\n"
        "arrival_time(scene, modes=modes, position=conditions.hands.position)  # s\n"
    )
    command = Ask("hit", (bat_source(state),), place_option(state) | swing_options(state)).command
    return {"python": python, "toml": bat_text(state)} | ({} if state.held else {"command": command})


VIEW = View("hit", "Slow motion", HitFilmState, answer, recipe, asides={"sure": sure})

"""The hit in slow motion: ball, bat, barrel wall and energy at a row of moments, and the wave to the hands."""

from __future__ import annotations

from functools import lru_cache
from typing import Any

import numpy as np
from pydantic import Field

from sweetspot.analysis.bat_analysis import TYPICAL_HAND, check_conditions, exit_speed_of
from sweetspot.answers.conditions import hit_conditions
from sweetspot.answers.records import to_dict
from sweetspot.collision.impact import Impact
from sweetspot.collision.one_hit import quick_hit
from sweetspot.collision.time_history import TimeHistory, arrival_time, history_of, impulse_given
from sweetspot.dynamics.hands import gripped
from sweetspot.dynamics.hoop import HARMONICS, ring_felt
from sweetspot.dynamics.modes import Modes
from sweetspot.dynamics.patch import contact_patch
from sweetspot.dynamics.reduction import ReducedBat
from sweetspot.dynamics.rigid import RigidBody
from sweetspot.equipment.bat import Bat
from sweetspot.equipment.sport import Terms
from sweetspot.motion.swing import Conditions, Hands
from sweetspot.numerics.arrays import Array
from sweetspot.report.hit.second_touch import touched_again
from sweetspot.report.sport_words import words_of
from sweetspot.units import INCH
from sweetspot.web.bats import ball_of, conditions_of, reduced
from sweetspot.web.documents import ReadDocument, in_both_systems, told
from sweetspot.web.drawings import ball_picture, bat_picture
from sweetspot.web.errors import FieldError
from sweetspot.web.recipes import bat_name, bat_text, conditions_lines, modes_line, swing_options
from sweetspot.web.states import HeldState, PlacedState
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


def answer(state: HitFilmState) -> dict[str, Any]:
    """Return the hit and its film; how it is drawn makes no difference."""
    drawn = {name: HitFilmState.model_fields[name].default for name in FILM_FIELDS}
    return _answer(state.model_copy(update=drawn))


@lru_cache(maxsize=64)
def _answer(state: HitFilmState) -> dict[str, Any]:
    reduced_bat, conditions, place = _asked(state)
    modes = reduced_bat.modes
    if state.held:
        hands = conditions.hands
        modes = gripped(modes, Hands(position=hands.position, spacing=hands.spacing, **TYPICAL_HAND))
    closing = conditions.pitch.speed + conditions.swing.speed_at(place)
    impact = quick_hit(modes, ball=conditions.ball, position=place, closing_speed=closing)
    struck = modes.shape_at(place, closing_speed=impact.closing_speed)
    scene = history_of(impact, modes=modes, ball=conditions.ball, duration=state.duration_ms * 1e-3)
    return {
        "bat": bat_picture(state, reduced_bat),
        "ball": ball_picture(state, conditions.ball),
        "hands_m": conditions.hands.places,
        "hit": _hit(impact, conditions, words_of(reduced_bat.bat)),
        "film": {
            "time_s": _short(scene.times, 9),
            "ball_travel_m": _short(scene.travel, 6),
            "force_n": _short(scene.force, 1),
            "compression_m": _short(scene.compression, 7),
            "gap_m": _short(np.maximum(scene.displacement @ struck - scene.travel, 0.0), 6),
            **_bat_motion(scene, modes, reduced_bat.body, reduced_bat.bat.length),
        },
        "energy_j": {name: _short(part, 3) for name, part in scene.energy._asdict().items() if part.any()},
        "hands": _hands(scene, modes, conditions.hands.position),
        "hoop": _hoop(scene, modes, reduced_bat, conditions),
        "conditions": to_dict(hit_conditions(conditions)),
    }


def sure(state: HitFilmState) -> ReadDocument:
    """Return the hit of the free bat with an interval beside each number, and what they come from."""
    from sweetspot.answers.hit import HitQuestion, hit_answer
    from sweetspot.report.hit.document import hit_document
    from sweetspot.web.how_sure import PAGE_DRAWS, sources_for

    reduced_bat, conditions, place = _asked(state)
    sources = sources_for(state, reduced_bat.bat, conditions)
    question = HitQuestion(reduced_bat.bat, conditions, place, sources=sources, draws=PAGE_DRAWS)
    return told(hit_document(hit_answer(question)))


def _asked(state: HitFilmState) -> tuple[ReducedBat[Bat], Conditions, float]:
    """Return the bat, its swing and the place that is hit, m from the knob end."""
    reduced_bat = reduced(state, ball_of(state))
    conditions = conditions_of(state, reduced_bat.bat)
    check_conditions(reduced_bat.bat, conditions, body=reduced_bat.body)
    place = reduced_bat.bat.length - state.impact_from_tip_in * INCH
    if place < conditions.hands.position:
        most = (reduced_bat.bat.length - conditions.hands.position) / INCH
        raise FieldError(
            "impact_from_tip_in", f"the ball would meet the hands; allowed is up to {most:.1f} in from the tip"
        )
    return reduced_bat, conditions, place


def _hit(impact: Impact, conditions: Conditions, words: Terms) -> dict[str, Any]:
    return {
        "position_m": impact.position,
        "outcome_text": impact.outcome.sentence,
        "touched_again": in_both_systems(touched_again(impact, words)),
        "closing_speed_m_s": impact.closing_speed,
        "bat_speed_m_s": conditions.swing.speed_at(impact.position),
        "exit_speed_m_s": exit_speed_of(impact, conditions),
        "collision_efficiency": impact.collision_efficiency,
        "contact_time_s": impact.contact_time,
        "release_time_s": impact.release_time,
        "peak_force_n": impact.peak_force,
        "peak_compression_m": impact.peak_compression,
        "incoming_energy_j": impact.energy.incoming,
    }


def _bat_motion(scene: TimeHistory, modes: Modes, body: RigidBody, length: float) -> dict[str, Any]:
    """Return how the bat's line moves, as modes: y(x, t) = sum_i shape_i(x) q_i(t), in the direction of the push.

    ``push_m`` and ``turn_rad`` are the part of it that an unbending bat would show: y = push + turn (x - balance).
    """
    places = np.linspace(0, length, PLACES)
    line = [index for index, family in enumerate(modes.families) if family != "hoop"]
    push, turn = (scene.displacement @ modes.rigid_part[:2].T).T
    return {
        "place_m": _short(places, 5),
        "shape_per_sqrt_kg": _short(modes.shape_at(places)[:, line].T, 4),
        "motion_sqrt_kg_m": _short(scene.displacement[:, line].T, 6),
        "push_m": _short(push / np.sqrt(body.mass), 6),
        "turn_rad": _short(turn / np.sqrt(body.moi_cm), 6),
    }


def _hands(scene: TimeHistory, modes: Modes, position: float) -> dict[str, Any]:
    """Return how the place of the top hand moves, and when the wave gets there."""
    shape = modes.shape_at(position)
    arrival = arrival_time(scene, modes=modes, position=position)
    return {
        "displacement_m": _short(scene.displacement @ shape, 6),
        "velocity_m_s": _short(scene.velocity @ shape, 3),
        "arrival_s": arrival,
        "impulse_given": None if arrival is None else impulse_given(scene.impact, arrival),
    }


def _hoop(scene: TimeHistory, modes: Modes, reduced_bat: ReducedBat, conditions: Conditions) -> dict[str, Any] | None:
    """Return how far each harmonic dents a hollow barrel's wall under the ball: inwards by a_n(t) cos(n theta)."""
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
    return {
        "harmonics": HARMONICS,
        "dent_m": dents,
        "radius_m": float(reduced_bat.bat.diameter_at(position)) / 2,
        "wall_m": float(reduced_bat.bat.wall_at(position)),
    }


def _short(values: Array, digits: int) -> Array:
    """Return numbers rounded to what a drawing can show, so that the answer is short."""
    return np.round(values, digits) + 0.0


def recipe(state: HitFilmState) -> dict[str, str]:
    """Return the lines that give the hit and its film; the command line knows no hands that weigh something."""
    place = f"{state.impact_from_tip_in:.12g}in-from-tip"
    python = conditions_lines(state) + (
        "from sweetspot import all_modes, beam_model\n"
        "from sweetspot.collision.time_history import arrival_time, history_of\n\n"
        f"{modes_line(held=state.held)}"
        f"impact = hit_at(bat.length - {state.impact_from_tip_in!r} * INCH, modes=modes, conditions=conditions)\n"
        f"scene = history_of(impact, modes=modes, ball=conditions.ball, duration={state.duration_ms!r} * 1e-3)\n"
        "scene.times, scene.force, scene.energy.bending  # s, N, J\n"
        "arrival_time(scene, modes=modes, position=conditions.hands.position)  # s\n"
    )
    command = f"sweetspot hit {bat_name(state)} --at {place}{swing_options(state)}"
    return {"python": python, "toml": bat_text(state)} | ({} if state.held else {"command": command})


VIEW = View("hit", "Slow motion", HitFilmState, answer, recipe, asides={"sure": sure})

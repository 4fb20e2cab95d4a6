"""The bat's motions: their shapes, still places, frequencies and damping, and what a tap excites of them."""

from __future__ import annotations

from collections import Counter
from functools import lru_cache
from typing import Any, Literal, NamedTuple

import numpy as np
from pydantic import Field

from sweetspot.analysis.bat_analysis import TYPICAL_HAND, check_conditions
from sweetspot.analysis.sweet_spot import barrel_node
from sweetspot.dynamics.hands import gripped
from sweetspot.dynamics.hoop import barrel_range
from sweetspot.dynamics.modes import Modes
from sweetspot.dynamics.tap import tapped
from sweetspot.motion.swing import Hands
from sweetspot.numerics.arrays import Array
from sweetspot.units import INCH
from sweetspot.web.bats import ball_of, conditions_of, reduced
from sweetspot.web.drawings import bat_picture
from sweetspot.web.errors import FieldError
from sweetspot.web.recipes import bat_name, bat_text, conditions_lines, modes_line, swing_options
from sweetspot.web.states import HeldState, SwungState
from sweetspot.web.view import View

PLACES = 101
HIGHEST = 10e3
"""Hz; above it a beam or a thin shell says little, and nobody hears or feels it."""
TAP_FIELDS = ("tap_from_tip_in", "tap_ms")
STILL = 1e-3
"""Part of the greatest shape below which a stretch of a hoop mode counts as still all along."""


class ModesState(SwungState, HeldState):
    """The bat, who holds it, which motion is shown, and where it is tapped."""

    family: Literal["rigid", "bending", "hoop", "hand"] = Field("bending", description="kind of motion that is shown")
    number: int = Field(1, ge=1, le=40, description="which of that kind, from the lowest")
    tap_from_tip_in: float = Field(2.0, ge=0, le=52, description="where the bat is tapped")
    tap_ms: float = Field(1.0, ge=0.02, le=5, description="how long the tap lasts; a ball: 1, a knuckle: 2, steel: 0.1")
    exaggeration: float = Field(1.0, ge=0.2, le=3, description="size of the drawn motion against the usual one")


def answer(state: ModesState) -> dict[str, Any]:
    """Return every motion of the bat and what the tap leaves in it."""
    still = {name: ModesState.model_fields[name].default for name in ("family", "number", "exaggeration", *TAP_FIELDS)}
    held = _held(state.model_copy(update=still))
    length = held.answer["bat"].length
    place, duration = length - state.tap_from_tip_in * INCH, state.tap_ms * 1e-3
    if place < 0:
        raise FieldError("tap_from_tip_in", f"the bat is {length / INCH:.4g} in long; tap it no further from its tip")
    taps = _taps(held, place, duration)
    return {
        **held.answer,
        "tap": {"position_m": place, "duration_s": duration},
        "modes": [{**row, "tap": tap} for row, tap in zip(held.answer["modes"], taps, strict=True)],
    }


class _Held(NamedTuple):
    """What does not depend on the tap: the motions, which of them are listed, the top hand's place, and their rows."""

    modes: Modes
    listed: list[int]
    hand: float
    answer: dict[str, Any]


@lru_cache(maxsize=64)
def _held(state: ModesState) -> _Held:
    model = reduced(state, ball_of(state))
    conditions = conditions_of(state, model.bat)
    check_conditions(model.bat, conditions, body=model.body)
    bat, hands, modes = model.bat, conditions.hands, model.modes
    if state.held:
        modes = gripped(modes, Hands(position=hands.position, spacing=hands.spacing, **TYPICAL_HAND))
    places = np.linspace(0, bat.length, PLACES)
    order = np.argsort(modes.frequency, kind="stable")
    listed = [int(index) for index in order if modes.frequency[index] < HIGHEST]
    table = {
        "bat": bat_picture(state, model),
        "hands_m": hands.places,
        "nodes": {f"node_{n}_m": barrel_node(model.modes, harmonic=n) for n in (1, 2)},
        "place_m": np.round(places, 5),
        "hoop_start_m": barrel_range(model.beam)[0] if bat.shell is not None else None,
        "modes": _rows(modes, listed, places),
    }
    return _Held(modes, listed, hands.position, table)


def _rows(modes: Modes, listed: list[int], places: Array) -> list[dict[str, Any]]:
    """Return the motions, lowest first, with shapes one high and positive at the tip."""
    shapes = modes.shape_at(places)
    damping = modes.damping_rate + np.sum(modes.dashpots**2, axis=0)
    nodes = _nodes(modes, listed, float(places[-1]))
    counts: Counter[str] = Counter()
    rows = []
    for index in listed:
        family, harmonic = modes.families[index], modes.harmonics[index]
        counts.update([family, f"{family} {harmonic}"])
        omega = 0.0 if family == "rigid" else float(modes.angular_frequency[index])
        rows.append(
            {
                "family": family,
                "number": counts[family],
                "harmonic": harmonic,
                "axial": counts[f"{family} {harmonic}"] if family == "hoop" else None,
                "frequency_hz": omega / (2 * np.pi),
                "damping_ratio": damping[index] / (2 * omega) if omega > 0 else None,
                "decay_s": 2 / damping[index] if damping[index] * omega > 0 else None,
                "nodes_m": nodes[index],
                "shape": np.round(shapes[:, index] / _signed_largest(shapes[:, index]), 4) + 0.0,
            }
        )
    return rows


def _taps(held: _Held, place: float, duration: float) -> list[dict[str, float | None]]:
    """Return what the tap leaves in each motion: its part of the vibration's energy, and the speed at the top hand."""
    modes, listed = held.modes, held.listed
    speeds, at_hand = tapped(modes, position=place, duration=duration), modes.shape_at(held.hand)
    rings = [index for index in listed if modes.families[index] != "rigid"]
    total = float(np.sum(speeds[rings] ** 2))
    return [
        {
            "energy_share": float(speeds[index] ** 2 / total) if index in rings and total > 0 else None,
            "hand_speed_m_s_per_n_s": float(abs(speeds[index] * at_hand[index])),
        }
        for index in listed
    ]


def _nodes(modes: Modes, listed: list[int], length: float) -> dict[int, list[float]]:
    """Return where motions stand still; a hoop mode's ends, where the barrel is held round, are not its nodes."""
    hoops = [index for index in listed if modes.families[index] == "hoop"]
    still = {index: [float(node) for node in modes.nodes(index)] for index in listed if index not in hoops}
    if hoops:
        places = np.linspace(0, length, 2001)
        for index, shape in zip(hoops, modes.shape_at(places)[:, hoops].T, strict=True):
            moving = np.abs(shape) > STILL * np.abs(shape).max()
            still[index] = _crossings(places[moving], shape[moving])
    return still


def _crossings(places: Array, values: Array) -> list[float]:
    """Return where values along a line change their sign, straight between places."""
    turns = np.flatnonzero(values[1:] * values[:-1] < 0)
    parts = values[turns] / (values[turns] - values[turns + 1])
    return [float(place) for place in places[turns] + parts * (places[turns + 1] - places[turns])]


def _signed_largest(shape: Array) -> float:
    """Return the greatest size of a shape, with the sign that makes its last moving place positive."""
    largest = float(np.abs(shape).max())
    moving = shape[np.abs(shape) > STILL * largest]
    return largest if not len(moving) or moving[-1] > 0 else -largest


def recipe(state: ModesState) -> dict[str, str]:
    """Return the lines that give the motions and the tap; the command line knows no hands that weigh something."""
    python = conditions_lines(state) + (
        "from sweetspot import all_modes, beam_model\n"
        "from sweetspot.dynamics.tap import tapped\n\n"
        f"{modes_line(held=state.held)}"
        "modes.frequency, modes.damping_ratio, modes.nodes(2)  # Hz, ratios, m from the knob end\n"
        f"tapped(modes, position=bat.length - {state.tap_from_tip_in!r} * INCH, duration={state.tap_ms!r} * 1e-3)\n"
    )
    command = f"sweetspot report {bat_name(state)}{swing_options(state)} --format json"
    return {"python": python, "toml": bat_text(state)} | ({} if state.held else {"command": command})


VIEW = View("modes", "Modes", ModesState, answer, recipe)

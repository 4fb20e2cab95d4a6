"""The bat's motions: their shapes, still places, frequencies and damping, and what a tap excites of them."""

from __future__ import annotations

from collections import Counter
from typing import Any, Literal

import numpy as np
from pydantic import Field

from sweetspot.analysis import TYPICAL_HAND, Reduction, check_conditions
from sweetspot.collision.impact import Array
from sweetspot.report.border import bat_json
from sweetspot.sweet_spots import barrel_node
from sweetspot.swing import Hands
from sweetspot.units import INCH
from sweetspot.vibration.hands import gripped
from sweetspot.vibration.hoop import barrel_range
from sweetspot.vibration.modes import Modes
from sweetspot.vibration.tap import tapped
from sweetspot.web.bats import ball_of, conditions_of, reduced
from sweetspot.web.faults import FieldError
from sweetspot.web.outline import outline
from sweetspot.web.recipes import bat_name, bat_text, conditions_lines, modes_line, swing_options
from sweetspot.web.states import SwungState
from sweetspot.web.view import View

PLACES = 101
HIGHEST = 10e3
"""Hz; above it a beam or a thin shell says little, and nobody hears or feels it."""
STILL = 1e-3
"""Part of the greatest shape below which a stretch of a hoop mode counts as still all along."""


class ModesState(SwungState):
    """The bat, who holds it, which motion is shown, and where it is tapped."""

    held: bool = Field(False, description="typical hands hold the bat: a mass behind a spring and a damper each")
    family: Literal["rigid", "bending", "hoop", "hand"] = Field("bending", description="kind of motion that is shown")
    number: int = Field(1, ge=1, le=40, description="which of that kind, from the lowest")
    tap_from_tip_in: float = Field(2.0, ge=0, le=52, description="where the bat is tapped")
    tap_ms: float = Field(1.0, ge=0.02, le=5, description="how long the tap lasts; a ball: 1, a knuckle: 2, steel: 0.1")
    exaggeration: float = Field(1.0, ge=0.2, le=3, description="size of the drawn motion against the usual one")


def answer(state: ModesState) -> dict[str, Any]:
    """Return every motion of the bat and what the tap leaves in it."""
    found = reduced(state, ball_of(state))
    conditions = conditions_of(state, found.bat)
    check_conditions(found.bat, conditions, body=found.body)
    place = found.bat.length - state.tap_from_tip_in * INCH
    if place < 0:
        raise FieldError(
            "tap_from_tip_in", f"the bat is {found.bat.length / INCH:.4g} in long; tap it no further from its tip"
        )
    hands, modes = conditions.hands, found.modes
    if state.held:
        modes = gripped(modes, Hands(position=hands.position, spacing=hands.spacing, **TYPICAL_HAND))
    places = np.linspace(0, found.bat.length, PLACES)
    listed = _listed(modes)
    hoop_start = barrel_range(found.line)[0] if found.bat.shell is not None else None
    return {
        "bat": {**bat_json(found.bat.name, found.bat.length, found.body), **outline(found.bat)},
        "hands_m": hands.places,
        "nodes": {f"node_{n}_m": barrel_node(found.modes, harmonic=n) for n in (1, 2)},
        "tap": {"position_m": place, "duration_s": state.tap_ms * 1e-3},
        "place_m": np.round(places, 5),
        "hoop_start_m": hoop_start,
        "modes": _modes(found, modes, listed, places, tap=(place, state.tap_ms * 1e-3), hand=hands.position),
    }


def _listed(modes: Modes) -> list[int]:
    """Return the motions to show, in the order of their frequencies: all that can be heard or felt."""
    order = np.argsort(modes.frequency, kind="stable")
    return [int(index) for index in order if modes.frequency[index] < HIGHEST]


def _modes(
    found: Reduction, modes: Modes, listed: list[int], places: Array, *, tap: tuple[float, float], hand: float
) -> list[dict[str, Any]]:
    speeds = tapped(modes, position=tap[0], duration=tap[1])
    shapes, at_hand, at_tap = modes.shape_at(places), modes.shape_at(hand), modes.shape_at(tap[0])
    rings = [index for index in listed if modes.families[index] != "rigid"]
    total = float(np.sum(speeds[rings] ** 2))
    damping = modes.damping_rate + np.sum(modes.dashpots**2, axis=0)
    counts: Counter[str] = Counter()
    rows = []
    for index in listed:
        family, harmonic = modes.families[index], modes.harmonics[index]
        counts.update([family, f"{family} {harmonic}"])
        largest = _signed_largest(shapes[:, index])
        omega = float(modes.angular_frequency[index]) if index in rings else 0.0
        rows.append(
            {
                "family": family,
                "number": counts[family],
                "harmonic": harmonic,
                "axial": counts[f"{family} {harmonic}"] if family == "hoop" else None,
                "frequency_hz": omega / (2 * np.pi),
                "damping_ratio": damping[index] / (2 * omega) if omega > 0 else None,
                "decay_s": 2 / damping[index] if damping[index] * omega > 0 else None,
                "nodes_m": _nodes(modes, index, found.bat.length),
                "shape": np.round(shapes[:, index] / largest, 4) + 0.0,
                "tap": {
                    "energy_share": float(speeds[index] ** 2 / total) if index in rings and total > 0 else None,
                    "hand_speed_m_s_per_n_s": float(abs(speeds[index] * at_hand[index])),
                    "shape_at_tap": float(at_tap[index] / largest),
                },
            }
        )
    return rows


def _nodes(modes: Modes, index: int, length: float) -> list[float]:
    """Return where a motion stands still; a hoop mode's ends, where the barrel is held round, are not its nodes."""
    if modes.families[index] != "hoop":
        return [float(node) for node in modes.nodes(index)]
    places = np.linspace(0, length, 2001)
    shape = modes.shape_at(places)[:, index]
    moving = np.abs(shape) > STILL * np.abs(shape).max()
    places, shape = places[moving], shape[moving]
    turns = np.flatnonzero(shape[1:] * shape[:-1] < 0)
    return [float(np.interp(0.0, sorted(shape[turn : turn + 2]), places[turn : turn + 2])) for turn in turns]


def _signed_largest(shape: Array) -> float:
    """Return the greatest size of a shape, with the sign that makes its last moving place positive."""
    largest = float(np.abs(shape).max())
    moving = shape[np.abs(shape) > STILL * largest]
    return largest if not len(moving) or moving[-1] > 0 else -largest


def recipe(state: ModesState) -> dict[str, str]:
    """Return the lines that give the motions and the tap; the command line knows no hands that weigh something."""
    python = conditions_lines(state) + (
        "from sweetspot import modes_of, reduce\n"
        "from sweetspot.vibration.tap import tapped\n\n"
        f"{modes_line(held=state.held)}"
        "modes.frequency, modes.damping_ratio, modes.nodes(2)  # Hz, ratios, m from the knob end\n"
        f"tapped(modes, position=bat.length - {state.tap_from_tip_in!r} * INCH, duration={state.tap_ms!r} * 1e-3)\n"
    )
    command = f"sweetspot report {bat_name(state)}{swing_options(state)} --format json"
    return {"python": python, "toml": bat_text(state)} | ({} if state.held else {"command": command})


VIEW = View("modes", "Modes", ModesState, answer, recipe)

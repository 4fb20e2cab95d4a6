"""The bat's motions: their shapes, still places, frequencies and damping, and what a tap excites of them."""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass, replace
from functools import lru_cache
from typing import Annotated, Literal, NamedTuple

import numpy as np
from pydantic import Field

from sweetspot.analysis.bat_analysis import TYPICAL_HAND, check_conditions
from sweetspot.analysis.sweet_spot import barrel_node
from sweetspot.answers.records import Frequency, Length, Ratio, Time
from sweetspot.dynamics.hands import held_modes
from sweetspot.dynamics.hoop import barrel_range
from sweetspot.dynamics.modes import Modes, tapped
from sweetspot.motion.swing import Hands
from sweetspot.numerics.arrays import Array
from sweetspot.reports.page_words import motion_words
from sweetspot.units import INCH
from sweetspot.units.dimensions import LENGTH
from sweetspot.web.bats import ball_of, conditions_of, reduced
from sweetspot.web.controls import BatState, HeldState, Place, SwungState
from sweetspot.web.documents import Sentences, in_both_systems
from sweetspot.web.drawings import BatPicture, bat_picture
from sweetspot.web.errors import FieldError
from sweetspot.web.recipes import Ask, bat_source, bat_text, setup_lines, swing_options
from sweetspot.web.view import View

PLACES = 101
HIGHEST = 10e3
"""Hz; above it a beam or a thin shell says little, and nothing is heard or felt."""
TAP_FIELDS = ("tap_from_tip_in", "tap_ms")
STILL = 1e-3
"""Part of the greatest shape below which a stretch of a hoop mode counts as still all along."""

LEAST_TONE = 1e-4
"""Part of the vibration's energy below which a tone is not heard beside the others: -40 dB."""


class ModesState(SwungState, HeldState):
    """The bat, who holds it, which motion is shown, and where it is tapped."""

    family: Literal["rigid", "bending", "hoop", "hand"] = Field("bending", description="kind of motion that is shown")
    number: int = Field(1, ge=1, le=40, description="which of that kind, from the lowest")
    tap_from_tip_in: Place = Field(2.0, description="where the bat is tapped")
    tap_ms: float = Field(1.0, ge=0.02, le=5, description="how long the tap lasts; a ball: 1, a knuckle: 2, steel: 0.1")
    exaggeration: float = Field(1.0, ge=0.2, le=3, description="size of the drawn motion against the usual one")


@dataclass(frozen=True)
class Tapped:
    """The tap's share in a motion: part of the vibration's energy, None of rigid motions, and speed at the hand."""

    energy_share: Ratio | None
    hand_speed_m_s_per_n_s: float


@dataclass(frozen=True, kw_only=True)
class BatMotion:
    """One motion of the bat.

    Parameters
    ----------
    number : among its family, from the lowest.
    axial : of a hoop mode: half waves along the barrel.
    decay : time in which it dies away to 1 / e.
    shape : one high, and positive at the tip.
    """

    family: str
    name: str
    number: int
    harmonic: int
    axial: int | None
    frequency: Frequency
    damping_ratio: Ratio | None
    decay: Time | None
    nodes: Annotated[tuple[float, ...], LENGTH]
    shape: Array
    tap: Tapped


@dataclass(frozen=True)
class BarrelNodes:
    """Nodes of the first two bending modes nearest to the tip."""

    node_1: Length
    node_2: Length


@dataclass(frozen=True)
class BatTap:
    """The place of the tap, from the knob end, and its duration."""

    position: Length
    duration: Time


@dataclass(frozen=True, kw_only=True)
class ModesAnswer:
    """Every motion of the bat, lowest first, and what the tap leaves in it.

    Parameters
    ----------
    place : from the knob end, of the shapes.
    hoop_start : where a hollow barrel begins to ring; None: it is solid.
    chosen, words : which of the motions is asked about, and what it is.
    """

    bat: BatPicture
    hands: Annotated[tuple[float, ...], LENGTH]
    nodes: BarrelNodes
    place: Annotated[Array, LENGTH]
    hoop_start: Length | None
    tap: BatTap
    modes: tuple[BatMotion, ...]
    chosen: int
    words: Sentences


UNTAPPED = Tapped(None, 0.0)


def answer(state: ModesState) -> ModesAnswer:
    """Return every motion of the bat and what the tap leaves in it."""
    still = {name: ModesState.model_fields[name].default for name in ("family", "number", "exaggeration", *TAP_FIELDS)}
    held = _held(state.model_copy(update=still))
    length = float(held.bat.length)
    place, duration = length - state.tap_from_tip_in * INCH, state.tap_ms * 1e-3
    if place < 0:
        raise FieldError("tap_from_tip_in", f"the bat is {length / INCH:.4g} in long; tap it no further from its tip")
    taps = _taps(held, place, duration)
    motions = tuple(replace(motion, tap=tap) for motion, tap in zip(held.motions, taps, strict=True))
    index = _shown(motions, state)
    chosen = motions[index]
    words = motion_words(
        chosen.name,
        chosen.family,
        frequency=float(chosen.frequency),
        waves=(chosen.harmonic, chosen.axial),
        nodes=[length - node for node in reversed(chosen.nodes)],
        tap=(length - place, None if chosen.tap.energy_share is None else float(chosen.tap.energy_share)),
    )
    return ModesAnswer(
        bat=held.bat,
        hands=held.hands,
        nodes=BarrelNodes(*held.nodes),
        place=held.place,
        hoop_start=held.hoop_start,
        tap=BatTap(place, duration),
        modes=motions,
        chosen=index,
        words=in_both_systems(words),
    )


@dataclass(frozen=True)
class ToneOfHit:
    """A tone of a struck bat, and its part of the vibration's energy."""

    frequency: Frequency
    decay: Time
    energy_share: Ratio


def tones(state: SwungState, place: float, duration: float) -> tuple[ToneOfHit, ...]:
    """Return the tones that a hit at a place leaves in a bat hung freely, m from the knob end and s."""
    held = _held(ModesState(**{name: getattr(state, name) for name in BatState.model_fields}))
    taps = _taps(held, place, duration)
    return tuple(
        ToneOfHit(motion.frequency, motion.decay, tap.energy_share)
        for motion, tap in zip(held.motions, taps, strict=True)
        if motion.decay is not None and tap.energy_share is not None and float(tap.energy_share) > LEAST_TONE
    )


def _shown(motions: tuple[BatMotion, ...], state: ModesState) -> int:
    """Return the index of the chosen motion, or of the one like it on another bat."""
    alike = [index for index, motion in enumerate(motions) if motion.family == state.family]
    if alike:
        return alike[min(state.number, len(alike)) - 1]
    return next(index for index, motion in enumerate(motions) if motion.family == "bending")


class _BatMotions(NamedTuple):
    """The part of an answer that does not depend on the tap; the motions have no tap yet."""

    modes: Modes
    listed: list[int]
    bat: BatPicture
    hands: tuple[float, ...]
    hand: float
    nodes: tuple[float, float]
    place: Array
    hoop_start: float | None
    motions: list[BatMotion]


@lru_cache(maxsize=64)
def _held(state: ModesState) -> _BatMotions:
    model = reduced(state, ball_of(state))
    conditions = conditions_of(state, model.bat)
    check_conditions(model, conditions)
    bat, hands, modes = model.bat, conditions.hands, model.modes
    if state.held:
        modes = held_modes(modes, Hands(position=hands.position, spacing=hands.spacing, **TYPICAL_HAND))
    places = np.linspace(0, bat.length, PLACES)
    order = np.argsort(modes.frequency, kind="stable")
    listed = [int(index) for index in order if modes.frequency[index] < HIGHEST]
    return _BatMotions(
        modes,
        listed,
        bat_picture(state, model),
        hands.places,
        hands.position,
        (barrel_node(model.modes, harmonic=1), barrel_node(model.modes, harmonic=2)),
        np.round(places, 5),
        barrel_range(model.beam)[0] if bat.shell is not None else None,
        _motions(modes, listed, places),
    )


def _motions(modes: Modes, listed: list[int], places: Array) -> list[BatMotion]:
    shapes = modes.shape_at(places)
    damping = modes.damping_rate + np.sum(modes.dashpots**2, axis=0)
    nodes = _nodes(modes, listed, float(places[-1]))
    counts: Counter[str] = Counter()
    motions = []
    for index in listed:
        family, harmonic = modes.families[index], modes.harmonics[index]
        counts.update([family, f"{family} {harmonic}"])
        omega = 0.0 if family == "rigid" else float(modes.angular_frequency[index])
        axial = counts[f"{family} {harmonic}"] if family == "hoop" else None
        names = {"hoop": f"Hoop {harmonic}.{axial}", "rigid": "Turn" if nodes[index] else "Push"}
        motions.append(
            BatMotion(
                family=family,
                name=names.get(family, f"{'Hands' if family == 'hand' else 'Bending'} {counts[family]}"),
                number=counts[family],
                harmonic=harmonic,
                axial=axial,
                frequency=omega / (2 * np.pi),
                damping_ratio=float(damping[index]) / (2 * omega) if omega > 0 else None,
                decay=2 / float(damping[index]) if damping[index] * omega > 0 else None,
                nodes=tuple(nodes[index]),
                shape=np.round(shapes[:, index] / _signed_largest(shapes[:, index]), 4) + 0.0,
                tap=UNTAPPED,
            )
        )
    return motions


def _taps(held: _BatMotions, place: float, duration: float) -> list[Tapped]:
    modes, listed = held.modes, held.listed
    speeds, at_hand = tapped(modes, position=place, duration=duration), modes.shape_at(held.hand)
    rings = [index for index in listed if modes.families[index] != "rigid"]
    total = float(np.sum(speeds[rings] ** 2))
    return [
        Tapped(
            float(speeds[index] ** 2 / total) if index in rings and total > 0 else None,
            float(abs(speeds[index] * at_hand[index])),
        )
        for index in listed
    ]


def _nodes(modes: Modes, listed: list[int], length: float) -> dict[int, list[float]]:
    """Return the nodes of motions; a hoop mode's ends, where the barrel is held round, are not its nodes."""
    hoops = [index for index in listed if modes.families[index] == "hoop"]
    still = {index: [float(node) for node in modes.nodes(index)] for index in listed if index not in hoops}
    if hoops:
        places = np.linspace(0, length, 2001)
        for index, shape in zip(hoops, modes.shape_at(places)[:, hoops].T, strict=True):
            moving = np.abs(shape) > STILL * np.abs(shape).max()
            still[index] = _crossings(places[moving], shape[moving])
    return still


def _crossings(places: Array, values: Array) -> list[float]:
    """Return the places along a line at which values change their sign, straight between samples."""
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
    python = setup_lines(state, held=state.held) + (
        "from sweetspot.dynamics.modes import tapped\n\n"
        "modes.frequency, modes.damping_ratio, modes.nodes(2)  # Hz, ratios, m from the knob end\n"
        f"tapped(modes, position=bat.length - {state.tap_from_tip_in!r} * INCH, duration={state.tap_ms!r} * 1e-3)\n"
    )
    command = Ask("report", (bat_source(state),), swing_options(state) | {"format": "json"}).command
    return {"python": python, "toml": bat_text(state)} | ({} if state.held else {"command": command})


VIEW = View("modes", "Modes", ModesState, answer, recipe)

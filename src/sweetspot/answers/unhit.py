"""An implement that the ball outweighs: its properties without a hit."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated

from sweetspot.analysis.bat_analysis import check_swing
from sweetspot.analysis.sweet_spot import barrel_node
from sweetspot.answers.answer import Answer
from sweetspot.answers.description import Description, described
from sweetspot.answers.records import INTERNAL, Length
from sweetspot.answers.report import VibrationMode, vibration_modes
from sweetspot.dynamics.reduction import ReducedBat
from sweetspot.dynamics.rigid import centre_of_percussion
from sweetspot.equipment.implement import Implement
from sweetspot.motion.swing import Conditions


@dataclass(frozen=True, kw_only=True)
class QuietPlaces:
    """Places that need no ball, from the knob end; None: a short implement has none."""

    node_1: Length | None = None
    node_2: Length | None = None
    center_of_percussion: Length | None = None


@dataclass(frozen=True, kw_only=True)
class UnhitAnswer(Description, Answer):
    """Weight, balance, tones and nodes of an implement that is no heavier than the ball."""

    modes: tuple[VibrationMode, ...]
    sweet_spots: QuietPlaces
    outcome: str = "the ball is no lighter than what would hit it"
    reduced: Annotated[ReducedBat[Implement], INTERNAL]
    conditions: Annotated[Conditions, INTERNAL]


def unhit_answer(reduced: ReducedBat[Implement], conditions: Conditions) -> UnhitAnswer:
    """Return the properties of an implement without a hit."""
    implement = reduced.bat
    check_swing(implement, conditions)
    places = {
        "node_1": barrel_node(reduced.modes, harmonic=1),
        "node_2": barrel_node(reduced.modes, harmonic=2),
        "center_of_percussion": centre_of_percussion(reduced.body, pivot=conditions.hands.position),
    }
    return UnhitAnswer(
        **vars(described(reduced.beam, reduced.body)),
        modes=vibration_modes(reduced.modes),
        sweet_spots=QuietPlaces(**{name: place for name, place in places.items() if place <= implement.length}),
        reduced=reduced,
        conditions=conditions,
    )

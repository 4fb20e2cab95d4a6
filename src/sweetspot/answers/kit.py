"""A measuring day: what is asked of every bat, what it should read near, and the empty table that `rank` reads back."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Annotated

from sweetspot.answers.answer import Answer
from sweetspot.answers.records import INTERNAL, OF_RECORD
from sweetspot.calibration.bat_table import MOISTURES, TIMED, USUAL_MOISTURE, expected_values
from sweetspot.calibration.measured import FLOORS
from sweetspot.calibration.unknowns import unknowns_of
from sweetspot.catalog.files.write import implement_toml, legible
from sweetspot.dynamics.beam import beam_model
from sweetspot.dynamics.hoop import hoop_frequency
from sweetspot.equipment.bat import Bat
from sweetspot.equipment.implement import Implement
from sweetspot.equipment.paddle import Paddle
from sweetspot.errors import InputError
from sweetspot.plausibility.implements import SAME_MODEL
from sweetspot.units.dimensions import FREQUENCY, LENGTH, MASS, RATIO, TIME, Dimension

OF_BODY = ("mass", "balance_point", "twenty_swings")
MOST_PIECES = 40
"""Rows of a sheet: their names fill a code that a telephone still reads."""
DIMENSIONS: Mapping[str, Dimension] = {
    "mass": MASS,
    "balance_point": LENGTH,
    "twenty_swings": TIME,
    "bending_1": FREQUENCY,
    "bending_2": FREQUENCY,
    "hoop": FREQUENCY,
    "moisture": RATIO,
}
"""Of what a sheet may ask; each is a column of `sweetspot.calibration.bat_table`."""
FACTORS: Mapping[str, float] = {"twenty_swings": SAME_MODEL["period"]} | {
    name: SAME_MODEL.get(name, SAME_MODEL["frequency"]) for name in DIMENSIONS if name != "twenty_swings"
}
"""Times what is expected, above which or by which below what is written is a slip."""


@dataclass(frozen=True)
class KitQuestion:
    """A model of which pieces are to be measured.

    ``pieces``: how many, 1 to `MOST_PIECES`.
    """

    model: Implement
    pieces: int = 12


@dataclass(frozen=True)
class SheetField:
    """What is asked of every piece: a column of the table that `rank` and `calibrate` read.

    Parameters
    ----------
    quantity : as that table calls it.
    expected : of the model as described.
    low, high : beyond these a unit or a column was mistaken.
    instrument : one sigma of what is written without a ±, at least.
    """

    quantity: str
    expected: Annotated[float, OF_RECORD]
    low: Annotated[float, OF_RECORD]
    high: Annotated[float, OF_RECORD]
    instrument: Annotated[float, OF_RECORD]

    @property
    def dimension(self) -> Dimension:
        """Of its numbers."""
        return DIMENSIONS[self.quantity]


@dataclass(frozen=True, kw_only=True)
class KitAnswer(Answer):
    """The sheet of a measuring day.

    Parameters
    ----------
    pieces : their names until somebody writes others.
    fields : what is asked of each.
    axis : of the pendulum, from the butt end.
    """

    question: Annotated[KitQuestion, INTERNAL]
    pieces: tuple[str, ...]
    fields: tuple[SheetField, ...]
    axis: Annotated[float, LENGTH]

    def to_toml(self) -> str:
        """Return the file of the model as described."""
        return legible(implement_toml(self.question.model))


def kit_answer(question: KitQuestion) -> KitAnswer:
    """Return the readings to take of every piece of a model.

    Raises
    ------
    InputError
        for too many pieces, or a kind that cannot be calibrated.
    """
    model, count = question.model, question.pieces
    if not 1 <= count <= MOST_PIECES:
        raise InputError(f"pieces were given as {count}; allowed is 1 to {MOST_PIECES}")
    unknowns_of(model)  # refuses what cannot be calibrated
    axis = model.swing_axis
    expected = expected_values(model, axis=axis) | _of_make(model)
    return KitAnswer(
        question=question,
        pieces=tuple(f"No {number}" for number in range(1, count + 1)),
        fields=tuple(_field(name, expected[name]) for name in _asked(model) if name in expected),
        axis=axis,
    )


def _asked(model: Implement) -> tuple[str, ...]:
    """Return the quantities that are worth measuring, in the order of work."""
    if isinstance(model, Paddle):
        return OF_BODY  # its face rings, of which a table has no column
    if not isinstance(model, Bat):
        return (*OF_BODY, "bending_1")  # the rest of a racket's or club's stiffness is scaled to its first tone
    return (*OF_BODY, "bending_1", "bending_2", "hoop", "moisture")


def _of_make(model: Implement) -> dict[str, float]:
    """Return the readings expected of a hollow bat's barrel, or of a wooden bat's moisture."""
    if not isinstance(model, Bat):
        return {}
    if model.shell is not None:
        return {"hoop": hoop_frequency(beam_model(model))}
    return {"moisture": USUAL_MOISTURE} if model.material.family == "wood" else {}


def _field(name: str, expected: float) -> SheetField:
    factor = FACTORS[name]
    low, high = MOISTURES if name == "moisture" else (expected / factor, expected * factor)
    floors = {**FLOORS, "twenty_swings": TIMED * FLOORS["pendulum"], "moisture": 0.01}
    return SheetField(name, expected, low, high, floors.get(name, FLOORS["tone"]))

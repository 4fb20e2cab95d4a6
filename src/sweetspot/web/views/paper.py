"""The paper: its questions one after the other, its formulas with other numbers, and what the full model says."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Literal

from pydantic import Field

from sweetspot import catalog
from sweetspot.answers.conditions import HitConditions, hit_conditions
from sweetspot.catalog.records import read_table
from sweetspot.dynamics.block import Support
from sweetspot.papers.chain import PARTS
from sweetspot.papers.choices import RATIOS, Choices
from sweetspot.papers.formulas import PaperRow
from sweetspot.reports.paper.page_words import paper_words
from sweetspot.reports.paper.statements import PAPER_READERS, StatedRow, stated, statement
from sweetspot.reports.quantities import System
from sweetspot.reports.sentences import Part, Sentence, Slot, say
from sweetspot.units import INCH
from sweetspot.web.bats import analysed
from sweetspot.web.controls import HoleDepth, HoleDiameter, Name, SwungState
from sweetspot.web.documents import Sentences, in_both_systems, in_either_system
from sweetspot.web.drawings import BallPicture, BatPicture, ball_picture, bat_picture
from sweetspot.web.errors import about
from sweetspot.web.recipes import Ask, bat_source, bat_text, lines_of, options_of, swing_options
from sweetspot.web.view import View
from sweetspot.web.views.paper_pictures import PICTURES, DropPicture, PaperPictures, SpeedsPicture

Question = Literal["end", "percussion", "corking", "drop", "energy", "verdict"]


class PaperState(SwungState):
    """The question, what the paper leaves open, and the bat and swing of the full model."""

    question: Question = Field("end", description="which of the paper's questions")
    entry_angle_deg: float = Field(10.0, ge=0, le=60, description="between the ball's path and the bat's normal")
    rod_hands_in: float = Field(6.0, ge=0, le=12, description="where the paper's rod is held, from its end")
    hands_moved_in: float = Field(2.0, ge=0, le=6, description="how far the hands are moved up")
    hole_diameter_in: HoleDiameter = 1.0
    hole_depth_in: HoleDepth = 10.0
    hole_fill: Name = Field("cork", description="material of the catalogue that fills the hole")
    drop_height_m: float = Field(1.0, ge=0.1, le=5)
    block_thickness_m: float = Field(0.1, ge=0.001, le=0.3)
    block_support: Support = Field("floor", description="how the blocks are held")
    ball_restitution: float = Field(0.45, ge=0, le=1, description="k0")
    wood_restitution: float = Field(0.45, ge=0, le=1, description="k1")
    metal_restitution: float = Field(0.9, ge=0, le=1, description="k2")
    wood_share: float = Field(0.02, ge=0, le=1, description="z1")
    metal_share: float = Field(0.1, ge=0, le=1, description="z2")


@dataclass(frozen=True)
class StatementWords:
    """Statement and comment of a row as readers of one system see them."""

    quantity: str
    comment: str


@dataclass(frozen=True)
class Statement(StatedRow):
    """One statement of the paper, with its words for readers of either system."""

    words: Mapping[System, StatementWords]


@dataclass(frozen=True)
class Asked:
    """A question of the paper: its claims, its formulas as they should read, and its misprints.

    Parameters
    ----------
    formulas : each as "number in the paper: formula; what it is of".
    """

    question: str
    claim: tuple[str, ...]
    formulas: tuple[str, ...]
    misprints: tuple[str, ...]


@dataclass(frozen=True, kw_only=True)
class PaperPicture:
    """The paper's statements on one question with its formula's number and the full model's, and a picture.

    Parameters
    ----------
    truth, live : what the full model says, and the formulas with the numbers of now.
    label : what the picture shows.
    """

    question: Question
    asked: Asked
    rows: tuple[Statement, ...]
    picture: PaperPictures
    truth: Sentences
    live: Sentences
    label: Mapping[System, str]
    ball: BallPicture
    bat: BatPicture
    conditions: HitConditions


def answer(state: PaperState) -> PaperPicture:
    """Return the paper's statements on one question with its formula's number and the full model's, and a picture."""
    analysis = analysed(state)
    choices = choices_of(state)
    control = {"corking": "hole_diameter_in", "drop": "block_thickness_m", "percussion": "rod_hands_in"}
    with about(control.get(state.question, "")):
        rows = list(PARTS[state.question](analysis, choices))
        picture = PICTURES[state.question](analysis, choices, rows)
        truth, live = paper_words(state.question, analysis, choices, rows)
    entry = read_table("paper.toml")[state.question]
    return PaperPicture(
        question=state.question,
        asked=Asked(entry.text("question"), entry.texts("claim"), entry.texts("formulas"), entry.texts("misprints")),
        rows=tuple(Statement(**vars(stated(row)), words=_words(row)) for row in rows),
        picture=picture,
        truth=in_both_systems(truth),
        live=in_both_systems(live),
        label=in_either_system(say(entry.text("picture"), **_numbers_of(picture))),
        ball=ball_picture(state, analysis.conditions.ball),
        bat=bat_picture(state, analysis.reduced),
        conditions=hit_conditions(analysis.conditions),
    )


def _numbers_of(picture: PaperPictures) -> dict[str, Part | Sentence]:
    """Return the numbers in the description of a picture."""
    if isinstance(picture, SpeedsPicture) and picture.elastic_travel is not None:
        return {"travel": Slot(picture.elastic_travel, "length")}
    if not isinstance(picture, DropPicture):
        return {}
    backs = {"wood": picture.wood.rebound, "metal": picture.metal.rebound}
    words = {
        name: "does not come back cleanly" if back is None else say("comes back to {back}", back=Slot(back, "place"))
        for name, back in backs.items()
    }
    return {"height": Slot(picture.drop_height, "place"), **words}


def _words(row: PaperRow) -> dict[System, StatementWords]:
    quantity, comment = statement(row)
    return {
        system: StatementWords(*(text.read(reader).replace(" - ", " \N{MINUS SIGN} ") for text in (quantity, comment)))
        for system, reader in PAPER_READERS.items()
    }


def choices_of(state: PaperState) -> Choices:
    """Return the paper's open parameters, as the controls say."""
    with about("hole_fill"):
        fill = catalog.material(state.hole_fill)
    return Choices(
        entry_angle=math.radians(state.entry_angle_deg),
        rod_hands=state.rod_hands_in * INCH,
        hands_moved=state.hands_moved_in * INCH,
        bore_diameter=state.hole_diameter_in * INCH,
        bore_depth=state.hole_depth_in * INCH,
        fill=fill,
        drop_height=state.drop_height_m,
        block_thickness=state.block_thickness_m,
        block_support=state.block_support,
        ball_restitution=state.ball_restitution,
        wood_restitution=state.wood_restitution,
        metal_restitution=state.metal_restitution,
        wood_share=state.wood_share,
        metal_share=state.metal_share,
    )


def recipe(state: PaperState) -> dict[str, str]:
    """Return command line, Python line and the bat's file that give the same numbers."""
    options = options_of(state, "entry_angle_deg", "rod_hands_in", "hands_moved_in", *RATIOS)
    hole = options_of(state, bore_diameter="hole_diameter_in", bore_depth="hole_depth_in", fill="hole_fill")
    block = options_of(state, "drop_height_m", "block_thickness_m", "block_support")
    options |= hole | block
    return {**lines_of(Ask("paper", (bat_source(state),), options | swing_options(state))), "toml": bat_text(state)}


SLOW = (PaperState(question="energy"), PaperState(question="drop", block_support="clamped"))
VIEW = View("paper", "The paper", PaperState, answer, recipe, slow=SLOW)

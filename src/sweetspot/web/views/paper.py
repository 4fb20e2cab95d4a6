"""The paper: its questions one after the other, its formulas with other numbers, and what the full model says."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import asdict
from functools import lru_cache
from shlex import quote
from typing import Any, Literal

import numpy as np
from pydantic import Field

from sweetspot import catalog
from sweetspot.analysis.bat_analysis import Analysis
from sweetspot.analysis.drop_test import bounce
from sweetspot.answers.conditions import hit_conditions
from sweetspot.answers.records import to_dict
from sweetspot.dynamics.block import Block, Support
from sweetspot.dynamics.rigid import centre_of_percussion, hand_impulse_ratio
from sweetspot.equipment.ball import Ball
from sweetspot.paper import formulas as paper
from sweetspot.paper.chain import PARTS
from sweetspot.paper.choices import RATIOS, Choices, can_be_drilled, corked_analysis
from sweetspot.paper.formulas import Row
from sweetspot.paper.metal_wall import metal_wall_point
from sweetspot.paper.words import Number, Words
from sweetspot.report.json_shapes import cleaned
from sweetspot.report.quantities import SYSTEMS, Reader
from sweetspot.report.sentences import Slot
from sweetspot.units import INCH
from sweetspot.web.bats import analysed
from sweetspot.web.drawings import ball_picture, bat_picture, outline
from sweetspot.web.errors import FieldError, about
from sweetspot.web.recipes import bat_name, bat_text, conditions_lines, swing_options
from sweetspot.web.states import Name, SwungState
from sweetspot.web.view import View

Question = Literal["end", "percussion", "corking", "drop", "energy", "verdict"]
PLACES = 121
MATERIALS = {"wood": "white-ash", "metal": "aluminium-7xxx"}
THICKNESSES = (0.002, 0.003, 0.005, 0.008, 0.015, 0.03, 0.1)
"""m, of the blocks in the picture of the drop experiment."""
WALLS = (1.2, 1.0, 0.95, 0.9, 0.85, 0.7)
"""Factors on the wall of the catalogue's aluminium bat in the picture of the energy."""


class PaperState(SwungState):
    """The question, what the paper leaves open, and the bat and swing of the full model."""

    question: Question = Field("end", description="which of the paper's questions")
    entry_angle_deg: float = Field(10.0, ge=0, le=60, description="between the ball's path and the bat's normal")
    rod_hands_in: float = Field(6.0, ge=0, le=12, description="where the paper's rod is held, from its end")
    hands_moved_in: float = Field(2.0, ge=0, le=6, description="how far the hands are moved up")
    hole_diameter_in: float = Field(1.0, ge=0.25, le=2)
    hole_depth_in: float = Field(10.0, ge=1, le=20)
    hole_fill: Name = Field("cork", description="material of the catalogue that fills the hole")
    drop_height_m: float = Field(1.0, ge=0.1, le=5)
    block_thickness_m: float = Field(0.1, ge=0.001, le=0.3)
    block_support: Support = Field("floor", description="how the blocks are held")
    ball_restitution: float = Field(0.45, ge=0, le=1, description="k0")
    wood_restitution: float = Field(0.45, ge=0, le=1, description="k1")
    metal_restitution: float = Field(0.9, ge=0, le=1, description="k2")
    wood_share: float = Field(0.02, ge=0, le=1, description="z1")
    metal_share: float = Field(0.1, ge=0, le=1, description="z2")


def answer(state: PaperState) -> dict[str, Any]:
    """Return the paper's statements on one question with its formula's number and the full model's, and a picture."""
    analysis = analysed(state)
    choices = choices_of(state)
    control = {"corking": "hole_diameter_in", "drop": "block_thickness_m", "percussion": "rod_hands_in"}
    with about(control.get(state.question, "")):
        rows = list(PARTS[state.question](analysis, choices))
        picture = PICTURES[state.question](analysis, choices, rows)
    return {
        "question": state.question,
        "rows": [asdict(row) | {"words": _words(row)} for row in rows],
        "picture": cleaned(picture),
        "ball": ball_picture(state, analysis.conditions.ball),
        "bat": bat_picture(state, analysis.reduced),
        "conditions": to_dict(hit_conditions(analysis.conditions)),
    }


def _words(row: Row) -> dict[str, dict[str, str]]:
    """Return statement and comment of a row as readers of either system see them."""
    texts = {"quantity": row.quantity, "comment": row.comment}
    return {system: {name: _read(text, reader) for name, text in texts.items()} for system, reader in SYSTEMS.items()}


def _read(text: str, reader: Reader) -> str:
    told = text.template.format(*(_told(one, reader) for one in text.numbers)) if isinstance(text, Words) else text
    return told.replace(" - ", " \N{MINUS SIGN} ")


def _told(number: Number, reader: Reader) -> str:
    """Return a number as the chain has it where that is the reader's unit, else in the reader's own."""
    slot = Slot(number.value, number.scale, digits=number.digits, round=True)
    return number.text if number.text.endswith(reader.behind(number.scale)) else slot.read(reader)


def choices_of(state: PaperState) -> Choices:
    """Return what the paper leaves open, as the controls say."""
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


def _along(analysis: Analysis) -> dict[str, Any]:
    along = analysis.scan
    return {
        "position_m": along.position,
        "exit_speed_m_s": along.exit_speed,
        "rigid_exit_speed_m_s": along.rigid_exit_speed,
        "best_m": analysis.sweet_spots.max_exit_speed,
        "zone_m": analysis.sweet_spots.zone,
        "percussion_m": analysis.sweet_spots.center_of_percussion,
    }


def _end(analysis: Analysis, _choices: Choices, rows: list[Row]) -> dict[str, Any]:
    """Return exit speeds along the bat, and the stretch S from the tip that the paper's limits leave."""
    elastic = [row for row in rows if row.equation == "S"][-1]
    assert isinstance(elastic.computed, float) and isinstance(elastic.full_model, float)
    return {**_along(analysis), "elastic_travel_m": elastic.computed / 1e3, "travel_m": elastic.full_model / 1e3}


def _percussion(analysis: Analysis, choices: Choices, _rows: list[Row]) -> dict[str, Any]:
    """Return equation 9 along the paper's rod and the bat, each held where its control says."""
    bat, body = analysis.bat, analysis.body
    rod = paper.rod(bat.length, body.mass)
    hands = analysis.conditions.hands.position
    places = np.linspace(0, bat.length, PLACES)
    moved = min(hands + choices.hands_moved, bat.length / 2)
    return {
        "position_m": places,
        "rod_ratio": [paper.hand_force_ratio(rod, place, hands=choices.rod_hands) for place in places],
        "bat_ratio": [hand_impulse_ratio(body, place, hands=hands) for place in places],
        "moved_ratio": [hand_impulse_ratio(body, place, hands=moved) for place in places],
        "rod_percussion_m": centre_of_percussion(rod, pivot=choices.rod_hands),
        "bat_percussion_m": centre_of_percussion(body, pivot=hands),
        "moved_percussion_m": centre_of_percussion(body, pivot=moved),
        "rod_hands_m": choices.rod_hands,
        "hands_m": hands,
        "best_m": analysis.sweet_spots.max_exit_speed,
    }


def _corking(analysis: Analysis, choices: Choices, _rows: list[Row]) -> dict[str, Any]:
    """Return the force of both hits over time, and the exit speeds along both bats at the same bat speed."""
    if not can_be_drilled(analysis.bat):
        raise FieldError(
            "bat", f"{analysis.bat.name} is hollow, drilled already or without an outline; choose a solid wood bat"
        )
    other = corked_analysis(analysis.bat, choices, analysis.conditions)
    return {
        "time_s": analysis.best.times,
        "force_n": analysis.best.force,
        "corked_time_s": other.best.times,
        "corked_force_n": other.best.force,
        "position_m": analysis.scan.position,
        "exit_speed_m_s": analysis.scan.exit_speed,
        "corked_position_m": other.scan.position,
        "corked_exit_speed_m_s": other.scan.exit_speed,
        "corked_bat": outline(other.bat),
    }


def _drop(analysis: Analysis, choices: Choices, rows: list[Row]) -> dict[str, Any]:
    """Return rebound heights of both blocks, and rebound over fall of blocks of every thickness held so."""
    ball, height = analysis.conditions.ball, choices.drop_height
    data: dict[str, Any] = {
        "drop_height_m": height,
        "thickness_m": THICKNESSES,
        "block_thickness_m": choices.block_thickness,
    }
    for (name, key), row in zip(MATERIALS.items(), rows, strict=True):
        data[name] = {
            "rebound_m": row.full_model,
            "limit_rebound_m": row.computed,
            "rebound_ratios": _rebounds(key, choices.block_support, ball),
        }
    return data


@lru_cache(maxsize=64)
def _rebounds(material: str, support: Support, ball: Ball) -> list[float]:
    """Return the rebound over the fall, from 1 m, for blocks of every thickness."""
    blocks = (
        Block(material=catalog.material(material), thickness=thickness, support=support) for thickness in THICKNESSES
    )
    return [bounce(block, ball=ball, height=1.0)[0] for block in blocks]


def _energy(_analysis: Analysis, choices: Choices, _rows: list[Row]) -> dict[str, Any]:
    """Return W over z for wood and metal, and what aluminium bats with other walls give in the full model."""
    shares = np.linspace(0, 0.3, 61)

    def returned(restitution: float) -> list[float]:
        ball = choices.ball_restitution
        return [
            paper.energy_returned(bat_restitution=restitution, ball_restitution=ball, share=float(share))
            for share in shares
        ]

    walls = [metal_wall_point(factor) for factor in WALLS]
    return {
        "share": shares,
        "wood_returned": returned(choices.wood_restitution),
        "metal_returned": returned(choices.metal_restitution),
        "wood": {"share": choices.wood_share, "restitution": choices.wood_restitution},
        "metal": {"share": choices.metal_share, "restitution": choices.metal_restitution},
        "walls": {
            "thickness_m": [wall.thickness for wall in walls],
            "share": [wall.energy.share for wall in walls],
            "returned": [wall.bbcor**2 for wall in walls],
            "restitution": [wall.energy.restitution for wall in walls],
            "exit_speed_m_s": [wall.exit_speed for wall in walls],
        },
    }


def _verdict(analysis: Analysis, _choices: Choices, _rows: list[Row]) -> dict[str, Any]:
    """Return exit speeds along the bat with every place that is called sweet."""
    spots = asdict(analysis.sweet_spots)
    return {**_along(analysis), "sweet_spots": {f"{name}_m": place for name, place in spots.items() if name != "zone"}}


PICTURES: dict[str, Callable[[Analysis, Choices, list[Row]], dict[str, Any]]] = {
    "end": _end,
    "percussion": _percussion,
    "corking": _corking,
    "drop": _drop,
    "energy": _energy,
    "verdict": _verdict,
}


def recipe(state: PaperState) -> dict[str, str]:
    """Return command line, Python lines and the bat's file that give the same numbers."""
    texts = {
        "entry_angle": f"{state.entry_angle_deg:.12g}deg",
        "rod_hands": f"{state.rod_hands_in:.12g}in",
        "hands_moved": f"{state.hands_moved_in:.12g}in",
        "bore_diameter": f"{state.hole_diameter_in:.12g}in",
        "bore_depth": f"{state.hole_depth_in:.12g}in",
        "fill": quote(state.hole_fill),
        "drop_height": f"{state.drop_height_m:.12g}m",
        "block_thickness": f"{state.block_thickness_m:.12g}m",
        "block_support": state.block_support,
        **{name: f"{getattr(state, name):.12g}" for name in RATIOS},
    }
    options = "".join(f" --{name.replace('_', '-')} {text}" for name, text in texts.items())
    python = conditions_lines(state) + (
        "\nfrom math import radians\nfrom sweetspot.paper.chain import PARTS\n"
        "from sweetspot.paper.choices import Choices\n\n"
        "choices = Choices(\n"
        f"    entry_angle=radians({state.entry_angle_deg!r}), rod_hands={state.rod_hands_in!r} * INCH,\n"
        f"    hands_moved={state.hands_moved_in!r} * INCH, bore_diameter={state.hole_diameter_in!r} * INCH,\n"
        f"    bore_depth={state.hole_depth_in!r} * INCH, fill=catalog.material({state.hole_fill!r}),\n"
        f"    drop_height={state.drop_height_m!r}, block_thickness={state.block_thickness_m!r},\n"
        f'    block_support="{state.block_support}",\n'
        f"    {', '.join(f'{name}={getattr(state, name)!r}' for name in RATIOS)},\n"
        ")\n"
        f'for row in PARTS["{state.question}"](analyse(bat, conditions), choices):\n'
        "    print(row.equation, row.quantity, row.paper, row.computed, row.full_model)\n"
    )
    return {
        "command": f"sweetspot paper {bat_name(state)}{options}{swing_options(state)}",
        "python": python,
        "toml": bat_text(state),
    }


VIEW = View(
    "paper", "The paper", PaperState, answer, recipe,
    slow=(PaperState(question="energy"), PaperState(question="drop", block_support="clamped")),
)  # fmt: skip

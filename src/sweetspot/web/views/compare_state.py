"""The controls of the view Compare, and the bats that they describe."""

from __future__ import annotations

from functools import lru_cache
from typing import Annotated, Literal

from pydantic import Field

from sweetspot.analysis.certification.rules import League
from sweetspot.answers.changes import FILLS, changed
from sweetspot.catalog.rules import league, league_names
from sweetspot.dynamics.reduction import ReducedBat, reduced_bat
from sweetspot.equipment.ball import Ball
from sweetspot.equipment.bat import Bat
from sweetspot.web.bats import reduced
from sweetspot.web.controls import BatState, HoleDepth, HoleDiameter, Name, SwungState, WallFactor, part_of
from sweetspot.web.errors import FieldError, about
from sweetspot.web.recipes import number

ALL, USUAL_HOLE = "all", " 10in x 1in"


class CompareState(SwungState):
    """The bat, its swing, the others beside it, and what is asked of them."""

    others: Annotated[tuple[BatState, ...], Field(max_length=3)] = Field(
        (BatState(bat="corked-r161"), BatState(bat="russell-b6")),
        description="bats 2 to 4; bat 1 is the reference, and the swing is known with it",
    )
    swing_law: Name | None = Field(
        None, description="how bat speed depends on the bat; empty: as in the first bat's sport"
    )
    what_if: Literal["none", "cork", "wall", "change"] = Field(
        "none", description="of the first bat alone: other bats made of it"
    )
    hole_diameter_in: HoleDiameter = Field(1.0, description="hole of what_if cork")
    hole_depth_in: HoleDepth = 10.0
    wall_times: WallFactor = Field(0.85, description="wall of what_if wall, times the bat's own")
    change: Annotated[str, Field(min_length=1, max_length=120)] = Field(
        "knob-weight 2oz", description="of what_if change: as the option --what-if has it, several after commas"
    )
    league: Name | None = Field(
        None, description="whose rules the bats are held against, or 'all'; empty: those of the first bat's sport"
    )


def bats_of(state: CompareState, ball: Ball) -> tuple[list[ReducedBat], list[str]]:
    """Return the bats with their labels; those of a what-if are made of the first."""
    first = reduced(state, ball)
    if state.what_if == "wall":
        if first.bat.shell is None:
            raise FieldError("what_if", f"{first.bat.name} is solid and has no wall; choose a hollow bat as bat 1")
        thickness = state.wall_factor * state.wall_times
        other = _made(part_of(state, BatState, wall_factor=thickness), ball, "wall_times")
        return [first, other], ["wall as it is", f"wall × {state.wall_times:.3g}"]
    if texts := changes_of(state):
        with about("hole_diameter_in" if state.what_if == "cork" else "change"):
            made = [_after(first.bat, text, ball) for text in texts]
        return [first, *made], [each.bat.name for each in (first, *made)]
    bats = [first, *(_other(bat, ball, number) for number, bat in enumerate(state.others, start=2))]
    return bats, _distinct([reduction.bat.name for reduction in bats])


def changes_of(state: CompareState) -> list[str]:
    """Return the changes of the first bat, as the option --what-if has it, a bat for each; empty: nothing."""
    if state.what_if == "cork":
        hole = f" {number(state.hole_depth_in, 'in')} x {number(state.hole_diameter_in, 'in')}"
        return [f"{name}{'' if hole == USUAL_HOLE else hole}" for name in ("drilled", *FILLS)]
    return [state.change] if state.what_if == "change" else []


@lru_cache(maxsize=32)
def _after(first: Bat, text: str, ball: Ball) -> ReducedBat[Bat]:
    after = changed(first, text).implement
    assert isinstance(after, Bat)  # as the first
    return reduced_bat(after, ball=ball)


def controls_of(state: CompareState, count: int) -> list[BatState]:
    """Return the controls of every bat; those of a what-if are made of the first."""
    return [state, *state.others] if state.what_if == "none" else [state] * count


def others_of(state: CompareState, reductions: list[ReducedBat]) -> list[tuple[BatState, Bat]]:
    """Return the controls of bats 2 to 4 with the bats; a what-if has none."""
    if state.what_if != "none":
        return []
    return [(controls, reduction.bat) for controls, reduction in zip(state.others, reductions[1:], strict=True)]


def _other(bat: BatState, ball: Ball, number: int) -> ReducedBat:
    """Return one bat; what is wrong with it is said of the bats, with its number."""
    try:
        return reduced(bat, ball)
    except FieldError as error:
        raise FieldError(f"others.{number - 2}.{error.field}", f"bat {number}: {error}") from None


def _made(bat: BatState, ball: Ball, control: str) -> ReducedBat:
    """Return a bat of a what-if; what does not work is said beside the what-if's own control."""
    try:
        return reduced(bat, ball)
    except FieldError as error:
        raise FieldError(control, str(error)) from None


def _distinct(names: list[str]) -> list[str]:
    """Return the names with a number behind those that occur again."""
    return [
        name if name not in names[:index] else f"{name} ({names[: index + 1].count(name)})"
        for index, name in enumerate(names)
    ]


def leagues_of(state: CompareState) -> list[League]:
    """Return the leagues whose rules are asked about; a wrong name is refused."""
    with about("league"):
        return [league(name) for name in (league_names() if state.league == ALL else [state.league or ""])]

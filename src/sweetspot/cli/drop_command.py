"""The command `drop`: a ball falls on a block."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Annotated, Literal

from cyclopts import Parameter

from sweetspot.cli.options.output import DEFAULT_OUTPUT, OutputOptions
from sweetspot.cli.options.uncertainty import Uncertainty
from sweetspot.cli.options.written_errors import error_of, without_error
from sweetspot.errors import InputError

if TYPE_CHECKING:
    from sweetspot.dynamics.block import Block

DEFAULT_HEIGHT = "1m"


@Parameter(name="*")
@dataclass(frozen=True)
class BlockOptions:
    """The block, and what holds it."""

    material: Annotated[str, Parameter(help="Material of the catalogue; wood is hit across the grain.")] = "white-ash"
    thickness: Annotated[str, Parameter(help="Thickness of the block.")] = "10cm"
    size: Annotated[str, Parameter(help="Side of its square face.")] = "20cm"
    support: Annotated[
        Literal["clamped", "floor", "free"], Parameter(help="Held all round its edges, lying on a floor, or free.")
    ] = "floor"
    floor: Annotated[Literal["concrete", "rigid"], Parameter(help="What --support floor means.")] = "concrete"


@Parameter(name="*")
@dataclass(frozen=True)
class FallOptions:
    """The ball, and how it comes."""

    height: Annotated[str | None, Parameter(help="Height the ball falls from; 1m unless --speed is given.")] = None
    speed: Annotated[str | None, Parameter(help="Fire the ball at this speed instead, for example 60mph.")] = None
    ball: Annotated[str, Parameter(help="Ball of the catalogue.")] = "baseball"
    in_air: Annotated[bool, Parameter(help="Let air slow fall and rise, as in the tests of rule books.")] = False


DEFAULT_BLOCK, DEFAULT_FALL = BlockOptions(), FallOptions()


def drop(
    *,
    block: BlockOptions = DEFAULT_BLOCK,
    fall: FallOptions = DEFAULT_FALL,
    uncertainty: Uncertainty = False,
    output: OutputOptions = DEFAULT_OUTPUT,
) -> int:
    """Drop or fire a ball on a block: rebound height, restitution, contact time and where the energy goes."""
    from sweetspot import catalog
    from sweetspot.analysis.drop_test import ROOM_AIR
    from sweetspot.answers.drop import DropQuestion, drop_answer
    from sweetspot.answers.drop_draws import drop_sources
    from sweetspot.cli.output import patience, present
    from sweetspot.plausibility import parse
    from sweetspot.report.drop.document import drop_document

    if fall.height is not None and fall.speed is not None:
        raise InputError("give either --height or --speed, and only one of them")
    hit, ball = block_of(block), catalog.ball(fall.ball)
    if fall.speed is not None and fall.in_air:
        raise InputError("--in-air slows a ball that falls; with --speed it arrives as it is told to")
    height = None
    if fall.speed is None:
        height = parse(fall.height or DEFAULT_HEIGHT, "length", "--height", quantity="fall_height")
    question = DropQuestion(
        hit,
        ball,
        height=height,
        speed=None if fall.speed is None else parse(without_error(fall.speed), "speed", "--speed"),
        air_density=ROOM_AIR if fall.in_air else 0.0,
        sources=drop_sources(hit, ball, speed_error=error_of(fall.speed, "speed", "--speed")) if uncertainty else None,
    )
    with patience():
        answer = drop_answer(question)
    return present(drop_document(answer), output)


def block_of(options: BlockOptions) -> Block:
    """Return the block that the options describe."""
    from sweetspot import catalog
    from sweetspot.dynamics.block import FLOOR_MODULUS, Block
    from sweetspot.plausibility import parse

    side = parse(options.size, "length", "--size")
    return Block(
        material=catalog.material(options.material),
        thickness=parse(options.thickness, "length", "--thickness"),
        length=side,
        width=side,
        support=options.support,
        floor_modulus=FLOOR_MODULUS if options.floor == "concrete" else None,
    )

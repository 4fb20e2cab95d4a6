"""The command `drop`: a ball falls on a block."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, Literal

from cyclopts import Parameter

from sweetspot.cli.options.output import DEFAULT_OUTPUT, OutputOptions
from sweetspot.cli.options.reading import Uncertainty, read
from sweetspot.errors import InputError


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
    ball: Annotated[str, Parameter(help="Ball of the catalogue, or a TOML file.")] = "baseball"
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
    from sweetspot.answers.ask_measured import drop as asked
    from sweetspot.answers.setups import BlockSetup, FallSetup
    from sweetspot.cli.output import present

    if fall.height is not None and fall.speed is not None:
        raise InputError("give either --height or --speed, and only one of them")
    if fall.speed is not None and fall.in_air:
        raise InputError("--in-air slows a ball that falls; with --speed it arrives at that speed")
    falling = read(FallSetup, fall, errors=uncertainty, quantities={"height": "fall_height"})
    answer = asked(block=read(BlockSetup, block), fall=falling, uncertainty=uncertainty)
    return present(answer, output)

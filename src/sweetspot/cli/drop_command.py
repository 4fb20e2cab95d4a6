"""The command `drop`: a ball falls on a block."""

from __future__ import annotations

from typing import Annotated, Literal

from cyclopts import Parameter

from sweetspot.cli.options.output import DEFAULT_OUTPUT, OutputOptions
from sweetspot.errors import InputError

DEFAULT_HEIGHT = "1m"


def drop(
    *,
    material: Annotated[str, Parameter(help="Material of the catalogue; wood is hit across the grain.")] = "white-ash",
    thickness: Annotated[str, Parameter(help="Thickness of the block.")] = "10cm",
    size: Annotated[str, Parameter(help="Side of its square face.")] = "20cm",
    support: Annotated[
        Literal["clamped", "floor", "free"], Parameter(help="Held all round its edges, lying on a floor, or free.")
    ] = "floor",
    floor: Annotated[Literal["concrete", "rigid"], Parameter(help="What --support floor means.")] = "concrete",
    height: Annotated[str | None, Parameter(help="Height the ball falls from; 1m unless --speed is given.")] = None,
    speed: Annotated[str | None, Parameter(help="Fire the ball at this speed instead, for example 60mph.")] = None,
    ball: Annotated[str, Parameter(help="Ball of the catalogue.")] = "baseball",
    in_air: Annotated[bool, Parameter(help="Let air slow fall and rise, as in the tests of rule books.")] = False,
    output: OutputOptions = DEFAULT_OUTPUT,
) -> int:
    """Drop or fire a ball on a block: rebound height, restitution, contact time and where the energy goes."""
    from sweetspot import catalog
    from sweetspot.analysis import drop_test as drops
    from sweetspot.cli.output import present
    from sweetspot.dynamics.block import FLOOR_MODULUS, Block
    from sweetspot.report.drop.document import drop_document
    from sweetspot.units import parse

    if height is not None and speed is not None:
        raise InputError("give either --height or --speed, and only one of them")
    side = parse(size, "length", "--size")
    block = Block(
        material=catalog.material(material),
        thickness=parse(thickness, "length", "--thickness"),
        length=side,
        width=side,
        support=support,
        floor_modulus=FLOOR_MODULUS if floor == "concrete" else None,
    )
    what = catalog.ball(ball)
    if speed is not None:
        if in_air:
            raise InputError("--in-air slows a ball that falls; with --speed it arrives as it is told to")
        rebound = drops.fire(block, ball=what, speed=parse(speed, "speed", "--speed"))
    else:
        fall = parse(height or DEFAULT_HEIGHT, "length", "--height")
        rebound = drops.drop(block, ball=what, height=fall, air_density=drops.ROOM_AIR if in_air else 0.0)
    return present(drop_document(rebound, fired=speed is not None), output)

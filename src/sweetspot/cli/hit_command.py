"""`sweetspot hit`: one collision."""

from __future__ import annotations

from typing import Annotated

from cyclopts import Parameter

from sweetspot.cli.options.output import DEFAULT_OUTPUT, OutputOptions
from sweetspot.cli.options.reading import Uncertainty
from sweetspot.cli.options.swing import DEFAULT_SWING, SwingOptions


def hit(
    bat: Annotated[str, Parameter(help="Name in the catalogue (see `sweetspot bats`) or a TOML file.")],
    /,
    *,
    at: Annotated[str, Parameter(help="Where the ball meets the bat: 27in, 6in-from-tip, or sweet-spot, barrel, tip.")],
    beside: Annotated[str | None, Parameter(help="How far beside a face's middle line: 3cm; not for bats.")] = None,
    uncertainty: Uncertainty = False,
    swing: SwingOptions = DEFAULT_SWING,
    output: OutputOptions = DEFAULT_OUTPUT,
) -> int:
    """Compute one collision: exit speed, q, BBCOR, contact time, peak force and where the energy goes."""
    from sweetspot.answers.ask_bat import hit as asked
    from sweetspot.answers.places import place_name
    from sweetspot.catalog.implements import loaded_implement
    from sweetspot.cli.output import present
    from sweetspot.plausibility import parse, parse_position

    loaded = loaded_implement(bat)
    implement = loaded.implement
    answer = asked(
        loaded,
        at=place_name(at) or parse_position(at, length=implement.length, what="--at"),
        beside=0.0 if beside is None else parse(beside, "length", "--beside"),
        setup=swing.setup(implement, errors=uncertainty),
        uncertainty=uncertainty,
    )
    return present(answer, output)

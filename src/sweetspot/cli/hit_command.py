"""`sweetspot hit`: one collision."""

from __future__ import annotations

from typing import Annotated

from cyclopts import Parameter

from sweetspot.cli.options.output import DEFAULT_OUTPUT, OutputOptions
from sweetspot.cli.options.swing import DEFAULT_SWING, SwingOptions
from sweetspot.cli.options.uncertainty import Uncertainty, sources_for
from sweetspot.errors import InputError


def hit(
    bat: Annotated[str, Parameter(help="Name in the catalogue (see `sweetspot bats`) or a TOML file.")],
    /,
    *,
    at: Annotated[str, Parameter(help="Where the ball meets the bat: 27in, 6in-from-tip or 0.152m-from-tip.")],
    beside: Annotated[str | None, Parameter(help="How far beside a face's middle line: 3cm; not for bats.")] = None,
    uncertainty: Uncertainty = False,
    swing: SwingOptions = DEFAULT_SWING,
    output: OutputOptions = DEFAULT_OUTPUT,
) -> int:
    """Compute one collision: exit speed, q, BBCOR, contact time, peak force and where the energy goes."""
    from sweetspot import catalog
    from sweetspot.answers.hit import HitQuestion, hit_answer
    from sweetspot.cli.options.swing import swung_bat
    from sweetspot.cli.output import present
    from sweetspot.equipment.implement import check_lateral, check_on_face, check_position
    from sweetspot.plausibility import parse, parse_position
    from sweetspot.report.hit.document import hit_document

    implement = catalog.load_implement(bat)
    swung = swung_bat(implement, swing)
    conditions = swung.conditions
    position = parse_position(at, length=implement.length, what="--at")
    lateral = 0.0 if beside is None else parse(beside, "length", "--beside")
    check_position(implement, position, "--at")
    check_on_face(implement, position, "--at")
    check_beyond_hands(position, conditions.hands.position, at)
    check_lateral(implement, position, lateral)
    sources = sources_for(bat, implement, conditions, swing) if uncertainty else None
    answer = hit_answer(HitQuestion(implement, conditions, position, lateral, sources))
    return present(swung.told(hit_document(answer)), output)


def check_beyond_hands(position: float, hands: float, given: str) -> None:
    """Refuse a hit on the hands: a place that was meant from the tip counts from the knob end."""
    from sweetspot.plausibility import insisted
    from sweetspot.units import INCH

    if position <= hands and not insisted():
        raise InputError(
            f"--at was given as {given}; there the hands are, {hands / INCH:.3g} in from the end of the grip, from "
            "which places count. From the tip write it as 6in-from-tip, or add --force if it is meant"
        )

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
    from sweetspot.analysis.bat_analysis import check_conditions, hit_at
    from sweetspot.analysis.strain import damage
    from sweetspot.calibration.ball_doubt import error_by_ball
    from sweetspot.cli.options.swing import conditions_for
    from sweetspot.cli.output import present
    from sweetspot.dynamics.beam import beam_model
    from sweetspot.dynamics.mode_assembly import all_modes
    from sweetspot.dynamics.rigid import rigid_body
    from sweetspot.equipment.bat import Bat
    from sweetspot.equipment.implement import check_lateral, check_on_face, check_position
    from sweetspot.report.hit.document import BattedHit, hit_document
    from sweetspot.units import parse, parse_position

    implement = catalog.load_implement(bat)
    conditions = conditions_for(implement, swing)
    line = beam_model(implement)
    body = rigid_body(line)
    check_conditions(implement, conditions, body=body)
    position = parse_position(at, length=implement.length, what="--at")
    check_position(implement, position, "--at")
    check_on_face(implement, position, "--at")
    check_beyond_hands(position, conditions.hands.position, at)
    modes = all_modes(line, conditions.ball)
    lateral = 0.0 if beside is None else parse(beside, "length", "--beside")
    check_lateral(implement, position, lateral)
    impact = hit_at(position, modes=modes, conditions=conditions, lateral=lateral)
    strains = damage(impact, line=line, modes=modes) if isinstance(implement, Bat) else None
    error = None
    if not uncertainty:  # which draws balls too
        error = error_by_ball(implement, body=body, modes=modes, conditions=conditions, position=position)
    document = hit_document(BattedHit(implement, body, conditions, impact, strains, error))
    if uncertainty:
        from sweetspot.calibration.draws.drawn_reports import drawn_hit
        from sweetspot.report.uncertainty.uncertainty_section import uncertain

        sources = sources_for(bat, implement, conditions, swing)
        answers = drawn_hit(line, conditions, sources, position, impact=impact)
        document = uncertain(document, answers, main="exit_speed_m_s", named="exit speed", where=sources.described)
    return present(document, output)


def check_beyond_hands(position: float, hands: float, given: str) -> None:
    """Refuse a hit on the hands: a place that was meant from the tip counts from the knob end."""
    from sweetspot.units import INCH, insisted

    if position <= hands and not insisted():
        raise InputError(
            f"--at was given as {given}; there the hands are, {hands / INCH:.3g} in from the end of the grip, from "
            "which places count. From the tip write it as 6in-from-tip, or add --force if it is meant"
        )

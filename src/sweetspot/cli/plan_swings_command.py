"""`sweetspot plan-swings`: which swings would tell what is not known of a player, and when to stop."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Annotated, Literal

from cyclopts import Parameter

from sweetspot.cli.options.output import DEFAULT_OUTPUT, OutputOptions


@Parameter(name="*")
@dataclass(frozen=True)
class SwingerOptions:
    """What is thought of the player before the swings."""

    bat_speed: Annotated[str | None, Parameter(help="Of the player; default: 68mph.")] = None
    bat_speed_spread: Annotated[str | None, Parameter(help="From swing to swing; default: 4mph.")] = None
    contact_spread: Annotated[str | None, Parameter(help="Of contact along the bat; default: 1.8in.")] = None


@Parameter(name="*")
@dataclass(frozen=True)
class SheetOptions:
    """The sheet with the swings made so far."""

    filled: Annotated[Path | None, Parameter(help="The sheet with the swings made so far.")] = None
    pitch_speed: Annotated[str | None, Parameter(help="At the plate, for rows without one: 60mph, or tee.")] = None
    batch: Annotated[int, Parameter(help="Swings after which it is asked whether to stop.")] = 20


DEFAULT_SWINGER, DEFAULT_SHEET = SwingerOptions(), SheetOptions()


def plan_swings(
    *bats: Annotated[str, Parameter(help="The player's own bat, then others at hand, by name or TOML file.")],
    find: Annotated[
        Literal["exponent", "position"],
        Parameter(help="What a heavier bat costs the player, or where the ball is met."),
    ] = "exponent",
    within: Annotated[
        str | None,
        Parameter(help="Half the 90 % interval wanted; default: 0.07 of the exponent, 0.5in of the place."),
    ] = None,
    lead: Annotated[bool, Parameter(negative="--no-lead", help="Lead tape may go on the player's own bat.")] = True,
    swinger: SwingerOptions = DEFAULT_SWINGER,
    sheet: SheetOptions = DEFAULT_SHEET,
    output: OutputOptions = DEFAULT_OUTPUT,
) -> int:
    """Say which swings would show what is not known of a player: bats, counts, order; then stop or go on."""
    from sweetspot.answers.ask_measured import SheetSetup, SwingerSetup
    from sweetspot.answers.ask_measured import plan_swings as asked
    from sweetspot.cli.output import present
    from sweetspot.plausibility import parse

    def si(text: str | None, kind: Literal["speed", "length"], option: str) -> float | None:
        return None if text is None else parse(text, kind, option)

    tee = sheet.pitch_speed is not None and sheet.pitch_speed.strip().lower() == "tee"
    answer = asked(
        *bats,
        find=find,
        within=within,
        lead=lead,
        swinger=SwingerSetup(
            bat_speed=si(swinger.bat_speed, "speed", "--bat-speed"),
            bat_speed_spread=si(swinger.bat_speed_spread, "speed", "--bat-speed-spread"),
            contact_spread=si(swinger.contact_spread, "length", "--contact-spread"),
        ),
        sheet=SheetSetup(
            filled=sheet.filled,
            pitch_speed=0.0 if tee else si(sheet.pitch_speed, "speed", "--pitch-speed"),
            batch=sheet.batch,
        ),
    )
    return present(answer, output)

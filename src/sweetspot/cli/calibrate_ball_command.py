"""The command `calibrate-ball`: one ball as it is, from a tape measure, a wall, a scale and a press."""

from __future__ import annotations

import os
import re
import sys
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Literal

from cyclopts import Parameter

from sweetspot.cli.options.output import DEFAULT_ANSWER, AnswerOptions
from sweetspot.errors import InputError

if TYPE_CHECKING:
    from sweetspot.answers.calibrate_ball import Bounce
    from sweetspot.calibration.measured import Measured
    from sweetspot.equipment.ball import Ball
    from sweetspot.units import Kind


@Parameter(name="*")
@dataclass(frozen=True)
class BallMeasurements:
    """What was measured on a ball."""

    drop: Annotated[
        list[str] | None,
        Parameter(help="Dropped on a hard floor and back, lowest point: 254cm:141cm±1cm; may be given again."),
    ] = None
    restitution: Annotated[
        list[str] | None, Parameter(help="On a rigid wall at a speed: 0.49±0.005@90mph; may be given again.")
    ] = None
    mass: Annotated[str | None, Parameter(help="Weight: 5.12oz±0.02oz.")] = None
    compression: Annotated[
        str | None,
        Parameter(
            help="Load that brings two plates a quarter inch nearer: 310lbf±10lbf, or 310pqi: pounds per quarter inch."
        ),
    ] = None
    temperature: Annotated[str | None, Parameter(help="Of the ball when it bounced: 10degC.")] = None
    humidity: Annotated[str | None, Parameter(help="At which it was stored before, 0.5 or 50%.")] = None
    name: Annotated[str, Parameter(help="What to call it.")] = "my ball"


NOTHING_MEASURED = BallMeasurements()


def calibrate_ball(
    ball: Annotated[str, Parameter(help="Ball that it is like: name in the catalogue or a TOML file.")],
    /,
    *,
    measured: BallMeasurements = NOTHING_MEASURED,
    out: Annotated[Path | None, Parameter(help="Ball file to write.")] = None,
    answer: AnswerOptions = DEFAULT_ANSWER,
) -> int:
    """Fit a ball to what was measured on it: a file for every --ball. Exit 1 when the bounces contradict."""
    from sweetspot.answers.calibrate_ball import CalibrateBallQuestion, calibrate_ball_answer
    from sweetspot.catalog.balls import ball as catalog_ball
    from sweetspot.catalog.records import is_file
    from sweetspot.cli.output import note, present

    like = catalog_ball(ball)
    found = calibrate_ball_answer(
        CalibrateBallQuestion(
            like=str(Path(ball).resolve()) if is_file(ball) else ball,
            bounces=[*(_drop(text, like) for text in measured.drop or []), *map(_bounce, measured.restitution or [])],
            mass=_number(measured.mass, "mass"),
            compression=_number(_in_pounds(measured.compression), "force", "compression"),
            temperature=_exact(measured.temperature, "temperature"),
            humidity=_exact(measured.humidity, "humidity"),
            name=measured.name,
        )
    )
    if found.contradictory:
        print("sweetspot: the bounces contradict each other; no ball was written", file=sys.stderr)
    elif out is not None:
        from sweetspot.reports.files import write_all

        if os.path.lexists(out):
            raise InputError(f"{out} is there already; choose another name for --out")
        write_all({out: found.to_toml().encode()})
        note(f"wrote {out}")
    return present(found, answer.into(None)) or int(found.contradictory)


def _number(text: str | None, kind: Kind, name: str = "mass") -> Measured | None:
    from sweetspot.calibration.measured import parse_measured

    return None if text is None else parse_measured(text, kind, f"ball {name}")


def _in_pounds(text: str | None) -> str | None:
    """Return a load in pounds at a quarter inch, as balls' compressions are labeled, as one in pounds."""
    return None if text is None else re.sub(r"\s*pqi\b", "lbf", text, flags=re.IGNORECASE)


def _exact(text: str | None, name: Literal["temperature", "humidity"]) -> float | None:
    from sweetspot.plausibility import parse

    return None if text is None else parse(text, "ratio" if name == "humidity" else name, f"--{name}")


def _drop(text: str, like: Ball) -> Bounce:
    from sweetspot.answers.calibrate_ball import drop_bounce
    from sweetspot.calibration.measured import parse_measured
    from sweetspot.plausibility import parse

    height, colon, rebound = text.partition(":")
    if not colon:
        raise InputError(f"--drop was given as {text!r}; write the heights of fall and rebound: 254cm:141cm")
    fall = parse(height, "length", "--drop", quantity="fall_height")
    return drop_bounce(like, height=fall, rebound=parse_measured(rebound, "length", "the rebound of --drop"))


def _bounce(text: str) -> Bounce:
    from sweetspot.answers.calibrate_ball import Bounce
    from sweetspot.calibration.measured import parse_measured
    from sweetspot.plausibility import parse

    value, at, speed = text.partition("@")
    if not at:
        raise InputError(f"--restitution was given as {text!r}; write it with its speed: 0.49±0.005@90mph")
    closing = parse(speed, "speed", "the speed of --restitution", quantity="closing_speed")
    if closing <= 0:
        raise InputError(f"--restitution was given as {text!r}; allowed is a speed of more than 0")
    return Bounce(closing, parse_measured(value, "ratio", "--restitution"))

"""The command `calibrate`: one bat as it is, from a scale, a string and a telephone."""

from __future__ import annotations

import sys
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

from cyclopts import Parameter

from sweetspot.cli.options.output import DEFAULT_ANSWER, AnswerOptions
from sweetspot.cli.options.reading import DEFAULT_COLUMNS, ColumnOptions
from sweetspot.errors import InputError

if TYPE_CHECKING:
    from sweetspot.analysis.certification.shots import Shot
    from sweetspot.calibration.measured import Measured
    from sweetspot.calibration.measurements import Measurement
    from sweetspot.equipment.ball import Ball
    from sweetspot.equipment.implement import Implement


@Parameter(name="*")
@dataclass(frozen=True)
class WeighedOptions:
    """What scale, balance and pendulum say."""

    measured: Annotated[
        Path | None, Parameter(help="CSV with a row for this bat, as rank reads it and a kit's sheet saves it.")
    ] = None
    row: Annotated[str | None, Parameter(help="Name of its row in --measured, where there are several.")] = None
    mass: Annotated[
        str | None,
        Parameter(
            help="Weight: 31.2oz, or 31.2oz±0.05oz, one standard deviation. Without ± the last digit counts, and no "
            "less than 1 g, 0.5 mm of balance, 2 ms of a swing, 0.3 Hz."
        ),
    ] = None
    balance_point: Annotated[str | None, Parameter(help="From the knob end: 22.4in±0.1in.")] = None
    pendulum: Annotated[str | None, Parameter(help="Period of one full swing about --pivot: 1.572s±0.003s.")] = None
    moi: Annotated[str | None, Parameter(help="Moment of inertia about --pivot: 11200oz*in^2±50oz*in^2.")] = None
    swing_weight: Annotated[
        str | None,
        Parameter(help="As its sport tells it, about the sport's own axis: D2 of a club, 316kg*cm^2 of a racket."),
    ] = None
    twist_weight: Annotated[str | None, Parameter(help="Of a paddle, about its long axis: 7.2kg*cm^2±0.2kg*cm^2.")] = (
        None
    )
    face_stiffness: Annotated[
        str | None, Parameter(help="Of a paddle's face: 45lbf/in, or as force for 1/16 in: 45lbf±2lbf.")
    ] = None
    pivot: Annotated[
        str | None,
        Parameter(help="Where it hangs, from the knob end; default: 6in, or the axis of the sport's swing weight."),
    ] = None


@Parameter(name="*")
@dataclass(frozen=True)
class RungOptions:
    """What it rings with."""

    tap: Annotated[list[Path] | None, Parameter(help="Recordings of taps, as tap reads them; may be given again.")] = (
        None
    )
    at: Annotated[list[str] | None, Parameter(help="Where it was tapped: 1in-from-tip; may be given again.")] = None
    tone: Annotated[
        list[str] | None,
        Parameter(
            help="A frequency measured otherwise: bending-1:171.3Hz±0.5Hz, or of a club clamped:252cpm±1cpm; may be "
            "given again."
        ),
    ] = None


@Parameter(name="*")
@dataclass(frozen=True)
class CalibrationShotOptions:
    """What shots at it say."""

    shots: Annotated[
        Path | None, Parameter(help="CSV of shots at places: ball_in_mph, ball_out_mph, position_in_from_tip.")
    ] = None
    ball: Annotated[str | None, Parameter(help="Ball of the shots, or its TOML file; default: the sport's.")] = None
    columns: ColumnOptions = DEFAULT_COLUMNS


@Parameter(name="*")
@dataclass(frozen=True)
class TrustOptions:
    """What is believed of the description and the measurements."""

    diameter_error: Annotated[str, Parameter(help="How well the diameters are known, of handle and barrel each.")] = (
        "0.3%"
    )
    leave_out: Annotated[
        list[str] | None, Parameter(help="A measurement that is not to count: 'bending 2'; may be given again.")
    ] = None


DEFAULT_WEIGHED, DEFAULT_RUNG, DEFAULT_SHOTS, DEFAULT_TRUST = (
    WeighedOptions(),
    RungOptions(),
    CalibrationShotOptions(),
    TrustOptions(),
)


def calibrate(
    bat: Annotated[
        str,
        Parameter(help="The bat, racket, club or stick as described: a TOML file or a name of the catalogue."),
    ],
    /,
    *,
    weighed: WeighedOptions = DEFAULT_WEIGHED,
    rung: RungOptions = DEFAULT_RUNG,
    shot: CalibrationShotOptions = DEFAULT_SHOTS,
    trust: TrustOptions = DEFAULT_TRUST,
    out: Annotated[Path | None, Parameter(help="Bat file to write.")] = None,
    answer: AnswerOptions = DEFAULT_ANSWER,
) -> int:
    """Fit a bat to what was measured on it, and say how sure each value is. Exit 1 when measurements contradict."""
    from sweetspot import catalog
    from sweetspot.answers.calibrate import CalibrateQuestion, calibrate_answer
    from sweetspot.cli.output import note, present
    from sweetspot.plausibility import parse
    from sweetspot.reports.calibration.document import calibration_document

    described = catalog.load_implement(bat).as_drawn()
    diameter_error = parse(trust.diameter_error, "ratio", "--diameter-error")
    measurements = _weighed(described, weighed)
    tapped, damping = _tapped(described, rung.tap or [], rung.at or [])
    measurements += tapped + [_tone(text, described) for text in rung.tone or []]
    shots, ball = _shots(described, shot)
    question = CalibrateQuestion(
        bat=described,
        measurements=measurements,
        damping=damping,
        shots=shots,
        ball=ball,
        left_out=trust.leave_out or [],
        diameter_error=diameter_error,
    )
    found = calibrate_answer(question)
    if not found.consistent:
        print("sweetspot: measurements contradict each other; no bat was written", file=sys.stderr)
    elif out is not None:
        from sweetspot.reports.files import write_all

        write_all({out: found.to_toml().encode()})
        note(f"wrote {out}")
    return present(calibration_document(found), answer.into(None))


def _weighed(described: Implement, weighed: WeighedOptions) -> list[Measurement]:
    """Return the measurements by scale, balance and pendulum."""
    from sweetspot.calibration.measured import FLOORS, parse_measured
    from sweetspot.calibration.measurements import Measurement, of_swing_weight, refuse_twice
    from sweetspot.plausibility import parse_position

    pivot = weighed.pivot
    axis = described.swing_axis if pivot is None else parse_position(pivot, length=described.length, what="--pivot")
    measurements: list[Measurement] = []
    if weighed.row is not None and weighed.measured is None:
        raise InputError("--row was given without --measured; name the table")
    if weighed.measured is not None:
        from sweetspot.calibration.bat_table import read_bat

        measurements += read_bat(weighed.measured, described, name=weighed.row, axis=axis)
    if weighed.mass is not None:
        measurements.append(Measurement("mass", parse_measured(weighed.mass, "mass", "--mass", floor=FLOORS["mass"])))
    if weighed.balance_point is not None:
        text, floor = weighed.balance_point, FLOORS["balance_point"]
        place = parse_measured(text, "length", "--balance-point", floor=floor)
        measurements.append(Measurement("balance_point", place))
    if weighed.pendulum is not None:
        period = parse_measured(weighed.pendulum, "time", "period", floor=FLOORS["pendulum"])
        measurements.append(Measurement("period", period, axis=axis))
    if weighed.moi is not None:
        measurements.append(Measurement("moi", parse_measured(weighed.moi, "moi", "--moi"), axis=axis))
    if weighed.swing_weight is not None:
        mass = next((measurement.value for measurement in measurements if measurement.kind == "mass"), None)
        measurements.append(of_swing_weight(weighed.swing_weight, described.sport, mass=mass, what="--swing-weight"))
    measurements += _of_paddle(described, weighed)
    refuse_twice(measurements)
    return measurements


def _of_paddle(described: Implement, weighed: WeighedOptions) -> list[Measurement]:
    """Return the measurements of twist weight and stiffness of the face, which paddles alone have."""
    from sweetspot.calibration.measurements import of_face_stiffness, of_twist_weight
    from sweetspot.equipment.paddle import Paddle

    given = {"--twist-weight": weighed.twist_weight, "--face-stiffness": weighed.face_stiffness}
    readers = {"--twist-weight": of_twist_weight, "--face-stiffness": of_face_stiffness}
    named = [(what, text) for what, text in given.items() if text is not None]
    if named and not isinstance(described, Paddle):
        raise InputError(f"{named[0][0]} is that of a paddle; leave it out")
    return [readers[what](text, what=what) for what, text in named]


def _tapped(described: Implement, recordings: list[Path], at: list[str]) -> tuple[list[Measurement], Measured | None]:
    """Return the tones that recordings hold, and the damping of the bending modes."""
    from sweetspot.answers.tap import TapQuestion, tap_answer
    from sweetspot.calibration.response_file import read_taps
    from sweetspot.cli.tap_command import tap_places
    from sweetspot.equipment.paddle import Paddle
    from sweetspot.reports.tap import touched_words, unlike_words

    if not recordings:
        if at:
            raise InputError("--at was given without --tap; name the recordings")
        return [], None
    sounds = [heard for path in recordings for heard in read_taps(path)]
    tapped = tap_answer(TapQuestion(sounds, described, tap_places(described, at)))
    if tapped.test.unheard:
        raise InputError(
            f"{unlike_words(tapped.test)} Give the bat that was tapped, or name tones yourself with --tone"
        )
    if tapped.test.unlike:
        print(f"sweetspot: {unlike_words(tapped.test)}", file=sys.stderr)
    if tapped.test.touched:
        print(f"sweetspot: {touched_words(tapped.test, tapped.test.touched)}", file=sys.stderr)
    if tapped.damping is None and not isinstance(described, Paddle):
        raise InputError(
            "no tone of the recordings is a bending mode of this bat; hang it freely, tap it 1 in from the tip"
        )
    return tapped.measurements, tapped.damping


def _shots(described: Implement, given: CalibrationShotOptions) -> tuple[list[Shot], Ball | None]:
    """Return the shots of a table, and the kind of their balls."""
    from sweetspot import catalog
    from sweetspot.analysis.certification.shots import read_shots
    from sweetspot.answers.calibrate import check_takes_shots

    if given.shots is None:
        if given.ball is not None:
            raise InputError("--ball was given without --shots; name the file of shots")
        return [], None
    check_takes_shots(described)
    table = read_shots(given.shots, length=described.length, given=given.columns.given())
    for bad in table.bad_rows:
        print(f"sweetspot: {given.shots}, row {bad.row} was left out: {bad.reason}", file=sys.stderr)
    return list(table.shots), None if given.ball is None else catalog.ball(given.ball)


def _tone(text: str, described: Implement) -> Measurement:
    """Return the measurement that a text like ``bending-1:171.3Hz`` names."""
    from sweetspot.calibration.measured import FLOORS, parse_measured
    from sweetspot.calibration.measurements import TONES, Measurement, of_clamped_tone
    from sweetspot.calibration.tap_analysis import tones_to_fit

    name, _, value = text.partition(":")
    if name.strip() == "clamped" and value:
        return of_clamped_tone(value, described, what="--tone")
    if name.strip() not in TONES or not value:
        raise InputError(f"--tone was given as {text!r}; write {', '.join(TONES)} and a frequency: bending-1:171.3Hz")
    frequency: Measured = parse_measured(value, "frequency", "--tone", floor=FLOORS["tone"])
    if frequency.value <= 0:
        raise InputError(f"--tone was given as {text!r}; allowed is a frequency of more than 0 Hz")
    given = tones_to_fit([Measurement("frequency", frequency, mode=TONES[name.strip()])], described)
    if not given:
        raise InputError(
            f"--tone was given as {text!r}; of {described.name} only the first bending mode counts, to which its "
            "stiffness is scaled, bending-1, and of a paddle its face"
        )
    return given[0]

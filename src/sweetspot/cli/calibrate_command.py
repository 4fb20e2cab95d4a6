"""The command `calibrate`: one bat as it is, from a scale, a string and a telephone."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

from cyclopts import Parameter

from sweetspot.cli.options.swing import Format
from sweetspot.errors import InputError

if TYPE_CHECKING:
    from sweetspot.calibration.measured import Measured
    from sweetspot.calibration.measurements import Measurement
    from sweetspot.calibration.unknowns import Unknown
    from sweetspot.equipment.bat import Bat


def calibrate(
    bat: Annotated[str, Parameter(help="The bat as described: a TOML file or a name of the catalogue.")],
    /,
    *,
    mass: Annotated[str | None, Parameter(help="Weight: 31.2oz, or 31.2oz±0.05oz; without ± the last digit.")] = None,
    balance_point: Annotated[str | None, Parameter(help="From the knob end: 22.4in±0.1in.")] = None,
    pendulum: Annotated[str | None, Parameter(help="Period of one full swing about --pivot: 1.572s±0.003s.")] = None,
    moi: Annotated[str | None, Parameter(help="Moment of inertia about --pivot: 11200oz*in^2±50oz*in^2.")] = None,
    pivot: Annotated[str, Parameter(help="Where it hangs, from the knob end.")] = "6in",
    tap: Annotated[list[Path] | None, Parameter(help="Sound files of taps; may be given again.")] = None,
    at: Annotated[list[str] | None, Parameter(help="Where it was tapped: 1in-from-tip; may be given again.")] = None,
    tone: Annotated[
        list[str] | None, Parameter(help="A frequency measured otherwise: bending-1:171.3Hz±0.5Hz; may be given again.")
    ] = None,
    shots: Annotated[
        Path | None, Parameter(help="CSV of shots at places: ball_in_mph, ball_out_mph, position_in_from_tip.")
    ] = None,
    ball: Annotated[str | None, Parameter(help="Ball of the shots; default: the sport's.")] = None,
    diameter_error: Annotated[str, Parameter(help="How well the diameters are known, of handle and barrel each.")] = (
        "0.3%"
    ),
    leave_out: Annotated[
        list[str] | None, Parameter(help="A measurement that is not to count: 'bending 2'; may be given again.")
    ] = None,
    out: Annotated[Path | None, Parameter(help="Bat file to write.")] = None,
    format: Annotated[Format, Parameter(name="--format", help="table for people, json or csv for programs.")] = "table",
) -> int:
    """Fit a bat to what was measured on it, and say how sure each value is. Exit 1 when measurements contradict."""
    from sweetspot import catalog
    from sweetspot.calibration.calibrated_file import calibrated_table
    from sweetspot.calibration.posterior import calibrate as fitted
    from sweetspot.calibration.unknowns import described, unknowns_of
    from sweetspot.cli.output import print_json, print_rows_csv, print_table
    from sweetspot.report.calibration.calibration_report import calibration_json, calibration_table
    from sweetspot.units import parse

    own = catalog.load_bat(bat)
    unknowns = unknowns_of(own, diameter_spread=parse(diameter_error, "ratio", "--diameter-error"))
    measurements = _weighed(own, mass=mass, balance_point=balance_point, pendulum=pendulum, moi=moi, pivot=pivot)
    tapped, damping = _tapped(own, tap or [], at or [])
    measurements += tapped + [_tone(text) for text in tone or []]
    if shots is not None:
        shot, of_ball = _shot(own, shots, ball)
        measurements += shot
        unknowns = (*unknowns, of_ball)
    elif ball is not None:
        raise InputError("--ball was given without --shots; name the file of shots")
    posterior = fitted(described(own), unknowns, _without(measurements, leave_out or []))
    if format == "json":
        print_json(calibration_json(posterior, damping))
    elif format == "csv":
        print_rows_csv(calibration_json(posterior, damping)["measurements"])
    else:
        print_table(calibration_table(posterior, damping))
    if posterior.contradictions:
        print("sweetspot: measurements contradict each other; no bat was written", file=sys.stderr)
        return 1
    if out is not None:
        import tomli_w

        from sweetspot.report.file_set import write_all

        write_all({out: tomli_w.dumps(calibrated_table(posterior, damping)).encode()})
        print(f"sweetspot: wrote {out}", file=sys.stderr)
    return 0


def _weighed(
    own: Bat, *, mass: str | None, balance_point: str | None, pendulum: str | None, moi: str | None, pivot: str
) -> list[Measurement]:
    """Return what scale, balance and pendulum say."""
    from sweetspot.calibration.measurements import Measurement
    from sweetspot.calibration.written import parse_measured
    from sweetspot.units import parse_position

    axis = parse_position(pivot, length=own.length, what="--pivot")
    found = []
    if mass is not None:
        found.append(Measurement("mass", parse_measured(mass, "mass", "--mass")))
    if balance_point is not None:
        found.append(Measurement("balance_point", parse_measured(balance_point, "length", "--balance-point")))
    if pendulum is not None:
        found.append(Measurement("period", parse_measured(pendulum, "time", "period"), axis=axis))
    if moi is not None:
        found.append(Measurement("moi", parse_measured(moi, "moi", "--moi"), axis=axis))
    return found


def _tapped(own: Bat, recordings: list[Path], at: list[str]) -> tuple[list[Measurement], Measured | None]:
    """Return the tones that recordings hold, and the damping of the bending modes."""
    from sweetspot.calibration.measured import pooled
    from sweetspot.calibration.measurements import of_tones
    from sweetspot.calibration.recording import read_recording
    from sweetspot.calibration.tap_analysis import tap_test
    from sweetspot.cli.tap_command import modes_to_name, tap_places

    if not recordings:
        if at:
            raise InputError("--at was given without --tap; name the recordings")
        return [], None
    sounds = [read_recording(path) for path in recordings]
    test = tap_test(sounds, modes=modes_to_name(own), positions=tap_places(own, at))
    bending = [one.tone.damping_ratio for one in test.tones if one.name and one.name.family == "bending"]
    if not bending:
        raise InputError(
            "no tone of the recordings is a bending mode of this bat; hang it freely, tap it 1 in from the tip"
        )
    return of_tones(test.tones), pooled(bending)


def _shot(own: Bat, path: Path, ball: str | None) -> tuple[list[Measurement], Unknown]:
    """Return what shots say at each place, and how lively their balls may be."""
    from sweetspot import catalog
    from sweetspot.analysis.certification.shots import read_shots
    from sweetspot.calibration.shot_measurements import of_shots, shot_ball_unknown
    from sweetspot.catalog.standard_hit import standard_conditions

    read = read_shots(path, length=own.length)
    for bad in read.bad_rows:
        print(f"sweetspot: {path}, row {bad.row} was left out: {bad.reason}", file=sys.stderr)
    used = standard_conditions(own).ball if ball is None else catalog.ball(ball)
    return of_shots(read.shots, used), shot_ball_unknown(read.shots, used)


def _tone(text: str) -> Measurement:
    """Return the measurement that a text like ``bending-1:171.3Hz`` names."""
    from sweetspot.calibration.measurements import MOST_BENDING, Measurement
    from sweetspot.calibration.naming import ModeName
    from sweetspot.calibration.written import parse_measured

    names = {f"bending-{number}": ModeName("bending", number) for number in range(1, MOST_BENDING + 1)}
    names["hoop"] = ModeName("hoop", 2)
    name, _, value = text.partition(":")
    if name.strip() not in names or not value:
        raise InputError(f"--tone was given as {text!r}; write {', '.join(names)} and a frequency: bending-1:171.3Hz")
    frequency: Measured = parse_measured(value, "frequency", "--tone")
    return Measurement("frequency", frequency, mode=names[name.strip()])


def _without(measurements: list[Measurement], names: list[str]) -> list[Measurement]:
    known = {one.name for one in measurements}
    for name in names:
        if name not in known:
            raise InputError(f"--leave-out was given as {name!r}; measured are {', '.join(sorted(known)) or 'none'}")
    return [one for one in measurements if one.name not in names]

"""The commands."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, Any

from cyclopts import App, Parameter

from sweetspot import __version__
from sweetspot.cli.options.swing import Format, SwingOptions
from sweetspot.errors import InputError

app = App(
    name="sweetspot",
    help="The open laboratory of the ball-bat collision: from a real bat's measurements to its sweet spots.",
    version=__version__,
    help_format="plaintext",
    suppress_keyboard_interrupt=False,  # `main` says that nothing was written
)

BatName = Annotated[str, Parameter(help="Name in the catalogue (see `sweetspot bats`) or a TOML file.")]
OutputFormat = Annotated[Format, Parameter(name="--format", help="table for people, json or csv for programs.")]
Uncertainty = Annotated[bool, Parameter(negative="", help="Say how sure the answer is, and what its doubt comes from.")]
DEFAULT_SWING = SwingOptions()


@app.command
def report(
    bat: BatName = "r161-ash",
    /,
    *,
    out: Annotated[Path | None, Parameter(help="Folder for report.html, PNG, SVG and JSON.")] = None,
    uncertainty: Uncertainty = False,
    swing: SwingOptions = DEFAULT_SWING,
    format: OutputFormat = "table",
) -> None:
    """Say where a bat hits best, why there and not at the end, and what each inch of miss costs."""
    from sweetspot.cli.output import patience, print_csv, print_json, print_table
    from sweetspot.report.json_shapes import report_json

    if out is not None:
        from sweetspot.report.bat.html import check_folder

        check_folder(out)
    with patience():
        analysis = _analysed(bat, swing)
        sure = _doubt(bat, analysis.line, analysis.conditions, None) if uncertainty else None
    best = analysis.sweet_spots.max_exit_speed
    if format == "json":
        extra = {} if sure is None else {"uncertainty": _doubt_json(sure, best, along=True)}
        print_json({**report_json(analysis), **extra})
    elif format == "csv":
        print_csv(report_json(analysis)["scan"])
    else:
        from sweetspot.report.bat.table import report_table

        print_table(report_table(analysis))
        if sure is not None:
            print_table(_doubt_words(sure, best, analysis.bat.length, along=True))
    if out is not None:
        from sweetspot.report.bat.html import write_report

        _say("wrote " + ", ".join(str(path) for path in write_report(analysis, out)))


@app.command
def hit(
    bat: BatName,
    /,
    *,
    at: Annotated[str, Parameter(help="Where the ball meets the bat: 27in, 6in-from-tip or 0.152m-from-tip.")],
    beside: Annotated[str | None, Parameter(help="How far beside a face's middle line: 3cm; not for bats.")] = None,
    uncertainty: Uncertainty = False,
    swing: SwingOptions = DEFAULT_SWING,
    format: OutputFormat = "table",
) -> None:
    """Compute one collision: exit speed, q, BBCOR, contact time, peak force and where the energy goes."""
    from sweetspot import catalog
    from sweetspot.analysis.bat_analysis import check_conditions, hit_at
    from sweetspot.analysis.strain import damage
    from sweetspot.cli.options.swing import conditions_for
    from sweetspot.cli.output import print_csv, print_json, print_table
    from sweetspot.dynamics.beam import beam_model
    from sweetspot.dynamics.mode_assembly import all_modes
    from sweetspot.dynamics.rigid import rigid_body
    from sweetspot.equipment.bat import Bat
    from sweetspot.equipment.implement import check_lateral, check_position
    from sweetspot.report.json_shapes import damage_json, hit_json
    from sweetspot.units import parse, parse_position

    described = catalog.load_implement(bat)
    conditions = conditions_for(described, swing)
    line = beam_model(described)
    body = rigid_body(line)
    check_conditions(described, conditions, body=body)
    position = parse_position(at, length=described.length, what="--at")
    check_position(described, position, "--at")
    modes = all_modes(line, conditions.ball)
    lateral = 0.0 if beside is None else parse(beside, "length", "--beside")
    check_lateral(described, position, lateral)
    impact = hit_at(position, modes=modes, conditions=conditions, lateral=lateral)
    strains = damage(impact, line=line, modes=modes) if isinstance(described, Bat) else None
    sure = _doubt(bat, line, conditions, [position]) if uncertainty else None
    if format == "json":
        extra = {"damage": damage_json(strains)} if strains else {}
        extra |= {} if sure is None else {"uncertainty": _doubt_json(sure, position, along=False)}
        print_json({**hit_json(impact, body=body, conditions=conditions), **extra})
    elif format == "csv":
        print_csv(hit_json(impact, body=body, conditions=conditions)["history"])
    else:
        from sweetspot.report.bat.table import damage_lines, hit_table
        from sweetspot.report.sports.table import sport_hit
        from sweetspot.report.sports.vocabulary import speaks_otherwise

        if speaks_otherwise(described):
            print_table(sport_hit(impact, body=body, conditions=conditions, bat=described))
        else:
            print_table(hit_table(impact, body=body, conditions=conditions, length=described.length))
        if strains:
            print_table(damage_lines(strains))
        if sure is not None:
            print_table(_doubt_words(sure, position, described.length, along=False))


@app.command
def validate(*, format: OutputFormat = "table") -> int:
    """Compare with every published case: printed against computed, tolerance, worth. Exit 1 on an unexplained miss."""
    from sweetspot import validation
    from sweetspot.cli.output import patience, print_json, print_rows_csv, print_table
    from sweetspot.report.bat.table import names_table

    with patience():
        found = validation.results()
    if format == "json":
        print_json(
            {
                "headline": validation.headline(found),
                "summary": validation.summary(found),
                "rows": validation.rows(found),
            }
        )
    elif format == "csv":
        print_rows_csv(validation.rows(found))
    else:
        print_table(names_table(validation.short_rows(found), "Published cases"))
        print(validation.headline(found))
    return 0 if validation.passed(found) else 1


@app.command
def bats(*, format: OutputFormat = "table") -> None:
    """List the catalogue's bats with their weight, balance and swing weight."""
    from sweetspot import catalog
    from sweetspot.cli.output import print_json, print_rows_csv, print_table
    from sweetspot.dynamics.beam import beam_model
    from sweetspot.dynamics.outline_doubt import moi_doubt
    from sweetspot.dynamics.rigid import rigid_body
    from sweetspot.numerics.constants import STANDARD_AXIS
    from sweetspot.report.bat.table import names_table
    from sweetspot.report.bat.words import told_with_doubt
    from sweetspot.report.json_shapes import bat_json
    from sweetspot.units import INCH, OUNCE, OUNCE_INCH_SQUARED

    found = [(name, catalog.bat(name)) for name in catalog.bat_names()]
    rows: list[dict[str, Any]] = []
    for key, bat in found:
        body = rigid_body(beam_model(bat))
        doubt = {"moi_6in_doubt_kg_m2": moi_doubt(bat, body, STANDARD_AXIS)}
        rows.append({"key": key, **bat_json(bat.name, bat.length, body), **doubt})
    if format == "json":
        print_json({"bats": rows})
    elif format == "csv":
        print_rows_csv(rows)
    else:
        shown = [
            {
                "name": row["key"],
                "what": row["name"],
                "in": f"{row['length_m'] / INCH:.1f}",
                "oz": f"{row['mass_kg'] / OUNCE:.1f}",
                "balance in": f"{row['balance_point_m'] / INCH:.2f}",
                "MOI 6in oz in^2": told_with_doubt(
                    row["moi_6in_kg_m2"] / OUNCE_INCH_SQUARED, row["moi_6in_doubt_kg_m2"] / OUNCE_INCH_SQUARED
                ),
            }
            for row in rows
        ]
        print_table(names_table(shown, "Bats of the catalogue"))


@app.command
def schema(
    kind: Annotated[
        str, Parameter(help="bat, racket, cricket-bat, golf-club, hockey-stick or table-tennis-racket.")
    ] = "bat",
    /,
) -> None:
    """Print the JSON schema of a file that describes a bat, racket, club or stick."""
    from sweetspot.catalog.files.implement import FILES
    from sweetspot.cli.output import print_json
    from sweetspot.errors import nearest_names

    if kind not in FILES:
        raise InputError(f"kind {kind!r} is not known. {nearest_names(kind, sorted(FILES))}")
    print_json(FILES[kind].model_json_schema())


@app.command
def pendulum(
    *,
    mass: Annotated[str, Parameter(help="Weight of the bat, for example 31oz.")],
    balance_point: Annotated[str, Parameter(help="Balance point from the knob end, for example 22.4in.")],
    period: Annotated[str | None, Parameter(help="Time of one full swing to and fro, for example 1.57s.")] = None,
    moi: Annotated[str | None, Parameter(help="Moment of inertia about --pivot; gives the period instead.")] = None,
    pivot: Annotated[str, Parameter(help="Where the bat hangs, from the knob end.")] = "6in",
    format: OutputFormat = "table",
) -> None:
    """Turn the period of a hanging bat into its moment of inertia, or back, as laboratories measure it."""
    from sweetspot.cli.output import print_json, print_rows_csv, print_table
    from sweetspot.dynamics import rigid
    from sweetspot.report.bat.table import names_table
    from sweetspot.units import OUNCE_INCH_SQUARED, parse

    if (period is None) == (moi is None):
        raise InputError("give either --period or --moi, and only one of them")
    weight, balance = parse(mass, "mass", "--mass"), parse(balance_point, "length", "--balance-point")
    axis = parse(pivot, "length", "--pivot")
    if not weight > 0:
        raise InputError(f"--mass was given as {mass}; allowed is a weight above zero")
    if moi is not None:
        inertia = parse(moi, "moi", "--moi")
        seconds = rigid.pendulum_period(inertia, mass=weight, balance_point=balance, pivot=axis)
    else:
        assert period is not None  # one of the two was given
        seconds = parse(period, "time", "--period")
        inertia = rigid.moi_from_pendulum(seconds, mass=weight, balance_point=balance, pivot=axis)
    result = {
        "period_s": seconds,
        "moi_kg_m2": inertia,
        "moi_oz_in2": inertia / OUNCE_INCH_SQUARED,
        "pivot_m": axis,
        "center_of_percussion_m": axis + inertia / (weight * (balance - axis)),
    }
    if format == "json":
        print_json(result)
    elif format == "csv":
        print_rows_csv([result])
    else:
        print_table(names_table([{key: f"{value:.6g}" for key, value in result.items()}], "Pendulum"))


def _analysed(name: str, swing: SwingOptions) -> Any:
    from sweetspot import catalog
    from sweetspot.analysis.bat_analysis import analyse
    from sweetspot.cli.options.swing import conditions_for

    described = catalog.load_implement(name)
    return analyse(described, conditions_for(described, swing))


def _doubt(name: str, line: Any, conditions: Any, positions: list[float] | None) -> Any:
    """Return what the answers about a bat depend on; a calibrated bat's file knows its own part."""
    import numpy as np

    from sweetspot.calibration.calibrated_file import deviations_of
    from sweetspot.calibration.uncertainty import doubt

    places = None if positions is None else np.array(positions)
    return doubt(line, conditions, known=deviations_of(name), positions=places)


def _doubt_json(sure: Any, position: float, *, along: bool) -> dict[str, Any]:
    from sweetspot.report.calibration.doubt_report import doubt_json

    return doubt_json(sure, position, place=sure.best_place() if along else None)


def _doubt_words(sure: Any, position: float, length: float, *, along: bool) -> Any:
    from rich.text import Text

    from sweetspot.report.calibration.doubt_report import doubt_words

    return Text(f"\n{doubt_words(sure, position, length=length, place=sure.best_place() if along else None)}")


def _say(text: str) -> None:
    import sys

    print(f"sweetspot: {text}", file=sys.stderr)


from sweetspot.cli.certify_command import certify  # noqa: E402

app.command(certify)
from sweetspot.cli.compare_command import compare  # noqa: E402

app.command(compare)
from sweetspot.cli.drop_command import drop  # noqa: E402

app.command(drop)
from sweetspot.cli.paper_command import paper  # noqa: E402

app.command(paper)
from sweetspot.cli.page_command import app as page  # noqa: E402

app.command(page, name="app")
from sweetspot.cli.parks_command import parks  # noqa: E402

app.command(parks)
from sweetspot.cli.sports_command import sports  # noqa: E402

app.command(sports)
from sweetspot.cli.play_command import play  # noqa: E402

app.command(play)
from sweetspot.cli.optimum_command import optimum  # noqa: E402

app.command(optimum)
from sweetspot.cli.fly_command import fly  # noqa: E402

app.command(fly)
from sweetspot.cli.fit_player_command import fit_player  # noqa: E402

app.command(fit_player)
from sweetspot.cli.tap_command import tap  # noqa: E402

app.command(tap)
from sweetspot.cli.calibrate_command import calibrate  # noqa: E402

app.command(calibrate)

"""The `certify` command: the bat test, measured or simulated, and a league's rules."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

from cyclopts import Parameter

from sweetspot.cli.options import Format
from sweetspot.errors import InputError

if TYPE_CHECKING:
    from rich.table import Table

    from sweetspot.ball import Ball
    from sweetspot.bat import Bat
    from sweetspot.certification import BatTest, Certification
    from sweetspot.rigid import RigidBody
    from sweetspot.rules import Check
    from sweetspot.shot_statistics import Estimate, Measured
    from sweetspot.shots import Shots

ALL = "all"


def certify(
    bat: Annotated[str | None, Parameter(help="Name in the catalogue (see `sweetspot bats`) or a TOML file.")] = None,
    /,
    *,
    league: Annotated[str, Parameter(help="League of the catalogue, or all that use the ball.")] = "ncaa",
    shots: Annotated[
        Path | None, Parameter(help="CSV file of measured shots; without it the test is computed.")
    ] = None,
    ball: Annotated[str | None, Parameter(help="Ball of the catalogue; default: the league's.")] = None,
    standard_ball_cor: Annotated[
        str | None, Parameter(help="Restitution that shots are normalised to; default: the ball's at 60 mph.")
    ] = None,
    format: Annotated[Format, Parameter(name="--format", help="table for people, json or csv for programs.")] = "table",
) -> int:
    """Test a bat: BBCOR, BESR, BPF and a league's rules, with margin. Exit 1 when a rule fails."""
    from sweetspot import catalog
    from sweetspot.cli.output import patience, print_json, print_rows_csv, print_table
    from sweetspot.line import reduce
    from sweetspot.report.border import bat_json, cleaned
    from sweetspot.report.certification import check_json, simulated_json
    from sweetspot.rigid import rigid_body
    from sweetspot.rules import Verdict, check_rules, construction_findings

    if bat is None:
        raise InputError("certify needs a bat: BBCOR takes the recoil from its weight, balance and moment of inertia")
    if standard_ball_cor is not None and shots is None:
        raise InputError("--standard-ball-cor normalises measured shots; give them with --shots")
    described = catalog.load_bat(bat)
    leagues, chosen = _leagues(league, ball)
    body = rigid_body(reduce(described))
    result: dict[str, Any] = {"bat": bat_json(described.name, described.length, body), "ball": chosen.name}
    table: Callable[[], Any]
    if shots is None:
        from sweetspot.certification import certify as simulate

        with patience():
            done = simulate(described, ball=chosen)
        findings, table = done.findings(), partial(simulated_table, done)
        result["test"] = simulated_json(done)
    else:
        read, measured = _measured(shots, described, body=body, ball=chosen, standard=standard_ball_cor)
        findings, table = measured.findings(), partial(measured_table, measured, read, length=described.length)
        result["shots"] = measured_json(measured, read)
    findings = {**construction_findings(described, body=body), **findings}
    checks = [(one.key, check) for one in leagues for check in check_rules(one, bat=described, findings=findings)]
    failed = any(check.verdict is Verdict.FAIL for _, check in checks)
    result |= {"checks": [check_json(key, check) for key, check in checks], "passed": not failed}
    if format == "json":
        print_json(cleaned(result))
    elif format == "csv":
        print_rows_csv(result["checks"])
    else:
        print_table(table())
        print_table("")
        print_table(checks_table(checks, described.name))
    return 1 if failed else 0


def _leagues(name: str, ball_name: str | None) -> tuple[list[Any], Ball]:
    """Return the leagues asked for and the ball; ``all`` means every league that uses the ball."""
    from sweetspot import catalog
    from sweetspot.catalog.rules import league, league_names

    if name.strip().lower() == ALL:
        ball_name = ball_name or catalog.balls.DEFAULT_BALL
        sport = catalog.ball(ball_name)
        using = [one for one in map(league, league_names()) if catalog.ball(one.ball) == sport]
        if not using:
            raise InputError(f"no league's rules name the ball {ball_name!r}; give one league with --league NAME")
        return using, sport
    one = league(name)
    return [one], catalog.ball(ball_name or one.ball)


def _measured(path: Path, bat: Bat, *, body: RigidBody, ball: Ball, standard: str | None) -> tuple[Shots, Measured]:
    from sweetspot.shot_statistics import measure
    from sweetspot.shots import read_shots
    from sweetspot.units import parse

    read = read_shots(path, length=bat.length)
    wanted = None if standard is None else parse(standard, "ratio", "--standard-ball-cor")
    return read, measure(read.shots, bat=bat, body=body, ball=ball, standard_restitution=wanted)


def measured_json(measured: Measured, read: Shots) -> dict[str, Any]:
    """Return what the shots say, with the rows that were not used and why."""
    from dataclasses import asdict

    def plain(found: Estimate | None) -> dict[str, Any] | None:
        return None if found is None else asdict(found)

    speed = asdict(measured.batted_ball_speed)
    return {
        "good_rows": len(read.shots),
        "bad_rows": [asdict(row) for row in read.bad_rows],
        "ignored_columns": read.ignored_columns,
        "places": [
            {"position_m": place.position, "count": place.count, "bbcor": place.bbcor} for place in measured.places
        ],
        "best_position_m": measured.best_position,
        "rows": measured.rows,
        "bbcor": plain(measured.bbcor),
        "raw_bbcor": plain(measured.raw_bbcor),
        "standard_ball_cor": measured.standard_restitution,
        "collision_efficiency": plain(measured.efficiency),
        "besr": measured.efficiency.mean + 0.5,
        "bpf": plain(measured.bpf),
        "batted_ball_speed": {f"{name}_m_s" if name != "count" else name: value for name, value in speed.items()},
        "outliers": [asdict(outlier) for outlier in measured.outliers],
        "bbcor_without_outliers": plain(measured.without_outliers),
        "slowest_closing_speed_m_s": measured.slowest,
        "fastest_closing_speed_m_s": measured.fastest,
        "ball_stiffness_n_m": measured.ball_stiffness,
        "notes": measured.notes,
    }


def simulated_table(done: Certification) -> Table:
    """Return the simulated test for a terminal."""
    from sweetspot.report.table import names_table
    from sweetspot.units import MPH

    fast, slow, length = done.fast, done.slow, done.bat.length
    rows = [
        ("BBCOR", f"{done.bbcor:.4f}", _place(fast, length),
         f"ball at {fast.closing_speed / MPH:.0f} mph, best of {len(fast.position)} places"),
        ("collision efficiency q", f"{fast.best_efficiency:.4f}", _place(fast, length), "there"),
        ("BESR", f"{done.besr:.4f}", _place(fast, length), "q + 1/2"),
        ("BPF", f"{done.bpf:.3f}", _place(slow, length),
         f"ball at {slow.closing_speed / MPH:.0f} mph, whose own restitution is {slow.ball_restitution:.4f}"),
        ("batted-ball speed", f"{done.batted_ball_speed / MPH:.1f} mph", _place(fast, length),
         "70 mph ball, 66 mph bat"),
        ("MOI about 6 in", f"{_ounces(done.body):.0f} oz in^2", "", "the clamp's axis"),
    ]  # fmt: skip
    shown = [dict(zip(("measure", "value", "in from tip", "test"), row, strict=True)) for row in rows]
    return names_table(shown, f"Simulated test: {done.bat.name}, {done.ball.name}")


def _place(test: BatTest, length: float) -> str:
    from sweetspot.units import INCH

    return f"{(length - test.best_position) / INCH:.2f}{' (end of scan)' if test.at_edge else ''}"


def _ounces(body: RigidBody) -> float:
    from sweetspot.certification import CLAMP
    from sweetspot.units import OUNCE_INCH_SQUARED

    return body.moi(CLAMP) / OUNCE_INCH_SQUARED


def measured_table(measured: Measured, read: Shots, *, length: float) -> Any:
    """Return what the shots say for a terminal: measures, places, hits that stand out, rows not used, notes."""
    from rich.console import Group
    from rich.text import Text

    from sweetspot.report.table import names_table
    from sweetspot.units import INCH, MPH

    def row(name: str, found: Estimate, digits: int = 4, scale: float = 1.0, unit: str = "") -> dict[str, Any]:
        numbers = [f"{value / scale:.{digits}f}" for value in (found.mean, found.standard_error, found.low, found.high)]
        mean, error, low, high = numbers
        return {"measure": name, "mean": mean + unit, "standard error": error, "95 % interval": f"{low} to {high}"}

    raw = measured.standard_restitution is None
    rows = [row("BBCOR, as measured" if raw else "BBCOR, normalised", measured.bbcor)]
    if not raw:
        rows.append(row("BBCOR, as measured", measured.raw_bbcor))
    if measured.without_outliers is not None:
        rows.append(row("BBCOR without outliers", measured.without_outliers))
    rows.append(row("collision efficiency q", measured.efficiency))
    rows.append(row("batted-ball speed, 70 + 66 mph", measured.batted_ball_speed, 1, MPH, " mph"))
    if measured.bpf is not None:
        rows.append(row("BPF", measured.bpf, 3))
    heading = f"{len(measured.rows)} shots {(length - measured.best_position) / INCH:.2f} in from the tip"
    places = [
        {"in from tip": f"{(length - place.position) / INCH:.2f}", "shots": place.count, "BBCOR": f"{place.bbcor:.4f}"}
        for place in measured.places
    ]
    lines = [f"Row {one.row} stands out: BBCOR {one.bbcor:.4f}, {one.deviation:+.1f} robust standard deviations from "
             "the median. It is counted." for one in measured.outliers]  # fmt: skip
    lines += [f"Row {bad.row} is not used: {bad.reason}." for bad in read.bad_rows]
    if read.ignored_columns:
        lines.append(f"Columns not used: {', '.join(read.ignored_columns)}.")
    lines += measured.notes
    return Group(names_table(rows, heading), Text(), names_table(places, "Places"), Text(), *map(Text, lines))


def checks_table(checks: list[tuple[str, Check]], name: str) -> Any:
    """Return the rules for a terminal, and below them why a rule is not a plain pass or fail."""
    from rich.console import Group
    from rich.text import Text

    from sweetspot.report.table import names_table
    from sweetspot.rules import title

    rows = []
    for league, check in checks:
        rule = check.rule
        reading = "" if rule.reading == "primary" else f", {rule.reading}"
        rows.append(
            {
                "league": league,
                "rule": title(rule),
                "verdict": check.verdict.value,
                "value": _shown(rule.quantity, check.value),
                "limit": _limit(check),
                "margin": _shown(rule.quantity, check.margin, sign="+"),
                "source": f"{rule.source} {rule.year or ''}".strip() + reading,
            }
        )
    reasons = [
        f"{league}, {title(check.rule)}: {check.verdict.value}: {check.reason}."
        for league, check in checks
        if check.reason
    ]
    return Group(names_table(rows, f"Rules: {name}"), Text(), *map(Text, reasons))


def _limit(check: Check) -> str:
    rule = check.rule
    if rule.quantity == "solid_wood":
        return "yes"
    sides = [("at least ", rule.least), ("at most ", rule.most)]
    return " ".join(word + _shown(rule.quantity, side) for word, side in sides if side is not None)


def _shown(quantity: str, value: float | None, sign: str = "") -> str:
    """Return a value in the unit that people use for it."""
    from sweetspot.rules import QUANTITIES
    from sweetspot.units import INCH, MPH, OUNCE_INCH_SQUARED

    if value is None:
        return ""
    unit = QUANTITIES[quantity][1]
    if unit == "yes or no":
        return "yes" if value else "no"
    scale, digits, label = {
        "m": (INCH, 3, " in"),
        "m/s": (MPH, 1, " mph"),
        "kg m^2": (OUNCE_INCH_SQUARED, 0, " oz in^2"),
        "in - oz": (1.0, 2, ""),
    }.get(unit, (1.0, 4, ""))
    return f"{value / scale:{sign}z.{digits}f}{label}"

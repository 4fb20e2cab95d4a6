"""`sweetspot fly`: a flight alone, and tables of flights."""

from __future__ import annotations

import sys
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, Literal

from cyclopts import Parameter

from sweetspot.cli.options import Format
from sweetspot.cli.weather import AirOptions, park_of
from sweetspot.errors import InputError

if TYPE_CHECKING:
    from sweetspot.aerodynamics import Aerodynamics
    from sweetspot.ball import Ball
    from sweetspot.flight.what_if import BattedBall, Varied
    from sweetspot.report.speech import Speech
    from sweetspot.units import Kind

    Flying = tuple[Ball, Aerodynamics]

DEFAULT_AIR = AirOptions()
MOST_VALUES = 100
KINDS: dict[str, Kind] = {
    "exit_speed": "speed", "launch_angle": "angle", "spray": "angle", "backspin": "angular speed",
    "sidespin": "angular speed", "gyrospin": "angular speed", "height": "length", "forward": "length",
    "temperature": "temperature", "humidity": "ratio", "pressure": "pressure", "elevation": "length",
    "wind_speed": "speed", "wind_direction": "angle", "wind_exponent": "ratio", "calm_below": "length",
}  # fmt: skip
"""Every number of a hit and its weather, and the kind of quantity."""


@Parameter(name="*", allow_leading_hyphen=True)
@dataclass(frozen=True)
class LaunchOptions:
    """How the ball leaves; every quantity takes a unit, and one or two may be ranges such as 90mph:110mph:5."""

    exit_speed: Annotated[str, Parameter(help="Speed of the ball as it leaves: 100mph.")] = "100mph"
    launch_angle: Annotated[str, Parameter(help="Above the level: 28deg.")] = "28deg"
    spray: Annotated[str, Parameter(help="Direction from centre field, positive to right field: -20deg.")] = "0deg"
    backspin: Annotated[str | None, Parameter(help="2500rpm; default: what hits like this usually have.")] = None
    sidespin: Annotated[
        str | None, Parameter(help="Positive bends the path to the left; default: what hits like this usually have.")
    ] = None
    gyrospin: Annotated[str, Parameter(help="About the direction of motion; it pushes the ball nowhere.")] = "0rpm"
    height: Annotated[str, Parameter(help="Of contact above the ground.")] = "3ft"
    forward: Annotated[str, Parameter(help="Of contact in front of the plate's tip.")] = "2ft"
    bats: Annotated[Literal["right", "left"], Parameter(help="Side the batter bats from, for the usual spin.")] = (
        "right"
    )
    ball: Annotated[str, Parameter(help="Ball of the catalogue; its sport's drag and lift are taken.")] = "baseball"


DEFAULT_LAUNCH = LaunchOptions()


def fly(
    *,
    launch: LaunchOptions = DEFAULT_LAUNCH,
    air: AirOptions = DEFAULT_AIR,
    cell: Annotated[
        Literal["carry", "hang-time", "apex", "landing-angle", "landing-speed"],
        Parameter(help="What the cells of a table show."),
    ] = "carry",
    out: Annotated[Path | None, Parameter(help="Folder for fly.png, fly.svg and fly.json.")] = None,
    format: Annotated[Format, Parameter(name="--format", help="table for people, json or csv for programs.")] = "table",
) -> None:
    """Say how far a hit ball carries. Any one or two options may be ranges (from:to:count); the answer is a table."""
    from sweetspot.flight.what_if import VARIATIONS, BattedBall

    values: dict[str, Any] = {}
    ranges: list[Varied] = []
    for name, text in _texts(launch, air).items():
        varied = next((known for known in VARIATIONS if known == name), None)
        if ":" in text and varied is not None:
            ranges.append((varied, _range(name, text)))
        else:
            values[name] = _number(name, text)
    for name, spread in ranges:
        values[name] = spread[0]
    hit, flying = BattedBall(**values, bats=launch.bats), _flying(launch.ball)
    if not ranges:
        _single(hit, air, flying, out, format, said=_court(launch.ball))
    elif out is not None or len(ranges) > 2:
        named = " and ".join(_option(name) for name, _ in ranges)
        raise InputError(
            f"{named} were given as ranges; a table has rows and columns, so at most two options can be ranges, and it "
            "makes no picture, so leave --out away"
        )
    else:
        _table(hit, ranges, cell, flying, format)


def _texts(launch: LaunchOptions, air: AirOptions) -> dict[str, str]:
    """Return every option that was given or has a default, by the name that a `BattedBall` has for it."""
    from sweetspot.catalog import ball_sport

    found: dict[str, str | None] = {
        name: getattr(launch, name)
        for name in ("exit_speed", "launch_angle", "spray", "backspin", "sidespin", "gyrospin", "height", "forward")
    }
    if ball_sport(launch.ball) != "baseball":  # the usual spin is that of batted baseballs
        found |= {name: found[name] or "0rpm" for name in ("backspin", "sidespin")}
    for name in ("temperature", "humidity", "pressure", "wind_speed", "wind_direction", "calm_below"):
        found[name] = getattr(air, name)
    park = park_of(air)
    found["wind_exponent"] = air.wind_profile
    found["elevation"] = air.elevation or f"{0.0 if park is None else park.elevation!r} m"
    return {name: text for name, text in found.items() if text is not None}


def _option(name: str) -> str:
    return "--wind-profile" if name == "wind_exponent" else f"--{name.replace('_', '-')}"


def _number(name: str, text: str) -> float:
    from sweetspot.units import parse

    return parse(text, KINDS[name], _option(name))


def _range(name: str, text: str) -> tuple[float, ...]:
    """Return the values of a range written as ``90mph:110mph:5``: from, to, and how many."""
    parts = text.split(":")
    if len(parts) != 3:
        raise InputError(
            f"{_option(name)} was given as {text!r}; a range is from, to and how many values: 90mph:110mph:5"
        )
    first, last, count = parts
    if not count.strip().isdecimal() or not 1 <= int(count) <= MOST_VALUES:
        raise InputError(f"{_option(name)} asks for {count!r} values; allowed is 1 to {MOST_VALUES}")
    low, high, steps = _number(name, first), _number(name, last), max(int(count) - 1, 1)
    return tuple(low + (high - low) * step / steps for step in range(int(count)))


def _flying(name: str) -> Flying:
    """Return a ball and how the air pushes it."""
    from sweetspot import catalog

    return catalog.ball(name), catalog.aerodynamics(catalog.sport(catalog.ball_sport(name)).aerodynamics)


def _court(ball_name: str) -> Speech | None:
    """Return how the ball's sport speaks of its flights; None for baseball, which has parks."""
    from sweetspot.catalog import ball_sport
    from sweetspot.report.speech import speech

    said = speech(ball_sport(ball_name))
    return None if said.sport.key == "baseball" else said


def _single(
    hit: BattedBall, air: AirOptions, flying: Flying, out: Path | None, format: Format, *, said: Speech | None
) -> None:
    from sweetspot.cli.output import print_csv, print_json, print_table
    from sweetspot.report.fly import FlyReport, fly_json, fly_table, write_fly

    report = FlyReport.of(
        hit, ball=flying[0], aerodynamics=flying[1], park=park_of(air), own_elevation=air.elevation is None
    )
    if format == "json":
        from sweetspot.report.court import court_json

        court = {} if said is None else {"court": court_json(report.flight, said, ball=flying[0])}
        print_json({**fly_json(report), **court})
    elif format == "csv":
        print_csv(fly_json(report)["path"])
    else:
        print_table(fly_table(report))
        if said is not None:
            from sweetspot.report.court import court_words

            print_table(f"\n{said.sport.name}: {court_words(report.flight, said, ball=flying[0])}")
    if out is not None:
        print("sweetspot: wrote " + ", ".join(str(path) for path in write_fly(report, out)), file=sys.stderr)


def _table(hit: BattedBall, ranges: list[Varied], cell: str, flying: Flying, format: Format) -> None:
    from sweetspot.cli.output import patience, print_json, print_rows_csv, print_table
    from sweetspot.flight.what_if import flight_table
    from sweetspot.report.fly_table import fly_table_json, fly_table_rows, shown_fly_table

    with patience():
        table = flight_table(
            hit, rows=ranges[0], columns=ranges[1] if len(ranges) > 1 else None, ball=flying[0],
            aerodynamics=flying[1],
        )  # fmt: skip
    if format == "json":
        print_json(fly_table_json(table))
    elif format == "csv":
        print_rows_csv(fly_table_rows(table))
    else:
        print_table(shown_fly_table(table, cell.replace("-", "_")))

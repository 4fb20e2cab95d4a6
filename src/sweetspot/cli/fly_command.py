"""`sweetspot fly`: a flight alone, and tables of flights."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Annotated, Any, Literal

from cyclopts import Parameter

from sweetspot.cli.options.output import DEFAULT_OUTPUT, OutputOptions
from sweetspot.cli.options.ranges import spread
from sweetspot.cli.options.uncertainty import Uncertainty
from sweetspot.cli.options.unused import refuse_unused
from sweetspot.cli.options.weather import DEFAULT_AIR, AirOptions, check_wind, park_of, pressure_of
from sweetspot.cli.options.written_errors import error_of, without_error
from sweetspot.errors import InputError

if TYPE_CHECKING:
    from sweetspot.flight.aerodynamics import Aerodynamics
    from sweetspot.flight.sweep import BattedBall, Varied
    from sweetspot.report.document import Document
    from sweetspot.uncertainty.sources import Sources
    from sweetspot.units import Kind

KINDS: dict[str, Kind] = {
    "exit_speed": "speed", "launch_angle": "angle", "spray": "angle", "bearing": "angle", "backspin": "angular speed",
    "sidespin": "angular speed", "gyrospin": "angular speed", "height": "length", "forward": "length",
    "temperature": "temperature", "humidity": "ratio", "pressure": "pressure", "elevation": "length",
    "wind_speed": "speed", "wind_direction": "wind direction", "wind_exponent": "ratio", "calm_below": "length",
}  # fmt: skip
"""Every number of a hit and its weather, and the kind of quantity."""


@Parameter(name="*", allow_leading_hyphen=True)
@dataclass(frozen=True)
class LaunchOptions:
    """How the ball leaves; every quantity takes a unit, and one or two may be ranges such as 90mph:110mph:5."""

    exit_speed: Annotated[str, Parameter(help="Speed of the ball as it leaves: 100mph.")] = "100mph"
    launch_angle: Annotated[str, Parameter(help="Above the level: 28deg.")] = "28deg"
    spray: Annotated[
        str | None,
        Parameter(help="Direction off the bat, from centre field, positive to right field: -20deg; default: 0deg."),
    ] = None
    bearing: Annotated[
        str | None,
        Parameter(help="Direction of where it comes down, as tracked tables have it; in the place of --spray."),
    ] = None
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
    law: Annotated[
        str | None, Parameter(help="Another law of drag and lift, such as trajectory-calculator; default: the sport's.")
    ] = None


DEFAULT_LAUNCH = LaunchOptions()
CELL: Literal["carry"] = "carry"
WITH_ERRORS = ("exit_speed", "launch_angle")
"""What may be written with an error, 100mph±1mph."""


def fly(
    *,
    launch: LaunchOptions = DEFAULT_LAUNCH,
    air: AirOptions = DEFAULT_AIR,
    cell: Annotated[
        Literal["carry", "hang-time", "apex", "landing-angle", "landing-speed"],
        Parameter(help="What the cells of a table show."),
    ] = CELL,
    uncertainty: Uncertainty = False,
    output: OutputOptions = DEFAULT_OUTPUT,
) -> int:
    """Say how far a hit ball carries. Any one or two options may be ranges (from:to:count); the answer is a table."""
    from sweetspot.catalog import ball_sport
    from sweetspot.catalog.aerodynamic_laws import DEFAULT_AERODYNAMICS, usual_spin_line
    from sweetspot.cli.output import present
    from sweetspot.flight.sweep import VARIATIONS, BattedBall
    from sweetspot.plausibility import check

    game = ball_sport(launch.ball)
    values: dict[str, Any] = {}
    ranges: list[Varied] = []
    for name, text in _texts(launch, air).items():
        varied = next((known for known in VARIATIONS if known == name), None)
        if ":" in text and varied is not None:
            ranges.append((varied, spread(text, KINDS[name], _option(name), sport=game)))
        else:
            values[name] = (
                pressure_of(air)
                if name == "pressure" and ":" not in (air.elevation or "")
                else _number(name, text, game)
            )
    for name, values_of in ranges:
        values[name] = values_of[0]
    for height in [values["height"], *(at for name, row in ranges if name == "height" for at in row)]:
        check(height, "--height", launch.height, quantity="launch_height")
    hit = BattedBall(**values, bats=launch.bats, line=usual_spin_line(launch.law or DEFAULT_AERODYNAMICS))
    if len(ranges) > 2:
        named = " and ".join(_option(name) for name, _ in ranges)
        raise InputError(
            f"{named} were given as ranges; a table has rows and columns, so at most two options can be ranges"
        )
    if not ranges and cell != CELL:
        refuse_unused(["--cell"], "a table", "give a range, for example --launch-angle 10deg:40deg:7")
    if uncertainty and ranges:
        raise InputError("--uncertainty is told of one flight; leave it out, or leave out the ranges")
    document = _table(hit, ranges, cell, launch, air) if ranges else _single(hit, air, launch, sure=uncertainty)
    return present(document, output)


def _texts(launch: LaunchOptions, air: AirOptions) -> dict[str, str]:
    """Return every option that was given or has a default, by the name that a `BattedBall` has for it."""
    from sweetspot.catalog import ball_sport

    options: dict[str, str | None] = {
        name: getattr(launch, name)
        for name in ("exit_speed", "launch_angle", "spray", "bearing", "backspin", "sidespin", "gyrospin", "height",
                     "forward")
    }  # fmt: skip
    if launch.spray is not None and launch.bearing is not None:
        raise InputError(
            "--spray and --bearing were both given; give --spray, the direction off the bat, or --bearing, that of the "
            "place where the ball comes down"
        )
    if ball_sport(launch.ball) != "baseball":  # the usual spin is that of batted baseballs
        options |= {name: options[name] or "0rpm" for name in ("backspin", "sidespin")}
    for name in ("temperature", "humidity", "pressure", "wind_speed", "wind_direction", "calm_below"):
        options[name] = getattr(air, name)
    check_wind(air)
    park = park_of(air)
    options["wind_exponent"] = air.wind_profile
    options["elevation"] = air.elevation or f"{0.0 if park is None else park.elevation!r} m"
    return {name: text for name, text in options.items() if text is not None}


def _option(name: str) -> str:
    return "--wind-profile" if name == "wind_exponent" else f"--{name.replace('_', '-')}"


def _number(name: str, text: str, sport: str) -> float:
    from sweetspot.plausibility import parse

    return parse(without_error(text) if name in WITH_ERRORS else text, KINDS[name], _option(name), sport=sport)


def _law(launch: LaunchOptions) -> Aerodynamics:
    from sweetspot import catalog

    return catalog.aerodynamics(launch.law) if launch.law else catalog.aerodynamics_of_ball(launch.ball)


def _single(hit: BattedBall, air: AirOptions, launch: LaunchOptions, *, sure: bool) -> Document:
    from sweetspot import catalog
    from sweetspot.answers.fly import FlyQuestion, fly_answer
    from sweetspot.report.flight.document import fly_document

    question = FlyQuestion(
        hit,
        ball=catalog.ball(launch.ball),
        sport=catalog.sport(catalog.ball_sport(launch.ball)),
        aerodynamics=_law(launch),
        park=park_of(air),
        own_elevation=air.elevation is None,
        sources=_sources(launch, air) if sure else None,
    )
    return fly_document(fly_answer(question))


def _sources(launch: LaunchOptions, air: AirOptions) -> Sources:
    """Return what is not known of the flight: its drag, and what was written with an error."""
    from sweetspot import catalog
    from sweetspot.answers.flight_draws import flight_sources

    speed, angle = (
        error_of(None if text == getattr(DEFAULT_LAUNCH, name) else text, KINDS[name], _option(name))
        for name, text in ((name, getattr(launch, name)) for name in WITH_ERRORS)
    )
    law = catalog.aerodynamics_in(park_of(air), _law(launch))
    return flight_sources(law, speed_error=speed, angle_error=angle)


def _table(hit: BattedBall, ranges: list[Varied], cell: str, launch: LaunchOptions, air: AirOptions) -> Document:
    from sweetspot import catalog
    from sweetspot.cli.output import patience
    from sweetspot.flight.sweep import flight_table
    from sweetspot.report.flight.sweep import sweep_document

    with patience():
        table = flight_table(
            hit, rows=ranges[0], columns=ranges[1] if len(ranges) > 1 else None, ball=catalog.ball(launch.ball),
            aerodynamics=catalog.aerodynamics_in(park_of(air), _law(launch)),
        )  # fmt: skip
    return sweep_document(table, cell.replace("-", "_"))

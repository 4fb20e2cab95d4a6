"""`sweetspot fly`: a flight alone, and tables of flights."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Annotated, Literal, TypeVar

from cyclopts import Parameter

from sweetspot.cli.options.output import DEFAULT_OUTPUT, OutputOptions
from sweetspot.cli.options.reading import Uncertainty, option, read, refuse_unused, spread
from sweetspot.cli.options.weather import DEFAULT_AIR, AirOptions
from sweetspot.errors import InputError

if TYPE_CHECKING:
    from sweetspot.flight.sweep import Varied


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
    ball: Annotated[
        str, Parameter(help="Ball of the catalogue, or a TOML file; its sport's drag and lift are taken.")
    ] = "baseball"
    law: Annotated[
        str | None, Parameter(help="Another law of drag and lift, such as trajectory-calculator; default: the sport's.")
    ] = None


DEFAULT_LAUNCH = LaunchOptions()
CELL: Literal["carry"] = "carry"
Options = TypeVar("Options", LaunchOptions, AirOptions)


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
    from sweetspot.answers.ask_flight import fly as asked
    from sweetspot.answers.ask_flight import fly_table
    from sweetspot.answers.flight_setups import LaunchSetup
    from sweetspot.answers.setups import Owner
    from sweetspot.catalog import ball_sport
    from sweetspot.cli.options.weather import setup_of
    from sweetspot.cli.output import present
    from sweetspot.plausibility import check

    if launch.spray is not None and launch.bearing is not None:
        raise InputError(
            "--spray and --bearing were both given; give --spray, the direction off the bat, or --bearing, that of the "
            "place where the ball comes down"
        )
    game = ball_sport(launch.ball)
    ranges = [*_ranges(launch, game), *_ranges(air, game)]
    if len(ranges) > 2:
        named = " and ".join(option(name) for name, _ in ranges)
        raise InputError(
            f"{named} were given as ranges; a table has rows and columns, so at most two options can be ranges"
        )
    if not ranges and cell != CELL:
        refuse_unused(["--cell"], "a table", "give a range, for example --launch-angle 10deg:40deg:7")
    if uncertainty and ranges:
        raise InputError("--uncertainty applies to one flight; leave it out, or leave out the ranges")
    asked_of = read(LaunchSetup, _without(ranges, launch), of=Owner(sport=game), errors=uncertainty)
    for height in [asked_of.height, *(value for name, values in ranges if name == "height" for value in values)]:
        check(height, "--height", launch.height, quantity="launch_height")
    weather = setup_of(_without(ranges, air))
    if not ranges:
        return present(asked(launch=asked_of, weather=weather, uncertainty=uncertainty), output)
    table = fly_table(dict(ranges), launch=asked_of, weather=weather, show=cell.replace("-", "_"))  # type: ignore[arg-type]
    return present(table, output)


def _ranges(options: LaunchOptions | AirOptions, sport: str) -> list[Varied]:
    """Return the options of a group that are ranges, with their values."""
    from sweetspot.flight.sweep import VARIATIONS
    from sweetspot.units.quantities import KIND_OF

    ranges: list[Varied] = []
    for name in VARIATIONS:
        text = getattr(options, name, None)
        if text is not None and ":" in text:
            values = spread(text, KIND_OF[name], option(name), sport=sport)
            ranges.append((name, values))
    return ranges


def _without(ranges: list[Varied], options: Options) -> Options:
    """Return a group with the options that are ranges as they are by default."""
    default = type(options)()
    usual = {name: getattr(default, name) for name, _ in ranges if hasattr(default, name)}
    return replace(options, **usual)

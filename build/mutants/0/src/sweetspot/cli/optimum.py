"""The command `optimum`: how to swing, how high to send the ball, and where a park is easiest to leave."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Annotated, Any, Literal

from cyclopts import Parameter

from sweetspot.cli.options import Format, SwingOptions
from sweetspot.cli.weather import AirOptions
from sweetspot.errors import InputError

if TYPE_CHECKING:
    from sweetspot.air import Air
    from sweetspot.park import Park

ALL = "all"
FAST_AND_SLOW = ("fastball", "curve")
SPEEDS = ("90mph", "100mph", "110mph")


@Parameter(name="*")
@dataclass(frozen=True)
class ContactOptions:
    """The bat's motion and what of the contact is not searched."""

    bat_speed: Annotated[str, Parameter(help="Speed of the bat before impact at --bat-speed-at.")] = "70mph"
    bat_speed_at: Annotated[str, Parameter(help="Where the bat speed is measured.")] = "6in-from-tip"
    pivot: Annotated[
        str | None, Parameter(help="Axis the bat turns about, from the knob end; default: the bottom of the grip.")
    ] = None
    at: Annotated[str | None, Parameter(help="Hit with this place of the bat; default: the best one is searched.")] = (
        None
    )
    attack_angle: Annotated[str | None, Parameter(help="Swing this steeply; default: the best is searched.")] = None
    tilt: Annotated[str, Parameter(help="Of the plane of the swing; 0deg keeps the bat level.")] = "32deg"
    ball: Annotated[str, Parameter(help="Ball of the catalogue.")] = "baseball"


DEFAULT_CONTACT = ContactOptions()
DEFAULT_AIR = AirOptions()


def optimum(
    bat: Annotated[str, Parameter(help="Name in the catalogue (see `sweetspot bats`) or a TOML file.")] = "r161-ash",
    /,
    *,
    pitch: Annotated[
        tuple[str, ...], Parameter(help="Pitches by name or letters; may be given again.", negative="")
    ] = (FAST_AND_SLOW),
    release_speed: Annotated[str | None, Parameter(help="Throw them all this fast; default: as is usual.")] = None,
    contact: ContactOptions = DEFAULT_CONTACT,
    exit_speed: Annotated[
        tuple[str, ...], Parameter(help="For the best launch angle; may be given again.", negative="")
    ] = SPEEDS,
    backspin: Annotated[str, Parameter(help="Of the ball in the last two questions.")] = "2200rpm",
    air: AirOptions = DEFAULT_AIR,
    show: Annotated[
        Literal["all", "swing", "launch", "parks"],
        Parameter(help="One of the three questions only; csv answers one, swing unless said; parks: --park all."),
    ] = "all",
    format: Annotated[Format, Parameter(name="--format", help="table for people, json or csv for programs.")] = "table",
) -> None:
    """Find the swing and the launch angle that carry farthest, and with --park (or --park all) the slowest home run."""
    from sweetspot import catalog
    from sweetspot.cli.output import patience, print_json, print_rows_csv, print_table
    from sweetspot.report import optimum as tables

    everywhere = air.park == ALL or (show == "parks" and air.park is None)
    weather = replace(air, park=None) if everywhere else air
    asked: tuple[str, ...] = ("swing", "launch", "parks") if show == "all" else (show,)
    if format == "csv":
        asked = asked[:1]
    described = catalog.load_bat(bat)
    found: dict[str, list[dict[str, Any]]] = {}
    with patience():
        if "swing" in asked:
            found["swings"] = _swings(bat, pitch, release_speed, contact, weather)
        if "launch" in asked:
            found["launches"] = _launches(exit_speed, backspin, contact.ball, weather)
        if "parks" in asked and (everywhere or air.park is not None):
            found["parks"] = _parks(backspin, contact.ball, weather, everywhere=everywhere)
    if format == "json":
        print_json({"bat": described.name, **found})
    elif format == "csv":
        print_rows_csv(next(iter(found.values())))
    else:
        if "swings" in found:
            print_table(tables.swings_table(found["swings"], length=described.length))
        if "launches" in found:
            print_table(tables.launches_table(found["launches"]))
        if "parks" in found:
            print_table(tables.parks_table(found["parks"]))


def _swings(
    bat: str, pitches: tuple[str, ...], release_speed: str | None, contact: ContactOptions, weather: AirOptions
) -> list[dict[str, Any]]:
    from sweetspot import catalog
    from sweetspot.cli.options import conditions_for
    from sweetspot.cli.pitching import pitched
    from sweetspot.cli.weather import air_of, wind_of
    from sweetspot.implement import check_position
    from sweetspot.optimum import best_swing
    from sweetspot.reduction import reduction
    from sweetspot.report.optimum import swing_row
    from sweetspot.units import parse, parse_position

    described = catalog.load_bat(bat)
    told = SwingOptions(
        bat_speed=contact.bat_speed, bat_speed_at=contact.bat_speed_at, pivot=contact.pivot, ball=contact.ball
    )
    conditions = conditions_for(described, told)
    air, wind = air_of(weather), wind_of(weather)
    position = None if contact.at is None else parse_position(contact.at, length=described.length, what="--at")
    if position is not None:
        check_position(described, position, "--at")
    steep = None if contact.attack_angle is None else parse(contact.attack_angle, "angle", "--attack-angle")
    model = reduction(described, ball=conditions.ball).held(conditions.hands)
    rows = []
    for name in pitches:
        thrown = pitched(name, release_speed, ball=conditions.ball, air=air, wind=wind)
        best = best_swing(
            model, ball=conditions.ball, swing=conditions.swing, pitch=thrown.plate, tilt=parse(contact.tilt, "angle",
            "--tilt"), aerodynamics=catalog.aerodynamics(), air=air, wind=wind, position=position, attack_angle=steep,
        )  # fmt: skip
        rows.append(swing_row(best, thrown))
    return rows


def _launches(speeds: tuple[str, ...], backspin: str, ball: str, weather: AirOptions) -> list[dict[str, Any]]:
    from sweetspot import catalog
    from sweetspot.cli.weather import air_of, wind_of
    from sweetspot.optimum import best_launch
    from sweetspot.report.optimum import launch_row
    from sweetspot.units import parse

    spin = parse(backspin, "angular speed", "--backspin")
    what, law, air, wind = catalog.ball(ball), catalog.aerodynamics(), air_of(weather), wind_of(weather)
    rows = []
    for text in speeds:
        speed = parse(text, "speed", "--exit-speed")
        best = best_launch(speed, backspin=spin, ball=what, aerodynamics=law, air=air, wind=wind)
        rows.append(launch_row(best, exit_speed=speed, backspin=spin))
    return rows


def _parks(backspin: str, ball: str, weather: AirOptions, *, everywhere: bool) -> list[dict[str, Any]]:
    from sweetspot import catalog
    from sweetspot.cli.weather import air_of, park_of, wind_of
    from sweetspot.optimum import easiest_home_run
    from sweetspot.report.optimum import park_row
    from sweetspot.units import parse

    if wind_of(weather).speed > 0:
        raise InputError(
            "--park was given with a wind; the slowest home run is found in still air only, so leave out --wind-speed "
            "or ask with --show swing or --show launch"
        )
    spin = parse(backspin, "angular speed", "--backspin")
    named = park_of(weather)
    parks: list[Park] = list(catalog.parks()) if everywhere or named is None else [named]
    rows = []
    for park in parks:
        here: Air = air_of(weather)
        if everywhere and weather.elevation is None:
            here = here.replaced(elevation=park.elevation)
        best = easiest_home_run(
            park, backspin=spin, ball=catalog.ball(ball), aerodynamics=catalog.aerodynamics(), air=here
        )
        rows.append(park_row(best))
    return rows

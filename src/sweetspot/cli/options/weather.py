"""Options of the air and the field, the same for every command with a flight, and what they become."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Annotated

from cyclopts import Parameter

from sweetspot.cli.options.unused import given, refuse_unused

if TYPE_CHECKING:
    from sweetspot.flight.air import Air, Wind
    from sweetspot.flight.conditions import FlightConditions
    from sweetspot.flight.park import Park


@Parameter(name="*", allow_leading_hyphen=True)
@dataclass(frozen=True)
class WeatherOptions:
    """Weather and elevation; every quantity takes a unit."""

    temperature: Annotated[str, Parameter(help="Of the air: 70degF or 21degC.")] = "70degF"
    humidity: Annotated[str, Parameter(help="Relative humidity as a ratio: 0.5 or 50%.")] = "0.5"
    pressure: Annotated[str, Parameter(help="Barometer, reduced to sea level: 29.92inHg or 1013hPa.")] = "29.92inHg"
    elevation: Annotated[
        str | None, Parameter(help="Of the field above the sea: 5200ft; default: the park's, or 0ft without one.")
    ] = None


@Parameter(name="*", allow_leading_hyphen=True)
@dataclass(frozen=True)
class AirOptions(WeatherOptions):
    """Weather and field; every quantity takes a unit."""

    wind_speed: Annotated[str, Parameter(help="Of the wind: 10mph.")] = "0mph"
    wind_direction: Annotated[
        str,
        Parameter(
            help="Where the wind blows to: out, in, left-to-right, out-to-right-field, in-from-left-field, ... or an "
            "angle: 0deg is out to centre field, 90deg from left to right, 180deg in."
        ),
    ] = "0deg"
    wind_profile: Annotated[
        str, Parameter(help="Exponent of the wind's growth with height, from 10 m: 0 is alike everywhere, 0.14 usual.")
    ] = "0"
    calm_below: Annotated[str, Parameter(help="Height that the stands shelter from the wind: 30ft.")] = "0ft"
    park: Annotated[str | None, Parameter(help="Ballpark whose fence and elevation count (see `sweetspot parks`).")] = (
        None
    )


@Parameter(name="*", allow_leading_hyphen=True)
@dataclass(frozen=True)
class GamesAirOptions(WeatherOptions):
    """Weather of games whose table does not give it; every quantity takes a unit."""

    temperature: Annotated[str, Parameter(help="Of the air, where no column gives it: 72degF.")] = "72degF"
    elevation: Annotated[
        str | None, Parameter(help="Of fields above the sea whose park is not known: 5200ft; default: 0ft.")
    ] = None


DEFAULT_AIR, DEFAULT_GAMES_AIR = AirOptions(), GamesAirOptions()


def park_of(options: AirOptions) -> Park | None:
    """Return the park that the options name, if any."""
    from sweetspot import catalog

    return None if options.park is None else catalog.park(options.park)


def air_of(options: AirOptions) -> Air:
    """Return the air that the options describe."""
    park = park_of(options)
    return weather_of(options, above_sea=0.0 if park is None else park.elevation)


def weather_of(options: WeatherOptions, *, above_sea: float = 0.0) -> Air:
    """Return the air that the options describe, at an elevation (m) where they name none."""
    from sweetspot.flight.air import Air
    from sweetspot.plausibility import parse

    return Air(
        temperature=parse(options.temperature, "temperature", "--temperature"),
        pressure=pressure_of(options),
        humidity=parse(options.humidity, "ratio", "--humidity"),
        elevation=above_sea if options.elevation is None else parse(options.elevation, "length", "--elevation"),
    )


def pressure_of(options: WeatherOptions) -> float:
    """Return the barometer in Pa; where the elevation is said to be 0, one that was read at a high field is allowed."""
    from sweetspot.plausibility import insisted, insisting, parse

    at_the_field = options.elevation is not None and parse(options.elevation, "length", "--elevation") == 0
    with insisting(insisted() or at_the_field):
        return parse(options.pressure, "pressure", "--pressure")


def wind_of(options: AirOptions) -> Wind:
    """Return the wind that the options describe."""
    from sweetspot.flight.air import Wind
    from sweetspot.plausibility import parse

    check_wind(options)
    return Wind(
        speed=parse(options.wind_speed, "speed", "--wind-speed"),
        direction=parse(options.wind_direction, "wind direction", "--wind-direction"),
        exponent=parse(options.wind_profile, "ratio", "--wind-profile"),
        calm_below=parse(options.calm_below, "length", "--calm-below"),
    )


def check_wind(options: AirOptions) -> None:
    """Refuse a wind that is described and has no speed."""
    if not given(options, "wind_speed"):
        described = given(options, "wind_direction", "wind_profile", "calm_below")
        refuse_unused(described, "a wind", "say how fast it blows, as in --wind-speed 10mph")


def through(options: AirOptions, ball: str) -> FlightConditions:
    """Return what a ball of the catalogue flies through: its drag law, the air and the wind."""
    from sweetspot import catalog
    from sweetspot.flight.conditions import FlightConditions

    return FlightConditions(
        ball=catalog.ball(ball),
        aerodynamics=catalog.aerodynamics_in(park_of(options), catalog.aerodynamics_of_ball(ball)),
        air=air_of(options),
        wind=wind_of(options),
    )

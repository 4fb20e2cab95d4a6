"""Options of the air and the field, the same for every command with a flight, and what they become."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Annotated

from cyclopts import Parameter

from sweetspot.cli.options.reading import given, read, refuse_unused

if TYPE_CHECKING:
    from sweetspot.answers.flight_setups import Weather
    from sweetspot.flight.air import Air


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


def setup_of(options: WeatherOptions) -> Weather:
    """Return the weather and the field that the options describe; refuse a wind that has no speed."""
    from sweetspot.answers.flight_setups import Weather
    from sweetspot.plausibility import insisted, insisting, parse

    if isinstance(options, AirOptions) and not given(options, "wind_speed"):
        described = given(options, "wind_direction", "wind_profile", "calm_below")
        refuse_unused(described, "a wind", "say how fast it blows, as in --wind-speed 10mph")
    # a barometer that was read at a high field is allowed where its elevation is said to be 0
    at_the_field = options.elevation is not None and parse(options.elevation, "length", "--elevation") == 0
    with insisting(insisted() or at_the_field):
        return read(Weather, options)


def weather_of(options: WeatherOptions) -> Air:
    """Return the air that the options describe."""
    from sweetspot.plausibility import parse

    weather = setup_of(options)
    return replace(weather, temperature=parse(options.temperature, "temperature", "--temperature")).air


def air_of(options: AirOptions) -> Air:
    """Return the air that the options describe, over their park."""
    return setup_of(options).air

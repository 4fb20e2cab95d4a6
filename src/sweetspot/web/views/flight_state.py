"""The state of the flight view: the ball's launch, from numbers or from a swing; the park, the air and the wind."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import Field

from sweetspot.web.controls import HitState, Name, Offset, Tilt, within


class FlightState(HitState):
    """The ball's launch, from numbers or from a swing; the park, the air and the wind."""

    offset_in: Offset = Field(0.75, description="ball's centre above the bat's axis at impact")
    start: Literal["ball", "swing"] = Field("ball", description="from the ball's own numbers, or from pitch and swing")
    exit_speed_mph: Annotated[float, within("exit_speed", "mph")] = 98.0
    launch_angle_deg: Annotated[float, within("launch_angle", "deg", least=-30, most=80)] = 28.0
    spray_deg: Annotated[float, within("spray", "deg", least=-60, most=60)] = Field(
        -15.0, description="from centre field, positive to right field"
    )
    direction: Literal["launch", "landing"] = Field(
        "launch", description="spray is that off the bat, or of the landing"
    )
    backspin_rpm: Annotated[float, within("backspin", "rpm", least=-5000, most=6000)] = Field(
        2200.0, description="positive lifts the ball"
    )
    sidespin_rpm: Annotated[float, within("sidespin", "rpm", least=-5000, most=5000)] = Field(
        0.0, description="positive bends the path to the left"
    )
    height_ft: Annotated[float, within("launch_height", "ft", least=0.5, most=7)] = Field(
        3.0, description="of the ball at contact"
    )
    attack_angle_deg: Annotated[float, within("attack_angle", "deg", least=-20, most=35)] = Field(
        9.0, description="of the barrel's path above the level"
    )
    attack_direction_deg: Annotated[float, within("attack_direction", "deg", least=-45, most=45)] = Field(
        0.0, description="from centre field, negative to the pull side"
    )
    tilt_deg: Tilt = Field(32.0, description="of the swing's plane; at least the attack angle")
    batter: Literal["right", "left"] = "right"
    pitch_angle_deg: Annotated[float, within("approach_angle", "deg", least=-20, most=5)] = Field(
        -6.0, description="of the pitch at the plate, negative falls"
    )
    pitch_backspin_rpm: Annotated[float, within("pitch_backspin", "rpm", least=-3500, most=3500)] = Field(
        2000.0, description="positive for a fastball"
    )
    park: Name | None = Field(None, description="name, team or its letters; empty: where such bats are swung")
    temperature_degf: Annotated[float, within("temperature", "degF")] = 70.0
    relative_humidity: Annotated[float, within("humidity", "")] = Field(0.5, description="of the air")
    pressure_inhg: Annotated[float, within("pressure", "inHg")] = Field(
        29.92, description="reduced to sea level, as weather reports give it"
    )
    elevation_ft: Annotated[float, within("elevation", "ft")] | None = Field(
        None, description="of the field; empty: the park's"
    )
    wind_speed_mph: Annotated[float, within("wind_speed", "mph")] = 0.0
    wind_direction_deg: Annotated[float, within("wind_direction", "deg", least=-180, most=180)] = Field(
        0.0, description="to where it blows, 0: out to centre field"
    )
    own_elevation: bool = Field(True, description="count parks in the air of each one's elevation")

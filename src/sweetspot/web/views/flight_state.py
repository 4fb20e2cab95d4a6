"""What the flight view asks: how the ball leaves, from numbers or from a swing; the park, the air and the wind."""

from __future__ import annotations

from typing import Literal

from pydantic import Field

from sweetspot.web.states import HitState, Name


class FlightState(HitState):
    """How the ball leaves, from numbers or from a swing; the park, the air and the wind."""

    offset_in: float = Field(0.75, ge=-2.5, le=2.5, description="ball's centre above the bat's axis at impact")
    start: Literal["ball", "swing"] = Field("ball", description="from the ball's own numbers, or from pitch and swing")
    exit_speed_mph: float = Field(98.0, ge=20, le=125)
    launch_angle_deg: float = Field(28.0, ge=-30, le=80)
    spray_deg: float = Field(-15.0, ge=-60, le=60, description="from centre field, positive to right field")
    direction: Literal["launch", "landing"] = Field(
        "launch", description="spray is that off the bat, or of the landing"
    )
    backspin_rpm: float = Field(2200.0, ge=-5000, le=6000, description="positive lifts the ball")
    sidespin_rpm: float = Field(0.0, ge=-5000, le=5000, description="positive bends the path to the left")
    height_ft: float = Field(3.0, ge=0.5, le=7, description="of the ball at contact")
    attack_angle_deg: float = Field(9.0, ge=-20, le=35, description="of the barrel's path above the level")
    attack_direction_deg: float = Field(0.0, ge=-45, le=45, description="from centre field, negative to the pull side")
    tilt_deg: float = Field(32.0, ge=0, le=75, description="of the swing's plane; at least the attack angle")
    batter: Literal["right", "left"] = "right"
    pitch_angle_deg: float = Field(-6.0, ge=-20, le=5, description="of the pitch at the plate, negative falls")
    pitch_backspin_rpm: float = Field(2000.0, ge=-3500, le=3500, description="positive for a fastball")
    park: Name | None = Field(None, description="name, team or its letters; empty: where such bats are swung")
    temperature_degf: float = Field(70.0, ge=0, le=120)
    relative_humidity: float = Field(0.5, ge=0, le=1, description="of the air")
    pressure_inhg: float = Field(29.92, ge=26, le=32, description="reduced to sea level, as weather reports give it")
    elevation_ft: float | None = Field(None, ge=-300, le=12000, description="of the field; empty: the park's")
    wind_speed_mph: float = Field(0.0, ge=0, le=50)
    wind_direction_deg: float = Field(0.0, ge=-180, le=180, description="to where it blows, 0: out to centre field")
    own_elevation: bool = Field(True, description="count parks in the air of each one's elevation")

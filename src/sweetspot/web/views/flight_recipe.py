"""The lines that give the numbers of the flight view without the page."""

from __future__ import annotations

from typing import TYPE_CHECKING

from sweetspot.web.bats import swung
from sweetspot.web.recipes import Ask, Options, bat_source, bat_text, lines_of, number, swing_options

if TYPE_CHECKING:
    from sweetspot.web.views.flight_state import FlightState


def flight_lines(state: FlightState) -> dict[str, str]:
    """Return command line and Python line, and the bat's file where a bat is swung."""
    at = {"height": number(state.height_ft, "ft"), "forward": "2ft"}
    wind, elevation = number(state.wind_speed_mph, "mph"), number(state.elevation_ft, "ft")
    weather: Options = {
        "park": swung(state).park,
        "temperature": number(state.temperature_degf, "degF"),
        "humidity": number(state.relative_humidity),
        "pressure": number(state.pressure_inhg, "inHg"),
        "elevation": elevation,
        "wind_speed": wind,
        "wind_direction": number(state.wind_direction_deg, "deg") if state.wind_speed_mph else None,
    }
    if state.start == "ball":
        return lines_of(Ask("fly", options={**_ball_options(state), **at, **weather}))
    options = {**_contact_options(state), **at, **swing_options(state), **weather}
    return {**lines_of(Ask("play", (bat_source(state),), options)), "toml": bat_text(state)}


def _ball_options(state: FlightState) -> Options:
    ball = swung(state).ball
    return {
        "exit_speed": number(state.exit_speed_mph, "mph"),
        "launch_angle": number(state.launch_angle_deg, "deg"),
        "bearing" if state.direction == "landing" else "spray": number(state.spray_deg, "deg"),
        "backspin": number(state.backspin_rpm, "rpm"),
        "sidespin": number(state.sidespin_rpm, "rpm"),
        "ball": None if ball == "baseball" else ball,
    }


def _contact_options(state: FlightState) -> Options:
    return {
        "at": f"{state.impact_from_tip_in:.12g}in-from-tip",
        "offset": number(state.offset_in, "in"),
        "attack_angle": number(state.attack_angle_deg, "deg"),
        "attack_direction": number(state.attack_direction_deg, "deg"),
        "tilt": number(state.tilt_deg, "deg"),
        "bats": state.batter,
        "approach_angle": number(state.pitch_angle_deg, "deg"),
        "pitch_backspin": number(state.pitch_backspin_rpm, "rpm"),
    }

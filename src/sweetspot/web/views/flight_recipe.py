"""The lines that give the numbers of the flight view without the page."""

from __future__ import annotations

from shlex import quote
from typing import TYPE_CHECKING

from sweetspot.web.bats import swung
from sweetspot.web.recipes import bat_name, bat_text, conditions_lines, swing_options

if TYPE_CHECKING:
    from sweetspot.web.views.flight_state import FlightState


def flight_lines(state: FlightState) -> dict[str, str]:
    """Return command line and Python lines, and the bat's file where a bat is swung."""
    if state.start == "ball":
        return {
            "command": f"sweetspot fly{_ball_options(state)}{_weather_options(state)}",
            "python": _ball_python(state),
        }
    command = f"sweetspot play {bat_name(state)}{_swing_options(state)}{swing_options(state)}{_weather_options(state)}"
    return {"command": command, "python": _swing_python(state), "toml": bat_text(state)}


def _ball_options(state: FlightState) -> str:
    ball = quote(swung(state).ball or "")
    return _options(
        exit_speed=f"{state.exit_speed_mph:.12g}mph",
        launch_angle=f"{state.launch_angle_deg:.12g}deg",
        **{"bearing" if state.direction == "landing" else "spray": f"{state.spray_deg:.12g}deg"},
        backspin=f"{state.backspin_rpm:.12g}rpm",
        sidespin=f"{state.sidespin_rpm:.12g}rpm",
        height=f"{state.height_ft:.12g}ft",
        forward="2ft",
        ball=None if ball == "baseball" else ball,
    )


def _swing_options(state: FlightState) -> str:
    return _options(
        at=f"{state.impact_from_tip_in:.12g}in-from-tip",
        offset=f"{state.offset_in:.12g}in",
        attack_angle=f"{state.attack_angle_deg:.12g}deg",
        attack_direction=f"{state.attack_direction_deg:.12g}deg",
        tilt=f"{state.tilt_deg:.12g}deg",
        bats=state.batter,
        approach_angle=f"{state.pitch_angle_deg:.12g}deg",
        pitch_backspin=f"{state.pitch_backspin_rpm:.12g}rpm",
        height=f"{state.height_ft:.12g}ft",
        forward="2ft",
    )


def _weather_options(state: FlightState) -> str:
    return _options(
        park=quote(swung(state).park or ""),
        temperature=f"{state.temperature_degf:.12g}degF",
        humidity=f"{state.relative_humidity:.12g}",
        pressure=f"{state.pressure_inhg:.12g}inHg",
        elevation=None if state.elevation_ft is None else f"{state.elevation_ft:.12g}ft",
        wind_speed=f"{state.wind_speed_mph:.12g}mph",
        wind_direction=f"{state.wind_direction_deg:.12g}deg" if state.wind_speed_mph else None,
    )


def _options(**texts: str | None) -> str:
    """Return options; an equals sign keeps a negative value from being taken for another option."""
    given = {name.replace("_", "-"): text for name, text in texts.items() if text is not None}
    return "".join(f" --{name}{'=' if text.startswith('-') else ' '}{text}" for name, text in given.items())


def _field_python(state: FlightState) -> str:
    state = swung(state)
    elevation = "park.elevation" if state.elevation_ft is None else f"{state.elevation_ft!r} * FOOT"
    return (
        f"park = catalog.park({state.park!r})\n"
        f"air = Air(temperature=({state.temperature_degf!r} - 32) / 1.8, humidity={state.relative_humidity!r},\n"
        f"          pressure={state.pressure_inhg!r} * 3386.389, elevation={elevation})\n"
        f"wind = Wind(speed={state.wind_speed_mph!r} * MPH, direction=radians({state.wind_direction_deg!r}))\n"
        f"through = FlightConditions(ball=catalog.ball({state.ball!r}),\n"
        f"                           aerodynamics=catalog.aerodynamics_in(park, "
        f"catalog.aerodynamics_of_ball({state.ball!r})),\n"
        "                           air=air, wind=wind)\n"
    )


def _ball_python(state: FlightState) -> str:
    spray, solved = f"radians({state.spray_deg!r})", ""
    if state.direction == "landing":
        solved = (
            "from sweetspot.flight.bearing import launched_to\n\n"
            f"sprays, _ = launched_to(radians({state.spray_deg!r}), exit_speed={state.exit_speed_mph!r} * MPH,\n"
            f"                        launch_angle=radians({state.launch_angle_deg!r}), conditions=through,\n"
            f"                        spins=({state.backspin_rpm!r} * RPM, {state.sidespin_rpm!r} * RPM),\n"
            f"                        position=(0, 2 * FOOT, {state.height_ft!r} * FOOT))\n"
        )
        spray = "float(sprays[0])"
    return (
        "from math import radians\n"
        "from sweetspot import FlightConditions, catalog\n"
        "from sweetspot.flight.air import Air, Wind\n"
        "from sweetspot.flight.fence import landing\n"
        "from sweetspot.flight.trajectory import fly\n"
        "from sweetspot.motion.ball_motion import batted_ball\n"
        "from sweetspot.units import FOOT, MPH, RPM\n\n"
        f"{_field_python(state)}"
        f"{solved}"
        f"motion = batted_ball(speed={state.exit_speed_mph!r} * MPH,\n"
        f"                  launch_angle=radians({state.launch_angle_deg!r}),\n"
        f"                  spray={spray}, backspin={state.backspin_rpm!r} * RPM,\n"
        f"                  sidespin={state.sidespin_rpm!r} * RPM,\n"
        f"                  position=(0, 2 * FOOT, {state.height_ft!r} * FOOT))\n"
        "flight = fly(motion, through)\n"
        "print(flight.carry, flight.hang_time, landing(flight.positions, park))\n"
    )


def _swing_python(state: FlightState) -> str:
    return conditions_lines(state) + (
        "\nfrom math import pi, radians\n"
        "from sweetspot import Contact, FlightConditions\n"
        "from sweetspot.flight.air import Air, Wind\n"
        "from sweetspot.dynamics.reduction import reduced_bat\n"
        "from sweetspot.flight.fence import landing\n"
        "from sweetspot.motion.ball_motion import batted_ball\n"
        "from sweetspot.analysis.full_play import play\n"
        "from sweetspot.motion.swing_path import SwingPath\n"
        "from sweetspot.units import FOOT, RPM\n\n"
        f"path = SwingPath(attack_angle=radians({state.attack_angle_deg!r}), tilt=radians({state.tilt_deg!r}),\n"
        f'                 attack_direction=radians({state.attack_direction_deg!r}), bats="{state.batter}")\n'
        f"pitch = batted_ball(speed=conditions.pitch.speed, spray=pi,\n"
        f"                 launch_angle=radians({state.pitch_angle_deg!r}),\n"
        f"                 backspin={state.pitch_backspin_rpm!r} * RPM,\n"
        f"                 position=(0, 2 * FOOT, {state.height_ft!r} * FOOT))\n"
        f"{_field_python(state)}"
        "model = reduced_bat(bat, ball=conditions.ball).held(conditions.hands)\n"
        f"met = Contact(bat.length - {state.impact_from_tip_in!r} * INCH, {state.offset_in!r} * INCH)\n"
        "played = play(model, through, swing=conditions.swing, path=path, pitch=pitch, contact=met)\n"
        "print(played.strike.launched, played.flight.carry, landing(played.flight.positions, park))\n"
    )

"""The air, the pitch and the ball that a question is asked of, as plain numbers; see `sweetspot.answers.setups`."""

from __future__ import annotations

import math
from dataclasses import dataclass

from sweetspot import catalog
from sweetspot.answers.setups import Exact, Place, value_of
from sweetspot.catalog.aerodynamic_laws import DEFAULT_AERODYNAMICS, usual_spin_line
from sweetspot.catalog.sports import pitched_aerodynamics
from sweetspot.errors import InputError
from sweetspot.flight.aerodynamics import Aerodynamics
from sweetspot.flight.air import Air, Wind
from sweetspot.flight.conditions import FlightConditions
from sweetspot.flight.park import Park
from sweetspot.flight.pitch import PitchFlight, aimed
from sweetspot.flight.sweep import BattedBall
from sweetspot.motion.ball_motion import USUAL_CONTACT, BallMotion, batted_ball
from sweetspot.motion.swing_path import Side
from sweetspot.units import to_si


@dataclass(frozen=True, kw_only=True)
class FieldAir:
    """The air over a field.

    Parameters
    ----------
    temperature, humidity : of the air, degC, and relative, 0 to 1.
    pressure : barometer reduced to sea level, Pa.
    elevation : of the field above the sea, m; None: the park's, or 0 without one.
    """

    temperature: float = to_si("70 degF", "temperature")
    humidity: float = 0.5
    pressure: float = to_si("29.92 inHg", "pressure")
    elevation: float | None = None

    @property
    def above_sea(self) -> float:
        """Elevation of the field, m."""
        return self.elevation or 0.0

    @property
    def air(self) -> Air:
        """The air over the field."""
        return Air(
            temperature=self.temperature, pressure=self.pressure, humidity=self.humidity, elevation=self.above_sea
        )


@dataclass(frozen=True, kw_only=True)
class Weather(FieldAir):
    """Air, wind and field.

    Parameters
    ----------
    temperature, humidity : of the air, degC, and relative, 0 to 1.
    pressure : barometer reduced to sea level, Pa.
    elevation : of the field above the sea, m; None: the park's, or 0 without one.
    wind_speed, wind_direction : m/s, and where the wind blows to, rad: 0 is out to centre field, pi in.
    wind_profile : exponent of the wind's growth with height, from 10 m; 0: the same everywhere.
    calm_below : height that the stands shelter from the wind, m.
    park : a ball park, or its name in the catalogue, whose fence, roof and elevation count; None: none does.
    """

    wind_speed: float = 0.0
    wind_direction: float = 0.0
    wind_profile: float = 0.0
    calm_below: float = 0.0
    park: str | Park | None = None

    @property
    def field(self) -> Park | None:
        """The park, if there is one."""
        return catalog.park(self.park) if isinstance(self.park, str) else self.park

    @property
    def above_sea(self) -> float:
        """Elevation of the field, m."""
        park = self.field
        return self.elevation if self.elevation is not None else 0.0 if park is None else park.elevation

    @property
    def wind(self) -> Wind:
        """The wind over the field."""
        return Wind(
            speed=self.wind_speed,
            direction=self.wind_direction,
            exponent=self.wind_profile,
            calm_below=self.calm_below,
        )

    def through(self, ball: str) -> FlightConditions:
        """Return the flight conditions of a ball of the catalogue."""
        law = catalog.aerodynamics_in(self.field, catalog.aerodynamics_of_ball(ball))
        return FlightConditions(ball=catalog.ball(ball), aerodynamics=law, air=self.air, wind=self.wind)


@dataclass(frozen=True, kw_only=True)
class PitchSetup:
    """How a pitch arrives: thrown by its name, or with the hit's pitch speed and these angles and spins.

    Parameters
    ----------
    pitch : by name, thrown over the middle of the plate; None: the others count.
    release_speed : of a pitch by name, m/s; None: as is usual.
    approach_angle : rad, at the plate; negative: it falls.
    pitch_backspin, pitch_sidespin : rad/s; negative backspin for a curve, positive sidespin bends it to its own left.
    height, forward : of contact above the ground and in front of the plate's tip, m.
    """

    pitch: str | None = None
    release_speed: float | None = None
    approach_angle: float = math.radians(-6)
    pitch_backspin: float = to_si("2200 rpm", "angular speed")
    pitch_sidespin: float = 0.0
    height: float = USUAL_CONTACT[2]
    forward: float = USUAL_CONTACT[1]

    def at_plate(self, speed: float, flying: FlightConditions) -> BallMotion:
        """Return the pitch where it is hit, as fast as ``speed`` (m/s) where it has no name."""
        if self.pitch is not None:
            return thrown(self.pitch, flying, release_speed=self.release_speed).plate
        if self.release_speed is not None:
            raise InputError("release_speed is of a pitch that is thrown; name it by pitch, or give pitch_speed")
        return batted_ball(
            speed=speed,
            launch_angle=self.approach_angle,
            spray=math.pi,
            backspin=self.pitch_backspin,
            sidespin=self.pitch_sidespin,
            position=(0.0, self.forward, self.height),
        )


def thrown(name: str, flying: FlightConditions, *, release_speed: float | None = None) -> PitchFlight:
    """Return the catalogue's pitch of a name, over the middle of the plate; ``release_speed`` None: as is usual."""
    delivery = catalog.delivery(name)
    if release_speed is not None:
        delivery = delivery.replaced(speed=release_speed)
    law, air, wind = pitched_aerodynamics(name), flying.one_air, flying.one_wind
    return aimed(delivery, ball=flying.ball, aerodynamics=law, air=air, wind=wind)


@dataclass(frozen=True, kw_only=True)
class LaunchSetup:
    """How a ball leaves the bat.

    Parameters
    ----------
    exit_speed, launch_angle : m/s, and rad above the level.
    spray : rad, direction off the bat from centre field, positive to right field; None: to centre field.
    bearing : rad, direction of the place where it comes down, in place of ``spray``.
    backspin, sidespin : rad/s, positive sidespin bends the path to the left; None: what such hits usually have.
    gyrospin : rad/s, about the direction of motion.
    height, forward : of contact above the ground and in front of the plate's tip, m.
    bats : side the batter bats from, for the usual spin.
    ball : its name in the catalogue, or its TOML file; its sport's drag and lift are taken.
    law : name of another law of drag and lift; None: the sport's.
    """

    exit_speed: Exact = to_si("100 mph", "speed")
    launch_angle: Exact = math.radians(28)
    spray: float | None = None
    bearing: float | None = None
    backspin: float | None = None
    sidespin: float | None = None
    gyrospin: float = 0.0
    height: float = USUAL_CONTACT[2]
    forward: float = USUAL_CONTACT[1]
    bats: Side = "right"
    ball: str = "baseball"
    law: str | None = None

    @property
    def aerodynamics(self) -> Aerodynamics:
        """The law of drag and lift in the open."""
        return catalog.aerodynamics(self.law) if self.law else catalog.aerodynamics_of_ball(self.ball)

    def hit(self, weather: Weather) -> BattedBall:
        """Return the ball in its weather."""
        if self.spray is not None and self.bearing is not None:
            raise InputError(
                "spray and bearing were both given; give spray, the direction off the bat, or bearing, that of the "
                "place where the ball comes down"
            )
        usual_spin = None if catalog.ball_sport(self.ball) == "baseball" else 0.0  # tracked balls are baseballs
        return BattedBall(
            exit_speed=value_of(self.exit_speed),
            launch_angle=value_of(self.launch_angle),
            spray=self.spray or 0.0,
            bearing=self.bearing,
            backspin=usual_spin if self.backspin is None else self.backspin,
            sidespin=usual_spin if self.sidespin is None else self.sidespin,
            gyrospin=self.gyrospin,
            height=self.height,
            forward=self.forward,
            bats=self.bats,
            temperature=weather.temperature,
            humidity=weather.humidity,
            pressure=weather.pressure,
            elevation=weather.above_sea,
            wind_speed=weather.wind_speed,
            wind_direction=weather.wind_direction,
            wind_exponent=weather.wind_profile,
            calm_below=weather.calm_below,
            line=usual_spin_line(self.law or DEFAULT_AERODYNAMICS),
        )


@dataclass(frozen=True, kw_only=True)
class SearchSetup:
    """What is thrown, and what of the contact is not searched.

    Parameters
    ----------
    pitch : names of the pitches to which the best swing is searched; none: those of the sport.
    release_speed : of all of them, m/s; None: as is usual.
    at : m from the knob end where the ball is met; None: the best place is searched.
    attack_angle : rad; None: the best is searched.
    tilt : of the plane of the swing, rad; 0 keeps the bat level.
    """

    pitch: tuple[str, ...] = ()
    release_speed: float | None = None
    at: Place | None = None
    attack_angle: float | None = None
    tilt: float = math.radians(32)


@dataclass(frozen=True, kw_only=True)
class SentSetup:
    """How the ball leaves, for the best launch angle and the easiest home run.

    Parameters
    ----------
    exit_speed : speeds for which the best launch angle is searched, m/s; none: three that are usual in the sport.
    backspin : rad/s.
    """

    exit_speed: tuple[float, ...] = ()
    backspin: float = to_si("2200 rpm", "angular speed")


FAIR_WEATHER = Weather()
GAMES_AIR = FieldAir(temperature=to_si("72 degF", "temperature"))
"""Of games whose table does not give it."""

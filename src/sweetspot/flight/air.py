"""The air that a ball flies through: how dense it is, and how the wind blows."""

from __future__ import annotations

import math
from dataclasses import dataclass, fields
from typing import Annotated, Self

import numpy as np
from numpy.typing import ArrayLike, NDArray
from pydantic import AfterValidator, Field, model_validator

from sweetspot.equipment.base import Fraction, NonNegative, Positive, Validated
from sweetspot.numerics.arrays import Array
from sweetspot.plausibility import check_angle
from sweetspot.units import MPH

STANDARD_PRESSURE = 101325.0
"""Pa, of the standard atmosphere at sea level: 760 mm of mercury."""
ICE = 273.15
"""K at 0 degC."""
DRY_DENSITY = 1.2929
"""kg/m^3, of dry air at 0 degC and standard pressure [nathan_calculator]."""
PRESSURE_FALL = 1.217e-4
"""1/m, how the pressure falls with elevation, p = p0 exp(-beta h) [nathan_calculator]."""
VAPOUR_LIGHTNESS = 0.3783
"""One minus the weight of a molecule of water over one of air [nathan_calculator]."""
MILLIMETRE_OF_MERCURY = STANDARD_PRESSURE / 760


def vapour_pressure(temperature: ArrayLike) -> Array:
    """Return the pressure of water vapour at saturation in Pa.

    4.5841 mmHg exp((18.687 - T / 234.5) T / (257.14 + T)), T in degC [nathan_calculator]. Boiling water must come near
    the pressure of the atmosphere:

    >>> round(float(vapour_pressure(100.0)) / STANDARD_PRESSURE, 2)
    1.0

    ``temperature``: degC, any shape.
    """
    degrees = np.asarray(temperature, float)
    power = (18.687 - degrees / 234.5) * degrees / (257.14 + degrees)
    return np.asarray(4.5841 * MILLIMETRE_OF_MERCURY * np.exp(power))


def air_density(temperature: ArrayLike, *, pressure: ArrayLike, humidity: ArrayLike, elevation: ArrayLike) -> Array:
    """Return the density of moist air in kg/m^3.

    rho = 1.2929 (273.15 / (T + 273.15)) (p exp(-beta h) - 0.3783 H p_s(T)) / p_0 [nathan_calculator]

    Nothing is checked: for rows of a table whose values are known to be sound; `Air` checks.

    Parameters
    ----------
    temperature : T, degC.
    pressure : p, Pa, reduced to sea level.
    humidity : H, 0 to 1.
    elevation : h, m above the sea.
        All of shapes that fit together.

    >>> denver = air_density(21.0, pressure=101325.0, humidity=0.5, elevation=1609.0)
    >>> round(float(denver / air_density(21.0, pressure=101325.0, humidity=0.5, elevation=0.0)), 2)
    0.82
    """
    degrees = np.asarray(temperature, float)
    total = np.asarray(pressure, float) * np.exp(-PRESSURE_FALL * np.asarray(elevation, float))
    missing = VAPOUR_LIGHTNESS * np.asarray(humidity, float) * vapour_pressure(degrees)
    return np.asarray(DRY_DENSITY * ICE / (degrees + ICE) * (total - missing) / STANDARD_PRESSURE)


class Air(Validated):
    """The air over a field, the same from the ground to the top of the flight.

    Parameters
    ----------
    temperature : degC, -60 to 60.
    pressure : Pa, as weather reports give it: reduced to sea level, 0 (nothing there) to 120 000.
    humidity : relative humidity, 0 to 1.
    elevation : m, of the field above the sea, -500 to 9000.

    >>> round(Air(temperature=21.111, pressure=101325, humidity=0.5, elevation=4.572).density, 3)
    1.194
    """

    temperature: Annotated[float, Field(ge=-60, le=60)] = 21.0
    pressure: Annotated[float, Field(ge=0, le=120e3)] = STANDARD_PRESSURE
    humidity: Fraction = 0.5
    elevation: Annotated[float, Field(ge=-500, le=9000)] = 0.0

    @model_validator(mode="after")
    def _more_air_than_water(self) -> Self:
        vapour = self.humidity * vapour_pressure(self.temperature)
        if vapour > self.pressure * math.exp(-PRESSURE_FALL * self.elevation):
            raise ValueError(
                f"the water vapour alone would press with {vapour:.0f} Pa, more than all the air with "
                f"{self.pressure:.0f} Pa; give a humidity of 0 for a vacuum"
            )
        return self

    @property
    def density(self) -> float:
        """Mass of the air per volume, kg/m^3; see `air_density`."""
        return float(
            air_density(self.temperature, pressure=self.pressure, humidity=self.humidity, elevation=self.elevation)
        )


USUAL_AIR = Air(temperature=22.2)
"""72 degF at sea level: for games of unknown weather."""


@dataclass(frozen=True)
class Airs:
    """The air of each of n flights; every array has shape (n,). Nothing is checked, as in `air_density`.

    Parameters
    ----------
    temperature : degC.
    pressure : Pa, reduced to sea level.
    humidity : relative humidity, 0 to 1.
    elevation : m above the sea.

    >>> two = Airs(np.array([4.0, 35.0]), np.array([101325.0] * 2), np.array([0.5, 0.5]), np.array([0.0, 0.0]))
    >>> two.density.round(3), Air(temperature=35).density == two.at(slice(1, 2)).density[0]
    (array([1.272, 1.134]), np.True_)
    """

    temperature: Array
    pressure: Array
    humidity: Array
    elevation: Array

    @property
    def density(self) -> Array:
        """Mass of the air per volume, kg/m^3, shape (n,); see `air_density`."""
        return air_density(self.temperature, pressure=self.pressure, humidity=self.humidity, elevation=self.elevation)

    def at(self, rows: slice | NDArray[np.intp] | NDArray[np.bool_]) -> Airs:
        """Return the air of some of the flights."""
        return Airs(*(getattr(self, field.name)[rows] for field in fields(self)))


VACUUM = Air(pressure=0.0, humidity=0.0)
"""No air at all: every flight is a parabola."""


def _in_radians(direction: float) -> float:
    check_angle(direction, "it")
    return direction


class Wind(Validated):
    """A steady wind, level, with its profile over height.

    It blows with speed (z / ``reference_height``)^``exponent``, and not at all below ``calm_below``.

    Parameters
    ----------
    speed : m/s at the reference height, 0 to 100.
    direction : rad, where it blows to: 0 to centre field (out), positive to right field, pi to the plate (in).
    exponent : 0 (the same at every height) to 1; about 1/7 over open land.
    reference_height : m, > 0, where the speed is measured.
    calm_below : m; below it the stands keep the wind off, as in the sheet [nathan_calculator].

    Raises
    ------
    InputError
        for a value outside these, or a direction that is none in radians.
    """

    speed: Annotated[float, Field(ge=0, le=100)] = 0.0
    direction: Annotated[float, AfterValidator(_in_radians)] = 0.0
    exponent: Annotated[float, Field(ge=0, le=1)] = 0.0
    reference_height: Positive = 10.0
    calm_below: NonNegative = 0.0

    @property
    def velocity(self) -> Array:
        """Velocity at the reference height, m/s, shape (3,)."""
        return self.speed * np.array([math.sin(self.direction), math.cos(self.direction), 0.0])

    def strength(self, height: float) -> float:
        """Return the wind's speed at a height (m) over that at the reference height.

        >>> Wind(speed=5.0, exponent=1 / 7).strength(10.0), Wind(speed=5.0, calm_below=3.0).strength(2.9)
        (1.0, 0.0)
        """
        return 0.0 if height < self.calm_below else self.open_strength(height)

    def open_strength(self, height: float) -> float:
        """Return the same as `strength` for an unsheltered field."""
        return float((max(height, 0.0) / self.reference_height) ** self.exponent)

    def at(self, height: float) -> Array:
        """Return the wind's velocity at a height (m) in m/s, shape (3,)."""
        return self.strength(height) * self.velocity


CALM = Wind()
"""No wind."""

MEAN_BREEZE = Wind(speed=1.8 * MPH, direction=math.pi)
"""What the mean park's air does to a ball of which no wind is known: it comes in from centre field.

Not measured as wind. In the open, in each of four seasons, pitches lose 5 % less than under a roof and hits 3.5 % more;
a breeze towards the plate of 2.1 mph does both. It is the level of `baseball` and of `pitched-baseball` less that of
`baseball-in-still-air`; give it with the latter only [savant_2022rays]."""

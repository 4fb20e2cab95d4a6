"""Everything about a flight that is not how the ball starts: the ball, its drag law, the air and the wind."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from sweetspot.equipment.ball import Ball
from sweetspot.errors import InputError
from sweetspot.flight.aerodynamics import Aerodynamics
from sweetspot.flight.air import CALM, Air, Airs, Wind
from sweetspot.numerics.arrays import Array
from sweetspot.units.quantities import in_si


@dataclass(frozen=True, kw_only=True)
class FlightConditions:
    """Ball and air of a flight.

    Parameters
    ----------
    ball : its size and mass.
    aerodynamics : its law of drag and lift.
    air : one air for all flights, or one for each: whole, or its density alone, kg/m^3, shape (n,).
    wind : one wind for all, or a wind alike at every height for each, m/s, shape (n, 2): to the right and out.
    """

    ball: Ball
    aerodynamics: Aerodynamics
    air: Air | Airs | ArrayLike
    wind: Wind | ArrayLike = CALM

    def __post_init__(self) -> None:
        if not isinstance(self.air, Air):
            object.__setattr__(self, "air", in_si(self.air, "air"))
        if not isinstance(self.wind, Wind):
            object.__setattr__(self, "wind", in_si(self.wind, "wind"))

    @property
    def one_air(self) -> Air:
        """The air, where all flights share one; raises `InputError` where each has its own density."""
        if not isinstance(self.air, Air):
            raise InputError("air is one for each flight; give one `Air` here")
        return self.air

    @property
    def weather(self) -> Air | Airs:
        """The air, where it is defined at any elevation; raises `InputError` where only densities are known."""
        if not isinstance(self.air, Air | Airs):
            raise InputError("air is a density for each flight; give one `Air`, or `Airs` here")
        return self.air

    @property
    def one_wind(self) -> Wind:
        """The wind, where all flights share one; raises `InputError` where each has its own."""
        if not isinstance(self.wind, Wind):
            raise InputError("wind is one for each flight; give one `Wind` here")
        return self.wind

    @property
    def density(self) -> Array:
        """Density of the air, kg/m^3, shape () or (n,)."""
        if isinstance(self.air, Air | Airs):
            return np.asarray(self.air.density)
        return np.atleast_1d(np.asarray(self.air, float))

    @property
    def blowing(self) -> Array:
        """The wind at its reference height to the right and out, m/s, shape (2,) or (n, 2)."""
        return np.asarray(self.wind.velocity[:2]) if isinstance(self.wind, Wind) else np.asarray(self.wind, float)

    @property
    def profile(self) -> float | None:
        """Exponent of the wind over height, None for one alike at every height."""
        return self.wind.exponent if isinstance(self.wind, Wind) and self.wind.exponent and self.wind.speed else None

    @property
    def shelter(self) -> tuple[float, float]:
        """Height below which no wind blows, and the wind's reference height, m."""
        return (self.wind.calm_below, self.wind.reference_height) if isinstance(self.wind, Wind) else (0.0, 1.0)

    def in_air(self, air: Air) -> FlightConditions:
        """Return the same in another air."""
        return FlightConditions(ball=self.ball, aerodynamics=self.aerodynamics, air=air, wind=self.wind)

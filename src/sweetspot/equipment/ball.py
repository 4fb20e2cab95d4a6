"""The ball: mass, size, how hard it is and how much of its energy it gives back."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Annotated, Protocol, Self

import numpy as np
from pydantic import Field

from sweetspot.equipment.base import Fraction, Positive, Real, Validated
from sweetspot.errors import InputError

COR_FLOOR = 0.05
"""Lowest restitution the linear law may reach; keeps the law meaningful far beyond game speed."""


class RestitutionLaw(Validated):
    """Coefficient of restitution against a rigid wall as a straight line in speed.

    e(v) = reference - slope (v - reference_speed), never above 1 nor below `COR_FLOOR`.

    Parameters
    ----------
    reference : e at ``reference_speed``, in (0, 1].
    reference_speed : m/s, > 0.
    slope : loss of e per m/s of speed, s/m, >= 0.
    """

    reference: Annotated[float, Field(gt=0, le=1)]
    reference_speed: Positive
    slope: Annotated[float, Field(ge=0)] = 0.0

    def at(self, speed: Real) -> Real:
        """Return e at an impact speed in m/s."""
        if isinstance(speed, float):  # many times faster, and stays a plain number
            return restitution_at(self, speed)
        line = self.reference - self.slope * (speed - self.reference_speed)
        within: Real = np.minimum(1.0, np.maximum(COR_FLOOR, line))
        return within


class RestitutionLine(Protocol):
    """The numbers of a `RestitutionLaw`; the compiled collision has them in a record of its own."""

    @property
    def reference(self) -> float: ...
    @property
    def slope(self) -> float: ...
    @property
    def reference_speed(self) -> float: ...


def restitution_at(law: RestitutionLine, speed: float) -> float:
    """Return e of a law at a speed in m/s; see `RestitutionLaw`. Plain arithmetic, which the kernel compiles."""
    return min(1.0, max(COR_FLOOR, law.reference - law.slope * (speed - law.reference_speed)))


class Ball(Validated):
    """A ball that is loaded along F = k u^n and gives back what its restitution law says.

    Parameters
    ----------
    name : what people call it.
    mass : kg, > 0.
    radius : m, > 0.
    restitution : the law e(v) against a rigid wall.
    stiffness : k of F = k u^n, N/m^n, > 0.
    exponent : n of F = k u^n, between 1 (linear spring) and 3.
    cor_humidity_slope : change of e per unit of relative humidity (0 to 1) of storage.
    cor_temperature_slope : change of e per kelvin.
    reference_humidity : relative humidity at which the law holds, 0 to 1.
    reference_temperature : degC at which the law holds.
    """

    name: str
    mass: Positive
    radius: Positive
    restitution: RestitutionLaw
    stiffness: Positive
    exponent: Annotated[float, Field(ge=1, le=3)]
    cor_humidity_slope: float = 0.0
    cor_temperature_slope: float = 0.0
    reference_humidity: Fraction = 0.5
    reference_temperature: float = 21.0

    def with_restitution(self, reference: float) -> Self:
        """Return the same ball with another e at the reference speed of its law."""
        return self.replaced(restitution=self.restitution.replaced(reference=reference))

    def deviated(self, deviations: Mapping[str, float]) -> Self:
        """Return the ball with deviations, by name; those that are not named are none.

        Parameters
        ----------
        deviations : "restitution" and "restitution_slope" (s/m), added to its law's; "mass" and "stiffness", added to
            their logarithms.
        """
        law = self.restitution
        law = law.replaced(
            reference=min(law.reference + deviations.get("restitution", 0.0), 1.0),
            slope=max(law.slope + deviations.get("restitution_slope", 0.0), 0.0),
        )
        return self.replaced(
            restitution=law,
            mass=self.mass * math.exp(deviations.get("mass", 0.0)),
            stiffness=self.stiffness * math.exp(deviations.get("stiffness", 0.0)),
        )

    def conditioned(self, *, humidity: float | None = None, temperature: float | None = None) -> Self:
        """Return the ball after long storage at a relative humidity (0 to 1) and temperature (degC).

        Linear about the ball's reference state with the catalogue's slopes; the returned ball's
        reference state is the new one, so conditioning twice does not count twice.
        """
        humidity = self.reference_humidity if humidity is None else humidity
        temperature = self.reference_temperature if temperature is None else temperature
        if not 0 <= humidity <= 1:
            raise InputError(f"humidity was given as {humidity:g}; allowed is a ratio from 0 to 1 (50 % is 0.5)")
        if not math.isfinite(temperature) or not -40 <= temperature <= 60:
            raise InputError(f"ball temperature was given as {temperature:g} degC; allowed is -40 to 60")
        change = self.cor_humidity_slope * (humidity - self.reference_humidity)
        change += self.cor_temperature_slope * (temperature - self.reference_temperature)
        warmer = self.with_restitution(self.restitution.reference + change)
        return warmer.replaced(reference_humidity=humidity, reference_temperature=temperature)


def peak_compression(ball: Ball, speed: float) -> float:
    """Return the depth U in m to which a rigid wall presses one side of a ball that meets it at ``speed`` (m/s).

    The kinetic energy is stored there: k U^(n+1) / (n+1) = m v^2 / 2.

    >>> law = RestitutionLaw(reference=0.5, reference_speed=25.0)
    >>> ball = Ball(name="spring", mass=0.1, radius=0.04, restitution=law, stiffness=1e5, exponent=1.0)
    >>> round(peak_compression(ball, 10.0), 6)  # v sqrt(m / k)
    0.01
    """
    energy = ball.mass * speed**2 / 2
    return float(((ball.exponent + 1) * energy / ball.stiffness) ** (1 / (ball.exponent + 1)))


def stiffness_from_peak_force(peak_force: float, *, speed: float, mass: float, exponent: float) -> float:
    """Return k of F = k u^n from the peak force (N) of a ball of ``mass`` on a rigid wall.

    The kinetic energy is stored at the peak: m v^2 / 2 = k U^(n+1) / (n+1) and F = k U^n, so
    U = (n+1) m v^2 / (2 F).

    >>> round(stiffness_from_peak_force(100.0, speed=10.0, mass=0.1, exponent=1.0), 6)
    1000.0
    """
    compression = (exponent + 1) * mass * speed**2 / (2 * peak_force)
    return float(peak_force / compression**exponent)


def stiffness_from_load(load: float, *, compression: float, exponent: float) -> float:
    """Return k of F = k u^n from a load (N) that presses one side of the ball in by ``compression`` (m): F / u^n.

    A test between two plates presses both sides in; each takes half of what the plates approach.

    >>> stiffness_from_load(80.0, compression=0.5, exponent=1.0)
    160.0
    """
    return float(load / compression**exponent)


def stiffness_from_contact_time(
    contact_time: float, *, speed: float, mass: float, exponent: float, restitution: float
) -> float:
    """Return k of F = k u^n from the time (s) that a ball of ``mass`` touches a rigid wall at ``speed`` (m/s).

    T = (U/v) (integral of ds / sqrt(1 - s^(n+1)) from 0 to 1 + the same with p for n, from s_1 to 1, over e), with U
    the peak compression, p = (n+1) / e^2 - 1 the unloading exponent and s_1 where the force has fallen to 1 % of its
    peak, as gauges see the end. U gives k = (n+1) m v^2 / (2 U^(n+1)).

    Parameters
    ----------
    restitution : e at that speed, in (0, 1].

    >>> mass, stiffness = 0.1, 1000.0  # a linear spring without loss touches for pi sqrt(m / k), less the last 1 %
    >>> time = (math.pi - math.asin(0.01)) * math.sqrt(mass / stiffness)
    >>> round(stiffness_from_contact_time(time, speed=3.0, mass=mass, exponent=1.0, restitution=1.0), 6)
    1000.0
    """
    unloading = (exponent + 1) / restitution**2 - 1
    last = 0.01 ** (1 / unloading)
    stretched = _time_to_peak(exponent, 0.0) + _time_to_peak(unloading, last) / restitution
    peak = contact_time * speed / stretched
    return float((exponent + 1) * mass * speed**2 / (2 * peak ** (exponent + 1)))


def _time_to_peak(exponent: float, start: float) -> float:
    """Return the integral of ds / sqrt(1 - s^(n+1)) from ``start`` to 1; s = 1 - x^2 takes the infinite end away."""
    nodes, weights = np.polynomial.legendre.leggauss(40)
    end = math.sqrt(1 - start)
    x = end * (nodes + 1) / 2
    values = 2 * x / np.sqrt(1 - (1 - x**2) ** (exponent + 1))
    return float(end / 2 * weights @ values)

"""The ball: mass, size, how hard it is and how much of its energy it gives back."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Annotated, NamedTuple, Protocol, Self

import numpy as np
from pydantic import Field

from sweetspot.equipment.base import Fraction, Positive, Real, Validated
from sweetspot.errors import InputError
from sweetspot.numerics.arrays import Array
from sweetspot.numerics.interpolants import on_parabola
from sweetspot.numerics.roots import root_between

COR_FLOOR = 0.05
"""Lowest restitution the law may reach; keeps it meaningful far beyond game speed."""
SLOWEST = 1e-3
"""m/s at which a logarithm of speed is taken at the least."""


class RestitutionLaw(Validated):
    """Coefficient of restitution against a rigid wall: a straight line in speed, or in the logarithm of speed.

    e(v) = reference - slope (v - reference_speed) - log_slope ln(v / reference_speed), never above 1 nor below
    `COR_FLOOR`.

    Parameters
    ----------
    reference : e at ``reference_speed``, in (0, 1].
    reference_speed : m/s, > 0.
    slope : loss of e per m/s of speed, s/m, >= 0.
    log_slope : loss of e for every e-fold of speed, >= 0; for hollow balls, which lose less and less of it.

    >>> law = RestitutionLaw(reference=0.6, reference_speed=5.0, log_slope=0.2)
    >>> round(law.at(5.0), 3), round(law.at(5.0 * math.e), 3)
    (0.6, 0.4)
    """

    reference: Annotated[float, Field(gt=0, le=1)]
    reference_speed: Positive
    slope: Annotated[float, Field(ge=0)] = 0.0
    log_slope: Annotated[float, Field(ge=0)] = 0.0

    def slope_at(self, speed: float) -> float:
        """Return the loss of e per m/s of speed, s/m, at a speed in m/s."""
        return self.slope + self.log_slope / max(speed, SLOWEST)

    def at(self, speed: Real) -> Real:
        """Return e at an impact speed in m/s."""
        if isinstance(speed, float):  # many times faster, and stays a plain number
            return restitution_at(self, speed)
        within: Real = restitutions_at(self, np.asarray(speed))[()]
        return within


class RestitutionLine(Protocol):
    """The numbers of a `RestitutionLaw`; the compiled collision has them in a record of its own."""

    @property
    def reference(self) -> float: ...
    @property
    def slope(self) -> float: ...
    @property
    def reference_speed(self) -> float: ...
    @property
    def log_slope(self) -> float: ...


class RestitutionLaws(NamedTuple):
    """The numbers of many `RestitutionLaw`, arrays that broadcast with the speeds that they are asked about."""

    reference: Array
    slope: Array
    reference_speed: Array
    log_slope: Array


def restitutions_at(law: RestitutionLine | RestitutionLaws, speed: Array) -> Array:
    """Return e of a law, or of many, at impact speeds in m/s."""
    line = np.asarray(law.reference - law.slope * (speed - law.reference_speed))
    if np.any(law.log_slope):
        line = line - law.log_slope * np.log(np.maximum(speed, SLOWEST) / law.reference_speed)
    return np.asarray(np.minimum(1.0, np.maximum(COR_FLOOR, line)))


def restitution_at(law: RestitutionLine, speed: float) -> float:
    """Return e of a law at a speed in m/s; see `RestitutionLaw`. Plain arithmetic, which the kernel compiles."""
    line = law.reference - law.slope * (speed - law.reference_speed)
    if law.log_slope > 0:
        line -= law.log_slope * math.log(max(speed, SLOWEST) / law.reference_speed)
    return min(1.0, max(COR_FLOOR, line))


class LossLaw(Validated):
    """What a ball would be if the rate of compression took another part of what it loses.

    Its tests stay what they are, so stiffness and restitution change with the damper; see `Ball.with_law`.

    Parameters
    ----------
    damping, stiffness : c in s/m and k in N/m^n.
    reference, slope : of the restitution law, at the same reference speed.
    """

    damping: Annotated[float, Field(ge=0)]
    stiffness: Positive
    reference: Annotated[float, Field(gt=0, le=1)]
    slope: Annotated[float, Field(ge=0)]


class BallSpread(Validated):
    """How far a ball may be from its description, each the half width of a 90 % interval.

    Parameters
    ----------
    scatter : of the restitution, from one ball of a kind to the next.
    mass : from one to the next, as a part of the mass.
    restitution : of the mean ball of its kind, at the reference speed of its law.
    stiffness : of k, as a part of it.
    slope : of the restitution law, s/m.
    anchor_speed : m/s about which the law turns where its slope is another; None: its reference speed.
    """

    scatter: Annotated[float, Field(ge=0)] = 0.0
    mass: Annotated[float, Field(ge=0)] = 0.0
    restitution: Annotated[float, Field(ge=0)] = 0.0
    stiffness: Annotated[float, Field(ge=0)] = 0.0
    slope: Annotated[float, Field(ge=0)] = 0.0
    anchor_speed: Positive | None = None


class Ball(Validated):
    """A ball that is loaded along F = k u^n (1 + c u') and gives back what its restitution law says.

    u is its compression and u' the rate of that. What it loses, it loses in two ways: by how fast it is pressed and
    springs back (c), and by how far (the way back is steeper than the way in). With c = 0 only the second is left.

    Parameters
    ----------
    name : what people call it.
    mass : kg, > 0.
    radius : m, > 0.
    restitution : the law e(v) against a rigid wall.
    stiffness : k of F = k u^n, N/m^n, > 0.
    exponent : n of F = k u^n, between 1 (linear spring) and 3.
    damping : c, s/m, >= 0.
    law_ends : the same ball with as little and with as much loss by the rate as the evidence allows (90 %); None: not
        asked.
    cor_humidity_slope : change of e per unit of relative humidity (0 to 1) of storage.
    cor_temperature_slope : change of e per kelvin.
    reference_humidity : relative humidity at which the law holds, 0 to 1.
    reference_temperature : degC at which the law holds.
    sport : that it belongs to; "": any.
    spread : how far it may be from all this; None: it is just so.
    """

    name: str
    mass: Positive
    radius: Positive
    restitution: RestitutionLaw
    stiffness: Positive
    exponent: Annotated[float, Field(ge=1, le=3)]
    damping: Annotated[float, Field(ge=0)] = 0.0
    law_ends: tuple[LossLaw, LossLaw] | None = None
    cor_humidity_slope: float = 0.0
    cor_temperature_slope: float = 0.0
    reference_humidity: Fraction = 0.5
    reference_temperature: float = 21.0
    sport: str = ""
    spread: BallSpread | None = None

    def with_restitution(self, reference: float) -> Self:
        """Return the same ball with another e at the reference speed of its law."""
        change, ends = reference - self.restitution.reference, self.law_ends
        return self.replaced(
            restitution=self.restitution.replaced(reference=reference),
            law_ends=ends and tuple(end.replaced(reference=min(1.0, end.reference + change)) for end in ends),
        )

    def with_law(self, deviation: float) -> Self:
        """Return the same ball with more or less of its loss by the rate, as fast and as hard in the tests it passed.

        Parameters
        ----------
        deviation : -1 and 1 are the two ends of the evidence; in between and beyond, a parabola through them and 0.
        """
        return self.deviated({"law": deviation})

    def deviated(self, deviations: Mapping[str, float]) -> Self:
        """Return the ball with deviations, by name; those that are not named are none.

        It is not validated again, which takes longer than a hit: what has limits is kept within them.

        Parameters
        ----------
        deviations : "law", as `with_law` takes it; "restitution" and "restitution_slope" (s/m), added to its
            restitution law's; "mass" and "stiffness", added to their logarithms.
        """
        damping, stiffness, reference, slope = self._by_law(deviations.get("law", 0.0))
        return self.unchecked(
            damping=max(damping, 0.0),
            stiffness=stiffness * math.exp(deviations.get("stiffness", 0.0)),
            mass=self.mass * math.exp(deviations.get("mass", 0.0)),
            restitution=self.restitution.unchecked(
                reference=max(COR_FLOOR, min(min(reference, 1.0) + deviations.get("restitution", 0.0), 1.0)),
                slope=max(max(slope, 0.0) + deviations.get("restitution_slope", 0.0), 0.0),
            ),
        )

    def _by_law(self, deviation: float) -> tuple[float, float, float, float]:
        """Return damping, stiffness, and reference and slope of the restitution; see `with_law`."""
        law = self.restitution
        if self.law_ends is None or deviation == 0:
            return self.damping, self.stiffness, law.reference, law.slope
        here = (self.damping, math.log(self.stiffness), law.reference, law.slope)
        less, more = ((end.damping, math.log(end.stiffness), end.reference, end.slope) for end in self.law_ends)
        damping, stiffness, reference, slope = (
            on_parabola(deviation, *values) for values in zip(less, here, more, strict=True)
        )
        return damping, math.exp(stiffness), reference, slope

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


def damped_part(number: float) -> float:
    """Return A(x) = x - ln(1 + x), x > -1: a damper's share in an energy.

    A ball that is pressed from the speed v to rest along F = G(u) (1 + c u') stores m A(c v) / c^2; one that springs
    back freely to the speed v needs m A(-c v) / c^2, for the integral of x dx / (1 + x) is A. Both are m v^2 / 2
    where c v is small. Plain arithmetic, which the kernel compiles.

    >>> round(damped_part(1.0), 6), round(damped_part(1e-4) / 1e-4**2, 6)
    (0.306853, 0.499967)
    """
    if abs(number) < 1e-3:
        return number * number * (0.5 - number * (1 / 3 - number * (0.25 - number / 5)))
    return number - math.log1p(number)


def stored_on_wall(speed: float, *, mass: float, damping: float) -> float:
    """Return the energy in J that a ball of ``mass`` (kg) and ``damping`` (s/m) stores on a rigid wall, met at m/s."""
    if damping == 0 or speed == 0:
        return mass * speed**2 / 2
    return mass * damped_part(damping * speed) / damping**2


def rate_share(damping: float, *, speed: float, restitution: float) -> float:
    """Return the part of what a ball loses on a rigid wall that it loses by the rate of compression.

    Of m v^2 / 2 (1 - e^2), all but what is stored is lost on the way in, and what springs back less m (e v)^2 / 2 on
    the way out: with d = c v, s = (1 - e^2 - 2 A(d) / d^2 + 2 A(-e d) / d^2) / (1 - e^2).

    Parameters
    ----------
    damping : c in s/m.
    speed, restitution : v in m/s, and e there.

    >>> round(rate_share(0.0063, speed=60.8, restitution=0.478), 2)
    0.3
    """
    d = damping * speed
    if d == 0:
        return 0.0
    stored, back = 2 * damped_part(d) / d**2, 2 * damped_part(-restitution * d) / d**2
    return (1 - restitution**2 - stored + back) / (1 - restitution**2)


def damping_from_share(share: float, *, speed: float, restitution: float) -> float:
    """Return c in s/m of a ball that loses so large a part by the rate; see `rate_share`.

    Parameters
    ----------
    share : from 0, all by how far it is pressed, to 1, all by how fast (Hunt and Crossley's law at this speed).

    >>> round(damping_from_share(0.3, speed=60.8, restitution=0.478), 4)
    0.0063
    """
    if share == 0:
        return 0.0
    least, most = 1e-5 / speed, (1 - 1e-12) / (restitution * speed)

    def excess(damping: float) -> float:
        return rate_share(damping, speed=speed, restitution=restitution) - share

    return root_between(excess, least, most) if excess(least) < 0 else 0.0


def peak_compression(ball: Ball, speed: float) -> float:
    """Return the depth U in m to which a rigid wall presses one side of a ball that meets it at ``speed`` (m/s).

    What is stored there is k U^(n+1) / (n+1) = m v^2 / 2, less what a damper takes (`stored_on_wall`).

    >>> law = RestitutionLaw(reference=0.5, reference_speed=25.0)
    >>> ball = Ball(name="spring", mass=0.1, radius=0.04, restitution=law, stiffness=1e5, exponent=1.0)
    >>> round(peak_compression(ball, 10.0), 6)  # v sqrt(m / k)
    0.01
    """
    stored = stored_on_wall(speed, mass=ball.mass, damping=ball.damping)
    return float(((ball.exponent + 1) * stored / ball.stiffness) ** (1 / (ball.exponent + 1)))


def peak_over_turn(number: float, exponent: float) -> float:
    """Return the greatest force of a ball on a rigid wall over that at its greatest compression, where nothing moves.

    At the rate x / c on the way in u^(n+1) = U^(n+1) (1 - A(x) / A(d)), d = c v, and F = k u^n (1 + x); the greatest is
    searched on a grid of rates. 1 without a damper.

    Parameters
    ----------
    number : d = c v.

    >>> peak_over_turn(0.0, 1.5), round(peak_over_turn(0.4, 1.5), 3)
    (1.0, 1.051)
    """
    if number == 0:
        return 1.0
    rates = np.linspace(0.0, number, 2001)
    pressed = 1 - (rates - np.log1p(rates)) / damped_part(number)
    return float(np.max(np.maximum(pressed, 0.0) ** (exponent / (exponent + 1)) * (1 + rates)))


def stiffness_from_peak_force(
    peak_force: float, *, speed: float, mass: float, exponent: float, damping: float = 0.0
) -> float:
    """Return k of F = k u^n (1 + c u') from the peak force (N) of a ball of ``mass`` on a rigid wall.

    Where the ball turns, E = k U^(n+1) / (n+1) is stored and F = k U^n, so U = (n+1) E / F; E is m v^2 / 2, or
    m A(c v) / c^2 with a damper (`damped_part`), which also lets the force peak before (`peak_over_turn`).

    >>> round(stiffness_from_peak_force(100.0, speed=10.0, mass=0.1, exponent=1.0), 6)
    1000.0
    """
    energy = stored_on_wall(speed, mass=mass, damping=damping)
    force = peak_force / peak_over_turn(damping * speed, exponent)
    compression = (exponent + 1) * energy / force
    return float(force / compression**exponent)


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

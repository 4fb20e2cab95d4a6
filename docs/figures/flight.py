"""Flights: the effect of air on one hit, and convergence with shorter steps."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from matplotlib.figure import Figure

from figures.style import BLUE, GREEN, GREY, INK, RED, new_figure
from sweetspot import catalog
from sweetspot.flight.air import VACUUM, Air
from sweetspot.flight.conditions import FlightConditions
from sweetspot.flight.kernel import STEP, Flights, flights
from sweetspot.flight.sweep import BattedBall
from sweetspot.flight.trajectory import fly
from sweetspot.motion.ball_motion import BallMotions, spin_axes
from sweetspot.units import DEGREE, FOOT, MPH, RPM

HIT = BattedBall(exit_speed=100 * MPH, launch_angle=28 * DEGREE, temperature=70 / 1.8 - 32 / 1.8)


def flight_figure() -> Figure:
    """Return the same hit through different air, and carry against backspin at three exit speeds."""
    figure, (paths, spins) = new_figure(7.0, 6.4, rows=2)
    for label, hit, air, color in (
        ("no air", HIT, VACUUM, GREY),
        ("a mile up", replace(HIT, elevation=5280 * FOOT), None, RED),
        ("wind 10 mph out", replace(HIT, wind_speed=10 * MPH), None, GREEN),
        ("sea level, calm", HIT, None, INK),
        ("wind 10 mph in", replace(HIT, wind_speed=10 * MPH, wind_direction=np.pi), None, BLUE),
    ):
        flight = fly(
            hit.motion,
            FlightConditions(
                ball=catalog.ball(), aerodynamics=catalog.aerodynamics("baseball"), air=air or hit.air, wind=hit.wind
            ),
        )
        over_ground = np.hypot(flight.positions[:, 0], flight.positions[:, 1]) / FOOT
        paths.plot(over_ground, flight.positions[:, 2] / FOOT, color=color, label=f"{label}: {over_ground[-1]:.0f} ft")
    paths.set(xlabel="distance over the ground, ft", ylabel="height, ft (stretched)", ylim=(0, 150))
    paths.legend(frameon=False, fontsize=8, loc="upper right", ncols=2)
    rates = np.linspace(0, 4000, 81)
    for speed, color in ((90, BLUE), (100, INK), (110, RED)):
        spins.plot(rates, carried(speed * MPH, rates * RPM).carry / FOOT, color=color, label=f"{speed} mph")
    spins.set(xlabel="backspin, rpm (no sidespin, 28 deg)", ylabel="carry, ft")
    spins.legend(frameon=False, fontsize=8)
    spins.grid(alpha=0.3)
    return figure


def carried(speed: float, backspin: np.ndarray, step: float = STEP) -> Flights:
    """Return flights of `HIT` at another speed (m/s), without sidespin, for many rates of backspin (rad/s)."""
    axes = spin_axes(HIT.launch_angle, 0.0)
    return flights(
        BallMotions(velocity=speed * axes[2], spin=backspin[:, None] * axes[0], position=HIT.motion.position),
        FlightConditions(
            ball=catalog.ball(), aerodynamics=catalog.aerodynamics("baseball"), air=Air(temperature=HIT.temperature)
        ),
        step=step,
    )


def flight_convergence() -> Figure:
    """Return the worst error of carry of many hits against the step, with the kernel's default marked."""
    figure, (plot,) = new_figure(7.0, 3.6)
    spin = np.linspace(0, 4000, 200) * RPM
    steps = np.array([0.5, 0.4, 0.3, 0.2, 0.15, 0.1, 0.07, 0.05, 0.035, 0.025])
    for speed, color in ((90, BLUE), (100, INK), (110, RED)):
        exact = carried(speed * MPH, spin, 0.004).carry
        errors = [np.abs(carried(speed * MPH, spin, step).carry - exact).max() / FOOT for step in steps]
        plot.loglog(steps, errors, "o-", color=color, markersize=4, linewidth=1, label=f"{speed} mph")
    guide = np.array([0.05, 0.3])
    plot.loglog(guide, 4e-2 * guide**4, "--", color=GREY, linewidth=1)
    plot.annotate("order 4", (0.12, 4e-2 * 0.12**4), xytext=(4, -12), textcoords="offset points", color=GREY)
    plot.axvline(STEP, color=GREEN, linewidth=1)
    plot.annotate(f"default {STEP:g} s", (STEP, 2e-8), xytext=(4, 0), textcoords="offset points", color=GREEN)
    plot.set(xlabel="step, s", ylabel="worst error of carry, ft")
    ticks = [0.025, 0.05, 0.1, 0.2, 0.5]
    plot.set_xticks(ticks, [f"{tick:g}" for tick in ticks])
    plot.set_xticks([], minor=True)
    plot.legend(frameon=False, fontsize=8)
    plot.grid(alpha=0.3)
    return figure

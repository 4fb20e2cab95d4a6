"""Carry of a fastball over attack angle and offset, with the place on the barrel at its best."""

from __future__ import annotations

import math

import numpy as np
from matplotlib.figure import Figure

from figures.style import INK, RED, new_figure
from sweetspot import catalog, standard_conditions
from sweetspot.analysis.full_play import plays
from sweetspot.analysis.optimum import best_swing
from sweetspot.collision.hit_in_space import Contact
from sweetspot.dynamics.reduction import reduced_bat
from sweetspot.flight.air import Air
from sweetspot.flight.conditions import FlightConditions
from sweetspot.motion.ball_motion import BallMotions
from sweetspot.motion.swing_path import Swings, path_axes
from sweetspot.units import FOOT, INCH
from sweetspot.validation.computations.flight import pitch_flight

ANGLES, OFFSETS = np.radians(np.linspace(-5, 40, 91)), np.linspace(-0.5, 2.0, 101) * INCH
LEVELS = (100, 150, 200, 250, 300, 325, 350, 375, 390, 400, 410)
LEAGUE = 9.0
"""deg, mean attack angle of the major leagues [sure2026]."""


def optimum_figure() -> Figure:
    """Return lines of equal carry in ft, the best contact, and the launch angles that go with them."""
    bat, ball = catalog.bat(), catalog.ball()
    model, swing = reduced_bat(bat, ball=ball), standard_conditions(bat).swing
    pitch = pitch_flight("four-seam").plate
    conditions = FlightConditions(ball=ball, aerodynamics=catalog.aerodynamics(), air=Air())
    best = best_swing(model, conditions, swing=swing, pitch=pitch)
    angle, offset = np.meshgrid(ANGLES, OFFSETS)
    place = np.full(angle.size, best.position)
    axes = path_axes(angle.ravel(), 0.0, tilt=np.abs(angle.ravel()), left=False)
    found = plays(
        model,
        conditions,
        swings=Swings(swing.speed_at(best.position) * np.ones(angle.size), axes),
        pitches=BallMotions(velocity=pitch.velocity, spin=pitch.spin),
        contact=Contact(place, offset.ravel()),
    )
    velocity = found.strikes.velocity
    launch = np.degrees(np.arctan2(velocity[:, 2], np.hypot(velocity[:, 0], velocity[:, 1]))).reshape(angle.shape)
    carry = found.flights.carry.reshape(angle.shape) / FOOT
    figure, (plot,) = new_figure(7.0, 4.6)
    across, up = np.degrees(angle), offset / INCH
    lines = plot.contour(across, up, carry, levels=LEVELS, cmap="viridis_r")
    plot.clabel(lines, fmt="%.0f ft", fontsize=8)
    rays = plot.contour(across, up, launch, levels=(10, 20, 30, 40), colors=INK, linewidths=0.6, linestyles=":")
    plot.clabel(rays, fmt="launch %.0f°", fontsize=7)
    plot.plot(
        math.degrees(best.attack_angle), best.offset / INCH, "o", color=RED, label=f"best: {best.carry / FOOT:.0f} ft"
    )
    column = int(np.abs(ANGLES - math.radians(LEAGUE)).argmin())
    top = int(carry[:, column].argmax())
    plot.plot(LEAGUE, OFFSETS[top] / INCH, "s", color=INK, label=f"best at {LEAGUE:.0f}°: {carry[top, column]:.0f} ft")
    plot.set(xlabel="attack angle (degrees)", ylabel="ball's center above the bat's axis (in)")
    plot.legend(loc="upper right")
    return figure

"""Off-center hits: exit speed, launch angle and spin against offset, for a level and for a tilted bat."""

from __future__ import annotations

import math

import numpy as np
from cases import analysed
from matplotlib.figure import Figure

from figures.style import BLUE, GREY, RED, new_figure
from sweetspot.collision.hit_in_space import Contact, Strikes, strikes
from sweetspot.motion.ball_motion import batted_ball, launch_angles
from sweetspot.motion.swing_path import SwingPath, Swings
from sweetspot.units import DEGREE, INCH, MPH, RPM

OFFSETS = np.linspace(-1.0, 1.75, 56) * INCH
ATTACK, FALL, PLATE_SPEED, BAT_SPEED, PITCH_SPIN = 9 * DEGREE, 6.5 * DEGREE, 82 * MPH, 72 * MPH, 2300 * RPM


def offset_figure() -> Figure:
    """Return exit speed, launch angle and spin against offset."""
    figure, (speed, angle, spin) = new_figure(7.5, 7.5, rows=3)
    for tilt, words, style in ((None, "level bat", GREY), (32 * DEGREE, "barrel tilted by 32 deg", RED)):
        found = _swept(SwingPath(attack_angle=ATTACK, tilt=tilt))
        launch, spray, (back, side, _) = launch_angles(found.velocity, found.spin)
        speed.plot(OFFSETS / INCH, found.exit_speed / MPH, color=style, label=words)
        angle.plot(OFFSETS / INCH, launch / DEGREE, color=style)
        angle.plot(OFFSETS / INCH, spray / DEGREE, color=style, linestyle="--")
        spin.plot(OFFSETS / INCH, back / RPM, color=style)
        spin.plot(OFFSETS / INCH, side / RPM, color=style, linestyle="--")
    angle.plot([], [], color=BLUE, label="launch angle")
    angle.plot([], [], color=BLUE, linestyle="--", label="spray, positive to right field")
    spin.plot([], [], color=BLUE, label="backspin")
    spin.plot([], [], color=BLUE, linestyle="--", label="side spin, negative: slice to right field")
    speed.set(ylabel="exit speed (mph)")
    angle.set(ylabel="angle (deg)")
    spin.set(ylabel="spin (rpm)", xlabel="ball's center above the bat's axis (in)")
    for plot in (speed, angle, spin):
        plot.grid(alpha=0.3)
        plot.legend(frameon=False)
    return figure


def _swept(path: SwingPath) -> Strikes:
    analysis = analysed()
    place = analysis.bat.length - 6 * INCH
    pitch = batted_ball(speed=PLATE_SPEED, launch_angle=-FALL, spray=math.pi, backspin=PITCH_SPIN)
    return strikes(
        analysis.reduced,
        ball=analysis.conditions.ball,
        swings=Swings(np.full(len(OFFSETS), BAT_SPEED), path.axes),
        pitches=pitch,
        contact=Contact(np.full(len(OFFSETS), place), OFFSETS),
    )

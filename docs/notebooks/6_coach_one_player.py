"""
Coach: one player's swings
==========================

Give the program a file of swings. It returns what the swings show, with intervals, and what they do not show. The
swings here are made up, so that we know the truth: 24 of them, half with each of two bats, hit the ball 6.5 in from
the tip with a scatter of 1.8 in.
"""

from pathlib import Path
from tempfile import mkdtemp

import numpy as np

from sweetspot import catalog
from sweetspot.player.prior import NAMES, natural
from sweetspot.player.simulate import simulated_swings
from sweetspot.units import INCH, MPH

bat, other, ball = catalog.bat("r161-ash"), catalog.bat("mlb-a"), catalog.ball()
truth = natural(np.zeros(len(NAMES)))
swings = simulated_swings(truth, bats=[bat, other], ball=ball, count=24, pitch_speed=60 * MPH, seed=4)
file = Path(mkdtemp()) / "swings.csv"
lines = ["bat,bat_speed_mph,exit_speed_mph,pitch_speed_mph"]
for swing in swings:
    lines.append(f"{swing.bat or 'r161-ash'},{swing.bat_speed / MPH:.1f},{swing.exit_speed / MPH:.1f},60")
file.write_text("\n".join(lines).replace(other.name, "mlb-a"))
print("\n".join(lines[:4]))

# %%
# Read the file as ``sweetspot fit-player swings.csv`` does, and fit:

import sweetspot

player = sweetspot.fit_player(file, bat="r161-ash")
for name in ("bat_speed", "position", "position_spread"):
    interval = player.posterior.learned[name].interval
    size, unit = (MPH, "mph") if name == "bat_speed" else (INCH, "in")
    print(f"{name:16} {interval.value / size:5.1f} {unit} ({interval.low / size:.1f} to {interval.high / size:.1f})")

# %%
# The intervals contain the truth. The interval of the place along the bat is wide, because exit speed hardly shows
# on which side of the best place a ball was hit. What would help this player?

player

# %%
# In one picture:

player.plot()

# %%
# **Try it.** Add twenty swings with the contact marked by tape: put ``position_in_from_tip`` into the file and see
# which interval shrinks.

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

own, other, ball = catalog.bat("r161-ash"), catalog.bat("mlb-a"), catalog.ball()
truth = natural(np.zeros(len(NAMES)))
swings = simulated_swings(truth, bats=[own, other], ball=ball, count=24, pitch_speed=60 * MPH, seed=4)
file = Path(mkdtemp()) / "swings.csv"
lines = ["bat,bat_speed_mph,exit_speed_mph,pitch_speed_mph"]
for one in swings:
    lines.append(f"{one.bat or 'r161-ash'},{one.bat_speed / MPH:.1f},{one.exit_speed / MPH:.1f},60")
file.write_text("\n".join(lines).replace(other.name, "mlb-a"))
print("\n".join(lines[:4]))

# %%
# Read the file as ``sweetspot fit-player swings.csv`` does, and fit:

from sweetspot.flight.air import Air
from sweetspot.player.advice import advise
from sweetspot.player.goal import Goal
from sweetspot.player.model import bats_of, player_model
from sweetspot.player.posterior import fit_player
from sweetspot.player.swings import read_swings
from sweetspot.report.player.document import player_document

read = read_swings(file, length=own.length)
good, bats, bad, notes = bats_of(read.swings, load=catalog.load_bat)
model = player_model(good, bat=own, ball=ball, others=bats, law=catalog.swing_law())
fitted = fit_player(model, seed=1)
for name in ("bat_speed", "position", "position_spread"):
    interval = fitted.learned[name].interval
    size, unit = (MPH, "mph") if name == "bat_speed" else (INCH, "in")
    print(f"{name:16} {interval.value / size:5.1f} {unit} ({interval.low / size:.1f} to {interval.high / size:.1f})")

# %%
# The intervals contain the truth. The interval of the place along the bat is wide, because exit speed hardly shows
# on which side of the best place a ball was hit. What would help this player?

advice = advise(fitted, goal=Goal("exit-speed"), aerodynamics=catalog.aerodynamics(), air=Air())
sheet = player_document(fitted, advice, read, player="made up")
sheet

# %%
# In one picture:

sheet.plot()

# %%
# **Try it.** Add twenty swings with the contact marked by tape: put ``position_in_from_tip`` into the file and see
# which interval shrinks.

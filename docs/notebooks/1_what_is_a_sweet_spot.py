"""
Lesson 1: What is a sweet spot?
===============================

Ask five people where a bat's sweet spot is, and you get five answers, because the words mean several things. This
lesson takes one bat and marks them all.
"""

import sweetspot
from sweetspot.units import INCH, MPH

result = sweetspot.standard_analysis("r161-ash")
result.plot()

# %%
# Everything above is one hit: a 90 mph pitch, and a bat that moves at 70 mph six inches from its tip. Each meaning
# has its own function. Inside the package, places are in meters from the knob end. In inches from the tip, they
# are:

for name in ("max_exit_speed", "max_collision_efficiency", "center_of_percussion", "node_1", "node_2", "min_sting"):
    place = getattr(result.sweet_spots, name)
    print(f"{name:26} {(result.bat.length - place) / INCH:5.1f} in")

# %%
# They lie close together, but they are not one place. The first two matter to the ball. The others matter to the
# hands: at the center of percussion the top hand feels no jolt, and at a node the hit does not excite that mode.
#
# What does a miss cost? The curve of exit speed is flat at the top and falls away on both sides:

import matplotlib.pyplot as plt

scan = result.scan
from_tip = (result.bat.length - scan.position) / INCH
figure, axes = plt.subplots(figsize=(7, 3.2), layout="constrained")
axes.plot(from_tip, scan.exit_speed / MPH, label="this bat")
axes.plot(from_tip, scan.rigid_exit_speed / MPH, "--", label="if it could not bend")
axes.set(xlabel="inches from the tip", ylabel="exit speed, mph", xlim=(14, 0), ylim=(40, 110))
axes.legend()
plt.show()

# %%
# **Exercises.** Put the ball on a tee, ``standard_analysis("r161-ash", pitch_speed=0.0)``. Which places move, and
# which cannot? Then try ``"youth-30"``, and a bat of your own from a file.

"""
Lesson 1: What is a sweet spot?
===============================

Ask five people where a bat's sweet spot is, and five places come back, because the words mean several things. We
take one bat and mark them all.
"""

import sweetspot
from sweetspot.units import INCH, MPH

result = sweetspot.standard_analysis("r161-ash")
result.plot()

# %%
# Everything above is one hit: a 90 mph pitch, and a bat that moves at 70 mph six inches from its tip. Each meaning
# is a function of its own. Inside the package places are metres from the knob end; from the tip, in inches, they
# are:

for name in ("max_exit_speed", "max_collision_efficiency", "center_of_percussion", "node_1", "node_2", "min_sting"):
    place = getattr(result.sweet_spots, name)
    print(f"{name:26} {(result.bat.length - place) / INCH:5.1f} in")

# %%
# They lie close together, and they are not one place. The ball cares for the first two. The hands care for the
# others: at the centre of percussion the top hand feels no jolt, at a node that mode does not ring.
#
# What is a miss worth? The curve of exit speed is flat on top and falls away:

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
# which cannot? Then take ``"youth-30"``, and a bat of your own from a file.

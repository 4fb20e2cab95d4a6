"""
Lesson 2: Why not the end?
==========================

The end moves fastest, so why does it not hit hardest? There are two reasons: momentum, then bending. The
:doc:`implemented paper </paper>` asks the same question in its equations 5 to 12, with a thin rod.
"""

from sweetspot import RigidBody, bat, beam_model, centre_of_percussion, effective_mass, rigid_body
from sweetspot.units import INCH, OUNCE

rod = RigidBody(mass=1.0, balance_point=0.5, moi_cm=1 / 12, roll_moi=0.0)
print(f"a rod of 1 m held at its end: center of percussion at {centre_of_percussion(rod, pivot=0.0):.4f} m (2/3)")
print(f"effective mass: middle {effective_mass(rod, 0.5):.2f} kg, end {effective_mass(rod, 1.0):.2f} kg")

# %%
# At the end of the rod the effective mass is a quarter of the rod's: the rod spins away. For a real bat the same
# calculation uses its outline:

wood = bat("r161-ash")
body = rigid_body(beam_model(wood))
for inches in (0, 2, 4, 6, 8, 10):
    place = wood.length - inches * INCH
    mass = effective_mass(body, place) / OUNCE
    print(f"{inches:2} in from the tip the effective mass is {mass:4.1f} oz of {body.mass / OUNCE:.1f}")

# %%
# The impulse at the hands changes sign, as the paper says: it is zero at the center of percussion. Move the hit
# along the bat:

import matplotlib.pyplot as plt
import numpy as np

from sweetspot.dynamics.rigid import hand_impulse_ratio

places = wood.length - np.linspace(0, 14, 60) * INCH
ratio = [hand_impulse_ratio(body, float(place), hands=6 * INCH) for place in places]
figure, axes = plt.subplots(figsize=(7, 3), layout="constrained")
axes.plot((wood.length - places) / INCH, ratio)
axes.axhline(0, color="gray", lw=0.8)
axes.set(xlabel="inches from the tip", ylabel="impulse at the top hand / impulse of the ball", xlim=(14, 0))
plt.show()

# %%
# Momentum alone gives the best place of a rigid bat, and this bat's best place is still elsewhere. The rest is
# bending: near the end, most of the missing energy stays in the bat as vibration.

import sweetspot
from sweetspot.units import MPH

result = sweetspot.standard_analysis(wood)
top, tip, rigid_tip = result.scan.exit_speed.max(), result.scan.exit_speed[-1], result.scan.rigid_exit_speed[-1]
print(
    f"best {top / MPH:.1f} mph; tip of a bat that cannot bend {rigid_tip / MPH:.1f}; tip as it is {tip / MPH:.1f} mph"
)

# %%
# **Exercises.** Where does a rigid bat hit best, and why not at the center of percussion? Choke up two inches
# (``wood.replaced(choke=2 * INCH)``): which of the two curves moves?

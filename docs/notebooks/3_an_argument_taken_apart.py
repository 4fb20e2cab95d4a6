"""
Lesson 3: A published argument, taken apart
===========================================

The :doc:`implemented paper </paper>` says where a bat's sweet spot is, and why corked and metal bats would hit
farther. Here is its chain: what it states, what its own formula gives, and what the full model says of the same
thing.
"""

import sweetspot

sweetspot.paper("r161-ash")

# %%
# One step of it by hand. Equation 11 puts the best place where the hands feel nothing, x = J / (m l) beyond the
# centre of mass. For a rod held at its end that is two thirds of its length:

from sweetspot.paper.formulas import best_point_beyond_centre, rod

thin = rod(length=0.84, mass=0.9)
beyond = best_point_beyond_centre(thin, hands=0.0)
print(f"{thin.balance_point + beyond:.3f} m of 0.840 m; two thirds are {2 / 3 * 0.84:.3f} m")

# %%
# And the claim on cork: a lighter barrel is swung faster. It is, and the ball meets less. Which wins?

sweetspot.compare_corked("r161-ash").plot()

# %%
# The lower panel is the difference: below zero along the barrel. Measured corked bats say the same (Nathan and
# others, 2011).
#
# **Exercises.** The formula W for the energy returned takes the share z as given, 2 % for wood and 10 % for metal.
# Find both shares in the table above as the full model has them. What wall would a metal bat need to hold a tenth?

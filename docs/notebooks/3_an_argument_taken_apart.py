"""
Lesson 3: A published argument, step by step
============================================

The :doc:`implemented paper </paper>` says where a bat's sweet spot is, and why corked and metal bats would hit
farther. Here is its chain of claims: what it states, what its own formula gives, and what the full model gives for
the same quantity.
"""

import sweetspot

sweetspot.paper("r161-ash")

# %%
# Here is one step by hand. Equation 11 puts the best place where the hands feel nothing, x = J / (m l) beyond the
# center of mass. For a rod held at its end that is two thirds of its length:

from sweetspot.papers.formulas import best_point_beyond_centre, rod

thin = rod(length=0.84, mass=0.9)
beyond = best_point_beyond_centre(thin, hands=0.0)
print(f"{thin.balance_point + beyond:.3f} m of 0.840 m; two thirds are {2 / 3 * 0.84:.3f} m")

# %%
# Next, the claim about cork: a lighter barrel is swung faster. That is true, but it hits with less mass. Which
# effect wins?

sweetspot.compare("r161-ash", what_if="cork").plot()

# %%
# The lower panel shows the difference: it is below zero along the barrel. Measurements of corked bats agree (Nathan
# and others, 2011).
#
# **Exercises.** The formula W for the energy returned takes the share z as given, 2 % for wood and 10 % for metal.
# Find both shares from the full model in the table above. What wall would a metal bat need to store a tenth?

"""
Lesson 4: A bat that vibrates
=============================

Tap a bat at different places and listen: at a node a tone is missing. A bat is a beam with free ends, and its
outline and wood determine its tones.
"""

import matplotlib.pyplot as plt
import numpy as np

from sweetspot import bat, beam_model, bending_modes
from sweetspot.units import INCH

wood = bat("r161-ash")
modes = bending_modes(beam_model(wood))
bending = modes.of_family("bending")[:3]

places = np.linspace(0, wood.length, 200)
shapes = modes.shape_at(places)  # a row for each place, a column for each mode
figure, axes = plt.subplots(figsize=(7, 3.2), layout="constrained")
for index in bending:
    shape = shapes[:, index]
    axes.plot(places / INCH, shape / abs(shape).max(), label=f"{modes.frequency[index]:.0f} Hz")
axes.axhline(0, color="gray", lw=0.8)
axes.set(xlabel="inches from the knob", ylabel="displacement")
axes.legend(loc="lower left")
plt.show()

# %%
# The nodes are where the curves cross zero. In inches from the tip:

for index in bending:
    nodes = [(wood.length - node) / INCH for node in modes.nodes(index)]
    print(f"{modes.frequency[index]:6.0f} Hz  " + "  ".join(f"{node:4.1f}" for node in nodes))

# %%
# Compare a hit on the node of the first mode with one at the tip. See where the energy goes. The ball also dents the
# wood, so the hits use all modes, not only the bending ones:

from sweetspot import all_modes, standard_conditions
from sweetspot.analysis.bat_analysis import hit_at

conditions = standard_conditions(wood)
struck = all_modes(beam_model(wood), conditions.ball)
hit_at(wood.length - 6.7 * INCH, modes=struck, conditions=conditions)

# %%
# At the tip:

hit_at(wood.length - 1 * INCH, modes=struck, conditions=conditions)

# %%
# Is the computation fine enough? A plain rod has few sections of its own, so it shows the effect of the elements:

rod = beam_model(bat("uniform-rod"))
for elements in (4, 8, 16, 32):
    coarse = bending_modes(rod, elements=elements)
    print(f"{elements:3} elements  " + "  ".join(f"{f:8.2f}" for f in coarse.frequency[bending]))

# %%
# **Exercises.** Hold the handle in a vice: :func:`sweetspot.held_modes` with ``Hands(mass=50, stiffness=5e6)``. What
# happens to the tones and to the ball's speed? Record a tapped bat with your phone and give the file to
# ``sweetspot tap``.

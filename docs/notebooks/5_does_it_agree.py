"""
Lesson 5: Does it agree with measurements?
==========================================

A model that explains everything but predicts nothing is worth little. sweetspot keeps every published number that
it was compared with, and its source, misses included.
"""

from sweetspot import validation
from sweetspot.validation.verdicts import headline

found = validation.results()
print(headline(found))

# %%
# The kinds of evidence, and how many rows miss:

from sweetspot.validation.verdicts import summary

print(f"{'evidence':34} {'rows':>5} {'hold':>5} {'explained':>10} {'fail':>5}")
for part in summary(found):
    print(f"{part.evidence:34} {part.rows:5} {part.hold:5} {part.explained_misses:10} {part.fail:5}")

# %%
# Predictions about bats, computed over printed. On the line the two agree:

import matplotlib.pyplot as plt

bats = [
    result
    for result in found
    if result.evidence == "prediction about bats"
    and result.printed.replace(".", "").isdigit()
    and float(result.printed)
]
figure, axes = plt.subplots(figsize=(5.5, 5), layout="constrained")
ratio = [result.computed / float(result.printed) for result in bats]
missed = [bool(result.expected_miss) for result in bats]
axes.axhline(1, color="gray", lw=0.8)
axes.scatter(range(len(bats)), ratio, s=12, c=["tab:red" if miss else "tab:blue" for miss in missed])
axes.set(xlabel="predictions, source by source (red: an explained miss)", ylabel="computed / printed", ylim=(0.5, 1.5))
plt.show()

# %%
# **Exercises.** Pick one red point. Which source is it, and what reason does :doc:`the page on validation
# </validation>` give? What measurement would decide?

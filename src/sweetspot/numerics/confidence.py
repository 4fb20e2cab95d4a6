"""How sure every interval of the package is: one level for all of them.

A difference whose interval leaves zero out is called sure. As the interval is central, the chance that the difference
has the other sign is then at most (1 - `LEVEL`) / 2, one in twenty.
"""

LEVEL = 0.9
"""Probability that the true value lies inside an interval."""
REACH = 1.6448536269514722
"""Half width of a normal distribution's interval of that level in standard deviations."""
ENDS = (0.05, 0.95)
"""Parts of a distribution that lie below the interval's two ends."""

"""Places on the way from the pitcher's rubber to the plate, m in front of the plate's tip."""

from __future__ import annotations

from sweetspot.units import FOOT, INCH

PLATE = 17 * INCH
"""The front edge of the plate, where Statcast's pitches end."""
REFERENCE = 50 * FOOT
"""Where Statcast gives velocity and acceleration [savant_2020day]."""
RUBBER = 60.5 * FOOT
"""The front of the pitcher's rubber, by the rules."""
MIDDLE = (0.0, 2.5 * FOOT)
"""m right and up: about the middle of a strike zone, over the plate."""

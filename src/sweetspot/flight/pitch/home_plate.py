"""From the pitcher's rubber to the plate: places, m in front of the plate's tip, and the speed lost on the way."""

from __future__ import annotations

from sweetspot.units import FOOT, INCH

PLATE = 17 * INCH
"""The front edge of the plate, where Statcast's pitches end."""
REFERENCE = 50 * FOOT
"""Where Statcast gives velocity and acceleration [savant_2020day]."""
RUBBER = 60.5 * FOOT
"""The front of the pitcher's rubber, by the rules."""
PLATE_OVER_RELEASE = 0.920
"""Speed of a pitch at the plate over that at release, 0.920 +- 0.007 over 2507 pitches [savant_2020day]."""
MIDDLE = (0.0, 2.5 * FOOT)
"""m right and up: about the middle of a strike zone, over the plate."""

"""Factors that turn people's units into SI."""

from __future__ import annotations

import math

INCH = 0.0254
OUNCE = 0.028349523125
MPH = 0.44704
POUND_FORCE = 4.4482216152605
FOOT = 0.3048
RPM = math.pi / 30
DEGREE = math.pi / 180
STANDARD_GRAVITY = 9.80665
"""m/s^2, by definition."""
INCH_OF_MERCURY = 13595.1 * STANDARD_GRAVITY * INCH
"""Pa: conventional mercury, 13,595.1 kg/m^3 at 0 degC, under standard gravity; as exact as all others here."""
OUNCE_INCH_SQUARED = OUNCE * INCH**2

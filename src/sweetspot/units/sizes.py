"""Sizes of people's units in SI."""

from __future__ import annotations

import math

INCH = 0.0254
OUNCE = 0.028349523125
MPH = 0.44704
POUND_FORCE = 4.4482216152605
FOOT = 0.3048
RPM = math.pi / 30
DEGREE = math.pi / 180
INCH_OF_MERCURY = 3386.389
"""Pa, at 0 degC; all others here are exact."""
OUNCE_INCH_SQUARED = OUNCE * INCH**2

"""Constants of nature and of the field, each once."""

from __future__ import annotations

from sweetspot.units import INCH

STANDARD_GRAVITY = 9.80665
"""m/s^2, by definition."""
STANDARD_AXIS = 6 * INCH
"""m from the knob end: where laboratories hang and clamp a bat, and about which swing weight is quoted
[wsu_glossary]."""

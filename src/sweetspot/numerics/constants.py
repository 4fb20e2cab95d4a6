"""Constants of nature and of the field, each once."""

from __future__ import annotations

from sweetspot.units.factors import INCH, STANDARD_GRAVITY

__all__ = ["STANDARD_AXIS", "STANDARD_GRAVITY"]

STANDARD_AXIS = 6 * INCH
"""m from the knob end: where laboratories hang and clamp a bat, and about which swing weight is quoted
[wsu_glossary]."""

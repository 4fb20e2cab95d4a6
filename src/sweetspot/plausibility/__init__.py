"""Whether a value can be: one table of bounds by quantity and sport, and the one reader of what people type."""

from sweetspot.plausibility.bounds import Judged, PlausibleRange, insisted, insisting
from sweetspot.plausibility.places import check_angle, check_angles, check_place
from sweetspot.plausibility.reading import example_of, parse, parse_position
from sweetspot.plausibility.table import bounds, check, check_possible, fine, objection, verdict

__all__ = [
    "Judged",
    "PlausibleRange",
    "bounds",
    "check",
    "check_angle",
    "check_angles",
    "check_place",
    "check_possible",
    "example_of",
    "fine",
    "insisted",
    "insisting",
    "objection",
    "parse",
    "parse_position",
    "verdict",
]

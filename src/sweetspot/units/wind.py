"""Where a wind blows to: the convention of its number, and the words of ballparks for it."""

from __future__ import annotations

import re

from sweetspot.units.factors import DEGREE

BLOWS_TO = {
    "out": 0,
    "out to right field": 45,
    "left to right": 90,
    "in from left field": 135,
    "in": 180,
    "in from right field": -135,
    "right to left": -90,
    "out to left field": -45,
}
"""Degrees that the wind blows to, as words say it: 0 is out to centre field, positive to right field.

The words are the eight of the league's weather reports ("Out To RF", "L To R", "In From CF"), an eighth of a turn
apart.
"""
ALIKE = (
    (r"[-_\s]+", " "),
    (r"\brf\b", "right field"),
    (r"\blf\b", "left field"),
    (r"\bcf\b", "center"),
    (r"\br\b", "right"),
    (r"\bl\b", "left"),
    (r"\b(?:the|blowing|blows|straight|dead|wind|side) ?", ""),
    (r"\btowards?\b", "to"),
    (r"\b(out|in)wards?\b", r"\1"),
    (r"\bcent(?:re|er)(?: ?field)?\b", "center"),
    (r"^(?:out )?to center$", "out"),
    (r"^(?:in )?from center$", "in"),
    (r"^from left$|^to right$", "left to right"),
    (r"^from right$|^to left$", "right to left"),
    (r"^out (?:to )?(right|left)$|^to (right|left) ?field$", r"out to \1\2 field"),
    (r"^in from (right|left)$|^from (right|left) ?field$", r"in from \1\2 field"),
)
"""What is spelled otherwise and means the same, put right one after the other."""


def in_words(text: str) -> float | None:
    """Return rad that a wind blows to, from words; None where they are no such words.

    >>> [round(in_words(text) / DEGREE) for text in ("out", "In From CF", "from left", "L to R", "out to right")]
    [0, 180, 90, 90, 45]
    """
    words = text.strip().lower()
    for pattern, plain in ALIKE:
        words = re.sub(pattern, plain, words).strip()
    return BLOWS_TO[words] * DEGREE if words in BLOWS_TO else None

"""Signs that a terminal may lack, written with letters: nothing that a number means is lost as a question mark."""

from __future__ import annotations

SIGNS = {"±": "+/-", "²": "^2", "³": "^3", "°": "deg", "·": "*", "×": "x", "…": "..."}
"""Of what answers are written with; letters of people's names have no other spelling here."""


def spelled_for(encoding: str, text: str) -> str:
    """Return a text with the signs spelled that an encoding lacks.

    >>> spelled_for("ascii", "10,300 ± 1000 oz in² at 21 °C"), spelled_for("cp1252", "1 ± 2")
    ('10,300 +/- 1000 oz in^2 at 21 degC', '1 ± 2')
    """
    if text.isascii():
        return text
    lacking = (sign for sign in SIGNS if sign in text and not sign.encode(encoding, "ignore"))
    return text.translate({ord(sign): SIGNS[sign] for sign in lacking})

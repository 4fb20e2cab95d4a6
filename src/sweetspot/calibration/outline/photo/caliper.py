"""One caliper reading of the barrel that a photographed outline is checked against, and brought to."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from sweetspot.calibration.outline.photo.photo_outline import PhotoOutline
from sweetspot.errors import InputError
from sweetspot.numerics.interval import REACH

MOST_OFF = 0.12
"""Part by which a picture's barrel may differ from the caliper's (our choice); more is another bat or another scale."""
AGREES = 1e-3
"""Part of the barrel below which nothing is said."""


def at_caliper(outline: PhotoOutline, barrel: float, what: str) -> PhotoOutline:
    """Return an outline whose thickest place is as a caliper reads it, m, all its diameters in proportion.

    A picture that was squeezed is too narrow in proportion, blurred edges are off by the same everywhere. One reading
    does not tell which, so half of what lies between the two is added to the errors, one sigma:

        (1 - d / d_barrel) |caliper - picture| / 2
    """
    place, diameter = np.array(outline.profile).T
    seen = float(diameter.max())
    factor = barrel / seen
    if not abs(factor - 1) < MOST_OFF:
        raise InputError(
            f"{what} shows a barrel of {1e3 * seen:.1f} mm, and --barrel was given as {1e3 * barrel:.1f} mm; check the "
            "caliper's unit, --length, and that it is the same bat"
        )
    either = (1 - diameter / seen) * abs(barrel - seen) / 2
    error = np.hypot(np.array(outline.diameter_error) * factor, either)
    usual = REACH * float(np.interp(place[np.argmax(diameter)], place, outline.diameter_error))
    surprise = "" if abs(barrel - seen) < usual else ", more than its own ±: the picture may have been squeezed"
    words = (
        f"The caliper reads {1e3 * barrel:.1f} mm where the picture shows {1e3 * seen:.1f} mm{surprise}. All diameters "
        f"were made {abs(factor - 1):.1%} {'wider' if factor > 1 else 'narrower'}."
    )
    return replace(
        outline,
        profile=tuple(zip(place.tolist(), (diameter * factor).tolist(), strict=True)),
        diameter_error=tuple(error.tolist()),
        notes=(*outline.notes, words) if abs(factor - 1) > AGREES else outline.notes,
    )

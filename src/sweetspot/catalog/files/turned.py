"""The outline of a turned bat from the few sizes that people know of one."""

from __future__ import annotations

import numpy as np

from sweetspot.equipment.base import Positive, Validated
from sweetspot.equipment.shell import Stations
from sweetspot.errors import InputError
from sweetspot.units import INCH

TAPER_STATIONS = 7
KNOB = ((0.0, 0.86), (0.3, 1.0), (0.6, 0.98))
"""(inches from the knob end, part of the knob's diameter): a rounded disc."""
HANDLE_START = 1.25
"""inches from the knob end where the knob's flare has become the handle."""
TIP = ((2.5, 1.0), (1.2, 0.975), (0.5, 0.91), (0.15, 0.80), (0.0, 0.66))
"""(inches from the tip, part of the barrel's diameter): a rounded end."""


class Turned(Validated):
    """The sizes that people know of a turned bat, m; positions from the knob end, the other three are diameters."""

    length: Positive
    knob: Positive
    handle: Positive
    barrel: Positive
    taper_start: float
    taper_end: float

    def profile(self) -> Stations:
        """Return (position, diameter) stations of a bat with knob, straight handle, smooth taper, barrel and round end.

        The taper follows 3 t^2 - 2 t^3 from its start to its end. The shapes of knob and end are typical ones
        (assumed), scaled by their diameters. Raises `InputError` when knob flare, taper and end do not follow one
        another.
        """
        flare, end = HANDLE_START * INCH, self.length - TIP[0][0] * INCH
        start, stop = self.taper_start, self.taper_end
        if not flare < start < stop <= end:
            raise InputError(
                f"the taper runs from {start:.4g} m to {stop:.4g} m; allowed is from more than {flare:.4g} m "
                f"to at most {end:.4g} m on this bat, start before end"
            )
        stations = [(inches * INCH, part * self.knob) for inches, part in KNOB]
        stations.append((flare, self.handle))
        part = np.linspace(0, 1, TAPER_STATIONS + 2)
        rise = self.handle + (self.barrel - self.handle) * (3 * part**2 - 2 * part**3)
        stations += zip((start + (stop - start) * part).tolist(), rise.tolist(), strict=True)
        places = [(self.length - inches * INCH, part * self.barrel) for inches, part in TIP]
        return (*stations, *((place, size) for place, size in places if place > stop))

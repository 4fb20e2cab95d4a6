"""The outline of a turned bat from the few sizes that people know of one."""

from __future__ import annotations

import numpy as np

from sweetspot.errors import InputError
from sweetspot.units import INCH

TAPER_STATIONS = 7
KNOB = ((0.0, 0.86), (0.3, 1.0), (0.6, 0.98))
"""(inches from the knob end, part of the knob's diameter): a rounded disc."""
HANDLE_START = 1.25
"""inches from the knob end where the knob's flare has become the handle."""
TIP = ((2.5, 1.0), (1.2, 0.975), (0.5, 0.91), (0.15, 0.80), (0.0, 0.66))
"""(inches from the tip, part of the barrel's diameter): a rounded end."""


def turned_profile(
    *, length: float, knob: float, handle: float, barrel: float, taper_start: float, taper_end: float
) -> tuple[tuple[float, float], ...]:
    """Return (position, diameter) stations of a bat with knob, straight handle, smooth taper, barrel and round end.

    The taper follows 3 t^2 - 2 t^3 from ``taper_start`` to ``taper_end``. The shapes of knob and end are typical
    ones (assumed), scaled by their diameters.

    Parameters
    ----------
    length, knob, handle, barrel : m; the last three are diameters.
    taper_start, taper_end : m from the knob end.

    Raises
    ------
    InputError
        when knob flare, taper and end do not follow one another.
    """
    flare, end = HANDLE_START * INCH, length - TIP[0][0] * INCH
    if not flare < taper_start < taper_end <= end:
        raise InputError(
            f"the taper runs from {taper_start:.4g} m to {taper_end:.4g} m; allowed is from more than {flare:.4g} m "
            f"to at most {end:.4g} m on this bat, start before end"
        )
    stations = [(inches * INCH, part * knob) for inches, part in KNOB]
    stations.append((flare, handle))
    part = np.linspace(0, 1, TAPER_STATIONS + 2)
    rise = handle + (barrel - handle) * (3 * part**2 - 2 * part**3)
    stations += zip((taper_start + (taper_end - taper_start) * part).tolist(), rise.tolist(), strict=True)
    stations += [(length - inches * INCH, part * barrel) for inches, part in TIP if length - inches * INCH > taper_end]
    return tuple(stations)

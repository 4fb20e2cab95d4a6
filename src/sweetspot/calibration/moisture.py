"""What moisture makes of a wooden bat, and what was measured brought to the usual 12 %.

Wood that dries gets lighter and stiffer: for a moisture u, mass of water over that of the dry wood, m ~ 1 + u, and E
falls by about 1.5 % for each per cent of moisture (assumed, between those of ash and maple in [usda_wood_handbook]).
What goes as m^p E^r is moved by p d ln m + r d ln E: weight and moment of inertia with p = 1, frequencies with
f ~ sqrt(E / m). A balance point and a period hardly change.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import replace

from sweetspot.calibration.measured import Measured
from sweetspot.calibration.measurements import MeasuredKind, Measurement

USUAL_MOISTURE = 0.12
"""At which tables give wood's properties [usda_wood_handbook]."""
MOISTURES = (0.02, 0.3)
"""Allowed: from wood just out of a kiln to the saturation of its fibres (both recalled); bats lie well within."""
STIFFER = 1.5
"""Logarithm of E lost per unit of moisture (assumed)."""
POWERS: Mapping[MeasuredKind, tuple[float, float]] = {"mass": (1.0, 0.0), "moi": (1.0, 0.0), "frequency": (-0.5, 0.5)}
"""p and r by kind of measurement."""


def at_usual_moisture(measurement: Measurement, moisture: Measured) -> Measurement:
    """Return a measurement as it would be at 12 % of moisture, with what the moisture's own error adds.

    Parameters
    ----------
    moisture : mass of water over that of the dry wood.
    """
    of_mass, of_modulus = POWERS.get(measurement.kind, (0.0, 0.0))
    heavier = math.log((1 + moisture.value) / (1 + USUAL_MOISTURE))
    limper = STIFFER * (moisture.value - USUAL_MOISTURE)
    factor = math.exp(of_modulus * limper - of_mass * heavier)
    value, slope = measurement.value, abs(of_mass - of_modulus * STIFFER)  # d ln m / du = 1 / (1 + u), nearly 1
    moved = Measured(value.value * factor, value.error * factor).widened(slope * moisture.error * value.value)
    return replace(measurement, value=moved)

"""Numbers as Python users give them: plain ones are SI; `pint` quantities and texts with a unit are converted to SI."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any

from sweetspot.errors import InputError
from sweetspot.units.text import SI, Kind, to_si

KINDS: Mapping[Kind, str] = {
    "speed": (
        "speed bat_speed bat_speed_spread pitch_speed release_speed exit_speed closing_speed velocity reference_speed "
        "wind wind_speed"
    ),
    "angle": ("launch_angle spray bearing attack_angle attack_direction tilt direction approach_angle entry_angle"),
    "wind direction": "wind_direction",
    "angular speed": "backspin sidespin gyrospin spin pitch_backspin pitch_sidespin",
    "length": (
        "position lateral at beside offset offset_spread contact contact_spread doubt handle deepest_cup "
        "pivot hands measured_at bat_speed_at spacing length diameter depth "
        "choke moi_axis balance_point radius plug bore_diameter bore_depth cup_depth rod_hands hands_moved elevation "
        "reference_height calm_below height forward drop_height thickness block_thickness size pivot_of_table line "
        "ruler camera_distance barrel places"
    ),
    "pressure": "longitudinal_modulus shear_modulus transverse_modulus pressure strength",
    "density": "density air",
    "mass": "mass",
    "moi": "moi clamp_inertia",
    "time": "step period",
    "temperature": "temperature ball_temperature",
    "ratio": (
        "humidity wind_profile ball_cor ball_humidity standard_ball_cor ball_restitution wood_restitution "
        "metal_restitution wood_share metal_share diameter_error drag"
    ),
}
"""Names of parameters and fields by what they are."""
KIND_OF: Mapping[str, Kind] = {name: kind for kind, names in KINDS.items() for name in names.split()}
"""What a parameter or field of this name is."""
PLAIN = {float, int, bool, type(None)}
"""Types of values that need no look, and no time."""


def in_si(value: Any, name: str) -> Any:
    """Return a value in SI: a number or array as it is, a quantity or a text with its unit converted.

    Raises `InputError` for a wrong dimension, a text without a unit, or a quantity of a library that is not understood.

    Parameters
    ----------
    value : one or many (list, array, series); a `pint` quantity of the right dimension, or a text like ``103 mph``.

    Returns
    -------
    float or array
        in SI, temperatures in degC.

    >>> round(in_si("103 mph", "speed"), 2), in_si(46.0, "speed"), in_si(["28deg", 0.5], "launch_angle").round(2)
    (46.05, 46.0, array([0.49, 0.5 ]))
    """
    if type(value) in PLAIN:
        return value
    if isinstance(value, str):
        return to_si(value, KIND_OF[name], name)  # what is unusual is warned of where it is used
    if hasattr(value, "dimensionality"):
        return _magnitude(value, name)
    if hasattr(value, "unit") or hasattr(value, "units"):
        raise InputError(
            f"{name} was given as a {type(value).__name__} with a unit of its own, which is not understood here; "
            "give plain numbers in SI, a pint quantity, or a text with its unit"
        )
    if getattr(getattr(value, "dtype", None), "kind", "") in {"f", "i", "u"}:
        return value
    return _each(value, name)


def _each(values: Any, name: str) -> Any:
    """Return many values in SI, of which each may have its own unit; what is none of that is returned as it is."""
    import numpy as np

    if isinstance(values, (list, tuple)):
        return np.array([in_si(value, name) for value in values], dtype=float) if _one_shape(values) else values
    array = np.asarray(values)
    if array.dtype.kind not in {"O", "U"} or array.ndim == 0:
        return values
    found = [math.nan if value is None else in_si(value, name) for value in array.ravel().tolist()]
    return np.array(found, dtype=float).reshape(array.shape)


def _one_shape(values: Any) -> bool:
    """Return whether every one of a list is a number, a text or a quantity, or all are lists of one length."""
    lengths = {len(value) if isinstance(value, (list, tuple)) else -1 for value in values}
    return len(lengths) <= 1


def _magnitude(quantity: Any, name: str) -> Any:
    from pint import PintError

    kind = KIND_OF[name]
    unit, example = SI[kind]
    try:
        found = quantity.to("degC" if kind == "temperature" else unit).magnitude
    except PintError:
        article = "an" if kind[0] in "aeiou" else "a"
        raise InputError(
            f"{name} was given as {quantity}, which is not {article} {kind}; write for example {example}"
        ) from None
    return float(found) if not getattr(found, "ndim", 0) else found

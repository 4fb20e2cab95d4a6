"""The collision solver as a module of JavaScript: translated from the very functions that numba compiles."""

from __future__ import annotations

from functools import cache

from sweetspot.analysis import sweet_spot
from sweetspot.collision import compiled, kernel_arrays, time_history
from sweetspot.collision.closed_form import (
    collision_efficiency,
    exit_speed,
    free_restitution,
    restitution_from_efficiency,
)
from sweetspot.numerics.interpolants import vertex
from sweetspot.numerics.interval import REACH
from sweetspot.reports.bat import words
from sweetspot.web.offline.translation import javascript_of

FUNCTIONS = (
    compiled.solve,
    free_restitution,
    collision_efficiency,
    exit_speed,
    restitution_from_efficiency,
    vertex,
)
CONSTANTS = {
    "RESULT_ROWS": kernel_arrays.RESULT_ROWS,
    "NARROWEST": sweet_spot.NARROWEST,
    "ZONE_LOSS": sweet_spot.ZONE_LOSS,
    "ZONE_STING": sweet_spot.ZONE_STING,
    "NEAR_BEST": words.NEAR,
    "LITTLE": words.LITTLE,
    "ARRIVAL": time_history.ARRIVAL,
    "DURATION": time_history.DURATION,
    "FREE_FRAMES": time_history.FREE_FRAMES,
    "REACH": REACH,
}
"""What other modules of the file need to know."""
STEPPING = "while ((busy > 0)) {"
SIGNATURE = "function $solve(lane_count, closing_speed, bat, ball, steps, output)"


@cache
def translated_solver() -> str:
    """Return the module; one hit is solved at a time, and a function may watch every time step of it."""
    text = javascript_of(FUNCTIONS, constants={"LANES": 1}, others=CONSTANTS)
    for place, instead in (
        (SIGNATURE, SIGNATURE.replace("output", "output, watch = null")),
        (STEPPING, f"{STEPPING}\nif (watch) watch(lanes);"),
    ):
        assert text.count(place) == 1, place
        text = text.replace(place, instead)
    return text

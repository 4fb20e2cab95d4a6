"""What the cases ask the package for, listed by name.

Each computation takes keyword arguments (texts in a case file become SI numbers by their name). It returns a number in
SI, or a thing of which the case names one number by its ``of``.
"""

import inspect
from collections.abc import Callable
from typing import Any

from sweetspot.collision.closed_form import collision_efficiency
from sweetspot.papers.formulas import energy_returned
from sweetspot.validation.computations import (
    bat_tests,
    collision,
    field_tests,
    flight,
    golf,
    hollow,
    modes,
    paddles,
    rigid,
    shared,
    space,
    sports,
)


def _is_computation(function: Any) -> bool:
    """Return whether a function takes keyword arguments only."""
    if not inspect.isfunction(inspect.unwrap(function)):
        return False
    kinds = {parameter.kind for parameter in inspect.signature(function).parameters.values()}
    return bool(kinds) and kinds <= {inspect.Parameter.KEYWORD_ONLY, inspect.Parameter.VAR_KEYWORD}


_OTHERS: dict[str, Callable[..., Any]] = {
    "efficiency_from_restitution": collision_efficiency,
    "returned_energy": energy_returned,
    "standard": shared.standard,
    "body": shared.body,
    "pitch_flight": flight.pitch_flight,
}

COMPUTATIONS = _OTHERS | {
    name: function
    for module in (rigid, modes, collision, bat_tests, hollow, field_tests, space, sports, golf, paddles, flight)
    for name, function in vars(module).items()
    if name[0] != "_" and getattr(function, "__module__", "") == module.__name__ and _is_computation(function)
}
"""Every computation by the name that case files use: the public functions of the modules, and a few others."""

"""What the cases ask the package for: small functions in SI, listed by name.

Each takes keyword arguments (texts in a case file become SI numbers by their name) and returns one number in SI.
"""

from collections.abc import Callable
from inspect import isfunction
from types import ModuleType

from sweetspot.validation.computations import bats, collision, flight, inertia, laboratory, space, sports


def computations_of(module: ModuleType) -> dict[str, Callable[..., float]]:
    """Return every public function that a module defines, by name."""
    own = {name: each for name, each in vars(module).items() if isfunction(each) and not name.startswith("_")}
    return {name: each for name, each in own.items() if each.__module__ == module.__name__}


COMPUTATIONS: dict[str, Callable[..., float]] = {
    name: computation
    for module in (inertia, bats, collision, laboratory, space, sports, flight)
    for name, computation in computations_of(module).items()
}
"""Every computation by the name that case files use."""

"""What the cases ask the package for: small functions in SI, listed by name.

Each takes keyword arguments (texts in a case file become SI numbers by their name) and returns one number in SI.
"""

from collections.abc import Callable

from sweetspot.validation.computations import (
    collision,
    corked,
    flight,
    handle,
    hollow,
    identities,
    inertia,
    laboratory,
    modes,
    optimum,
    pitching,
    space,
    sports,
    torpedo,
    whole_play,
)

COMPUTATIONS: dict[str, Callable[..., float]] = {
    function.__name__: function
    for module in (
        identities,
        inertia,
        modes,
        collision,
        laboratory,
        handle,
        corked,
        hollow,
        space,
        sports,
        pitching,
        optimum,
        flight,
        torpedo,
        whole_play,
    )
    for function in module.COMPUTATIONS
}
"""Every computation by the name that case files use."""

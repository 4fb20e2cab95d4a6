"""What `sweetspot.NAME` adds to a function: names, files and quantities are taken where it works on things and SI.

A door is opened once per function, when it is first used; inside the package the functions call each other directly.
What is wanted is read off the annotations, and modules are loaded only where something is to be made of a name.
"""

from __future__ import annotations

import inspect
import warnings
from collections.abc import Callable, Mapping
from functools import lru_cache, wraps
from pathlib import Path
from typing import TYPE_CHECKING, Any, Final

from sweetspot.errors import InputError, UnusualWarning
from sweetspot.plausibility import bounds, insisted
from sweetspot.plausibility.table import TABLE
from sweetspot.units.quantities import KIND_OF, in_si

if TYPE_CHECKING:
    from sweetspot.dynamics.reduction import ReducedBat
    from sweetspot.equipment.ball import Ball
    from sweetspot.equipment.implement import Implement

NUMBERS = {"float", "float | None", "ArrayLike", "Real"}
"""Annotations of parameters that are converted by their name."""
BAT = "a bat or another implement, its name in the catalogue (`sweetspot bats` lists them) or its file"
ROUND_BAT = "a round bat, its name in the catalogue (`sweetspot bats` lists them) or its file"
THINGS: Mapping[str, tuple[set[str], str]] = {
    "Given": ({"Implement"}, BAT),
    "Implement": ({"Implement"}, BAT),
    "Implement | str | Path": ({"Implement"}, BAT),
    "Bat": ({"Bat"}, ROUND_BAT),
    "BeamModel": ({"BeamModel"}, f"what `beam_model` returns, or {BAT}"),
    "RigidBody": ({"RigidBody"}, f"what `rigid_body` returns, or {BAT}"),
    "Modes": ({"Modes"}, f"what `all_modes` returns, or {BAT}"),
    "ReducedBat[Bat]": ({"ReducedBat"}, f"what `reduced_bat` returns, or {ROUND_BAT}"),
    "Analysis": ({"Analysis"}, f"what `analyse` returns, or {BAT}"),
    "Ball": ({"Ball"}, "what `catalog.ball` returns, or a ball's name in the catalogue"),
    "SwingLaw | None": ({"SwingLaw", "NoneType"}, "what `catalog.swing_law` returns, or None for the same speed"),
    "Park": ({"Park"}, "what `catalog.park` returns, or a park's name in the catalogue"),
    "Conditions": ({"Conditions"}, "what `standard_conditions` returns for the bat"),
    "FlightConditions": ({"FlightConditions"}, "what `standard_flight` returns"),
    "BallMotion": ({"BallMotion"}, "what `launched` returns for one ball"),
    "BallMotion | BallMotions": ({"BallMotion", "BallMotions"}, "what `launched` returns"),
    "Impact": ({"Impact"}, "what `hit` or `hit_at` returns"),
    "Swing": ({"Swing"}, "a `Swing`, as `standard_conditions(bat).swing`"),
    "Swings": ({"Swings"}, "`Swings`"),
    "SwingPath": ({"SwingPath"}, "a `SwingPath`"),
    "Hands": ({"Hands"}, "`Hands`"),
    "Contact": ({"Contact"}, "a `Contact`"),
}
"""By annotation: names of the types that a function takes, and how to say so."""
MANY = {"Sequence[Given]": "Given", "Iterable[Park]": "Park"}
"""By annotation of several things: that of each."""
NAMED = {"Ball": "ball", "SwingLaw | None": "swing_law", "Park": "park"}
"""By annotation: the catalogue's function that loads the thing by its name."""
HITTERS = {
    *("Given", "Implement", "Implement | str | Path", "Bat", "Sequence[Given]"),
    *("BeamModel", "RigidBody", "Modes", "ReducedBat[Bat]", "Analysis"),
}
"""Annotations of parameters for which a bat may be given; the first says whose sport, ball and swing are usual."""
FILLED = {"Conditions", "Ball", "SwingLaw | None"}
"""Annotations of parameters that follow from the bat where they are left out."""
LONGEST_SHOWN = 60
"""Letters of what was given that a message repeats."""


class _Usual:
    """The default of a parameter that follows from the bat: the usual swing, ball or law of its sport."""

    def __repr__(self) -> str:
        return "usual"


USUAL_FOR_IT: Final = _Usual()


def opened(function: Callable[..., Any]) -> Callable[..., Any]:
    """Return a function that also takes names, files, texts with units and `pint` quantities.

    Where a bat is given and its conditions, ball or swing law are not, those that are usual in its sport count.
    """
    signature = inspect.signature(function)
    kinds = {name: str(one.annotation) for name, one in signature.parameters.items()}
    hitters = [name for name, kind in kinds.items() if kind in HITTERS]
    of_parameters = signature.parameters.values()
    filled = [one.name for one in of_parameters if hitters and kinds[one.name] in FILLED and one.default is one.empty]
    several = next((name for name, kind in kinds.items() if kind == "Sequence[Given]"), None)
    shown = signature.replace(
        parameters=[one.replace(default=USUAL_FOR_IT) if one.name in filled else one for one in of_parameters]
    )

    @wraps(function)
    def door(*args: Any, **kwargs: Any) -> Any:
        if several is not None and several not in kwargs and not (len(args) == 1 and _is_list(args[0])):
            args = (list(args),)
        bound = shown.bind(*args, **kwargs)
        given = bound.arguments
        tool = next((found for name in hitters if (found := _implement(given.get(name))) is not None), None)
        for name in filled:
            if name not in given:
                for hitter in hitters if tool is None else ():
                    _thing(given[hitter], hitter, kinds[hitter], None)  # what is no bat is worse than what is missing
                if tool is None:
                    raise InputError(f"{name} is missing; give {THINGS[kinds[name]][1]}")
                given[name] = _usual(kinds[name], tool, given)
        for name, kind in kinds.items():
            if kind == "Ball" and name in given:
                given[name] = _thing(given[name], name, kind, None)
        ball = next((given[name] for name, kind in kinds.items() if kind == "Ball" and name in given), None)
        for name, value in given.items():
            if kinds[name] in NUMBERS:
                given[name] = _numbers(value, name)
            elif kinds[name] in THINGS or kinds[name] in MANY:
                given[name] = _thing(value, name, kinds[name], ball or _ball_for(tool, given))
        return function(*bound.args, **bound.kwargs)

    door.__module__ = "sweetspot"  # where it can be found again, for pickle and help
    door.__signature__ = shown  # type: ignore[attr-defined]
    return door


def _is_a(value: Any, *names: str) -> bool:
    """Return whether something is of a class of one of these names, whose module need not be loaded to ask."""
    return any(base.__name__ in names for base in type(value).__mro__)


def _is_list(value: Any) -> bool:
    return not (isinstance(value, (str, Path)) or _is_a(value, "Implement", "Park"))


def _numbers(value: Any, name: str, *, callers: int = 3) -> Any:
    """Return the number or numbers of a parameter in SI; each of further keywords by its own name."""
    if isinstance(value, dict):
        found = {}
        for key, one in value.items():
            found[key] = _numbers(one, key, callers=callers + 1)
        return found
    if name not in KIND_OF:
        return value
    numbers = in_si(value, name)
    if KIND_OF[name] == "speed" and name in TABLE and numbers is not None and not insisted():
        _warn_of_unusual(numbers, name, callers=callers)
    return numbers


def _warn_of_unusual(speeds: Any, name: str, *, callers: int) -> None:
    """Warn of speeds that are no game's, which as a rule are miles an hour in place of m/s."""
    import numpy as np

    many = np.ravel(np.asarray(speeds, dtype=float))
    odd = [
        float(speed) for speed in many[np.isfinite(many) & (many != 0)] if bounds(name).verdict(float(speed)) != "fine"
    ]
    if odd:
        usual = bounds(name)
        warnings.warn(
            f"{name} is {odd[0]:.4g} m/s ({usual.in_unit(odd[0]):.4g} {usual.unit}); usual is {usual.low:g} to "
            f"{usual.high:g} {usual.unit}. Plain numbers are m/s; miles an hour are written '{odd[0]:.4g} mph'",
            UnusualWarning,
            stacklevel=callers + 1,
        )


def _implement(value: Any) -> Implement | None:
    """Return the implement that something given is, is called or was made of; None where that cannot be said."""
    if isinstance(value, (str, Path)):
        from sweetspot.catalog import load_implement

        return load_implement(str(value))
    if isinstance(value, (list, tuple)) and value:
        return _implement(value[0])
    found = value.bat if _is_a(value, "Analysis", "ReducedBat", "BeamModel") else value
    return found if _is_a(found, "Implement") else None


def _usual(kind: str, tool: Implement, given: Mapping[str, Any]) -> Any:
    from sweetspot import catalog
    from sweetspot.catalog.standard_hit import standard_conditions

    if kind == "Conditions":
        return standard_conditions(tool)
    return _ball_for(tool, given) if kind == "Ball" else catalog.swing_law(catalog.sport(tool.sport).swing_law)


def _ball_for(tool: Implement | None, given: Mapping[str, Any]) -> Ball | None:
    """Return the ball of the conditions that were given, else the usual one of an implement's sport."""
    conditions = given.get("conditions")
    if _is_a(conditions, "Conditions", "FlightConditions"):
        ball: Ball = conditions.ball  # type: ignore[union-attr]
        return ball
    if tool is None:
        return None
    from sweetspot import catalog

    return catalog.ball(catalog.sport(tool.sport).balls[0])


def _thing(value: Any, name: str, kind: str, ball: Ball | None) -> Any:
    """Return what a function takes, of what was given for it; see `THINGS`."""
    if kind in MANY:
        if _is_list(value) and not value:
            raise InputError(f"{name} is empty; give {THINGS[MANY[kind]][1]}")
        return [_thing(one, name, MANY[kind], ball) for one in (value if _is_list(value) else [value])]
    types, wanted = THINGS[kind]
    if kind in NAMED and isinstance(value, str):
        from sweetspot import catalog

        value = getattr(catalog, NAMED[kind])(value)
    elif kind == "Contact" and isinstance(value, tuple):
        from sweetspot.collision.hit_in_space import Contact

        value = Contact(*map(in_si, value, Contact._fields))
    elif kind == "Swings" and _is_a(value, "Swings"):
        value = value._replace(bat_speed=in_si(value.bat_speed, "bat_speed"), pivot=in_si(value.pivot, "pivot"))
    elif kind in HITTERS and not _is_a(value, *types):
        value = _made_of(value, kind, ball)
    if not _is_a(value, *types) or (kind == "ReducedBat[Bat]" and not _is_a(value.bat, "Bat")):
        raise InputError(f"{name} was given as {_shown(value)}; give {wanted}")
    return value


def _made_of(value: Any, kind: str, ball: Ball | None) -> Any:
    """Return of a bat, or of what was made of one, the part that a function works on; as it is where there is none."""
    tool = _implement(value)
    if tool is None or (kind == "Bat" and not _is_a(tool, "Bat")):
        return value if tool is None else tool
    if THINGS[kind][0] <= {"Implement", "Bat"}:
        return tool
    if kind == "Analysis":
        from sweetspot.analysis.bat_analysis import analyse
        from sweetspot.catalog.standard_hit import standard_conditions

        return analyse(tool, standard_conditions(tool))
    if kind == "Modes" and _is_a(value, "Analysis"):
        return value.modes  # as the hands hold it
    reduced = _reduced_of(value, tool, ball)
    parts = {"BeamModel": "beam", "RigidBody": "body", "Modes": "modes"}
    return getattr(reduced, parts[kind]) if kind in parts else reduced


def _reduced_of(value: Any, tool: Implement, ball: Ball | None) -> ReducedBat[Implement]:
    """Return a bat reduced, from what was made of it already."""
    from sweetspot.dynamics.mode_assembly import all_modes
    from sweetspot.dynamics.reduction import ReducedBat
    from sweetspot.dynamics.rigid import rigid_body

    if isinstance(value, ReducedBat):
        return value
    if _is_a(value, "Analysis"):
        reduced: ReducedBat[Implement] = value.reduced
        return reduced
    ball = ball or _ball_for(tool, {})
    assert ball is not None
    if _is_a(value, "BeamModel"):
        return ReducedBat(tool, value, rigid_body(value), all_modes(value, ball))
    return _reduced(tool, ball)


@lru_cache(maxsize=16)
def _reduced(tool: Implement, ball: Ball) -> ReducedBat[Implement]:
    """Return a bat reduced, kept for the next call: a loop over speeds gives the same bat again and again."""
    from sweetspot.dynamics.reduction import reduced_bat

    return reduced_bat(tool, ball=ball)


def _shown(value: Any) -> str:
    """Return what was given, short."""
    if _is_a(value, "ReducedBat"):
        return _shown(value.bat)
    if _is_a(value, "Implement"):
        return f"the {type(value).__name__} {value.name!r}"
    text = repr(value)
    return text if len(text) <= LONGEST_SHOWN else f"a {type(value).__name__}"

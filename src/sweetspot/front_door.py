"""Conversion of the arguments of public functions: names, files and quantities become objects and SI numbers.

Each public function is wrapped once, when first used; inside the package functions call each other directly. The
annotations decide the conversion, and modules are loaded only when a name has to be resolved.
"""

from __future__ import annotations

import inspect
import re
import warnings
from collections.abc import Callable, Iterable, Mapping
from dataclasses import fields, replace
from functools import lru_cache, wraps
from pathlib import Path
from typing import TYPE_CHECKING, Any, Final

from sweetspot.errors import InputError, UnusualWarning, missing_extras_named
from sweetspot.plausibility import bounds, insisted, insisting
from sweetspot.plausibility.table import TABLE
from sweetspot.units.quantities import KIND_OF, in_si

if TYPE_CHECKING:
    from sweetspot.analysis.certification.shots import Shots
    from sweetspot.dynamics.reduction import ReducedBat
    from sweetspot.equipment.ball import Ball
    from sweetspot.equipment.implement import Implement

NUMBERS = {"float", "float | None", "ArrayLike", "Real", "Mapping[str, ArrayLike]"}
"""Annotations of parameters that are converted by their name."""
WRITTEN = re.compile(r"\b(Written|Exact|Place|ExactPlace)\b|tuple\[float")
"""The same of numbers that may have an error, or be a place from the tip."""
SETUPS = {
    *("HitSetup", "PathSetup", "PitchSetup", "ContactSetup", "Weather", "FieldAir", "LaunchSetup", "FlightChoice"),
    *(
        "BlockSetup",
        "FallSetup",
        "SearchSetup",
        "SentSetup",
        "Choices",
        "SwingerSetup",
        "SheetSetup",
        "HungSetup",
        "RowSetup",
        "GoalSetup",
        "BatterSetup",
        "LimitSetup",
        "FrontSetup",
    ),
}
"""Annotations of parameters whose fields are parameters of the public function."""
BAT = "a bat or another implement, its name in the catalogue (`sweetspot bats` lists them) or its file"
ROUND_BAT = "a round bat, its name in the catalogue (`sweetspot bats` lists them) or its file"
THINGS: Mapping[str, tuple[set[str], str]] = {
    "Loaded": ({"Loaded", "tuple"}, BAT),
    "Loaded | None": ({"Loaded", "NoneType"}, BAT),
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
    "Material | None": ({"Material", "NoneType"}, "what `catalog.material` returns, or its name in the catalogue"),
    "Shots | None": ({"Shots", "NoneType"}, "a CSV file of measured shots, or what `read_shots` returns"),
    "Park": ({"Park"}, "what `catalog.park` returns, or a park's name in the catalogue"),
    "Conditions": ({"Conditions"}, "what `standard_conditions` returns for the bat"),
    "FlightConditions": ({"FlightConditions"}, "what `standard_flight` returns"),
    "BallMotion": ({"BallMotion"}, "what `batted_ball` returns for one ball"),
    "BallMotion | BallMotions": ({"BallMotion", "BallMotions"}, "what `batted_ball` returns"),
    "Impact": ({"Impact"}, "what `hit` of `sweetspot.collision.coupled` returns"),
    "Swing": ({"Swing"}, "a `Swing`, as `standard_conditions(bat).swing`"),
    "Swings": ({"Swings"}, "`Swings`"),
    "SwingPath": ({"SwingPath"}, "a `SwingPath`"),
    "Hands": ({"Hands"}, "`Hands`"),
    "Contact": ({"Contact"}, "a `Contact`"),
}
"""By annotation: names of the types that a function takes, and how to say so."""
MANY = {"Sequence[Given]": "Given", "Iterable[Park]": "Park"}
"""By annotation of several things: that of each."""
NAMED = {"Material | None": "material", "Ball": "ball", "SwingLaw | None": "swing_law", "Park": "park"}
"""By annotation: the catalogue's function that loads the thing by its name."""
HITTERS = {
    *("Loaded", "Loaded | None"),
    *("Given", "Implement", "Implement | str | Path", "Bat", "Sequence[Given]"),
    *("BeamModel", "RigidBody", "Modes", "ReducedBat[Bat]", "Analysis"),
}
"""Annotations of parameters for which a bat may be given; the first says whose sport, ball and swing are usual."""
FILLED = {"Conditions", "Ball", "SwingLaw | None"}
"""Annotations of parameters that follow from the bat where they are left out."""
PARAMETERS = re.compile(r"^Parameters\n-+\n(.*?)(?=\n\n|\Z)", re.DOTALL | re.MULTILINE)
"""That section of a docstring."""
LONGEST_SHOWN = 60
"""Letters of an argument that a message repeats."""


class _Usual:
    """The default of a parameter that follows from the bat: the usual swing, ball or law of its sport."""

    def __repr__(self) -> str:
        return "usual"


USUAL_FOR_IT: Final = _Usual()


def opened(function: Callable[..., Any]) -> Callable[..., Any]:
    """Return a function that also takes names, files, texts with units and `pint` quantities.

    The fields of its setups become its parameters. Conditions, ball and swing law that are not given with a bat are
    the usual ones of its sport.
    """
    inner = inspect.signature(function)
    setups = {name: each.default for name, each in inner.parameters.items() if each.annotation in SETUPS}
    signature = _flat(inner, setups)
    kinds = {name: str(each.annotation) for name, each in signature.parameters.items()}
    hitters = [name for name, kind in kinds.items() if kind in HITTERS]
    filled = [name for name, each in signature.parameters.items() if each.default is USUAL_FOR_IT]
    several = next((name for name, kind in kinds.items() if kind == "Sequence[Given]"), None)

    @wraps(function)
    def door(*args: Any, **kwargs: Any) -> Any:
        if several is not None and several not in kwargs and not (len(args) == 1 and _is_list(args[0])):
            args = (list(args),)
        try:
            given = signature.bind(*args, **kwargs).arguments
        except TypeError as error:
            takes = ", ".join(signature.parameters)
            raise TypeError(f"sweetspot.{function.__name__}() {error}; it takes {takes}") from None
        for name in hitters:
            if kinds[name].startswith("Loaded") and given.get(name) is not None:
                given[name] = _loaded(given[name], name)
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
            kind = kinds[name]
            if kind in NUMBERS:
                given[name] = _numbers(value, name)
            elif WRITTEN.search(kind) and name in KIND_OF:
                given[name] = _written(value, name, kind, tool)
            elif kind == "Shots | None" and isinstance(value, (str, Path)):
                given[name] = _shots(Path(value), tool)
            elif kind in THINGS or kind in MANY:
                given[name] = _thing(value, name, kind, ball or _ball_for(tool, given))
        for name, setup in setups.items():
            names = [field.name for field in fields(setup) if field.name in given]
            given[name] = replace(setup, **{field: given.pop(field) for field in names})
        bound = inspect.BoundArguments(inner, given)
        with missing_extras_named():
            return function(*bound.args, **bound.kwargs)

    door.__doc__ = _documented(inspect.getdoc(function) or "", setups.values())
    door.__module__ = "sweetspot"  # where it can be found again, for pickle and help
    door.__signature__ = signature  # type: ignore[attr-defined]
    return door


def _documented(words: str, setups: Iterable[object]) -> str:
    """Return a docstring that also lists the parameters of setups, after the function's own."""
    sections = [PARAMETERS.search(inspect.getdoc(type(setup)) or "") for setup in setups]
    more = "\n".join(found[1].rstrip() for found in sections if found)
    if not more:
        return words
    section = PARAMETERS.search(words)
    if section is None:
        head, blank, rest = words.partition("\n\n")
        return f"{head}{blank}Parameters\n----------\n{more}\n\n{rest}"
    return f"{words[: section.end(1)].rstrip()}\n{more}\n{words[section.end(1) :]}"


def _flat(signature: inspect.Signature, setups: Mapping[str, Any]) -> inspect.Signature:
    """Return a signature with setups replaced by their fields and with `USUAL_FOR_IT` for what follows from the bat."""
    hitter = any(each.annotation in HITTERS for each in signature.parameters.values())
    parameters = [
        each.replace(default=USUAL_FOR_IT)
        if hitter and each.annotation in FILLED and each.default is each.empty
        else each
        for name, each in signature.parameters.items()
        if name not in setups
    ]
    of_setups = [
        inspect.Parameter(
            field.name, inspect.Parameter.KEYWORD_ONLY, default=getattr(setup, field.name), annotation=field.type
        )
        for setup in setups.values()
        for field in fields(setup)
    ]
    further = [each for each in parameters if each.kind is each.VAR_KEYWORD]
    return signature.replace(parameters=[*(each for each in parameters if each not in further), *of_setups, *further])


def _loaded(value: Any, name: str) -> Any:
    """Return the loaded implement of a name, a file, an implement or a model of one; a tuple for several."""
    from sweetspot.catalog.implements import Loaded, loaded_bat, loaded_implement

    if isinstance(value, (list, tuple)):
        return tuple(each for part in value for each in _as_list(_loaded(part, name)))
    if isinstance(value, Loaded):
        return value
    if isinstance(value, (str, Path)):
        return (loaded_bat if name == "bat" else loaded_implement)(str(value))
    tool = _implement(value)
    if tool is None or (name == "bat" and not _is_a(tool, "Bat")):
        raise InputError(f"{name} was given as {_shown(value)}; give {ROUND_BAT if name == 'bat' else BAT}")
    return Loaded(tool)


def _shots(path: Path, tool: Implement | None) -> Shots:
    from sweetspot.analysis.certification.shots import read_shots

    return read_shots(path, length=0.0 if tool is None else tool.length)


def _as_list(value: Any) -> tuple[Any, ...]:
    return value if isinstance(value, tuple) else (value,)


def _written(value: Any, name: str, kind: str, tool: Implement | None) -> Any:
    """Return the number of a setup's field in SI, with its error if one was given; a tuple for several."""
    from sweetspot.answers.setups import Owner, value_of_text

    if value is None or _is_a(value, "Measured"):
        return value
    if kind.startswith("tuple"):
        return tuple(_written(each, name, "float", tool) for each in _numbers_of(value))
    if isinstance(value, str):
        of = Owner() if tool is None else Owner(tool.length, tool.sport)
        with insisting():  # what is unusual is warned of
            value = value_of_text(value, name, kind, what=name, of=of)
    if _is_a(value, "Measured", "str"):
        return value
    return _numbers(value, name, sport=tool.sport if tool else "", callers=3)


def _numbers_of(value: Any) -> Any:
    return [value] if isinstance(value, (str, float, int)) else value


def _is_a(value: Any, *names: str) -> bool:
    """Return whether a value's class or a base of it has one of these names, without loading their modules."""
    return any(base.__name__ in names for base in type(value).__mro__)


def _is_list(value: Any) -> bool:
    return not (isinstance(value, (str, Path)) or _is_a(value, "Implement", "Park"))


def _numbers(value: Any, name: str, *, sport: str = "", callers: int = 3) -> Any:
    """Return the number or numbers of a parameter in SI; a dictionary is converted key by key."""
    if isinstance(value, dict):
        found = {}
        for key, each in value.items():
            found[key] = _numbers(each, key, sport=sport, callers=callers + 1)
        return found
    if name not in KIND_OF:
        return value
    numbers = in_si(value, name)
    if KIND_OF[name] == "speed" and name in TABLE and numbers is not None and not insisted():
        _warn_of_unusual(numbers, name, sport, callers=callers)
    return numbers


def _warn_of_unusual(speeds: Any, name: str, sport: str, *, callers: int) -> None:
    """Warn of speeds outside those of the game, which usually are miles an hour in place of m/s."""
    import numpy as np

    many = np.ravel(np.asarray(speeds, dtype=float))
    usual = bounds(name, sport)
    odd = [float(speed) for speed in many[np.isfinite(many) & (many != 0)] if usual.verdict(float(speed)) != "fine"]
    if odd:
        warnings.warn(
            f"{name} is {odd[0]:.4g} m/s ({usual.in_unit(odd[0]):.4g} {usual.unit}); usual is {usual.low:g} to "
            f"{usual.high:g} {usual.unit}. Plain numbers are m/s; miles an hour are written '{odd[0]:.4g} mph'",
            UnusualWarning,
            stacklevel=callers + 1,
        )


def _implement(value: Any) -> Implement | None:
    """Return the implement that a value is, names or was computed from; None if there is none."""
    if isinstance(value, (str, Path)):
        from sweetspot.catalog import load_implement

        return load_implement(str(value))
    if isinstance(value, (list, tuple)) and value:
        return _implement(value[0])
    found = value.bat if _is_a(value, "Analysis", "ReducedBat", "BeamModel") else value
    found = value.implement if _is_a(value, "Loaded") else found
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
    """Return an argument converted to the type that the function takes; see `THINGS`."""
    if kind in MANY:
        if _is_list(value) and not value:
            raise InputError(f"{name} is empty; give {THINGS[MANY[kind]][1]}")
        return [_thing(each, name, MANY[kind], ball) for each in (value if _is_list(value) else [value])]
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
    """Return the part of a bat or of a model of one that a function works on; the value itself if there is no bat."""
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
    """Return the reduced bat, reusing models that were computed already."""
    from sweetspot.dynamics.reduction import ReducedBat, all_modes
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
    """Return the reduced bat, cached because a loop over speeds repeats the same bat."""
    from sweetspot.dynamics.reduction import reduced_bat

    return reduced_bat(tool, ball=ball)


def _shown(value: Any) -> str:
    """Return an argument as short text for a message."""
    if _is_a(value, "ReducedBat"):
        return _shown(value.bat)
    if _is_a(value, "Implement"):
        return f"the {type(value).__name__} {value.name!r}"
    text = repr(value)
    return text if len(text) <= LONGEST_SHOWN else f"a {type(value).__name__}"

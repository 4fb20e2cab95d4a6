"""A bat, racket, club or stick from a few answers: what is asked of each sport, and the file that the answers make.

The catalogue's implement of the sport is the pattern; see `catalog.scaled_implements`.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from functools import cache
from typing import Annotated, Any, Literal

import numpy as np
from pydantic import BaseModel, ConfigDict, Field

from sweetspot import catalog
from sweetspot.catalog.files.write import bat_toml, changes_table, legible
from sweetspot.catalog.materials import bounds_of_ra, frequency_of_ra, rubber, rubber_names
from sweetspot.catalog.scaled_implements import Measures, club_weights, scaled_to, with_shaft
from sweetspot.catalog.swing_laws import swing_weight
from sweetspot.dynamics.beam import beam_model
from sweetspot.dynamics.rigid import rigid_body
from sweetspot.equipment.bat import Bat
from sweetspot.equipment.golf_club import GolfClub
from sweetspot.equipment.implement import Implement
from sweetspot.equipment.material import Material
from sweetspot.equipment.racket import Racket
from sweetspot.equipment.table_tennis_racket import TableTennisRacket
from sweetspot.plausibility import bounds as bounds_of
from sweetspot.plausibility.implements import ROUND_BAT, WHOLE, WholeImplement
from sweetspot.reports.page_words import assumed_measures
from sweetspot.reports.quantity_table import words_in_both_systems
from sweetspot.reports.sentences import Sentence
from sweetspot.units import INCH, OUNCE, OUNCE_INCH_SQUARED
from sweetspot.web.errors import FieldError, about
from sweetspot.web.recipes import ENOUGH
from sweetspot.web.schemas import Choice

PATTERNS = {
    "baseball": {
        "r161-ash": "of wood, turned",
        "college-alloy": "hollow, of metal, stamp BBCOR .50",
        "composite": "hollow, composite",
        "single-wall": "hollow, of metal, older or without a stamp",
    },
    "softball": {"fast-pitch": "hollow, composite", "r161-ash": "of wood, turned"},
    "slow-pitch": {"slow-pitch": "hollow, composite", "r161-ash": "of wood, turned"},
    "youth-baseball": {
        "youth-alloy": "hollow, of metal, stamp USA Baseball",
        "youth-30": "of wood, turned",
        "composite": "hollow, composite, stamp USSSA 1.15",
    },
    "cricket": {"cricket-bat": "blade with a spine"},
    "tennis": {"tennis-racket": "carbon-fibre frame"},
    "badminton": {"badminton-racket": "carbon-fibre frame and shaft"},
    "table-tennis": {"table-tennis-racket": "five plies"},
    "golf": {"golf-driver": "driver"},
    "field-hockey": {"hockey-stick": "composite"},
}
"""By sport: the catalogue's names of what an own one may be like, and what people call the kind."""
WOODS = ("white-ash", "sugar-maple", "yellow-birch", "hickory")
SHAFTS = ("carbon-shaft", "steel")
LENGTHS = (0.78, 1.12)
"""Of a pattern's, for children and for the tallest."""
BARRELS = (0.8, 1.2)
"""Of a pattern's width, as far as barrels of one kind differ: 2 1/4 to 2 3/4 in are sold (assumed)."""


class Usual(BaseModel):
    """The usual value of an answer, and its bounds."""

    value: float | str | None = None
    least: float | None = None
    most: float | None = None


class WizardQuestion(Usual):
    """One question.

    ``kind`` says how its number is shown, by the ending of a name; ``system`` that it is shown in one system whatever
    the page has. A number without a value may stay empty. ``follows`` names another question of whose answer ``by``
    has what is usual here, and ``proportion_to`` one in proportion to whose answer that is.
    """

    field: str
    label: dict[Literal["us", "si"], str]
    kind: str
    system: Literal["us", "si"] | None = None
    follows: str = ""
    by: dict[str, Usual] = {}
    proportion_to: str = ""
    options: list[Choice] = []


class Pattern(BaseModel):
    """A pattern for an own implement, and the questions that follow."""

    key: str
    name: str
    questions: list[WizardQuestion]


class Form(BaseModel):
    """The questions of a sport; ``view`` is where its implement is looked at."""

    sport: str
    name: str
    implement: str
    view: Literal["explorer", "sports"]
    patterns: list[Pattern]


@cache
def forms() -> tuple[Form, ...]:
    """Return the questions of every sport."""
    return tuple(_form(sport, patterns) for sport, patterns in PATTERNS.items())


def _form(sport: str, patterns: dict[str, str]) -> Form:
    its = catalog.sport(sport)
    made = [Pattern(key=key, name=name, questions=_questions(key, sport)) for key, name in patterns.items()]
    bats = all(isinstance(catalog.implement(key), Bat) for key in patterns)
    view: Literal["explorer", "sports"] = "explorer" if bats else "sports"
    return Form(sport=sport, name=its.name, implement=its.words.implement, view=view, patterns=made)


def _questions(key: str, sport: str) -> list[WizardQuestion]:
    pattern = catalog.implement(key)
    usual = WHOLE.get(sport, ROUND_BAT)
    low, high = (part * pattern.length for part in LENGTHS)
    balances = usual.balance[0] * low / INCH, usual.balance[1] * high / INCH
    return [
        *_made_of(pattern),
        _number("length_in", "Length", pattern.length / INCH, (low / INCH, high / INCH)),
        *_barrel(pattern),
        *_drop(pattern),
        _weight(pattern, rigid_body(beam_model(pattern)).mass, usual.mass),
        _number("balance_in", f"Balance point from the {catalog.sport(sport).words.butt}, if measured", None, balances),
        *_swing_weight(sport, usual, (low, high)),
        *_stiffness(pattern, usual),
    ]


def _barrel(pattern: Implement) -> list[WizardQuestion]:
    """Ask for the width of a bat's barrel, which stands on most of them."""
    if not isinstance(pattern, Bat) or pattern.profile is None:
        return []
    widest = max(width for _, width in pattern.profile) / INCH
    low, high = (part * widest for part in BARRELS)
    most = min(high, bounds_of("greatest_diameter").high)
    return [_number("barrel_in", "Width of the barrel, if you know it", None, (low, most))]


def _drop(pattern: Implement) -> list[WizardQuestion]:
    """Ask for a hollow bat's drop, which stands on it and gives its weight."""
    if not isinstance(pattern, Bat) or pattern.shell is None:
        return []
    label = _same("Drop, such as -10, if it stands on it: it gives the weight")
    return [WizardQuestion(field="drop", label=label, kind="drop")]


def _weight(pattern: Implement, mass: float, usual: tuple[float, float]) -> WizardQuestion:
    """Ask for the weight: what it may be follows from the wood, or the shaft."""
    question = _number("mass_oz", "Weight", mass / OUNCE, (usual[0] / OUNCE, usual[1] / OUNCE))
    if isinstance(pattern, Racket):
        return question
    if isinstance(pattern, GolfClub):
        return _following(question, {name: _club_weight(pattern, name, usual) for name in SHAFTS})
    question.proportion_to = "length_in"
    if not isinstance(pattern, Bat) or pattern.shell is not None:
        return question
    return _following(question, {name: _wood_weight(pattern, name, mass) for name in WOODS})


def _following(question: WizardQuestion, by: dict[str, Usual]) -> WizardQuestion:
    """Return a question whose usual answer follows the material's; at first it is that of the first one."""
    first = next(iter(by.values()))
    return question.model_copy(update={"follows": "material", "by": by, **first.model_dump()})


def _club_weight(pattern: GolfClub, shaft: str, usual: tuple[float, float]) -> Usual:
    club = with_shaft(pattern, catalog.material(shaft))
    low, high = club_weights(club)
    value = rigid_body(beam_model(club)).mass
    return Usual(value=value / OUNCE, least=max(low, usual[0]) / OUNCE, most=min(high, usual[1]) / OUNCE)


def _wood_weight(pattern: Bat, wood: str, mass: float) -> Usual:
    """Return the range of weights of a turned bat like the pattern, and the usual one: its own, where inside."""
    bat = pattern.with_material(catalog.material(wood))
    drawn, density = rigid_body(beam_model(bat)).mass, bat.density_range
    low, high = (drawn * part / density.usual for part in (density.lightest, density.heaviest))
    value = mass if low < mass < high else drawn
    return Usual(value=value / OUNCE, least=low / OUNCE, most=high / OUNCE)


def _made_of(pattern: Implement) -> list[WizardQuestion]:
    if isinstance(pattern, GolfClub):
        return [_choice("material", "Shaft", SHAFTS)]
    if isinstance(pattern, Bat) and pattern.shell is None:
        return [_choice("material", "Wood", WOODS)]
    if isinstance(pattern, TableTennisRacket):
        names = {name: rubber(name).name for name in rubber_names()}
        options = [Choice(key=name, name=words) for name, words in names.items()]
        return [WizardQuestion(field="front", label=_same("Rubber"), kind="", value=options[0].key, options=options)]
    return []


def _swing_weight(sport: str, usual: WholeImplement, lengths: tuple[float, float]) -> list[WizardQuestion]:
    """Ask for a swing weight in the sport's own way; where it only repeats the balance point, it is not asked."""
    its, words = swing_weight(sport), catalog.sport(sport).words
    if its.order == 1:
        letters = its.zero is not None
        label = _same(f"{its.name.capitalize()}, such as D2, if known; it stands for the balance point")
        return [WizardQuestion(field="swing_points", label=label, kind="")] if letters else []
    system: Literal["si"] | None = None if words.weighed_in == "oz" else "si"  # kg cm^2 the world over
    axis = f"{{{_place(its.axis, words.place_unit)}}}"
    label = words_in_both_systems(f"Swing weight about the axis {axis} from the {words.butt}, if measured")
    if system is not None:
        label = _same(label[system])
    if its.axis == 0:
        label = _same(f"Moment of inertia about the {words.butt}, if measured")
    least, most = (
        mass * ((gyration * length) ** 2 + (balance * length - its.axis) ** 2) / OUNCE_INCH_SQUARED
        for mass, gyration, balance, length in zip(usual.mass, usual.gyration, usual.balance, lengths, strict=True)
    )
    return [
        WizardQuestion(field="swing_weight_oz_in2", label=label, kind="_oz_in2", system=system, least=least, most=most)
    ]


def _stiffness(pattern: Implement, usual: WholeImplement) -> list[WizardQuestion]:
    tone = _number("tone_hz", "First bending tone hung freely, if tapped", None, usual.frequency)
    if not isinstance(pattern, Racket):
        return [] if isinstance(pattern, Bat | TableTennisRacket) else [tone]
    tension = bounds_of("racket strings.tension")
    most = min(tension.high, pattern.greatest_tension or tension.high)
    strings = _number("string_tension_n", "Tension of the strings", pattern.bed.tension, (tension.low, most))
    if pattern.sport != "tennis":
        return [tone, strings]
    return [_number("ra", "Stiffness of the frame (RA), if known", None, bounds_of_ra()), strings]


def _number(field: str, label: str, value: float | None, bounds: tuple[float, float]) -> WizardQuestion:
    return WizardQuestion(field=field, label=_same(label), kind=field, value=value, least=bounds[0], most=bounds[1])


def _choice(field: str, label: str, materials: tuple[str, ...]) -> WizardQuestion:
    options = [Choice(key=name, name=catalog.material(name).name) for name in materials]
    return WizardQuestion(field=field, label=_same(label), kind="", value=materials[0], options=options)


def _same(label: str) -> dict[Literal["us", "si"], str]:
    return {"us": label, "si": label}


def _place(position: float, unit: str) -> str:
    return f"{position / INCH:.4g} in" if unit == "in" else f"{100 * position:.4g} cm"


class Wanted(BaseModel):
    """The answers; what is empty was not measured, and is as the pattern has it."""

    model_config = ConfigDict(frozen=True, extra="forbid", allow_inf_nan=False)

    name: Annotated[str, Field(min_length=1, max_length=60)] = "my bat"
    sport: Annotated[str, Field(max_length=60)] = "baseball"
    pattern: Annotated[str, Field(max_length=60)] = Field("r161-ash", description="name in the catalogue")
    material: Annotated[str, Field(max_length=60)] | None = Field(None, description="of a wooden bat, or of a shaft")
    front: Annotated[str, Field(max_length=60)] | None = Field(None, description="rubber that the ball meets")
    length_in: Annotated[float, Field(ge=5, le=60)] | None = None
    barrel_in: Annotated[float, Field(ge=1, le=4)] | None = Field(None, description="greatest diameter of a bat")
    mass_oz: Annotated[float, Field(ge=1, le=60)] | None = None
    balance_in: Annotated[float, Field(ge=1, le=60)] | None = Field(None, description="balance point from the grip end")
    swing_weight_oz_in2: Annotated[float, Field(ge=50, le=40000)] | None = Field(
        None, description="moment of inertia about the axis that the sport has for it"
    )
    swing_points: Annotated[str, Field(max_length=20)] | None = Field(None, description="of a golf club, such as D2")
    ra: Annotated[float, Field(gt=0, le=200)] | None = Field(None, description="stiffness of a racket as shops tell it")
    tone_hz: Annotated[float, Field(ge=5, le=1000)] | None = Field(None, description="first bending tone, hung freely")
    string_tension_n: Annotated[float, Field(ge=10, le=1000)] | None = None


def described_by(wanted: Wanted) -> tuple[str, str, list[Sentence]]:
    """Return the file of some answers, the change that gave its weight, in words, and what was assumed.

    A `FieldError` names the answer that cannot be.
    """
    with about("pattern"):
        if wanted.pattern not in catalog.implement_names():  # by its name alone: a path must open no file
            raise FieldError("pattern", f"there is no {wanted.pattern!r} in the catalogue")
        pattern = _built(catalog.implement(wanted.pattern), wanted).replaced(name=wanted.name)
    with about("sport"):
        axis = swing_weight(wanted.sport).axis
    tool, note = pattern, ""
    for field, measures in _steps(pattern, wanted, axis):
        with about(field):
            tool, note = scaled_to(pattern, measures)
    tool = tool.replaced(sport=wanted.sport)
    text = _text(tool, wanted)
    return f"# {note}\n{text}" if note else text, note, _assumed(tool, wanted, axis)


def _assumed(tool: Implement, wanted: Wanted, axis: float) -> list[Sentence]:
    """Return the properties that no answer gave, as the implement has them."""
    body = rigid_body(beam_model(tool))
    heavy = wanted.swing_weight_oz_in2 is not None or wanted.swing_points is not None
    return assumed_measures(
        catalog.implement(wanted.pattern).name,
        mass=body.mass if wanted.mass_oz is None else None,
        balance=body.balance_point if wanted.balance_in is None else None,
        moi=None if heavy or axis == 0 else body.moi(axis),
        axis=axis,
        lively=isinstance(tool, Bat) and tool.shell is not None,
        words=catalog.sport(wanted.sport).words,
    )


def _of_material(tool: Implement, material: Material) -> Implement:
    if isinstance(tool, GolfClub):
        return with_shaft(tool, material)
    return tool.with_material(material) if isinstance(tool, Bat) else tool.replaced(material=material)


def _barrelled(tool: Implement, diameter: float) -> Implement:
    """Return a bat whose barrel has another greatest diameter; handle and knob stay."""
    if not isinstance(tool, Bat) or tool.profile is None:
        raise FieldError("barrel_in", f"{tool.name} has no barrel; leave it out")
    place, width = np.array(tool.profile).T
    thin = int(np.argmin(np.where(place < 0.6 * tool.length, width, np.inf)))
    factor = (diameter - width[thin]) / (width.max() - width[thin])
    wide = np.where(place > place[thin], width[thin] + factor * (width - width[thin]), width)
    stations = tuple(zip(place.tolist(), np.minimum(wide, diameter).tolist(), strict=True))
    return tool.reshaped(stations).replaced(name=tool.name, original=None)


def _strung(tool: Implement, tension: float) -> Implement:
    return tool.replaced(strings=tool.bed.replaced(tension=tension)) if isinstance(tool, Racket) else tool


CHANGES: dict[str, Callable[[Implement, Any], Implement]] = {
    "material": lambda tool, name: _of_material(tool, catalog.material(name)),
    "barrel_in": lambda tool, inches: _barrelled(tool, inches * INCH),
    "front": lambda tool, name: tool.replaced(front=rubber(name)),
    "ra": lambda tool, rating: tool.replaced(first_frequency=frequency_of_ra(rating)),
    "tone_hz": lambda tool, hertz: tool.replaced(first_frequency=hertz),
    "string_tension_n": _strung,
}
"""By answer, what it makes of a pattern."""


def _built(tool: Implement, wanted: Wanted) -> Implement:
    """Return a pattern of the material, rubber, stiffness and tension that were asked for."""
    for field, change in CHANGES.items():
        if (given := getattr(wanted, field)) is not None:
            with about(field):
                tool = change(tool, given)
    return tool


def _steps(pattern: Implement, wanted: Wanted, axis: float) -> list[tuple[str, Measures]]:
    """Return the measures, answer by answer, so that an answer that cannot be met is named."""
    measures = Measures(length=None if wanted.length_in is None else wanted.length_in * INCH)
    steps = [("length_in", measures)]
    if wanted.mass_oz is not None:
        steps.append(("mass_oz", measures := replace(measures, mass=wanted.mass_oz * OUNCE)))
    if wanted.balance_in is not None:
        steps.append(("balance_in", measures := replace(measures, balance_point=wanted.balance_in * INCH)))
    if wanted.swing_weight_oz_in2 is not None:
        measures = replace(measures, moi=wanted.swing_weight_oz_in2 * OUNCE_INCH_SQUARED, moi_axis=axis)
        steps.append(("swing_weight_oz_in2", measures))
    if wanted.swing_points is not None:
        with about("swing_points"):
            moment = swing_weight(wanted.sport).moment_of(wanted.swing_points)
        mass = measures.mass or rigid_body(beam_model(scaled_to(pattern, measures)[0])).mass
        steps.append(("swing_points", replace(measures, balance_point=axis + moment / mass)))
    return steps[-1:] if isinstance(pattern, GolfClub) else steps  # a club's weight is met together with its balance


def _text(tool: Implement, wanted: Wanted) -> str:
    import tomli_w

    if isinstance(tool, Bat):
        return legible(bat_toml(tool.replaced(original=None)), digits=ENOUGH)
    table = changes_table(tool, catalog.implement(wanted.pattern), like=wanted.pattern)
    if wanted.ra is not None:
        table = {"ra" if field == "first_frequency" else field: value for field, value in table.items()}
        table["ra"] = wanted.ra
    return legible(tomli_w.dumps(table), digits=ENOUGH)

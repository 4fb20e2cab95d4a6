"""A bat, racket, club or stick from a few answers: what is asked of each sport, and the file that the answers make.

The catalogue's implement of the sport is the pattern; see `catalog.scaled_implements`.
"""

from __future__ import annotations

from dataclasses import replace
from typing import Annotated

from pydantic import BaseModel, ConfigDict, Field

from sweetspot import catalog
from sweetspot.catalog.files.write import bat_toml, legible
from sweetspot.catalog.files.write_changes import changes_table
from sweetspot.catalog.materials import frequency_of_ra, rubber
from sweetspot.catalog.scaled_implements import Measures, scaled_to, with_shaft
from sweetspot.catalog.swing_laws import swing_weight
from sweetspot.dynamics.beam import beam_model
from sweetspot.dynamics.rigid import rigid_body
from sweetspot.equipment.bat import Bat
from sweetspot.equipment.golf_club import GolfClub
from sweetspot.equipment.implement import Implement
from sweetspot.equipment.racket import Racket
from sweetspot.units import INCH, OUNCE, OUNCE_INCH_SQUARED
from sweetspot.web.errors import FieldError, about
from sweetspot.web.recipes import ENOUGH


class Wanted(BaseModel):
    """The answers; what is empty was not measured, and is as the pattern has it."""

    model_config = ConfigDict(frozen=True, extra="forbid", allow_inf_nan=False)

    name: Annotated[str, Field(min_length=1, max_length=60)] = "my bat"
    sport: Annotated[str, Field(max_length=60)] = "baseball"
    pattern: Annotated[str, Field(max_length=60)] = Field("r161-ash", description="name in the catalogue")
    material: Annotated[str, Field(max_length=60)] | None = Field(None, description="of a wooden bat, or of a shaft")
    front: Annotated[str, Field(max_length=60)] | None = Field(None, description="rubber that the ball meets")
    length_in: Annotated[float, Field(ge=5, le=60)] | None = None
    mass_oz: Annotated[float, Field(ge=1, le=60)] | None = None
    balance_in: Annotated[float, Field(ge=1, le=60)] | None = Field(None, description="balance point from the grip end")
    swing_weight_oz_in2: Annotated[float, Field(ge=50, le=40000)] | None = Field(
        None, description="moment of inertia about the axis that the sport has for it"
    )
    swing_points: Annotated[str, Field(max_length=20)] | None = Field(None, description="of a golf club, such as D2")
    ra: Annotated[float, Field(gt=0, le=200)] | None = Field(None, description="stiffness of a racket as shops tell it")
    tone_hz: Annotated[float, Field(ge=5, le=1000)] | None = Field(None, description="first bending tone, hung freely")
    string_tension_n: Annotated[float, Field(ge=10, le=1000)] | None = None


def described_by(wanted: Wanted) -> tuple[str, str]:
    """Return the file of some answers, and how it was made to weigh what it does, in words.

    A `FieldError` names the answer that cannot be.
    """
    with about("pattern"):
        if wanted.pattern not in catalog.implement_names():  # by its name alone: a path must open no file
            raise FieldError("pattern", f"there is no {wanted.pattern!r} in the catalogue")
        pattern = _built(catalog.implement(wanted.pattern), wanted).replaced(name=wanted.name)
    with about("sport"):
        axis = swing_weight(wanted.sport).axis
    tool, told = pattern, ""
    for field, known in _steps(pattern, wanted, axis):
        with about(field):
            tool, told = scaled_to(pattern, known)
    tool = tool.replaced(sport=wanted.sport)
    return f"# {told}\n{_text(tool, wanted)}" if told else _text(tool, wanted), told


def _built(tool: Implement, wanted: Wanted) -> Implement:
    """Return a pattern of the material, rubber, stiffness and tension that were asked for."""
    if wanted.material is not None:
        with about("material"):
            material = catalog.material(wanted.material)
            if isinstance(tool, GolfClub):
                tool = with_shaft(tool, material)
            else:
                tool = tool.with_material(material) if isinstance(tool, Bat) else tool.replaced(material=material)
    if wanted.front is not None:
        with about("front"):
            tool = tool.replaced(front=rubber(wanted.front))
    if wanted.ra is not None:
        with about("ra"):
            tool = tool.replaced(first_frequency=frequency_of_ra(wanted.ra))
    if wanted.tone_hz is not None:
        with about("tone_hz"):
            tool = tool.replaced(first_frequency=wanted.tone_hz)
    if wanted.string_tension_n is not None and isinstance(tool, Racket):
        with about("string_tension_n"):
            tool = tool.replaced(strings=tool.bed.replaced(tension=wanted.string_tension_n))
    return tool


def _steps(pattern: Implement, wanted: Wanted, axis: float) -> list[tuple[str, Measures]]:
    """Return what is known, answer by answer, so that the one that cannot be met is the one that is named."""
    known = Measures(length=None if wanted.length_in is None else wanted.length_in * INCH)
    steps = [("length_in", known)]
    if wanted.mass_oz is not None:
        known = replace(known, mass=wanted.mass_oz * OUNCE)
        steps.append(("mass_oz", known))
    if wanted.balance_in is not None:
        known = replace(known, balance_point=wanted.balance_in * INCH)
        steps.append(("balance_in", known))
    if wanted.swing_weight_oz_in2 is not None:
        known = replace(known, moi=wanted.swing_weight_oz_in2 * OUNCE_INCH_SQUARED, moi_axis=axis)
        steps.append(("swing_weight_oz_in2", known))
    if wanted.swing_points is not None:
        with about("swing_points"):
            moment = swing_weight(wanted.sport).moment_of(wanted.swing_points)
        mass = known.mass or rigid_body(beam_model(scaled_to(pattern, known)[0])).mass
        known = replace(known, balance_point=axis + moment / mass)
        steps.append(("swing_points", known))
    return steps[-1:] if isinstance(pattern, GolfClub) else steps  # a club's weight is met together with its balance


def _text(tool: Implement, wanted: Wanted) -> str:
    import tomli_w

    if isinstance(tool, Bat):
        return legible(bat_toml(tool.replaced(original=None)), digits=ENOUGH)
    table = changes_table(tool, like=wanted.pattern)
    if wanted.ra is not None:
        table = {"ra" if field == "first_frequency" else field: value for field, value in table.items()}
        table["ra"] = wanted.ra
    return legible(tomli_w.dumps(table), digits=ENOUGH)

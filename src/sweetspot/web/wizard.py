"""A bat from a few answers: what it is for, how long and heavy it is, where it balances, and what it is made of."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import BaseModel, ConfigDict, Field

from sweetspot import catalog
from sweetspot.analysis.two_way import varied
from sweetspot.catalog.files.write import bat_toml
from sweetspot.dynamics.beam import beam_model
from sweetspot.equipment.bat import Bat
from sweetspot.numerics.constants import STANDARD_AXIS
from sweetspot.units import INCH, OUNCE, OUNCE_INCH_SQUARED
from sweetspot.web.errors import about

SHAPES = {
    ("baseball", "wood"): "r161-ash", ("baseball", "hollow"): "single-wall", ("softball", "wood"): "r161-ash",
    ("softball", "hollow"): "fast-pitch", ("youth", "wood"): "youth-30", ("youth", "hollow"): "youth-alloy",
}  # fmt: skip
"""The bat of the catalogue whose outline is stretched to the asked length."""
SPORTS = {"baseball": "baseball", "softball": "softball", "youth": "youth-baseball"}


class Wanted(BaseModel):
    """The answers; what is empty was not measured."""

    model_config = ConfigDict(frozen=True, extra="forbid", allow_inf_nan=False)

    name: Annotated[str, Field(min_length=1, max_length=60)] = "my bat"
    used_for: Literal["baseball", "softball", "youth"] = "baseball"
    built: Literal["wood", "hollow"] = "wood"
    material: Annotated[str, Field(max_length=60)] = Field("white-ash", description="of a wooden bat")
    length_in: Annotated[float, Field(ge=24, le=38)] = 33.0
    mass_oz: Annotated[float, Field(ge=14, le=50)] = 31.0
    balance_in: Annotated[float, Field(ge=8, le=30)] | None = Field(None, description="balance point from the knob")
    swing_weight_oz_in2: Annotated[float, Field(ge=1500, le=25000)] | None = Field(
        None, description="moment of inertia about the axis 6 in from the knob"
    )


def described_by(wanted: Wanted) -> str:
    """Return the bat of some answers as the text of a bat file; a `FieldError` names the answer that cannot be."""
    base = catalog.bat(SHAPES[wanted.used_for, wanted.built])
    bat = _stretched(base, wanted.length_in * INCH)
    if wanted.built == "wood":
        with about("material"):
            bat = bat.with_material(catalog.material(wanted.material))
    with about("mass_oz"):
        if wanted.built == "wood":
            bat = bat.replaced(mass=wanted.mass_oz * OUNCE)
        else:
            bat = varied(bat, {"mass": wanted.mass_oz * OUNCE}, fill=bat.material)
        beam_model(bat)
    if wanted.balance_in is not None:
        with about("balance_in"):
            bat = bat.replaced(balance_point=wanted.balance_in * INCH)
            beam_model(bat)
    if wanted.swing_weight_oz_in2 is not None:
        with about("swing_weight_oz_in2"):
            bat = bat.replaced(moi=wanted.swing_weight_oz_in2 * OUNCE_INCH_SQUARED, moi_axis=STANDARD_AXIS)
            beam_model(bat)
    return bat_toml(bat.replaced(name=wanted.name, original=None, sport=SPORTS[wanted.used_for]))


def _stretched(bat: Bat, length: float) -> Bat:
    """Return a bat with its places, not its widths, stretched to another length; nothing of it is measured any more."""
    part = length / bat.length
    assert bat.profile is not None
    changes: dict[str, object] = {
        "length": length,
        "profile": tuple((place * part, width) for place, width in bat.profile),
        "mass": None, "balance_point": None, "moi": None,
        "point_masses": tuple(one.replaced(position=one.position * part) for one in bat.point_masses),
    }  # fmt: skip
    if bat.shell is not None:
        changes["shell"] = bat.shell.replaced(wall=tuple((place * part, wall) for place, wall in bat.shell.wall))
    return bat.replaced(**changes)

"""The bat file: how people write a bat down in TOML, and what becomes of it."""

from __future__ import annotations

import re
import tomllib
from collections.abc import Mapping
from pathlib import Path
from typing import Annotated, Literal

import numpy as np
from pydantic import BeforeValidator, Field

from sweetspot.catalog.files.mended import fault_of
from sweetspot.catalog.files.tables import (
    ANGLE,
    DENSITY,
    LENGTH,
    MASS,
    MOI,
    PRESSURE,
    SIZES,
    CalibrationTable,
    Called,
    FileTable,
    Length,
    Made,
    Mass,
    NameOf,
    Sizes,
    check_sport,
    in_si,
    made,
    values_in_si,
)
from sweetspot.catalog.files.turned import Turned
from sweetspot.catalog.materials import material
from sweetspot.catalog.records import TomlTable, unwrapped, unwrapped_table
from sweetspot.dynamics.weight_match import weight_matched
from sweetspot.equipment.bat import Bat, Bore, Cup, PointMass
from sweetspot.equipment.laminate import Laminate, Ply
from sweetspot.equipment.material import Material
from sweetspot.equipment.shell import InnerWall, Ring, Shell, Stations
from sweetspot.errors import InputError
from sweetspot.numerics.text_files import read_text
from sweetspot.plausibility import check, insisted, insisting
from sweetspot.units import INCH, format_length

MAX_BYTES = 250_000
"""Of a bat's file: ten times what the longest outline takes, and read in a tenth of a second."""
OUTLINES = ("profile", "turned", "linear_density")
"""Ways to give an outline, of which a file has one."""
MEASURED = ("mass", "balance_point", "moi")
"""Values that count as measured where a file has them, unless it says that they were fitted."""
DEEPEST_KEY = 40
DEEP_KEY = re.compile(rf"""(?<![\w"'-])(?:(?:[\w-]++|"[^"\n]*+"|'[^'\n]*+')\s*+\.\s*+){{{DEEPEST_KEY}}}""")
"""A key of many parts joined by dots."""


def _listed(value: object) -> object:
    """Return one table as a list of one: [bore] is as good as [[bore]]."""
    return (value,) if isinstance(value, dict) else value


MaterialName = Annotated[str, NameOf(material)]
OwnMaterial = Annotated[str | None, NameOf(material, of_body=True)]


class BoreTable(FileTable):
    """[[bore]]: a hole drilled from the barrel end."""

    diameter: Length = Field(description="for example '1 in'")
    depth: Length = Field(description="from the tip, for example '10 in'")
    fill: Annotated[str | None, NameOf(material)] = Field(
        None, description="material of the catalogue that fills it; absent: empty"
    )
    plug: Length = Field("0 in", description="length of the mouth closed again with the bat's own material")


class CupTable(FileTable):
    """[cup]: a hollow turned into the end of the barrel."""

    diameter: Length
    depth: Length


class PlyTable(FileTable):
    """One ply of a laminate, [{ material = "carbon ply", angle = "45 deg", thickness = "0.15 mm" }, ...]."""

    material: MaterialName = Field(description="name in the catalogue; its longitudinal axis is that of the fibres")
    angle: Annotated[str, ANGLE] = Field("0 deg", description="from the bat's axis to the fibres, -90 to 90 deg")
    thickness: Length = Field(description="only its share counts: plies are scaled to the wall")


LAMINATE = Made(Ply, PlyTable, whole=lambda plies: Laminate(plies=plies))
Plies = Annotated[tuple[PlyTable, ...], LAMINATE]


class InnerWallTable(FileTable):
    """[shell.inner_wall]: a sleeve inside the barrel."""

    wall: Sizes = Field(description="pairs of position and thickness, from where the sleeve starts to where it stops")
    material: OwnMaterial = Field(None, description="name in the catalogue; absent: the bat's own")
    laminate: Annotated[tuple[PlyTable, ...] | None, LAMINATE] = Field(
        None, description="plies from the inside outwards"
    )
    gap: Length = Field("0 mm", description="between the outer wall and the sleeve")
    bonded: bool = Field(False, description="true: the walls are glued to each other")


class RingTable(FileTable):
    """[[shell.ring]]: a flat ring or disc inside the barrel, fixed to the innermost wall."""

    position: Length = Field(description="of its middle, from the knob end")
    width: Length = Field(description="along the bat")
    depth: Annotated[str | None, LENGTH] = Field(None, description="from the wall inwards; absent: a solid disc")
    material: OwnMaterial = Field(None, description="name in the catalogue; absent: the bat's own")


class ShellTable(FileTable):
    """[shell]: a hollow bat."""

    wall: Annotated[tuple[tuple[str, str], ...] | str, SIZES] = Field(
        description="one thickness, or pairs of position from the knob end and thickness"
    )
    laminate: Annotated[tuple[PlyTable, ...] | None, LAMINATE] = Field(
        None, description="plies from the inside outwards"
    )
    inner_wall: Annotated[InnerWallTable | None, Made(InnerWall, InnerWallTable)] = None
    ring: Annotated[tuple[RingTable, ...], BeforeValidator(_listed), Made(Ring, RingTable), Called("rings")] = Field(
        (), description="rings and discs that keep the barrel round"
    )
    weight_by: Literal["handle", "knob", "end cap", "wall"] | None = Field(
        None, description="what meets a measured mass where density alone cannot; absent: the first of these that can"
    )
    handle_material: Annotated[str | None, NameOf(material)] = Field(
        None, description="of a two-piece bat; name in the catalogue"
    )
    joint: Annotated[str | None, LENGTH] = Field(
        None, description="where the handle of a two-piece bat ends, from the knob end"
    )
    joint_mass: Mass = "0 oz"
    end_cap_mass: Mass = "0 oz"
    knob_mass: Mass = "0 oz"
    end_cap_depth: Annotated[str | None, LENGTH] = Field(
        None, description="of the end cap, from the tip inwards; absent: 10 mm assumed"
    )
    knob_depth: Annotated[str | None, LENGTH] = Field(
        None, description="of the knob's weight, from the knob end inwards; absent: 20 mm assumed"
    )


class PointMassTable(FileTable):
    """[[point_mass]]: a small weight fixed to the bat; a mass in the same file is that of the bat with it."""

    position: Length
    mass: Mass
    on_surface: bool = Field(False, description="true where it sits on the bat, as tape does, and not inside it")


class TurnedTable(FileTable):
    """[turned]: outline of an ordinary turned bat from the sizes that people know."""

    knob: Length = "2 in"
    handle: Length
    barrel: Length
    taper_start: Length = Field(description="where the handle begins to thicken, from the knob end")
    taper_end: Length = Field(description="where the barrel is reached, from the knob end")


class MaterialTable(FileTable):
    """[material]: a material of the catalogue with some values of this bat's own."""

    like: str
    density: Annotated[str | None, DENSITY] = None
    longitudinal_modulus: Annotated[str | None, PRESSURE] = None
    shear_modulus: Annotated[str | None, PRESSURE] = None
    transverse_modulus: Annotated[str | None, PRESSURE] = None
    poisson_ratio: float | None = None
    damping_ratio: float | None = None
    laminated: bool | None = Field(None, description="true where the wood is glued from several pieces")


class BatFile(FileTable):
    """A bat as written in a TOML file; every size, weight and modulus is a text with its unit."""

    kind: Literal["bat"] = "bat"
    name: str
    sport: str = Field("baseball", description="name in the catalogue")
    length: Length = Field(description="for example '33 in'")
    material: str | MaterialTable = Field(description="name in the catalogue, or a [material] table")
    profile: Annotated[tuple[tuple[str, str], ...] | None, SIZES] = Field(
        None, description="pairs of position from the knob end and diameter"
    )
    turned: TurnedTable | None = None
    linear_density: tuple[float, ...] | None = Field(
        None, description="c0, c1, c2, ... of c0 + c1 x + c2 x^2 ... in kg/m with x in m from the knob end"
    )
    density_gradient: float = Field(0.0, description="relative change of density from the middle to the tip")
    mass: Annotated[str | None, MASS] = Field(
        None, description="measured, with all that is on it; density is scaled to it"
    )
    balance_point: Annotated[str | None, LENGTH] = Field(None, description="measured, from the knob end")
    moi: Annotated[str | None, MOI] = Field(None, description="measured moment of inertia about moi_axis")
    moi_axis: Length = Field("6 in", description="axis of moi, from the knob end")
    outline_assumed: bool = Field(
        False, description="whether the outline is not this bat's own but assumed, as that of others of its kind"
    )
    fitted: tuple[str, ...] = Field((), description="which of mass, balance_point and moi were not measured but fitted")
    bore: Annotated[tuple[BoreTable, ...], BeforeValidator(_listed), Made(Bore, BoreTable), Called("bores")] = ()
    cup: Annotated[CupTable | None, Made(Cup, CupTable)] = None
    shell: Annotated[ShellTable | None, Made(Shell, ShellTable)] = None
    point_mass: Annotated[
        tuple[PointMassTable, ...],
        BeforeValidator(_listed),
        Made(PointMass, PointMassTable),
        Called("point_masses"),
    ] = ()
    grain_slope: Annotated[str, ANGLE] = Field(
        "0 deg", description="between the grain of the wood and the axis, at the handle, 0 to 20 deg"
    )
    altered: bool = Field(False, description="true where it was changed after it was made, as no rule allows")
    choke: Length = Field("0 in", description="how far the grip is moved up from the knob")
    original: BatFile | None = Field(
        None, description="the bat as it was measured, when this one is that bat changed; like = ... writes it"
    )
    calibration: CalibrationTable | None = None
    note: str | None = Field(None, description="anything worth knowing about this bat")


def read_toml(path: Path) -> TomlTable:
    """Return a TOML file's content; a missing, huge or malformed file is an `InputError`."""
    text = read_text(path, most=MAX_BYTES, advice="a bat file is TOML text of a few lines")
    return table_of_text(text, str(path))


def table_of_text(text: str, where: str) -> TomlTable:
    """Return the table that a TOML text describes; ``where`` names its origin in messages."""
    if DEEP_KEY.search(text):  # the reader's time grows with the square of their number
        raise InputError(f"{where} holds a key of more than {DEEPEST_KEY} parts; a bat has a few lines")
    try:
        return tomllib.loads(text)
    except ValueError as error:  # wrong TOML, or a number of thousands of digits
        table = "; of a table of diameters `sweetspot outline` makes a bat file" if where.endswith(".csv") else ""
        reason = "" if table else fault_of(text, error)
        if reason:
            raise InputError(f"{where}, {reason}" if reason.startswith("line") else f"{where}: {reason}") from None
        raise InputError(f"{where} is not valid TOML: {error}{table}") from None
    except RecursionError:
        raise InputError(f"{where} holds tables inside tables beyond all need; a bat has a few lines") from None


def bat_of_table(table: TomlTable, where: str) -> Bat:
    """Return the bat that a table describes by itself; ``where`` names the file in messages."""
    if table.get("kind", "bat") != "bat":
        kind = str(table["kind"]).replace("-", " ")
        raise InputError(
            f"{where} is a {kind}, not a baseball or softball bat; `sweetspot report`, `hit` and `compare` take it"
        )
    loose = sorted(set(table) & set(ShellTable.model_fields))
    if loose:
        raise InputError(
            f"{where}: {' and '.join(loose)} stand{'s' if len(loose) == 1 else ''} outside [shell]; only a hollow bat "
            "has a wall, an end cap or a joint: put it into a [shell] table that has a wall"
        )
    try:
        if table.get("sport", "baseball") != "baseball":
            check_sport(str(unwrapped(table["sport"])), kind="bat")
        with insisting(insisted() or "calibration" in table):  # what was fitted to a checked drawing need not be usual
            return checked_drawing(_bat(BatFile(**unwrapped_table(with_fitted(table)))))
    except InputError as error:
        message = re.sub(r"\b\w*table: ", "", str(error).removeprefix("batfile: ").removeprefix("bat: "))
        raise InputError(f"{where}: {message}") from None


OWN_OUTLINE = ("measured", "specified")
"""Kinds of records whose outline is the bat's own."""


def with_fitted(table: TomlTable) -> TomlTable:
    """Return a file's table that says what its records say was fitted or assumed, also of the original bat."""
    original = table.get("original")
    changed = {**table, "original": with_fitted(original)} if isinstance(original, Mapping) else table
    records = {name: record for name in MEASURED if isinstance(record := table.get(name), Mapping)}
    by_record = [name for name, record in records.items() if record.get("kind") == "fitted"]
    outlines = [record for name in OUTLINES if isinstance(record := table.get(name), Mapping)]
    if any(record.get("kind", "measured") not in OWN_OUTLINE for record in outlines):
        changed = {**changed, "outline_assumed": True}
    return {**changed, "fitted": by_record} if by_record else changed


def checked_drawing(bat: Bat) -> Bat:
    """Return a bat whose drawing is drawn as drawings are: from the knob end, in diameters, a wall of millimetres."""
    check(bat.length, "bat length", format_length(bat.length))
    if bat.profile is not None:
        greatest = max(diameter for _, diameter in bat.profile)
        check(greatest, "greatest diameter", format_length(greatest))
        places = np.linspace(0, bat.length, 200)
        smallest = float(np.min(bat.diameter_at(places[10:-10])))  # ends may be round down to the axis
        check(smallest, "smallest diameter", format_length(smallest))
        areas = np.asarray(bat.diameter_at(places)) ** 2
        middle = float(areas @ places / areas.sum()) / bat.length
        check(middle, "middle of the outline", f"{middle:.2f} of the length")
    if bat.shell is not None:
        walls = [thickness for _, thickness in bat.shell.wall]
        walls += [] if bat.shell.inner_wall is None else [thickness for _, thickness in bat.shell.inner_wall.wall]
        for what, wall in (("thinnest wall", min(walls)), ("thickest wall", max(walls))):
            check(wall, what, f"{1e3 * wall:.3g} mm ({wall / INCH:.3g} in)")
        if bat.shell.joint is not None:
            joint = bat.shell.joint / bat.length
            check(joint, "joint", f"{joint:.2f} of the length")
    return bat


def _bat(file: BatFile) -> Bat:
    body = _material(file.material, measured=file.calibration is not None)
    length = in_si(file.length, "length", "length", "bat")
    outlines = [name for name in OUTLINES if getattr(file, name) is not None]
    if len(outlines) != 1:
        among = " and ".join(outlines) or "none of them"
        raise InputError(f"the outline is given as {among}; give exactly one of profile, turned, linear_density")
    original = None if file.original is None else _bat(file.original)
    shell = file.shell
    if shell is not None and isinstance(shell.wall, str):
        shell = shell.model_copy(update={"wall": (("0 in", shell.wall), (file.length, shell.wall))})
        file = file.model_copy(update={"shell": shell})
    turned = {} if file.turned is None else {"profile": _turned(file.turned, length)}
    assumed = file.outline_assumed or file.turned is not None  # a few sizes are no outline
    flags = {"outline_assumed": assumed, "calibrated": file.calibration is not None}
    given = {"material": body, "original": original, **flags, **turned}
    bat = made(Bat, file, implement="bat", body=body, given=given)
    if shell is None or bat.shell is None:
        return bat
    if original is not None and original.shell is not None and original.drawn_shell is not None:
        bat = _made_alike(bat, bat.shell, original.shell, original.drawn_shell).replaced(remark=original.remark)
    if bat.calibrated:
        return bat
    matched = weight_matched(bat, shell.weight_by)
    return matched if matched is bat else matched.replaced(drawn_shell=bat.shell)


def _turned(table: TurnedTable, length: float) -> Stations:
    sizes = made(Turned, table, "turned", implement="bat", given={"length": length})
    end = sizes.taper_end / length
    check(end, "end of the taper", f"{table.taper_end}, {end:.2f} of the length")
    return sizes.profile()


def _made_alike(bat: Bat, shell: Shell, made: Shell, drawn: Shell) -> Bat:
    """Return a bat whose shell is made as that of its original, which is not quite as that one was drawn.

    Parameters
    ----------
    shell : as the bat's own file draws it; where that is as the original was drawn, it is as that one was made.
    """
    same = {name: getattr(made, name) for name in Shell.model_fields if getattr(shell, name) == getattr(drawn, name)}
    return bat.replaced(shell=shell.replaced(**same), drawn_shell=shell)


def _material(given: str | MaterialTable, *, measured: bool) -> Material:
    """Return the material of a file; a measured density may lie outside what its kind usually has."""
    if isinstance(given, str):
        return material(given)
    made_of = material(given.like)
    values = values_in_si(given, "material", implement="bat")
    changes = {name: value for name, value in values.items() if value is not None and name not in ("like", "density")}
    if given.density is not None:
        density = in_si(given.density, "density", "material.density", "bat")
        made_of = made_of.of_density(density) if measured else made_of.replaced(density=density)
    return made_of.replaced(**changes)

"""Files of rackets, clubs and sticks: how people write them down in TOML, and what becomes of them."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from typing import Annotated, Any, Literal, TypeVar

from pydantic import Field

from sweetspot.catalog.files.bat import BatFile, MaterialName, Plies, bat_of_table, with_fitted
from sweetspot.catalog.files.racket_words import in_file_names
from sweetspot.catalog.files.tables import (
    AREAL_DENSITY,
    DENSITY,
    FORCE,
    FREQUENCY,
    LENGTH,
    LINEAR_DENSITY,
    MASS,
    MOI,
    PRESSURE,
    STIFFNESS,
    TIME,
    CalibrationTable,
    Called,
    FileTable,
    Length,
    Made,
    Mass,
    NameOf,
    Parts,
    Sizes,
    check_sport,
    in_si,
    made,
)
from sweetspot.catalog.materials import frequency_of_ra, rubber
from sweetspot.catalog.records import TomlTable, unwrapped, unwrapped_table
from sweetspot.equipment.cricket_bat import CricketBat
from sweetspot.equipment.face import Face, FaceOutline
from sweetspot.equipment.golf_club import ClubHead, GolfClub, stiffness_by_pendulum
from sweetspot.equipment.hockey_stick import HockeyStick
from sweetspot.equipment.implement import AddedMass, Implement
from sweetspot.equipment.paddle import Paddle, SoftSpot
from sweetspot.equipment.racket import Racket, StringBed
from sweetspot.equipment.table_tennis_racket import TableTennisRacket
from sweetspot.errors import InputError, nearest_names
from sweetspot.plausibility import check, insisted, insisting

Tool = TypeVar("Tool", bound=Implement)


class AddedTable(FileTable):
    """[[point_mass]]: a small weight, for example lead tape."""

    position: Length = Field(description="from the butt end")
    mass: Mass
    beside: Annotated[str, LENGTH, Called("lateral")] = Field("0 cm", description="from the middle line, either side")


class CommonTable(FileTable):
    """Fields of every implement's file."""

    kind: str
    name: str
    sport: str = Field(description="catalogue name of the sport")
    length: Length
    mass: Annotated[str | None, MASS] = Field(None, description="measured")
    balance_point: Annotated[str | None, LENGTH] = Field(None, description="measured, from the butt end")
    moi: Annotated[str | None, MOI] = Field(
        None, description="measured moment of inertia about moi_axis (swing weight)"
    )
    moi_axis: Length = Field("0 cm", description="axis of moi, from the butt end")
    fitted: tuple[str, ...] = Field((), description="which of mass, balance_point and moi were not measured but fitted")
    choke: Length = Field("0 cm", description="how far the grip is moved up from the butt end")
    note: str | None = Field(None, description="anything worth knowing about it")
    point_mass: Annotated[tuple[AddedTable, ...], Made(AddedMass, AddedTable), Called("added")] = Field(
        (), description="small weights, lead tape; mass is that before them, but with like = ... with them"
    )
    calibration: CalibrationTable | None = None
    original: Mapping[str, Any] | None = Field(
        None, description="it as it was measured, when this one is that one changed; like = ... writes it"
    )


FirstFrequency = Annotated[
    str | None, FREQUENCY, Field(description="measured, of bending mode 1, hung freely; absent: as the material has it")
]


class HeadTable(FileTable):
    """[head]: the part of a racket that is strung."""

    length: Length = Field(description="of the string bed")
    width: Length = Field(description="of the string bed")
    rim: Length = Field("1 cm", description="width of the frame beyond the strings")


class StringsTable(FileTable):
    """[strings]: of a racket."""

    tension: Annotated[str, FORCE] = Field(description="in each string, for example '230 N', '52 lb' or '24 kg'")
    mains: int
    crosses: int
    pattern: str | None = Field(None, description="in place of mains and crosses: 16x19")
    linear_density: Annotated[str, LINEAR_DENSITY] = Field(description="of one string, for example '1.4 g/m'")
    restitution: float = Field(description="of a hard ball on the bed of a clamped head")
    patch: Length = Field(description="radius of the round patch through which the ball pushes")


class RacketFile(CommonTable):
    """A tennis or badminton racket."""

    kind: Literal["racket"]
    head: HeadTable
    strings: Annotated[StringsTable | None, Made(StringBed, StringsTable)] = None
    first_frequency: Annotated[str | None, FREQUENCY] = Field(None, description="of bending mode 1, hung freely")
    ra: float | None = Field(None, description="stiffness as shops tell it; in place of first_frequency")
    damping: float = Field(0.01, description="fraction of critical damping, hung freely")
    handle_length: Length
    relative_stiffness: Parts = Field(None, description="pairs of position and stiffness; only ratios count")
    twist_moi: Annotated[str | None, MOI] = Field(None, description="measured, about the long axis")
    swing_weight: float | str | None = Field(
        None, description="in place of moi, about the axis of the sport; a number is in kg cm^2"
    )
    twist_weight: float | str | None = Field(None, description="in place of twist_moi; a number is in kg cm^2")
    greatest_tension: Annotated[str | None, FORCE] = Field(None, description="per string that the frame is made for")
    frame: str = "carbon-fibre frame"


class CricketBatFile(CommonTable):
    """A cricket bat."""

    kind: Literal["cricket-bat"]
    material: MaterialName = Field(description="of the blade; name in the catalogue")
    handle_material: MaterialName
    handle: Sizes = Field(description="pairs of position and diameter, from the top to the shoulders")
    width: Sizes = Field(description="pairs of position and width of the blade, from the shoulders to the toe")
    spine: Sizes = Field(description="pairs of position and depth in the middle of the blade")
    edge: Sizes = Field(description="pairs of position and depth at its edges")
    concavity: float = Field(1.5, description="1: a back of two planes; more: scooped out")
    splice: Length = Field(description="how far the handle reaches into the blade")
    grip_mass: Mass = "0 g"
    first_frequency: FirstFrequency = None


class HockeyStickFile(CommonTable):
    """A field-hockey stick."""

    kind: Literal["hockey-stick"]
    material: MaterialName
    width: Sizes = Field(description="pairs of position and width across the ball's path, over the whole length")
    depth: Sizes = Field(description="pairs of position and thickness along the ball's path")
    wall: Sizes = Field(description="pairs of position and wall thickness")
    face_start: Length = Field(description="where the playing face begins")
    grip_mass: Mass = "0 g"
    grip_length: Length = "30 cm"
    hook_mass: Mass = "0 g"
    hook_reach: Length = "0 cm"
    first_frequency: FirstFrequency = None


class ClubHeadTable(FileTable):
    """[head]: of a golf club."""

    mass: Mass
    height: Length = Field(description="of the face, along the shaft")
    face_width: Length
    moi: Annotated[str, MOI] = Field(description="about the axis from heel to toe")
    roll_moi: Annotated[str, MOI] = Field(description="about the shaft's direction")
    depth: Length = Field("0 cm", description="from the face back to the center of gravity")
    bulge: Annotated[str | None, LENGTH] = Field(None, description="radius of the face from heel to toe; absent: flat")
    face_stiffness: Annotated[str | None, STIFFNESS, Called("stiffness")] = Field(
        None, description="of the plate under the ball"
    )
    characteristic_time: Annotated[str | None, TIME] = Field(
        None, description="as a pendulum test read it, for example '245 us'; the stiffness of the face follows from it"
    )
    face_mass: Annotated[str | None, MASS, Called("moving_mass")] = Field(None, description="that moves with the ball")
    face_restitution: Annotated[float, Called("restitution")] = Field(
        1.0, description="of a hard ball on the face held fast"
    )
    tangential_restitution: float | None = Field(None, description="e_x of the ball on the face; 0 is rolling")


class GolfClubFile(CommonTable):
    """A golf club, weighed by its parts."""

    kind: Literal["golf-club"]
    material: MaterialName = Field(description="of the shaft; name in the catalogue")
    diameter: Sizes = Field(description="pairs of position and outer diameter of the shaft")
    wall: Sizes = Field(description="pairs of position and wall thickness of the shaft")
    head: ClubHeadTable
    grip_mass: Mass = "50 g"
    grip_length: Length = "27 cm"
    first_frequency: FirstFrequency = None


RubberName = Annotated[str | None, NameOf(rubber)]


class TableTennisRacketFile(CommonTable):
    """A table-tennis racket."""

    kind: Literal["table-tennis-racket"]
    blade: Plies = Field(description="plies from one side to the other; angle 0 along the handle")
    blade_length: Length
    blade_width: Length
    handle_width: Length
    handle_thickness: Length = Field(description="with the blade between the scales")
    handle_material: MaterialName
    front: RubberName = Field(None, description="rubber of the catalogue that the ball meets")
    back: RubberName = Field(None, description="rubber of the other side")
    damping: float = 0.02


class SoftSpotTable(FileTable):
    """[soft_spot]: where the core of a paddle is crushed."""

    position: Length = Field(description="of its middle, from the butt end")
    radius: Length
    factor: float = Field(description="of its shear stiffness over the sound core's")


class PaddleFile(CommonTable):
    """A paddle: a sandwich plate with a handle."""

    kind: Literal["paddle"]
    handle_length: Length
    handle_width: Length
    throat: Length = Field("4 cm", description="over which the handle widens to the head")
    head_width: Length
    corner_radius: Length = Field("5 cm", description="of the corners at the tip")
    core_thickness: Length
    core_density: Annotated[str, DENSITY]
    core_shear: Annotated[str, PRESSURE] = Field(description="shear modulus of the core, for example '8 MPa'")
    core_modulus: Annotated[str, PRESSURE] = Field("40 MPa", description="of the core through its thickness")
    skin: Plies = Field(description="plies of one skin, outwards; angle 0 along the handle")
    glue: Annotated[str, AREAL_DENSITY] = Field("0 kg/m^2", description="and paint")
    twist_moi: Annotated[str | None, MOI] = Field(None, description="measured, about the long axis")
    rim_at_tip: float = Field(1.0, description="mass per length of the rim round the tip over that along the sides")
    soft_spot: Annotated[SoftSpotTable | None, Made(SoftSpot, SoftSpotTable)] = None
    patch: Length = Field("16 mm", description="radius of the round patch through which the ball pushes")
    damping: float = Field(0.01, description="fraction of critical damping, hung freely")
    friction: float | None = Field(None, description="of the ball on the face")
    tangential_restitution: float | None = Field(None, description="e_x of the ball on the face; 0 is rolling")
    swing_weight: float | str | None = Field(
        None, description="in place of moi, about the axis of the sport; a number is in kg cm^2"
    )
    twist_weight: float | str | None = Field(None, description="in place of twist_moi; a number is in kg cm^2")


def implement_of_table(table: TomlTable, where: str) -> Implement:
    """Return the implement that a table describes by itself, by its ``kind``; ``where`` names the file in messages."""
    kind = table.get("kind", "bat")
    if kind == "bat":
        return bat_of_table(table, where)
    if not isinstance(kind, str) or kind not in KINDS:
        names = nearest_names(str(kind)[:40], sorted((*KINDS, "bat")))
        raise InputError(f"{where}: kind {repr(kind)[:60]} is not known. {names}")
    made_from, make = KINDS[kind]
    try:
        table = in_file_names(table, str(unwrapped(table.get("sport", "")))) if kind in IN_WORDS else table
        check_sport(str(unwrapped(table.get("sport", ""))), kind=kind)
        with insisting(insisted() or "calibration" in table):  # what was fitted to a checked drawing need not be usual
            return make(made_from(**unwrapped_table(with_fitted(table))))
    except InputError as error:
        message = re.sub(PREFIXES, "", str(error))
        if message.count("is missing") >= MANY_MISSING:
            like = EXAMPLES.get(kind, kind)
            message += f'. Or begin with like = "{like}" and write only what is different (sweetspot bats lists names)'
        raise InputError(f"{where}: {message}") from None


def _made(kind: type[Tool], file: CommonTable, **given: object) -> Tool:
    """Return the implement of a file; ``given`` is what the file says in other words."""
    original = None if file.original is None else implement_of_table(file.original, "original")
    calibrated = file.calibration is not None
    return made(kind, file, implement=file.kind, given={"calibrated": calibrated, "original": original, **given})


def _racket(file: RacketFile) -> Racket:
    if (file.ra is None) == (file.first_frequency is None):
        raise InputError("give first_frequency in Hz, or ra, the stiffness as shops tell it, and not both")
    of_ra = {} if file.ra is None else {"first_frequency": frequency_of_ra(file.ra)}
    head = file.head
    length, width, rim = (
        in_si(getattr(head, name), "length", f"head.{name}", file.kind) for name in ("length", "width", "rim")
    )
    end = in_si(file.length, "length", "length", file.kind) - rim
    return _made(Racket, file, head=FaceOutline(start=end - length, end=end, width=width), **of_ra)


def _golf_club(file: GolfClubFile) -> GolfClub:
    given: dict[str, object] = {"edge": "plate"}
    if file.head.characteristic_time is not None:
        read = in_si(file.head.characteristic_time, "time", "head.characteristic_time", file.kind)
        given["stiffness"] = stiffness_by_pendulum(read)
    face = made(Face, file.head, "head", implement=file.kind, given=given)
    return _made(GolfClub, file, head=made(ClubHead, file.head, "head", implement=file.kind, given={"face": face}))


def _table_tennis_racket(file: TableTennisRacketFile) -> TableTennisRacket:
    racket = _made(TableTennisRacket, file)
    thickness = sum(ply.thickness for ply in racket.blade.plies)
    check(thickness, "blade", f"{1e3 * thickness:.3g} mm")
    return racket


KINDS: dict[str, tuple[type[FileTable], Callable[[Any], Implement]]] = {
    "racket": (RacketFile, _racket),
    "cricket-bat": (CricketBatFile, lambda file: _made(CricketBat, file)),
    "hockey-stick": (HockeyStickFile, lambda file: _made(HockeyStick, file)),
    "golf-club": (GolfClubFile, _golf_club),
    "table-tennis-racket": (TableTennisRacketFile, _table_tennis_racket),
    "paddle": (PaddleFile, lambda file: _made(Paddle, file)),
}
"""By a file's ``kind``: the table it is read as, and the constructor of the implement."""
IN_WORDS = ("racket", "paddle")
"""Kinds whose files may give the swing weight as shops tell it."""
MANY_MISSING = 3
EXAMPLES = {"racket": "tennis-racket", "golf-club": "golf-driver", "paddle": "pickleball-paddle"}
"""Entry of the catalogue to begin with, where it has not the name of its kind."""
PREFIXES = (
    r"^(?:\w*file|\w*racket|paddle|softspot|cricketbat|hockeystick|golfclub|\w*table|outline|stringbed|clubhead|face): "
)
FILES: dict[str, type[FileTable]] = {"bat": BatFile, **{kind: made_from for kind, (made_from, _) in KINDS.items()}}
"""The table of every kind, for schemas."""

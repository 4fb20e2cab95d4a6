"""A bat's outline as it was measured, drawn or photographed: how thick it is, and what it would weigh."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated

import numpy as np

from sweetspot.analysis.certification.rules import League, Verdict, check_rules
from sweetspot.answers.answer import Answer
from sweetspot.answers.certify import RuleCheck, rule_check
from sweetspot.answers.records import INTERNAL
from sweetspot.calibration.outline.measured_outline import MeasuredOutline
from sweetspot.calibration.outline.photo.photo_outline import PhotoOutline
from sweetspot.catalog.files.bat import checked_drawing
from sweetspot.designs.constraints import drawn_findings
from sweetspot.dynamics.beam import beam_model
from sweetspot.dynamics.rigid import rigid_body
from sweetspot.equipment.bat import Bat
from sweetspot.equipment.implement import Implement
from sweetspot.equipment.material import Material
from sweetspot.numerics.arrays import Array
from sweetspot.units import INCH
from sweetspot.units.dimensions import LENGTH, MASS

TOLERANCE = 0.01 * INCH
"""m by which a diameter may be off: what a lathe with a copying rest holds (assumed)."""


@dataclass(frozen=True)
class OutlineQuestion:
    """An outline and the bat that has it.

    ``outline``: see `sweetspot.calibration.outline.outline_file.read_outline`. ``bat``: see `bat_of_outline`; or a
    racket, club or stick that is to be drawn. ``league``: whose rules a drawing has to keep; None: no league's.
    """

    outline: MeasuredOutline
    bat: Implement
    league: League | None = None


def outline_to_draw(implement: Implement) -> MeasuredOutline:
    """Return the outline that an implement has already: its width where its description bends."""
    places = np.array(implement.breakpoints())
    if isinstance(implement, Bat) and implement.profile is not None:
        return MeasuredOutline(implement.profile)
    if isinstance(implement, Bat):
        places = np.linspace(0.0, implement.length, 101)
    widths = np.asarray(implement.width_at(places))
    return MeasuredOutline(tuple(zip(places.tolist(), widths.tolist(), strict=True)))


def bat_of_outline(outline: MeasuredOutline, *, material: Material, name: str) -> Bat:
    """Return the solid bat that has an outline.

    Raises
    ------
    InputError
        where no bat can have it.
    """
    return checked_drawing(Bat(name=name, length=outline.profile[-1][0], material=material, profile=outline.profile))


@dataclass(frozen=True)
class OutlineStations:
    """Stations from the knob end to the tip, arrays of shape (stations,)."""

    position: Annotated[Array, LENGTH]
    diameter: Annotated[Array, LENGTH]


@dataclass(frozen=True, kw_only=True)
class OutlineAnswer(Answer):
    """A measured outline.

    Parameters
    ----------
    bat : that has it, or another implement.
    assumed_position : stations at the ends that no one measured.
    mass, balance_point : of the bat; as weighed, or as its material's density makes them.
    tolerance : by which a diameter may be off, usually. mass_by_tolerance : by how much a round bat weighs more if it
        is thicker by that all along; None: it is not turned.
    broken : rules that its drawing breaks.
    notes : what to know of it.
    """

    bat: Annotated[Implement, INTERNAL]
    profile: OutlineStations
    assumed_position: Annotated[tuple[float, ...], LENGTH]
    length: Annotated[float, LENGTH]
    mass: Annotated[float, MASS]
    balance_point: Annotated[float, LENGTH]
    tolerance: Annotated[float, LENGTH]
    mass_by_tolerance: Annotated[float | None, MASS]
    broken: tuple[RuleCheck, ...]
    notes: tuple[str, ...]


@dataclass(frozen=True, kw_only=True)
class PhotoOutlineAnswer(OutlineAnswer):
    """An outline from a photograph, and how sure it is; see `PhotoOutline`.

    Parameters
    ----------
    pixel, edge_scatter, axis_bend : size of a pixel, rms of single edges about smooth ones and of the bat's middle
        about a straight line.
    diameter_error, place_error : one sigma of every diameter and of places along the bat.
    camera_distance : from camera to bat; None: not known.
    tape_hooked_at : by how much a tape hooked over the tip begins farther in than the bat.
    """

    pixel: Annotated[float, LENGTH]
    edge_scatter: Annotated[float, LENGTH]
    axis_bend: Annotated[float, LENGTH]
    diameter_error: Annotated[Array, LENGTH]
    place_error: Annotated[float, LENGTH]
    camera_distance: Annotated[float | None, LENGTH]
    tape_hooked_at: Annotated[float, LENGTH]


def outline_answer(question: OutlineQuestion) -> OutlineAnswer:
    """Return the mass of a bat with a measured outline, and the outline's uncertainty."""
    outline, bat = question.outline, question.bat
    body = rigid_body(beam_model(bat))
    position, diameter = np.array(outline.profile).T
    answer = OutlineAnswer(
        bat=bat,
        profile=OutlineStations(position, diameter),
        assumed_position=outline.assumed,
        length=bat.length,
        mass=body.mass,
        balance_point=body.balance_point,
        tolerance=TOLERANCE,
        mass_by_tolerance=_mass_by(TOLERANCE, bat, body.mass),
        broken=rules_broken(bat, question.league),
        notes=outline.notes,
    )
    if not isinstance(outline, PhotoOutline):
        return answer
    return PhotoOutlineAnswer(
        **vars(answer),
        pixel=outline.pixel,
        edge_scatter=outline.edge_scatter,
        axis_bend=outline.axis_bend,
        diameter_error=np.array(outline.diameter_error),
        place_error=outline.place_error,
        camera_distance=outline.camera_distance,
        tape_hooked_at=outline.hooked,
    )


def _mass_by(tolerance: float, bat: Implement, mass: float) -> float | None:
    """Return by how much a turned bat's mass grows with all its diameters, kg; None for what is not turned."""
    if not isinstance(bat, Bat) or bat.shell is not None or bat.profile is None:
        return None
    thicker = bat.unchecked(profile=tuple((place, size + tolerance) for place, size in bat.profile), mass=None)
    plain = bat.unchecked(mass=None, balance_point=None, moi=None)
    same = thicker.unchecked(balance_point=None, moi=None)
    share = rigid_body(beam_model(same)).mass / rigid_body(beam_model(plain)).mass
    return mass * (share - 1)


def rules_broken(bat: Implement, league: League | None) -> tuple[RuleCheck, ...]:
    """Return the rules of a league that a drawing of an implement breaks."""
    if league is None:
        return ()
    checks = check_rules(league, bat=bat, findings=drawn_findings(bat))
    return tuple(rule_check(league, check) for check in checks if check.verdict is Verdict.FAIL)

"""A bat's outline as it was measured, drawn or photographed: how thick it is, and what it would weigh."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated

import numpy as np

from sweetspot.answers.answer import Answer
from sweetspot.answers.records import INTERNAL
from sweetspot.calibration.outline.measured_outline import MeasuredOutline
from sweetspot.calibration.outline.photo.photo_outline import PhotoOutline
from sweetspot.catalog.files.bat import checked_drawing
from sweetspot.dynamics.beam import beam_model
from sweetspot.dynamics.rigid import rigid_body
from sweetspot.equipment.bat import Bat
from sweetspot.equipment.material import Material
from sweetspot.numerics.arrays import Array
from sweetspot.units.dimensions import LENGTH, MASS


@dataclass(frozen=True)
class OutlineQuestion:
    """An outline and the bat that has it.

    ``outline``: see `sweetspot.calibration.outline.outline_file.read_outline`. ``bat``: see `bat_of_outline`.
    """

    outline: MeasuredOutline
    bat: Bat


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
    bat : that has it.
    assumed_position : stations at the ends that no one measured.
    mass, balance_point : of the bat; as weighed, or as its material's density makes them.
    notes : what to know of it.
    """

    bat: Annotated[Bat, INTERNAL]
    profile: OutlineStations
    assumed_position: Annotated[tuple[float, ...], LENGTH]
    length: Annotated[float, LENGTH]
    mass: Annotated[float, MASS]
    balance_point: Annotated[float, LENGTH]
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

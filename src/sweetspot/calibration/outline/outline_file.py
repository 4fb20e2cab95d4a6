"""The outline in any file that holds one, by the ending of its name."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

from sweetspot.calibration.outline.curves import outline_of_curves
from sweetspot.calibration.outline.drawing_file import dxf_curves, svg_curves
from sweetspot.calibration.outline.lathe_program import program_outline
from sweetspot.calibration.outline.measured_outline import MeasuredOutline, unlike_bats
from sweetspot.calibration.outline.photo.caliper import at_caliper
from sweetspot.calibration.outline.photo.photo_outline import read_photo
from sweetspot.calibration.outline.solid_mesh import mesh_outline
from sweetspot.calibration.outline.station_table import read_stations
from sweetspot.calibration.outline.step_file import step_outline
from sweetspot.errors import InputError
from sweetspot.tables.headings import NOTHING_GIVEN, GivenColumns

TABLES, DRAWINGS = (".csv", ".txt", ".tsv"), (".svg", ".dxf")
PHOTOGRAPHS = (".jpg", ".jpeg", ".png", ".tif", ".tiff", ".webp", ".bmp")
HEIF = (".heic", ".heif")
"""Photographs that are not read; the message says how to save them."""
MESHES, SOLIDS = (".stl", ".obj"), (".step", ".stp")
PROGRAMS = (".nc", ".gcode", ".ngc", ".tap", ".cnc")
"""Of lathes."""
ENDINGS = TABLES + DRAWINGS + MESHES + SOLIDS + PROGRAMS + PHOTOGRAPHS


def read_outline(
    path: Path,
    *,
    length: float | None = None,
    ruler: float | None = None,
    camera_distance: float | None = None,
    barrel: float | None = None,
    given: GivenColumns = NOTHING_GIVEN,
) -> MeasuredOutline:
    """Return the outline that a file holds.

    A table of stations (CSV), a drawing (SVG, DXF), a solid (STEP), a mesh (STL, OBJ), a lathe's program (G-code) or a
    photograph.

    It notes what is unlike bats.

    ``length``: m of the bat; needed where places count from the tip, and where a drawing has no units. ``ruler``,
    ``camera_distance``: m, of photographs only; see `sweetspot.calibration.outline.photo.photo_outline.read_photo`.
    ``barrel``: m, its greatest diameter by caliper, of photographs only.
    """
    ending = path.suffix.lower()
    if ending in PHOTOGRAPHS + HEIF:
        photo = read_photo(path, length=length, ruler=ruler, camera_distance=camera_distance)
        outline: MeasuredOutline = photo if barrel is None else at_caliper(photo, barrel, str(path))
    elif (ruler, camera_distance, barrel) != (None, None, None):
        raise InputError(f"--ruler, --camera-distance and --barrel are for photographs; {path} is none")
    elif ending in TABLES:
        outline = read_stations(path, length=length, given=given)
    elif ending in MESHES:
        outline = mesh_outline(path, length=length)
    elif ending in SOLIDS:
        outline = step_outline(path, length=length)
    elif ending in PROGRAMS:
        outline = program_outline(path, length=length)
    elif ending in DRAWINGS:
        curves, unit = svg_curves(path) if ending == ".svg" else dxf_curves(path)
        outline = outline_of_curves(curves, str(path), unit=unit, length=length, axis=ending == ".dxf")
    else:
        raise InputError(f"{path} has no ending that is understood; allowed are {', '.join(ENDINGS)}")
    return replace(outline, notes=(*outline.notes, *unlike_bats(outline.profile)))

"""An implement's drawing in any of the formats that workshops take, by the ending of the file's name."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from sweetspot.equipment.bat import Bat
from sweetspot.equipment.implement import Implement
from sweetspot.errors import InputError
from sweetspot.reports.drawings.sheet import sheet_of
from sweetspot.reports.quantities import US, Reader

FLAT = (".svg", ".dxf", ".pdf")
"""Drawings to scale, of every implement; PDF: a template to print on several sheets."""
PROGRAM = (".ngc", ".nc", ".gcode")
"""Tool paths."""
SOLID = (".csv", ".stl", ".step", ".stp", *PROGRAM)
"""Stations, solids and tool paths, of round bats alone."""
LATHE_TABLE = ".lathe.csv"
ENDINGS = (*SOLID[:1], LATHE_TABLE, *FLAT, *SOLID[1:])


@dataclass(frozen=True)
class Workshop:
    """Where a drawing goes to.

    Parameters
    ----------
    remarks : what must stand on it, such as a rule that the bat breaks.
    paper : of a template, a name of `template.PAPERS`.
    lathe : a name of `lathes.toml`, or a TOML file.
    """

    remarks: tuple[str, ...] = ()
    paper: str = "a4"
    lathe: str = "linuxcnc"


ANY_WORKSHOP = Workshop()


def drawing_bytes(
    implement: Implement, path: Path, *, reading: Reader = US, workshop: Workshop = ANY_WORKSHOP
) -> bytes:
    """Return the contents of a file with this name: an implement's drawing, table or solid.

    `sweetspot.calibration.outline.outline_file.read_outline` takes those of bats back.

    Parameters
    ----------
    path : a name with one of `ENDINGS`.
    reading : whose units stations and written sizes are in; solids, DXF and the lathe's table are in mm.
    workshop : where the drawing goes to.

    Raises
    ------
    InputError
        for another ending, and for solids of what is not round.
    """
    ending = path.suffix.lower()
    if ending not in (*FLAT, *SOLID):
        raise InputError(f"{path} has no ending of a drawing; write to a name that ends in {', '.join(ENDINGS)}")
    if ending in FLAT:
        sheet = sheet_of(implement).with_remarks(workshop.remarks)
        if ending == ".dxf":
            from sweetspot.reports.drawings.dxf import dxf_bytes

            return dxf_bytes(sheet)
        if ending == ".pdf":
            from sweetspot.reports.drawings.template import template_pdf

            return template_pdf(sheet, reading, paper=workshop.paper)
        from sweetspot.reports.drawings.svg import svg_bytes

        return svg_bytes(sheet, reading)
    if not isinstance(implement, Bat):
        raise InputError(
            f"{implement.name} is not round, and its description holds no solid; write a drawing of it: "
            f"{', '.join(FLAT)}"
        )
    return _solid(implement, path.name.lower(), reading, workshop)


def _solid(bat: Bat, name: str, reading: Reader, workshop: Workshop) -> bytes:
    from sweetspot.reports.drawings.solids import bat_parts

    remark = "; ".join(workshop.remarks)
    if name.endswith(PROGRAM):
        from sweetspot.reports.drawings.lathe import lathe_named, lathe_program

        return lathe_program(bat, lathe_named(workshop.lathe), workshop.remarks)
    if name.endswith(".csv"):
        from sweetspot.reports.drawings.tables import lathe_csv, stations_csv

        return lathe_csv(bat) if name.endswith(LATHE_TABLE) else stations_csv(bat, reading)
    if name.endswith(".stl"):
        from sweetspot.reports.drawings.stl import stl_bytes

        return stl_bytes(bat_parts(bat, joined=True), f"{remark}: {bat.name}" if remark else bat.name)
    from sweetspot.reports.drawings.step import step_bytes

    return step_bytes(bat_parts(bat), bat.name, remark)

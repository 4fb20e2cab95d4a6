"""The command `outline`: a bat file from a table of diameters."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Annotated

from cyclopts import Parameter

from sweetspot.cli.options.output import Format


def outline(
    file: Annotated[Path, Parameter(help="CSV with a column like in_from_tip and one like diameter_mm.")],
    /,
    *,
    length: Annotated[str | None, Parameter(help="Of the bat: 34in; needed where places count from the tip.")] = None,
    material: Annotated[str, Parameter(help="Material of the catalogue.")] = "white-ash",
    name: Annotated[str | None, Parameter(help="What to call the bat; default: the file's name.")] = None,
    out: Annotated[Path | None, Parameter(help="Bat file to write.")] = None,
    format: Annotated[Format, Parameter(name="--format", help="table for people, json or csv for programs.")] = "table",
) -> None:
    """Turn a table of diameters or circumferences, measured from either end in any unit, into a bat file."""
    from sweetspot import catalog
    from sweetspot.calibration.outline import read_outline
    from sweetspot.catalog.files.write import bat_toml
    from sweetspot.cli.output import print_csv, print_json, print_table
    from sweetspot.dynamics.beam import beam_model
    from sweetspot.dynamics.rigid import rigid_body
    from sweetspot.equipment.bat import Bat
    from sweetspot.report.calibration.outline_report import outline_json, outline_words
    from sweetspot.units import parse

    given = None if length is None else parse(length, "length", "--length")
    found = read_outline(file, length=given)
    bat = Bat(
        name=name or file.stem, length=found.profile[-1][0], material=catalog.material(material), profile=found.profile
    )
    body = rigid_body(beam_model(bat))
    answer = outline_json(found, body)
    if format == "json":
        print_json(answer)
    elif format == "csv":
        print_csv({key: answer["profile"][key] for key in ("position_m", "diameter_m")})
    else:
        print_table(str(outline_words(found, bat, body)))
    if out is not None:
        from sweetspot.report.file_set import write_all

        write_all({out: bat_toml(bat).encode()})
        print(f"sweetspot: wrote {out}", file=sys.stderr)

"""The command `outline`: a bat file from a table of diameters or a drawing, and drawings from a bat."""

from __future__ import annotations

import sys
from dataclasses import dataclass, fields
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

from cyclopts import Parameter

from sweetspot.cli.options.output import DEFAULT_ANSWER, AnswerOptions
from sweetspot.cli.options.reading import DEFAULT_COLUMNS, ColumnOptions
from sweetspot.errors import InputError

if TYPE_CHECKING:
    from sweetspot.answers.outline import OutlineQuestion
    from sweetspot.equipment.bat import Bat
    from sweetspot.reports.quantities import Reader

BAT_FILE = ".toml"


@Parameter(name="*")
@dataclass(frozen=True)
class SizeOptions:
    """Sizes that a table, drawing or photograph does not hold itself."""

    length: Annotated[
        str | None,
        Parameter(help="Of the bat: 34in; needed where places count from the tip or nothing else has units."),
    ] = None
    ruler: Annotated[
        str | None, Parameter(help="Whole length of a straight ruler beside the bat in a photograph: 30cm.")
    ] = None
    camera_distance: Annotated[
        str | None, Parameter(help="From camera to bat: 2.5m; default: as the photograph's lens tells.")
    ] = None

    def given(self) -> dict[str, float]:
        """Return the sizes that were given, in m by name."""
        from sweetspot.plausibility import parse

        texts = {field.name: getattr(self, field.name) for field in fields(self)}
        return {
            name: parse(text, "length", f"--{name.replace('_', '-')}")
            for name, text in texts.items()
            if text is not None
        }


DEFAULT_SIZES = SizeOptions()


def outline(
    source: Annotated[
        str,
        Parameter(
            help="What holds the outline: a CSV with columns like in_from_tip and diameter_mm, a drawing (SVG, DXF), "
            "a photograph (JPEG, PNG) of the bat on a plain ground, "
            "or, to draw it, a bat file or a name of the catalogue."
        ),
    ],
    /,
    *,
    sizes: SizeOptions = DEFAULT_SIZES,
    columns: ColumnOptions = DEFAULT_COLUMNS,
    material: Annotated[str, Parameter(help="Material of the catalogue.")] = "white-ash",
    name: Annotated[str | None, Parameter(help="What to call the bat; default: the file's name.")] = None,
    out: Annotated[
        list[Path] | None,
        Parameter(
            help="Bat file (.toml), stations (.csv), drawing 1:1 (.svg, .dxf) or solid (.stl); may be given again."
        ),
    ] = None,
    answer: AnswerOptions = DEFAULT_ANSWER,
) -> int:
    """Turn a table of diameters, a drawing or a photograph into a bat file, and bats into drawings."""
    from sweetspot.answers.outline import outline_answer
    from sweetspot.cli.output import present
    from sweetspot.reports.calibration.outline_report import outline_document

    found = outline_answer(_question(source, sizes, columns, material=material, name=name))
    document = outline_document(found)
    contents = {path: _content(path, found.bat, document.reader_of(answer.units)) for path in out or []}
    if contents:
        from sweetspot.reports.files import write_all

        for folder in dict.fromkeys(path.parent for path in contents):  # those of one folder together
            write_all({path: content for path, content in contents.items() if path.parent == folder})
        print(f"sweetspot: wrote {', '.join(map(str, contents))}", file=sys.stderr)
    return present(document, answer.into(None))


def _question(
    source: str, sizes: SizeOptions, columns: ColumnOptions, *, material: str, name: str | None
) -> OutlineQuestion:
    """Return the outline and its bat: of a table, drawing or photograph, of a bat file, or of the catalogue."""
    from sweetspot import catalog
    from sweetspot.answers.outline import OutlineQuestion, bat_of_outline
    from sweetspot.calibration.outline.measured_outline import MeasuredOutline
    from sweetspot.calibration.outline.outline_file import ENDINGS, read_outline

    ending = Path(source).suffix.lower()
    if ending in ENDINGS or (ending not in ("", BAT_FILE) and Path(source).exists()):
        measured = read_outline(Path(source), **sizes.given(), given=columns.given())
        made_of = catalog.material(material)
        bat = bat_of_outline(measured, material=made_of, name=name or Path(source).stem)
        return OutlineQuestion(measured, bat)
    if sizes.given():
        raise InputError(f"--length or --ruler was given, but {source} is a bat and has its own; leave it out")
    from sweetspot.reports.drawing import outline_stations

    bat = catalog.load_bat(source)
    bat = bat if name is None else bat.replaced(name=name)
    stations = tuple((float(place), float(size)) for place, size in outline_stations(bat))
    return OutlineQuestion(MeasuredOutline(stations), bat)


def _content(path: Path, bat: Bat, reading: Reader) -> bytes:
    """Return the contents of a file with this name."""
    from sweetspot.catalog.files.write import bat_toml, legible
    from sweetspot.reports.drawing import ENDINGS, drawing_bytes

    if path.suffix.lower() == BAT_FILE:
        return legible(bat_toml(bat)).encode()
    if path.suffix.lower() not in ENDINGS:
        raise InputError(f"--out was given as {path}; write to a name that ends in {', '.join((BAT_FILE, *ENDINGS))}")
    return drawing_bytes(bat, path, reading=reading)

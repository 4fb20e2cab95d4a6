"""The command `outline`: a bat file from a table of diameters or a drawing, and drawings from a bat."""

from __future__ import annotations

from dataclasses import dataclass, fields
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Literal

from cyclopts import Parameter

from sweetspot.cli.options.output import DEFAULT_ANSWER, AnswerOptions
from sweetspot.cli.options.reading import DEFAULT_COLUMNS, ColumnOptions
from sweetspot.errors import InputError

if TYPE_CHECKING:
    from sweetspot.analysis.certification.rules import League
    from sweetspot.answers.outline import OutlineAnswer, OutlineQuestion
    from sweetspot.equipment.implement import Implement
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
    barrel: Annotated[
        str | None,
        Parameter(
            help="Its greatest diameter by caliper, which a photograph is checked against and brought to: 64.5mm."
        ),
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


@Parameter(name="*")
@dataclass(frozen=True)
class DrawingOptions:
    """Files to write, and the rules that a drawing has to keep."""

    out: Annotated[
        list[Path] | None,
        Parameter(
            help="Bat file (.toml), stations (.csv), drawing 1:1 (.svg, .dxf), template to print 1:1 (.pdf), solid "
            "(.step, .stl), table for a lathe (.lathe.csv) or its program (.nc, .ngc, .gcode); may be given again."
        ),
    ] = None
    league: Annotated[
        str,
        Parameter(help="Whose rules a drawing has to keep: a league of the catalogue, or none. Default: the sport's."),
    ] = ""
    paper: Annotated[Literal["a4", "letter"], Parameter(help="Of a template.")] = "a4"
    lathe: Annotated[
        str, Parameter(help="Control of a program: linuxcnc, fanuc, grbl, or a TOML file with stock, tool and passes.")
    ] = "linuxcnc"


DEFAULT_DRAWING = DrawingOptions()


def outline(
    source: Annotated[
        str,
        Parameter(
            help="What holds the outline: a CSV with columns like in_from_tip and diameter_mm, a drawing (SVG, DXF), a "
            "solid (STEP), a mesh (STL, OBJ), a lathe program (.nc, .gcode), "
            "a photograph (JPEG, PNG) of the bat on a plain ground, "
            "or, to draw it, a file or a name of the catalogue: a bat, racket, club or stick."
        ),
    ],
    /,
    *,
    sizes: SizeOptions = DEFAULT_SIZES,
    columns: ColumnOptions = DEFAULT_COLUMNS,
    material: Annotated[str, Parameter(help="Material of the catalogue.")] = "white-ash",
    name: Annotated[str | None, Parameter(help="What to call the bat; default: the file's name.")] = None,
    drawn: DrawingOptions = DEFAULT_DRAWING,
    answer: AnswerOptions = DEFAULT_ANSWER,
) -> int:
    """Turn a table of diameters, a drawing or a photograph into a bat file, and bats and others into drawings."""
    from sweetspot.answers.outline import outline_answer
    from sweetspot.cli.output import note, present
    from sweetspot.reports.calibration.outline_report import outline_document

    found = outline_answer(_question(source, sizes, columns, material=material, name=name, league=drawn.league))
    document = outline_document(found)
    contents = {path: _content(path, found, document.reader_of(answer.units), drawn) for path in drawn.out or []}
    if contents:
        from sweetspot.reports.files import write_all

        for folder in dict.fromkeys(path.parent for path in contents):  # those of one folder together
            write_all({path: content for path, content in contents.items() if path.parent == folder})
        note(f"wrote {', '.join(map(str, contents))}")
    return present(document, answer.into(None))


def _question(
    source: str, sizes: SizeOptions, columns: ColumnOptions, *, material: str, name: str | None, league: str
) -> OutlineQuestion:
    """Return the outline and its bat: of a table, drawing or photograph, of a bat file, or of the catalogue."""
    from sweetspot import catalog
    from sweetspot.answers.outline import OutlineQuestion, bat_of_outline, outline_to_draw
    from sweetspot.calibration.outline.outline_file import ENDINGS, read_outline

    ending = Path(source).suffix.lower()
    if ending in ENDINGS or (ending not in ("", BAT_FILE) and Path(source).exists()):
        measured = read_outline(Path(source), **sizes.given(), given=columns.given())
        made_of = catalog.material(material)
        bat = bat_of_outline(measured, material=made_of, name=name or Path(source).stem)
        return OutlineQuestion(measured, bat, _league(bat, league))
    if sizes.given():
        raise InputError(f"--length or --ruler was given, but {source} is a bat and has its own; leave it out")
    implement = catalog.load_implement(source)
    implement = implement if name is None else implement.replaced(name=name)
    return OutlineQuestion(outline_to_draw(implement), implement, _league(implement, league))


def _league(bat: Implement, name: str) -> League | None:
    """Return the league of a name; none named: the sport's."""
    from sweetspot.catalog.rules import league, usual_league

    chosen = None if name == "none" else name or usual_league(bat)
    return None if chosen is None else league(chosen)


def _content(path: Path, found: OutlineAnswer, reading: Reader, options: DrawingOptions) -> bytes:
    """Return the contents of a file with this name."""
    from sweetspot.catalog.files.write import implement_toml, legible
    from sweetspot.reports.calibration.outline_report import drawing_remarks
    from sweetspot.reports.drawings.drawing_file import ENDINGS, Workshop, drawing_bytes

    if path.suffix.lower() == BAT_FILE:
        return legible(implement_toml(found.bat)).encode()
    if not path.name.lower().endswith(ENDINGS):
        raise InputError(f"--out was given as {path}; write to a name that ends in {', '.join((BAT_FILE, *ENDINGS))}")
    workshop = Workshop(tuple(drawing_remarks(found.broken, reading)), options.paper, options.lathe)
    return drawing_bytes(found.bat, path, reading=reading, workshop=workshop)

"""A measuring day as a document: the order of work, with the sheet to print or fill in and the table behind it."""

from __future__ import annotations

import csv
import io
from collections.abc import Mapping, Sequence

from sweetspot.answers.kit import KitAnswer, SheetField
from sweetspot.reports.document import Bullets, Cell, Column, Document, Paragraph, Section, Table, as_columns
from sweetspot.reports.quantities import Reader
from sweetspot.reports.sentences import Sentence, Slot
from sweetspot.reports.sport_words import in_words, reader_of, words_of
from sweetspot.units import INCH

SHEET, TABLE = "sheet.html", "measured.csv"
SCALES: Mapping[str, tuple[str, int | None]] = {
    "mass": ("mass", None),
    "balance_point": ("length", 1),
    "twenty_swings": ("time", 1),
    "moisture": ("share", 0),
}
"""Scale and digits of what is asked; all others are frequencies."""
NAMES = {
    "mass": "weight",
    "balance_point": "balance point",
    "twenty_swings": "twenty swings",
    "bending_1": "first tone",
    "bending_2": "second tone",
    "hoop": "barrel's tone",
    "moisture": "moisture",
}
HOW = {
    "mass": "Put it on a kitchen scale. Write down every digit it shows.",
    "balance_point": "Balance it across the edge of a ruler. Measure from the {butt} end to the edge.",
    "twenty_swings": "Hang it from a bolt or two pins {axis:place} from the {butt} end. Let it swing a hand's "
    "width and time twenty full swings, there and back.",
    "from_the_end": "Hang it by its very {butt} end. Let it swing a hand's width and time twenty full swings, there "
    "and back.",
    "bending_1": "Hang it from two rubber bands and tap it {tap} from the {tip} with a marble or a spoon, five "
    "times. Record the taps on a phone; `sweetspot tap` names the tones.",
    "bending_2": "The second bending tone of the same recording.",
    "hoop": "The barrel's own tone of the same recording.",
    "moisture": "Press a moisture meter's pins into the wood. Leave it blank if you have none.",
}
FILL_IN = (
    "Leave blank what you did not measure. A number counts as sure to its last digit; write 31.2±0.1 where you know "
    "better."
)


def kit_document(answer: KitAnswer) -> Document:
    """Return a measuring day as a document, with its sheet, its table and the model's file to go along."""
    model = answer.question.model
    words = words_of(model.sport)
    file = model_file(answer)
    columns = [Column("what"), Column("how"), Column("should read near", right=True), Column("sure to", right=True)]
    rows: list[list[Cell]] = [
        [
            NAMES[field.quantity],
            in_words(HOW[_step(field, answer)], words, axis=answer.axis, tap=Slot(INCH, "place", round=True)),
            Slot(field.expected, *_scale(field)),
            Slot(field.instrument, *_finer(field)),
        ]
        for field in answer.fields
    ]
    lead = in_words(
        "{count} {implement}{plural} like {name}, {readings} readings each. Write a name on tape on every {implement} "
        "first.",
        words,
        count=str(len(answer.pieces)),
        plural="s" if len(answer.pieces) > 1 else "",
        name=model.name,
        readings=str(len(answer.fields)),
    )
    data = answer.to_dict()
    return Document(
        name="kit",
        kind="Measuring day",
        title=model.name,
        blocks=[
            Paragraph(lead),
            Section("order", "The order of work", [Table("", columns, rows), Paragraph(FILL_IN, "note")]),
            Section("desk", "Back at the desk", [Bullets(_at_the_desk(answer, file))]),
        ],
        data=data,
        rows=as_columns(data["fields"]),
        reader=reader_of(model.sport),
        attachments={
            SHEET: lambda reader: sheet_html(answer, reader).encode(),
            TABLE: lambda reader: sheet_csv(answer, reader).encode(),
            file: lambda _: answer.to_toml().encode(),
        },
    )


def _at_the_desk(answer: KitAnswer, file: str) -> Sequence[Sentence]:
    words = words_of(answer.question.model.sport)
    first = answer.pieces[0]
    lines = (
        "Open `{sheet}` on a phone or computer, type the sheet in and press Save: that writes `{table}`. A spreadsheet "
        "does too.",
        "`sweetspot tap no-1.wav --bat {file} --at 1in-from-tip` names the tones of a recording.",
        "`sweetspot rank {table} --like {file}` puts the {implement}s in order.",
        '`sweetspot calibrate {file} --measured {table} --row "{first}" --out no-1.toml` makes a file of one, every '
        "number with its interval.",
        "`sweetspot report no-1.toml` tells where it hits best and how fast, with `--pitch-speed` and `--bat-speed` in "
        "your own cage.",
    )
    return [in_words(line, words, sheet=SHEET, table=TABLE, file=file, first=first) for line in lines]


def model_file(answer: KitAnswer) -> str:
    """Return the name of the file that describes the model."""
    return f"{words_of(answer.question.model.sport).implement.replace(' ', '-')}.toml"


def _step(field: SheetField, answer: KitAnswer) -> str:
    """Return which words tell how it is measured: a club swings about its very end."""
    return "from_the_end" if field.quantity == "twenty_swings" and not answer.axis else field.quantity


def _scale(field: SheetField) -> tuple[str, int | None]:
    return SCALES.get(field.quantity, ("frequency", None))


def _finer(field: SheetField) -> tuple[str, int]:
    """Return the scale of an error, which is shown with more digits than its value."""
    scale, digits = _scale(field)
    return scale, {"mass": 2, "length": 2, "time": 2, "frequency": 1}.get(scale, digits or 0)


def _heading(field: SheetField, reader: Reader) -> str:
    """Return a column's heading with its unit, as `sweetspot.tables` reads it."""
    unit = "percent" if field.quantity == "moisture" else reader.unit(_scale(field)[0]).lower()
    return f"{field.quantity}_{unit}"


def sheet_csv(answer: KitAnswer, reader: Reader) -> str:
    """Return the empty table: its headings, and the names of the pieces."""
    written = io.StringIO()
    writer = csv.writer(written, lineterminator="\n")
    writer.writerow(["name", *(_heading(field, reader) for field in answer.fields)])
    writer.writerows([name, *("" for _ in answer.fields)] for name in answer.pieces)
    return written.getvalue()


def sheet_html(answer: KitAnswer, reader: Reader) -> str:
    """Return the sheet as a page that needs nothing else: to print, or to fill in and save as the table."""
    import segno
    from markupsafe import Markup

    from sweetspot.reports.html import page_of

    empty = sheet_csv(answer, reader)
    code = segno.make("\n".join(line.rstrip(",") for line in empty.splitlines()), error="m", micro=False)
    columns = [
        {
            "heading": _heading(field, reader),
            "name": NAMES[field.quantity],
            "unit": reader.unit(scale),
            "near": reader.number(field.expected, scale, digits=digits),
            "low": f"{field.low / reader.units[scale].size:.6g}",
            "high": f"{field.high / reader.units[scale].size:.6g}",
        }
        for field in answer.fields
        for scale, digits in [_scale(field)]
    ]
    return page_of(
        "sheet.html.j2",
        title=answer.question.model.name,
        words=words_of(answer.question.model.sport),
        columns=columns,
        pieces=answer.pieces,
        table=TABLE,
        advice=FILL_IN,
        code=Markup(code.svg_inline(omitsize=True, border=4, svgclass="code")),
    )

"""Materials as documents: every one in a line, or one as a card."""

from __future__ import annotations

import math

from sweetspot.answers.materials import MaterialAnswer, MaterialFacts, MaterialsAnswer, MaterialValue
from sweetspot.numerics.interval import interval_of
from sweetspot.reports.document import Block, Cell, Column, Document, Paragraph, Table, as_columns, table_head
from sweetspot.reports.sentences import PLUS_MINUS, Doubtful, Sentence, Slot

SHOWN = {
    "density": ("density at 12 % moisture", "density"),
    "longitudinal_modulus": ("modulus E along the grain", "modulus"),
    "transverse_modulus": ("modulus across the grain", "modulus"),
    "shear_modulus": ("shear modulus G", "modulus"),
    "strength": ("strength in bending", "modulus"),
    "poisson_ratio": ("Poisson's ratio", "ratio"),
    "damping_ratio": ("damping of a bat's tones", "share"),
}
"""What each value is called on a card of wood, and how it is shown."""
NOT_OF_WOOD = {" along the grain": "", " across the grain": " across", " at 12 % moisture": ""}
UNKNOWN = "-"


def materials_document(answer: MaterialsAnswer) -> Document:
    """Return every material in a line as a document."""
    columns = table_head("name | kind | density: density | E: modulus, 1 | G: modulus, 2")
    columns += [Column("strength MPa", right=True), Column("E/density km²/s²", right=True)]
    data = answer.to_dict()
    return Document(
        name="materials",
        title="",
        kind="Materials",
        blocks=[Table("Materials of the catalogue", columns, [_row(each) for each in answer.materials], "materials")],
        data=data,
        rows=as_columns(data["materials"]),
    )


def _row(facts: MaterialFacts) -> list[Cell]:
    strong = UNKNOWN if math.isnan(facts.strength) else f"{facts.strength / 1e6:.0f}"
    return [
        facts.key,
        facts.family,
        Slot(facts.density, "density", unit=False),
        Slot(facts.longitudinal_modulus, "modulus", 3 if facts.longitudinal_modulus < 1e8 else 1, unit=False),
        Slot(facts.shear_modulus, "modulus", 3 if facts.longitudinal_modulus < 1e8 else 2, unit=False),
        strong,
        f"{facts.stiffness_for_weight / 1e6:.1f}",
    ]


def material_document(answer: MaterialAnswer) -> Document:
    """Return one material as a card."""
    data = answer.to_dict()
    columns = [Column(""), Column("value", right=True), Column("rests on"), Column("source")]
    rows: list[list[Cell]] = [
        [_called(answer, value), _value(value), value.kind, value.source] for value in answer.values
    ]
    return Document(
        name="material",
        title=answer.name,
        kind="Material",
        blocks=[
            Paragraph(f"{PLUS_MINUS} Of a piece such as bats are made of."),
            Table("The material", columns, rows, "values"),
            *_grain(answer),
            *(Paragraph(f"{_called(answer, value)}: {value.where}.", "note") for value in answer.values),
        ],
        data=data,
        rows=as_columns(data["values"]),
    )


def _called(answer: MaterialAnswer, value: MaterialValue) -> str:
    name = SHOWN[value.quantity][0]
    if answer.family == "wood":
        return name
    for words, others in NOT_OF_WOOD.items():
        name = name.replace(words, others)
    return name


def _value(value: MaterialValue) -> Sentence | str:
    number, scale = interval_of(value.value), SHOWN[value.quantity][1]
    half = number.high - number.value
    if value.quantity == "strength":
        return f"{number.value / 1e6:.0f} ± {half / 1e6:.0f} MPa"
    return Sentence((Doubtful(number.value, half, scale, False) if half > 0 else Slot(number.value, scale, 2),))


def _grain(answer: MaterialAnswer) -> list[Block]:
    if not answer.grain:
        return []
    rows: list[list[Cell]] = [
        [Slot(each.slope, "angle", 0), f"1 in {1 / math.tan(each.slope):.0f}", Slot(each.strength_left, "share")]
        for each in answer.grain
    ]
    columns = [Column(name, right=True) for name in ("grain slopes by", "", "strength that is left")]
    return [Table("Slope of grain", columns, rows, "grain")]

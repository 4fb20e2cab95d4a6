"""Sports as documents: what is known of each, how sure, and the paper's formulas with its numbers."""

from __future__ import annotations

from collections.abc import Sequence

from sweetspot.answers.catalogued import SportAnswer, SportsAnswer, SportSummary
from sweetspot.answers.records import to_dict
from sweetspot.equipment.sport import CERTAINTIES, Fact, RuleLimit, Sport
from sweetspot.reports.bench import paper_table
from sweetspot.reports.document import (
    Block,
    Bullets,
    Cell,
    Column,
    Document,
    Paragraph,
    Section,
    Table,
    as_columns,
    table_head,
)
from sweetspot.reports.paper.statements import stated
from sweetspot.reports.quantities import SI, reader
from sweetspot.reports.sentences import Sentence, say


def sports_document(answer: SportsAnswer) -> Document:
    """Return all sports in short; a mark stands behind a speed that no source was read for."""
    columns = table_head("sport | ball")
    columns += [Column(name, right=True) for name in ("tools", "swing", "comes at", *CERTAINTIES)]
    data = answer.to_dict()
    flat = [{**row, **{key: " ".join(row[key]) for key in ("balls", "implements")}} for row in data["sports"]]
    note = "* assumed: recalled, no source was read. `sweetspot sports NAME` shows every number."
    return Document(
        name="sports",
        title="Sports, and how many of their numbers rest on what",
        kind="Catalogue",
        blocks=[Table("", columns, [_row(summary) for summary in answer.sports]), Paragraph(note, "note")],
        data=data,
        rows=as_columns(flat),
        reader=SI,
    )


def _row(summary: SportSummary) -> list[Cell]:
    return [
        summary.key,
        summary.balls[0],
        str(len(summary.implements)),
        _speed(float(summary.swing_speed), summary.swing_speed_kind),
        _speed(float(summary.ball_speed), summary.ball_speed_kind),
        *(str(getattr(summary, kind)) for kind in CERTAINTIES),
    ]


def sport_document(answer: SportAnswer) -> Document:
    """Return everything about one sport; its numbers are shown as their sources write them."""
    described = answer.sport
    counts = {kind: getattr(answer, kind) for kind in CERTAINTIES}
    sure = ", ".join(f"{number} {kind}" for kind, number in counts.items() if number)
    blocks: list[Block] = [
        Paragraph(f"How sure: of its numbers, balls and implements included, {sure}.", "note"),
        _stroke(described),
    ]
    lists = (("Speeds", described.speeds), ("Rules", described.limits), ("Published numbers", described.facts))
    blocks += [_facts_table(facts, title) for title, facts in lists if facts]
    if described.marks:
        blocks.append(_marks(described))
    if answer.formulas:
        blocks.append(paper_table(answer.formulas, "The paper's formulas with this sport's numbers", SI))
    if described.terms:
        blocks.append(Table("Words", table_head("word | what it is here"), described.terms))
    missing = Bullets(described.not_covered)
    data = answer.to_dict() | {"formulas": [to_dict(stated(row, SI)) for row in answer.formulas]}
    return Document(
        name="sports",
        title=described.name,
        kind="Sport",
        blocks=[*blocks, Section("not-covered", "What the model does not cover", [missing])],
        data=data,
        rows=as_columns(data["numbers"]),
        reader=reader(None, described.words),
    )


def _stroke(described: Sport) -> Table:
    stroke, words = described.stroke, described.words
    place: str | Sentence = f"at the {words.tip}"
    if stroke.from_tip:
        place = say("{distance:place} from the {tip}", distance=stroke.from_tip, tip=words.tip)
    swing = say("{name}, {place}", name=stroke.swing_speed.name, place=place)
    rows: list[list[Cell]] = [
        [swing, *_cells(stroke.swing_speed)], [stroke.ball_speed.name, *_cells(stroke.ball_speed)]
    ]  # fmt: skip
    return Table("Usual stroke", [Column(name) for name in ("what", "speed", "kind", "source")], rows)


def _facts_table(facts: Sequence[Fact], title: str) -> Table:
    rows: list[list[Cell]] = []
    for each in facts:
        value, *others = _cells(each)
        rows.append([each.name, f"at {each.side} {value}" if isinstance(each, RuleLimit) else value, *others])
    return Table(title, [Column(name) for name in ("what", "value", "kind", "source")], rows)


def _marks(described: Sport) -> Table:
    rows: list[list[Cell]] = []
    for mark in described.marks:
        good = "passes it in the air" if mark.side == "beyond" else "lands before it"
        height = mark.height.marked if mark.height else None
        rows.append([mark.name, mark.distance.marked, height, good, mark.distance.source])
    columns = [Column(name) for name in ("mark", "distance", "height", "a good flight", "source")]
    return Table("Court or field, from where the ball is usually hit", columns, rows)


def _cells(fact: Fact) -> tuple[str, str, str]:
    return fact.marked, fact.kind, fact.source


def _speed(speed: float, kind: str) -> Sentence:
    return say("{speed:speed}{mark}", speed=speed, mark="*" if kind == "assumed" else "")

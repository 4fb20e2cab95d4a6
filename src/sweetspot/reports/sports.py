"""Sports as documents: what is known of each, how sure, and the paper's formulas with its numbers."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from sweetspot.answers.records import to_dict
from sweetspot.catalog.sports import certainty, sport, sport_implements, sport_names
from sweetspot.equipment.sport import CERTAINTIES, Fact, RuleLimit, Sport
from sweetspot.papers.formulas import PaperRow
from sweetspot.reports.bench import paper_table
from sweetspot.reports.document import Block, Bullets, Cell, Column, Document, Paragraph, Section, Table
from sweetspot.reports.json_shapes import as_columns
from sweetspot.reports.quantities import SI, reader
from sweetspot.reports.sentences import Sentence, Slot, say


def sports_document() -> Document:
    """Return all sports in short; a mark stands behind a speed that no source was read for."""
    rows = [_summary(sport(name)) for name in sport_names()]
    columns = [Column("sport"), Column("ball"), Column("tools", right=True), Column("swing", right=True),
               Column("comes at", right=True), *(Column(kind, right=True) for kind in CERTAINTIES)]  # fmt: skip
    cells: list[list[Cell]] = [
        [row["key"], row["balls"][0], str(len(row["implements"])),
         *(_speed(row[f"{what}_speed_m_s"], row[f"{what}_speed_kind"]) for what in ("swing", "ball")),
         *(str(row[kind]) for kind in CERTAINTIES)]
        for row in rows
    ]  # fmt: skip
    flat = [{**row, **{key: " ".join(row[key]) for key in ("balls", "implements")}} for row in rows]
    note = "* assumed: recalled, no source was read. `sweetspot sports NAME` shows every number."
    return Document(
        name="sports", title="Sports, and how many of their numbers rest on what", kind="Catalogue",
        blocks=[Table("", columns, cells), Paragraph(note, "note")], data={"sports": rows},
        rows=as_columns(flat), reader=SI,
    )  # fmt: skip


def sport_document(described: Sport, rows: Sequence[PaperRow]) -> Document:
    """Return everything about one sport; its numbers are shown as their sources write them.

    Parameters
    ----------
    rows : the paper's formulas with its numbers.
    """
    counts = certainty(described.key)
    sure = ", ".join(f"{number} {kind}" for kind, number in counts.items() if number)
    blocks: list[Block] = [
        Paragraph(f"How sure: of its numbers, balls and implements included, {sure}.", "note"),
        _stroke(described),
    ]
    lists = (("Speeds", described.speeds), ("Rules", described.limits), ("Published numbers", described.facts))
    blocks += [_facts_table(facts, title) for title, facts in lists if facts]
    if described.marks:
        blocks.append(_marks(described))
    if rows:
        blocks.append(paper_table(rows, title="The paper's formulas with this sport's numbers"))
    if described.terms:
        blocks.append(Table("Words", [Column("word"), Column("what it is here")], described.terms))
    missing = Bullets(described.not_covered)
    records = [_record(each) for each in described.numbers()]
    data = _summary(described) | {
        "words": described.words.model_dump(), "numbers": records, "formulas": [to_dict(row) for row in rows],
        "terms": dict(described.terms), "not_covered": list(described.not_covered),
    }  # fmt: skip
    return Document(
        name="sports", title=described.name, kind="Sport",
        blocks=[*blocks, Section("not-covered", "What the model does not cover", [missing])], data=data,
        rows=as_columns(records), reader=reader(None, described.words),
    )  # fmt: skip


def _summary(described: Sport) -> dict[str, Any]:
    stroke = described.stroke
    return {
        "key": described.key,
        "name": described.name,
        "balls": list(described.balls),
        "implements": list(sport_implements(described.key)),
        "swing_speed_m_s": stroke.swing_speed.value,
        "swing_speed_kind": stroke.swing_speed.kind,
        "ball_speed_m_s": stroke.ball_speed.value,
        "ball_speed_kind": stroke.ball_speed.kind,
        **{str(kind): number for kind, number in certainty(described.key).items()},
    }


def _record(fact: Fact) -> dict[str, Any]:
    return {name: getattr(fact, name) for name in ("name", "value", "unit", "written", "kind", "source", "where")}


def _stroke(described: Sport) -> Table:
    stroke, words = described.stroke, described.words
    place: str | Sentence = f"at the {words.tip}"
    if stroke.from_tip:
        place = say("{distance} from the {tip}", distance=Slot(stroke.from_tip, "place"), tip=words.tip)
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
    return say("{speed}{mark}", speed=Slot(speed, "speed"), mark="*" if kind == "assumed" else "")

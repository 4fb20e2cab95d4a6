"""Lead on a racket as a document: where it goes, and how near it comes to the other racket."""

from __future__ import annotations

from sweetspot.answers.match import Feel, Lead, MatchAnswer
from sweetspot.catalog.swing_laws import swing_weight
from sweetspot.reports.bat.tables import in_kg_cm2
from sweetspot.reports.document import Cell, Column, Document, Paragraph, Table, as_columns
from sweetspot.reports.sentences import Sentence, Slot
from sweetspot.reports.sport_words import in_words, reader_of, words_of


def match_document(answer: MatchAnswer) -> Document:
    """Return the lead as a document."""
    implement, target = answer.question.implement, answer.question.target
    data = answer.to_dict()
    return Document(
        name="match",
        title=f"{implement.name} to feel like {target.name}",
        kind="Lead",
        blocks=[Paragraph(_verdict(answer)), *_table_of_lead(answer), _table_of_feel(answer)],
        data=data,
        rows=as_columns(data["lead"]),
        reader=reader_of(implement.sport),
    )


def _verdict(answer: MatchAnswer) -> Sentence:
    words, target = words_of(answer.question.implement.sport), answer.question.target.name
    if not answer.lead and answer.reached:
        text = "All four numbers are those of {target} already."
    elif not answer.lead:
        text = "No lead brings it nearer to {target}: lead only adds weight."
    elif answer.reached:
        text = "{total} of lead in {number} places gives this {implement} all four numbers of {target}."
    else:
        text = (
            "{total} of lead in {number} places comes nearest to {target}, and not all four numbers are met: lead only "
            "adds weight, and only where it may go."
        )
    total = sum(float(piece.mass) for piece in answer.lead)
    return in_words(text, words, target=target, total=Slot(total, "mass", 1), number=str(len(answer.lead)))


def _table_of_lead(answer: MatchAnswer) -> list[Table]:
    if not answer.lead:
        return []
    words = words_of(answer.question.implement.sport)
    columns = [Column(f"from the {words.butt}", right=True), Column("lead", "mass", 1), Column("how")]
    rows: list[list[Cell]] = [
        [Slot(piece.position, "place"), Slot(piece.mass, "mass", 1, unit=False), _how(piece, answer)]
        for piece in answer.lead
    ]
    return [Table("Where the lead goes", columns, rows, name="lead")]


def _how(piece: Lead, answer: MatchAnswer) -> Sentence:
    words = words_of(answer.question.implement.sport)
    half = Slot(float(piece.mass) / 2, "mass", 1)
    return in_words("{half} on each side of the frame" if piece.lateral else "on the middle line", words, half=half)


def _table_of_feel(answer: MatchAnswer) -> Table:
    words = words_of(answer.question.implement.sport)
    axis = swing_weight(answer.question.implement.sport).axis
    feels = (answer.before, answer.after, answer.target)
    columns = [Column(""), *(Column(name, right=True) for name in ("now", "with the lead", "to feel like"))]
    rows: list[list[Cell]] = [
        ["mass", *(Slot(feel.mass, "mass", 1) for feel in feels)],
        [f"balance point, from the {words.butt}", *(Slot(feel.balance_point, "length") for feel in feels)],
        [
            in_words("swing weight, about {axis:place} from the {butt}", words, axis=axis),
            *_in_kg_cm2(feels, "swing_weight"),
        ],
        ["twist weight", *_in_kg_cm2(feels, "twist_weight")],
    ]
    return Table("How it feels", columns, rows, name="feel")


def _in_kg_cm2(feels: tuple[Feel, ...], name: str) -> list[str]:
    return [in_kg_cm2(getattr(feel, name)) for feel in feels]

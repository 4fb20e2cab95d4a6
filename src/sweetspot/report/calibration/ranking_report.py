"""A ranking of bats as an answer."""

from __future__ import annotations

from typing import Any

from sweetspot.calibration.measured import LEVEL
from sweetspot.calibration.ranking import RankedBat, Ranking
from sweetspot.report.calibration.intervals import half_width, measured_json
from sweetspot.report.document import Block, Column, Document, Paragraph, Table
from sweetspot.report.json_shapes import cleaned
from sweetspot.report.sentences import Sentence, Slot, joined, say

WORDS = {"mass": "weight", "balance_point": "balance", "moi": "swing weight", "modulus": "stiffness"}
UNITS = {"mass": "_kg", "balance_point": "_m", "moi": "_kg_m2", "modulus": ""}


def ranking_document(ranking: Ranking, *, model: str) -> Document:
    """Return a ranking as an answer: who is first and how surely, whether they differ at all, what differs."""
    rows = [
        (
            one.name, one.exit_speed.value, half_width(one.exit_speed), one.best_chance, one.properties["mass"].value,
            one.properties["moi"].value, one.properties["modulus"].value - 1,
            ", ".join(WORDS[name] for name in one.differs) or "nothing surely",
        )
        for one in ranking.bats
    ]  # fmt: skip
    columns = [
        Column("bat"), Column("exit speed", "speed"), Column("±", "speed", digits=2), Column("best of all", "share"),
        Column("weight", "mass"), Column("MOI", "moi"), Column("E off", "share", digits=1, sign=True),
        Column("differs in"),
    ]  # fmt: skip
    blocks: list[Block] = [Paragraph(ranking_words(ranking))]
    for one in ranking.bats:
        off = ", ".join(f"{name} lies {abs(pull):.1f} sigma off" for name, pull in one.contradictions.items())
        if off:
            blocks.append(Paragraph(f"{one.name}: {off}; measure it again.", "warning"))
    blocks.append(Table("The bats", columns, rows))
    blocks.append(
        Paragraph(
            say(
                "{level} intervals: of the bat alone, hit by the same ball. MOI: about 6 in from the knob. E off: "
                "modulus against the drawing's. Where a moisture was given, all is told at 12 %.",
                level=Slot(LEVEL, "share"),
            ),
            "note",
        )
    )
    data = ranking_json(ranking)
    flat = [{key: value for key, value in one.items() if not isinstance(value, (dict, list))} for one in data["bats"]]
    return Document(
        name="rank", title=f"{len(ranking.bats)} bats like {model}", blocks=blocks, data=data,
        rows={key: [one[key] for one in flat] for key in flat[0]},
    )  # fmt: skip


def ranking_words(ranking: Ranking) -> Sentence:
    """Return in words who is first, how surely, and whether the bats differ by more than wood does."""
    first, last = ranking.bats[0], ranking.bats[-1]
    words = [
        say(
            "{name} hits best: {speed}, with a chance of {chance} of being the best of {count}; {last} comes last, "
            "{apart} behind.", name=first.name, speed=Slot(first.exit_speed.value, "speed"),
            chance=Slot(first.best_chance, "share"), count=len(ranking.bats), last=last.name,
            apart=Slot(first.exit_speed.value - last.exit_speed.value, "speed_change"),
        )
    ]  # fmt: skip
    sizes = {"scatter": Slot(ranking.scatter, "speed_change", 2), "chance": Slot(ranking.by_chance, "speed_change", 2),
             "doubt": Slot(ranking.not_known, "speed_change", 2),
             "wood": Slot(ranking.wood, "speed_change", 2)}  # fmt: skip
    verdict = (
        "The bats differ by {scatter} (one sigma), more than the {chance} that chance alone could make of the {doubt} "
        "that is not known of each: the order means something."
        if ranking.beyond_doubt
        else "The bats differ by {scatter} (one sigma), no more than the {chance} that chance alone could make of the "
        "{doubt} that is not known of each: the order may be chance."
    )
    words.append(say(verdict, **sizes))
    words.append(
        say(
            "Bats of this outline in any billet of this wood would differ by {wood}; these differ by {more}.",
            more=_beside_wood(ranking), **sizes,
        )
    )  # fmt: skip
    return joined(words)


def _beside_wood(ranking: Ranking) -> str:
    if ranking.scatter <= ranking.wood:
        return "no more than wood does by itself"
    much = ranking.scatter > 1.5 * ranking.wood
    return "much more: look for another reason" if much else "little more, which wood may do by itself"


def ranking_json(ranking: Ranking) -> dict[str, Any]:
    """Return a ranking, SI."""
    found: dict[str, Any] = cleaned(
        {
            "interval_level": LEVEL,
            "scatter_m_s": ranking.scatter,
            "not_known_m_s": ranking.not_known,
            "by_chance_m_s": ranking.by_chance,
            "wood_m_s": ranking.wood,
            "beyond_doubt": ranking.beyond_doubt,
            "bats": [_bat_json(one) for one in ranking.bats],
        }
    )
    return found


def _bat_json(one: RankedBat) -> dict[str, Any]:
    return {
        "name": one.name,
        **measured_json(one.exit_speed, "exit_speed", "_m_s"),
        "best_chance": one.best_chance,
        "best_position_m": one.place,
        "mass_kg": one.properties["mass"].value,
        "moi_6in_kg_m2": one.properties["moi"].value,
        "properties": {name: measured_json(value, name, UNITS[name]) for name, value in one.properties.items()},
        "differs": list(one.differs),
        "contradictions": one.contradictions,
    }

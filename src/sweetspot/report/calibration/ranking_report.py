"""A ranking of bats as an answer."""

from __future__ import annotations

from typing import Any

from sweetspot.calibration.ranking import RankedBat, Ranking
from sweetspot.catalog.sports import sport
from sweetspot.catalog.swing_weights import swing_weight
from sweetspot.dynamics.rigid import RigidBody
from sweetspot.equipment.bat import Bat
from sweetspot.equipment.implement import Implement
from sweetspot.numerics.confidence import LEVEL
from sweetspot.report.calibration.document import axis_words, source_words
from sweetspot.report.calibration.intervals import half_width, measured_json
from sweetspot.report.document import Block, Column, Document, Paragraph, Table
from sweetspot.report.json_shapes import cleaned
from sweetspot.report.quantities import reader
from sweetspot.report.sentences import Sentence, Slot, joined, say

WORDS = {"mass": "weight", "balance_point": "balance", "moi": "swing weight", "modulus": "stiffness"}
UNITS = {"mass": "_kg", "balance_point": "_m", "moi": "_kg_m2", "modulus": ""}

LAST_DIGIT = (
    "A value without ± counts to one unit of its last digit, 1.4545 as 1.4545 ± 0.0001. Write 1.4545±0.003 where it is "
    "less sure."
)


def ranking_document(ranking: Ranking, *, model: Implement) -> Document:
    """Return a ranking as an answer: who is first and how surely, whether they differ at all, what differs."""
    convention = swing_weight(model.sport)
    lettered = convention.zero is not None
    rows = [
        (
            one.name, one.exit_speed.value, half_width(one.exit_speed), one.best_chance, one.properties["mass"].value,
            one.properties["moi"].value,
            *([convention.text_of(_as_body(one, model))] if lettered else []), _stiffer(one),
            "not ranked" if one in ranking.unranked else ", ".join(WORDS[name] for name in one.differs)
            or "nothing surely",
        )
        for one in (*ranking.bats, *ranking.unranked)
    ]  # fmt: skip
    of_bats = isinstance(model, Bat)
    words = sport(model.sport).words
    columns = [
        Column(words.implement), Column("exit speed", "speed"), Column("±", "speed", digits=2),
        Column("best of all", "share"),
        Column("weight", "mass"), Column("MOI" if of_bats or lettered else "swing weight", "moi"),
        *([Column(convention.name)] if lettered else []),
        Column("E off" if of_bats else "stiffness off", "share", digits=1, sign=True),
        Column("differs in"),
    ]  # fmt: skip
    blocks: list[Block] = []
    for one in (*ranking.unranked, *(one for one in ranking.bats if one.contradictions)):
        off = ", ".join(
            f"{source_words(name, model)} lies {abs(pull):.1f} sigma off" for name, pull in one.contradictions.items()
        )
        then = (
            "It is not ranked, and the words below leave it out. Measure it again, or check the drawing."
            if one in ranking.unranked
            else f"Its measurements agree on an unusual {words.implement}; its place holds if they are right."
        )
        blocks.append(Paragraph(f"{one.name}: {off}. {then}", "warning"))
    if ranking.unranked:
        blocks.append(Paragraph(LAST_DIGIT, "note"))
    blocks.append(Paragraph(ranking_words(ranking, model=model)))
    blocks.append(Table(f"The {words.implement}s", columns, rows))
    blocks.append(
        Paragraph(
            say(
                "{level} intervals: of the bat alone, hit by the same ball. MOI: about {axis}. E off: "
                "modulus against the drawing's. Where a moisture was given, all is told at 12 %."
                if of_bats
                else "{level} intervals: of the {thing} alone, hit by the same ball. {moi}: about {axis}. "
                "Stiffness off: the first frequency squared, against the description's.",
                level=Slot(LEVEL, "share"),
                thing=words.implement,
                moi="MOI" if lettered else "Swing weight",
                axis=axis_words(model.swing_axis, words.butt),
            ),
            "note",
        )
    )
    data = ranking_json(ranking, axis=None if of_bats else model.moi_axis)
    flat = [{key: value for key, value in one.items() if not isinstance(value, (dict, list))} for one in data["bats"]]
    return Document(
        name="rank", title=f"{len(rows)} {words.implement}s like {model.name}", blocks=blocks, data=data,
        rows={key: [one[key] for one in flat] for key in flat[0]}, reader=reader(None, words),
    )  # fmt: skip


def _as_body(one: RankedBat, model: Implement) -> RigidBody:
    """Return a ranked implement as the rigid body that its weight, balance and moment of inertia are those of."""
    mass, balance, moi = (one.properties[name].value for name in ("mass", "balance_point", "moi"))
    about_balance = moi - mass * (balance - model.moi_axis) ** 2
    return RigidBody(mass=mass, balance_point=balance, moi_cm=about_balance, roll_moi=0.0)


def _stiffer(one: RankedBat) -> float | None:
    """Return by which part a bat is stiffer than described; None: it was not tapped."""
    known = one.properties.get("modulus")
    return None if known is None else known.value - 1


def ranking_words(ranking: Ranking, *, model: Implement) -> Sentence:
    """Return in words who is first, how surely, and whether bats differ by more than wood or making does."""
    first, last = ranking.bats[0], ranking.bats[-1]
    words = [
        say(
            "{name} comes first: {speed}, with a chance of {chance} of being the best of {count}; {last} comes last, "
            "{apart} behind.", name=first.name, speed=Slot(first.exit_speed.value, "speed"),
            chance=Slot(first.best_chance or 0.0, "share"), count=len(ranking.bats), last=last.name,
            apart=Slot(first.exit_speed.value - last.exit_speed.value, "speed_change"),
        )
    ]  # fmt: skip
    likeliest = max(ranking.bats, key=lambda one: one.best_chance or 0.0)
    if likeliest is not first:
        more = Slot(likeliest.best_chance or 0.0, "share")
        words.append(say("Likelier to be the best is {name}, {chance}.", name=likeliest.name, chance=more))
    sizes = {"scatter": Slot(ranking.scatter, "speed_change", 2), "chance": Slot(ranking.by_chance, "speed_change", 2),
             "doubt": Slot(ranking.not_known, "speed_change", 2),
             "wood": Slot(ranking.wood, "speed_change", 2)}  # fmt: skip
    verdict = (
        "They differ by {scatter} (one sigma); {things} all alike would seem to differ by up to {chance}, for {doubt} "
        "is not known of each: the order as a whole means something, neighbours in it may be alike."
        if ranking.beyond_doubt
        else "They differ by {scatter} (one sigma); {things} all alike may seem to differ by up to {chance}, for "
        "{doubt} is not known of each: the order may be chance."
    )
    words.append(say(verdict, things=f"{sport(model.sport).words.implement}s", **sizes))
    if not isinstance(model, Bat):
        return joined(words)
    apart = (
        "Bats of this outline in any billet of this wood would differ by {wood}; these differ by {more}."
        if model.shell is None
        else "Bats of this drawing whose metal, wall and fittings differ as is supposed would differ by {wood}; these "
        "differ by {more}."
    )
    reason = "wood" if model.shell is None else "making"
    words.append(say(apart, more=_beside_making(ranking, reason), **sizes))
    return joined(words)


def _beside_making(ranking: Ranking, reason: str) -> str:
    if ranking.scatter <= ranking.wood:
        return f"no more than {reason} does by itself"
    if not ranking.beyond_doubt:
        return "more, which what is not known of each may do by itself"
    if ranking.scatter <= ranking.wood_by_chance:
        return f"little more, which {reason} may do by itself"
    return "much more: look for another reason"


def ranking_json(ranking: Ranking, *, axis: float | None = None) -> dict[str, Any]:
    """Return a ranking, SI.

    Parameters
    ----------
    axis : m from the butt end, of the swing weight; None: the moment of inertia is about 6 in.
    """
    data: dict[str, Any] = cleaned(
        {
            "interval_level": LEVEL,
            "scatter_m_s": ranking.scatter,
            "not_known_m_s": ranking.not_known,
            "by_chance_m_s": ranking.by_chance,
            "wood_m_s": ranking.wood,
            "beyond_doubt": ranking.beyond_doubt,
            "bats": [_bat_json(one, axis) for one in (*ranking.bats, *ranking.unranked)],
        }
    )
    return data


def _bat_json(one: RankedBat, axis: float | None) -> dict[str, Any]:
    turning = one.properties["moi"].value
    return {
        "name": one.name,
        **measured_json(one.exit_speed, "exit_speed", "_m_s"),
        "best_chance": one.best_chance,
        "best_position_m": one.place,
        "mass_kg": one.properties["mass"].value,
        **({"moi_6in_kg_m2": turning} if axis is None else {"swing_weight_kg_m2": turning, "moi_axis_m": axis}),
        "properties": {name: measured_json(value, name, UNITS[name]) for name, value in one.properties.items()},
        "differs": list(one.differs),
        "contradictions": one.contradictions,
    }

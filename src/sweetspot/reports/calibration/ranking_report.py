"""A ranking of bats as an answer."""

from __future__ import annotations

from sweetspot.answers.rank import RankAnswer, RankedBat
from sweetspot.catalog.sports import sport
from sweetspot.catalog.swing_laws import swing_weight
from sweetspot.dynamics.rigid import RigidBody
from sweetspot.equipment.bat import Bat
from sweetspot.equipment.implement import Implement
from sweetspot.reports.calibration.document import axis_words, source_words
from sweetspot.reports.document import Block, Column, Document, Paragraph, Table, as_columns
from sweetspot.reports.quantities import reader
from sweetspot.reports.sentences import Sentence, Slot, joined, say

WORDS = {"mass": "weight", "balance_point": "balance", "moi": "swing weight", "modulus": "stiffness"}

LAST_DIGIT = (
    "A value without ± counts to its last digit, and no less than 1 g, 0.5 mm of balance, 2 ms of a swing or 0.3 Hz. "
    "Write 1.4545±0.005 where it is less sure."
)


def ranking_document(answer: RankAnswer) -> Document:
    """Return a ranking as a document: who is first and how surely, whether they differ at all, what differs."""
    model, unranked = answer.model, answer.unranked
    convention = swing_weight(model.sport)
    lettered = convention.zero is not None
    rows = [
        (
            bat.name,
            bat.exit_speed.value,
            bat.exit_speed.half_width,
            bat.best_chance,
            bat.mass if bat.weighed is None else bat.weighed,
            bat.properties.moi.value.value,
            *([convention.text_of(_as_body(bat, model))] if lettered else []),
            _stiffer(bat),
            "not ranked" if bat in unranked else ", ".join(WORDS[name] for name in bat.differs) or "nothing surely",
        )
        for bat in answer.bats
    ]
    of_bats = isinstance(model, Bat)
    words = sport(model.sport).words
    moi = "MOI" if of_bats or lettered else "swing weight"
    columns = [
        Column(words.implement),
        Column("exit speed", "speed"),
        Column("±", "speed", digits=2),
        Column("best of all", "share"),
        Column("weight", "mass"),
        Column(say("{name} about {axis:place, round},", name=moi, axis=model.swing_axis), "moi"),
        *([Column(convention.name)] if lettered else []),
        Column("E off" if of_bats else "stiffness off", "share", digits=1, sign=True),
        Column("differs in"),
    ]
    blocks: list[Block] = []
    for bat in (*unranked, *(bat for bat in answer.ranked if bat.contradictions)):
        off = ", ".join(
            f"{source_words(name, model)} lies {abs(pull):.1f} sigma off" for name, pull in bat.contradictions.items()
        )
        if bat in unranked:
            then = "It is not ranked, and the words below leave it out. Measure it again, or check the drawing."
        elif bat.far_off:
            then = "Of so many readings one may lie there by chance, so it stays in the list. Measure it again."
        else:
            then = f"Its measurements agree on an unusual {words.implement}; its place holds if they are right."
        blocks.append(Paragraph(f"{bat.name}: {off}. {then}", "warning"))
    if unranked:
        blocks.append(Paragraph(LAST_DIGIT, "note"))
    blocks.append(Paragraph(ranking_words(answer)))
    blocks.append(Table(f"The {words.implement}s", columns, rows))
    blocks.append(
        Paragraph(
            say(
                "{level} intervals: of the bat alone, hit by the same ball. Weight: as it stood on the scale. MOI: "
                "about {axis}. E off: modulus against the drawing's. Where a moisture was given, speed, MOI and E are "
                "at 12 %."
                if of_bats
                else "{level} intervals: of the {thing} alone, hit by the same ball. {moi}: about {axis}. "
                "Stiffness off: the first frequency squared, against the description's.",
                level=Slot(answer.interval_level, "share"),
                thing=words.implement,
                moi="MOI" if lettered else "Swing weight",
                axis=axis_words(model.swing_axis, words.butt),
            ),
            "note",
        )
    )
    data = answer.to_dict()
    flat = [{key: value for key, value in bat.items() if not isinstance(value, (dict, list))} for bat in data["bats"]]
    return Document(
        name="rank",
        title=f"{len(rows)} {words.implement}s like {model.name}",
        blocks=blocks,
        data=data,
        rows=as_columns(flat),
        reader=reader(None, words),
    )


def _as_body(bat: RankedBat, model: Implement) -> RigidBody:
    """Return a ranked implement as the rigid body that its weight, balance and moment of inertia are those of."""
    mass, balance, moi = (bat.properties.by_name[name].value for name in ("mass", "balance_point", "moi"))
    about_balance = moi - mass * (balance - model.moi_axis) ** 2
    return RigidBody(mass=mass, balance_point=balance, moi_cm=about_balance, roll_moi=0.0)


def _stiffer(bat: RankedBat) -> float | None:
    """Return by which part a bat is stiffer than described; None: it was not tapped."""
    modulus = bat.properties.modulus
    return None if modulus is None else modulus.value.value - 1


def ranking_words(answer: RankAnswer) -> Sentence:
    """Return in words who is first, how surely, and whether bats differ by more than wood or making does."""
    ranked, model = answer.ranked, answer.model
    first, last = ranked[0], ranked[-1]
    first_words = (
        "{first.name} comes first: {speed:speed}, with a chance of {chance:share} of being the best of {count}; "
        "{last.name} comes last, {apart:speed_change} behind."
    )
    speed, chance = first.exit_speed.value, first.best_chance or 0.0
    facts = {"speed": speed, "chance": chance, "count": len(ranked), "apart": speed - last.exit_speed.value}
    words = [say(first_words, first=first, last=last, **facts)]
    likeliest = max(ranked, key=lambda bat: bat.best_chance or 0.0)
    if likeliest is not first:
        more = Slot(likeliest.best_chance or 0.0, "share")
        words.append(say("Likelier to be the best is {name}, {chance}.", name=likeliest.name, chance=more))
    sizes = {
        "scatter": Slot(answer.scatter, "speed_change", 2),
        "chance": Slot(answer.by_chance, "speed_change", 2),
        "wood": Slot(answer.wood, "speed_change", 2),
    }
    verdict = (
        "The {things} really differ, by about {scatter}; measuring error alone would give {chance} at most. "
        "Neighbours in the list may be equal."
        if answer.beyond_doubt
        else "The order may be chance: the {things} differ by about {scatter}, and measuring error alone may give "
        "{chance}."
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
    words.append(say(apart, more=_beside_making(answer, reason), **sizes))
    return joined(words)


def _beside_making(answer: RankAnswer, reason: str) -> str:
    if answer.scatter <= answer.wood:
        return f"no more than {reason} does by itself"
    if not answer.beyond_doubt:
        return "more, which what is not known of each may do by itself"
    if answer.scatter <= answer.wood_by_chance:
        return f"little more, which {reason} may do by itself"
    return "much more: look for another reason"

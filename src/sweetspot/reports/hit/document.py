"""A hit as a document: what came out, where the energy went, and what it did to the bat."""

from __future__ import annotations

import numpy as np

from sweetspot.answers.hit import Collision, Hit, HitAnswer, Strains, collision_of
from sweetspot.answers.records import to_dict
from sweetspot.collision.coupled import hit
from sweetspot.collision.impact import Impact, Outcome
from sweetspot.dynamics.modes import Modes
from sweetspot.equipment.ball import Ball
from sweetspot.equipment.sport import Terms
from sweetspot.numerics.arrays import Array
from sweetspot.numerics.interval import Number
from sweetspot.reports.bat.provenance import assumed_wall, known_misses, soft_note
from sweetspot.reports.document import Block, Cell, Document, Paragraph, Picture, Table, drawn, values_table
from sweetspot.reports.quantities import ENERGY_NAMES
from sweetspot.reports.sentences import Sentence, Slot, Span, UnitName, joined, say
from sweetspot.reports.sport_words import in_words, reader_of, weight, words_of
from sweetspot.reports.uncertainty import how_sure

Rows = list[tuple[Cell, Cell]]
FEW_JOULES, FEW_NEWTONS = 20.0, 5e3
"""Below these a number is shown with more digits."""
SEPARATED = Outcome.SEPARATED.name.lower()
TOLD = 1e-3
"""A part of the energy below which what a sum misses is rounding."""


def hit_document(answer: HitAnswer) -> Document:
    """Return a hit as a document."""
    implement, conditions, impact = answer.question.implement, answer.question.conditions, answer.impact
    words = words_of(implement.sport)
    place = in_words("hit {place:place} from the {tip}", words, place=implement.length - impact.position)
    picture = hit_picture(impact, words, title=say("{name}, {place}", name=implement.name, place=place))
    masses = masses_words(answer.bat.mass, answer.ball_mass, words)
    data = answer.to_dict()
    return Document(
        name="hit",
        title=implement.name,
        kind="Hit",
        subtitle=place,
        blocks=[
            Paragraph(lead_words(answer, words)),
            hit_table(answer, words, masses, rigid=implement.face is None),
            *_aside(answer, words),
            *map(Paragraph, by_ball(answer.exit_speed_half_by_ball, answer.exit_speed_half_by_kind, words)),
            *_doubts(impact, words),
            *known_misses(implement.sport, implement.length - impact.position),
            *assumed_wall(implement),
            *in_hands(answer.exit_speed, answer.exit_speed_in_hands, words),
            *_damage_blocks(answer.damage, words),
            *soft_note(implement.sport, conditions.ball),
            picture,
            *([] if answer.uncertainty is None else [how_sure(answer.uncertainty, "exit speed")]),
        ],
        data=data,
        rows=data["history"],
        reader=reader_of(implement.sport),
        drawing=picture,
    )


def lead_words(hit: Hit, words: Terms) -> Sentence:
    """Return the exit speed in a sentence, or the reason why there is none."""
    if hit.outcome != SEPARATED:
        return say("{outcome}.", outcome=_outcome(hit, words))
    return in_words(
        "The {ball} leaves at {hit.exit_speed:speed}, off a {implement} that moves at {hit.bat_speed:speed} there.",
        words,
        hit=hit,
    )


def _outcome(hit: Hit, words: Terms) -> str:
    text = hit.outcome_text.replace(" bat ", f" {words.implement} ")
    return text[0].upper() + text[1:]


def _aside(answer: HitAnswer, words: Terms) -> list[Block]:
    """Return the direction of a ball that met a flat face beside its line; nothing of any other."""
    if answer.aside is None:
        return []
    lateral, aside = Slot(abs(answer.impact.lateral), "place", round=True), Slot(abs(float(answer.aside)), "angle", 1)
    text = "{lateral} beside the middle line the face turns under the {ball}, which leaves {aside} to that side{curve}."
    return [Paragraph(in_words(text, words, lateral=lateral, aside=aside, curve=curve(answer.gear_spin)))]


def curve(spin: Number | None) -> Sentence:
    """Return how side spin curves a golf ball; nothing for other balls."""
    if spin is None:
        return say("")
    back = "back" if float(spin) > 0 else "further out"
    return say(", with {spin:spin} that curves it {back}", spin=abs(float(spin)), back=back)


def masses_words(tool: Number, ball: Number, words: Terms) -> Sentence:
    """Return the masses that met, kg, in words."""
    return in_words("{implement} {tool:mass}, {ball} {thrown}", words, tool=tool, thrown=weight(ball))


def by_ball(scatter: Number | None, common: Number | None, words: Terms) -> list[Sentence]:
    """Return in words the uncertainty of an exit speed due to the ball alone; nothing if unknown.

    Parameters
    ----------
    scatter, common : halves of 90 % intervals, m/s: from ball to ball, and of all balls of the kind alike.
    """
    if scatter is None or common is None:
        return []
    return [
        in_words(
            "No two {ball}s are the same: nine in ten come off within {scatter} of that. How lively they are on "
            "average, and how they spring back, is known to {common} (90 %).",
            words,
            scatter=Slot(scatter, "speed_change", 1),
            common=Slot(common, "speed_change", 1),
        )
    ]


def _doubts(impact: Impact, words: Terms) -> list[Paragraph]:
    return [Paragraph(doubt, "warning") for doubt in touched_again(impact, words)]


def impact_document(impact: Impact) -> Document:
    """Return a collision alone as a document, without its bat's name or swing speed."""
    bare, words = collision_of(impact), Terms()
    data = to_dict(bare)
    title = say("Hit {place:place} from the end of the grip", place=impact.position)
    picture = hit_picture(impact, words, title=title)
    rows: Rows = [
        ("closing speed", Slot(bare.closing_speed, "speed")),
        ("collision efficiency q", Slot(bare.collision_efficiency, "ratio", 4)),
        *_contact_rows(bare, words), *_energy_rows(bare, words),
    ]  # fmt: skip
    return Document(
        name="hit", title=title, kind="Hit",
        blocks=[values_table(rows), *_doubts(impact, words), picture], data=data, rows=data["history"],
        drawing=picture,
    )  # fmt: skip


def hit_table(hit: Hit, words: Terms, masses: Sentence, *, rigid: bool) -> Table:
    """Return one hit in the words of its sport.

    Parameters
    ----------
    masses : what met, in words.
    rigid : whether the ball does not meet a face, so that BBCOR is defined.
    """
    rows: Rows = [
        *([] if hit.outcome == SEPARATED else [("outcome", _outcome(hit, words))]),
        (f"{words.implement} speed there", Slot(hit.bat_speed, "speed")),
        (words.exit_speed, Slot(hit.exit_speed, "speed")),
        (words.efficiency, Slot(hit.collision_efficiency, "ratio", 4)),
    ]
    if words.smash_factor and hit.smash_factor is not None:
        rows.append((words.smash_factor, Slot(hit.smash_factor, "ratio")))
    if rigid:
        rows.append(("BBCOR at this speed", Slot(hit.bbcor, "ratio")))
    return values_table([*rows, *_contact_rows(hit, words), *_energy_rows(hit, words), ("masses", masses)])


def hit_picture(impact: Impact, words: Terms, caption: str | Sentence = "", *, title: str | Sentence = "") -> Picture:
    """Return force and energy of a hit, drawn."""
    heat = impact.energy.heat / impact.energy.incoming if impact.energy.incoming else 0.0
    label = in_words(
        "Force of the hit: it rises to {force} and lasts {time:contact, 2}. Of the energy, {heat:share} become heat "
        "in the {ball}.", words, force=_force(impact.peak_force), time=impact.contact_time, heat=heat)  # fmt: skip
    return Picture("hit", drawn("sweetspot.reports.hit.picture:hit_figure", impact, words, title), label, caption)


def _contact_rows(hit: Collision, words: Terms) -> Rows:
    pressed = Slot(hit.peak_compression, "pressed")
    return [
        ("contact, force above 1 % of its peak", Slot(hit.contact_time, "contact")),
        ("peak force", _force(hit.peak_force)),
        (in_words("peak compression of the {ball}", words), pressed),
    ]


def _energy_rows(hit: Collision, words: Terms) -> Rows:
    """Return the ledger; a part that the implement does not have is left out."""
    digits = 1 if float(hit.energy.incoming) > FEW_JOULES else 3
    rows: Rows = []
    for field, (name, _) in ENERGY_NAMES.items():
        joules, share = getattr(hit.energy, field), getattr(hit.energy_share, field)
        if not float(joules) and field in ("face", "hoop"):
            continue
        part = Slot(share, "share", 1)
        energy = Slot(joules, "energy", digits)
        rows.append((in_words(f"energy: {name}", words), say("{joules}, {part}", joules=energy, part=part)))
    missed = abs(hit.energy_imbalance)
    return rows if missed < TOLD else [*rows, ("energy: what the sum misses", Slot(missed, "share", 1))]


def _damage_blocks(strains: Strains | None, words: Terms) -> list[Block]:
    """Return the strains of one hit in words, with a warning for each limit that is passed."""
    if strains is None:
        return []
    text = in_words(
        "Greatest bending strain of the handle {strains.handle_strain:strain}, {strains.handle_position:place} from "
        "the {butt}",
        words,
        strains=strains,
    )
    if strains.wall_strain is not None:
        text += say("; of the barrel's wall {strain:strain}", strain=strains.wall_strain)
    limit = strains.handle_strain_limit
    if limit is not None and float(strains.handle_strain) > limit and not strains.warnings:
        text += say(
            ". In a slow test its wood reaches its strength at {limit:strain}; in a blow it bears two or three times "
            "as much", limit=limit)  # fmt: skip
    if strains.least_breaking_speed is not None:
        text += say(
            ". A hit at this place breaks the handle between {low:speed, 0} and {high:speed, 0} of closing speed",
            low=strains.least_breaking_speed,
            high=strains.most_breaking_speed,
        )
    return [Paragraph(text + "."), *(Paragraph(f"Warning: {words}", "warning") for words in strains.warnings)]


def _force(force: Number) -> Slot:
    return Slot(force, "blow", None if float(force) > FEW_NEWTONS else 3)


AGAIN = (
    "{where} {implement} catches up with the {ball} and hits it again. How far a {ball} has recovered by then has "
    "not been measured: it is taken to spring back about as quickly as it was pressed in{otherwise}."
)
FIRST_TOUCH = "By the first touch alone it would leave {slower:speed} {faster}, {efficiency} {first}."
IN_HANDS = (
    "These numbers are for {a} {implement} that no hands hold. Gripped as people do (assumed), it sends the {ball} off "
    "{change} {faster}: here the grip counts, and its effect was not measured."
)
GRIP_MATTERS = 0.01
"""Of the exit speed; on the barrel hands change less than that (`docs/theory/collision.md`)."""
PRESSED_AGAIN = (
    "{where} {implement} catches up with a {ball} that is nearly gone and presses it again. How far a {ball} has "
    "recovered by then has not been measured"
)


def best_in_doubt(best: Impact, words: Terms) -> list[Sentence]:
    """Return the doubt of a best hit that presses the ball more than once; nothing for any other."""
    if best.presses < 2:
        return []
    return [
        in_words(
            PRESSED_AGAIN + ", and the best place and its speed follow from what is taken for it.", words,
            where="There the",
        )
    ]  # fmt: skip


def touched_again(impact: Impact, words: Terms) -> list[Sentence]:
    """Return the doubt of a hit whose ball is pressed more than once, in one sentence; nothing of any other."""
    if impact.presses < 2 and impact.unrecovered is None:
        return []
    first = impact.first_touch_efficiency
    alone = (
        []
        if first is None
        else [
            in_words(
                FIRST_TOUCH,
                words,
                slower=impact.closing_speed * abs(first - impact.collision_efficiency),
                faster="slower" if first < impact.collision_efficiency else "faster",
                first=Slot(first, "ratio"),
            )
        ]
    )
    if impact.unrecovered is None:
        return [in_words(PRESSED_AGAIN + ": it springs on as it was.", words, where="The"), *alone]
    gain = impact.unrecovered_gain
    otherwise = in_words(
        "; had it not recovered at all, it would leave {gain:speed} {faster}",
        words,
        gain=abs(gain),
        faster="slower" if gain < 0 else "faster",
    )
    return [in_words(AGAIN, words, where="The", otherwise=otherwise), *alone]


def in_hands(free: Number, held: Number | None, words: Terms) -> list[Block]:
    """Describe the change by typical hands, where that is more than `GRIP_MATTERS` of the exit speed; else nothing.

    Parameters
    ----------
    free, held : exit speed, m/s, of an implement that no hands hold and of one in typical hands; None: not asked.
    """
    if held is None or abs(float(held) - float(free)) <= GRIP_MATTERS * abs(float(free)):
        return []
    change = float(held) - float(free)
    return [
        Paragraph(
            in_words(
                IN_HANDS,
                words,
                a="an" if words.implement[0] in "aeiou" else "a",
                change=Slot(abs(change), "speed_change", 1),
                faster="faster" if change > 0 else "slower",
            ),
            "warning",
        )
    ]


def touched_again_at(
    perhaps: bool, words: Terms, *, modes: Modes, ball: Ball, position: float, closing_speed: float,
    lateral: float = 0.0,
) -> list[Sentence]:  # fmt: skip
    """Return the same for a hit of the compiled solver, which is made once more for it."""
    if not perhaps:
        return []
    again = hit(modes, ball=ball, position=position, lateral=lateral, closing_speed=closing_speed)
    return touched_again(again, words)


def touched_again_between(from_tip: Array, touches: Array, words: Terms) -> list[Sentence]:
    """Return the same for hits along a bat, stretch by stretch.

    Parameters
    ----------
    from_tip : m, of neighbours along the bat, shape (n,).
    touches : how often the ball is touched there, shape (n,).
    """
    places = np.flatnonzero(touches > 1)
    if len(places) == 0:
        return []
    stretches = [from_tip[each] for each in np.split(places, np.flatnonzero(np.diff(places) > 1) + 1)]
    spans = (
        Sentence((Span(float(stretche.min()), float(stretche.max()), "place", unit=False),))
        for stretche in sorted(stretches, key=np.min)
    )
    where = in_words(
        "Hit {places} {unit} from the {tip}, the", words, unit=UnitName("place"), places=joined(spans, " and "),
    )  # fmt: skip
    return [in_words(AGAIN, words, where=where, otherwise="")]

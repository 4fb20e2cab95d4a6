"""A hit as a document: what came out, where the energy went, and what it did to the bat."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any

from sweetspot.analysis.bat_analysis import exit_speed_of
from sweetspot.analysis.strain import Damage
from sweetspot.collision.closed_form import bbcor
from sweetspot.collision.impact import Impact
from sweetspot.dynamics.rigid import RigidBody
from sweetspot.equipment.implement import Implement
from sweetspot.equipment.sport import Words
from sweetspot.motion.swing import Conditions
from sweetspot.numerics.confidence import REACH
from sweetspot.report.bat.assumed_values import soft_note
from sweetspot.report.document import Block, Cell, Column, Document, Paragraph, Picture, Table
from sweetspot.report.hit.json import damage_json, hit_json, impact_json
from sweetspot.report.hit.ledger import ENERGY_NAMES
from sweetspot.report.hit.second_touch import touched_again
from sweetspot.report.sentences import Sentence, Slot, read, say
from sweetspot.report.sport_words import in_words, reader_of, weight, words_of

Rows = list[tuple[Cell, Cell]]
FEW_JOULES, FEW_NEWTONS = 20.0, 5e3
"""Below these a number is shown with more digits."""
TOLD = 1e-3
"""A part of the energy below which what a sum misses is rounding."""


@dataclass(frozen=True)
class BattedHit:
    """A collision with everything that was put in; ``damage`` is known of bats only.

    Parameters
    ----------
    error : standard deviation in m/s that the ball alone leaves to the exit speed; None: not known, or told elsewhere.
    """

    implement: Implement
    body: RigidBody
    conditions: Conditions
    impact: Impact
    damage: Damage | None = None
    error: float | None = None


def hit_document(hit: BattedHit) -> Document:
    """Return a hit as a document."""
    words, impact = words_of(hit.implement), hit.impact
    from_tip = Slot(hit.implement.length - impact.position, "place")
    place = in_words("hit {place} from the {tip}", words, place=from_tip)
    picture = hit_picture(impact, words, title=say("{name}, {place}", name=hit.implement.name, place=place))
    data = hit_json(impact, body=hit.body, conditions=hit.conditions)
    if hit.damage is not None:
        data["damage"] = damage_json(hit.damage)
    if hit.error is not None:
        data["exit_speed_half_by_ball_m_s"] = REACH * hit.error
    if impact.unrecovered is not None:
        data["exit_speed_unrecovered_m_s"] = exit_speed_of(impact.unrecovered, hit.conditions)
    return Document(
        name="hit", title=hit.implement.name, kind="Hit",
        subtitle=place,
        blocks=[hit_table(hit), *map(Paragraph, by_ball(hit.error, words)), *_doubts(impact, words),
                *_damage_blocks(hit.damage, words), *soft_note(hit.implement, hit.conditions.ball), picture], data=data,
        rows=data["history"], reader=reader_of(hit.implement), drawing=picture,
    )  # fmt: skip


def by_ball(error: float | None, words: Words) -> list[Sentence]:
    """Return in words what the ball alone leaves open of an exit speed; nothing where that is not known.

    Parameters
    ----------
    error : standard deviation, m/s.
    """
    if error is None:
        return []
    half = Slot(REACH * error, "speed_change", 1)
    return [in_words("By the {ball} alone the {exit_speed} may be {half} more or less (90 %).", words, half=half)]


def _doubts(impact: Impact, words: Words) -> list[Paragraph]:
    return [Paragraph(doubt, "warning") for doubt in touched_again(impact, words)]


def impact_document(impact: Impact) -> Document:
    """Return a collision alone as a document: nobody says here whose it is, or how fast the bat was swung."""
    data, words = impact_json(impact), Words()
    title = say("Hit {place} from the end of the grip", place=Slot(impact.position, "place"))
    picture = hit_picture(impact, words, title=title)
    rows: Rows = [
        ("closing speed", Slot(impact.closing_speed, "speed")),
        ("collision efficiency q", Slot(impact.collision_efficiency, "ratio", 4)),
        *_contact_rows(impact, words), *_energy_rows(impact, words),
    ]  # fmt: skip
    return Document(
        name="hit", title=title, kind="Hit",
        blocks=[_two_columns(rows), *_doubts(impact, words), picture], data=data, rows=data["history"],
        drawing=picture,
    )  # fmt: skip


def hit_table(hit: BattedHit, title: str | Sentence = "", *, at: str = "") -> Table:
    """Return one hit in the words of its sport.

    Parameters
    ----------
    at : what its numbers' names begin with in the document's data.
    """
    impact, conditions, words = hit.impact, hit.conditions, words_of(hit.implement)
    leaves, swung = exit_speed_of(impact, conditions), conditions.swing.speed_at(impact.position)
    restitution = bbcor(impact.collision_efficiency, body=hit.body, ball=conditions.ball, position=impact.position)
    rows: Rows = [
        ("outcome", impact.outcome.sentence.replace(" bat ", f" {words.implement} ")),
        (f"{words.implement} speed there", Slot(swung, "speed", of=f"{at}bat_speed_m_s")),
        (words.exit_speed, Slot(leaves, "speed", of=f"{at}exit_speed_m_s")),
        (words.efficiency, Slot(impact.collision_efficiency, "ratio", 4, of=f"{at}collision_efficiency")),
    ]
    if words.smash_factor and swung:
        rows.append((words.smash_factor, Slot(leaves / swung, "ratio", of=f"{at}smash_factor")))
    if hit.implement.face is None:
        rows.append(("BBCOR at this speed", Slot(restitution, "ratio", of=f"{at}bbcor")))
    rows += [*_contact_rows(impact, words, at), *_energy_rows(impact, words, at)]
    masses = in_words(
        "{implement} {tool}, {ball} {thrown}", words, tool=Slot(hit.body.mass, "mass", of="bat.mass_kg"),
        thrown=weight(conditions.ball.mass, "conditions.ball_mass_kg"),
    )  # fmt: skip
    return _two_columns([*rows, ("masses", masses)], title)


def hit_picture(impact: Impact, words: Words, caption: str | Sentence = "", *, title: str | Sentence = "") -> Picture:
    """Return force and energy of a hit, drawn.

    Parameters
    ----------
    title : over the picture where it is a file of its own.
    """
    heat = impact.energy.heat / impact.energy.incoming if impact.energy.incoming else 0.0
    label = in_words(
        "Force of the hit: it rises to {force} and lasts {time}. Of the energy, {heat} become heat in the {ball}.",
        words, force=_force(impact.peak_force), time=Slot(impact.contact_time, "contact", 2), heat=Slot(heat, "share"),
    )  # fmt: skip
    return Picture("hit", lambda reading: _drawn(impact, words, read(title, reading)), label, caption)


def _drawn(impact: Impact, words: Words, title: str) -> Any:
    from sweetspot.report.hit.picture import hit_figure

    return hit_figure(impact, words, title)


def _contact_rows(impact: Impact, words: Words, at: str = "") -> Rows:
    pressed = Slot(impact.peak_compression, "pressed", of=f"{at}peak_compression_m")
    return [
        ("contact, force above 1 % of its peak", Slot(impact.contact_time, "contact", of=f"{at}contact_time_s")),
        ("peak force", replace(_force(impact.peak_force), of=f"{at}peak_force_n")),
        (in_words("peak compression of the {ball}", words), pressed),
    ]


def _energy_rows(impact: Impact, words: Words, at: str = "") -> Rows:
    """Return the ledger; a part that the implement does not have is left out."""
    energy = impact.energy
    digits = 1 if energy.incoming > FEW_JOULES else 3
    rows: Rows = []
    for field, (name, _) in ENERGY_NAMES.items():
        joules = getattr(energy, field)
        if not joules and field in ("face", "hoop"):
            continue
        part = Slot(joules / energy.incoming if energy.incoming else 0.0, "share", 1, of=f"{at}energy_share.{field}")
        size = say("{joules}, {part}", joules=Slot(joules, "energy", digits, of=f"{at}energy_j.{field}"), part=part)
        rows.append((in_words(f"energy: {name}", words), size))
    missed = abs(energy.imbalance)
    told = say("less than {part}", part=Slot(TOLD, "share", 1)) if missed < TOLD else Slot(missed, "share", 1)
    return [*rows, ("energy: what the sum misses", told)]


def _damage_blocks(damage: Damage | None, words: Words) -> list[Block]:
    """Return the strains of one hit in words, with a warning for each limit that is passed."""
    if damage is None:
        return []
    text = in_words(
        "Greatest bending strain of the handle {strain}, {place} from the {butt}", words,
        strain=Slot(damage.handle_strain, "strain"), place=Slot(damage.handle_position, "place"),
    )  # fmt: skip
    if damage.wall_strain is not None:
        text += say("; of the barrel's wall {strain}", strain=Slot(damage.wall_strain, "strain"))
    limit = damage.strain_limit
    if limit is not None and damage.handle_strain > limit and not damage.warnings:
        text += say(
            ". In a slow test its wood reaches its strength at {limit}; in a blow it bears two or three times as much",
            limit=Slot(limit, "strain"),
        )  # fmt: skip
    return [Paragraph(text + "."), *(Paragraph(f"Warning: {words}", "warning") for words in damage.warnings)]


def _force(force: float) -> Slot:
    return Slot(force, "blow", None if force > FEW_NEWTONS else 3)


def _two_columns(rows: Sequence[tuple[Cell, Cell]], title: str | Sentence = "") -> Table:
    return Table(title, [Column(""), Column("value", right=True)], rows)

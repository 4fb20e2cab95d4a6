"""Lead that makes one racket feel like another: where, and how much."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import astuple, dataclass
from typing import Annotated

import numpy as np

from sweetspot.answers.answer import Answer
from sweetspot.answers.records import INTERNAL, Length, Mass, MomentOfInertia
from sweetspot.catalog.files.write import implement_toml, legible
from sweetspot.catalog.swing_laws import swing_weight
from sweetspot.dynamics.beam import beam_model
from sweetspot.dynamics.rigid import RigidBody, rigid_body
from sweetspot.equipment.face import FaceOutline
from sweetspot.equipment.implement import AddedMass, Implement
from sweetspot.errors import InputError
from sweetspot.units import format_length

SPACING = 0.01
"""m between places that are tried where none are given."""
SCALES = (1e-4, 1e-3, 1e-4, 1e-5)
"""kg, m, kg m^2, kg m^2: what scale, balance board and swing-weight machine tell apart, 0.1 g, 1 mm, 1 and 0.1 kg cm^2
[our choice]; a target within that is reached."""
DIGITS = 9
"""Of the numbers in its file."""
LEAST = 1e-5
"""kg; a piece below that is none."""


@dataclass(frozen=True)
class MatchQuestion:
    """A racket that shall feel like another.

    ``places``: m from the butt end where lead may go; none: anywhere on it. Within the face it goes on both sides of
    the frame, else on the line.
    """

    implement: Implement
    target: Implement
    places: Sequence[float] = ()


@dataclass(frozen=True)
class Lead:
    """Lead in one place: ``mass`` in all, half of it ``lateral`` m to either side, or all of it on the line (0)."""

    position: Length
    lateral: Length
    mass: Mass


@dataclass(frozen=True)
class Feel:
    """What is matched: swing weight about the sport's axis, twist weight about the line."""

    mass: Mass
    balance_point: Length
    swing_weight: MomentOfInertia
    twist_weight: MomentOfInertia


@dataclass(frozen=True, kw_only=True)
class MatchAnswer(Answer):
    """Where lead goes on a racket, and what it then has.

    Parameters
    ----------
    lead : by place, from the butt end on; nothing where none helps.
    before, after, target : of the racket, of it with the lead, and of the one that it shall feel like.
    reached : whether all four are met to what a shop's scales tell apart; lead only adds, so not every pair can be.
    leaded : the racket with the lead.
    """

    question: Annotated[MatchQuestion, INTERNAL]
    lead: tuple[Lead, ...]
    before: Feel
    after: Feel
    target: Feel
    reached: bool
    leaded: Annotated[Implement, INTERNAL]

    def to_toml(self) -> str:
        """Return the racket with the lead as a file."""
        return legible(implement_toml(self.leaded), digits=DIGITS)


def match_answer(question: MatchQuestion) -> MatchAnswer:
    """Return the lead on a racket that comes nearest to another in mass, balance, swing weight and twist weight.

    With masses m_i >= 0 at z_i, y_i, all four are linear: sum m = M' - M; sum m (z - B') = M (B' - B);
    sum m (z - a)^2 = I' - I; sum m y^2 = T' - T. A linear program makes the sum of what is missed least, each in units
    of `SCALES`; its corners have no more places than targets.

    Raises
    ------
    InputError
        for implements of two sports or without a face, and places that are not on it.
    """
    from scipy.optimize import linprog

    implement, target = question.implement, question.target
    face, axis = _face_of(implement, target), swing_weight(implement.sport).axis
    body, wanted = (rigid_body(beam_model(each)) for each in (implement, target))
    place = _places(question, implement)
    on_frame = (place >= face.start) & (place <= implement.length)
    lateral = np.where(on_frame, implement.width_at(place) / 2, 0.0)
    rows = np.array([np.ones_like(place), place - wanted.balance_point, (place - axis) ** 2, lateral**2])
    missing = np.array(
        [
            wanted.mass - body.mass,
            body.mass * (wanted.balance_point - body.balance_point),
            wanted.moi(axis) - body.moi(axis),
            wanted.roll_moi - body.roll_moi,
        ]
    )
    units = np.array(SCALES) * [1, wanted.mass, 1, 1]
    rows, missing = rows / units[:, None], missing / units
    slack = np.eye(len(units))
    found = linprog(
        np.concatenate([np.zeros(len(place)), np.ones(2 * len(units))]),
        A_eq=np.hstack([rows, slack, -slack]),
        b_eq=missing,
        bounds=(0, None),
        method="highs",
    )
    assert found.x is not None, "whatever is missed has its slack"
    masses = np.maximum(found.x[: len(place)], 0.0)
    exact = [Lead(*map(float, each)) for each in zip(place, lateral, masses, strict=True) if each[2] > LEAST]
    aim = _feel(wanted, axis)
    for lead in (exact if question.places else _joined(exact, implement), exact):
        added = (*implement.added, *_weights(lead))
        leaded = implement.replaced(name=f"{implement.name}, leaded", added=added, original=implement)
        after = _feel(rigid_body(beam_model(leaded)), axis)
        if reached := _same(after, aim):
            break
    return MatchAnswer(
        question=question,
        lead=tuple(lead),
        before=_feel(body, axis),
        after=after,
        target=aim,
        reached=reached,
        leaded=leaded,
    )


def _joined(lead: Sequence[Lead], implement: Implement) -> list[Lead]:
    """Return pieces that touch as one, at their center of mass."""
    pieces: list[Lead] = []
    for piece in lead:
        last = pieces[-1] if pieces else None
        if last is None or float(piece.position) - float(last.position) > 1.5 * SPACING or not last.lateral:
            pieces.append(piece)
            continue
        mass = float(last.mass) + float(piece.mass)
        place = (float(last.position) * float(last.mass) + float(piece.position) * float(piece.mass)) / mass
        pieces[-1] = Lead(place, float(implement.width_at(place)) / 2, mass)
    return pieces


def _same(feel: Feel, target: Feel) -> bool:
    """Return whether all four numbers are alike to `SCALES`."""
    numbers = zip(astuple(feel), astuple(target), SCALES, strict=True)
    return all(abs(ours - theirs) <= unit for ours, theirs, unit in numbers)


def _face_of(implement: Implement, target: Implement) -> FaceOutline:
    """Return the face of a racket; refuse a pair that cannot be matched."""
    if implement.sport != target.sport:
        raise InputError(
            f"{implement.name} is for {implement.sport} and {target.name} for {target.sport}; match two of one sport"
        )
    if implement.outline is None:
        raise InputError(f"{implement.name} is round and has no twist weight to match; give two rackets")
    return implement.outline


def _places(question: MatchQuestion, implement: Implement) -> np.ndarray[tuple[int], np.dtype[np.float64]]:
    """Return the places where lead may go, m from the butt end."""
    if not question.places:
        return np.arange(SPACING, implement.length, SPACING)
    for place in question.places:
        if not 0 <= place <= implement.length:
            raise InputError(
                f"a place for lead is {format_length(place)} from the butt, off {implement.name}, which is "
                f"{format_length(implement.length)} long"
            )
    return np.array(sorted(set(question.places)), dtype=np.float64)


def _weights(lead: Sequence[Lead]) -> list[AddedMass]:
    """Return the pieces of lead as weights on an implement."""
    return [
        AddedMass(position=float(piece.position), mass=float(piece.mass) / len(sides), lateral=side)
        for piece in lead
        for sides in [(float(piece.lateral), -float(piece.lateral)) if piece.lateral else (0.0,)]
        for side in sides
    ]


def _feel(body: RigidBody, axis: float) -> Feel:
    return Feel(body.mass, body.balance_point, body.moi(axis), body.roll_moi)

"""Whether a golf club keeps the rules: its face by the pendulum and by a ball, and every rule held against it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from math import hypot, sqrt
from typing import Annotated

from sweetspot.analysis.certification.rules import Finding, League, Verdict, check_rules
from sweetspot.analysis.certification.simulated_club_test import TEST_SPEED, head_restitution
from sweetspot.answers.answer import Answer
from sweetspot.answers.certify import RuleCheck, rule_check
from sweetspot.answers.conditions import MassProperties, mass_properties
from sweetspot.answers.records import INTERNAL, MomentOfInertia, Ratio, Speed, Time
from sweetspot.dynamics.beam import beam_model
from sweetspot.dynamics.rigid import rigid_body
from sweetspot.equipment.ball import Ball
from sweetspot.equipment.golf_club import ClubHead, GolfClub
from sweetspot.numerics.interval import Interval, Number, chance_above
from sweetspot.units.dimensions import STIFFNESS

STIFFNESS_HALF = 0.29
"""Half of the 90 % interval of a face's stiffness, as a part of it, where no pendulum read it: 4 of 14 MN/m of the
catalogue's driver, whose faces have restitutions from 0.81 to 0.84."""
FACE_MASS_HALF = 0.5
"""The same of the mass that moves with the ball: 3 of 6 g, for it was guessed (assumed)."""
READ_HALF = 0.02
"""The same of a time that a pendulum read: about 5 of 239 us (assumed)."""


@dataclass(frozen=True, kw_only=True)
class TestedClub:
    """The face of a club.

    Parameters
    ----------
    characteristic_time : of the pendulum; ``read``: whether it was measured, and not computed from the face.
    face_stiffness : that it stands for.
    cor : restitution of a ball fired at the bare head at ``speed``.
    head_moi : about the vertical.
    """

    characteristic_time: Time
    read: bool
    face_stiffness: Annotated[Number | None, STIFFNESS]
    cor: Ratio
    speed: Speed
    head_moi: MomentOfInertia


@dataclass(frozen=True, kw_only=True)
class CertifyClubAnswer(Answer):
    """A club, the tests of its face, and every rule held against it; ``passed``: whether none is surely broken."""

    club: MassProperties
    ball: str
    test: TestedClub
    checks: tuple[RuleCheck, ...]
    passed: bool
    implement: Annotated[GolfClub, INTERNAL]


@dataclass(frozen=True)
class CertifyClubQuestion:
    """A club whose rules are asked for, and the ball that is fired at its head."""

    club: GolfClub
    leagues: Sequence[League]
    ball: Ball


def certify_club_answer(question: CertifyClubQuestion) -> CertifyClubAnswer:
    """Return the tests of a club's face and every rule of some associations held against it."""
    club, ball = question.club, question.ball
    head = club.head
    time, cor = _time(head), _restitution(head, ball)
    read = head.characteristic_time is not None  # then it is the test itself, whose tolerance the limit has
    findings = {
        "characteristic_time": Finding(time.value, interval=None if read else (time.low, time.high)),
        "cor": Finding(cor.value, interval=(cor.low, cor.high)),
        "head_moi": Finding(head.roll_moi),
    }
    checks = tuple(
        rule_check(league, check) if read else _with_chance(rule_check(league, check), time)
        for league in question.leagues
        for check in check_rules(league, bat=club, findings=findings)
    )
    verdicts = {check.quantity: check.outcome.verdict for check in checks}
    return CertifyClubAnswer(
        club=mass_properties(club, rigid_body(beam_model(club))),
        ball=ball.name,
        test=TestedClub(
            characteristic_time=time,
            read=read,
            face_stiffness=head.face.stiffness,
            cor=cor,
            speed=TEST_SPEED,
            head_moi=head.roll_moi,
        ),
        checks=checks,
        passed=Verdict.FAIL not in verdicts.values()
        and (not checks or verdicts.get("characteristic_time") is Verdict.PASS),
        implement=club,
    )


def _time(head: ClubHead) -> Interval:
    """Return the characteristic time, with what reading it or the stiffness of the face leaves open."""
    time = head.contact_of_pendulum
    if head.characteristic_time is not None:
        return Interval(time, time * (1 - READ_HALF), time * (1 + READ_HALF))
    return Interval(time, time / sqrt(1 + STIFFNESS_HALF), time / sqrt(1 - STIFFNESS_HALF))


def _restitution(head: ClubHead, ball: Ball) -> Interval:
    """Return the restitution with what ball and face leave open: each moved to its ends, as independent."""
    value = head_restitution(head, ball)
    half = 0.0 if ball.spread is None else ball.spread.restitution
    by_ball = [
        head_restitution(head, ball.with_restitution(min(ball.restitution.reference + sign * half, 1.0)))
        for sign in (-1, 1)
    ]
    moved = [by_ball]
    if head.face.stiffness is not None and head.face.moving_mass is not None:
        open_by = 2 * READ_HALF if head.characteristic_time is not None else STIFFNESS_HALF
        for name, part in (("stiffness", open_by), ("moving_mass", FACE_MASS_HALF)):
            usual = getattr(head.face, name)
            faces = [head.face.replaced(**{name: usual * (1 + sign * part)}) for sign in (-1, 1)]
            moved.append([head_restitution(head.replaced(face=face), ball) for face in faces])
    below = [max(0.0, value - min(ends)) for ends in moved]
    above = [max(0.0, max(ends) - value) for ends in moved]
    return Interval(value, value - hypot(*below), value + hypot(*above))


def _with_chance(check: RuleCheck, time: Interval) -> RuleCheck:
    """Return the check on the characteristic time with the probability that it is kept."""
    most = check.outcome.rule.most
    if check.quantity != "characteristic_time" or most is None:
        return check
    return replace(check, passes_probability=1 - chance_above(most, time))

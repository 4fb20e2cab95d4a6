"""Whether a paddle keeps its associations' rules: its test, simulated or measured, and what the clamp does to it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from math import hypot
from statistics import fmean
from typing import Annotated

import numpy as np

from sweetspot.analysis.certification.rules import Check, Finding, League, Verdict, check_rules
from sweetspot.analysis.certification.shot_statistics import SAME_PLACE, Estimate, estimate
from sweetspot.analysis.certification.shots import Shot, Shots, by_place
from sweetspot.analysis.certification.simulated_paddle_test import (
    PaddleTest,
    effective_mass_in,
    paddle_restitution,
    paddle_test,
)
from sweetspot.answers.answer import Answer
from sweetspot.answers.certify import RuleCheck, rule_check
from sweetspot.answers.conditions import MassProperties, mass_properties
from sweetspot.answers.records import INTERNAL, Length, Mass, MomentOfInertia, Ratio, Speed, Time
from sweetspot.dynamics.beam import beam_model
from sweetspot.dynamics.paddle_modes import DEFLECTED, Clamp, face_stiffness
from sweetspot.dynamics.rigid import RigidBody, rigid_body
from sweetspot.equipment.ball import Ball
from sweetspot.equipment.paddle import Paddle
from sweetspot.numerics.interval import Interval, chance_above
from sweetspot.tables.cells import BadRow
from sweetspot.units import INCH, MPH

TEST_SPEED = 60 * MPH
"""m/s, of the ball in the test of USA Pickleball [coretek_test]."""
HEAVY_CLAMP = 33e-4
"""kg m^2, the clamp of USA Pickleball's test [technicalpickleball_clamp]."""
OTHER_CLAMPS = (0.0, 5e-4, 12.15e-4, HEAVY_CLAMP)
"""kg m^2: an axle alone, a light clamp [our choice], that of another laboratory [kewcor], the association's."""
CLAMP_AXIS = 2 * INCH
"""m from the butt end [kewcor]."""
CLAMP_REACH = 0.09
"""m from the butt end, to where the clamp holds the handle (assumed)."""
FAR_FROM_CLAMP = (3 * INCH, 5 * INCH)
"""m from the tip, where the ball has left before the wave is back [technicalpickleball_clamp]."""
CORE_HALF = 0.25
"""Half of the 90 % interval of a core's shear modulus, as a part of it: two grades of one maker have 5 and 9 MPa
[nidaplast]."""
SPEED_STEP = 0.1
"""Part of the speed by which the slope of the restitution with speed is taken."""


@dataclass(frozen=True)
class PaddleScan:
    """One place of the test: restitution, rebound, time of contact, and when the clamp's wave is back."""

    position_from_tip: Length
    pbcor: Ratio
    rebound_speed: Speed
    contact_time: Time
    wave_time: Time


@dataclass(frozen=True, kw_only=True)
class TestedPaddle:
    """The test at its best place; see `PaddleTest`.

    Parameters
    ----------
    pbcor : greatest over the face, with the 90 % interval that ball and core leave open.
    pef : greatest restitution with the paddle's own moment of inertia alone.
    """

    pbcor: Ratio
    pef: Ratio
    position_from_tip: Length
    rebound_speed: Speed
    speed: Speed
    effective_mass: Mass
    clamp_inertia: MomentOfInertia
    scan: tuple[PaddleScan, ...]


@dataclass(frozen=True)
class OtherClamp:
    """What another clamp would have said of the same paddle.

    ``rebound_change``: of the rebound 3 to 5 in from the tip, the greatest, as a part of it.
    """

    clamp_inertia: MomentOfInertia
    pbcor: Ratio
    position_from_tip: Length
    rebound_speed: Speed
    rebound_change: Ratio


@dataclass(frozen=True)
class PlaceOfShots:
    """Mean restitution of the shots at one place."""

    position_from_tip: Length
    count: int
    pbcor: Ratio


@dataclass(frozen=True, kw_only=True)
class PaddleShots:
    """What measured shots say.

    Parameters
    ----------
    pbcor : at the best place, brought to the test's speed.
    speed_slope : of the restitution, by which they were brought there, per m/s.
    """

    pbcor: Estimate
    position_from_tip: Length
    places: tuple[PlaceOfShots, ...]
    speed_slope: float
    good_rows: int
    bad_rows: tuple[BadRow, ...]


@dataclass(frozen=True, kw_only=True)
class CertifyPaddleAnswer(Answer):
    """A paddle, its test, other clamps, and every rule held against it.

    ``passed``: whether no rule is broken and that on the paddle-ball restitution is kept, where there is one.
    """

    paddle: MassProperties
    ball: str
    test: TestedPaddle
    shots: PaddleShots | None = None
    clamps: tuple[OtherClamp, ...]
    checks: tuple[RuleCheck, ...]
    passed: bool
    implement: Annotated[Paddle, INTERNAL]
    result: Annotated[PaddleTest, INTERNAL]

    @property
    def failed(self) -> list[RuleCheck]:
        """The rules that the paddle breaks."""
        return [check for check in self.checks if check.outcome.verdict is Verdict.FAIL]


@dataclass(frozen=True)
class CertifyPaddleQuestion:
    """A paddle test that is asked for.

    Parameters
    ----------
    speed : m/s of the ball. clamp_inertia : kg m^2 of the clamp.
    shots : measured ones; None: the test is computed alone.
    """

    paddle: Paddle
    leagues: Sequence[League]
    ball: Ball
    speed: float = TEST_SPEED
    clamp_inertia: float = HEAVY_CLAMP
    shots: Shots | None = None


def certify_paddle_answer(question: CertifyPaddleQuestion) -> CertifyPaddleAnswer:
    """Return a paddle's test and every rule of some associations held against it.

    Raises
    ------
    InputError
        for a paddle whose handle is too short for the clamp.
    """
    paddle, ball = question.paddle, question.ball
    body = rigid_body(beam_model(paddle))
    test = _tested(paddle, ball, question.speed, question.clamp_inertia)
    interval = restitution_interval(test)
    bare = Clamp(axis=CLAMP_AXIS, reach=CLAMP_REACH, moi=0.0)
    alone = paddle_restitution(
        test.rebound, ball_mass=ball.mass, effective_mass=effective_mass_in(bare, body, test.position)
    )
    shots = None if question.shots is None else _measured(question.shots, test, body)
    measured = None if shots is None else shots.pbcor
    findings = _findings(paddle, interval, measured, float(np.nanmax(alone)))
    checks = tuple(
        _with_chance(rule_check(league, check), interval, measured)
        for league in question.leagues
        for check in check_rules(league, bat=paddle, findings=findings)
    )
    return CertifyPaddleAnswer(
        paddle=mass_properties(paddle, body),
        ball=ball.name,
        test=TestedPaddle(
            pbcor=interval,
            pef=float(np.nanmax(alone)),
            position_from_tip=paddle.length - test.best_position,
            rebound_speed=test.best_rebound * test.speed,
            speed=test.speed,
            effective_mass=test.best_effective_mass,
            clamp_inertia=test.clamp.moi,
            scan=_scan(test),
        ),
        shots=shots,
        clamps=tuple(_other(test, moi) for moi in OTHER_CLAMPS if abs(moi - test.clamp.moi) > 1e-9),
        checks=checks,
        passed=_passed(checks),
        implement=paddle,
        result=test,
    )


def tested_as_by_the_rules(paddle: Paddle, ball: Ball) -> PaddleTest:
    """Return the test of a paddle at the speed and in the clamp of USA Pickleball."""
    return _tested(paddle, ball, TEST_SPEED, HEAVY_CLAMP)


def _tested(paddle: Paddle, ball: Ball, speed: float, moi: float) -> PaddleTest:
    clamp = Clamp(axis=CLAMP_AXIS, reach=CLAMP_REACH, moi=moi)
    return paddle_test(paddle, ball=ball, speed=speed, clamp=clamp)


def restitution_interval(test: PaddleTest) -> Interval:
    """Return the greatest restitution with what ball and core leave open: each moved to its ends, as independent."""
    paddle, ball, best = test.paddle, test.ball, test.best_pbcor
    half = 0.0 if ball.spread is None else ball.spread.restitution
    ends = []
    for sign in (-1.0, 1.0):
        other = ball.with_restitution(min(ball.restitution.reference + sign * half, 1.0))
        by_ball = _tested(paddle, other, test.speed, test.clamp.moi).best_pbcor - best
        softer = paddle.replaced(core_shear=paddle.core_shear * (1 - sign * CORE_HALF))
        ends.append(hypot(by_ball, _tested(softer, ball, test.speed, test.clamp.moi).best_pbcor - best))
    return Interval(best, best - ends[0], best + ends[1])


def _scan(test: PaddleTest) -> tuple[PaddleScan, ...]:
    rows = zip(test.position, test.pbcor, test.rebound, test.contact_time, test.wave_time, strict=True)
    return tuple(
        PaddleScan(
            float(test.paddle.length - place), float(pbcor), float(back * test.speed), float(contact), float(wave)
        )
        for place, pbcor, back, contact, wave in rows
    )


def _other(test: PaddleTest, moi: float) -> OtherClamp:
    """Return the test in a clamp of another moment of inertia."""
    other = _tested(test.paddle, test.ball, test.speed, moi)
    from_tip = test.paddle.length - test.position
    far = (from_tip >= FAR_FROM_CLAMP[0] - 1e-9) & (from_tip <= FAR_FROM_CLAMP[1] + 1e-9)
    change = other.rebound[far] / test.rebound[far] - 1
    return OtherClamp(
        clamp_inertia=moi,
        pbcor=other.best_pbcor,
        position_from_tip=test.paddle.length - other.best_position,
        rebound_speed=other.best_rebound * test.speed,
        rebound_change=float(change[int(np.argmax(np.abs(change)))]),
    )


def _measured(shots: Shots, test: PaddleTest, body: RigidBody) -> PaddleShots:
    """Return the restitution of measured shots, each brought to the speed of the test by the model's slope."""
    faster, slower = (
        _tested(test.paddle, test.ball, (1 + sign * SPEED_STEP) * test.speed, test.clamp.moi).best_pbcor
        for sign in (1, -1)
    )
    slope = (faster - slower) / (2 * SPEED_STEP * test.speed)

    def restitution(shot: Shot) -> float:
        mass = effective_mass_in(test.clamp, body, shot.position)
        ball_mass = test.ball.mass if shot.ball_mass is None else shot.ball_mass
        found = paddle_restitution(shot.collision_efficiency, ball_mass=ball_mass, effective_mass=mass)
        return found + slope * (test.speed - shot.closing_speed)

    groups = by_place(shots.shots, within=SAME_PLACE)
    means = [fmean(map(restitution, group)) for group in groups]
    best = int(np.argmax(means))
    places = [fmean(shot.position for shot in group) for group in groups]
    return PaddleShots(
        pbcor=estimate(map(restitution, groups[best])),
        position_from_tip=test.paddle.length - places[best],
        places=tuple(
            PlaceOfShots(test.paddle.length - place, len(group), mean)
            for place, group, mean in zip(places, groups, means, strict=True)
        ),
        speed_slope=slope,
        good_rows=len(shots.shots),
        bad_rows=tuple(shots.bad_rows),
    )


def _findings(paddle: Paddle, computed: Interval, measured: Estimate | None, pef: float) -> dict[str, Finding]:
    """Return the findings on the quantities of the rules; measured shots count before the model."""
    if measured is None:
        by = "what ball and core leave open"
        pbcor = Finding(computed.value, interval=(computed.low, computed.high), interval_is=by)
    else:
        pbcor = Finding(measured.mean, interval=(measured.low, measured.high))
    return {
        "pbcor": pbcor,
        "pef": Finding(pef),
        "length": Finding(paddle.length),
        "length_and_width": Finding(paddle.length + paddle.head_width),
        "deflection_force": Finding(face_stiffness(paddle) * DEFLECTED),
    }


def _with_chance(check: RuleCheck, computed: Interval, measured: Estimate | None) -> RuleCheck:
    """Return a check on the restitution with the probability that it is kept."""
    rule: Check = check.outcome
    if check.quantity != "pbcor" or rule.rule.most is None:
        return check
    if measured is None:
        return replace(check, passes_probability=1 - chance_above(rule.rule.most, computed))
    from scipy.special import stdtr

    apart = (rule.rule.most - measured.mean) / max(measured.standard_error, 1e-9)
    return replace(check, passes_probability=float(stdtr(measured.count - 1, apart)))


def _passed(checks: Sequence[RuleCheck]) -> bool:
    verdicts = [check.outcome.verdict for check in checks]
    lively = [check.outcome.verdict for check in checks if check.quantity == "pbcor"]
    decided = not checks or Verdict.PASS in (lively or verdicts)
    return Verdict.FAIL not in verdicts and decided

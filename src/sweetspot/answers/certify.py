"""Whether a bat keeps the rules: its test, simulated or measured, and every rule held against it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from typing import Annotated

from sweetspot.analysis.certification.passing_wall import MEASURES, wall_that_passes
from sweetspot.analysis.certification.rules import (
    PERFORMANCE,
    QUANTITIES,
    Check,
    League,
    Verdict,
    check_rules,
    construction_findings,
    title,
)
from sweetspot.analysis.certification.shot_statistics import ShotStatistics, measure
from sweetspot.analysis.certification.shots import Shots
from sweetspot.analysis.certification.simulated_test import BASEBALL_TEST, Certification, certify
from sweetspot.answers.answer import Answer, DrawnAnswer, Uncertainty, with_draws
from sweetspot.answers.bat_test import (
    MeasuredShots,
    SimulatedTest,
    chance_by_shots,
    chance_of_draws,
    drawn_margin,
    measured_shots,
    simulated_test,
)
from sweetspot.answers.conditions import MassProperties, mass_columns, mass_properties
from sweetspot.answers.records import INTERNAL, Columns, Length, Mass
from sweetspot.catalog.bats import wall_doubt
from sweetspot.catalog.standard_hit import standard_conditions
from sweetspot.dynamics.beam import beam_model
from sweetspot.dynamics.rigid import RigidBody, rigid_body
from sweetspot.equipment.ball import Ball
from sweetspot.equipment.bat import Bat
from sweetspot.errors import InputError
from sweetspot.numerics.interval import Interval, Number
from sweetspot.uncertainty.drawn_tests import DrawnTest, drawn_test, sources_of_test
from sweetspot.uncertainty.sources import DRAWS, Sources


@dataclass(frozen=True, kw_only=True)
class RuleCheck:
    """One rule held against a bat; value, limits and margin in ``unit``, SI.

    Parameters
    ----------
    league, league_name, quantity, title : whose rule, and what it limits: for programs and for people.
    sure : whether it is a pass or a fail that what is not known of the value cannot turn.
    margin : distance inside the nearer limit, negative outside.
    reason : why it is no plain pass or fail; "": it is.
    reading : how the source was read, see `Rule`.
    passes_probability : that the bat keeps the rule; None: it was not asked, or cannot be said.
    """

    league: str
    league_name: str
    quantity: str
    title: str
    verdict: str
    sure: bool
    value: Number | None
    least: float | None
    most: float | None
    margin: Number | None
    unit: str
    reason: str
    source: str
    where: str
    year: int | None
    reading: str
    passes_probability: float | None = None
    rules: Annotated[League, INTERNAL]
    outcome: Annotated[Check, INTERNAL]


@dataclass(frozen=True)
class WallThatPasses:
    """The barrel wall that just keeps a league's limit: how thick in the middle of the barrel, and the bat's mass."""

    league: str
    league_name: str
    measure: str
    limit: float
    factor: float
    thickness: Length
    mass: Mass


@dataclass(frozen=True)
class RuleChance:
    """How probable it is that a bat keeps a rule."""

    league: str
    quantity: str
    passes_probability: float


@dataclass(frozen=True, kw_only=True)
class TestedMeasure:
    """The one number that a test is made for: that of the first limit on liveliness, else the game's own.

    Parameters
    ----------
    value : with its 90 % interval, in ``unit``, SI.
    position_from_tip : where on the barrel it was found.
    """

    __test__ = False

    quantity: str
    value: Interval
    unit: str
    position_from_tip: Length


@dataclass(frozen=True, kw_only=True)
class CertifyAnswer(Answer):
    """A bat, its test, and every rule held against it.

    Parameters
    ----------
    ball : that was fired.
    measure : the one number that the test is made for.
    test, shots : the simulated test, or what measured shots say.
    passed : whether no rule is broken, one is kept, and the test decides the rules that it is made for.
    walls : the barrel wall that just keeps each limit; None: it was not asked.
    passes : the probabilities of ``checks``; None: there are none.
    uncertainty : of BBCOR, where draws were made.
    result, body : what the answer was read from.
    """

    bat: MassProperties
    ball: str
    measure: TestedMeasure
    test: SimulatedTest | None = None
    shots: MeasuredShots | None = None
    checks: tuple[RuleCheck, ...]
    passed: bool
    walls: tuple[WallThatPasses, ...] | None = None
    passes: tuple[RuleChance, ...] | None = None
    uncertainty: Uncertainty | None = None
    implement: Annotated[Bat, INTERNAL]
    fired: Annotated[Ball, INTERNAL]
    body: Annotated[RigidBody, INTERNAL]
    result: Annotated[Certification | ShotStatistics, INTERNAL]

    @property
    def failed(self) -> list[RuleCheck]:
        """The rules that the bat breaks."""
        return _failed(self.checks)

    @property
    def untested(self) -> list[RuleCheck]:
        """The rules on its liveliness, where this test decides none of them; empty: it decides one, or none applies."""
        return _untested(self.checks)

    @property
    def verdict(self) -> Verdict:
        """Pass, fail or not decidable for all rules together."""
        if self.failed:
            return Verdict.FAIL
        return Verdict.PASS if self.passed else Verdict.NOT_DECIDABLE

    @property
    def sure(self) -> bool:
        """Whether what is not known cannot turn pass into fail, or a fail into pass: one sure fail is enough."""
        if self.failed:
            return any(each.sure for each in self.failed)
        return all(check.sure for check in self.checks if check.outcome.decided)


def _failed(checks: Sequence[RuleCheck]) -> list[RuleCheck]:
    return [check for check in checks if check.outcome.verdict is Verdict.FAIL]


def _untested(checks: Sequence[RuleCheck]) -> list[RuleCheck]:
    asked = [
        check
        for check in checks
        if check.quantity in PERFORMANCE and check.outcome.verdict is not Verdict.NOT_APPLICABLE
    ]
    return [] if any(each.outcome.decided for each in asked) else asked


def _passed(checks: Sequence[RuleCheck]) -> bool:
    any_passed = any(check.outcome.verdict is Verdict.PASS for check in checks)
    return not _failed(checks) and not _untested(checks) and (any_passed or not checks)


@dataclass(frozen=True)
class CertifyQuestion:
    """A bat test that is asked for, and the rules to hold against it.

    Parameters
    ----------
    ball : that is fired.
    shots : measured ones; None: the test is simulated.
    standard_restitution : of the ball that measured shots are normalized to; None: the ball's own at 60 mph.
    passing_wall : whether the barrel wall is asked that just passes.
    sources : what is not known of a hit, for the chance that each rule is kept, and an interval beside each number of a
        simulated test; None: neither.
    draws : how many answers the intervals come from, a power of two.
    """

    bat: Bat
    leagues: Sequence[League]
    ball: Ball
    shots: Shots | None = None
    standard_restitution: float | None = None
    passing_wall: bool = False
    sources: Sources | None = None
    draws: int = field(default=DRAWS, kw_only=True)


def certify_answer(question: CertifyQuestion) -> CertifyAnswer:
    """Return a bat's test and every rule of some leagues held against it.

    Raises
    ------
    InputError
        for a bat that cannot be clamped, shots that do not go with it, or a wall that is asked of no limit.
    """
    bat, ball, shots = question.bat, question.ball, question.shots
    body = rigid_body(beam_model(bat))
    if shots is None:
        return certificate_of(question, body=body, test=certify(bat, ball=ball, wall_doubt=wall_doubt(bat)))
    measured = measure(
        shots.shots,
        bat=bat,
        body=body,
        ball=ball,
        standard_restitution=question.standard_restitution,
        unused=shots.bad_rows,
    )
    return certificate_of(question, body=body, test=measured)


def certificate_of(
    question: CertifyQuestion, *, body: RigidBody, test: Certification | ShotStatistics
) -> CertifyAnswer:
    """Return the answer to a question whose test is there already: what every answer says of rules.

    ``body``, ``test``: of the question's bat.
    """
    bat, ball, leagues, shots = question.bat, question.ball, question.leagues, question.shots
    findings = {**construction_findings(bat, body=body), **test.findings()}
    checks = tuple(
        rule_check(league, check) for league in leagues for check in check_rules(league, bat=bat, findings=findings)
    )
    simulated = simulated_test(test) if isinstance(test, Certification) else None
    plain = CertifyAnswer(
        bat=mass_properties(bat, body),
        ball=ball.name,
        measure=_measure(test, checks, length=bat.length),
        test=simulated,
        shots=measured_shots(test, shots) if isinstance(test, ShotStatistics) and shots is not None else None,
        checks=checks,
        passed=_passed(checks),
        walls=passing_walls(bat, leagues, ball=ball) if question.passing_wall else None,
        implement=bat,
        fired=ball,
        body=body,
        result=test,
    )
    if question.sources is None:
        return plain
    if isinstance(test, ShotStatistics):
        return _with_chances(plain, [chance_by_shots(each.outcome, test) for each in checks])
    asked, conditions = sources_of_test(question.sources), standard_conditions(bat).replaced(ball=ball)
    drawn = drawn_test(beam_model(bat), conditions, asked, test, count=question.draws)
    likely = _with_chances(plain, [chance_of_draws(each.outcome, drawn) for each in checks])
    return with_draws(likely, DrawnAnswer(drawn.draws.normal, _columns(checks, drawn)), asked, of="test.bbcor")


def _measure(test: Certification | ShotStatistics, checks: Sequence[RuleCheck], *, length: float) -> TestedMeasure:
    """Return the number of a test whose limit decides, or the game's own where there is no limit."""
    found = {name: each for name, each in test.findings().items() if each.value is not None}
    limited = [
        check.quantity
        for check in checks
        if check.quantity in PERFORMANCE and check.quantity in found and check.outcome.applies
    ]
    usual = "bbcor" if test.swung == BASEBALL_TEST or "bpf" not in found else "bpf"
    name = limited[0] if limited else usual
    value = float(found[name].value or 0.0)
    ends = found[name].interval or (value, value)
    scan = test if isinstance(test, ShotStatistics) else test.slow if name == "bpf" else test.fast
    return TestedMeasure(
        quantity=name,
        value=Interval(value, *ends),
        unit=QUANTITIES[name][1],
        position_from_tip=length - scan.best_position,
    )


def rule_check(league: League, check: Check) -> RuleCheck:
    """Return a rule held against a bat, with its league."""
    rule = check.rule
    return RuleCheck(
        league=league.key,
        league_name=league.name,
        quantity=rule.quantity,
        title=title(rule),
        verdict=check.verdict.value,
        sure=check.sure,
        value=check.value,
        least=rule.least,
        most=rule.most,
        margin=check.margin,
        unit=QUANTITIES[rule.quantity][1],
        reason=check.reason,
        source=rule.source,
        where=rule.where,
        year=rule.year,
        reading=rule.reading,
        rules=league,
        outcome=check,
    )


def passing_walls(bat: Bat, leagues: Sequence[League], *, ball: Ball) -> tuple[WallThatPasses, ...]:
    """Return the barrel wall that just keeps every league's limit on BBCOR or BPF.

    Raises
    ------
    InputError
        where no rule limits either, or the bat has no wall that keeps the limit.
    """
    limits = [(each, rule) for each in leagues for rule in each.rules if rule.quantity in MEASURES and rule.most]
    if not limits:
        raise InputError("no rule of this league limits BBCOR or BPF, so no wall can be asked for that passes")
    walls = []
    for league, rule in limits:
        assert rule.most is not None
        wall = wall_that_passes(bat, ball=ball, limit=rule.most, measure=rule.quantity)
        walls.append(
            WallThatPasses(league.key, league.name, wall.measure, wall.limit, wall.factor, wall.thickness, wall.mass)
        )
    return tuple(walls)


def _with_chances(answer: CertifyAnswer, chances: Sequence[float | None]) -> CertifyAnswer:
    """Return an answer whose checks have the probability that they are kept; None where it cannot be computed."""
    checks = tuple(
        replace(each, passes_probability=chance) for each, chance in zip(answer.checks, chances, strict=True)
    )
    passes = tuple(
        RuleChance(check.league, check.quantity, check.passes_probability)
        for check in checks
        if check.passes_probability is not None
    )
    return replace(answer, checks=checks, passes=passes or None)


def _columns(checks: Sequence[RuleCheck], drawn: DrawnTest) -> Columns:
    """Return the sampled answers, by the fields of `CertifyAnswer`."""
    ruled: list[Columns] = []
    for check in checks:
        answers = {"value": drawn.of_rule(check.quantity), "margin": drawn_margin(check.outcome, drawn)}
        ruled.append({name: column for name, column in answers.items() if column is not None})
    return {
        "bat": mass_columns(drawn.draws),
        "test": {
            "bbcor": drawn.bbcor,
            "collision_efficiency": drawn.collision_efficiency,
            "besr": drawn.besr,
            "bpf": drawn.bpf,
            "batted_ball_speed": drawn.batted_ball_speed,
            "best_position": drawn.best_position,
            "fast": {"best_position": drawn.best_position},
            "slow": {"best_position": drawn.slow_best_position},
        },
        "checks": ruled,
    }

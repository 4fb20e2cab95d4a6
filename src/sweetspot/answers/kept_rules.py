"""Whether a compared bat keeps the rules of its own sport."""

from __future__ import annotations

from dataclasses import dataclass

from sweetspot.answers.certify import CertifyAnswer, CertifyQuestion, certify_answer
from sweetspot.catalog.balls import ball
from sweetspot.catalog.rules import DEFAULT_LEAGUE, WOODEN_LEAGUE, league
from sweetspot.catalog.sports import sport
from sweetspot.equipment.bat import Bat
from sweetspot.numerics.interval import Number


@dataclass(frozen=True)
class DecidedRule:
    """A rule that is kept or broken; `RuleCheck` has its limits and its source."""

    league: str
    quantity: str
    verdict: str
    sure: bool
    value: Number | None
    unit: str


@dataclass(frozen=True)
class RulesKept:
    """Whether a bat keeps the rules of its own sport, and the rules behind that."""

    passed: bool
    verdict: str
    sure: bool
    checks: tuple[DecidedRule, ...]


def certificate_of_sport(bat: Bat) -> CertifyAnswer:
    """Return a bat held against the rules of its sport; a wooden one of baseball also against those of the majors."""
    of_sport = sport(bat.sport).rules or DEFAULT_LEAGUE
    names = [of_sport, WOODEN_LEAGUE] if of_sport == DEFAULT_LEAGUE and bat.material.family == "wood" else [of_sport]
    leagues = [league(name) for name in names]
    return certify_answer(CertifyQuestion(bat, leagues, ball(leagues[0].ball)))


def rules_kept(certificate: CertifyAnswer) -> RulesKept:
    """Return the rules that a certificate decides."""
    checks = tuple(
        DecidedRule(check.league, check.quantity, check.verdict, check.sure, check.value, check.unit)
        for check in certificate.checks
        if check.outcome.decided
    )
    return RulesKept(certificate.passed, certificate.verdict.value, certificate.sure, checks)

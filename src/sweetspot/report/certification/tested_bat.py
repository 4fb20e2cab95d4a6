"""A bat that was tested, and every rule that was held against it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from sweetspot.analysis.certification.passing_wall import PassingWall
from sweetspot.analysis.certification.rules import (
    PERFORMANCE,
    Check,
    League,
    Verdict,
    check_rules,
    construction_findings,
)
from sweetspot.analysis.certification.shot_statistics import Measured
from sweetspot.analysis.certification.shots import Shots
from sweetspot.analysis.certification.simulated_test import Certification
from sweetspot.analysis.certification.simulated_test import certify as simulate
from sweetspot.catalog.bats import wall_doubt
from sweetspot.dynamics.beam import beam_model
from sweetspot.dynamics.rigid import RigidBody, rigid_body
from sweetspot.equipment.ball import Ball
from sweetspot.equipment.bat import Bat


@dataclass(frozen=True)
class TestedBat:
    """A bat, how it was tested, and every rule held against it.

    Parameters
    ----------
    test : the simulated test, or what measured shots say.
    shots : the file of measured shots; None for a simulated test.
    checks : (league, rule held against the bat).
    walls : (league, the barrel wall that would just pass its limit), where that was asked.
    """

    bat: Bat
    ball: Ball
    body: RigidBody
    test: Certification | Measured
    shots: Shots | None = None
    checks: Sequence[tuple[League, Check]] = ()
    walls: Sequence[tuple[League, PassingWall]] = ()

    @property
    def failed(self) -> list[tuple[League, Check]]:
        """The rules that the bat breaks."""
        return [(league, check) for league, check in self.checks if check.verdict is Verdict.FAIL]

    @property
    def untested(self) -> list[tuple[League, Check]]:
        """The rules on its liveliness, where this test decides none of them; empty: it decides one, or none applies."""
        asked = [
            (league, check) for league, check in self.checks
            if check.rule.quantity in PERFORMANCE and check.verdict is not Verdict.NOT_APPLICABLE
        ]  # fmt: skip
        return [] if any(check.decided for _, check in asked) else asked

    @property
    def passed(self) -> bool:
        """Whether no rule is broken, one is kept, and the test decides the rules that it is made for."""
        kept = any(check.verdict is Verdict.PASS for _, check in self.checks)
        return not self.failed and not self.untested and (kept or not self.checks)

    @property
    def sure(self) -> bool:
        """Whether what is not known cannot turn pass into fail, or a fail into pass: one sure fail is enough."""
        if self.failed:
            return any(check.sure for _, check in self.failed)
        return all(check.sure for _, check in self.checks if check.decided)


def tested_by_model(bat: Bat, leagues: Sequence[League], *, ball: Ball) -> TestedBat:
    """Return a bat with its computed test and every rule of some leagues held against it.

    Parameters
    ----------
    ball : that the bat is tested with.
    """
    body, test = rigid_body(beam_model(bat)), simulate(bat, ball=ball, wall_doubt=wall_doubt(bat))
    return held_to_rules(bat, leagues, ball=ball, body=body, test=test)


def held_to_rules(
    bat: Bat,
    leagues: Sequence[League],
    *,
    ball: Ball,
    body: RigidBody,
    test: Certification | Measured,
    shots: Shots | None = None,
) -> TestedBat:
    """Return a bat with its test and every rule of some leagues held against it: what every answer says of rules.

    Parameters
    ----------
    shots : the file of measured shots; None: the test was simulated.
    """
    findings = {**construction_findings(bat, body=body), **test.findings()}
    checks = [(one, check) for one in leagues for check in check_rules(one, bat=bat, findings=findings)]
    return TestedBat(bat, ball, body, test, shots, checks)

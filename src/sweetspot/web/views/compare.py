"""Compare: up to four bats in one player's hands, what a hole or another wall changes, and what leagues say of them."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from functools import lru_cache
from typing import Annotated, Literal

import numpy as np
from markupsafe import escape

from sweetspot import catalog
from sweetspot.analysis.bat_analysis import Analysis
from sweetspot.analysis.certification.rules import League, Verdict
from sweetspot.analysis.certification.simulated_test import Certification, certify
from sweetspot.analysis.comparison import Comparison, compare, compare_reduced
from sweetspot.analysis.trampoline import wall_point_of
from sweetspot.answers.certify import CertifyQuestion, RuleCheck, certificate_of
from sweetspot.answers.changes import changed
from sweetspot.answers.compare import CompareAnswer, ComparedBat, ComparedCurves, SpeedWithEnds, compare_of
from sweetspot.answers.conditions import MassProperties
from sweetspot.answers.records import GAPS, Frequency, Length, MomentOfInertia, Ratio
from sweetspot.catalog.bats import wall_doubt
from sweetspot.catalog.standard_hit import standard_conditions
from sweetspot.catalog.swing_laws import swing_law
from sweetspot.dynamics.reduction import ReducedBat
from sweetspot.equipment.ball import Ball
from sweetspot.equipment.bat import Bat
from sweetspot.numerics.arrays import Array
from sweetspot.numerics.interval import Band, Curve
from sweetspot.reports.certification.limits_shown import league_limit, verdict_words
from sweetspot.reports.comparison.words import (
    assumed,
    assumptions,
    changes,
    cork_verdict,
    fastest_places,
    speed_changes,
    verdict,
    wall_verdict,
)
from sweetspot.reports.quantities import SYSTEMS
from sweetspot.reports.sentences import Sentence, say
from sweetspot.uncertainty.comparison_draws import Ends
from sweetspot.uncertainty.sources import Sources
from sweetspot.units.dimensions import SPEED, System
from sweetspot.web.bat_bounds import Range, bounds
from sweetspot.web.bats import ball_of, conditions_of, swung
from sweetspot.web.controls import BatState, part_of
from sweetspot.web.documents import ReadDocument, Sentences, in_both_systems, in_either_system, page_document
from sweetspot.web.drawings import BallPicture, BatPicture, BatShape, ball_picture, bat_picture, moi_half, outline
from sweetspot.web.errors import about
from sweetspot.web.how_sure import PAGE_DRAWS, sources_for
from sweetspot.web.recipes import Ask, bat_source, bat_text, is_catalogued, lines_of, swing_options
from sweetspot.web.view import View
from sweetspot.web.views.compare_state import (
    CompareState,
    bats_of,
    changes_of,
    controls_of,
    leagues_of,
    others_of,
)

ALONE = say("Choose another bat to compare this one with.")


@dataclass(frozen=True)
class WeighedBat(MassProperties):
    """Mass properties, with half the 90 % interval of the swing weight; 0: it was measured."""

    moi_6in_half: MomentOfInertia


@dataclass(frozen=True)
class ComparedCurvesInFull(ComparedCurves):
    """Exit speed, its change against the first bat's, and efficiencies along one bat."""

    change: Annotated[Curve, SPEED, GAPS]
    collision_efficiency: Curve
    bbcor: Curve


@dataclass(frozen=True)
class WallInBestHit:
    """The wall of a hollow bat in its best hit."""

    thickness: Length
    hoop_frequency: Frequency
    energy_share: Ratio
    restitution: Ratio


@dataclass(frozen=True, kw_only=True)
class DrawnComparedBat(ComparedBat):
    """One bat of the comparison with what is drawn of it; ``wall`` where another wall is asked about."""

    bat: WeighedBat
    scan: ComparedCurvesInFull
    shape: BatShape
    wall: WallInBestHit | None


@dataclass(frozen=True, kw_only=True)
class ComparisonPicture(CompareAnswer):
    """Bats beside each other, without intervals yet: `intervals` has them.

    Parameters
    ----------
    bat, ball : the first one, and what it meets.
    others_bounds : how far the controls of the others may go.
    verdict, assumptions : what changes, and what that rests on.
    fastest, changes : where each hits fastest, and the changes of exit speed, in a sentence each.
    """

    bats: tuple[DrawnComparedBat, ...]
    bat: BatPicture
    others_bounds: tuple[Mapping[str, Range], ...]
    ball: BallPicture
    verdict: Sentences
    assumptions: Sentences
    fastest: Sentences
    changes: Sentences


@dataclass(frozen=True, kw_only=True)
class SureBat:
    """The intervals of one bat's numbers; ``change_low`` and ``change_high`` are those of its curve."""

    bat_speed: SpeedWithEnds
    exit_speed: SpeedWithEnds
    change: SpeedWithEnds
    change_low: Annotated[Array | None, SPEED, GAPS] = None
    change_high: Annotated[Array | None, SPEED, GAPS] = None


@dataclass(frozen=True)
class SureComparison:
    """The intervals of all that is not known, and the verdict that they allow."""

    bats: tuple[SureBat, ...]
    verdict: Sentences
    assumptions: Sentences
    changes: Sentences


@dataclass(frozen=True)
class CertifiedBat:
    """The results of a bat in the league's simulated test, and the verdict by every rule."""

    label: str
    results: str
    ball: str
    checks: tuple[RuleCheck, ...]


@dataclass(frozen=True)
class BatVerdict:
    """The verdict of a rule on one bat, in words."""

    words: Mapping[System, str]
    reason: str
    mark: Literal["good", "bad", "muted", ""]


@dataclass(frozen=True)
class RuleRow:
    """One rule held against every bat; ``decided``: at least one of them keeps or breaks it."""

    title: str
    limit: Mapping[System, str]
    decided: bool
    verdicts: tuple[BatVerdict, ...]


@dataclass(frozen=True)
class CertifiedBats:
    """Every bat's simulated test, and every rule held against the bats."""

    certification: tuple[CertifiedBat, ...]
    rules: tuple[RuleRow, ...]


def answer(state: CompareState) -> ComparisonPicture:
    """Return curves and changes, in numbers and words; how sure they are comes apart, see `intervals`."""
    state = swung(state)
    ball = ball_of(state)
    leagues_of(state)  # a wrong name is refused at once, though the rules come later
    reductions, comparison = _compared(state, ball)
    plain = compare_of(comparison)
    words = changes(plain) or [ALONE]
    return ComparisonPicture(
        **vars(plain)
        | {
            "interval": "none here: /compare/intervals has them",
            "bats": tuple(
                _drawn(row, compared.analysis, wall=state.what_if == "wall")
                for row, compared in zip(plain.bats, comparison.compared, strict=True)
            ),
        },
        bat=bat_picture(state, reductions[0]),
        others_bounds=tuple(bounds(*pair) for pair in others_of(state, reductions)),
        ball=ball_picture(state, ball),
        verdict=in_both_systems(words + _of_wall(state, comparison)),
        assumptions=in_both_systems([assumptions(plain)]),
        fastest=in_both_systems([fastest_places(comparison)]),
        changes=in_both_systems([speed_changes(plain)]),
    )


def _drawn(row: ComparedBat, analysis: Analysis[Bat], *, wall: bool) -> DrawnComparedBat:
    scan = analysis.scan
    curves = {"collision_efficiency": scan.collision_efficiency, "bbcor": scan.bbcor}
    parts = {
        "bat": WeighedBat(**vars(row.bat), moi_6in_half=moi_half(analysis.bat, analysis.body)),
        "scan": ComparedCurvesInFull(**vars(row.scan), **curves),
        "shape": outline(analysis.bat),
        "wall": _wall(analysis) if wall else None,
    }
    return DrawnComparedBat(**vars(row) | parts)


def _wall(analysis: Analysis[Bat]) -> WallInBestHit:
    point = wall_point_of(analysis)
    return WallInBestHit(point.thickness, point.hoop_frequency, point.energy.share, point.energy.restitution)


def intervals(state: CompareState) -> SureComparison:
    """Return the intervals of all that is not known, and the verdict and what it assumes, as the command has them."""
    state = swung(state)
    _, comparison = _compared(state, ball_of(state))
    sure = compare_of(comparison, _sources(state, comparison), ends=_ends(state, comparison))
    words = (verdict(sure) or [ALONE]) + cork_verdict(sure)
    return SureComparison(
        tuple(map(_sure_bat, sure.bats)),
        in_both_systems(words + _of_wall(state, comparison)),
        in_both_systems([assumed(sure, draws="the fold below")]),
        in_both_systems([speed_changes(sure)]),
    )


def _sure_bat(bat: ComparedBat) -> SureBat:
    change = bat.scan.change
    low, high = (np.round(change.low, 4), np.round(change.high, 4)) if isinstance(change, Band) else (None, None)
    speeds = {"bat_speed": bat.bat_speed, "exit_speed": bat.exit_speed, "change": bat.change}
    return SureBat(**speeds, change_low=low, change_high=high)


def _sources(state: CompareState, comparison: Comparison[Bat]) -> list[Sources]:
    """Return the uncertain quantities, bat by bat."""
    controls = controls_of(state, len(comparison.compared))
    analyses = [compared.analysis for compared in comparison.compared]
    return [sources_for(each, entry.bat, entry.conditions) for each, entry in zip(controls, analyses, strict=True)]


def _ends(state: CompareState, comparison: Comparison[Bat]) -> Ends:
    """Return the changed bat at both ends of what cannot be known of its change, where that was asked."""
    first, ends = comparison.reference.analysis, {}
    for place, text in enumerate(changes_of(state), start=1):
        if both := changed(first.bat, text).ends:
            found = compare([first.bat, *both], conditions=first.conditions, law=comparison.law)
            ends[place] = (found.compared[1], found.compared[2])
    return ends


def _compared(state: CompareState, ball: Ball) -> tuple[list[ReducedBat[Bat]], Comparison[Bat]]:
    """Return the bats and their comparison."""
    reductions, labels = bats_of(state, ball)
    with about("swing_law"):
        law = swing_law(state.swing_law or "") if state.same == "effort" else None
    conditions = conditions_of(state, reductions[0].bat)
    return reductions, compare_reduced(reductions, conditions=conditions, law=law, labels=labels)


def sure(state: CompareState) -> ReadDocument:
    """Return the comparison with an interval beside each number, and what they come from."""
    from sweetspot.reports.comparison.document import compare_document

    state = swung(state)
    _, comparison = _compared(state, ball_of(state))
    answer = compare_of(
        comparison, _sources(state, comparison), drawn=True, draws=PAGE_DRAWS, ends=_ends(state, comparison)
    )
    return page_document(compare_document(answer))


def rules_sure(state: CompareState) -> ReadDocument:
    """Return every bat's simulated test with intervals, one below the other, for leagues with the first one's ball."""
    from sweetspot.reports.certification.document import certificate_document

    state = swung(state)
    reductions, labels = bats_of(state, ball_of(state))
    every = leagues_of(state)
    leagues = [entry for entry in every if entry.ball == every[0].ball]
    pages = dict.fromkeys(SYSTEMS, "")
    bats = zip(controls_of(state, len(reductions)), reductions, labels, strict=True)
    for place, (controls, reduction, label) in enumerate(bats, start=1):
        bat = _unheld(reduction.bat)
        test = _certified(bat, every[0].ball)
        conditions = standard_conditions(bat).replaced(ball=test.ball)
        sources = sources_for(controls, bat, conditions)
        question = CertifyQuestion(bat, leagues, test.ball, sources=sources, draws=PAGE_DRAWS)
        tested = certificate_of(question, body=reduction.body, test=test)
        for system, page in page_document(certificate_document(tested).unfolded, mark=f"-{place}").html.items():
            pages[system] += page if label == bat.name else f"<h3>{escape(label)}</h3>{page}"
    return ReadDocument("", pages)


def rules(state: CompareState) -> CertifiedBats:
    """Return the results of the league's simulated test of every bat, and the verdict by every rule."""
    state = swung(state)
    reductions, labels = bats_of(state, ball_of(state))
    leagues = leagues_of(state)
    bats = tuple(_certified_bat(*pair, leagues) for pair in zip(reductions, labels, strict=True))
    return CertifiedBats(bats, tuple(map(_rule_row, *(bat.checks for bat in bats))))


def _rule_row(*checks: RuleCheck) -> RuleRow:
    decided = any(check.verdict in (Verdict.PASS, Verdict.FAIL) for check in checks)
    verdicts = tuple(BatVerdict(in_either_system(verdict_words(check)), check.reason, _mark(check)) for check in checks)
    return RuleRow(checks[0].title, in_either_system(league_limit(checks[0])), decided, verdicts)


def _mark(check: RuleCheck) -> Literal["good", "bad", "muted", ""]:
    if check.verdict == Verdict.NOT_APPLICABLE:
        return "muted"
    if not check.sure or check.verdict == Verdict.NOT_DECIDABLE:
        return ""
    return "good" if check.verdict == Verdict.PASS else "bad"


def _of_wall(state: CompareState, comparison: Comparison) -> list[Sentence]:
    """Return the effect of another wall, where that was asked."""
    return wall_verdict(comparison) if state.what_if == "wall" else []


def _unheld(bat: Bat) -> Bat:
    """Return a bat as a laboratory clamps it, whatever grip it was choked up to."""
    return bat.choked_up(-bat.choke) if bat.choke else bat


def _certified_bat(reduction: ReducedBat, label: str, leagues: list[League]) -> CertifiedBat:
    checks: list[RuleCheck] = []
    for each in leagues:
        test = _certified(_unheld(reduction.bat), each.ball)
        question = CertifyQuestion(reduction.bat, [each], test.ball)
        checks += certificate_of(question, body=reduction.body, test=test).checks
    results = f"BBCOR {test.bbcor:.3f}, BESR {test.besr:.3f}, BPF {test.bpf:.2f}"
    return CertifiedBat(label, results, test.ball.name, tuple(checks))


@lru_cache(maxsize=128)
def _certified(bat: Bat, ball: str) -> Certification:
    return certify(bat, ball=catalog.ball(ball), wall_doubt=wall_doubt(bat))


def recipe(state: CompareState) -> dict[str, str]:
    """Return command line, Python line and bat files that give the same numbers."""
    files, names = {}, [bat_source(state)]
    others = state.others if state.what_if == "none" else ()
    if state.what_if == "wall":
        others = (part_of(state, BatState, wall_factor=state.wall_factor * state.wall_times),)
    for place, bat in enumerate(others, start=2):
        names.append(bat.bat if is_catalogued(bat) else f"bat-{place}.toml")
        if not is_catalogued(bat):
            files[names[-1]] = bat_text(bat)
    options = swing_options(state, beside=True) | {"same_speed": state.same == "speed", "swing_law": state.swing_law}
    ask = Ask("compare", tuple(names), options)
    if made := changes_of(state):
        ask = replace(ask, options=options | {"what_if": made})
    tests = [Ask("certify", (name,), {"league": swung(state).league}).command for name in names]
    return {
        "command": "\n".join([ask.command, *tests]),
        "python": lines_of(ask)["python"],
        "toml": bat_text(state),
        **files,
    }


ASIDES = {"intervals": intervals, "rules": rules, "sure": sure, "rules_sure": rules_sure}
VIEW = View("compare", "Compare", CompareState, answer, recipe, asides=ASIDES)

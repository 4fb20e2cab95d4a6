"""Compare: up to four bats in one player's hands, what a hole or another wall changes, and what leagues say of them."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from functools import lru_cache
from typing import Annotated, Any, Literal

import numpy as np
from markupsafe import escape
from pydantic import Field

from sweetspot import catalog
from sweetspot.analysis.bat_analysis import Analysis
from sweetspot.analysis.certification.rules import League
from sweetspot.analysis.certification.simulated_test import Certification, certify
from sweetspot.analysis.comparison import Comparison, compare_reduced
from sweetspot.analysis.trampoline import wall_point_of
from sweetspot.answers.certify import CertifyQuestion, RuleCheck, certificate_of
from sweetspot.answers.compare import CompareAnswer, ComparedBat, ComparedCurves, SpeedWithEnds, compare_of
from sweetspot.answers.implement import MassProperties
from sweetspot.answers.records import GAPS, Frequency, Length, MomentOfInertia, Ratio
from sweetspot.catalog.bats import FILLS, LABELS, wall_doubt
from sweetspot.catalog.rules import league, league_names
from sweetspot.catalog.standard_hit import standard_conditions
from sweetspot.catalog.swing_laws import swing_law
from sweetspot.dynamics.reduction import ReducedBat
from sweetspot.equipment.ball import Ball
from sweetspot.equipment.bat import Bat
from sweetspot.numerics.arrays import Array
from sweetspot.numerics.interval import Band, Curve
from sweetspot.reports.comparison.words import (
    assumed,
    assumptions,
    changes,
    cork_verdict,
    verdict,
    wall_verdict,
)
from sweetspot.reports.quantities import SYSTEMS
from sweetspot.reports.sentences import Sentence, say
from sweetspot.uncertainty.sources import Sources
from sweetspot.units.dimensions import SPEED
from sweetspot.web.bat_bounds import Range, bounds
from sweetspot.web.bats import ball_of, conditions_of, reduced, swung
from sweetspot.web.controls import BatState, Name, SwungState
from sweetspot.web.documents import ReadDocument, Sentences, in_both_systems, page_document
from sweetspot.web.drawings import BallPicture, BatPicture, BatShape, ball_picture, bat_picture, moi_half, outline
from sweetspot.web.errors import FieldError, about
from sweetspot.web.how_sure import PAGE_DRAWS, sources_for
from sweetspot.web.recipes import Ask, bat_source, bat_text, is_catalogued, lines_of, number, swing_options
from sweetspot.web.view import View

ALL = "all"
NOTHING = "nothing"
ALONE = say("Choose another bat to compare this one with.")


class CompareState(SwungState):
    """The bat, its swing, the others beside it, and what is asked of them."""

    others: Annotated[tuple[BatState, ...], Field(max_length=3)] = Field(
        (BatState(bat="corked-r161"), BatState(bat="russell-b6")),
        description="bats 2 to 4; bat 1 is the reference, and the swing is known with it",
    )
    swing_law: Name | None = Field(
        None, description="how bat speed depends on the bat; empty: as in the first bat's sport"
    )
    what_if: Literal["none", "cork", "wall"] = Field(
        "none", description="of the first bat alone: other bats made of it"
    )
    hole_diameter_in: float = Field(1.0, ge=0.25, le=2, description="hole of what_if cork")
    hole_depth_in: float = Field(10.0, ge=1, le=20)
    wall_times: float = Field(0.85, ge=0.5, le=2.0, description="wall of what_if wall, times the bat's own")
    league: Name | None = Field(
        None, description="whose rules the bats are held against, or 'all'; empty: those of the first bat's sport"
    )


@dataclass(frozen=True)
class WeighedBat(MassProperties):
    """Mass properties, with half the 90 % interval of the swing weight; 0: it was measured."""

    moi_6in_half: MomentOfInertia


@dataclass(frozen=True)
class ComparedCurvesInFull(ComparedCurves):
    """Exit speed and efficiencies along one bat."""

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
    """

    bats: tuple[DrawnComparedBat, ...]
    bat: BatPicture
    others_bounds: tuple[Mapping[str, Range], ...]
    ball: BallPicture
    verdict: Sentences
    assumptions: Sentences


@dataclass(frozen=True, kw_only=True)
class SureBat:
    """The intervals of one bat's numbers; ``change_half`` is half that of its curve."""

    bat_speed: SpeedWithEnds
    exit_speed: SpeedWithEnds
    change: SpeedWithEnds
    change_half: Annotated[Array | None, SPEED, GAPS] = None


@dataclass(frozen=True)
class SureComparison:
    """The intervals of all that is not known, and the verdict that they allow."""

    bats: tuple[SureBat, ...]
    verdict: Sentences
    assumptions: Sentences


@dataclass(frozen=True)
class CertifiedBat:
    """The results of a bat in the league's simulated test, and the verdict by every rule."""

    label: str
    bbcor: float
    besr: float
    bpf: float
    ball: str
    checks: tuple[RuleCheck, ...]


@dataclass(frozen=True)
class CertifiedBats:
    """Every bat's simulated test."""

    certification: tuple[CertifiedBat, ...]


def answer(state: CompareState) -> ComparisonPicture:
    """Return curves and changes, in numbers and words; how sure they are comes apart, see `intervals`."""
    state = swung(state)
    ball = ball_of(state)
    _leagues(state)  # a wrong name is refused at once, though the rules come later
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
        others_bounds=tuple(bounds(*pair) for pair in _others(state, reductions)),
        ball=ball_picture(state, ball),
        verdict=in_both_systems(words + _of_wall(state, comparison)),
        assumptions=in_both_systems([assumptions(plain)]),
    )


def _drawn(row: ComparedBat, analysis: Analysis[Bat], *, wall: bool) -> DrawnComparedBat:
    more = {"collision_efficiency": analysis.scan.collision_efficiency, "bbcor": analysis.scan.bbcor}
    in_full: dict[str, Any] = {
        "bat": WeighedBat(**vars(row.bat), moi_6in_half=moi_half(analysis.bat, analysis.body)),
        "scan": ComparedCurvesInFull(**vars(row.scan), **more),
        "shape": outline(analysis.bat),
        "wall": _wall(analysis) if wall else None,
    }
    return DrawnComparedBat(**vars(row) | in_full)


def _wall(analysis: Analysis[Bat]) -> WallInBestHit:
    point = wall_point_of(analysis)
    return WallInBestHit(point.thickness, point.hoop_frequency, point.energy.share, point.energy.restitution)


def intervals(state: CompareState) -> SureComparison:
    """Return the intervals of all that is not known, and the verdict and what it assumes, as the command has them."""
    state = swung(state)
    _, comparison = _compared(state, ball_of(state))
    sure = compare_of(comparison, _sources(state, comparison))
    words = (verdict(sure) or [ALONE]) + (cork_verdict(sure) if state.what_if == "cork" else [])
    bats = []
    for bat in sure.bats:
        change = bat.scan.change
        half = np.round(change.high - change.value, 4) if isinstance(change, Band) else None
        bats.append(SureBat(bat_speed=bat.bat_speed, exit_speed=bat.exit_speed, change=bat.change, change_half=half))
    return SureComparison(
        tuple(bats),
        in_both_systems(words + _of_wall(state, comparison)),
        in_both_systems([assumed(sure, draws="the fold below")]),
    )


def _sources(state: CompareState, comparison: Comparison[Bat]) -> list[Sources]:
    """Return the uncertain quantities, bat by bat."""
    controls = _own_controls(state, len(comparison.compared))
    analyses = [compared.analysis for compared in comparison.compared]
    return [sources_for(each, entry.bat, entry.conditions) for each, entry in zip(controls, analyses, strict=True)]


def _compared(state: CompareState, ball: Ball) -> tuple[list[ReducedBat[Bat]], Comparison[Bat]]:
    """Return the bats and their comparison."""
    reductions, labels = _bats(state, ball)
    with about("swing_law"):
        law = swing_law(state.swing_law or "") if state.same == "effort" else None
    conditions = conditions_of(state, reductions[0].bat)
    return reductions, compare_reduced(reductions, conditions=conditions, law=law, labels=labels)


def sure(state: CompareState) -> ReadDocument:
    """Return the comparison with an interval beside each number, and what they come from."""
    from sweetspot.reports.comparison.document import compare_document

    state = swung(state)
    _, comparison = _compared(state, ball_of(state))
    answer = compare_of(comparison, _sources(state, comparison), drawn=True, draws=PAGE_DRAWS)
    return page_document(compare_document(answer, corking=state.what_if == "cork"))


def rules_sure(state: CompareState) -> ReadDocument:
    """Return every bat's simulated test with intervals, one below the other, for leagues with the first one's ball."""
    from sweetspot.reports.certification.document import certificate_document

    state = swung(state)
    reductions, labels = _bats(state, ball_of(state))
    every = _leagues(state)
    leagues = [entry for entry in every if entry.ball == every[0].ball]
    pages = dict.fromkeys(SYSTEMS, "")
    bats = zip(_own_controls(state, len(reductions)), reductions, labels, strict=True)
    for place, (controls, reduction, label) in enumerate(bats, start=1):
        bat = _unheld(reduction.bat)
        test = _certified(bat, every[0].ball)
        conditions = standard_conditions(bat).replaced(ball=test.ball)
        sources = sources_for(controls, bat, conditions)
        question = CertifyQuestion(bat, leagues, test.ball, sources=sources, draws=PAGE_DRAWS)
        tested = certificate_of(question, body=reduction.body, test=test)
        for system, page in page_document(certificate_document(tested), mark=f"-{place}").html.items():
            pages[system] += page if label == bat.name else f"<h3>{escape(label)}</h3>{page}"
    return ReadDocument("", pages)


def rules(state: CompareState) -> CertifiedBats:
    """Return the results of the league's simulated test of every bat, and the verdict by every rule."""
    state = swung(state)
    reductions, labels = _bats(state, ball_of(state))
    leagues = _leagues(state)
    pairs = zip(reductions, labels, strict=True)
    return CertifiedBats(tuple(_certified_bat(reduction, label, leagues) for reduction, label in pairs))


def _of_wall(state: CompareState, comparison: Comparison) -> list[Sentence]:
    """Return the effect of another wall, where that was asked."""
    return wall_verdict(comparison) if state.what_if == "wall" else []


def _bats(state: CompareState, ball: Ball) -> tuple[list[ReducedBat], list[str]]:
    """Return the bats with their labels; those of a what-if are made of the first."""
    first = reduced(state, ball)
    if state.what_if == "cork":
        made = [_made(_holed(state, fill), ball, "hole_diameter_in") for fill in (NOTHING, *FILLS.values())]
        return [first, *made], list(LABELS)
    if state.what_if == "wall":
        if first.bat.shell is None:
            raise FieldError("what_if", f"{first.bat.name} is solid and has no wall; choose a hollow bat as bat 1")
        thickness = state.wall_factor * state.wall_times
        other = _made(_changed(state, wall_factor=thickness), ball, "wall_times")
        return [first, other], ["wall as it is", f"wall × {state.wall_times:.3g}"]
    bats = [first, *(_other(bat, ball, number) for number, bat in enumerate(state.others, start=2))]
    return bats, _distinct([reduction.bat.name for reduction in bats])


def _own_controls(state: CompareState, count: int) -> list[BatState]:
    """Return the controls of every bat; those of a what-if are made of the first."""
    return [state, *state.others] if state.what_if == "none" else [state] * count


def _unheld(bat: Bat) -> Bat:
    """Return a bat as a laboratory clamps it, whatever grip it was choked up to."""
    return bat.choked_up(-bat.choke) if bat.choke else bat


def _others(state: CompareState, reductions: list[ReducedBat]) -> list[tuple[BatState, Bat]]:
    """Return the controls of bats 2 to 4 with the bats; a what-if has none."""
    if state.what_if != "none":
        return []
    return [(controls, reduction.bat) for controls, reduction in zip(state.others, reductions[1:], strict=True)]


def _other(bat: BatState, ball: Ball, number: int) -> ReducedBat:
    """Return one bat; what is wrong with it is said of the bats, with its number."""
    try:
        return reduced(bat, ball)
    except FieldError as error:
        raise FieldError(f"others.{number - 2}.{error.field}", f"bat {number}: {error}") from None


def _made(bat: BatState, ball: Ball, control: str) -> ReducedBat:
    """Return a bat of a what-if; what does not work is said beside the what-if's own control."""
    try:
        return reduced(bat, ball)
    except FieldError as error:
        raise FieldError(control, str(error)) from None


def _holed(state: CompareState, fill: str) -> BatState:
    return _changed(state, bore_diameter_in=state.hole_diameter_in, bore_depth_in=state.hole_depth_in, bore_fill=fill)


def _changed(state: CompareState, **changes: Any) -> BatState:
    """Return the first bat's own controls with changes."""
    return BatState.model_construct(**{**{name: getattr(state, name) for name in BatState.model_fields}, **changes})


def _distinct(names: list[str]) -> list[str]:
    """Return the names with a number behind those that occur again."""
    return [
        name if name not in names[:index] else f"{name} ({names[: index + 1].count(name)})"
        for index, name in enumerate(names)
    ]


def _leagues(state: CompareState) -> list[League]:
    with about("league"):
        return [league(name) for name in (league_names() if state.league == ALL else [state.league or ""])]


def _certified_bat(reduction: ReducedBat, label: str, leagues: list[League]) -> CertifiedBat:
    checks: list[RuleCheck] = []
    for each in leagues:
        test = _certified(_unheld(reduction.bat), each.ball)
        question = CertifyQuestion(reduction.bat, [each], test.ball)
        checks += certificate_of(question, body=reduction.body, test=test).checks
    return CertifiedBat(label, test.bbcor, test.besr, test.bpf, test.ball.name, tuple(checks))


@lru_cache(maxsize=128)
def _certified(bat: Bat, ball: str) -> Certification:
    return certify(bat, ball=catalog.ball(ball), wall_doubt=wall_doubt(bat))


def recipe(state: CompareState) -> dict[str, str]:
    """Return command line, Python line and bat files that give the same numbers."""
    files, names = {}, [bat_source(state)]
    others = state.others if state.what_if == "none" else ()
    if state.what_if == "wall":
        others = (_changed(state, wall_factor=state.wall_factor * state.wall_times),)
    for place, bat in enumerate(others, start=2):
        names.append(bat.bat if is_catalogued(bat) else f"bat-{place}.toml")
        if not is_catalogued(bat):
            files[names[-1]] = bat_text(bat)
    options = swing_options(state, beside=True) | {"same_speed": state.same == "speed", "swing_law": state.swing_law}
    ask = Ask("compare", tuple(names), options)
    if state.what_if == "cork":
        hole = {
            "bore_diameter": number(state.hole_diameter_in, "in"),
            "bore_depth": number(state.hole_depth_in, "in"),
            "plug": number(min(1.0, state.hole_depth_in / 2), "in"),
        }
        ask = replace(ask, options=options | hole, function="compare_corked", chosen={"what_if": "cork"})
    tests = [Ask("certify", (name,), {"league": swung(state).league}).command for name in names]
    return {
        "command": "\n".join([ask.command, *tests]),
        "python": lines_of(ask)["python"],
        "toml": bat_text(state),
        **files,
    }


VIEW = View(
    "compare",
    "Compare",
    CompareState,
    answer,
    recipe,
    asides={"intervals": intervals, "rules": rules, "sure": sure, "rules_sure": rules_sure},
)

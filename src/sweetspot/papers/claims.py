"""What the implemented paper claims, and whether the full model agrees, for one bat under its conditions."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from enum import StrEnum
from typing import Annotated

from sweetspot.analysis.bat_analysis import Analysis
from sweetspot.dynamics.rigid import centre_of_percussion
from sweetspot.equipment.implement import Implement
from sweetspot.papers.formulas import PaperRow
from sweetspot.units import MPH

STILL = 5e-3
"""m by which two places may differ and still be called the same: a player scatters by ten times as much [our choice].
"""
LITTLE = 0.1
"""Part of a carry that "hardly matters" [our choice]."""


class ClaimVerdict(StrEnum):
    """Whether a claim of the paper holds for a bat."""

    HOLDS = "holds"
    FAILS = "does not hold"
    OPEN = "open"


@dataclass(frozen=True)
class PaperClaim:
    """One claim of the paper.

    Parameters
    ----------
    name : by which `sweetspot.reports.paper.claims` has its words.
    verdict : whether it holds; open: what is not known decides.
    facts : the numbers that decide it, in SI.
    """

    name: str
    verdict: ClaimVerdict
    facts: Annotated[Mapping[str, object], "internal"] = field(default_factory=dict)


def paper_claims(analysis: Analysis[Implement], rows: Sequence[PaperRow]) -> tuple[PaperClaim, ...]:
    """Return the paper's claims with their verdicts, in the paper's order; those on corking only for bats of wood.

    ``rows``: of this analysis, see `paper_rows`.

    >>> from sweetspot import paper_rows, standard_analysis
    >>> analysis = standard_analysis("r161-ash")
    >>> first, second = paper_claims(analysis, paper_rows(analysis))[:2]
    >>> first.name, str(first.verdict), second.name, str(second.verdict)
    ('not the end', 'holds', 'within the shift', 'does not hold')
    """
    return tuple(_claims(analysis, {row.name: row for row in reversed(rows)}, rows))


def _claims(
    analysis: Analysis[Implement], named: Mapping[str, PaperRow], rows: Sequence[PaperRow]
) -> Iterator[PaperClaim]:
    def full(name: str) -> float:
        value = named[name].full_model
        return float(value) if isinstance(value, (int, float)) else float("nan")

    best, bat = analysis.sweet_spots.max_exit_speed, analysis.bat
    place = bat.length - best
    smooth = named["elastic travel"].computed
    shift = 1e-3 * float(smooth if isinstance(smooth, (int, float)) else 0.0)
    yield _claim("not the end", place > STILL, bat=bat.name, place=place)
    yield _claim("within the shift", place <= shift, shift=shift, place=place)
    at_centre, at_tip = (row.full_model for row in rows if row.name == "hand force")
    yield _claim("quiet hands", float(at_centre or 0.0) > 0 > float(at_tip or 0.0))
    quiet = centre_of_percussion(analysis.body, pivot=analysis.conditions.hands.position)
    yield _claim("percussion is best", abs(quiet - best) < STILL, gap=abs(quiet - best))
    moved = 1e-3 * full("hands moved")
    yield _claim("hands moved", moved > 0, moved=moved, hands=named["hands moved"].facts["moved"])
    if "force, corked" in named:
        yield from _corking(full)
    wood, metal = (row.full_model for row in rows if row.name == "rebound")
    if isinstance(wood, float) and isinstance(metal, float):
        height = named["rebound"].facts["height"]
        yield _claim("metal rebounds higher", metal > wood, wood=wood, metal=metal, height=height)
    wood, metal = full("energy returned, wood"), full("energy returned, metal")
    yield _claim("metal returns more", metal > wood, wood=wood, metal=metal)
    if swung := named.get("metal swung faster"):
        verdict = ClaimVerdict.HOLDS if swung.facts["right"] else ClaimVerdict.FAILS
        facts = {"low": swung.facts["low"], "high": swung.facts["high"], "faster": full("metal swung faster") * MPH}
        yield PaperClaim("metal swung faster", ClaimVerdict.OPEN if swung.facts["open"] else verdict, facts)
    wood, metal = full("carry off wood"), full("carry off metal")
    yield _claim("metal carries further", metal > wood, further=metal - wood)
    taken = float(str(named["carry off metal"].facts["taken"]))
    yield _claim("air hardly matters", taken < LITTLE, taken=taken)
    livelier = named["livelier ball, place"].facts["livelier"]
    moved, gained = 1e-3 * full("livelier ball, place"), full("livelier ball, speed") * MPH
    yield _claim("livelier ball, same place", abs(moved) < STILL, moved=abs(moved), livelier=livelier)
    yield _claim("livelier ball, faster", gained > 0, gained=gained, livelier=livelier)


def _corking(full: Callable[[str], float]) -> Iterator[PaperClaim]:
    """Yield the claims on a hollowed bat."""
    lost = -1e-3 * full("mass of the corked bat")
    yield _claim("corking lightens", lost > 0, lost=lost)
    before, after = 1e3 * full("force, plain"), 1e3 * full("force, corked")
    yield _claim("corking adds force", after > before, before=before, after=after)
    before, after = 1e-3 * full("contact time, plain"), 1e-3 * full("contact time, corked")
    yield _claim("corking lengthens contact", after > before, before=before, after=after)
    change = (full("exit speed, corked") - full("exit speed, plain")) * MPH
    yield _claim("corking speeds the ball", change > 0, change=change)


def _claim(name: str, holds: bool, **facts: object) -> PaperClaim:
    return PaperClaim(name, ClaimVerdict.HOLDS if holds else ClaimVerdict.FAILS, facts)

"""The paper's claims: each verdict follows from the numbers, and another bat or block turns it."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import pytest

from sweetspot import catalog, standard_analysis
from sweetspot.analysis.bat_analysis import Analysis
from sweetspot.papers.chain import paper_rows
from sweetspot.papers.claims import ClaimVerdict, PaperClaim, paper_claims
from sweetspot.reports.paper.claims import CLAIMS, claim_reason, claims_headline
from sweetspot.reports.quantities import US


def claims(analysis: Analysis[Any]) -> dict[str, PaperClaim]:
    found = paper_claims(analysis, paper_rows(analysis))
    assert len({claim.name for claim in found}) == len(found)
    return {claim.name: claim for claim in found}


@pytest.fixture(scope="module")
def analysis() -> Analysis[Any]:
    return standard_analysis(catalog.bat("r161-ash"))


def test_what_laboratories_have_settled_comes_out_as_they_did(analysis: Analysis[Any]) -> None:
    """cross1998ajp: not the end, nor the center of percussion; nathan2011corked: lighter, and no faster ball."""
    found = claims(analysis)
    holding = {name for name, claim in found.items() if claim.verdict is ClaimVerdict.HOLDS}
    assert {"not the end", "quiet hands", "hands moved", "corking lightens", "metal returns more"} <= holding
    assert not {"within the shift", "percussion is best", "corking adds force", "corking speeds the ball"} & holding


@pytest.mark.parametrize(
    ("row", "value", "claim"),
    [
        ("rebound", 0.9, "metal rebounds higher"),
        ("force, corked", 99.0, "corking adds force"),
        ("contact time, corked", 0.1, "corking lengthens contact"),
        ("exit speed, corked", 120.0, "corking speeds the ball"),
        ("mass of the corked bat", 10.0, "corking lightens"),
        ("hands moved", -5.0, "hands moved"),
        ("energy returned, metal", 0.1, "metal returns more"),
        ("carry off metal", 10.0, "metal carries further"),
        ("livelier ball, place", 40.0, "livelier ball, same place"),
        ("livelier ball, speed", -1.0, "livelier ball, faster"),
    ],
)
def test_another_answer_of_the_model_turns_the_claim(
    analysis: Analysis[Any], row: str, value: float, claim: str
) -> None:
    rows = paper_rows(analysis)
    place = max(at for at, each in enumerate(rows) if each.name == row)  # of two blocks the metal one
    turned = [replace(each, full_model=value) if at == place else each for at, each in enumerate(rows)]
    (before,) = (each for each in paper_claims(analysis, rows) if each.name == claim)
    (after,) = (each for each in paper_claims(analysis, turned) if each.name == claim)
    assert {before.verdict, after.verdict} == {ClaimVerdict.HOLDS, ClaimVerdict.FAILS}


def test_a_bat_that_cannot_be_drilled_has_no_claims_on_corking() -> None:
    found = claims(standard_analysis(catalog.bat("college-alloy")))
    assert "not the end" in found and not any(name.startswith("corking") for name in found)


def test_the_headline_counts_every_claim_and_each_has_its_words(analysis: Analysis[Any]) -> None:
    found = list(claims(analysis).values())
    assert set(CLAIMS) == {claim.name for claim in found}
    assert all(claim_reason(claim).read(US) for claim in found)
    opened = [*found, PaperClaim("metal swung faster", ClaimVerdict.OPEN)]
    holding = sum(claim.verdict is ClaimVerdict.HOLDS for claim in found)
    expected = f"{len(found) + 1} claims: {holding} hold, {len(found) - holding} do not, 1 open."
    assert claims_headline(opened) == expected

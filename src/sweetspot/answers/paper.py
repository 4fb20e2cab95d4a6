"""The implemented paper's chain: each statement beside our own computation of it and the full model's answer."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated

from sweetspot.analysis.bat_analysis import Analysis
from sweetspot.answers.answer import Answer
from sweetspot.answers.records import INTERNAL
from sweetspot.answers.setups import SwungWith
from sweetspot.equipment.bat import Bat
from sweetspot.papers.chain import paper_rows
from sweetspot.papers.choices import Choices
from sweetspot.papers.claims import PaperClaim, paper_claims
from sweetspot.papers.formulas import PaperRow


@dataclass(frozen=True, kw_only=True)
class PaperAnswer(Answer):
    """The paper's claims with their verdicts, and its statements about one bat; each row's numbers are in its unit."""

    claims: tuple[PaperClaim, ...]
    rows: tuple[PaperRow, ...]
    swung_with: SwungWith | None = None
    analysis: Annotated[Analysis[Bat], INTERNAL]


def paper_answer(analysis: Analysis[Bat], choices: Choices) -> PaperAnswer:
    """Return the paper's chain for one analysed bat; see `paper_rows`."""
    rows = tuple(paper_rows(analysis, choices))
    return PaperAnswer(claims=paper_claims(analysis, rows), rows=rows, analysis=analysis)

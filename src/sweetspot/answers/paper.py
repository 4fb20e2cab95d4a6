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
from sweetspot.papers.formulas import PaperRow


@dataclass(frozen=True, kw_only=True)
class PaperAnswer(Answer):
    """The paper's statements about one bat, in the paper's order; numbers are in the unit of their row."""

    rows: tuple[PaperRow, ...]
    swung_with: SwungWith | None = None
    analysis: Annotated[Analysis[Bat], INTERNAL]


def paper_answer(analysis: Analysis[Bat], choices: Choices) -> PaperAnswer:
    """Return the paper's chain for one analysed bat; see `paper_rows`."""
    return PaperAnswer(rows=tuple(paper_rows(analysis, choices)), analysis=analysis)

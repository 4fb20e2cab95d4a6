"""Comparisons with an interval beside every number, and what the intervals come from."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from sweetspot.analysis.comparison import Comparison
from sweetspot.answers.certify import CertifyAnswer
from sweetspot.equipment.implement import Implement
from sweetspot.report.comparison.document import comparison_document
from sweetspot.report.document import Document, Paragraph
from sweetspot.report.uncertainty.gains import gain_json, gain_words
from sweetspot.report.uncertainty.uncertainty_section import uncertain
from sweetspot.uncertainty.comparison_draws import LAW, drawn_comparison, names_of_bats
from sweetspot.uncertainty.sources import DRAWS, Sources


def comparison_with_doubt(
    comparison: Comparison[Implement],
    sources: list[Sources],
    *,
    corking: bool = False,
    tested: Sequence[CertifyAnswer | None] = (),
    count: int = DRAWS,
) -> Document:
    """Return a comparison with intervals, and how sure each bat's gain over the first is.

    Parameters
    ----------
    sources : of every bat; those that are not a bat's are taken from the first.
    corking, tested : see `comparison_document`.
    """
    answers = drawn_comparison(comparison, sources, count=count)
    compared = comparison.compared
    own = zip(names_of_bats(comparison), sources, strict=True)
    where = {name: one.bat_where for name, one in own} | {one.name: one.where for one in sources[0].others}
    where[LAW] = "spread of its exponent in the catalogue"
    last = len(compared) - 1
    main, named = (
        (f"bats.{last}.change_m_s", f"change of {compared[-1].label}")
        if last
        else ("bats.0.exit_speed_m_s", "exit speed")
    )
    document = comparison_document(comparison, corking=corking, tested=tested, sources=sources, reaches=answers.reaches)
    told = uncertain(document, answers, main=main, named=named, where=where)
    gains = [(one.label, index) for index, one in enumerate(compared) if index]
    words = [Paragraph(gain_words(label, compared[0].label, answers, index)) for label, index in gains]
    data = {**told.data, "uncertainty": {**told.data["uncertainty"], "gains": [
        {"label": label, **gain_json(answers, index)} for label, index in gains
    ]}}  # fmt: skip
    return replace(told, blocks=[*told.blocks[:last], *words, *told.blocks[last:]], data=data)

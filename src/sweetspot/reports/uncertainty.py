"""Sources of a number's uncertainty as ranked bars: in words, as a table and as a picture."""

from __future__ import annotations

import math
from collections.abc import Mapping

from sweetspot.answers.answer import Uncertainty
from sweetspot.catalog.sports import sport, sport_names
from sweetspot.reports.document import Cell, Paragraph, Picture, Section, Table, drawn, table_head
from sweetspot.reports.sentences import Sentence, Slot, say
from sweetspot.uncertainty.intervals import TOGETHER

LEAST_SHARE = 0.005
LONGEST_BAR = 30
"""Characters."""
HOW_SURE = (
    "Numbers with ±, or with ends in brackets of which nothing else is said: {drawn.interval_level:share} intervals "
    "from {drawn.draws} draws of what is not known. What the interval of the {named} comes from (the rest of the "
    "conditions is taken as given):"
)


def how_sure(uncertainty: Uncertainty, named: str) -> Section:
    """Return an explanation of an answer's intervals, with the sources of the main number's."""
    shares = {name: share for name, share in uncertainty.shares.items() if share >= LEAST_SHARE}
    not_drawn = {name: 0.0 for name in uncertainty.sources if name not in uncertainty.shares}
    words = say(HOW_SURE, drawn=uncertainty, named=named)
    table = shares_table({**shares, **not_drawn}, uncertainty.sources)
    return Section("how-sure", "How sure", [Paragraph(words), table, shares_picture(shares, named)])


def shares_table(shares: Mapping[str, float], where: Mapping[str, str]) -> Table:
    """Return sources ranked by the part of the variance that they cause, each with a bar."""
    most = max(shares.values(), default=1.0)
    rows: list[list[Cell]] = [
        [
            _name(name), Slot(share, "share"), "█" * math.ceil(LONGEST_BAR * share / most),
            where.get(name, "more than one of them at once"),
        ]
        for name, share in shares.items()
    ]  # fmt: skip
    columns = table_head("source | part > |  | rests on")
    return Table("", columns, rows, name="shares")


def shares_picture(shares: Mapping[str, float], named: str) -> Picture:
    """Return the ranked bars as a picture."""
    shares_by_name = {_name(name): share for name, share in shares.items()}
    ranked = ", ".join(f"{name} {100 * share:.0f} %" for name, share in shares_by_name.items())
    return Picture(
        "doubt",
        drawn("sweetspot.reports.pictures.shares:shares_figure", shares_by_name, named),
        label=f"What the doubt comes from: {ranked}.",
    )


def _name(source: str) -> str:
    if source == TOGETHER:
        return "several together"
    implements = {sport(name).words.implement for name in sport_names()}
    return f"the {source}" if source in implements else source


LEAST = 0.005
"""Least probability that draws resolve: one nearer to 0 or 1 is reported as beyond 1 or 99 %."""


def chance_words(chance: float) -> Sentence:
    """Return a probability in percent; never 0 or 100, which draws cannot establish.

    >>> str(chance_words(0.64)), str(chance_words(0.0)), str(chance_words(1.0))
    ('64 %', 'less than 1 %', 'more than 99 %')
    """
    if chance < LEAST:
        return say("less than {share:share}", share=0.01)
    if chance > 1 - LEAST:
        return say("more than {share:share}", share=0.99)
    return say("{share:share}", share=chance)

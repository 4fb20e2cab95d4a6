"""A comparison as a document: who gains, what the implements are, what they do in play, and what that assumes."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from sweetspot.analysis.comparison import Compared, Comparison
from sweetspot.answers.certify import CertifyAnswer
from sweetspot.answers.conditions import hit_conditions
from sweetspot.answers.implement import mass_properties
from sweetspot.answers.records import to_dict
from sweetspot.catalog.sports import sport
from sweetspot.catalog.swing_weights import swing_weight
from sweetspot.dynamics.outline_doubt import moi_doubt
from sweetspot.equipment.bat import Bat
from sweetspot.equipment.implement import Implement
from sweetspot.numerics.constants import STANDARD_AXIS
from sweetspot.numerics.interval import Interval
from sweetspot.report.comparison.legality import legality_json, legality_table
from sweetspot.report.comparison.words import (
    INTERVAL_HOLDS,
    LINEAR_HOLDS,
    assumed,
    cork_verdict,
    verdict,
)
from sweetspot.report.document import Block, Cell, Column, Document, Paragraph, Picture, Table
from sweetspot.report.json_shapes import as_columns, cleaned
from sweetspot.report.quantities import Reader, reader
from sweetspot.report.sentences import PLUS_MINUS, Slot, Words, joined, read, with_doubt, within
from sweetspot.uncertainty.comparison_draws import with_intervals
from sweetspot.uncertainty.intervals import Reaches
from sweetspot.uncertainty.linear_doubt import comparison_reaches
from sweetspot.uncertainty.sources import Sources, sources_of
from sweetspot.units import INCH

BBCOR_OF_PLAY = (
    "BBCOR in play is at this swing's closing speed. The number that rules limit is measured otherwise, in a test with "
    "the bat at rest{where}."
)

PLACES = INCH * np.array([1, 2, 3, 4, 5, 6, 7, 8, 10, 12])
"""m from the tip; hits that are told one by one."""
MOST_BY_PLACE = 3
"""Bats beside the first whose columns fit a terminal; the picture draws any number."""
WITH_RULES, WITHOUT = ", as in the table of the rules", "; `sweetspot certify` computes that one"


def comparison_document(
    comparison: Comparison[Implement],
    *,
    corking: bool = False,
    tested: Sequence[CertifyAnswer | None] = (),
    sources: Sequence[Sources] | None = None,
    reaches: Reaches | None = None,
) -> Document:
    """Return a comparison as a document, with intervals of all that is not known.

    Parameters
    ----------
    corking : whether the bats are one bat unmodified, drilled, corked, ..., so that corking is answered too.
    tested : every bat held against the rules of its own sport, in the comparison's order, None of what has no such
        rules; none: no rules were asked.
    sources : what is not known, bat by bat; None: what is not of bats of these descriptions.
    reaches : of the intervals of draws, see `drawn_comparison`; None: they are worked out without draws.
    """
    drawn = reaches is not None
    if sources is None:
        sources = [sources_of(one.analysis.bat, one.analysis.conditions) for one in comparison.compared]
    if reaches is None:
        reaches = comparison_reaches(comparison, sources)
    comparison, interval_is = with_intervals(comparison, reaches), INTERVAL_HOLDS if drawn else LINEAR_HOLDS
    reference = comparison.reference.analysis
    its = sport(reference.bat.sport)
    reading, tool, number = reader(None, its.words), its.words.implement, len(comparison.compared)
    ruled = [(one.label, test) for one, test in zip(comparison.compared, tested, strict=False) if test is not None]
    words = verdict(comparison, sources=sources) + (cork_verdict(comparison) if corking else [])
    picture = Picture(
        "curves", lambda reading: _drawn(comparison, reaches, reading),
        label=f"Outlines, exit speed along each {tool}, and the difference from the first one.",
        caption="Tips aligned. Boxes: sweet zones. Dots: best places.",
        sheet=lambda reading: _drawn_sheet(comparison, reaches, reading),
    )  # fmt: skip
    notes: list[Words] = [
        joined(
            [
                assumed(comparison, sources, draws="" if drawn else "`--uncertainty`"),
                *([PLUS_MINUS] if _has_doubt(comparison.compared) else []),
            ]
        ),
        *([BBCOR_OF_PLAY.format(where=WITH_RULES if ruled else WITHOUT)] if isinstance(reference.bat, Bat) else []),
    ]
    return Document(
        name="compare", title=f"One {tool}" if number == 1 else f"{number} {tool}s, one player",
        subtitle=_effort(comparison), kind="Comparison",
        blocks=[
            *map(Paragraph, words), picture, _things(comparison.compared), _in_play(comparison.compared),
            *([legality_table(ruled)] if ruled else []),
            *(Paragraph(note, "note") for note in notes),
        ],
        data=_data(comparison, [read(sentence, reading) for sentence in words], interval_is, tested),
        rows=as_columns(comparison_rows(comparison)), reader=reading, drawing=picture, details=_by_place(comparison),
    )  # fmt: skip


def _data(
    comparison: Comparison[Implement], words: Sequence[str], interval_is: str, tested: Sequence[CertifyAnswer | None]
) -> dict[str, Any]:
    data = comparison_json(comparison, words, interval_is)
    for bat, test in zip(data["bats"], tested, strict=False):
        if test is not None:
            bat["rules"] = cleaned(legality_json(test))
    return data


def _effort(comparison: Comparison[Implement]) -> str:
    tool = sport(comparison.reference.analysis.bat.sport).words.implement
    law = comparison.law
    return f"all at the same {tool} speed" if law is None else f"same effort by the law of {law.name}"


def _has_doubt(compared: Sequence[Compared[Implement]]) -> bool:
    """Return whether a moment of inertia among them was not measured."""
    every = (one.analysis for one in compared)
    return any(isinstance(one.bat, Bat) and moi_doubt(one.bat, one.body, STANDARD_AXIS) > 0 for one in every)


def _things(compared: Sequence[Compared[Implement]]) -> Table:
    """Return what the implements are; round bats have a BBCOR, others their sport's own swing weight."""
    bat = compared[0].analysis.bat
    tool, convention = sport(bat.sport).words.implement, swing_weight(bat.sport)
    columns = [Column(tool), Column("mass", "mass"), Column("balance", "length")]
    weighed = Column("MOI" if isinstance(bat, Bat) else convention.name, right=True)
    columns += [weighed, Column("f1", "frequency"), Column("q max", "ratio")]
    columns += [Column("BBCOR in play", "ratio")] if isinstance(bat, Bat) else []
    rows: list[list[Cell]] = []
    for number, one in enumerate(compared):
        body, at = one.analysis.body, f"bats.{number}."
        turning: Cell = convention.shown(body)
        if isinstance(own := one.analysis.bat, Bat):
            doubt = moi_doubt(own, body, STANDARD_AXIS)
            turning = with_doubt(body.moi(STANDARD_AXIS), doubt, "moi", of=f"{at}bat.moi_6in_kg_m2")
        row: list[Cell] = [
            one.label, Slot(body.mass, "mass", unit=False, of=f"{at}bat.mass_kg"),
            Slot(body.balance_point, "length", unit=False, of=f"{at}bat.balance_point_m"),
            turning,
            Slot(first_frequency(one, "bending"), "frequency", unit=False, of=f"{at}bending_1_hz"),
            Slot(one.collision_efficiency, "ratio", of=f"{at}max_collision_efficiency"),
        ]  # fmt: skip
        row += [Slot(one.bbcor, "ratio", of=f"{at}max_bbcor")] if isinstance(bat, Bat) else []
        rows.append(row)
    return Table(f"The {tool}s", columns, rows, name="compared")


def _in_play(compared: Sequence[Compared[Implement]]) -> Table:
    words = sport(compared[0].analysis.bat.sport).words
    tool = words.implement
    columns = [
        Column(tool), Column(f"{tool} speed", "speed"), Column(words.exit_speed, "speed"),
        Column("change", "speed_change"), Column("break-even", "speed"),
    ]  # fmt: skip
    rows: list[list[Cell]] = [
        [
            one.label, within(one.bat_speed, "speed", unit=False, of=f"bats.{number}.bat_speed_m_s"),
            within(one.exit_speed, "speed", unit=False, of=f"bats.{number}.exit_speed_m_s"),
            within(one.change, "speed_change", sign=True, unit=False, of=f"bats.{number}.change_m_s")
            if number else "reference",
            Slot(one.break_even, "speed", unit=False, of=f"bats.{number}.break_even_bat_speed_m_s"),
        ]
        for number, one in enumerate(compared)
    ]  # fmt: skip
    return Table("In play", columns, rows, name="compared")


def _by_place(comparison: Comparison[Implement]) -> list[Block]:
    """Return what each place on a round bat gains beside the first bat, as the picture draws it; none for many bats."""
    first, others = comparison.reference, comparison.compared[1:]
    if not isinstance(first.analysis.bat, Bat) or not 0 < len(others) <= MOST_BY_PLACE:
        return []
    known = first.exit_speed_from_tip(PLACES)
    changes = [one.exit_speed_from_tip(PLACES) - known for one in others]
    columns = [
        Column("hit from the tip", "place"), *(Column(f"{one.label},", "speed_change", sign=True) for one in others)
    ]  # fmt: skip
    rows: list[list[Cell]] = [list(map(float, row)) for row in zip(PLACES, *changes, strict=True)]
    return [Table(f"Change by place, against {first.label}", columns, rows)]


def _drawn(comparison: Comparison[Implement], reaches: Reaches | None, reading: Reader) -> Any:
    from sweetspot.report.comparison.picture import compare_figure

    return compare_figure(comparison, reading, reaches=reaches)


def _drawn_sheet(comparison: Comparison[Implement], reaches: Reaches | None, reading: Reader) -> Any:
    from sweetspot.report.comparison.picture import compare_sheet

    return compare_sheet(comparison, reading, reaches=reaches)


def comparison_json(comparison: Comparison[Implement], verdict: Sequence[str], interval_is: str) -> dict[str, Any]:
    """Return everything about a comparison; the first bat is the reference."""
    law, reference = comparison.law, comparison.reference
    exponents = law.exponents if law else None
    return cleaned(
        {
            "reference": reference.label,
            "same": "speed" if law is None else "effort",
            "swing_law": law and exponents and {
                "name": law.name,
                "exponent": _interval(exponents),
                "axis_from_grip_m": law.axis,
                "lightest_moi_kg_m2": law.lightest_moi,
            },
            "interval": interval_is,
            "bats": [_bat(compared) for compared in comparison.compared],
            "verdict": list(verdict),
            "conditions": to_dict(hit_conditions(reference.analysis.conditions)),
        }
    )  # fmt: skip


def comparison_rows(comparison: Comparison[Implement]) -> list[dict[str, Any]]:
    """Return one flat row per bat."""
    rows = []
    for compared in comparison.compared:
        described = _bat(compared)
        row: dict[str, Any] = {"label": compared.label}
        for key, value in described.items():
            if key == "bat":
                row |= {name: value[name] for name in ("mass_kg", "balance_point_m", "moi_6in_kg_m2", "moi_knob_kg_m2")}
            elif isinstance(value, dict) and "value" in value:
                stem = key.removesuffix("_m_s")
                row |= {key: value["value"], f"{stem}_low_m_s": value["low"], f"{stem}_high_m_s": value["high"]}
            elif isinstance(value, float | None):
                row[key] = value
        rows.append(cleaned(row))
    return rows


def first_frequency(compared: Compared[Implement], family: str) -> float:
    """Return the lowest frequency in Hz of a family of modes, nan where the bat has none."""
    modes = compared.analysis.modes
    return min(
        (float(modes.frequency[i]) for i, name in enumerate(modes.families) if name == family), default=float("nan")
    )


def _bat(compared: Compared[Implement]) -> dict[str, Any]:
    analysis = compared.analysis
    return {
        "label": compared.label,
        "bat": to_dict(mass_properties(analysis.bat, analysis.body)),
        "bending_1_hz": first_frequency(compared, "bending"),
        "hoop_1_hz": first_frequency(compared, "hoop"),
        "max_collision_efficiency": compared.collision_efficiency,
        "max_bbcor": compared.bbcor,
        "bat_speed_m_s": _interval(compared.bat_speed),
        "exit_speed_m_s": _interval(compared.exit_speed),
        "change_m_s": _interval(compared.change),
        "break_even_bat_speed_m_s": compared.break_even,
        "max_exit_speed_m": analysis.sweet_spots.max_exit_speed,
        "zone_m": analysis.sweet_spots.zone,
        "scan": {"position_m": analysis.scan.position, "exit_speed_m_s": analysis.scan.exit_speed},
    }


def _interval(interval: Interval) -> dict[str, float]:
    return {"value": interval.value, "low": interval.low, "high": interval.high}

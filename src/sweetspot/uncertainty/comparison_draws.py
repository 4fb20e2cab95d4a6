"""A comparison of many bats that may be meant, all hit by the same balls with the same effort.

What is not known of ball, pitch and swing is the same for all bats of a draw and mostly cancels. Each bat has its own
doubt, but bats that were made from one piece share what is not known of it. The swing law's exponent is drawn too.
"""

from __future__ import annotations

from collections.abc import Hashable, Sequence
from dataclasses import replace

import numpy as np

from sweetspot.analysis.bat_analysis import Analysis
from sweetspot.analysis.comparison import Compared, Comparison
from sweetspot.equipment.implement import Implement
from sweetspot.motion.swing_law import GREATEST_EXPONENT, SwingLaw
from sweetspot.numerics.arrays import Array
from sweetspot.numerics.constants import STANDARD_AXIS
from sweetspot.numerics.interval import Interval
from sweetspot.numerics.parabola import peak
from sweetspot.uncertainty.drawn_hits import Draws, draws_of, hits_along
from sweetspot.uncertainty.intervals import DrawnAnswers, Reaches
from sweetspot.uncertainty.sources import DRAWS, Source, Sources, even_normal

PLACES = 41
NEARER, SHOWN_FROM = 6, 0.6
"""Places nearer the hands, from this part of the length on, that are hit for the curves alone."""
LAW = "swing law"
ALONG, CHANGE_ALONG = "scan.exit_speed_m_s", "scan.change_m_s"
"""Curves of every bat along its own scan, from the balance point on; the second against the first bat."""
LEAST_APART = 0.05
"""m/s of bat speed from which on two exit speeds tell how one goes with the other."""


def drawn_comparison(
    comparison: Comparison[Implement],
    sources: Sequence[Sources],
    *,
    count: int = DRAWS,
    normal: Array | None = None,
) -> DrawnAnswers:
    """Return the answers of draws to a comparison, by their names in its data.

    Parameters
    ----------
    sources : of every bat; those that are not a bat's are taken from the first.
    normal : standard normal numbers to draw by, shape (count, n) with a column for each of `drawn_names`; None: Sobol's
        sequence.
    """
    first, law = sources[0], comparison.law
    behind = {number: column for column, number in enumerate(_behind(comparison, sources))}
    names = drawn_names(comparison, sources)
    if normal is None:
        normal = even_normal(count, len(names))  # of one sequence: two of them go together, whatever their seeds
    count = len(normal)
    of_bats, shared = np.split(normal, [len(behind)], axis=1)
    power = np.zeros(count + 1)
    if law is not None:
        power[1:] = law.exponent_spread * shared[:, -1]
        power = np.clip(law.exponent + power, 0.0, GREATEST_EXPONENT)
    of_others = shared[:, : len(first.others)]
    values: dict[str, Array] = {}
    reference: Draws | None = None
    longest = max(one.analysis.bat.length for one in comparison.compared)
    for index, (one, own) in enumerate(zip(comparison.compared, sources, strict=True)):
        joint = Sources(own.doubt, first.others)
        analysis = one.analysis
        drawn = np.hstack([of_bats[:, [behind[number] for number in own.doubt.behind]], of_others])
        draws = draws_of(analysis.line, analysis.conditions, joint, count=count, normal=drawn)
        if reference is not None and law is not None:
            draws = draws.swung(reference.bat_speed / reference.bat_speed[0] * _ratios(law, draws, reference, power))
        reference = reference or draws
        values |= _of_bat(draws, index, analysis)
    known = values["bats.0.exit_speed_m_s"]
    for index in range(len(sources)):
        values[f"bats.{index}.change_m_s"] = values[f"bats.{index}.exit_speed_m_s"] - known
    for index, one in enumerate(comparison.compared):
        if index:
            values |= _against_the_first(one, index, values)
            values |= _change_along(comparison, index, values, longest)
    return DrawnAnswers(np.vstack([np.zeros((1, normal.shape[1])), normal]), names, values)


def drawn_names(comparison: Comparison[Implement], sources: Sequence[Sources]) -> tuple[str, ...]:
    """Return the name of the source of every column of a draw: of the bats, then of what they share."""
    own = _behind(comparison, sources).values()
    return (*own, *(one.name for one in (*sources[0].others, *_of_law(comparison.law))))


def _behind(comparison: Comparison[Implement], sources: Sequence[Sources]) -> dict[Hashable, str]:
    """Return whose every number behind the bats' deviations is, and what the first bat is called that it is behind."""
    called: dict[Hashable, str] = {}
    for label, one in zip(names_of_bats(comparison), sources, strict=True):
        called |= {number: label for number in one.doubt.behind if number not in called}
    return called


def _against_the_first(one: Compared[Implement], index: int, values: dict[str, Array]) -> dict[str, Array]:
    """Return how much faster a bat is swung, and the speed at which it would send the ball off as fast.

    Near there the exit speed goes with the bat speed as it does for the bats as described.
    """
    swung, change = values[f"bats.{index}.bat_speed_m_s"], values[f"bats.{index}.change_m_s"]
    columns = {f"bats.{index}.swung_faster_m_s": swung - values["bats.0.bat_speed_m_s"]}
    apart = one.bat_speed.value - one.break_even
    if np.isfinite(apart):
        slope = one.change.value / apart if abs(apart) > LEAST_APART else 1 + one.collision_efficiency
        needed = swung - change / slope
        columns[f"bats.{index}.break_even_bat_speed_m_s"] = one.break_even + needed - needed[0]
    return columns


def _change_along(
    comparison: Comparison[Implement], index: int, values: dict[str, Array], longest: float
) -> dict[str, Array]:
    """Return by how much the ball leaves faster than from the first, equally far from the tip, shape (draws, scan)."""
    first, own = comparison.compared[0].analysis, comparison.compared[index].analysis
    places = own.scan.position + longest - own.bat.length
    there = first.scan.position + longest - first.bat.length
    known = [np.interp(places, there, row, left=np.nan, right=np.nan) for row in values[f"bats.0.{ALONG}"]]
    return {f"bats.{index}.{CHANGE_ALONG}": values[f"bats.{index}.{ALONG}"] - np.array(known)}


def names_of_bats(comparison: Comparison[Implement]) -> tuple[str, ...]:
    """Return what every bat's own doubt is called: the bat's name, with its number where two are named alike."""
    labels = [one.label for one in comparison.compared]
    return tuple(
        label if labels.count(label) == 1 else f"{label} (number {number})" for number, label in enumerate(labels, 1)
    )


def with_intervals(comparison: Comparison[Implement], reaches: Reaches) -> Comparison[Implement]:
    """Return a comparison with intervals of all that is not known, in place of the swing law's exponent alone."""

    def told(interval: Interval, name: str) -> Interval:
        reach = reaches[name]
        return Interval(interval.value, interval.value - float(reach.below), interval.value + float(reach.above))

    return replace(comparison, compared=tuple(
        replace(
            one, bat_speed=told(one.bat_speed, f"bats.{index}.bat_speed_m_s"),
            exit_speed=told(one.exit_speed, f"bats.{index}.exit_speed_m_s"),
            change=told(one.change, f"bats.{index}.change_m_s"),
        )
        for index, one in enumerate(comparison.compared)
    ))  # fmt: skip


def _of_law(law: SwingLaw | None) -> tuple[Source, ...]:
    return () if law is None else (Source(LAW, law.exponent_spread, f"spread of the exponent of {law.name}"),)


def _ratios(law: SwingLaw, draws: Draws, reference: Draws, power: Array) -> Array:
    """Return every draw's omega against the reference's, over that of the bats as described."""
    own, known = (one.moi(one.line.bat.choke + law.axis) for one in (draws, reference))
    ratios = [
        law.speed_ratio(float(moi), reference_moi=float(before), exponent=float(exponent))
        for moi, before, exponent in zip(own, known, power, strict=True)
    ]
    return np.array(ratios) / ratios[0]


def _of_bat(draws: Draws, index: int, analysis: Analysis[Implement]) -> dict[str, Array]:
    """Return what is told of one bat."""
    scan = analysis.scan
    barrel = scan.position[scan.position > analysis.body.balance_point]
    nearer = np.linspace(min(SHOWN_FROM * analysis.bat.length, barrel[0]), barrel[0], NEARER, endpoint=False)
    along = hits_along(draws, np.concatenate([nearer, np.linspace(barrel[0], barrel[-1], PLACES)]))
    body = draws.bats.bending
    off = [np.interp(scan.position, along.position, row, left=np.nan) for row in along.exit_speed - along.exit_speed[0]]
    columns = {
        "bat_speed_m_s": draws.bat_speed,
        "exit_speed_m_s": _peaks(along.exit_speed[:, NEARER:]), "max_bbcor": _peaks(along.bbcor[:, NEARER:]),
        "max_collision_efficiency": _peaks(along.collision_efficiency[:, NEARER:]),
        "bat.mass_kg": body.mass, "bat.balance_point_m": body.balance_point,
        "bat.moi_6in_kg_m2": body.moi(STANDARD_AXIS), ALONG: scan.exit_speed + np.array(off),
    }  # fmt: skip
    if draws.sources.unknowns:
        columns["bending_1_hz"] = draws.bats.angular_frequency[:, 2] / (2 * np.pi)
    else:
        columns = {name: value for name, value in columns.items() if not name.startswith("bat.")}
    return {f"bats.{index}.{name}": value for name, value in columns.items()}


def _peaks(curves: Array) -> Array:
    return np.array([peak(curve) for curve in curves])

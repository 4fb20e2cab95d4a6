"""A comparison of many bats that may be meant, all hit by the same balls with the same effort.

What is not known of ball, pitch and swing is the same for all bats of a draw and mostly cancels. Each bat has its own
doubt, but bats that were made from one piece share what is not known of it. The swing law's exponent is drawn too.
"""

from __future__ import annotations

from collections.abc import Callable, Hashable, Mapping, Sequence
from dataclasses import dataclass, replace
from types import MappingProxyType

import numpy as np
from numpy.typing import ArrayLike

from sweetspot.analysis.comparison import Compared, Comparison
from sweetspot.equipment.implement import Implement
from sweetspot.motion.swing_law import GREATEST_EXPONENT, SwingLaw
from sweetspot.numerics.arrays import Array
from sweetspot.numerics.interpolants import on_parabola, peak
from sweetspot.uncertainty.drawn_hits import Draws, draws_of, hits_along
from sweetspot.uncertainty.sources import DRAWS, Source, Sources, even_normal, one_by_one
from sweetspot.uncertainty.worth_measuring import Narrowing, narrowings

PLACES = 41
NEARER, SHOWN_FROM = 6, 0.6
"""Places nearer the hands, from this part of the length on, that are hit for the curves alone."""
LAW = "swing law"
AMOUNT = "how far {label} was changed"
EVEN = 3**-0.5
"""Standard deviation of what is spread evenly from -1 to 1."""
Ends = Mapping[int, tuple[Compared[Implement], Compared[Implement]]]
"""By number of a bat: the same at both ends of what cannot be known of how it was changed."""
LEAST_APART = 0.05
"""m/s of bat speed from which on two exit speeds tell how one goes with the other."""


@dataclass(frozen=True)
class DrawnBat:
    """What draws answer to one bat of a comparison, arrays of shape (draws,); the first draw is as described.

    Parameters
    ----------
    swung_faster, change : bat speed and exit speed against the first bat's, m/s.
    break_even : m/s of bat speed at which it sends the ball off as fast; None for the first bat, or where none would.
    bending_1 : the lowest tone in Hz; None where nothing of the bat is open.
    exit_speed_along, change_along : m/s along the bat's own scan, shape (draws, n); nan where nothing was hit.
    """

    draws: Draws
    bat_speed: Array
    exit_speed: Array
    swung_faster: Array
    change: Array
    break_even: Array | None
    max_collision_efficiency: Array
    max_bbcor: Array
    bending_1: Array | None
    exit_speed_along: Array
    change_along: Array


@dataclass(frozen=True)
class DrawnComparison:
    """What draws answer to a comparison.

    ``normal``: standard normal numbers behind every draw, shape (draws, n); the first row is 0. ``names``: of the
    source of each, shape (n,).
    """

    normal: Array
    names: tuple[str, ...]
    bats: tuple[DrawnBat, ...]


def drawn_comparison(
    comparison: Comparison[Implement],
    sources: Sequence[Sources],
    *,
    count: int = DRAWS,
    normal: Array | None = None,
    ends: Ends = MappingProxyType({}),
) -> DrawnComparison:
    """Return the answers of draws to a comparison.

    ``sources``: of every bat; those that are not a bat's are taken from the first. ``normal``: standard normal numbers
    to draw by, shape (count, n) with a column for each of `drawn_names`; None: Sobol's sequence. ``ends``: see `Ends`;
    between them the amount of a change is spread evenly.
    """
    first, law = sources[0], comparison.law
    behind = {number: column for column, number in enumerate(_behind(comparison, sources))}
    names = drawn_names(comparison, sources, ends)
    if normal is None:
        normal = even_normal(count, len(names))  # of one sequence: two of them go together, whatever their seeds
    count = len(normal)
    of_bats, shared, amounts = np.split(normal, [len(behind), len(names) - len(ends)], axis=1)
    part = np.vstack([np.zeros((1, len(ends))), np.clip(EVEN * amounts, -1.0, 1.0)])
    power = np.zeros(count + 1)
    if law is not None:
        power[1:] = law.exponent_spread * shared[:, -1]
        power = np.clip(law.exponent + power, 0.0, GREATEST_EXPONENT)
    of_others = shared[:, : len(first.others)]
    bats: list[DrawnBat] = []
    for compared, its_sources in zip(comparison.compared, sources, strict=True):
        joint = Sources(its_sources.doubt, first.others)
        analysis = compared.analysis
        drawn = np.hstack([of_bats[:, [behind[number] for number in its_sources.doubt.behind]], of_others])
        draws = draws_of(analysis.beam, analysis.conditions, joint, count=count, normal=drawn)
        if bats and law is not None:
            reference = bats[0].draws
            draws = draws.swung(reference.bat_speed / reference.bat_speed[0] * _ratios(law, draws, reference, power))
        bats.append(_drawn_bat(compared, draws, comparison.reference, bats[0] if bats else None))
    for column, (number, both) in enumerate(ends.items()):
        bats[number] = _changed_as_far(bats[number], comparison.compared[number], both, part[:, column])
    return DrawnComparison(np.vstack([np.zeros((1, normal.shape[1])), normal]), names, tuple(bats))


def _drawn_bat(
    compared: Compared[Implement], draws: Draws, reference: Compared[Implement], first: DrawnBat | None
) -> DrawnBat:
    """Return the sampled answers for one bat."""
    scan, length = compared.analysis.scan, compared.analysis.bat.length
    barrel = scan.position[scan.position > compared.analysis.body.balance_point]
    nearer = np.linspace(min(SHOWN_FROM * length, barrel[0]), barrel[0], NEARER, endpoint=False)
    along = hits_along(draws, np.concatenate([nearer, np.linspace(barrel[0], barrel[-1], PLACES)]))
    off = [np.interp(scan.position, along.position, row, left=np.nan) for row in along.exit_speed - along.exit_speed[0]]
    exit_speed, exit_speed_along = _peaks(along.exit_speed[:, NEARER:]), scan.exit_speed + np.array(off)
    change = exit_speed - (exit_speed if first is None else first.exit_speed)
    baseline = exit_speed_along
    if first is not None:  # equally far from the tip
        there, places = reference.analysis.scan.position, scan.position + (reference.analysis.bat.length - length)
        rows = [np.interp(places, there, row, left=np.nan, right=np.nan) for row in first.exit_speed_along]
        baseline = np.array(rows)
    return DrawnBat(
        draws,
        bat_speed=draws.bat_speed,
        exit_speed=exit_speed,
        swung_faster=draws.bat_speed - (draws if first is None else first.draws).bat_speed,
        change=change,
        break_even=None if first is None else _break_even(compared, draws.bat_speed, change),
        max_collision_efficiency=_peaks(along.collision_efficiency[:, NEARER:]),
        max_bbcor=_peaks(along.bbcor[:, NEARER:]),
        bending_1=draws.bats.angular_frequency[:, 2] / (2 * np.pi) if draws.sources.unknowns else None,
        exit_speed_along=exit_speed_along,
        change_along=exit_speed_along - baseline,
    )


def _changed_as_far(
    bat: DrawnBat, middle: Compared[Implement], both: tuple[Compared[Implement], Compared[Implement]], part: Array
) -> DrawnBat:
    """Return a bat's answers where its change went as far as drawn: -1 to the low end, 1 to the high one."""
    places = middle.analysis.scan.position

    def moved(values: Array, answer: Callable[[Compared[Implement]], ArrayLike]) -> Array:
        low, here, high = (np.asarray(answer(each), float) for each in (both[0], middle, both[1]))
        size = part.reshape(-1, *(1,) * here.ndim)
        return np.asarray(values - here + on_parabola(size, low, here, high))

    def along(each: Compared[Implement]) -> Array:
        return np.asarray(np.interp(places, each.analysis.scan.position, each.analysis.scan.exit_speed))

    return replace(
        bat,
        bat_speed=moved(bat.bat_speed, lambda each: each.bat_speed.value),
        exit_speed=moved(bat.exit_speed, lambda each: each.exit_speed.value),
        swung_faster=moved(bat.swung_faster, lambda each: each.bat_speed.value),
        change=moved(bat.change, lambda each: each.change.value),
        max_collision_efficiency=moved(bat.max_collision_efficiency, lambda each: each.collision_efficiency),
        max_bbcor=moved(bat.max_bbcor, lambda each: each.bbcor),
        exit_speed_along=moved(bat.exit_speed_along, along),
        change_along=moved(bat.change_along, along),
    )


def drawn_names(
    comparison: Comparison[Implement], sources: Sequence[Sources], ends: Ends = MappingProxyType({})
) -> tuple[str, ...]:
    """Return the name of the source of every column of a draw: of the bats, of what they share, of their changes."""
    names_behind, law = _behind(comparison, sources).values(), comparison.law
    of_law = () if law is None else (Source(LAW, law.exponent_spread, f"spread of the exponent of {law.name}"),)
    of_changes = (AMOUNT.format(label=comparison.compared[number].label) for number in ends)
    return (*names_behind, *(source.name for source in (*sources[0].others, *of_law)), *of_changes)


def _behind(comparison: Comparison[Implement], sources: Sequence[Sources]) -> dict[Hashable, str]:
    """Return the owner of every number behind the bats' deviations, with the name of the first bat that it affects."""
    called: dict[Hashable, str] = {}
    for label, source in zip(names_of_bats(comparison), sources, strict=True):
        called |= {number: label for number in source.doubt.behind if number not in called}
    return called


def _break_even(compared: Compared[Implement], bat_speed: Array, change: Array) -> Array | None:
    """Return the bat speed at which a bat would send the ball off as fast as the first; None where none would.

    Near there the exit speed goes with the bat speed as it does for the bats as described.
    """
    apart = compared.bat_speed.value - compared.break_even
    if not np.isfinite(apart):
        return None
    slope = compared.change.value / apart if abs(apart) > LEAST_APART else 1 + compared.collision_efficiency
    needed = bat_speed - change / slope
    return np.asarray(compared.break_even + needed - needed[0])


def names_of_bats(comparison: Comparison[Implement]) -> tuple[str, ...]:
    """Return the name of every bat's own uncertainty: the bat's, with its number where two bats share a name."""
    labels = [bat.label for bat in comparison.compared]
    return tuple(
        label if labels.count(label) == 1 else f"{label} (number {number})" for number, label in enumerate(labels, 1)
    )


def _ratios(law: SwingLaw, draws: Draws, reference: Draws, power: Array) -> Array:
    """Return every draw's omega against the reference's, over that of the bats as described."""
    mois, of_reference = (each.moi(each.beam.bat.choke + law.axis) for each in (draws, reference))
    ratios = [
        law.speed_ratio(float(moi), reference_moi=float(reference_moi), exponent=float(exponent))
        for moi, reference_moi, exponent in zip(mois, of_reference, power, strict=True)
    ]
    return np.array(ratios) / ratios[0]


def _peaks(curves: Array) -> Array:
    return np.array([peak(curve) for curve in curves])


def linear_comparison(
    comparison: Comparison[Implement], sources: Sequence[Sources], ends: Ends = MappingProxyType({})
) -> DrawnComparison:
    """Return the answers to a comparison with one source off at a time; `linear_reach` makes intervals of them."""
    count = len(drawn_names(comparison, sources, ends))
    return drawn_comparison(comparison, sources, normal=one_by_one(count), ends=ends)


def narrowings_of_changes(
    drawn: DrawnComparison, comparison: Comparison[Implement], sources: Sequence[Sources]
) -> list[tuple[Narrowing, ...]]:
    """Return the measurements on each implement and the first that make the change between them surer.

    ``drawn``: see `linear_comparison`. Nothing stands for the first one.
    """
    behind = tuple(_behind(comparison, sources))
    found: list[tuple[Narrowing, ...]] = [()]
    for number, bat in enumerate(drawn.bats[1:], start=1):
        up, down = np.split(bat.change[1:], 2)
        slopes = (up - down) / 2
        pair = [(comparison.compared[which].analysis.bat, sources[which].doubt) for which in (0, number)]
        others = float(np.linalg.norm(slopes[len(behind) :]))
        found.append(narrowings(pair, dict(zip(behind, slopes.tolist(), strict=False)), others=others))
    return found

"""Which mode makes which tone: by the ratios of the frequencies, and by the place of the tap.

The modes of a family are known up to one stiffness, which scales all its frequencies alike. Every tone is tried as
every mode; the best scale is the one that leaves the least unexplained: tones off their mode, loud tones without a
mode, and modes that the tap must have excited without a tone. A mode with a node at the place of the tap may be silent,
so a bat tapped at the node of mode 1 is not named one mode too low.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Literal

import numpy as np

from sweetspot.calibration.taps import Tone
from sweetspot.dynamics.modes import Family, Modes
from sweetspot.numerics.arrays import Array

STIFFNESS_SPREAD = 0.12
"""One sigma of the logarithm of a family's scale (assumed): 25 % of the modulus, and a few per cent of the outline."""
RATIO_SPREAD = 0.05
"""One sigma of a frequency's logarithm against its family's scale (assumed): outline and shear are not exact. Of 60
made-up bats and implements described by others of their kind, 5 % gave fewer wrong names and more right ones than 3."""
FINE_SPREAD = 0.02
"""The same of a bat that is described well, as the agreement of its own bending tones shows (assumed)."""
BAR_RATIO_SPREAD = 0.03
"""The same of a uniform bar (assumed): its ratios are known but for E/G."""
FARTHEST, CLOSE = 3.0, 1.0
"""A tone whose logarithm is more ratio spreads away from a mode is not it; only nearer ones are tried too, for a tone
far from a mode may belong to another family."""
SILENT = 0.15
"""Part of its greatest excitation below which a mode need not be heard."""
UNHEARD, UNEXPLAINED = 6.0, 3.0
"""Costs of a mode without a tone and of a loud tone without a mode, in units of chi squared."""
MOST_BENDING = 5
"""Bending modes that are named and compared; higher ones depend on shear, knots and grain."""
DOUBT = 4.0
"""Additional cost of another name, in units of chi squared, below which a tone has no name."""
STRAY = 4.0
"""Additional cost of a tone off by the usual spread where the others agree to the fine one, units of chi squared."""
LOUD = 0.1
"""Level of a tone that wants to be explained, unless the room may have added it."""
BAR_SPREAD = 0.6
"""One sigma of the logarithm of a bar's first frequency before it is tapped: that of sqrt(E / rho), see `bar.SPEED`."""
VAGUE = 0.5
"""Spread of a family's scale from which on no expected frequency is reported."""
ANY_BAT = (175.0, 580.0, 1180.0, 1900.0)
"""Hz, bending modes of bats: f2 / f1 is 2.7 to 4.1 and f3 / f1 5.1 to 9.5 over the catalogue's bats."""
ANY_SPREAD, ANY_RATIO_SPREAD = 0.25, 0.09
"""One sigma of the logarithms of their common scale and of each."""


@dataclass(frozen=True)
class ModeName:
    """Family and number of a mode; a bar bends sideways and twists too.

    ``order``: among the modes of this family and number, lowest first: a barrel has several hoop modes of one n.
    """

    family: Family | Literal["sideways", "torsion"]
    harmonic: int
    order: int = 1

    @property
    def can_be_named(self) -> bool:
        """Whether a tone may have this name; other modes only take part in the naming."""
        return self.harmonic <= MOST_BENDING and self.order == 1

    def __str__(self) -> str:
        return f"hoop n = {self.harmonic}" if self.family == "hoop" else f"{self.family} {self.harmonic}"


@dataclass(frozen=True)
class ModeFamily:
    """The expected frequencies of a family of modes.

    Parameters
    ----------
    names, frequency : of the modes, Hz, increasing.
    excitation : how strongly the tap moves each, over its greatest; 1 where the place is not known.
    spread : one sigma of the logarithm of the common scale; from `VAGUE` on no expected frequency is reported.
    ratio_spread : one sigma of every frequency's logarithm against the scale.
    farthest : logarithms between which the common scale lies; None: `FARTHEST` spreads on both sides.
    fine_spread : what ``ratio_spread`` is where the tones agree so well; None: it is known.
    """

    names: tuple[ModeName, ...]
    frequency: Array
    excitation: Array
    spread: float
    ratio_spread: float = RATIO_SPREAD
    farthest: tuple[float, float] | None = None
    fine_spread: float | None = None


@dataclass(frozen=True)
class NamedTone:
    """A tone and the mode that makes it, if any is known.

    ``name``: None where no mode explains it. ``expected``: Hz, of the mode as described; None where there is none.
    ``rivals``: modes that explain it about as well; none where one does best.
    """

    tone: Tone
    name: ModeName | None
    expected: float | None
    rivals: tuple[ModeName, ...] = ()


def expected_of(modes: Modes, family: Family, *, positions: Sequence[float]) -> ModeFamily:
    """Return the expected frequencies of a family of modes, tapped at places in m (none: anywhere)."""
    chosen = modes.of_family(family)
    shapes = np.abs(modes.shape_at(np.linspace(0, modes.shapes.ends[-1], 201))[:, chosen])
    excitation = np.ones(len(chosen))
    if positions:
        excitation = np.abs(modes.shape_at(np.array(positions))[:, chosen]).max(axis=0) / shapes.max(axis=0)
    harmonics = [modes.harmonics[index] for index in chosen]
    orders = [harmonics[: index + 1].count(number) for index, number in enumerate(harmonics)]
    names = tuple(ModeName(family, number, order) for number, order in zip(harmonics, orders, strict=True))
    fine = FINE_SPREAD if family == "bending" else None  # tones of one wall tell little of how well it is described
    return ModeFamily(names, modes.frequency[chosen], excitation, STIFFNESS_SPREAD, fine_spread=fine)


def uniform_bar(
    tones: Sequence[float],
    *,
    sideways: Sequence[float] = (),
    twist: Sequence[float] = (),
    farthest: tuple[float, float] | None = None,
) -> list[ModeFamily]:
    """Return the modes of a uniform bar, of which hardly more than the ratios is known.

    A tap across the thickness need not move those that bend it sideways, which share E, and those that twist it.

    ``tones``, ``sideways``, ``twist``: Hz, were it of a usual material. ``farthest``: logarithms between which sound's
    speed along it lies, over that of the usual material.
    """
    across = [ModeName("bending", number + 1) for number in range(len(tones))]
    beside = [ModeName("sideways", number + 1) for number in range(len(sideways))]
    heard = np.repeat([1.0, 0.0], [len(tones), len(sideways)])
    order = np.argsort(frequency := np.array([*tones, *sideways]))
    names = tuple([*across, *beside][index] for index in order)
    families = [ModeFamily(names, frequency[order], heard[order], BAR_SPREAD, RATIO_SPREAD, farthest)]
    if len(twist):
        turned = tuple(ModeName("torsion", number + 1) for number in range(len(twist)))
        families.append(ModeFamily(turned, np.array(twist), np.zeros(len(twist)), BAR_SPREAD, BAR_RATIO_SPREAD))
    return families


def any_bat() -> ModeFamily:
    """Return the bending modes of bats in general."""
    names = tuple(ModeName("bending", number + 1) for number in range(len(ANY_BAT)))
    return ModeFamily(names, np.array(ANY_BAT), np.ones(len(ANY_BAT)), ANY_SPREAD, ANY_RATIO_SPREAD)


def named(tones: Sequence[Tone], families: Sequence[ModeFamily], *, doubt: float = DOUBT) -> tuple[NamedTone, ...]:
    """Return the tones with their modes: the assignment of all families together that leaves the least unexplained.

    A tone that another assignment, less than ``doubt`` worse, gives to another mode has no name. Where even the best
    leaves more than 1 a tone unexplained, the modes are not those described, and ``doubt`` grows with it.

    ``doubt``: in units of chi squared; 0 names every tone by the best assignment.
    """
    doubt *= max(1.0, misfit(tones, families))
    near = _assignments(tones, frozenset(range(len(tones))), tuple(families), 0.0, doubt)
    _, modes = min(near, key=lambda entry: entry[0])
    result = []
    for index, tone in enumerate(tones):
        ways = {other[index][0].names[other[index][1]] for _, other in near if index in other}
        ways |= set(_exchanged(tones, modes, index, doubt))
        if index not in modes or len(ways) > 1 or not all(name.can_be_named for name in ways):
            result.append(NamedTone(tone, None, None, tuple(sorted(ways, key=str)) if len(ways) > 1 else ()))
            continue
        family, mode = modes[index]
        expected = float(family.frequency[mode]) if family.spread < VAGUE else None
        result.append(NamedTone(tone, family.names[mode], expected))
    return tuple(result)


def misfit(tones: Sequence[Tone], families: Sequence[ModeFamily]) -> float:
    """Return the misfit per tone of the best assignment, in units of chi squared.

    Of the catalogue's bats and implements described as what they are it is less than 0, as others of their material
    mostly less than 2, and as others of another 1.5 to 6.
    """
    least = _assignments(tones, frozenset(range(len(tones))), tuple(families), 0.0, 0.0)
    return least[0][0] / max(len(tones), 1)


def _exchanged(tones: Sequence[Tone], modes: Assignment, index: int, doubt: float) -> Iterator[ModeName]:
    """Yield the modes of other families with whose tones a tone may be exchanged at a cost of less than ``doubt``.

    In one family the order of tones is known.
    """
    if index not in modes:
        return
    for other, (family, mode) in modes.items():
        if family is not modes[index][0]:
            changed = modes | {index: modes[other], other: modes[index]}
            both = (family, modes[index][0])
            if sum(_cost_in(tones, family, changed) - _cost_in(tones, family, modes) for family in both) < doubt:
                yield family.names[mode]


def _cost_in(tones: Sequence[Tone], family: ModeFamily, modes: Assignment) -> float:
    """Return the cost of a family in an assignment."""
    pairs = {tone: mode for tone, (other, mode) in modes.items() if other is family}
    return _cost(tones, family, _common_scale(tones, family, pairs), pairs)


def wants_a_mode(tone: Tone) -> bool:
    """Return whether a tone must have a mode: it is loud, and surely the body's and not the room's."""
    return tone.level > LOUD and tone.distinct


Assignment = dict[int, tuple[ModeFamily, int]]


def _assignments(
    tones: Sequence[Tone], free: frozenset[int], families: tuple[ModeFamily, ...], top: float, doubt: float
) -> list[tuple[float, Assignment]]:
    """Return cost and {tone: (family, mode)} of naming the free tones after these families, ``doubt`` off the least.

    ``top`` is the highest frequency in Hz that the families before could explain.
    """
    if not families:
        loud = (tones[index] for index in free if wants_a_mode(tones[index]))
        return [(UNEXPLAINED * sum(tone.frequency.value < top for tone in loud), {})]
    family, rest = families[0], families[1:]
    scales = {
        round(math.log(tones[index].frequency.value / frequency), 3) for index in free for frequency in family.frequency
    }
    tried: dict[frozenset[tuple[int, int]], float] = {frozenset(): 0.0}
    lowest, highest_scale = family.farthest or (-FARTHEST * family.spread, FARTHEST * family.spread)
    for scale in scales:
        if lowest < scale < highest_scale:
            for reach in (FARTHEST, CLOSE):
                pairs = _pairs(tones, free, family, scale, reach)
                tried[frozenset(pairs.items())] = _common_scale(tones, family, pairs)
    costs = sorted((_cost(tones, family, scale, dict(items)), scale, tuple(items)) for items, scale in tried.items())
    found: list[tuple[float, Assignment]] = []
    least = math.inf
    for cost, scale, items in costs:
        if cost > least + doubt:  # what the other families leave unexplained only adds to it
            break
        highest = max(top, family.frequency[-1] * math.exp(scale)) if items else top or math.inf
        for more, others in _assignments(tones, free - {tone for tone, _ in items}, rest, highest, doubt):
            found.append((cost + more, others | {tone: (family, mode) for tone, mode in items}))
            least = min(least, cost + more)
    return [(cost, modes) for cost, modes in found if cost <= least + doubt]


def _pairs(
    tones: Sequence[Tone], free: frozenset[int], family: ModeFamily, scale: float, reach: float
) -> dict[int, int]:
    """Return {tone: mode}: for every mode the nearest free tone within ``reach``, of two as near the stronger."""
    pairs: dict[int, int] = {}
    for mode, frequency in enumerate(family.frequency):
        off = {index: abs(math.log(tones[index].frequency.value / frequency) - scale) for index in free - set(pairs)}
        near = [index for index, miss in off.items() if miss < reach * family.ratio_spread]
        if near:
            worth = {
                index: math.log(tones[index].strength) - (off[index] / family.ratio_spread) ** 2 / 2 for index in near
            }
            pairs[max(near, key=lambda index: worth[index])] = mode
    return pairs


def _common_scale(tones: Sequence[Tone], family: ModeFamily, pairs: dict[int, int]) -> float:
    logs = [math.log(tones[tone].frequency.value / family.frequency[mode]) for tone, mode in pairs.items()]
    pull = (family.ratio_spread / family.spread) ** 2  # of the expected scale
    return sum(logs) / (len(logs) + pull) if logs else 0.0


def _cost(tones: Sequence[Tone], family: ModeFamily, scale: float, pairs: dict[int, int]) -> float:
    """Return the total cost of tones off their mode and of modes that must ring but do not."""
    cost = (scale / family.spread) ** 2 + _misfit(tones, family, scale, pairs)
    highest = max((tone.frequency.value for tone in tones), default=0.0)
    unheard = sum(
        family.excitation[mode] > SILENT and frequency * math.exp(scale) < highest and mode not in pairs.values()
        for mode, frequency in enumerate(family.frequency)
    )
    return cost + UNHEARD * int(unheard)


def _misfit(tones: Sequence[Tone], family: ModeFamily, scale: float, pairs: dict[int, int]) -> float:
    """Return the total cost of tones off their mode, at the likelier of the ratio spreads s that a family may have.

    sum (miss / s)^2 + 2 n ln s, over that of the usual one. A bat may be described well but for a tone or two: each of
    them then costs `STRAY` beside what it is off by the usual spread.
    """
    misses = np.array(
        [math.log(tones[tone].frequency.value / family.frequency[mode]) - scale for tone, mode in pairs.items()]
    )
    usual = (misses / family.ratio_spread) ** 2
    if family.fine_spread is None:
        return float(usual.sum())
    fine = (misses / family.fine_spread) ** 2 + 2 * math.log(family.fine_spread / family.ratio_spread)
    return float(min(usual.sum(), np.minimum(fine, usual + STRAY).sum()))

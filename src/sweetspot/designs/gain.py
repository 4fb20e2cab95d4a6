"""Whether a gain can be seen: beside differences of wood and doubts about the batter, and its cost at the handle."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass, replace
from enum import StrEnum
from functools import lru_cache
from itertools import chain

import numpy as np
from numpy.typing import NDArray

from sweetspot.analysis.strain import Damage, damage
from sweetspot.collision.coupled import hit
from sweetspot.designs.batter import FROM_TIP, usual_places
from sweetspot.designs.durability import Handles, strain_limits_of
from sweetspot.designs.measures import Bench, MeasuredDesigns
from sweetspot.designs.spaces import willow_variants
from sweetspot.designs.turned import TurnedSpace, knob_of
from sweetspot.designs.variables import DENSITY_SPREAD, MODULUS_SPREAD, ImplementSpace, ranges, sizes_of
from sweetspot.dynamics.batch.beams import BeamRow
from sweetspot.dynamics.batch.reduction import ReducedBats, reduced_beams, reduced_outlines
from sweetspot.dynamics.beam import beam_model
from sweetspot.equipment.ball import Ball
from sweetspot.equipment.bat import Bat
from sweetspot.equipment.cricket_bat import CricketBat
from sweetspot.equipment.implement import Implement
from sweetspot.numerics.arrays import Array
from sweetspot.numerics.interval import REACH
from sweetspot.units import INCH, MPH

TURNED_ALIKE = 0.02
"""Standard deviation, as a part, of every number of one of a model that is not turned from wood (assumed)."""
SHIPMENT = 2 * MPH
"""m/s by which the best and the worst of a dozen bats of one model differ, as a grading service reports (recalled)."""
PAIR = math.sqrt(2) * SHIPMENT / 3.258
"""m/s, standard deviation between two of them: the range of twelve normal draws is 3.258 of theirs on average."""
CLEARLY, LIKELY = 2.5758, 1.2816
"""Standard deviations above which a gain, or loss, is seen, and likely: 99.5 and 90 % of a normal doubt lie below."""
TOWARDS_END = 2 * INCH
"""m from the tip, where the loss of a hit nearer the tip is reported."""


PRIOR_BALLS = 3.5
"""Balls that what is known of all players is worth: the variance of a usual scatter over that of players' means."""


class GainVerdict(StrEnum):
    """The verdict on a gain, beside the effects that could hide it."""

    SEEN = "a gain that you could see"
    LIKELY = "likely a gain, yet too small to see"
    HIDDEN = "no gain that you could see"
    LIKELY_LOSS = "likely a loss, yet too small to see"
    LOSS = "a loss that you could see"


@dataclass(frozen=True)
class Gain:
    """A design beside the present bat, in this batter's hands.

    Parameters
    ----------
    shift : m by which the best place moves towards the hands.
    wider : m by which the zone within 3 mph of the best grows.
    greatest : m/s by which the greatest exit speed grows.
    expected : m/s by which the exit speed over this batter's contacts grows.
    wood, law, contact : standard deviations of ``expected`` in m/s: from two pieces of one model (of wood, where they
        are turned), from how this batter's swing depends on the bat, from where the ball is met on average.
    by_weight : the part of ``wood`` that is left when the wood is chosen by weight.
    shipment : standard deviation between two of a dozen as is reported, m/s; 0: nothing is.
    sample : standard deviation of ``expected`` in m/s from how few balls tell of the contacts; 0: none do.
    curve : change of the exit speed at `FROM_TIP`, m/s.
    noise : standard deviation of that change from two pieces of wood, m/s, shape of ``curve``.
    time : s by which the time to contact grows.
    """

    shift: float
    wider: float
    greatest: float
    expected: float
    wood: float
    law: float
    contact: float
    by_weight: float
    curve: Array
    noise: Array
    time: float
    shipment: float = 0.0
    sample: float = 0.0
    balls: float = 0.0

    @property
    def pieces(self) -> float:
        """Standard deviation between two of one model, m/s: ours, or that of a shipment where it is larger."""
        return max(self.wood, self.shipment)

    @property
    def spread(self) -> float:
        """Standard deviation of ``expected``, m/s."""
        return math.hypot(self.pieces, self.law, self.contact, self.sample)

    @property
    def doubt(self) -> float:
        """Half of the 90 % interval of ``expected``, m/s."""
        return REACH * self.spread

    @property
    def odds(self) -> float:
        """Probability that the design is the faster one of two such bats in this batter's hands."""
        if self.spread == 0:
            return 0.5 if self.expected == 0 else float(self.expected > 0)
        return 0.5 * (1 + math.erf(self.expected / self.spread / math.sqrt(2)))

    @property
    def verdict(self) -> GainVerdict:
        """The verdict on the gain: seen only where the interval clearly excludes zero; a loss alike."""
        size = abs(self.expected)
        if size > CLEARLY * self.spread:
            return GainVerdict.SEEN if self.expected > 0 else GainVerdict.LOSS
        if size > LIKELY * self.spread:
            return GainVerdict.LIKELY if self.expected > 0 else GainVerdict.LIKELY_LOSS
        return GainVerdict.HIDDEN

    @property
    def balls_needed(self) -> int | None:
        """From how many balls such a gain would be seen, were they all met as these; None: never, or it is seen.

        What balls leave open falls with the square root of their number, those that the league's prior is worth
        (`PRIOR_BALLS`) among them.
        """
        room = (self.expected / CLEARLY) ** 2 - math.hypot(self.pieces, self.law, self.contact) ** 2
        if self.sample == 0 or self.expected <= 0 or room <= 0 or self.verdict is GainVerdict.SEEN:
            return None
        return math.ceil(self.sample**2 * (self.balls + PRIOR_BALLS) / room - PRIOR_BALLS)

    @property
    def turning_place(self) -> float | None:
        """Where gain turns into loss, m from the tip: nearer the tip the present bat is better; None: nowhere."""
        outer = np.flatnonzero(self.curve[: math.ceil(len(self.curve) / 2)] < 0)
        if len(outer) == 0 or self.curve[outer[-1] + 1] < 0:
            return None
        i = int(outer[-1])
        part = self.curve[i] / (self.curve[i] - self.curve[i + 1])
        return float(FROM_TIP[i] + part * (FROM_TIP[i + 1] - FROM_TIP[i]))

    def at(self, from_tip: float) -> float:
        """Return the change of exit speed at a place, m/s."""
        return float(np.interp(from_tip, FROM_TIP, self.curve))


def present_measured(bench: Bench) -> MeasuredDesigns:
    """Return the batter's present bat, as it is described and not as the handles have it, on the same bench."""
    present = bench.space.present
    beams, bats = _reduced(present, bench.conditions.ball)
    breaking = bench.breaking
    if breaking is not None and isinstance(present, Bat):
        breaking = strain_limits_of(present, bench.batter)  # of its own material
        bench = replace(bench, breaking=breaking)
    handles = None if breaking is None else Handles(beams, present.width_at(breaking.position)[None])
    return bench.of_bats(bats, present.width_at(present.length - FROM_TIP)[None], shapes=_sizes(bench), handles=handles)


@lru_cache(maxsize=32)
def _reduced(present: Implement, ball: Ball) -> tuple[BeamRow, ReducedBats]:
    """Return the present bat as a beam and ready to be hit, which no batter changes."""
    beams = BeamRow([beam_model(present)])
    return beams, reduced_beams(beams.beams, ball=ball)


def gain_of(bench: Bench, numbers: Array, design: MeasuredDesigns, now: MeasuredDesigns) -> Gain:
    """Return the gain of a design over the present bat, with its uncertainty.

    ``numbers``: of the design, shape (variables,). ``design``, ``now``: both measured, one row each.
    """
    weight, sample = bench.batter.weight, bench.batter.sample
    apart = design.worth[0] - now.worth[0]
    expected = float(apart @ weight)
    turned = isinstance(bench.space, TurnedSpace)
    curves, chosen = _wood(bench, numbers) if turned else _alike(bench, numbers)
    face = _on_face(bench)
    law = _over_the_law(bench, numbers)
    contact = [float(apart @ bench.batter.moved(way * bench.batter.doubt).weight) for way in (-1, 1)]
    return Gain(
        shift=float(design.values["best_from_tip"][0] - now.values["best_from_tip"][0]),
        wider=float(design.values["zone"][0] - now.values["zone"][0]),
        greatest=float(design.values["best"][0] - now.values["best"][0]),
        expected=expected,
        wood=float(np.sqrt(2) * np.sqrt(np.sum((curves @ weight) ** 2))),
        law=law,
        contact=abs(contact[1] - contact[0]) / 2,
        by_weight=float(np.sqrt(2) * np.sqrt(np.sum((chosen @ weight) ** 2))),
        curve=np.where(face, design.curve[0] - now.curve[0], 0.0),
        noise=np.where(face, np.sqrt(2 * np.sum(curves**2, axis=0)), 0.0),
        time=float(design.values["swing_time"][0] - now.values["swing_time"][0]),
        shipment=PAIR if turned else 0.0,
        sample=0.0 if sample is None else sample.doubt_of(apart),
        balls=0.0 if sample is None else sample.balls,
    )


def _sizes(bench: Bench) -> dict[str, Array]:
    """Return the sizes of the present bat's outline that are asked for again."""
    present = bench.space.present
    sizes = {name: np.array([size]) for name, size in sizes_of(present).items()}
    if isinstance(present, Bat):
        grip = np.linspace(0.04 * present.length, 0.36 * present.length, 60)
        sizes |= {
            "handle": np.array([float(present.diameter_at(grip).min())]),
            "cup_depth": np.array([0.0 if present.cup is None else present.cup.depth]),
            "cup_diameter": np.array([0.0 if present.cup is None else present.cup.diameter]),
            "knob": np.array([knob_of(present)]),
        }
    if isinstance(bench.space, TurnedSpace):
        sizes["density"] = bench.space.parts(bench.space.start[None])[2]
    return sizes


def _wood(bench: Bench, numbers: Array) -> tuple[Array, Array]:
    """Return changes of the exit speed, one standard deviation of density and of moduli each, shape (2, places).

    The second array is without what the weight would tell: the density as it was.
    """
    space = bench.space
    assert isinstance(space, TurnedSpace)
    rows = np.tile(numbers, (4, 1))
    density = [variable.name for variable in space.variables].index("density")
    rows[:2, density] *= [1 + DENSITY_SPREAD, 1 - DENSITY_SPREAD]
    stiffness = np.array([1.0, 1.0, 1 + MODULUS_SPREAD, 1 - MODULUS_SPREAD])
    bats = reduced_outlines(space.outlines(rows, stiffness=stiffness), ball=bench.conditions.ball)
    widths = space.widths_at(rows, bats.bending.length[:, None] - FROM_TIP)
    worth = bench.of_bats(bats, widths).worth
    changes = np.stack([(worth[0] - worth[1]) / 2, (worth[2] - worth[3]) / 2])
    return changes, np.stack([np.zeros(len(FROM_TIP)), changes[1]])


def _alike(bench: Bench, numbers: Array) -> tuple[Array, Array]:
    """Return changes of the exit speed, one standard deviation of every number each, and of willow's; see `_wood`.

    Nothing tells a piece by its weight here: both arrays, of shape (variables or more, places), are the same.
    """
    space = bench.space
    assert isinstance(space, ImplementSpace)
    count = len(numbers)
    steps = TURNED_ALIKE * np.diag(numbers)
    low, high = ranges(space.variables)
    more, less = np.clip(numbers + steps, low, high), np.clip(numbers - steps, low, high)  # what can be made
    made = space.all_made(np.concatenate([more, less]))
    pairs = list(zip(made[:count], made[count:], strict=True))
    if isinstance(space.present, CricketBat):
        pairs += willow_variants(space.change(space.present, numbers))
    every = list(chain(*zip(*pairs, strict=True)))
    bats = reduced_beams([beam_model(implement) for implement in every], ball=bench.conditions.ball)
    places = bats.bending.length[:, None] - FROM_TIP
    widths = np.array([implement.width_at(row) for implement, row in zip(every, places, strict=True)])
    worth = bench.of_bats(bats, widths).worth
    changes = (worth[: len(pairs)] - worth[len(pairs) :]) / 2
    changes[:count] *= (2 * np.diag(steps) / np.diag(more - less))[:, None]  # at the end of a range: its slope there
    return changes, changes


def _on_face(bench: Bench) -> NDArray[np.bool_]:
    """Return a mask of the places `FROM_TIP` that lie on the face; all do on a round bat."""
    present = bench.space.present
    face, places = present.outline, present.length - FROM_TIP
    if face is None:
        return np.ones(len(places), bool)
    return np.asarray((places >= face.start) & (places <= face.end))


def _over_the_law(bench: Bench, numbers: Array) -> float:
    """Return the standard deviation of the expected gain, m/s, for batters whose swings depend otherwise on the bat."""
    law = bench.batter.law
    if law is None:
        return 0.0
    gains = []
    for exponent in (law.exponents.low, law.exponents.high):
        other = replace(bench, batter=replace(bench.batter, law=replace(law, exponent=exponent)))
        design, now = other.measured(numbers), present_measured(other)
        gains.append(float((design.worth[0] - now.worth[0]) @ bench.batter.weight))
    return abs(gains[1] - gains[0]) / (2 * REACH)


@dataclass(frozen=True)
class HandleBending:
    """The greatest bending strain of a bat's handle over a batter's contacts; see `sweetspot.analysis.strain`.

    ``strain``: without a unit (0.01 is 1 %). ``from_tip``: where that ball was met, m from the tip. ``limit``: strength
    over modulus of the handle's material; None when its strength is not known.
    """

    strain: float
    from_tip: float
    limit: float | None


def strains_of_contacts(bench: Bench, bat: Bat) -> Iterator[tuple[float, Damage]]:
    """Yield every place where this batter usually meets the ball, m from the tip, and the strains of a hit there.

    The bat is swung as the swing law has it; one hit follows the other, by the readable collision.
    """
    beam = beam_model(bat)
    bats = reduced_beams([beam], ball=bench.conditions.ball)
    modes, turning = bats.modes(0), float(bench.turning_speed(bats)[0])
    for place in FROM_TIP[usual_places(bench.batter)].tolist():
        position = bat.length - place
        closing = bench.batter.pitch_speed + turning * (position - bench.conditions.swing.pivot)
        impact = hit(modes, ball=bench.conditions.ball, position=position, closing_speed=closing)
        yield place, damage(impact, beam=beam, modes=modes)


def handle_bending(bench: Bench, bat: Bat) -> HandleBending:
    """Return the largest bending of a bat's handle by this batter's hits, swung as the swing law has it."""
    bendings = [
        HandleBending(strains.handle_strain, place, strains.strain_limit)
        for place, strains in strains_of_contacts(bench, bat)
    ]
    return max(bendings, key=lambda bending: bending.strain)

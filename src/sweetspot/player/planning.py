"""Which swings would tell what is not known of a player: bats, how many swings with each, their order, when to stop.

Bat speed against moment of inertia I is v I^-n, so its logarithm is a straight line in x = ln I. Swings whose speeds
scatter by s and are measured to e, of which a part p are full ones, give the exponent n to

    1 / var(n) = 1 / tau^2 + p v^2 / (s^2 + e^2) sum (x - mean x)^2

with tau the spread between players. The sum is largest for the two bats that differ most, swung equally often. A mark
on the barrel, read to e, gives the mean place of contact, of scatter s, to 1 / var = 1 / tau^2 + count / (s^2 + e^2).
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import combinations
from typing import Literal

from sweetspot.dynamics.beam import beam_model
from sweetspot.dynamics.rigid import rigid_body
from sweetspot.equipment.bat import Bat
from sweetspot.errors import InputError
from sweetspot.motion.swing_law import SwingLaw
from sweetspot.numerics.interval import REACH
from sweetspot.player.prior import fixed, priors
from sweetspot.units import INCH, OUNCE

Aim = Literal["exponent", "position"]
"""What swings are to find: how much a heavier bat slows the player, or where the ball is met on average."""
LEADS = (2 * OUNCE, 4 * OUNCE, 6 * OUNCE)
"""kg of lead tape on the barrel that are tried where the bats at hand are too much alike."""
LEAD_FROM_TIP = 2 * INCH
"""m from the tip, the middle of the tape: on the barrel, past where the ball is met."""
FEW_PLANNED, MOST_PLANNED = 80, 200
"""Swings of a plan that is looked for, and the most that one may ask for: of two sessions, and of four. Our choice."""
BLOCK = 5
"""Swings in a row with one bat: few, so that a player who tires or warms up does so with all. Our choice."""


@dataclass(frozen=True)
class SwingScatter:
    """What is thought of a player before the swings.

    ``bat_speed``, ``bat_speed_spread``: m/s, mean and from swing to swing. ``position_spread``: m along the bat.
    """

    bat_speed: float
    bat_speed_spread: float
    position_spread: float

    @classmethod
    def usual(cls) -> SwingScatter:
        """Return the scatter that is usual for players."""
        return cls(*(priors()[name].centre for name in ("bat_speed", "bat_speed_spread", "position_spread")))

    def speed_variance(self) -> float:
        """Return the variance of the logarithm of one measured bat speed, larger for the part that are slow swings."""
        noisy = self.bat_speed_spread**2 + fixed("bat_speed_noise") ** 2
        return noisy / self.bat_speed**2 / (1 - fixed("slow_part"))

    def position_variance(self) -> float:
        """Return the variance of one marked place, m^2."""
        return self.position_spread**2 + fixed("position_noise") ** 2


@dataclass(frozen=True)
class SwingPlan:
    """Swings to make.

    ``bats``: to swing. ``each``: swings with each of them. ``expected_error``: half the width of the 90 % interval
    after them. ``enough``: whether that is within what was asked for. ``information``: of one swing with each, one over
    the square of the unit of the error.
    """

    aim: Aim
    bats: tuple[Bat, ...]
    each: int
    expected_error: float
    enough: bool
    information: float

    @property
    def order(self) -> tuple[Bat, ...]:
        """The bat of every swing: in blocks, A B B A, so that a player who tires does so with all alike."""
        return self.order_of(self.each * len(self.bats))

    def order_of(self, count: int) -> tuple[Bat, ...]:
        """Return the bat of every one of at least so many swings, as many with each bat, in blocks A B B A."""
        each = math.ceil(count / len(self.bats))
        blocks = [min(BLOCK, each - start) for start in range(0, each, BLOCK)]
        turns = [self.bats if number % 2 == 0 else self.bats[::-1] for number in range(len(blocks))]
        return tuple(bat for turn, count in zip(turns, blocks, strict=True) for bat in turn for _ in range(count))

    def further(self, error: float, within: float) -> int:
        """Return how many more swings with each bat an error known so far needs, 0 where it is small enough."""
        return 0 if error <= within else _swings(self.information, within, precision(error))


def precision(error: float) -> float:
    """Return one over the variance of what is known to half a 90 % interval.

    >>> round(precision(1.6448536), 6)
    1.0
    """
    return (REACH / error) ** 2


def _swings(information: float, within: float, before: float) -> int:
    """Return how many swings with each bat bring a precision to what an error needs."""
    return max(0, math.ceil((precision(within) - before) / information))


def swing_plan(
    bats: Sequence[Bat], *, aim: Aim, within: float, law: SwingLaw, scatter: SwingScatter, lead: bool = True
) -> SwingPlan:
    """Return a plan that finds something within an error with few swings.

    For the exponent: with the two bats that differ most, or else the first with the least lead for which `FEW_PLANNED`
    swings do; for the place with the first bat.

    ``bats``: at hand, the player's own first. ``within``: half the width of the 90 % interval wanted, of the exponent
    or in m. ``lead``: whether lead tape may go on the first bat.

    Raises
    ------
    InputError
        for an error that is not above zero, or one bat and no lead.
    """
    if not within > 0:
        raise InputError(f"the error was given as {within:g}; allowed is above 0")
    prior = priors()[aim].width
    if aim == "position":
        return _planned(aim, bats[:1], 1 / scatter.position_variance(), within, prior)
    pairs = list(combinations(bats, 2))
    if lead:
        pairs += [(bats[0], leaded(bats[0], mass)) for mass in LEADS]
    if not pairs:
        raise InputError("with one bat the exponent cannot be found; give a second bat, or allow lead on it")
    plans = [
        _planned(aim, pair, _contrast(pair, law) ** 2 / 2 / scatter.speed_variance(), within, prior)
        for pair in pairs
        if _contrast(pair, law) > 0
    ]
    at_hand = sorted(plans[: len(plans) - len(LEADS)] if lead else plans, key=lambda plan: -plan.information)[:1]
    looked_for = [*at_hand, *(plans[-len(LEADS) :] if lead else [])]
    few = [plan for plan in looked_for if plan.enough and len(plan.bats) * plan.each <= FEW_PLANNED]
    enough = [plan for plan in looked_for if plan.enough]
    return next(iter(few), min(enough or looked_for, key=lambda plan: -plan.information))


def leaded(bat: Bat, mass: float) -> Bat:
    """Return a bat with lead tape (kg) on its barrel."""
    heavier = bat.weighted(position=bat.length - LEAD_FROM_TIP, mass=mass)
    return heavier.replaced(name=f"{bat.name} with {mass / OUNCE:g} oz of lead")


def _contrast(pair: Sequence[Bat], law: SwingLaw) -> float:
    """Return the logarithm of the ratio of two bats' moments of inertia about the law's axis, at least 0."""
    moments = [rigid_body(beam_model(bat)).moi(bat.choke + law.axis) for bat in pair]
    return abs(math.log(moments[0] / moments[1]))


def _planned(aim: Aim, bats: Sequence[Bat], information: float, within: float, prior: float) -> SwingPlan:
    most = MOST_PLANNED // len(bats)
    each = _swings(information, within, 1 / prior**2)
    planned = min(each, most)
    error = REACH / math.sqrt(1 / prior**2 + planned * information)
    return SwingPlan(aim, tuple(bats), planned, error, each <= most, information)

"""Where a player stands: what share of other batters has less of a quantity, and how the hardest hits are met.

Bat speed and squared-up hits are held against major-league batters [savant_bat_tracking_2025]. Where balls are met, and
how far that scatters, no public table has: those are held against what is usual for players before any swing is read. A
fast swing is squared up less often, so that share is also held against batters of the same bat speed.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import Literal

import numpy as np

from sweetspot.catalog.league_batters import (
    LEAGUE_BAT,
    LEAGUE_PITCH,
    SQUARED_UP,
    HardestHit,
    hardest_hit,
    major_league,
)
from sweetspot.numerics.arrays import Array
from sweetspot.numerics.interval import ENDS, REACH, Interval
from sweetspot.player.model import PlayerModel
from sweetspot.player.posterior import PlayerPosterior
from sweetspot.player.prior import PARAMETERS, priors
from sweetspot.units import Kind

AGAINST_USUAL = ("bat_speed_spread", "position", "position_spread", "offset", "offset_spread", "attack_angle")
"""Parameters held against what is usual."""
SPORT = "baseball"
"""Whose batters are tabled."""
FEWEST_SQUARED = 10
"""Balls below which the share squared up says nothing. Our choice: its interval is then half of all shares wide."""


@dataclass(frozen=True)
class RankedQuantity:
    """One quantity of a player and the share of other batters who have less of it.

    ``name``: of the quantity. ``value``: of the player, SI. ``share_below``: with less, 0 to 1. ``against``: "league",
    "same bat speed" (of the league), or "usual". ``kind``: of the quantity.
    """

    name: str
    value: Interval
    share_below: Interval
    against: Literal["league", "same bat speed", "usual"]
    kind: Kind


@dataclass(frozen=True)
class PlayerStanding:
    """Where a player stands in all that his swings tell.

    ``off_path``: rad, median size of his launch angle less attack angle; None: not measured. ``hardest_hit``: the
    hardest-hit balls of the league at his bat speed; None: none is tabled there.
    """

    quantities: tuple[RankedQuantity, ...]
    off_path: Interval | None
    hardest_hit: HardestHit | None


def player_standing(posterior: PlayerPosterior) -> PlayerStanding:
    """Return the standing of a player in all that the own swings determine."""
    model, learned = posterior.model, posterior.learned
    standings, hardest = [], None
    if model.bats[0].bat.sport == SPORT and learned["bat_speed"].told:
        speed = _with_bias(learned["bat_speed"].interval, model)
        standings.append(
            RankedQuantity("bat_speed", speed, _levels(major_league().bat_speed.level, speed), "league", "speed")
        )
        hardest = hardest_hit(speed.value)
        standings += _squared_up(model, speed.value)
    for name in AGAINST_USUAL:
        if learned[name].told:
            level = _levels(_usual_level(name), learned[name].interval)
            standings.append(RankedQuantity(name, learned[name].interval, level, "usual", PARAMETERS[name]))
    return PlayerStanding(tuple(standings), _off_path(model), hardest)


def _with_bias(speed: Interval, model: PlayerModel) -> Interval:
    """Return a bat speed with what the sensor may be off by on all swings in its interval."""
    bias = 0.0 if model.sensor is None else REACH * model.sensor.speed_bias * speed.value
    low, high = (float(np.hypot(end - speed.value, bias)) for end in (speed.low, speed.high))
    return Interval(speed.value, speed.value - low, speed.value + high)


def squared_up_share(model: PlayerModel) -> tuple[int, int]:
    """Return how many balls were squared up by the league's formula, and of how many with both speeds."""
    both = [
        (swing.exit_speed, LEAGUE_BAT * swing.bat_speed + LEAGUE_PITCH * (swing.pitch_speed or 0.0))
        for swing in model.swings
        if swing.exit_speed is not None and swing.bat_speed is not None
    ]
    return sum(out >= SQUARED_UP * most for out, most in both), len(both)


def _squared_up(model: PlayerModel, bat_speed: float) -> list[RankedQuantity]:
    """Return the share squared up against the league and against batters of the same bat speed."""
    squared, balls = squared_up_share(model)
    if balls < FEWEST_SQUARED:
        return []
    league = major_league()
    share = share_of(squared, balls)
    usual = league.squared_up_at(bat_speed)

    def at_speed(value: float) -> float:
        return _normal_level((value - usual) / league.spread)

    return [
        RankedQuantity("squared_up", share, _levels(league.squared_up.level, share), "league", "ratio"),
        RankedQuantity("squared_up", share, _levels(at_speed, share), "same bat speed", "ratio"),
    ]


def share_of(some: int, count: int) -> Interval:
    """Return a share with its 90 % interval, that of a beta law with half a trial of either kind before any.

    >>> share_of(7, 10)
    Interval(value=0.7, low=0.44..., high=0.88...)
    """
    from scipy.special import betaincinv

    low, high = (float(betaincinv(some + 0.5, count - some + 0.5, end)) for end in ENDS)
    value = some / count
    return Interval(value, min(low, value), max(high, value))


def _usual_level(name: str) -> Callable[[float], float]:
    prior = priors()[name]

    def level(value: float) -> float:
        apart = math.log(value / prior.centre) if prior.scale == "ratio" else value - prior.centre
        return _normal_level(apart / prior.width)

    return level


def _normal_level(apart: float) -> float:
    return 0.5 * math.erfc(-apart / math.sqrt(2))


def _levels(level: Callable[[float], float], value: Interval) -> Interval:
    return Interval(level(value.value), level(value.low), level(value.high))


def _off_path(model: PlayerModel) -> Interval | None:
    """Return the median size of launch angle less attack angle with its interval, that of ranks."""
    off: Array = np.sort(
        [
            abs(swing.launch_angle - swing.attack_angle)
            for swing in model.swings
            if swing.launch_angle is not None and swing.attack_angle is not None
        ]
    )
    if len(off) < FEWEST_SQUARED:
        return None
    half = REACH / (2 * math.sqrt(len(off)))
    return Interval(*(float(np.quantile(off, part)) for part in (0.5, max(0.5 - half, 0.0), min(0.5 + half, 1.0))))

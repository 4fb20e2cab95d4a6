"""Advice for a player: bats ranked, the best contact point, and the value of an inch or a mile an hour."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from statistics import median

import numpy as np

from sweetspot.equipment.bat import Bat
from sweetspot.errors import SweetspotError
from sweetspot.flight.aerodynamics import Aerodynamics
from sweetspot.flight.air import Air
from sweetspot.numerics.arrays import Array
from sweetspot.numerics.interpolants import top
from sweetspot.numerics.interval import Interval, sure_sign
from sweetspot.player.bat_pairs import BatPair, compared_pairs, measured_bats
from sweetspot.player.bat_response import response_of
from sweetspot.player.candidate import Candidate, candidates
from sweetspot.player.expected_gain import NO_CHANGE, Change, Expectation, expectation
from sweetspot.player.goal import Goal, carry_table
from sweetspot.player.posterior import PlayerPosterior, interval
from sweetspot.player.prior import NAMES
from sweetspot.units import INCH, MPH

PLACES = np.arange(2.0, 11.01, 0.5) * INCH
"""m from the tip where the mean contact is tried."""
OFFSETS = np.arange(-0.5, 1.76, 0.15) * INCH
"""m above the bat's axis where the mean contact is tried."""


@dataclass(frozen=True)
class Option:
    """A bat tried on the player.

    ``bat_speed``: of the player with it, m/s. ``goal``: what is expected with it. ``change``: the same against the
    player's own bat. ``chance``: part of the draws in which it is better by more than nothing.
    """

    candidate: Candidate
    bat_speed: Interval
    goal: Interval
    change: Interval
    chance: float


@dataclass(frozen=True)
class Worth:
    """What a change of the player is worth.

    ``key``: short and unique, for programs. ``change``: what is changed, SI.
    """

    key: str
    change: Change
    gain: Interval


@dataclass(frozen=True)
class Advice:
    """Everything recommended to a player.

    Parameters
    ----------
    posterior : what it rests on.
    pitch_speed : m/s at the plate that the answers hold for.
    now : what is expected with the player's own bat.
    options : bats tried, the best first.
    faults : bats that could not be tried, and why.
    pairs : the bats of the file, every two of them, the best first.
    seldom : names of bats of the file that were swung too seldom to be compared.
    end_loaded : an ounce at the tip against the same ounce at the knob.
    contact_point : m from the tip, where the mean contact should lie; with its interval.
    contact_gain : of the goal, from there against where the player meets the ball now.
    contact_curve : expected goal at every place of `PLACES`, mean over the draws.
    height_point, height_gain : the same for the mean offset above the bat's axis.
    worth : what single changes are worth, by key.
    """

    posterior: PlayerPosterior
    goal: Goal
    pitch_speed: float
    now: Interval
    options: tuple[Option, ...]
    faults: tuple[str, ...]
    pairs: tuple[BatPair, ...]
    seldom: tuple[str, ...]
    end_loaded: Interval
    contact_point: Interval
    contact_gain: Interval
    contact_curve: Array
    height_point: Interval
    height_gain: Interval
    worth: dict[str, Worth]

    def lighter(self) -> Advice:
        """Return the advice with few of the fit's draws."""
        return replace(self, posterior=replace(self.posterior.lighter(), weighted=None))

    def sign_of(self, option: Option) -> int:
        """Return 1 for a bat surely better than the player's own, -1 for one surely worse, 0 where that is open.

        Of a bat that the player swung, what was measured has its say too: see `BatPair.verdict`.
        """
        names = {option.candidate.bat.name, self.posterior.model.bats[0].bat.name}
        for pair in self.pairs:
            if {pair.better, pair.other} == names:
                sure = pair.verdict in ("better", "better by the model")
                return 0 if not sure else 1 if pair.better == option.candidate.bat.name else -1
        return sure_sign(option.change.low, option.change.high, nothing=self.goal.nothing)

    @property
    def surely_best(self) -> Option | None:
        """The bat that is surely better by most, None where there is none."""
        return next((option for option in self.options if self.sign_of(option) > 0), None)


def advise(
    posterior: PlayerPosterior,
    *,
    goal: Goal,
    aerodynamics: Aerodynamics,
    air: Air,
    others: Sequence[Bat] = (),
    pitch_speed: float | None = None,
    progress: Callable[[int, int], None] | None = None,
) -> Advice:
    """Return advice for a player, averaged over the posterior and the scatter of the swings.

    The same draws and the same swings are used for every bat, so that a difference is the bats' alone. With another
    bat the player meets the ball equally far from its tip.

    ``pitch_speed``: m/s at the plate; None: the median of the swings.
    """
    model = posterior.model
    speeds = [swing.pitch_speed for swing in model.swings if swing.pitch_speed is not None]
    pitch = pitch_speed if pitch_speed is not None else median(speeds or [0.0])
    carries = None
    if goal.name != "exit-speed":
        carries = carry_table(model, pitch_speed=pitch, aerodynamics=aerodynamics, air=air)
    asked = expectation(posterior, goal=goal, pitch_speed=pitch, carries=carries, seed=posterior.seed)
    reference = model.bats[0]
    now = asked.of(reference)
    tried, not_read = candidates(reference.bat, others, swung=[table.bat for table in model.bats[1:]])
    options, with_key, not_met = _tried(asked, tried, now, progress)
    by_key = {f"bat:{reference.bat.name}": now, **with_key}
    named = {key.removeprefix("bat:"): gained for key, gained in by_key.items() if key.startswith("bat:")}
    pairs, seldom = compared_pairs(measured_bats(model), named, goal=goal)
    place, place_gain, curve = _best_place(asked, PLACES, "position", now)
    height, height_gain, _ = _best_place(asked, OFFSETS, "offset", now)
    return Advice(
        posterior=posterior,
        goal=goal,
        pitch_speed=pitch,
        now=interval(now),
        options=tuple(sorted(options, key=lambda option: -option.change.value)),
        faults=(*not_read, *not_met),
        pairs=pairs,
        seldom=seldom,
        end_loaded=interval(by_key["end-loaded"] - by_key["knob-loaded"]),
        contact_point=place,
        contact_gain=place_gain,
        contact_curve=curve,
        height_point=height,
        height_gain=height_gain,
        worth={
            key: Worth(key, change, interval(asked.of(reference, change) - now)) for key, change in _changes().items()
        },
    )


def _tried(
    asked: Expectation, bats: Sequence[Candidate], now: Array, progress: Callable[[int, int], None] | None
) -> tuple[list[Option], dict[str, Array], list[str]]:
    """Return the expected goal with each bat: as options, by key over the draws; and the faults of the others."""
    reference, model = asked.model.bats[0], asked.model
    options, by_key, faults = [], {}, []
    for number, candidate in enumerate(bats, start=1):
        try:
            table = response_of(candidate.bat, ball=model.ball, axis=model.law.axis, like=reference)
        except SweetspotError as error:
            faults.append(f"{candidate.label}: {error}")
            continue
        gained = asked.of(table)
        by_key[candidate.key] = gained
        options.append(
            Option(
                candidate,
                interval(asked.bat_speed(table)),
                interval(gained),
                interval(gained - now),
                float(np.mean(gained - now > asked.goal.nothing)),
            )
        )
        if progress is not None:
            progress(number, len(bats))
    return options, by_key, faults


def _changes() -> dict[str, Change]:
    """Return the single changes that people ask about."""
    return {
        "bat_speed": Change(bat_speed=1 * MPH),
        "position_spread": Change(position_spread=-1 * INCH),
        "offset_spread": Change(offset_spread=-0.25 * INCH),
        "towards_tip": Change(position=-1 * INCH),
        "towards_hands": Change(position=1 * INCH),
        "attack_angle": Change(attack_angle=np.radians(5.0)),
    }


def _best_place(asked: Expectation, grid: Array, what: str, now: Array) -> tuple[Interval, Interval, Array]:
    """Return the best place of the mean contact, its gain, and the expected goal all over the grid."""
    reference = asked.model.bats[0]
    mean = asked.draws[:, NAMES.index(what)]
    values = np.array([asked.of(reference, NO_CHANGE, **{what: np.full_like(mean, place)}) for place in grid])
    best, height = np.empty(len(mean)), np.empty(len(mean))
    for draw in range(len(mean)):
        index, shift, height[draw] = top(values[:, draw])
        best[draw] = grid[index] + shift * (grid[1] - grid[0])
    return interval(best), interval(height - now), values.mean(axis=1)

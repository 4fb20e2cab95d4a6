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
from sweetspot.player.bat_response import BatResponse, response_of
from sweetspot.player.best_bat import BatChance, BatChoice, bat_choice, width_ratio
from sweetspot.player.candidate import Candidate, candidates
from sweetspot.player.expected_gain import NO_CHANGE, Change, Expectation, expectation
from sweetspot.player.goal import Goal, carry_table
from sweetspot.player.model import PlayerModel
from sweetspot.player.posterior import NOTHING_LEARNED, PlayerPosterior, interval
from sweetspot.player.prior import NAMES
from sweetspot.player.standing import PlayerStanding, player_standing
from sweetspot.player.unlike_bats import Liveliness, gains_of_several, liveliness
from sweetspot.units import INCH, MPH

PLACES = np.arange(2.0, 11.01, 0.5) * INCH
"""m from the tip where the mean contact is tried."""
OFFSETS = np.arange(-0.5, 1.76, 0.15) * INCH
"""m above the bat's axis where the mean contact is tried."""
ATTACK_CHANGE = float(np.radians(5.0))
"""rad steeper upward, of which the worth is asked."""
TWO_WAYS = (("towards_tip", "towards_hands"), ("higher", "lower"), ("attack_angle", "flatter"))
"""Changes of a player that are each other's opposite: at most one of them serves."""
SAME_LENGTH = 0.25 * INCH
"""m; bats whose lengths differ by less are swung alike. Our choice: bats come in half inches."""


@dataclass(frozen=True)
class Option:
    """A bat tried on the player.

    ``bat_speed``: of the player with it, m/s. ``goal``: what is expected with it. ``change``: the same against the
    player's own bat. ``chance``: part of the draws in which it is better by more than nothing. ``usual``: the change
    for anybody, of whom no swing is known. ``width_ratio``: of the change, see `sweetspot.player.best_bat.width_ratio`.
    ``length_known``: whether the player swung a bat of this length: timing, reach and misses change with it.
    """

    candidate: Candidate
    bat_speed: Interval
    goal: Interval
    change: Interval
    chance: float
    usual: Interval
    width_ratio: float
    length_known: bool

    @property
    def own(self) -> bool:
        """Whether the change is known from the player's own swings."""
        return self.length_known and self.width_ratio < NOTHING_LEARNED


@dataclass(frozen=True)
class Worth:
    """What a change of the player is worth.

    ``key``: short and unique, for programs. ``change``: what is changed, SI. ``usual``: the gain of anybody.
    ``width_ratio``: of the gain, see `sweetspot.player.best_bat.width_ratio`.
    """

    key: str
    change: Change
    gain: Interval
    usual: Interval
    width_ratio: float

    @property
    def own(self) -> bool:
        """Whether the gain is known from the player's own swings."""
        return self.width_ratio < NOTHING_LEARNED


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
    choice : the player's own bat, those of the file and those asked for, the likeliest best first; None: it is the only
        one whose length the player swung.
    end_loaded : an ounce at the tip against the same ounce at the knob.
    contact_point : m from the tip, where the mean contact should lie; with its interval.
    contact_gain : of the goal, from there against where the player meets the ball now.
    contact_curve : expected goal at every place of `PLACES`, mean over the draws.
    height_point, height_gain : the same for the mean offset above the bat's axis.
    worth : what single changes are worth, by key.
    standing : where the player stands among others.
    """

    posterior: PlayerPosterior
    goal: Goal
    pitch_speed: float
    now: Interval
    options: tuple[Option, ...]
    faults: tuple[str, ...]
    pairs: tuple[BatPair, ...]
    seldom: tuple[str, ...]
    choice: BatChoice | None
    end_loaded: Interval
    contact_point: Interval
    contact_gain: Interval
    contact_curve: Array
    height_point: Interval
    height_gain: Interval
    worth: dict[str, Worth]
    standing: PlayerStanding

    def lighter(self) -> Advice:
        """Return the advice with few of the fit's draws."""
        return replace(self, posterior=replace(self.posterior.lighter(), weighted=None))

    def sign_of(self, option: Option) -> int:
        """Return 1 for a bat surely better than the player's own by own swings, -1 for one surely worse, 0 else.

        Of a bat that the player swung, what was measured has its say too: see `BatPair.verdict`.
        """
        names = {option.candidate.bat.name, self.posterior.model.bats[0].bat.name}
        for pair in self.pairs:
            if {pair.better, pair.other} == names:
                sure = pair.verdict in ("better", "better by the model")
                return 0 if not sure else 1 if pair.better == option.candidate.bat.name else -1
        if not option.own:
            return 0
        return sure_sign(option.change.low, option.change.high, nothing=self.goal.nothing)

    def usual_sign(self, option: Option) -> int:
        """Return 1 for a bat surely better than the player's own for anybody, -1 for one surely worse, 0 else."""
        if not option.length_known:
            return 0
        return sure_sign(option.usual.low, option.usual.high, nothing=self.goal.nothing)

    @property
    def named_best(self) -> BatChance | None:
        """The best of the bats at hand; None: the swings cannot tell, or what was measured says something else."""
        best = None if self.choice is None else self.choice.best
        contrary = any(
            pair.verdict == "gainsaid" and best is not None and best.name in (pair.better, pair.other)
            for pair in self.pairs
        )
        return None if contrary else best

    @property
    def surely_best(self) -> Option | None:
        """The bat that is surely better by most, None where there is none."""
        return next((option for option in self.options if self.sign_of(option) > 0), None)

    @property
    def ranked_worth(self) -> tuple[Worth, ...]:
        """The changes of the player that may bring something, the most first; of two opposite ones the better."""
        worse = {min(both, key=lambda key: self.worth[key].gain.value) for both in TWO_WAYS}
        gaining = [
            worth for key, worth in self.worth.items() if key not in worse and worth.gain.value > self.goal.nothing
        ]
        return tuple(sorted(gaining, key=lambda worth: -worth.gain.value))

    @property
    def surely_worth(self) -> tuple[Worth, ...]:
        """The changes of the player that surely bring something by own swings, those that bring most first."""
        sure = [
            worth
            for worth in self.worth.values()
            if worth.own and sure_sign(worth.gain.low, worth.gain.high, nothing=self.goal.nothing) > 0
        ]
        return tuple(sorted(sure, key=lambda worth: -worth.gain.value))


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
    anybody = asked.of_anybody(posterior.population)
    reference = model.bats[0]
    now = asked.of(reference)
    swung = measured_bats(model)
    lively, usually_lively = liveliness(asked, swung), liveliness(anybody)
    beside = _Asked(asked, anybody, now, anybody.of(reference), lively, usually_lively)
    tried, not_read = candidates(reference.bat, others, swung=[table.bat for table in model.bats[1:]])
    options, with_key, not_met = _tried(beside, tried, progress)
    by_key = {f"bat:{reference.bat.name}": (now, beside.usual_now), **with_key}
    named = {key.removeprefix("bat:"): gained for key, gained in by_key.items() if key.startswith("bat:")}
    gained, usual = ({name: both[side] for name, both in named.items()} for side in (0, 1))
    pairs, seldom = compared_pairs(swung, gained, usual, goal=goal)
    alike = [option for option in options if option.length_known and option.candidate.key.startswith("bat:")]
    comparable = [reference, *(_table_of(option.candidate, model) for option in alike)]
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
        choice=bat_choice(gains_of_several(asked, comparable, swung), gains_of_several(anybody, comparable)),
        end_loaded=interval(by_key["end-loaded"][0] - by_key["knob-loaded"][0]),
        contact_point=place,
        contact_gain=place_gain,
        contact_curve=curve,
        height_point=height,
        height_gain=height_gain,
        worth={key: beside.worth(key, change) for key, change in _changes().items()},
        standing=player_standing(posterior),
    )


@dataclass(frozen=True)
class _Asked:
    """A player and anybody, asked the same question; ``now``, ``usual_now``: their goal with the player's own bat.

    ``lively``, ``usually_lively``: by how much bats differ from their descriptions, for the player and for anybody.
    """

    player: Expectation
    anybody: Expectation
    now: Array
    usual_now: Array
    lively: Liveliness
    usually_lively: Liveliness

    def with_bat(self, candidate: Candidate, table: BatResponse) -> tuple[Array, Array]:
        """Return the goal expected with a bat over the draws of the player and of anybody.

        Bats of the file and of the catalogue may be livelier or deader than described beside the player's own.
        """
        if candidate.family not in ("swung", "catalogue"):
            return self.of(table)
        name = candidate.bat.name
        of_player, of_anybody = self.lively.of(name), self.usually_lively.of(name)
        return self.player.of(table, livelier=of_player), self.anybody.of(table, livelier=of_anybody)

    def of(self, table: BatResponse, change: Change = NO_CHANGE) -> tuple[Array, Array]:
        """Return the goal expected with a bat over the draws of the player, and of anybody."""
        return self.player.of(table, change), self.anybody.of(table, change)

    def worth(self, key: str, change: Change) -> Worth:
        """Return the worth of a change of the player."""
        changed, usual = self.of(self.player.model.bats[0], change)
        gain, usual = changed - self.now, usual - self.usual_now
        return Worth(key, change, interval(gain), interval(usual), width_ratio(gain, usual))


def _tried(
    asked: _Asked, bats: Sequence[Candidate], progress: Callable[[int, int], None] | None
) -> tuple[list[Option], dict[str, tuple[Array, Array]], list[str]]:
    """Return the expected goal with each bat: as options, by key over the draws; and the faults of the others."""
    model, goal = asked.player.model, asked.player.goal
    lengths = np.array([table.bat.length for table in model.bats])
    options, by_key, faults = [], {}, []
    for number, candidate in enumerate(bats, start=1):
        try:
            table = _table_of(candidate, model)
        except SweetspotError as error:
            faults.append(f"{candidate.label}: {error}")
            continue
        gained, usually = by_key[candidate.key] = asked.with_bat(candidate, table)
        change, usual = gained - asked.now, usually - asked.usual_now
        options.append(
            Option(
                candidate,
                bat_speed=interval(asked.player.bat_speed(table)),
                goal=interval(gained),
                change=interval(change),
                chance=float(np.mean(change > goal.nothing)),
                usual=interval(usual),
                width_ratio=width_ratio(change, usual),
                length_known=bool(np.min(np.abs(lengths - candidate.bat.length)) < SAME_LENGTH),
            )
        )
        if progress is not None:
            progress(number, len(bats))
    return options, by_key, faults


def _table_of(candidate: Candidate, model: PlayerModel) -> BatResponse:
    return response_of(candidate.bat, ball=model.ball, axis=model.law.axis, like=model.bats[0])


def _changes() -> dict[str, Change]:
    """Return the single changes that people ask about."""
    return {
        "bat_speed": Change(bat_speed=1 * MPH),
        "position_spread": Change(position_spread=-1 * INCH),
        "offset_spread": Change(offset_spread=-0.25 * INCH),
        "towards_tip": Change(position=-1 * INCH),
        "towards_hands": Change(position=1 * INCH),
        "higher": Change(offset=0.25 * INCH),
        "lower": Change(offset=-0.25 * INCH),
        "attack_angle": Change(attack_angle=ATTACK_CHANGE),
        "flatter": Change(attack_angle=-ATTACK_CHANGE),
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

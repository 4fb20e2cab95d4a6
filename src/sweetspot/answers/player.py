"""What swings say about a player, and which bat and contact point serve."""

from __future__ import annotations

from collections.abc import Mapping
from contextlib import nullcontext
from dataclasses import asdict, dataclass
from typing import TYPE_CHECKING, Annotated

from sweetspot.answers.answer import Answer, Progress, frame_of
from sweetspot.answers.conditions import MassProperties, mass_properties
from sweetspot.answers.player_question import (
    FitPlayerQuestion,
    PlayerSwings,
    player_advice,
    player_posterior,
    read_player,
)
from sweetspot.answers.player_training import (
    DIMENSIONS,
    GOAL_DIMENSIONS,
    ChangeWorth,
    HardestHitBalls,
    StandingAmong,
    change_worth,
    hardest_hit_balls,
    standing_among,
)
from sweetspot.answers.records import (
    INTERNAL,
    NESTED,
    OF_RECORD,
    PLAIN_ENDS,
    Angle,
    Distance,
    Length,
    Mass,
    MomentOfInertia,
    Speed,
)
from sweetspot.numerics.arrays import Array
from sweetspot.numerics.interval import LEVEL, Interval, Number
from sweetspot.player.advice import PLACES, Advice, Option
from sweetspot.player.bat_pairs import BatPair, MeasuredBat, measured_bats
from sweetspot.player.best_bat import BatChance
from sweetspot.player.posterior import Learned, PlayerPosterior
from sweetspot.player.prior import PARAMETERS
from sweetspot.player.swings import SwingFile
from sweetspot.tables.cells import BadRow
from sweetspot.units.dimensions import LENGTH, SPEED, Dimension, System

if TYPE_CHECKING:
    import polars


@dataclass(frozen=True)
class GoalAsked:
    """What the player wants more of: "exit-speed", "carry", or hits beyond a "line" over the ground."""

    name: str
    line: Distance | None


@dataclass(frozen=True)
class SensorErrors:
    """Errors of a bat sensor as standard deviations; see `sweetspot.player.sensor.Sensor`."""

    name: str
    speed_bias: float
    speed_noise: Speed
    angle_noise: Angle


@dataclass(frozen=True)
class SwingsUsed:
    """The swings that a fit rests on.

    Parameters
    ----------
    used : how many.
    system : whose file it is; "plain" where the names belong to no system.
    without_swing : rows with neither a bat speed nor an exit speed.
    first_day, last_day : of the dated rows, year-month-day.
    notes : what is missing, constant or few.
    bats : names, the player's own first.
    sensor : errors of the bat sensor; None: none are known of its own.
    """

    used: int
    system: str
    bad_rows: tuple[BadRow, ...]
    without_swing: int
    ignored_columns: tuple[str, ...]
    first_day: str | None
    last_day: str | None
    notes: tuple[str, ...]
    bats: tuple[str, ...]
    sensor: SensorErrors | None


@dataclass(frozen=True)
class ParameterRange:
    """A parameter of a player, with its interval."""

    dimension: Annotated[Dimension, INTERNAL]
    value: Annotated[Number, OF_RECORD, PLAIN_ENDS]


@dataclass(frozen=True)
class FittedParameter(ParameterRange):
    """A parameter of a player after the fit; see `sweetspot.player.posterior.Learned`.

    ``prior``: what was known before any swing. ``told_by_data``: whether the swings say anything beyond that.
    """

    prior: ParameterRange
    width_ratio: float
    told_by_data: bool
    independent_draws: float


@dataclass(frozen=True, kw_only=True)
class TriedBat:
    """A bat tried on the player.

    ``key``, ``label``, ``family``: see `sweetspot.player.candidate.Candidate`. ``goal``, ``change``: what is expected
    with it, and that against the player's own bat. ``chance_better``: part of what the data allow in which it is
    better. ``usual_change``: of whom no swing is known. ``told_by_swings``: whether the change is known from the
    player's own swings. ``length_swung``: whether a bat of its length was swung.
    """

    key: str
    label: str
    family: str
    bat: MassProperties
    choke: Length
    bat_speed: Annotated[Speed, NESTED]
    goal: Annotated[Number, OF_RECORD, NESTED]
    change: Annotated[Number, OF_RECORD, NESTED]
    chance_better: float
    usual_change: Annotated[Number, OF_RECORD, NESTED]
    told_by_swings: bool
    length_swung: bool
    dimension: Annotated[Dimension, INTERNAL]
    option: Annotated[Option, INTERNAL]


@dataclass(frozen=True, kw_only=True)
class TriedBatRow:
    """A bat tried on the player as a row of a table; see `TriedBat`."""

    key: str
    label: str
    family: str
    length: Length
    mass: Mass
    balance_point: Length
    moi_6in: MomentOfInertia
    bat_speed: Speed
    goal: Annotated[Number, OF_RECORD]
    change: Annotated[Number, OF_RECORD]
    chance_better: float
    usual_change: Annotated[Number, OF_RECORD]
    told_by_swings: bool
    length_swung: bool
    dimension: Annotated[Dimension, INTERNAL]


@dataclass(frozen=True)
class BatMeans:
    """A bat of the file as it was measured: how many swings, and their means; None: too few."""

    name: str
    swings: int
    bat_speed: Annotated[Number | None, SPEED, NESTED]
    exit_speed: Annotated[Number | None, SPEED, NESTED]


@dataclass(frozen=True)
class PairGain:
    """Two bats of the file, of which the model expects more of the first; see `sweetspot.player.bat_pairs.Pair`."""

    better: str
    other: str
    gain: Annotated[Number, OF_RECORD, NESTED]
    chance_better: float
    measured: Annotated[Number | None, SPEED, NESTED]
    verdict: str
    dimension: Annotated[Dimension, INTERNAL]


@dataclass(frozen=True)
class BestBat:
    """Which of the bats at hand is best, the likeliest first.

    ``best``: its name; None: the swings cannot tell. ``bats``: each with its chance of being the best, for this player
    and for anybody. ``lead``: of the first over the second. ``told_by_swings``: whether own swings say which of these.
    """

    best: str | None
    bats: tuple[BatChance, ...]
    lead: Annotated[Number, OF_RECORD, NESTED]
    told_by_swings: bool
    dimension: Annotated[Dimension, INTERNAL]


@dataclass(frozen=True)
class ContactCurve:
    """The expected goal by where the mean contact lies, arrays of one shape (n,)."""

    from_tip: Annotated[Array, LENGTH]
    goal: Annotated[Array, OF_RECORD]
    dimension: Annotated[Dimension, INTERNAL]


@dataclass(frozen=True, kw_only=True)
class FitPlayerAnswer(Answer):
    """What swings say about a player, and what would serve; contact places from the tip.

    Parameters
    ----------
    pitch_speed : at the plate, that the answers hold for.
    bat_speed_from_tip : where bat speed is measured.
    converged : whether enough of the draws count.
    parameters : of the player, by name.
    now : what is expected with the player's own bat.
    options : bats tried, the best first.
    not_tried : bats that could not be, and why.
    pairs : the bats of the file, every two of them.
    swung_too_seldom : bats of the file with too few swings to be compared.
    best_bat : which of the player's own bat, those of the file and those asked for is best; None: there is one only.
    end_loaded_against_knob_loaded : an ounce at the tip against the same ounce at the knob.
    contact_point_from_tip, contact_point_gain : where the mean contact should lie, and what that brings.
    contact_height, contact_height_gain : the same for the ball's centre above the bat's axis.
    worth : what single changes of the player bring, by key.
    training : keys of `worth`, what may bring something by what it brings, the most first.
    standing : where the player stands among others.
    hardest_hit : how the league's hardest-hit balls at this bat speed were met; None: none are tabled.
    """

    question: Annotated[FitPlayerQuestion, INTERNAL]
    file: Annotated[SwingFile, INTERNAL]
    advice: Annotated[Advice, INTERNAL]
    goal: GoalAsked
    swings: SwingsUsed
    pitch_speed: Speed
    bat_speed_from_tip: Length
    interval_level: float
    seed: int
    converged: bool
    parameters: Mapping[str, FittedParameter]
    now: Annotated[Number, OF_RECORD, NESTED]
    options: tuple[TriedBat, ...]
    not_tried: tuple[str, ...]
    swung: tuple[BatMeans, ...]
    pairs: tuple[PairGain, ...]
    swung_too_seldom: tuple[str, ...]
    best_bat: BestBat | None
    end_loaded_against_knob_loaded: Annotated[Number, OF_RECORD, NESTED]
    contact_point_from_tip: Annotated[Length, NESTED]
    contact_point_gain: Annotated[Number, OF_RECORD, NESTED]
    contact_height: Annotated[Length, NESTED]
    contact_height_gain: Annotated[Number, OF_RECORD, NESTED]
    contact_curve: ContactCurve
    worth: Mapping[str, ChangeWorth]
    training: tuple[str, ...]
    standing: tuple[StandingAmong, ...]
    hardest_hit: HardestHitBalls | None

    @property
    def dimension(self) -> Dimension:
        """Of what is wanted."""
        return GOAL_DIMENSIONS[self.question.goal.name]

    @property
    def posterior(self) -> PlayerPosterior:
        """What the swings say about the parameters."""
        return self.advice.posterior

    @property
    def rows(self) -> list[TriedBatRow]:
        """The bats tried as rows of a table, the best first."""
        shared = (
            *("key", "label", "family", "bat_speed", "goal", "change", "chance_better", "dimension"),
            *("usual_change", "told_by_swings", "length_swung"),
        )
        sizes = ("length", "mass", "balance_point", "moi_6in")
        return [
            TriedBatRow(
                **{name: getattr(tried, name) for name in shared}, **{name: getattr(tried.bat, name) for name in sizes}
            )
            for tried in self.options
        ]

    def to_frame(self, units: System = "si") -> polars.DataFrame:
        """Return a frame of a row for every bat tried, the best first."""
        return frame_of(self.rows, units)


def fit_player_answer(question: FitPlayerQuestion, *, progress: Progress | None = None) -> FitPlayerAnswer:
    """Return the parameters fitted to one player's swings, and the bat and contact point advised.

    ``progress``: called with the pieces of work.

    Raises
    ------
    InputError
        for a file that cannot be read, or tells too little of one player.
    """
    swings = read_player(question)
    posterior = player_posterior(swings)
    with (progress or (lambda _: nullcontext()))("trying bats") as report:
        advice = player_advice(question, posterior, report)
    return player_answer(swings, advice)


def player_answer(swings: PlayerSwings, advice: Advice) -> FitPlayerAnswer:
    """Return the answer whose fit and advice are there already."""
    posterior, file, goal = advice.posterior, swings.file, advice.goal
    model, dimension = posterior.model, GOAL_DIMENSIONS[goal.name]
    return FitPlayerAnswer(
        question=swings.question,
        file=file,
        advice=advice,
        goal=GoalAsked(goal.name, goal.line),
        swings=SwingsUsed(
            used=len(model.swings),
            system=file.system,
            bad_rows=file.bad_rows,
            without_swing=file.without_swing,
            ignored_columns=file.ignored_columns,
            first_day=None if file.first_day is None else str(file.first_day),
            last_day=None if file.last_day is None else str(file.last_day),
            notes=file.notes,
            bats=tuple(table.bat.name for table in model.bats),
            sensor=None if model.sensor is None else SensorErrors(**asdict(model.sensor)),
        ),
        pitch_speed=advice.pitch_speed,
        bat_speed_from_tip=model.speed_from_tip,
        interval_level=LEVEL,
        seed=posterior.seed,
        converged=posterior.converged,
        parameters={name: _fitted_parameter(learned) for name, learned in posterior.learned.items()},
        now=advice.now,
        options=tuple(_tried_bat(option, dimension) for option in advice.options),
        not_tried=advice.faults,
        swung=tuple(_bat_means(swung) for swung in measured_bats(model)),
        pairs=tuple(_pair_gain(pair, dimension) for pair in advice.pairs),
        swung_too_seldom=advice.seldom,
        best_bat=_best_bat(advice, dimension),
        end_loaded_against_knob_loaded=advice.end_loaded,
        contact_point_from_tip=advice.contact_point,
        contact_point_gain=advice.contact_gain,
        contact_height=advice.height_point,
        contact_height_gain=advice.height_gain,
        contact_curve=ContactCurve(PLACES, advice.contact_curve, dimension),
        worth={key: change_worth(worth, dimension) for key, worth in advice.worth.items()},
        training=tuple(worth.key for worth in advice.ranked_worth),
        standing=tuple(standing_among(standing) for standing in advice.standing.quantities),
        hardest_hit=hardest_hit_balls(advice.standing),
    )


def parameter_dimension(name: str) -> Dimension:
    """Return the dimension of a parameter of a player."""
    return DIMENSIONS[PARAMETERS[name]]


def parameter_range(name: str, interval: Interval) -> ParameterRange:
    """Return a parameter of a player with its interval."""
    return ParameterRange(parameter_dimension(name), interval)


def _fitted_parameter(learned: Learned) -> FittedParameter:
    return FittedParameter(
        dimension=parameter_dimension(learned.name),
        value=learned.interval,
        prior=parameter_range(learned.name, learned.before),
        width_ratio=learned.width_ratio,
        told_by_data=learned.told,
        independent_draws=learned.independent_draws,
    )


def _tried_bat(option: Option, dimension: Dimension) -> TriedBat:
    candidate = option.candidate
    return TriedBat(
        key=candidate.key,
        label=candidate.label,
        family=candidate.family,
        bat=mass_properties(candidate.bat, candidate.body),
        choke=candidate.bat.choke,
        bat_speed=option.bat_speed,
        goal=option.goal,
        change=option.change,
        chance_better=option.chance,
        usual_change=option.usual,
        told_by_swings=option.own,
        length_swung=option.length_known,
        dimension=dimension,
        option=option,
    )


def _bat_means(swung: MeasuredBat) -> BatMeans:
    return BatMeans(swung.bat.name, swung.count, swung.bat_speed, swung.exit_speed)


def _pair_gain(pair: BatPair, dimension: Dimension) -> PairGain:
    return PairGain(pair.better, pair.other, pair.gain, pair.chance, pair.measured, pair.verdict, dimension)


def _best_bat(advice: Advice, dimension: Dimension) -> BestBat | None:
    choice = advice.choice
    if choice is None:
        return None
    best = None if advice.named_best is None else advice.named_best.name
    return BestBat(best, choice.bats, choice.lead, choice.own, dimension)

"""What swings say about every batter of a file: one row a batter, each fitted knowing how the others differ."""

from __future__ import annotations

from collections.abc import Mapping
from contextlib import nullcontext
from dataclasses import dataclass, fields, replace
from typing import TYPE_CHECKING, Annotated

from sweetspot.answers.answer import Answer, Progress, frame_of
from sweetspot.answers.player import (
    ParameterRange,
    parameter_dimension,
    parameter_range,
)
from sweetspot.answers.player_question import FitPlayerQuestion, player_advice, player_posterior, read_player
from sweetspot.answers.player_training import GOAL_DIMENSIONS
from sweetspot.answers.records import INTERNAL, OF_RECORD, PLAIN_ENDS, Length, Speed
from sweetspot.errors import InputError, SweetspotError
from sweetspot.numerics.interval import Number
from sweetspot.numerics.threads import side_by_side
from sweetspot.player.advice import Advice, Option
from sweetspot.player.posterior import PlayerPosterior, own_share, population_of, refitted
from sweetspot.player.prior import NAMES, Population, population_range
from sweetspot.player.swings import batters
from sweetspot.units.dimensions import Dimension, System

if TYPE_CHECKING:
    import polars


@dataclass(frozen=True)
class PooledParameter:
    """A parameter of a batter alone and knowing how the league's batters differ.

    ``alone``, ``pooled``: from the own swings only, and within the league. ``own_share``: how much of the pooled spread
    is the batter's own word; 0: that of the league.
    """

    alone: ParameterRange
    pooled: ParameterRange
    moved: Annotated[Number, OF_RECORD]
    own_share: float
    dimension: Annotated[Dimension, INTERNAL]


@dataclass(frozen=True)
class LeagueParameter:
    """The middle of a league, with what 90 % of its players lie within."""

    dimension: Annotated[Dimension, INTERNAL]
    mean: Annotated[Number, OF_RECORD, PLAIN_ENDS]


@dataclass(frozen=True, kw_only=True)
class TeamRow:
    """One batter of a team as a row of a table.

    ``bat_speed_alone``, ``position_spread_alone``: as the own swings alone say; the others knowing the league.
    ``one_inch_less_scatter``: what it brings; ``told_by_swings``: whether own swings say so, beyond the league's.
    ``surely_gained``: the least that the best sure change of bat or player brings by own swings; 0: none is sure.
    ``better_bat``, ``better_by``: the bat that is surely better by most;
    None: there is none.
    """

    batter: str
    swings: int
    bat: str
    bat_speed: Speed
    bat_speed_alone: Speed
    position_spread: Length
    position_spread_alone: Length
    goal: str
    expected: Annotated[Number, OF_RECORD]
    contact_point_from_tip: Length
    one_inch_less_scatter: Annotated[Number, OF_RECORD]
    told_by_swings: bool
    surely_gained: Annotated[Number, OF_RECORD]
    better_bat: str | None
    better_by: Annotated[Number | None, OF_RECORD]
    dimension: Annotated[Dimension, INTERNAL]


@dataclass(frozen=True, kw_only=True)
class TeamBatter(TeamRow):
    """One batter of a team.

    ``alone``: the fit to the own swings. ``advice``: which rests on the fit within the league. ``best``: the bat that
    is surely better by most; None: there is none.
    """

    parameters: Mapping[str, PooledParameter]
    alone: Annotated[PlayerPosterior, INTERNAL]
    advice: Annotated[Advice, INTERNAL]
    best: Annotated[Option | None, INTERNAL]

    @property
    def posterior(self) -> PlayerPosterior:
        """The fit within the league; that to the own swings where there is none."""
        return self.advice.posterior


@dataclass(frozen=True, kw_only=True)
class FitTeamAnswer(Answer):
    """Every batter of a file, each fitted knowing how the others differ.

    Parameters
    ----------
    batters : the one who surely gains most by own swings first.
    league : how the batters differ, by parameter, and how many they are; None: too few to say.
    left_out : batters who cannot be fitted, and why.
    """

    question: Annotated[FitPlayerQuestion, INTERNAL]
    population: Annotated[Population | None, INTERNAL]
    batters: tuple[TeamBatter, ...]
    league: Mapping[str, int | LeagueParameter] | None
    left_out: tuple[str, ...]

    @property
    def rows(self) -> list[TeamRow]:
        """The batters as rows of a table."""
        names = [column.name for column in fields(TeamRow)]
        return [TeamRow(**{name: getattr(batter, name) for name in names}) for batter in self.batters]

    def to_frame(self, units: System = "si") -> polars.DataFrame:
        """Return a frame of a row for every batter."""
        return frame_of(self.rows, units)


def fit_team_answer(question: FitPlayerQuestion, *, progress: Progress | None = None) -> FitTeamAnswer:
    """Return the fits of every batter of a file, each with the spread among batters as its prior.

    Raises
    ------
    InputError
        for a file that cannot be read, or tells too little of every batter.
    """

    def fit(name: str) -> tuple[str, PlayerPosterior | str]:
        try:
            return name, player_posterior(read_player(replace(question, batter=name))).lighter()
        except SweetspotError as error:
            return name, " ".join(str(error).split())

    def ask(member: tuple[str, PlayerPosterior]) -> TeamBatter:
        name, alone = member
        posterior = alone if population is None else refitted(alone, population)
        advice = player_advice(question, posterior).lighter()
        return _team_batter(name, replace(alone, weighted=None), advice, population)

    begin = progress or (lambda _: nullcontext())
    with begin("reading the swings") as report:
        fits = side_by_side(fit, batters(question.file, given=question.columns), progress=report)
    fitted = [(name, fit) for name, fit in fits if not isinstance(fit, str)]
    left_out = tuple(f"{name}: {fit}" for name, fit in fits if isinstance(fit, str))
    if not fitted:
        raise InputError(f"{question.file} has no batter who can be fitted: {'; '.join(left_out[:3])}")
    population = population_of([fit for _, fit in fitted])
    with begin("trying bats") as report:
        members = side_by_side(ask, fitted, progress=report)
    members.sort(key=lambda member: (-float(member.surely_gained), -float(member.one_inch_less_scatter)))
    league: dict[str, int | LeagueParameter] | None = None
    if population is not None:
        league = {"players": len(members)}
        for name, interval in population_range(population).items():
            league[name] = LeagueParameter(parameter_dimension(name), interval)
    return FitTeamAnswer(
        question=question, population=population, batters=tuple(members), league=league, left_out=left_out
    )


def _team_batter(name: str, alone: PlayerPosterior, advice: Advice, population: Population | None) -> TeamBatter:
    learned = advice.posterior.learned
    shares = dict.fromkeys(NAMES, 1.0) if population is None else own_share(advice.posterior, population)
    best = advice.surely_best
    sure = [*(worth.gain for worth in advice.surely_worth), *([best.change] if best is not None else [])]
    return TeamBatter(
        batter=name,
        swings=len(advice.posterior.model.swings),
        bat=advice.posterior.model.bats[0].bat.name,
        bat_speed=learned["bat_speed"].interval.value,
        bat_speed_alone=alone.learned["bat_speed"].interval.value,
        position_spread=learned["position_spread"].interval.value,
        position_spread_alone=alone.learned["position_spread"].interval.value,
        goal=advice.goal.name,
        expected=advice.now.value,
        contact_point_from_tip=advice.contact_point.value,
        one_inch_less_scatter=advice.worth["position_spread"].gain,
        told_by_swings=advice.worth["position_spread"].own,
        surely_gained=max((gain.low for gain in sure), default=0.0),
        better_bat=None if best is None else best.candidate.label,
        better_by=None if best is None else best.change.value,
        dimension=GOAL_DIMENSIONS[advice.goal.name],
        parameters={
            name: PooledParameter(
                alone=parameter_range(name, alone.learned[name].interval),
                pooled=parameter_range(name, learned[name].interval),
                moved=learned[name].interval.value - alone.learned[name].interval.value,
                own_share=shares[name],
                dimension=parameter_dimension(name),
            )
            for name in NAMES
        },
        alone=alone,
        advice=advice,
        best=best,
    )

"""Questions about what was measured as plain functions: files in, a typed answer out.

The command line asks the same of the same files; see `sweetspot.season`, `sweetspot.fit_player` and their like.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from sweetspot import catalog
from sweetspot.analysis.drop_test import ROOM_AIR
from sweetspot.answers.drop import DropAnswer, DropQuestion, drop_answer, drop_sources
from sweetspot.answers.flight_setups import GAMES_AIR, FieldAir
from sweetspot.answers.pendulum import PendulumAnswer, PendulumQuestion, checked_pendulum
from sweetspot.answers.setups import (
    BlockSetup,
    Exact,
    FallSetup,
    Written,
    error_of,
    round_bat,
    value_of,
)
from sweetspot.calibration.measured import Measured
from sweetspot.catalog.implements import Loaded
from sweetspot.errors import InputError
from sweetspot.plausibility import parse
from sweetspot.player.goal import Goal, GoalName
from sweetspot.player.planning import Aim
from sweetspot.seasons.flight_choice import USUAL_FLIGHT, FlightChoice
from sweetspot.units import INCH

if TYPE_CHECKING:
    from sweetspot.answers.plan_swings import PlanSwingsAnswer
    from sweetspot.answers.player import FitPlayerAnswer
    from sweetspot.answers.season import SeasonAnswer


USUAL_AIR = FieldAir()


@dataclass(frozen=True, kw_only=True)
class GoalSetup:
    """What a player wants more of.

    Parameters
    ----------
    goal : "exit-speed", "carry" or "line".
    line : distance to pass, m, for "line".
    """

    goal: GoalName = "exit-speed"
    line: float | None = None


def season(
    *tables: Path | str,
    bats: Mapping[str, str] | str | None = None,
    others: Sequence[str] = (),
    contact: bool = True,
    player: str | None = None,
    folder: Path | str | None = None,
    air: FieldAir = GAMES_AIR,
    flights: FlightChoice = USUAL_FLIGHT,
) -> SeasonAnswer:
    """Analyze every ball in play of tables: its place on the bat, its carry, and the results of each batter.

    Parameters
    ----------
    tables : Statcast exports, Trackman, plain; CSV, .csv.gz or Parquet.
    bats : of all hitters, or by batter, with "" for all others: names of the catalogue or files; None: the usual one.
    others : bats that every swing is tried with.
    contact : whether contacts are wanted beside flights.
    player : number or name of a batter who must be in the tables.
    folder : where the answers go; None: a temporary one.
    air : of games whose weather the tables do not give.
    flights : ball, law of drag and lift, drag, and the field of balls whose table names none.

    Raises
    ------
    InputError
        for tables that are not there, batters whom no table has, or a bat that is not known.
    """
    from sweetspot.answers.season import season_answer
    from sweetspot.answers.season_question import SeasonQuestion

    given = {"": bats} if isinstance(bats, str) else bats
    question = SeasonQuestion(
        paths=tables,
        bats=given,
        others=others,
        contact=contact,
        player=player,
        folder=folder,
        air=air.air,
        flights=flights,
    )
    return season_answer(question)


def fit_player(
    swings: Path | str,
    *,
    bat: Loaded | None = None,
    batter: str | None = None,
    pitch_speed: Written | None = None,
    wanted: GoalSetup = GoalSetup(),
    others: Sequence[str] = (),
    air: FieldAir = USUAL_AIR,
) -> FitPlayerAnswer:
    """Fit a player's bat speed and scatter to measured swings, and advise a bat and a contact point.

    Parameters
    ----------
    swings : CSV or Parquet, a row per swing.
    bat : the player's; None: the one most swung in the file.
    batter : whose rows to use, where the file has several.
    pitch_speed : m/s at the plate, for rows without one; 0, or "tee" as a text: the ball is at rest.
    others : bats to try, by name or file.

    Raises
    ------
    InputError
        for a file that cannot be read, tells too little of a player, or has a misspelt bat.
    """
    from sweetspot.answers.player import fit_player_answer
    from sweetspot.answers.player_question import FitPlayerQuestion

    question = FitPlayerQuestion(
        Path(swings),
        bat=None if bat is None else round_bat(bat),
        batter=batter,
        pitch_speed=None if pitch_speed is None else value_of(pitch_speed),
        goal=Goal(wanted.goal, wanted.line),
        other_bats=[catalog.load_bat(name) for name in others],
        air=air.air,
    )
    return fit_player_answer(question)


@dataclass(frozen=True, kw_only=True)
class SwingerSetup:
    """What is thought of a player before the swings of a plan; None: what is usual.

    Parameters
    ----------
    bat_speed, bat_speed_spread : m/s, mean and from swing to swing.
    contact_spread : m, of contact along the bat.
    """

    bat_speed: float | None = None
    bat_speed_spread: float | None = None
    contact_spread: float | None = None


@dataclass(frozen=True, kw_only=True)
class SheetSetup:
    """The sheet of a plan of swings.

    Parameters
    ----------
    filled : with the swings made so far; None: none were made.
    pitch_speed : m/s at the plate, for rows without one; 0, or "tee" as a text: the ball is at rest.
    batch : swings after which it is asked whether to stop.
    """

    filled: Path | str | None = None
    pitch_speed: float | None = None
    batch: int = 20


WITHIN: Mapping[Aim, float] = {"exponent": 0.07, "position": 0.5 * INCH}
"""Half the 90 % interval that a plan of swings aims at: half of what is not known of any player, and a tape's width."""


def plan_swings(
    *bats: str,
    find: Aim = "exponent",
    within: float | str | None = None,
    lead: bool = True,
    swinger: SwingerSetup = SwingerSetup(),
    sheet: SheetSetup = SheetSetup(),
) -> PlanSwingsAnswer:
    """Plan the swings that find how a heavier bat slows a player, or where the ball is met; then stop or go on.

    Parameters
    ----------
    bats : the player's own, then others at hand, by name or file.
    find : "exponent" of bat speed against moment of inertia, or mean contact "position".
    within : half the 90 % interval wanted, of the exponent or in m (a text: with its unit); None: 0.07, 0.5 in.
    lead : whether lead tape may go on the player's own bat.

    Raises
    ------
    InputError
        for bats or errors that no plan can be made with, or a sheet that cannot be read.
    """
    from sweetspot.answers.plan_swings import PlanSwingsQuestion, plan_swings_answer

    question = PlanSwingsQuestion(
        bats=tuple(catalog.load_bat(name) for name in bats),
        aim=find,
        within=WITHIN[find] if within is None else _error_wanted(within, find),
        bat_speed=swinger.bat_speed,
        bat_speed_spread=swinger.bat_speed_spread,
        position_spread=swinger.contact_spread,
        lead=lead,
        filled=None if sheet.filled is None else Path(sheet.filled),
        pitch_speed=sheet.pitch_speed,
        batch=sheet.batch,
    )
    return plan_swings_answer(question)


def _error_wanted(within: float | str, find: Aim) -> float:
    if isinstance(within, float | int):
        return float(within)
    if find == "position":
        return parse(within, "length", "within")
    try:
        return float(within)
    except ValueError:
        raise InputError(f"within was given as {within}; an exponent's error is a number, for example 0.07") from None


def drop(*, block: BlockSetup = BlockSetup(), fall: FallSetup = FallSetup(), uncertainty: bool = False) -> DropAnswer:
    """Drop or fire a ball on a block: rebound height, restitution, contact time and where the energy goes.

    Parameters
    ----------
    uncertainty : whether every number gets its interval, with what that comes from.

    Raises
    ------
    InputError
        for a height or speed that cannot be, or a ball that does not come back in one clean contact.

    >>> import sweetspot
    >>> round(sweetspot.drop(height="1 m").restitution, 2)
    0.58
    """
    if fall.height is not None and fall.speed is not None:
        raise InputError("give either height or speed, and only one of them")
    if fall.speed is not None and fall.in_air:
        raise InputError("in_air slows a ball that falls; one that is fired arrives as fast as its speed says")
    held, ball = block.block, catalog.ball(fall.ball)
    sources = drop_sources(held, ball, speed_error=error_of(fall.speed)) if uncertainty else None
    question = DropQuestion(
        held,
        ball,
        height=None if fall.speed is not None else 1.0 if fall.height is None else fall.height,
        speed=None if fall.speed is None else value_of(fall.speed),
        air_density=ROOM_AIR if fall.in_air else 0.0,
        sources=sources,
    )
    return drop_answer(question)


def pendulum(
    *,
    mass: Written,
    balance_point: Written,
    period: Written | None = None,
    moi: Written | None = None,
    pivot: Exact = 6 * INCH,
    uncertainty: bool = False,
) -> PendulumAnswer:
    """Turn the period of a hanging bat into its moment of inertia, or back, as laboratories measure it.

    Parameters
    ----------
    mass, balance_point : kg, and m from the knob end.
    period : s, of one full swing to and fro.
    moi : kg m^2 about the pivot; gives the period in place of it.
    pivot : m from the knob end, where the bat hangs.
    uncertainty : whether numbers get intervals, of every error that was written.

    Raises
    ------
    InputError
        for a bat that does not swing about that axis, or is like no implement.

    >>> import sweetspot
    >>> hung = sweetspot.pendulum(mass="30.5 oz", balance_point="22.4 in", period="1.38 s")
    >>> round(hung.moi_oz_in2)
    9316
    """
    swung, timed = (moi, False) if period is None else (period, True)
    if swung is None or (period is not None and moi is not None):
        raise InputError("give either period or moi, and only one of them")
    weighed, balanced, hung, swings = (
        Measured(value_of(each), error_of(each) if uncertainty else 0.0) for each in (mass, balance_point, pivot, swung)
    )
    return checked_pendulum(PendulumQuestion(weighed, balanced, hung, swings, timed=timed, uncertain=uncertainty))

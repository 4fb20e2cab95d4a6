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
    AS_USUAL,
    BlockSetup,
    Exact,
    ExactPlace,
    FallSetup,
    HitSetup,
    Place,
    Written,
    error_of,
    round_bat,
    value_of,
)
from sweetspot.calibration.measured import Measured
from sweetspot.catalog.implements import Loaded
from sweetspot.errors import InputError
from sweetspot.numerics.constants import STANDARD_AXIS
from sweetspot.plausibility import parse
from sweetspot.player.goal import Goal, GoalName
from sweetspot.player.planning import Aim
from sweetspot.seasons.flight_choice import USUAL_FLIGHT, FlightChoice
from sweetspot.units import INCH

if TYPE_CHECKING:
    from sweetspot.answers.calibrate import CalibrateAnswer
    from sweetspot.answers.outline import OutlineAnswer
    from sweetspot.answers.plan_swings import PlanSwingsAnswer
    from sweetspot.answers.player import FitPlayerAnswer
    from sweetspot.answers.rank import RankAnswer
    from sweetspot.answers.season import SeasonAnswer
    from sweetspot.answers.tap import TapAnswer


USUAL_AIR = FieldAir()
DIAMETER_ERROR = 0.003
"""Part of a diameter to which it is known."""


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


def rank(
    table: Path | str,
    *,
    like: Loaded,
    diameter_error: float = DIAMETER_ERROR,
    pivot_of_table: Place | None = None,
    setup: HitSetup = AS_USUAL,
) -> RankAnswer:
    """Rank bats of one model that were weighed, hung and tapped: how fast each hits, how surely, what differs.

    Parameters
    ----------
    table : CSV, one row a bat, or a folder of such files and of calibrated bats.
    like : the model as described.
    diameter_error : how well each bat's diameters are known, as a part of them.
    pivot_of_table : m from the knob end, axis of the table's pendulum and moments; None: that of the swing weight.
    """
    from sweetspot.answers.rank import RankQuestion, rank_answer
    from sweetspot.calibration.bat_table import read_bats, read_folder

    model, path = like.implement.as_drawn(), Path(table)
    axis = model.swing_axis if pivot_of_table is None else pivot_of_table
    read = read_folder(path, model, axis=axis) if path.is_dir() else read_bats(path, axis=axis, sport=model.sport)
    law = None if setup.same_speed else catalog.swing_law(catalog.sport(model.sport).swing_law)
    return rank_answer(RankQuestion(model, read, setup.conditions(model), law, diameter_error, axis))


def tap(*recordings: Path | str, implement: Loaded | None = None, at: Place | None = None) -> TapAnswer:
    """Find the taps in sound recordings, reject the bad ones, and name the tones of the good ones.

    Parameters
    ----------
    recordings : sound files.
    implement : what was tapped; None: unknown, and its tones have no names.
    at : m from the knob end, where it was tapped.
    """
    from sweetspot.answers.tap import TapQuestion, tap_answer
    from sweetspot.calibration.recording import read_recording

    described = None if implement is None else implement.implement.as_drawn()
    if at is not None and described is None:
        raise InputError("at was given without implement; say what was tapped")
    if at is not None and described is not None:
        described.check_position(at, "at")
    heard = [read_recording(Path(path)) for path in recordings]
    return tap_answer(TapQuestion(heard, described, [] if at is None else [at]))


def outline(
    source: Path | str,
    *,
    length: float | None = None,
    ruler: float | None = None,
    camera_distance: float | None = None,
    material: str = "white-ash",
    name: str | None = None,
) -> OutlineAnswer:
    """Turn a table of diameters, a drawing or a photograph into a bat.

    Parameters
    ----------
    source : CSV, SVG, DXF, JPEG or PNG file.
    length, ruler, camera_distance : m, what the file does not hold: of the bat, of a straight ruler beside it in a
        photograph, and from camera to bat.
    material : its name in the catalogue.
    name : what to call the bat; None: the file's name.
    """
    from sweetspot.answers.outline import OutlineQuestion, bat_of_outline, outline_answer
    from sweetspot.calibration.outline.outline_file import read_outline

    path = Path(source)
    measured = read_outline(path, length=length, ruler=ruler, camera_distance=camera_distance)
    bat = bat_of_outline(measured, material=catalog.material(material), name=name or path.stem)
    return outline_answer(OutlineQuestion(measured, bat))


def calibrate(
    implement: Loaded,
    *,
    mass: Written | None = None,
    balance_point: Written | None = None,
    period: Written | None = None,
    moi: Written | None = None,
    pivot: ExactPlace | None = None,
    tones: Mapping[str, float | Measured] | None = None,
) -> CalibrateAnswer:
    """Fit a bat to its measurements, with the uncertainty of each value.

    Parameters
    ----------
    implement : as described.
    mass, balance_point, period, moi : kg, m from the knob end, s of a full swing about the pivot, kg m^2 about it; each
        with its error: ``"31.0oz±0.1oz"``, or ``Measured(value, error)``.
    pivot : m from the knob end; None: the axis of the sport's swing weight.
    tones : in Hz by name, ``{"bending-1": Measured(171.3, 0.5)}``; one without an error is known to 1 Hz.

    Raises
    ------
    InputError
        for a value without an error, or a bat that cannot have what was measured.
    """
    from sweetspot.answers.calibrate import CalibrateQuestion, calibrate_answer
    from sweetspot.calibration.measurements import MeasuredKind, Measurement
    from sweetspot.calibration.mode_naming import MOST_BENDING, ModeName

    drawn = implement.implement.as_drawn()
    axis = drawn.swing_axis if pivot is None else value_of(pivot)
    given: tuple[tuple[MeasuredKind, Written | None], ...] = (
        ("mass", mass),
        ("balance_point", balance_point),
        ("period", period),
        ("moi", moi),
    )
    measurements = []
    for kind, value in given:
        if isinstance(value, Measured):
            measurements.append(Measurement(kind, value, axis=axis if kind in ("period", "moi") else STANDARD_AXIS))
        elif value is not None:
            raise InputError(f"{kind} was given without its error; write '31.0oz±0.1oz', or Measured(value, error)")
    modes = {f"bending-{number}": ModeName("bending", number) for number in range(1, MOST_BENDING + 1)}
    modes["hoop"] = ModeName("hoop", 2)
    for name, hertz in (tones or {}).items():
        if name not in modes:
            raise InputError(f"the tone {name!r} is not known; allowed is one of {', '.join(modes)}")
        frequency = hertz if isinstance(hertz, Measured) else Measured(hertz, 1.0)
        measurements.append(Measurement("frequency", frequency, mode=modes[name]))
    return calibrate_answer(CalibrateQuestion(drawn, measurements))


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

"""`sweetspot fit-player`: what a player's swings say, and which bat and contact point serve."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Literal

from cyclopts import Parameter

from sweetspot.cli.options.output import DEFAULT_OUTPUT, OutputOptions
from sweetspot.cli.options.reading import DEFAULT_COLUMNS, ColumnOptions
from sweetspot.cli.options.weather import DEFAULT_AIR, AirOptions
from sweetspot.errors import InputError

if TYPE_CHECKING:
    from sweetspot.equipment.bat import Bat

ALL = "all"


@Parameter(name="*")
@dataclass(frozen=True)
class FileOptions:
    """What the file of swings does not say itself."""

    bat: Annotated[
        str | None,
        Parameter(help="The player's bat, by name or TOML file; default: the one most swung in the file, or r161-ash."),
    ] = None
    bat_is: Annotated[
        list[str] | None,
        Parameter(help="Which bat a name in the file is: 'Victus Nox=nox.toml'; may be given again."),
    ] = None
    pitch_speed: Annotated[str | None, Parameter(help="At the plate, for rows without one: 82mph, or tee.")] = None
    batter: Annotated[
        str | None, Parameter(help="Whose rows to use, where the file has several; all: a team sheet.")
    ] = None
    bat_speed_at: Annotated[str, Parameter(help="Where the player's bat speed is measured.")] = "6in-from-tip"
    ball: Annotated[
        str | None, Parameter(help="Ball of the catalogue, or a TOML file; default: the first of the bat's sport.")
    ] = None
    columns: ColumnOptions = DEFAULT_COLUMNS


@Parameter(name="*")
@dataclass(frozen=True)
class WantedOptions:
    """What the player wants, and what else to try."""

    goal: Annotated[Literal["exit-speed", "carry", "line"], Parameter(help="What the player wants more of.")] = (
        "exit-speed"
    )
    line: Annotated[str | None, Parameter(help="Distance to pass, for --goal line: 300ft.")] = None
    try_bat: Annotated[
        list[str] | None, Parameter(name="--try", help="Another bat to try on the player; may be given again.")
    ] = None
    seed: Annotated[int, Parameter(help="Of the random numbers; the same seed gives the same answers.")] = 1


DEFAULT_FILE, DEFAULT_WANTED = FileOptions(), WantedOptions()


def fit_player(
    file: Annotated[Path, Parameter(help="CSV or Parquet, a row per swing: Blast, HitTrax, Statcast, ... or plain.")],
    /,
    *,
    given: FileOptions = DEFAULT_FILE,
    wanted: WantedOptions = DEFAULT_WANTED,
    air: AirOptions = DEFAULT_AIR,
    output: OutputOptions = DEFAULT_OUTPUT,
) -> int:
    """Learn a player's bat speed and scatter from measured swings, and say which bat and contact point serve."""
    from sweetspot import catalog
    from sweetspot.answers.player import fit_player_answer
    from sweetspot.answers.player_question import FitPlayerQuestion
    from sweetspot.answers.team import fit_team_answer
    from sweetspot.cli.options.weather import air_of
    from sweetspot.cli.output import present, progress, today
    from sweetspot.plausibility import parse
    from sweetspot.player.goal import Goal
    from sweetspot.reports.player.document import player_document
    from sweetspot.reports.player.team import team_document

    if wanted.seed < 0:
        raise InputError(f"--seed was given as {wanted.seed}; allowed is a whole number from 0 up")
    goal = Goal(wanted.goal, None if wanted.line is None else parse(wanted.line, "length", "--line"))
    if output.out is not None and output.out.exists() and not output.out.is_dir():
        raise InputError(f"{output.out} is not a folder; choose another name for --out")
    bat = None if given.bat is None else catalog.load_bat(given.bat)
    question = FitPlayerQuestion(
        file,
        bat=bat,
        named_bats=_named_bats(given.bat_is or []),
        batter=None if given.batter == ALL else given.batter,
        pitch_speed=_pitch_speed(given.pitch_speed, "baseball" if bat is None else bat.sport),
        speed_from_tip=lambda swung: _measured_at(swung, given.bat_speed_at),
        ball=given.ball,
        columns=given.columns.given(),
        goal=goal,
        other_bats=[catalog.load_bat(name) for name in wanted.try_bat or []],
        air=air_of(air),
        seed=wanted.seed,
    )
    if given.batter == ALL:
        return present(team_document(fit_team_answer(question, progress=progress)), output)
    answer = fit_player_answer(question, progress=progress)
    return present(player_document(answer, player=output.made_for, day=today()), output)


def _named_bats(texts: list[str]) -> dict[str, Bat]:
    """Return which bat a name in the file is."""
    from sweetspot import catalog

    bats = {}
    for text in texts:
        name, equals, bat = text.rpartition("=")
        if not equals or not name.strip():
            raise InputError(
                f"--bat-is was given as {text!r}; write the file's name and the bat, 'Victus Nox=nox.toml'"
            )
        bats[name] = catalog.load_bat(bat.strip())
    return bats


def _measured_at(bat: Bat, text: str) -> float:
    """Return the distance in m from the tip at which bat speed is measured."""
    from sweetspot.plausibility import parse_position

    place = bat.length - parse_position(text, length=bat.length, what="--bat-speed-at")
    if not 0 <= place < bat.length / 2:
        raise InputError(f"--bat-speed-at was given as {text}; allowed is a place on the outer half of the bat")
    return place


def _pitch_speed(text: str | None, sport: str) -> float | None:
    """Return the speed in m/s of pitches whose row has none; None: not given."""
    from sweetspot.plausibility import parse

    if text is None:
        return None
    speed = 0.0 if text.strip().lower() == "tee" else parse(text, "speed", "--pitch-speed", sport=sport)
    if speed < 0:
        raise InputError(f"--pitch-speed was given as {text}; allowed is tee, or a speed at the plate, as 82mph")
    return speed

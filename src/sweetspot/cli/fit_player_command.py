"""`sweetspot fit-player`: what a player's swings say, and which bat and contact point serve."""

from __future__ import annotations

from dataclasses import replace
from datetime import date
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Literal

from cyclopts import Parameter

from sweetspot.cli.options.output import DEFAULT_OUTPUT, OutputOptions
from sweetspot.cli.options.weather import AirOptions
from sweetspot.errors import InputError

if TYPE_CHECKING:
    from sweetspot.player.model import PlayerModel
    from sweetspot.player.swings import Swings

DEFAULT_AIR = AirOptions()


def fit_player(
    file: Annotated[Path, Parameter(help="CSV file, one row per swing: Blast, HitTrax, Statcast or plain.")],
    /,
    *,
    bat: Annotated[str, Parameter(help="The player's bat: a name of the catalogue or a TOML file.")] = "r161-ash",
    goal: Annotated[Literal["exit-speed", "carry", "line"], Parameter(help="What the player wants more of.")] = (
        "exit-speed"
    ),
    line: Annotated[str | None, Parameter(help="Distance to pass, for --goal line: 300ft.")] = None,
    try_bat: Annotated[
        list[str] | None, Parameter(name="--try", help="Another bat to try on the player; may be given again.")
    ] = None,
    pitch_speed: Annotated[str | None, Parameter(help="At the plate, for rows without one: 82mph, or tee.")] = None,
    file_units: Annotated[
        Literal["us", "metric"] | None, Parameter(help="Of the file's columns whose heading names no unit.")
    ] = None,
    batter: Annotated[str | None, Parameter(help="Whose rows to use, where the file has several batters.")] = None,
    bat_speed_at: Annotated[str, Parameter(help="Where the player's bat speed is measured.")] = "6in-from-tip",
    ball: Annotated[str | None, Parameter(help="Ball of the catalogue; default: the first of the bat's sport.")] = None,
    air: AirOptions = DEFAULT_AIR,
    sampler: Annotated[
        Literal["draws", "walkers"],
        Parameter(help="draws: weighted ones, in about a second; walkers: an ensemble that walks, ten times longer."),
    ] = "draws",
    seed: Annotated[int, Parameter(help="Of the random numbers; the same seed gives the same answers.")] = 1,
    title: Annotated[str, Parameter(help="Heading of the report; default: the bat's name.")] = "",
    player: Annotated[str, Parameter(name="--for", help="The player's name, for the report.")] = "",
    output: OutputOptions = DEFAULT_OUTPUT,
) -> int:
    """Learn a player's bat speed and scatter from measured swings, and say which bat and contact point serve."""
    from sweetspot import catalog
    from sweetspot.cli.options.weather import air_of
    from sweetspot.cli.output import present, progress
    from sweetspot.player.advice import advise
    from sweetspot.player.goal import Goal
    from sweetspot.player.posterior import fit_player as fitted
    from sweetspot.report.player.document import player_document
    from sweetspot.units import parse

    if seed < 0:
        raise InputError(f"--seed was given as {seed}; allowed is a whole number from 0 up")
    wanted = Goal(goal, None if line is None else parse(line, "length", "--line"))
    if output.out is not None and output.out.exists() and not output.out.is_dir():
        raise InputError(f"{output.out} is not a folder; choose another name for --out")
    ball = ball or catalog.sport(catalog.load_bat(bat).sport).balls[0]
    law = catalog.aerodynamics_of_ball(ball)
    others = [catalog.load_bat(name) for name in try_bat or []]
    weather = air_of(air)
    swings, model = _read(file, bat, pitch_speed, file_units, batter, bat_speed_at, ball)
    with progress("reading the swings") as report:
        posterior = fitted(model, method=sampler, seed=seed, progress=report)
    with progress("trying bats") as report:
        advice = advise(posterior, goal=wanted, aerodynamics=law, air=weather, others=others, progress=report)
    document = player_document(posterior, advice, swings, title=title, player=player, made=date.today())
    return present(document, output)


def _read(
    file: Path,
    bat: str,
    pitch_speed: str | None,
    units: Literal["us", "metric"] | None,
    batter: str | None,
    bat_speed_at: str,
    ball: str,
) -> tuple[Swings, PlayerModel]:
    """Return the file's swings, those with unknown bats among the bad rows, and the model of the others."""
    from sweetspot import catalog
    from sweetspot.player.model import bats_of, player_model
    from sweetspot.player.player_swing import check_enough
    from sweetspot.player.swings import MOST_SWINGS, evenly, read_swings
    from sweetspot.units import parse, parse_position

    own = catalog.load_bat(bat)
    place = own.length - parse_position(bat_speed_at, length=own.length, what="--bat-speed-at")
    if not 0 <= place < own.length / 2:
        raise InputError(f"--bat-speed-at was given as {bat_speed_at}; allowed is a place on the outer half of the bat")
    arriving = None
    if pitch_speed is not None:
        arriving = 0.0 if pitch_speed.strip().lower() == "tee" else parse(pitch_speed, "speed", "--pitch-speed")
        if not 0 <= arriving <= MAX_PITCH:
            raise InputError(f"--pitch-speed was given as {pitch_speed}; allowed is tee, or up to 110mph at the plate")
    found = read_swings(file, length=own.length, units=units, pitch_speed=arriving, batter=batter)
    good, bats, bad, notes = bats_of(found.swings, load=catalog.load_bat)
    rows = tuple(sorted((*found.bad_rows, *bad), key=lambda row: row.row))
    check_enough(good, file)
    good, thinned = evenly(good, MOST_SWINGS)
    swings = replace(found, swings=good, bad_rows=rows, notes=(*found.notes, *notes, *thinned))
    model = player_model(good, bat=own, ball=catalog.ball(ball), others=bats, speed_from_tip=place)
    return swings, model


MAX_PITCH = 110 * 0.44704
"""m/s."""

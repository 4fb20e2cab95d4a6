"""`sweetspot fit-player`: what a player's swings say, and which bat and contact point serve."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Literal

from cyclopts import Parameter

from sweetspot.cli.options.columns import DEFAULT_COLUMNS, ColumnOptions
from sweetspot.cli.options.output import DEFAULT_OUTPUT, OutputOptions
from sweetspot.cli.options.weather import DEFAULT_AIR, AirOptions
from sweetspot.errors import InputError, maybe_meant, spelt_almost

if TYPE_CHECKING:
    from sweetspot.equipment.bat import Bat
    from sweetspot.player.advice import Advice
    from sweetspot.player.goal import Goal
    from sweetspot.player.model import PlayerModel
    from sweetspot.player.player_swing import PlayerSwing
    from sweetspot.player.posterior import Posterior
    from sweetspot.player.swings import Swings

ALL = "all"
BBCOR, COLLEGE_BAT = "bbcor", "college-alloy"
"""What a bat that is not known has in its name, and the bat that it is then taken for."""


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
    ball: Annotated[str | None, Parameter(help="Ball of the catalogue; default: the first of the bat's sport.")] = None
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
    sampler: Annotated[
        Literal["draws", "walkers"],
        Parameter(help="draws: weighted ones, in about a second; walkers: an ensemble that walks, ten times longer."),
    ] = "draws"
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
    from sweetspot.cli.output import present, progress, today
    from sweetspot.plausibility import parse
    from sweetspot.player.goal import Goal
    from sweetspot.player.posterior import fit_player as fitted
    from sweetspot.report.player.document import player_document

    if wanted.seed < 0:
        raise InputError(f"--seed was given as {wanted.seed}; allowed is a whole number from 0 up")
    goal = Goal(wanted.goal, None if wanted.line is None else parse(wanted.line, "length", "--line"))
    if output.out is not None and output.out.exists() and not output.out.is_dir():
        raise InputError(f"{output.out} is not a folder; choose another name for --out")
    if given.batter == ALL:
        return _team(file, given, wanted, goal, air, output)
    swings, model = _read(file, given)
    with progress("reading the swings") as report:
        posterior = fitted(model, method=wanted.sampler, seed=wanted.seed, progress=report)
    with progress("trying bats") as report:
        advice = _advised(posterior, wanted, goal, air, given, report)
    return present(player_document(posterior, advice, swings, player=output.made_for, day=today()), output)


def _team(
    file: Path, given: FileOptions, wanted: WantedOptions, goal: Goal, air: AirOptions, output: OutputOptions
) -> int:
    """Present one sheet with a row for every batter of a file, each fitted knowing how the others differ."""
    from sweetspot.cli.output import present, progress
    from sweetspot.errors import SweetspotError
    from sweetspot.numerics.threads import side_by_side
    from sweetspot.player.league import population_of
    from sweetspot.player.posterior import fit_player as fitted
    from sweetspot.player.posterior import refitted
    from sweetspot.player.swings import batters
    from sweetspot.report.player.team import team_document
    from sweetspot.report.player.teammate import Teammate

    def fit(name: str) -> tuple[str, Posterior | str]:
        try:
            _, model = _read(file, replace(given, batter=name))
            return name, fitted(model, method=wanted.sampler, seed=wanted.seed).lighter()
        except SweetspotError as error:
            return name, " ".join(str(error).split())

    def ask(member: tuple[str, Posterior]) -> Teammate:
        name, alone = member
        posterior = alone if league is None else refitted(alone, league)
        return Teammate(name, replace(alone, weighted=None), _advised(posterior, wanted, goal, air, given).lighter())

    with progress("reading the swings") as report:
        fits = side_by_side(fit, batters(file, given=given.columns.given()), progress=report)
    known = [(name, fit) for name, fit in fits if not isinstance(fit, str)]
    left_out = [f"{name}: {why}" for name, why in fits if isinstance(why, str)]
    if not known:
        raise InputError(f"{file} has no batter who can be told of: {'; '.join(left_out[:3])}")
    league = population_of([fit for _, fit in known])
    with progress("trying bats") as report:
        members = side_by_side(ask, known, progress=report)
    return present(team_document(members, left_out, goal, league), output)


def _advised(
    posterior: Posterior,
    wanted: WantedOptions,
    goal: Goal,
    air: AirOptions,
    given: FileOptions,
    progress: Callable[[int, int], None] | None = None,
) -> Advice:
    from sweetspot import catalog
    from sweetspot.cli.options.weather import air_of
    from sweetspot.player.advice import advise

    others = [catalog.load_bat(name) for name in wanted.try_bat or []]
    law = catalog.aerodynamics_of_ball(_ball_name(given, posterior.model.bats[0].bat))
    return advise(posterior, goal=goal, aerodynamics=law, air=air_of(air), others=others, progress=progress)


def _ball_name(given: FileOptions, bat: Bat) -> str:
    from sweetspot import catalog

    return given.ball or catalog.sport(bat.sport).balls[0]


def _read(file: Path, given: FileOptions, own: Bat | None = None) -> tuple[Swings, PlayerModel]:
    """Return the file's swings, those with unknown bats among the bad rows, and the model of the others."""
    from sweetspot import catalog
    from sweetspot.catalog.bats import DEFAULT_BAT
    from sweetspot.player.model import bats_of, player_model
    from sweetspot.player.player_swing import check_enough
    from sweetspot.player.swings import MOST_SWINGS, evenly, read_swings

    load, stand_in_for = _bat_names(given)
    is_settled = own is not None
    own = load(given.bat or DEFAULT_BAT) if own is None else own
    table = read_swings(
        file,
        length=own.length,
        given=given.columns.given(),
        pitch_speed=_arriving(given, own.sport),
        batter=given.batter,
        sport=own.sport,
    )
    good, bats, bad, notes = bats_of(table.swings, load=load, stand_in_for=stand_in_for)
    if given.bat is None and not is_settled:  # the file says itself what is swung
        swung = Counter(one.bat for one in good if one.bat in bats).most_common(1)
        if swung:
            return _read(file, given, bats[swung[0][0]])
        if good and BBCOR in good[0].bat.casefold():
            return _read(file, given, stand_in_for(good[0].bat))
    _check_named(good, bats, given, file)
    place = _measured_at(own, given)
    same = {name for name, other in bats.items() if other == own}
    good = tuple(replace(one, bat="") if one.bat in same else one for one in good)
    others = {name: other for name, other in bats.items() if name not in same}
    rows = tuple(sorted((*table.bad_rows, *bad), key=lambda row: row.row))
    check_enough(good, file, rows)
    good, thinned = evenly(good, MOST_SWINGS)
    assumed = (
        ()
        if given.bat or is_settled
        else (f"No bat was named: the swings are taken as made with {own.name}; say --bat.",)
    )
    swings = replace(table, swings=good, bad_rows=rows, notes=(*assumed, *table.notes, *notes, *thinned))
    ball = catalog.ball(_ball_name(given, own))
    law = catalog.swing_law(catalog.sport(own.sport).swing_law)
    return swings, player_model(good, bat=own, ball=ball, others=others, law=law, speed_from_tip=place)


def _bat_names(given: FileOptions) -> tuple[Callable[[str], Bat], Callable[[str], Bat]]:
    """Return what loads a bat by a name of the file, and what gives the bat that an unknown name is taken for."""
    from sweetspot import catalog
    from sweetspot.catalog.bats import DEFAULT_BAT
    from sweetspot.player.swing_table import one_name

    said = {}
    for text in given.bat_is or []:
        name, equals, bat = text.rpartition("=")
        if not equals or not name.strip():
            raise InputError(
                f"--bat-is was given as {text!r}; write the file's name and the bat, 'Victus Nox=nox.toml'"
            )
        said[one_name(name)] = catalog.load_bat(bat.strip())

    def load(name: str) -> Bat:
        known = said.get(one_name(name))
        return catalog.load_bat(name) if known is None else known

    def stand_in_for(name: str) -> Bat:
        return catalog.load_bat(given.bat or (COLLEGE_BAT if BBCOR in name.casefold() else DEFAULT_BAT))

    return load, stand_in_for


def _check_named(swings: tuple[PlayerSwing, ...], known: dict[str, Bat], given: FileOptions, file: Path) -> None:
    """Refuse a misspelt bat where nobody says which it is; with ``--bat``, or by a name of one's own, it is taken."""
    from sweetspot import catalog

    names = sorted({one.bat for one in swings} - {"", *known})
    if names and given.bat is None and spelt_almost(names[0], catalog.bat_names()):
        meant = maybe_meant(names[0], catalog.bat_names())
        raise InputError(f"{file} has the bat {meant}: mend the name, or say which bat it is with --bat")


def _measured_at(own: Bat, given: FileOptions) -> float:
    """Return how far in m from the tip bat speed is measured."""
    from sweetspot.plausibility import parse_position

    place = own.length - parse_position(given.bat_speed_at, length=own.length, what="--bat-speed-at")
    if not 0 <= place < own.length / 2:
        raise InputError(
            f"--bat-speed-at was given as {given.bat_speed_at}; allowed is a place on the outer half of the bat"
        )
    return place


def _arriving(given: FileOptions, sport: str) -> float | None:
    """Return the speed in m/s of pitches whose row has none; None: not said."""
    from sweetspot.plausibility import parse

    text = given.pitch_speed
    if text is None:
        return None
    arriving = 0.0 if text.strip().lower() == "tee" else parse(text, "speed", "--pitch-speed", sport=sport)
    if arriving < 0:
        raise InputError(f"--pitch-speed was given as {text}; allowed is tee, or a speed at the plate, as 82mph")
    return arriving

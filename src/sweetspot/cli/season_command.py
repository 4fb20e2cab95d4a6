"""`sweetspot season`: a season's table, every ball of it."""

from __future__ import annotations

import sys
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

from cyclopts import Parameter

from sweetspot.cli.options.output import DEFAULT_OUTPUT, OutputOptions
from sweetspot.cli.options.reading import DEFAULT_COLUMNS, ColumnOptions
from sweetspot.cli.options.weather import DEFAULT_GAMES_AIR, GamesAirOptions
from sweetspot.errors import InputError
from sweetspot.units import grouped

if TYPE_CHECKING:
    from sweetspot.answers.season import SeasonAnswer
    from sweetspot.flight.park import Park
    from sweetspot.seasons.flight_choice import FlightChoice
    from sweetspot.tables.headings import GivenColumns

FENCE_HEIGHT = "8ft"


@Parameter(name="*")
@dataclass(frozen=True)
class SwungOptions:
    """What was swung, and what else to try."""

    bat: Annotated[str | None, Parameter(help="Bat of all hitters: a name of the catalogue or a TOML file.")] = None
    bats: Annotated[
        Path | None, Parameter(help="CSV with columns batter and bat; a row without a batter is all others' bat.")
    ] = None
    try_bat: Annotated[
        list[str] | None, Parameter(name="--try", help="Another bat that every swing is tried with; may be repeated.")
    ] = None
    flight_only: Annotated[bool, Parameter(negative="", help="Leave the bats out.")] = False

    def named(self) -> dict[str, str] | None:
        """Return the bat of each batter, under "" that of all others; None: nothing was said."""
        from sweetspot.seasons.batters import read_bats

        if self.bat is not None and self.bats is not None:
            raise InputError(
                "--bat and --bats were both given; put the bat of all others into the table, without a batter"
            )
        if self.bats is not None:
            return read_bats(self.bats)
        return None if self.bat is None else {"": self.bat}


@Parameter(name="*")
@dataclass(frozen=True)
class BallsOptions:
    """How the balls fly, and over which fence where the tables do not tell."""

    ball: Annotated[str, Parameter(help="Ball of the catalogue; its sport's drag and lift are taken.")] = "baseball"
    law: Annotated[
        str | None, Parameter(help="Another law of drag and lift, such as college-baseball; default: the sport's.")
    ] = None
    drag: Annotated[
        float | None,
        Parameter(help="Drag over the law's: 1 is the law's own; default: what the tracked distances say."),
    ] = None
    park: Annotated[
        str | None,
        Parameter(help="Park or kind of field of balls whose table names none that is known: coors, college."),
    ] = None
    fence: Annotated[
        str | None,
        Parameter(
            help="A field given by its fence instead: distances at even angles from the left foul pole to the right "
            "one, 330ft,375ft,400ft,375ft,330ft."
        ),
    ] = None
    fence_height: Annotated[str, Parameter(help="Height of that fence: 8ft.")] = FENCE_HEIGHT
    air: GamesAirOptions = DEFAULT_GAMES_AIR

    def choice(self) -> FlightChoice:
        """Return how balls fly."""
        from sweetspot.seasons.flight_choice import FlightChoice

        return FlightChoice(ball=self.ball, law=self.law, drag=self.drag, park=self._field())

    def _field(self) -> Park | None:
        """Return the field of balls whose table names no park, at the elevation that was given in place of its own."""
        from sweetspot.catalog.ballparks import fenced_field, park
        from sweetspot.plausibility import parse

        if self.park is not None and self.fence is not None:
            raise InputError("--park and --fence were both given; give --park, a known field, or --fence, your own")
        if self.fence is None and self.fence_height != FENCE_HEIGHT:
            raise InputError("--fence-height was given without --fence; say how far away that fence is, too")
        above = None if self.air.elevation is None else parse(self.air.elevation, "length", "--elevation")
        if self.fence is not None:
            distances = [parse(text.strip(), "length", "--fence") for text in self.fence.split(",")]
            height = parse(self.fence_height, "length", "--fence-height")
            return fenced_field(distances, height=height, elevation=above or 0.0)
        if self.park is None:
            return None
        found = park(self.park)
        return found if above is None else found.replaced(elevation=above)


@Parameter(name="*")
@dataclass(frozen=True)
class SeasonColumnOptions:
    """What the columns of the tables mean, and whether that is all that is asked."""

    columns: ColumnOptions = DEFAULT_COLUMNS
    show_columns: Annotated[
        bool, Parameter(negative="", help="Print what the columns of the files mean, and stop.")
    ] = False


@Parameter(name="*")
@dataclass(frozen=True)
class WorkOptions:
    """Who does the work, and what of it is done already."""

    resume: Annotated[
        bool, Parameter(negative="", help="Keep answers that are in --out already and of the same plan.")
    ] = False
    balls_csv: Annotated[
        bool, Parameter(negative="", help="Also write every ball with all answers as CSV, balls.csv in --out.")
    ] = False
    workers: Annotated[
        int, Parameter(help="Processes that share the work (needs Dask, sweetspot[cluster]); 0: this one alone.")
    ] = 0
    scheduler: Annotated[
        str | None, Parameter(help="A running Dask scheduler, tcp://HOST:8786, whose workers see the same folders.")
    ] = None

    def __post_init__(self) -> None:
        """Refuse a number of processes that cannot be started."""
        if self.workers < 0:
            raise InputError(f"--workers was given as {self.workers}; allowed is 0 (this process alone) and up")

    @property
    def needs_folder(self) -> str:
        """Why --out must be given; "": it need not."""
        if self.resume:
            return "--resume needs --out, the folder that holds the answers so far"
        if self.balls_csv:
            return "--balls-csv needs --out, the folder for balls.csv"
        if self.workers or self.scheduler:
            return "--workers and --scheduler need --out, the folder that all of them write to"
        return ""


DEFAULT_SWUNG, DEFAULT_SEASON_COLUMNS, DEFAULT_WORK = SwungOptions(), SeasonColumnOptions(), WorkOptions()
DEFAULT_BALLS = BallsOptions()


def season(
    files: Annotated[list[Path], Parameter(help="Tables: Statcast exports, Trackman, plain; CSV, .csv.gz, Parquet.")],
    /,
    *,
    bats: SwungOptions = DEFAULT_SWUNG,
    columns: SeasonColumnOptions = DEFAULT_SEASON_COLUMNS,
    balls: BallsOptions = DEFAULT_BALLS,
    player: Annotated[
        str | None, Parameter(help="A batter's number or name: a page to print of that player alone.")
    ] = None,
    work: WorkOptions = DEFAULT_WORK,
    output: OutputOptions = DEFAULT_OUTPUT,
) -> int:
    """Tell every ball in play of tables of any size: where on the bat it was hit, how far it carries, who did what."""
    given = columns.columns.given()
    if columns.show_columns:
        return _show_columns(files, given)
    if output.out is None and work.needs_folder:
        raise InputError(work.needs_folder)
    from functools import partial

    from sweetspot.answers.season import season_answer
    from sweetspot.answers.season_question import SeasonQuestion, checked_season
    from sweetspot.cli.options.weather import weather_of
    from sweetspot.cli.output import progress
    from sweetspot.seasons.cluster import run_on_cluster

    question = checked_season(
        SeasonQuestion(
            paths=files,
            bats=bats.named(),
            others=bats.try_bat or (),
            contact=not bats.flight_only,
            air=weather_of(balls.air),
            flights=balls.choice(),
            given=given,
            system=output.units or "us",
            player=player,
            folder=output.out,
            resume=work.resume,
        )
    )
    run = partial(run_on_cluster, workers=work.workers, scheduler=work.scheduler)
    try:
        with progress("season") as report:
            answer = season_answer(question, run=run, progress=report)
        return _presented(answer, output, balls_csv=work.balls_csv)
    except KeyboardInterrupt:
        if output.out is None:
            raise
        words = f"interrupted; what is done lies in {output.out}, and --resume goes on"
        raise KeyboardInterrupt(words) from None


def _presented(answer: SeasonAnswer, output: OutputOptions, *, balls_csv: bool) -> int:
    from sweetspot.cli.output import note, present
    from sweetspot.reports.season.document import (
        player_page,
        season_document,
        unread_of,
        write_balls,
        write_tables,
    )

    if output.out is not None:
        written = write_tables(answer, output.out)
        if balls_csv:
            written.append(write_balls(answer, output.out))
        tables = f"; {', '.join(written)}" if written else ""
        note(f"wrote {output.out}: folders balls, ledger, counted{tables}")
    player = answer.question.player
    code = present(season_document(answer) if player is None else player_page(answer.player(player)), output, long=True)
    for fault in unread_of(answer):
        print(f"sweetspot: not read: {fault}", file=sys.stderr)
    return max(code, int(bool(answer.not_read)))


def _show_columns(files: list[Path], given: GivenColumns) -> int:
    from tempfile import TemporaryDirectory

    from sweetspot.seasons.table_file import open_table

    bad = 0
    with TemporaryDirectory(prefix="sweetspot-season-") as folder:
        for number, path in enumerate(files):
            try:
                table = open_table(path, staging=Path(folder) / str(number), given=given)
            except InputError as error:
                print(f"sweetspot: not read: {error}", file=sys.stderr)
                bad = 1
                continue
            print(f"{path.name}: {table.headings.system}, {grouped(table.lines)} rows")
            for name, column in table.headings.columns.items():
                print(f"  {name:<18}{column.heading}{f' [{column.unit}]' if column.unit else ''}")
            print(f"  passed through: {', '.join(table.headings.passed) or 'nothing'}")
            for note in table.notes:
                print(f"  note: {note}")
    return bad

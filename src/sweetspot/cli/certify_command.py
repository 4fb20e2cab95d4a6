"""The `certify` command: the bat test, measured or simulated, and a league's rules."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

from cyclopts import Parameter

from sweetspot.cli.options.output import DEFAULT_OUTPUT, OutputOptions
from sweetspot.cli.options.reading import DEFAULT_COLUMNS, ColumnOptions, Uncertainty
from sweetspot.errors import InputError

if TYPE_CHECKING:
    from sweetspot.analysis.certification.shots import Shots
    from sweetspot.catalog.implements import Loaded


@Parameter(name="*")
@dataclass(frozen=True)
class PaddleOptions:
    """The test of a paddle."""

    speed: Annotated[
        str | None, Parameter(help="Paddles: of the ball fired at it: 50mph; default: 60mph, as in the rules.")
    ] = None
    clamp_inertia: Annotated[
        str | None, Parameter(help="Paddles: of the clamp about its axis: '12.15 kg*cm^2'; default: 33 kg*cm^2.")
    ] = None


DEFAULT_PADDLE = PaddleOptions()


@Parameter(name="*")
@dataclass(frozen=True)
class ShotOptions:
    """Measured shots, in the place of a computed test, and how a paddle is tested."""

    shots: Annotated[Path | None, Parameter(help="CSV file of measured shots; without it the test is computed.")] = None
    standard_ball_cor: Annotated[
        str | None, Parameter(help="Restitution that shots are normalised to; default: the ball's at 60 mph.")
    ] = None
    columns: ColumnOptions = DEFAULT_COLUMNS
    paddle: PaddleOptions = DEFAULT_PADDLE


DEFAULT_SHOTS = ShotOptions()


def certify(
    bat: Annotated[str | None, Parameter(help="Name in the catalogue (see `sweetspot bats`) or a TOML file.")] = None,
    /,
    *,
    league: Annotated[
        str | None,
        Parameter(help="League of the catalogue, or all that use the ball; default: that of the bat's sport."),
    ] = None,
    shooting: ShotOptions = DEFAULT_SHOTS,
    ball: Annotated[str | None, Parameter(help="Ball of the catalogue, or a TOML file; default: the league's.")] = None,
    wall_that_passes: Annotated[
        bool, Parameter(negative="", help="Also say which barrel wall of a hollow bat would just pass.")
    ] = False,
    uncertainty: Uncertainty = False,
    output: OutputOptions = DEFAULT_OUTPUT,
) -> int:
    """Test a bat: BBCOR, BESR, BPF and a league's rules, with margin; a paddle: PBCoR; a golf club: CT.

    Exit 1 when a rule fails or none can be decided.
    """
    from sweetspot.analysis.certification.shots import read_shots
    from sweetspot.answers.ask_bat import certify as asked
    from sweetspot.answers.ask_bat import certify_club
    from sweetspot.catalog.implements import loaded_bat, loaded_implement
    from sweetspot.cli.output import present
    from sweetspot.equipment.golf_club import GolfClub
    from sweetspot.equipment.paddle import Paddle
    from sweetspot.plausibility import parse

    if bat is None:
        raise InputError("certify needs a bat: BBCOR takes the recoil from its weight, balance and moment of inertia")
    shots, cor = shooting.shots, shooting.standard_ball_cor
    if cor is not None and shots is None:
        raise InputError("--standard-ball-cor normalises measured shots; give them with --shots")
    loaded, columns = loaded_implement(bat), shooting.columns.given()
    if isinstance(loaded.implement, Paddle):
        if cor is not None or wall_that_passes:
            raise InputError("--standard-ball-cor and --wall-that-passes are for bats; a paddle has no wall")
        fired = None if shots is None else read_shots(shots, length=loaded.implement.length, given=columns)
        return _paddle(loaded, shooting.paddle, league=league, ball=ball, shots=fired, output=output)
    if shooting.paddle != DEFAULT_PADDLE:
        raise InputError("--speed and --clamp-inertia are for paddles; a bat is tested at its league's speed")
    if isinstance(loaded.implement, GolfClub):
        if shots is not None or wall_that_passes or uncertainty:
            raise InputError(
                "--shots, --wall-that-passes and --uncertainty are for bats; a club is tested by the characteristic "
                "time of its face, which its file can have as it was read: [head] characteristic_time"
            )
        club = certify_club(loaded, league=league, ball=ball)
        return present(club, output)
    loaded = loaded_bat(bat)
    answer = asked(
        loaded,
        league=league,
        ball=ball,
        shots=None if shots is None else read_shots(shots, length=loaded.implement.length, given=columns),
        standard_ball_cor=None if cor is None else parse(cor, "ratio", "--standard-ball-cor"),
        wall_that_passes=wall_that_passes,
        uncertainty=uncertainty,
    )
    return present(answer, output)


def _paddle(
    loaded: Loaded,
    asked: PaddleOptions,
    *,
    league: str | None,
    ball: str | None,
    shots: Shots | None,
    output: OutputOptions,
) -> int:
    """Test a paddle."""
    from sweetspot.answers.ask_bat import certify_paddle
    from sweetspot.cli.output import present
    from sweetspot.plausibility import check, parse

    speed = None if asked.speed is None else parse(asked.speed, "speed", "--speed")
    if speed is not None:
        check(speed, "--speed", str(asked.speed), quantity="fired_speed")
    moi = None if asked.clamp_inertia is None else parse(asked.clamp_inertia, "moi", "--clamp-inertia")
    if moi is not None:
        check(moi, "--clamp-inertia", str(asked.clamp_inertia), quantity="clamp_inertia")
    answer = certify_paddle(loaded, league=league, ball=ball, speed=speed, clamp_inertia=moi, shots=shots)
    return present(answer, output)

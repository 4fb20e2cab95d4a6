"""The `certify` command: the bat test, measured or simulated, and a league's rules."""

from __future__ import annotations

from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

from cyclopts import Parameter

from sweetspot.cli.options.columns import DEFAULT_COLUMNS, ColumnOptions
from sweetspot.cli.options.output import DEFAULT_OUTPUT, OutputOptions
from sweetspot.cli.options.uncertainty import Uncertainty
from sweetspot.errors import InputError

if TYPE_CHECKING:
    from sweetspot.analysis.certification.passing_wall import PassingWall
    from sweetspot.analysis.certification.rules import League
    from sweetspot.analysis.certification.shot_statistics import Measured
    from sweetspot.analysis.certification.shots import Shots
    from sweetspot.dynamics.rigid import RigidBody
    from sweetspot.equipment.ball import Ball
    from sweetspot.equipment.bat import Bat
    from sweetspot.report.certification.tested_bat import TestedBat
    from sweetspot.report.document import Document

ALL = "all"


@Parameter(name="*")
@dataclass(frozen=True)
class ShotOptions:
    """Measured shots, in the place of a computed test."""

    shots: Annotated[Path | None, Parameter(help="CSV file of measured shots; without it the test is computed.")] = None
    standard_ball_cor: Annotated[
        str | None, Parameter(help="Restitution that shots are normalised to; default: the ball's at 60 mph.")
    ] = None
    columns: ColumnOptions = DEFAULT_COLUMNS


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
    ball: Annotated[str | None, Parameter(help="Ball of the catalogue; default: the league's.")] = None,
    wall_that_passes: Annotated[
        bool, Parameter(negative="", help="Also say which barrel wall of a hollow bat would just pass.")
    ] = False,
    uncertainty: Uncertainty = False,
    output: OutputOptions = DEFAULT_OUTPUT,
) -> int:
    """Test a bat: BBCOR, BESR, BPF and a league's rules, with margin. Exit 1 when one fails or none can be decided."""
    from sweetspot import catalog
    from sweetspot.catalog.rules import DEFAULT_LEAGUE
    from sweetspot.cli.output import patience, present
    from sweetspot.dynamics.beam import beam_model
    from sweetspot.dynamics.rigid import rigid_body
    from sweetspot.report.certification.document import tested_document
    from sweetspot.report.certification.tested_bat import held_to_rules, tested_by_model

    if bat is None:
        raise InputError("certify needs a bat: BBCOR takes the recoil from its weight, balance and moment of inertia")
    shots, standard_ball_cor = shooting.shots, shooting.standard_ball_cor
    if standard_ball_cor is not None and shots is None:
        raise InputError("--standard-ball-cor normalises measured shots; give them with --shots")
    described = catalog.load_bat(bat)
    leagues, chosen = _leagues(league or catalog.sport(described.sport).rules or DEFAULT_LEAGUE, ball)
    if shots is None:
        with patience():
            tested = tested_by_model(described, leagues, ball=chosen)
    else:
        body = rigid_body(beam_model(described))
        read, test = _measured(shooting, shots, described, body=body, ball=chosen)
        tested = held_to_rules(described, leagues, ball=chosen, body=body, test=test, shots=read)
    if wall_that_passes:
        with patience():
            tested = replace(tested, walls=_walls(leagues, described, chosen))
    if not uncertainty:
        return present(tested_document(tested), output)
    with patience():
        document = _with_doubt(tested, bat)
    return present(document, output)


def _with_doubt(tested: TestedBat, name: str) -> Document:
    """Return a test with intervals, and how probable it is that the bat passes each rule."""
    from sweetspot.catalog.standard_hit import standard_conditions
    from sweetspot.cli.options.swing import SwingOptions
    from sweetspot.cli.options.uncertainty import sources_for
    from sweetspot.report.uncertainty.doubtful_answers import certificate_with_doubt

    conditions = standard_conditions(tested.bat).replaced(ball=tested.ball)
    return certificate_with_doubt(tested, conditions, sources_for(name, tested.bat, conditions, SwingOptions()))


def _leagues(name: str, ball_name: str | None) -> tuple[list[League], Ball]:
    """Return the leagues asked for and the ball; ``all`` means every league that uses the ball."""
    from sweetspot import catalog
    from sweetspot.catalog.balls import DEFAULT_BALL
    from sweetspot.catalog.rules import league, league_names
    from sweetspot.units import insisted

    if name.strip().lower() == ALL:
        ball_name = ball_name or DEFAULT_BALL
        sport = catalog.ball(ball_name)
        using = [one for one in map(league, league_names()) if catalog.ball(one.ball) == sport]
        if not using:
            raise InputError(f"no league's rules name the ball {ball_name!r}; give one league with --league NAME")
        return using, sport
    one = league(name)
    wanted, own = (catalog.sport(catalog.ball_sport(each)).name.lower() for each in (ball_name or one.ball, one.ball))
    if wanted != own and not insisted():
        raise InputError(
            f"--ball was given as {ball_name}, a ball of {wanted}; {one.key} tests bats with a ball of {own}. Leave "
            "--ball out, or add --force if it is meant"
        )
    return [one], catalog.ball(ball_name or one.ball)


def _walls(leagues: list[League], bat: Bat, ball: Ball) -> list[tuple[League, PassingWall]]:
    """Return the wall that would just pass every league's limit on BBCOR or BPF."""
    from sweetspot.analysis.certification.passing_wall import MEASURES
    from sweetspot.analysis.certification.passing_wall import wall_that_passes as thinnest

    limits = [(one, rule) for one in leagues for rule in one.rules if rule.quantity in MEASURES and rule.most]
    if not limits:
        raise InputError("no rule of this league limits BBCOR or BPF; leave --wall-that-passes out")
    return [
        (one, thinnest(bat, ball=ball, limit=rule.most, measure=rule.quantity)) for one, rule in limits if rule.most
    ]


def _measured(given: ShotOptions, path: Path, bat: Bat, *, body: RigidBody, ball: Ball) -> tuple[Shots, Measured]:
    from sweetspot.analysis.certification.shot_statistics import measure
    from sweetspot.analysis.certification.shots import read_shots
    from sweetspot.units import parse

    read = read_shots(path, length=bat.length, given=given.columns.given())
    standard = given.standard_ball_cor
    wanted = None if standard is None else parse(standard, "ratio", "--standard-ball-cor")
    return read, measure(
        read.shots, bat=bat, body=body, ball=ball, standard_restitution=wanted, unused=read.bad_rows
    )  # fmt: skip

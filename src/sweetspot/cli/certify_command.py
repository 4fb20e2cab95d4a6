"""The `certify` command: the bat test, measured or simulated, and a league's rules."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

from cyclopts import Parameter

from sweetspot.cli.options.columns import DEFAULT_COLUMNS, ColumnOptions
from sweetspot.cli.options.output import DEFAULT_OUTPUT, OutputOptions
from sweetspot.cli.options.uncertainty import Uncertainty
from sweetspot.errors import InputError

if TYPE_CHECKING:
    from sweetspot.analysis.certification.rules import League
    from sweetspot.equipment.ball import Ball
    from sweetspot.equipment.bat import Bat
    from sweetspot.uncertainty.sources import Sources

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
    from sweetspot.analysis.certification.shots import read_shots
    from sweetspot.answers.certify import CertifyQuestion, certify_answer
    from sweetspot.catalog.rules import DEFAULT_LEAGUE
    from sweetspot.cli.output import patience, present
    from sweetspot.plausibility import parse
    from sweetspot.report.certification.document import certificate_document

    if bat is None:
        raise InputError("certify needs a bat: BBCOR takes the recoil from its weight, balance and moment of inertia")
    shots, cor = shooting.shots, shooting.standard_ball_cor
    if cor is not None and shots is None:
        raise InputError("--standard-ball-cor normalises measured shots; give them with --shots")
    described = catalog.load_bat(bat)
    leagues, chosen = _leagues(league or catalog.sport(described.sport).rules or DEFAULT_LEAGUE, ball)
    question = CertifyQuestion(
        described,
        leagues,
        chosen,
        shots=None if shots is None else read_shots(shots, length=described.length, given=shooting.columns.given()),
        standard_restitution=None if cor is None else parse(cor, "ratio", "--standard-ball-cor"),
        passing_wall=wall_that_passes,
        sources=_sources(bat, described, chosen) if uncertainty else None,
    )
    with patience():
        answer = certify_answer(question)
    return present(certificate_document(answer), output)


def _sources(name: str, bat: Bat, ball: Ball) -> Sources:
    """Return what is not known of a hit with this bat."""
    from sweetspot.catalog.standard_hit import standard_conditions
    from sweetspot.cli.options.swing import SwingOptions
    from sweetspot.cli.options.uncertainty import sources_for

    return sources_for(name, bat, standard_conditions(bat).replaced(ball=ball), SwingOptions())


def _leagues(name: str, ball_name: str | None) -> tuple[list[League], Ball]:
    """Return the leagues asked for and the ball; ``all`` means every league that uses the ball."""
    from sweetspot import catalog
    from sweetspot.catalog.balls import DEFAULT_BALL
    from sweetspot.catalog.rules import league, league_names
    from sweetspot.plausibility import insisted

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

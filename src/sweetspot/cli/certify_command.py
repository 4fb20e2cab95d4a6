"""The `certify` command: the bat test, measured or simulated, and a league's rules."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Annotated

from cyclopts import Parameter

from sweetspot.cli.options.output import DEFAULT_OUTPUT, OutputOptions
from sweetspot.cli.options.reading import DEFAULT_COLUMNS, ColumnOptions, Uncertainty
from sweetspot.errors import InputError


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
    ball: Annotated[str | None, Parameter(help="Ball of the catalogue, or a TOML file; default: the league's.")] = None,
    wall_that_passes: Annotated[
        bool, Parameter(negative="", help="Also say which barrel wall of a hollow bat would just pass.")
    ] = False,
    uncertainty: Uncertainty = False,
    output: OutputOptions = DEFAULT_OUTPUT,
) -> int:
    """Test a bat: BBCOR, BESR, BPF and a league's rules, with margin. Exit 1 when one fails or none can be decided."""
    from sweetspot.analysis.certification.shots import read_shots
    from sweetspot.answers.ask_bat import certify as asked
    from sweetspot.catalog.implements import loaded_bat
    from sweetspot.cli.output import patience, present
    from sweetspot.plausibility import parse

    if bat is None:
        raise InputError("certify needs a bat: BBCOR takes the recoil from its weight, balance and moment of inertia")
    shots, cor = shooting.shots, shooting.standard_ball_cor
    if cor is not None and shots is None:
        raise InputError("--standard-ball-cor normalises measured shots; give them with --shots")
    loaded, columns = loaded_bat(bat), shooting.columns.given()
    with patience():
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

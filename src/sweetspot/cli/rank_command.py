"""The command `rank`: which of a dozen bats of one model hits best, and whether they differ at all."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

from cyclopts import Parameter

from sweetspot.cli.options.output import DEFAULT_OUTPUT, OutputOptions
from sweetspot.cli.options.swing import DEFAULT_SWING, SwingOptions
from sweetspot.errors import InputError

if TYPE_CHECKING:
    from sweetspot.calibration.measurements import Measurement


def rank(
    table: Annotated[
        Path,
        Parameter(
            help="CSV, one row a bat: name, mass_oz, balance_point_in, pendulum_s, bending_1_hz, moisture_percent; or "
            "a folder of such files."
        ),
    ],
    /,
    *,
    like: Annotated[str, Parameter(help="The model as described: a bat file or a name of the catalogue.")],
    diameter_error: Annotated[str, Parameter(help="How well each bat's diameters are known.")] = "0.3%",
    same_speed: Annotated[
        bool, Parameter(negative="", help="Swing all bats at the same speed, not with the same effort.")
    ] = False,
    swing: SwingOptions = DEFAULT_SWING,
    output: OutputOptions = DEFAULT_OUTPUT,
) -> int:
    """Rank bats of one model that were weighed, hung and tapped: how fast each hits, how surely, what differs."""
    from sweetspot import catalog
    from sweetspot.calibration.likeness import check_likeness
    from sweetspot.calibration.posterior import calibrate
    from sweetspot.calibration.ranking import rank_bats
    from sweetspot.calibration.unknowns import described, unknowns_of
    from sweetspot.catalog.swing_laws import swing_law
    from sweetspot.cli.options.swing import conditions_for
    from sweetspot.cli.output import patience, present, progress
    from sweetspot.report.calibration.ranking_report import ranking_document
    from sweetspot.units import parse

    model = catalog.load_bat(like)
    measured = _measured(table)
    check_likeness(measured, model)
    unknowns = unknowns_of(model, diameter_spread=parse(diameter_error, "ratio", "--diameter-error"))
    line, law = described(model), None if same_speed else swing_law(catalog.sport(model.sport).swing_law)
    with progress("bats") as step, patience():
        posteriors = {}
        for count, (name, given) in enumerate(measured.items(), start=1):
            try:
                posteriors[name] = calibrate(line, unknowns, given)
            except InputError as error:
                raise InputError(f"{name}: {error}") from None
            step(count, len(measured))
        ranking = rank_bats(posteriors, conditions=conditions_for(model, swing), law=law)
    return present(ranking_document(ranking, model=model.name), output)


def _measured(table: Path) -> dict[str, list[Measurement]]:
    """Return what was measured on each bat: of a table, or of all tables of a folder."""
    from sweetspot.calibration.bat_table import read_bats

    if not table.is_dir():
        return read_bats(table)
    files = sorted(table.glob("*.csv"))
    if not files:
        raise InputError(f"{table} holds no CSV file; put one with the bats' measurements there")
    measured: dict[str, list[Measurement]] = {}
    for file in files:
        for name, given in read_bats(file).items():
            if name in measured:
                raise InputError(f"{file}: there are two bats of the name {name!r}; give each its own")
            measured[name] = given
    return measured

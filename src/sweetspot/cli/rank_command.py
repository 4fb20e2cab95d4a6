"""The command `rank`: which of a dozen bats of one model hits best, and whether they differ at all."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

from cyclopts import Parameter

from sweetspot.cli.options.output import DEFAULT_OUTPUT, OutputOptions
from sweetspot.cli.options.reading import DEFAULT_COLUMNS, ColumnOptions
from sweetspot.cli.options.swing import DEFAULT_SWING, SwingOptions

if TYPE_CHECKING:
    from sweetspot.calibration.measurements import Measurement
    from sweetspot.equipment.implement import Implement
    from sweetspot.tables.headings import GivenColumns


def rank(
    table: Annotated[
        Path,
        Parameter(
            help="CSV, one row a bat: name, mass_oz, balance_point_in, pendulum_s, bending_1_hz, moisture_percent; or "
            "a folder of such files and of bats that calibrate wrote."
        ),
    ],
    /,
    *,
    like: Annotated[str, Parameter(help="The model as described: a file or a name of the catalogue.")],
    diameter_error: Annotated[str, Parameter(help="How well each bat's diameters are known.")] = "0.3%",
    pivot: Annotated[
        str | None,
        Parameter(
            name="--pivot-of-table",
            help="Axis of the table's pendulum and moi, from the knob end; default: 6in, or that of the swing weight.",
        ),
    ] = None,
    columns: ColumnOptions = DEFAULT_COLUMNS,
    swing: SwingOptions = DEFAULT_SWING,
    output: OutputOptions = DEFAULT_OUTPUT,
) -> int:
    """Rank bats of one model that were weighed, hung and tapped: how fast each hits, how surely, what differs."""
    from sweetspot import catalog
    from sweetspot.answers.rank import RankQuestion, rank_answer
    from sweetspot.catalog.swing_laws import swing_law
    from sweetspot.cli.options.swing import conditions_for
    from sweetspot.cli.output import present, progress
    from sweetspot.plausibility import parse, parse_position
    from sweetspot.reports.calibration.ranking_report import ranking_document

    model = catalog.load_implement(like).as_drawn()
    axis = model.swing_axis if pivot is None else parse_position(pivot, length=model.length, what="--pivot-of-table")
    question = RankQuestion(
        model=model,
        bats=_measured(table, axis, model, columns.given()),
        conditions=conditions_for(model, swing),
        law=None if swing.same_speed else swing_law(catalog.sport(model.sport).swing_law),
        diameter_error=parse(diameter_error, "ratio", "--diameter-error"),
        axis=axis,
    )
    with progress("bats") as step:
        answer = rank_answer(question, step=step)
    return present(ranking_document(answer), output)


def _measured(table: Path, axis: float, model: Implement, given: GivenColumns) -> dict[str, list[Measurement]]:
    """Return the measurements of each bat, from a table or from every file of a folder."""
    from sweetspot.calibration.bat_table import read_bats, read_folder

    if table.is_dir():
        return read_folder(table, model, axis=axis, given=given)
    return read_bats(table, axis=axis, sport=model.sport, given=given)

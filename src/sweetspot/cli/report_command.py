"""`sweetspot report`: where a bat hits best, and why."""

from __future__ import annotations

from typing import Annotated

from cyclopts import Parameter

from sweetspot.cli.options.output import DEFAULT_OUTPUT, OutputOptions
from sweetspot.cli.options.swing import DEFAULT_SWING, SwingOptions
from sweetspot.cli.options.uncertainty import Uncertainty, sources_for


def report(
    bat: Annotated[str, Parameter(help="Name in the catalogue (see `sweetspot bats`) or a TOML file.")] = "r161-ash",
    /,
    *,
    appendix: Annotated[
        bool, Parameter(negative="", help="Print tables, constants and sources after the one page of --out.")
    ] = False,
    uncertainty: Uncertainty = False,
    swing: SwingOptions = DEFAULT_SWING,
    output: OutputOptions = DEFAULT_OUTPUT,
) -> int:
    """Say where a bat hits best, why there and not at the end, and what each inch of miss costs."""
    from sweetspot import catalog
    from sweetspot.analysis.bat_analysis import analyse_reduced, check_swing, outweighed
    from sweetspot.answers.report import report_of
    from sweetspot.cli.options.swing import swung_bat
    from sweetspot.cli.output import patience, present
    from sweetspot.dynamics.reduction import reduced_bat
    from sweetspot.report.bat.document import report_document
    from sweetspot.report.bat.unhit import unhit_document

    if output.out is not None:
        from sweetspot.report.file_set import check_folder, files_of

        check_folder(output.out, files_of("report"))
    implement = catalog.load_implement(bat)
    swung = swung_bat(implement, swing)
    conditions = swung.conditions
    with patience():
        reduced = reduced_bat(implement, ball=conditions.ball)
        if outweighed(reduced.body, conditions.ball):
            check_swing(implement, conditions)
            return present(unhit_document(reduced, conditions), output, long=appendix)
        analysis = analyse_reduced(reduced, conditions)
        sources = sources_for(bat, implement, analysis.conditions, swing)
        document = report_document(report_of(analysis, sources, drawn=uncertainty))
    return present(swung.told(document), output, long=appendix)

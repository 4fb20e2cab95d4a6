"""`sweetspot report`: where a bat hits best, and why."""

from __future__ import annotations

from typing import Annotated

from cyclopts import Parameter

from sweetspot.cli.options.output import DEFAULT_OUTPUT, OutputOptions
from sweetspot.cli.options.reading import Uncertainty
from sweetspot.cli.options.swing import DEFAULT_SWING, SwingOptions


def report(
    bat: Annotated[str, Parameter(help="Name in the catalogue (see `sweetspot bats`) or a TOML file.")] = "r161-ash",
    /,
    *,
    uncertainty: Uncertainty = False,
    swing: SwingOptions = DEFAULT_SWING,
    output: OutputOptions = DEFAULT_OUTPUT,
) -> int:
    """Say where a bat hits best, why there and not at the end, and what each inch of miss costs."""
    from sweetspot.answers.ask_bat import report_or_tones
    from sweetspot.catalog.implements import loaded_implement
    from sweetspot.cli.output import present

    if output.out is not None:
        from sweetspot.reports.files import check_folder, files_of

        check_folder(output.out, files_of("report"))
    loaded = loaded_implement(bat)
    setup = swing.setup(loaded.implement)
    answer = report_or_tones(loaded, setup=setup, uncertainty=uncertainty)
    return present(answer, output)

"""`sweetspot kit`: a measuring day in one folder."""

from __future__ import annotations

from typing import Annotated

from cyclopts import Parameter

from sweetspot.cli.options.output import DEFAULT_OUTPUT, OutputOptions


def kit(
    bat: Annotated[str, Parameter(help="What is measured, as described: a name in the catalogue or a TOML file.")],
    /,
    *,
    pieces: Annotated[int, Parameter(help="How many there are to measure: rows of the sheet.")] = 12,
    output: OutputOptions = DEFAULT_OUTPUT,
) -> int:
    """Prepare a measuring day: order of work, a sheet to print or fill in, and the table that rank and calibrate read.

    --out kit writes kit.html, sheet.html, measured.csv and the described bat's file.
    """
    from sweetspot.answers.ask_bench import kit as asked
    from sweetspot.catalog.implements import loaded_implement
    from sweetspot.cli.output import present

    return present(asked(loaded_implement(bat), pieces=pieces), output)

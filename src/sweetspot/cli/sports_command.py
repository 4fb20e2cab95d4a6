"""The command `sports`: what is known of each sport, and how sure."""

from __future__ import annotations

from typing import Annotated

from cyclopts import Parameter

from sweetspot.cli.options.output import DEFAULT_OUTPUT, OutputOptions


def sports(
    name: Annotated[str | None, Parameter(help="One sport in full; without it, all of them.")] = None,
    /,
    *,
    output: OutputOptions = DEFAULT_OUTPUT,
) -> int:
    """List the sports with their balls, implements, speeds and rules, and how sure each number is."""
    from sweetspot.catalog.sports import sport
    from sweetspot.cli.output import patience, present
    from sweetspot.papers.sports import sport_rows
    from sweetspot.reports.sports import sport_document, sports_document

    if name is None:
        return present(sports_document(), output)
    described = sport(name)
    with patience():
        rows = sport_rows(described)
    return present(sport_document(described, rows), output)

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
    from sweetspot.answers.catalogued import sport_answer, sports_answer
    from sweetspot.cli.output import patience, present

    with patience():
        answer = sports_answer() if name is None else sport_answer(name)
    return present(answer, output)

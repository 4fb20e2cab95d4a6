"""The command `parks`: the catalogue's fences."""

from __future__ import annotations

from typing import Annotated

from cyclopts import Parameter

from sweetspot.cli.options.output import DEFAULT_OUTPUT, OutputOptions


def parks(
    park: Annotated[str | None, Parameter(help="Park, old name of it, team or its letters; default: all.")] = None,
    /,
    *,
    output: OutputOptions = DEFAULT_OUTPUT,
) -> int:
    """List the Major League parks, and fields of youth and softball, or one park's fence all the way round."""
    from sweetspot.answers.catalogued import park_answer, parks_answer
    from sweetspot.cli.output import present

    return present(parks_answer() if park is None else park_answer(park), output)

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
    from sweetspot import catalog
    from sweetspot.catalog.ballparks import field_names
    from sweetspot.cli.output import present
    from sweetspot.reports.flight.parks import park_document, parks_document

    if park is not None:
        return present(park_document(catalog.park(park), catalog.parks()), output)
    fields = {name: catalog.park(name) for name in field_names()}
    return present(parks_document({name: catalog.park(name) for name in catalog.park_names()}, fields), output)

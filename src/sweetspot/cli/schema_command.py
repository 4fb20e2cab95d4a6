"""`sweetspot schema`: what a file of a bat, racket, club or stick may hold."""

from __future__ import annotations

from typing import Annotated

from cyclopts import Parameter

from sweetspot.errors import InputError


def schema(
    kind: Annotated[
        str, Parameter(help="bat, racket, cricket-bat, golf-club, hockey-stick or table-tennis-racket.")
    ] = "bat",
    /,
) -> None:
    """Print the JSON schema of a file that describes a bat, racket, club or stick."""
    from sweetspot.catalog.files.implement import FILES
    from sweetspot.cli.output import print_json
    from sweetspot.errors import nearest_names

    if kind not in FILES:
        raise InputError(f"kind {kind!r} is not known. {nearest_names(kind, sorted(FILES))}")
    print_json(FILES[kind].model_json_schema())

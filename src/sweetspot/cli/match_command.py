"""`sweetspot match`: lead that makes one racket feel like another."""

from __future__ import annotations

from dataclasses import replace
from typing import Annotated

from cyclopts import Parameter

from sweetspot.cli.options.output import DEFAULT_OUTPUT, OutputOptions


def match(
    racket: Annotated[str, Parameter(help="Racket to put lead on: name in the catalogue or a TOML file.")],
    target: Annotated[str, Parameter(help="Racket that it shall feel like.")],
    /,
    *,
    places: Annotated[
        str | None,
        Parameter(
            help="Where lead may go, from the butt: 2cm,15cm,52cm; 1cm-from-tip counts from the tip. Default: anywhere."
        ),
    ] = None,
    output: OutputOptions = DEFAULT_OUTPUT,
) -> int:
    """Find the lead that gives a racket another's weight, balance, swing weight and twist weight at once.

    --out leaded.toml writes the racket with the lead as a file.
    """
    from sweetspot.answers.ask_bat import match as asked
    from sweetspot.catalog.implements import loaded_implement
    from sweetspot.cli.output import note, present
    from sweetspot.plausibility import parse_position

    given = loaded_implement(racket)
    length = given.implement.length
    spots = (
        ()
        if places is None
        else tuple(parse_position(place, length=length, what="--places") for place in places.split(","))
    )
    found = asked(given, loaded_implement(target), places=spots)
    out = output.out
    if out is None or out.suffix.lower() != ".toml":
        return present(found, output)
    from sweetspot.reports.files import write_all

    write_all({out: found.to_toml().encode()})
    note(f"wrote {out}")
    return present(found, replace(output, out=None))

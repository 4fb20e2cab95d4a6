"""`sweetspot show`: any entry of the catalogue as a file."""

from __future__ import annotations

import os
import sys
from pathlib import Path
from typing import Annotated

from cyclopts import Parameter

from sweetspot.errors import InputError


def show(
    name: Annotated[str, Parameter(help="Of the catalogue: a bat, racket, club, ball, material, sport, pitch, park.")],
    /,
    *,
    of: Annotated[str | None, Parameter(help="Where a name means several: implement, ball, pitch, park, ...")] = None,
    sources: Annotated[
        bool, Parameter(negative="", help="With every value's spread, source, place in it and kind.")
    ] = False,
    out: Annotated[Path | None, Parameter(help="File to write it to, which must not be there yet.")] = None,
) -> int:
    """Print an entry of the catalogue as a file; that of a bat, racket, club or stick can be changed and given back.

    A comment marks every value that was assumed: recalled, no source was read.
    """
    from sweetspot.catalog.entries import entry_toml

    text = entry_toml(name, of, sources=sources)
    if out is not None:
        from sweetspot.reports.files import write_all

        if os.path.lexists(out):
            raise InputError(f"{out} is there already; choose another name for --out")
        write_all({out: text.encode()})
        print(f"sweetspot: wrote {out}", file=sys.stderr)
        return 0
    sys.stdout.write(text)
    return 0

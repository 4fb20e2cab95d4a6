"""`sweetspot bats`: what the catalogue has to hit with."""

from __future__ import annotations

from sweetspot.cli.options.output import DEFAULT_OUTPUT, OutputOptions


def bats(*, output: OutputOptions = DEFAULT_OUTPUT) -> int:
    """List the catalogue's bats with their weight, balance and swing weight, then what other sports hit with."""
    from sweetspot.cli.output import present
    from sweetspot.reports.bat.listing import catalogue_document

    return present(catalogue_document(), output)

"""`sweetspot validate`: every published case beside what this package computes."""

from __future__ import annotations

from sweetspot.cli.options.output import DEFAULT_OUTPUT, OutputOptions


def validate(*, output: OutputOptions = DEFAULT_OUTPUT) -> int:
    """Compare with every published case: printed against computed, tolerance, worth. Exit 1 on an unexplained miss."""
    from sweetspot import validation
    from sweetspot.cli.output import patience, present
    from sweetspot.reports.bench import validation_document

    with patience():
        results = validation.results()
    return present(validation_document(results), output)

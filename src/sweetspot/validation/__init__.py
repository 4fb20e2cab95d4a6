"""Published cases: what others measured or derived, beside what this package computes, with every miss shown.

One folder per source under ``cases/``: values as printed, how they map to our axes, tolerance and its reason, what
was left out and why. The command line, the tests and the docs page all read `results`, so they cannot drift apart.
"""

from sweetspot.validation.cases import Case, Result, Row, sources
from sweetspot.validation.verdicts import by_subject, headline, markdown, passed, results, rows, short_rows, summary

__all__ = [
    "Case",
    "Result",
    "Row",
    "by_subject",
    "headline",
    "markdown",
    "passed",
    "results",
    "rows",
    "short_rows",
    "sources",
    "summary",
]

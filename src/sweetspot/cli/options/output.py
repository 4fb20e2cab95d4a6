"""What every answer can be asked for: its format, its units, and files of it."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Annotated, Literal

from cyclopts import Parameter

Format = Literal["table", "json", "csv"]


@Parameter(name="*")
@dataclass(frozen=True)
class AnswerOptions:
    """Units and format of an answer."""

    format: Annotated[
        Format, Parameter(help="table for people, json or csv for programs (SI); --json and --csv do too.")
    ] = "table"
    units: Annotated[
        Literal["us", "si"] | None,
        Parameter(help="Units of the answer; default: the sport's own, SI on the bench."),
    ] = None

    def into(self, folder: Path | None) -> OutputOptions:
        """Return the same with a folder for files, where one is given."""
        return OutputOptions(format=self.format, units=self.units, out=folder)


@Parameter(name="*")
@dataclass(frozen=True)
class OutputOptions(AnswerOptions):
    """Units and format of an answer, and the files it is written to."""

    title: Annotated[str, Parameter(help="Heading of the answer and its page.")] = ""
    details: Annotated[
        bool, Parameter(negative="", help="Also print the tables behind the answer; a page opens them.")
    ] = False
    made_for: Annotated[str, Parameter(name="--for", help="Whom it is for, named at the head of the page.")] = ""
    out: Annotated[
        Path | None, Parameter(help="Folder for the answer as a page to print, pictures and JSON, made if need be.")
    ] = None

    def __post_init__(self) -> None:
        """Refuse a folder that cannot be written before anything is computed."""
        if self.out is not None:
            from sweetspot.reports.files import check_folder

            check_folder(self.out, ())


DEFAULT_ANSWER, DEFAULT_OUTPUT = AnswerOptions(), OutputOptions()

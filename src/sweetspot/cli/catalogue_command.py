"""Commands that list and show what the package holds: bats, sports, parks, entries, schemas, published cases."""

from __future__ import annotations

import os
import sys
from pathlib import Path
from typing import Annotated

from cyclopts import Parameter

from sweetspot.cli.options.output import DEFAULT_OUTPUT, OutputOptions
from sweetspot.errors import InputError


def bats(*, output: OutputOptions = DEFAULT_OUTPUT) -> int:
    """List the catalogue's bats with their weight, balance and swing weight, then what other sports hit with."""
    from sweetspot.cli.output import present
    from sweetspot.reports.bat.listing import catalogue_document

    return present(catalogue_document(), output)


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


def sports(
    name: Annotated[str | None, Parameter(help="One sport in full; without it, all of them.")] = None,
    /,
    *,
    output: OutputOptions = DEFAULT_OUTPUT,
) -> int:
    """List the sports with their balls, implements, speeds and rules, and how sure each number is."""
    from sweetspot.answers.catalogued import sport_answer, sports_answer
    from sweetspot.cli.output import present

    answer = sports_answer() if name is None else sport_answer(name)
    return present(answer, output)


def materials(
    material: Annotated[
        str | None, Parameter(help="Of the catalogue, or as the trade calls it: ash, maple; default: all.")
    ] = None,
    /,
    *,
    output: OutputOptions = DEFAULT_OUTPUT,
) -> int:
    """List woods, metals and fillers, or one as a card: density, stiffness, strength, their spread and source."""
    from sweetspot.answers.materials import material_answer, materials_answer
    from sweetspot.cli.output import present

    return present(materials_answer() if material is None else material_answer(material), output)


def schema(
    kind: Annotated[
        str,
        Parameter(
            help="A file: bat, ball, racket, cricket-bat, golf-club, hockey-stick or table-tennis-racket; or an "
            "answer: report, hit, play, ..."
        ),
    ] = "bat",
    /,
) -> None:
    """Print the JSON schema of a file that describes a bat, ball, racket, club or stick, or of a command's answer."""
    from sweetspot.answers.schema import answer_names, answer_schema, answer_type
    from sweetspot.catalog.files.ball import BallFile
    from sweetspot.catalog.files.implement import FILES
    from sweetspot.catalog.files.tables import FileTable
    from sweetspot.cli.output import print_json
    from sweetspot.errors import nearest_names

    files: dict[str, type[FileTable]] = {**FILES, "ball": BallFile}
    answers = answer_names()
    if kind not in {**files, **answers}:
        raise InputError(f"kind {kind!r} is not known. {nearest_names(kind, sorted({**files, **answers}))}")
    print_json(files[kind].model_json_schema() if kind in files else answer_schema(answer_type(kind)))


def validate(
    *,
    sealed: Annotated[
        Path | None,
        Parameter(
            help="CSV or TOML of questions whose answers are withheld: id, kind, implement or exit_speed and "
            "launch_angle, ...; --out writes our predictions.csv too."
        ),
    ] = None,
    score: Annotated[
        tuple[Path, Path] | None,
        Parameter(help="Predictions, and the CSV of what was measured: id, value, error. How the predictions did."),
    ] = None,
    output: OutputOptions = DEFAULT_OUTPUT,
) -> int:
    """Compare with every published case: printed against computed, tolerance, worth. Exit 1 on an unexplained miss."""
    from sweetspot import validation
    from sweetspot.cli.output import present, progress
    from sweetspot.reports.bench import validation_document
    from sweetspot.validation import sealed_files

    if sealed is not None and score is not None:
        raise InputError("give --sealed, questions to answer, or --score, answers to judge, not both")
    if sealed is not None:
        from sweetspot.answers.sealed import sealed_answer

        questions = sealed_files.read_questions(sealed)
        with progress("questions") as step:
            predicted = sealed_answer(questions, sealed, step=step)
        return present(predicted, output)
    if score is not None:
        from sweetspot.answers.sealed import score_answer

        answers, measured = score
        predictions = sealed_files.read_predictions(answers)
        return present(score_answer(predictions, sealed_files.read_measured(measured), measured), output)
    results = validation.results()
    return present(validation_document(results), output)


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
    """Print an entry of the catalogue as a file; that of a bat, ball, racket, club or stick can be given back.

    A comment marks every value that was assumed: recalled, no source was read.
    """
    from sweetspot.catalog.entries import entry_toml

    text = entry_toml(name, of, sources=sources)
    if out is not None:
        from sweetspot.cli.output import note
        from sweetspot.reports.files import write_all

        if os.path.lexists(out):
            raise InputError(f"{out} is there already; choose another name for --out")
        write_all({out: text.encode()})
        note(f"wrote {out}")
        return 0
    sys.stdout.write(text)
    return 0

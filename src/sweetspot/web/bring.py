"""Whatever a person brings to the page: what a file is, and the bat that it holds.

A bat comes as its file (TOML), as a table of diameters, as a drawing, a solid or a photograph; a racket, club, stick or
ball as its file. Tables of swings and sounds of taps have a view of their own, which reads them.
"""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Annotated, Literal

from fastapi import APIRouter
from pydantic import BaseModel, ConfigDict, Field

from sweetspot import catalog
from sweetspot.answers.outline import OutlineQuestion, bat_of_outline, outline_answer
from sweetspot.calibration.outline.outline_file import ENDINGS, HEIF, TABLES, read_outline
from sweetspot.calibration.outline.station_table import ACROSS
from sweetspot.calibration.recording import OF_PHONES, SOUND_FILES
from sweetspot.catalog.balls import ball_of_text
from sweetspot.catalog.files.write import bat_toml, legible
from sweetspot.equipment.bat import Bat
from sweetspot.errors import InputError
from sweetspot.numerics.text_files import MOST_TABLE_BYTES, read_text
from sweetspot.reports.page_words import brought_bat
from sweetspot.tables.headings import names_one_of
from sweetspot.tables.text_encoding import FIRST_LINES, table_rows
from sweetspot.units import INCH
from sweetspot.web.bats import bat_from_text, implement_from_text
from sweetspot.web.controls import LONGEST, LONGEST_TOML
from sweetspot.web.documents import Sentences, in_both_systems, in_one_system
from sweetspot.web.errors import FieldError, about
from sweetspot.web.recipes import ENOUGH
from sweetspot.web.uploads import UPLOADS, UploadKey

Kind = Literal["bat", "implement", "ball", "swings", "season", "batter", "sound"]
SEASON_ROWS = 600
"""Rows of a table from which on it is many players' season, not one player's swings: [our choice], as many as a regular
puts into play in a year."""
TABLES_OF_BALLS = (".gz", ".parquet")
LENGTH = "length_in"


class Brought(BaseModel):
    """What a person brings, and what its file may not hold."""

    model_config = ConfigDict(frozen=True, extra="forbid", allow_inf_nan=False)

    upload: UploadKey
    length_in: Annotated[float, Field(ge=10, le=LONGEST)] | None = Field(None, description="of the bat")
    material: Annotated[str, Field(max_length=60)] = Field("white-ash", description="of a drawn or measured bat")


class Found(BaseModel):
    """What a file is.

    ``toml``: the file of a bat, implement or ball. ``notes``: what is to be known of it. ``asks``: the field that is
    needed before it can be read, with the reason in ``notes``.
    """

    kind: Kind
    name: str
    toml: str = ""
    notes: Sentences = {"us": [], "si": []}
    asks: Literal["", "length_in"] = ""


def bring_routes(api: APIRouter) -> None:
    """Add the route that looks at what is brought."""

    @api.post("/bring", tags=["files"])
    def bring(brought: Brought) -> Found:
        """Find out what a file that was handed in is, and the bat, implement or ball that it holds."""
        path, name = UPLOADS.path_of(brought.upload)
        try:
            return found(path, name, brought)
        except InputError as fault:
            raise FieldError("upload", str(fault).replace(str(path), name)) from None


def found(path: Path, name: str, brought: Brought) -> Found:
    """Find out what the file at a path is; a `FieldError` or `InputError` says what is wrong with it by its name."""
    ending = path.suffix.lower()
    if ending in (*SOUND_FILES, *OF_PHONES):
        return Found(kind="sound", name=name)
    if ending in TABLES_OF_BALLS:
        return Found(kind="season", name=name)
    if ending == ".json":
        return Found(kind="batter", name=name)
    if ending == ".toml":
        return _described(read_text(path, most=LONGEST_TOML, advice="a bat's file has a few lines"), name)
    if ending in TABLES and not _measures_a_bat(path):
        with path.open("rb") as lines:
            rows = sum(1 for _ in lines)
        return Found(kind="season" if rows > SEASON_ROWS else "swings", name=name)
    return _outlined(path, name, brought)


def _described(text: str, name: str) -> Found:
    """Find out what a TOML text describes; where it is nothing, the bat's fault is the one to give."""
    try:
        return Found(kind="bat", name=bat_from_text(text).name, toml=text)
    except InputError as fault:
        refusal = fault
    try:
        tool = implement_from_text(text)
        return Found(kind="bat" if isinstance(tool, Bat) else "implement", name=tool.name, toml=text)
    except InputError:
        pass
    try:
        return Found(kind="ball", name=ball_of_text(text).name, toml=text)
    except InputError:
        raise FieldError("upload", f"{name}: {refusal}") from None


def _measures_a_bat(path: Path) -> bool:
    """Return whether a table has a heading of diameters, radii or girths."""
    text = read_text(path, most=MOST_TABLE_BYTES, advice="bring a table of diameters") if _short(path) else ""
    rows = [cells for _, cells in table_rows(text, path, is_heading=_heads)][:FIRST_LINES] if text else []
    return any(_heads(cells) for cells in rows)


def _short(path: Path) -> bool:
    return path.stat().st_size <= MOST_TABLE_BYTES


def _heads(cells: Sequence[str]) -> bool:
    return names_one_of(cells, ("station",)) and names_one_of(cells, tuple(ACROSS))


def _outlined(path: Path, name: str, brought: Brought) -> Found:
    """Return the solid bat whose outline a table, drawing, solid or photograph holds."""
    if path.suffix.lower() not in (*ENDINGS, *HEIF):
        raise FieldError("upload", f"{name} is nothing that this page reads")
    with about("material"):
        material = catalog.material(brought.material)
    try:
        outline = read_outline(path, length=None if brought.length_in is None else brought.length_in * INCH)
    except InputError as fault:
        words = str(fault).replace(str(path), name)
        if brought.length_in is None and "--length" in words:
            return Found(kind="bat", name=name, notes=_both([_in_page_words(words)]), asks=LENGTH)
        raise FieldError("upload", _in_page_words(words)) from None
    bat = bat_of_outline(outline, material=material, name=Path(name).stem)
    answer = outline_answer(OutlineQuestion(outline, bat))
    assumed = brought_bat(
        length=bat.length,
        widest=max(width for _, width in outline.profile),
        mass=float(answer.mass),
        material=material.name,
        guessed=len(outline.assumed),
    )
    doubts = _both([_in_page_words(note) for note in outline.notes])
    notes = {system: [*lines, *doubts[system]] for system, lines in in_both_systems(assumed).items()}
    return Found(kind="bat", name=bat.name, toml=legible(bat_toml(bat), digits=ENOUGH), notes=notes)


def _both(texts: list[str]) -> Sentences:
    every = [in_one_system(text) for text in texts]
    return {"us": [words["us"] for words in every], "si": [words["si"] for words in every]}


PAGE_WORDS = {"--length": "its length", "--camera-distance": "the distance of the camera", "--ruler": "a ruler"}
"""What options of the command line are on the page."""


def _in_page_words(text: str) -> str:
    for option, words in PAGE_WORDS.items():
        text = text.replace(f"the bat's {option}", words).replace(f"with {option}", "below").replace(option, words)
    return text

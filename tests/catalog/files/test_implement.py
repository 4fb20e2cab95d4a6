"""Files of rackets, clubs and sticks."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from sweetspot import catalog
from sweetspot.catalog.bats import IMPLEMENT_FOLDER
from sweetspot.catalog.files.implement import FILES
from sweetspot.catalog.files.read import implement_from_table
from sweetspot.catalog.implements import implement_tables
from sweetspot.catalog.materials import rubber
from sweetspot.catalog.records import all_records
from sweetspot.catalog.sports import sport_names
from sweetspot.equipment.racket import Racket
from sweetspot.errors import InputError
from sweetspot.references import reference

RACKET = """
kind = "racket"
sport = "tennis"
name = "mine"
length = "27 in"
mass = "300 g"
balance_point = "32 cm"
moi = "300 kg*cm^2"
moi_axis = "10 cm"
first_frequency = "150 Hz"
handle_length = "18 cm"
greatest_tension = "60 lbf"
[head]
length = "33 cm"
width = "25 cm"
[strings]
tension = "50 lbf"
mains = 16
crosses = 19
linear_density = "1.4 g/m"
restitution = 0.97
patch = "2 cm"
"""


def written(folder: Path, text: str) -> str:
    path = folder / "mine.toml"
    path.write_text(text, encoding="utf-8")
    return str(path)


def test_a_file_becomes_a_racket(tmp_path: Path) -> None:
    racket = catalog.load_implement(written(tmp_path, RACKET))
    assert isinstance(racket, Racket)
    assert racket.length == pytest.approx(0.6858) and racket.bed.tension == pytest.approx(222.4, abs=0.05)
    assert racket.head.end == pytest.approx(racket.length - 0.01)


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        ("[strings]", "[other]", "unknown key 'other'"),
        ('tension = "50 lbf"', 'tension = "70 lbf"', "bears up to 267 N. String it softer"),
        ('tension = "50 lbf"', 'tension = "50"', "without a unit"),
        ('tension = "50 lbf"', 'tension = "50 mm"', "which is not a force"),
        ('kind = "racket"', 'kind = "raquet"', "kind 'raquet' is not known. .*racket"),
        ('mass = "300 g"', "", "needs mass, balance_point and swing weight"),
        ("mains = 16", "mains = 2", "strings.mains|mains"),
    ],
)
def test_what_is_wrong_is_said(tmp_path: Path, old: str, new: str, said: str) -> None:
    with pytest.raises(InputError, match=said) as refused:
        catalog.load_implement(written(tmp_path, RACKET.replace(old, new)))
    assert "mine.toml: " in str(refused.value) and "racketfile" not in str(refused.value)


def test_a_racket_without_strings_cannot_hit(tmp_path: Path) -> None:
    with pytest.raises(InputError, match="no strings; a racket without strings cannot hit"):
        catalog.load_implement(written(tmp_path, RACKET[: RACKET.index("[strings]")]))


def test_an_unknown_rubber_names_the_nearest() -> None:
    with pytest.raises(InputError, match=r"rubber 'invertd' is not in the catalogue.*inverted"):
        rubber("invertd")
    table = {**implement_tables()["table-tennis-racket"], "front": "short pimples"}
    with pytest.raises(InputError, match="short-pips"):
        implement_from_table(table, "mine")


def test_a_racket_is_no_bat(tmp_path: Path) -> None:
    with pytest.raises(InputError, match="is a racket, not a baseball or softball bat"):
        catalog.load_bat(written(tmp_path, RACKET))
    with pytest.raises(InputError, match="tennis-racket is a racket, not a baseball"):
        catalog.load_bat("tennis-racket")


@pytest.mark.parametrize("path", sorted(IMPLEMENT_FOLDER.glob("*.toml")), ids=lambda path: path.stem)
def test_catalogue_files_say_where_their_numbers_come_from(path: Path) -> None:
    table = implement_tables()[path.stem]
    assert table["kind"] in FILES and table["sport"] in sport_names() and table["note"]
    inside = [one for one in table.values() if isinstance(one, dict) and "value" not in one]
    found = [record for entry in (table, *inside) for record in all_records(entry, path.stem)]
    assert len(found) >= 7
    for record in found:
        reference(record.source)
        assert record.kind == "assumed" or record.source != "recalled" or "define" in record.where, record.name


@pytest.mark.parametrize("kind", sorted(FILES))
def test_every_kind_has_a_schema(kind: str) -> None:
    assert f'"title": "{FILES[kind].__name__}"' in json.dumps(FILES[kind].model_json_schema())

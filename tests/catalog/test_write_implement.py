"""What is written of a bat, racket, club or stick reads back as the same."""

from __future__ import annotations

import tomllib

import pytest

from sweetspot import catalog
from sweetspot.catalog.files.read import implement_from_table
from sweetspot.catalog.files.write import implement_toml
from sweetspot.equipment.implement import AddedMass


@pytest.mark.parametrize(
    "name", [*(name for name in catalog.implement_names() if name not in catalog.bat_names()), "single-wall"]
)
def test_it_reads_back_as_the_same(name: str) -> None:
    own = catalog.load_implement(name)
    assert implement_from_table(tomllib.loads(implement_toml(own)), "here") == own


def test_lead_tape_is_written_too() -> None:
    own = catalog.load_implement("tennis-racket")
    taped = own.replaced(added=(AddedMass(position=0.6, mass=0.005, lateral=0.1),))
    assert implement_from_table(tomllib.loads(implement_toml(taped)), "here") == taped

"""A written bat file gives the same bat when it is read again."""

from __future__ import annotations

import tomllib

import pytest

from sweetspot import catalog
from sweetspot.catalog.files.read import bat_from_table
from sweetspot.catalog.files.write import bat_toml, legible
from sweetspot.dynamics.beam import beam_model
from sweetspot.dynamics.weight_match import with_wall_factor
from sweetspot.equipment.bat import Bat
from sweetspot.equipment.material import Material
from sweetspot.errors import InputError


def read_again(bat: Bat) -> Bat:
    return bat_from_table(tomllib.loads(bat_toml(bat)), "written")


@pytest.mark.parametrize("name", catalog.bat_names())
def test_catalogue_bats_come_back_the_same(name: str) -> None:
    bat = catalog.bat(name)
    assert read_again(bat) == bat


def test_changed_bats_come_back_with_the_bat_that_was_measured(r161: Bat) -> None:
    cork = catalog.material("cork")
    changed = r161.corked(diameter=0.0254, depth=0.254, fill=cork, plug=0.0254).cupped(diameter=0.03, depth=0.01)
    changed = changed.weighted(position=0.1, mass=0.05).choked_up(0.02)
    assert read_again(changed) == changed
    assert beam_model(read_again(changed)).density_factor == beam_model(r161).density_factor
    thinner = with_wall_factor(catalog.bat("composite"), 0.9)
    assert read_again(thinner) == thinner


def test_a_material_of_its_own_is_written_as_what_differs(r161: Bat, ash: Material) -> None:
    lighter = r161.with_material(ash.replaced(density=600.0))
    assert read_again(lighter) == lighter
    assert 'like = "white-ash"' in bat_toml(lighter)


def test_an_unknown_material_is_refused(r161: Bat, ash: Material) -> None:
    with pytest.raises(InputError, match="not in the catalogue"):
        bat_toml(r161.with_material(ash.replaced(name="driftwood")))
    with pytest.raises(InputError, match="cannot describe"):
        bat_toml(r161.with_material(ash.replaced(strength=None)))


@pytest.mark.parametrize("name", ["r161-ash", "composite", "mlb-d"])
def test_a_legible_bat_file_is_the_bat_to_a_nanometre(name: str) -> None:
    text = legible(bat_toml(catalog.bat(name)))
    assert "00000" not in text and "99999" not in text
    again = bat_from_table(tomllib.loads(text), "written")
    assert again.length == pytest.approx(catalog.bat(name).length, abs=1e-9)
    assert again.profile is not None and again.profile[-1][0] == again.length

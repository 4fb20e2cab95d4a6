"""The catalogue: every value has a source, every entry makes a thing."""

from __future__ import annotations

import math

import pytest

from sweetspot import catalog, references
from sweetspot.catalog.bats import bat_tables
from sweetspot.catalog.files.read import bat_from_table
from sweetspot.catalog.files.turned import Turned
from sweetspot.catalog.records import TomlTable, all_records, read_table
from sweetspot.catalog.rules import league
from sweetspot.dynamics.beam import beam_model
from sweetspot.dynamics.rigid import rigid_body
from sweetspot.errors import InputError
from sweetspot.units import OUNCE

TABLES = {
    "materials": read_table("materials.toml"),
    "balls": read_table("balls.toml"),
    "bats": bat_tables(),
    "players": read_table("player_priors.toml"),
}
KEYS = set(references.keys())
PLAIN = {"name", "family", "sport", "like", "note", "scale", "laminated"}
"""Fields that are words, or say what a thing is, and no values that were measured."""
ENTRIES = [(table, name) for table, entries in TABLES.items() for name in entries]


def test_rules_are_known_by_the_names_that_people_have_for_them() -> None:
    """What is printed on bats and said in offices: NFHS and NCAA share one rule, USA Softball was the ASA."""
    known = {"NFHS": "ncaa", "high school": "ncaa", "USA Bat": "usabat", "usa-softball": "asa", "BPF 1.15": "usssa"}
    assert {name: league(name).key for name in known} == known
    listed = r"Known names: asa \(.*\), cricket \(.*\), golf \(.*\), little-league, .*ncaa \(nfhs, high-school"
    with pytest.raises(InputError, match=listed):
        league("xyz")
    also = [name for entry in read_table("rules.toml").values() for name in entry.texts("also")]
    assert len(also) == len(set(also)) and not {*also} & {*read_table("rules.toml")}


@pytest.mark.parametrize(("table", "name"), ENTRIES)
def test_every_value_has_a_source_and_a_kind(table: str, name: str) -> None:
    entry = TABLES[table][name]
    found = all_records(entry, name)
    ends = {
        key for key in entry if key.startswith("law_")
    }  # the same ball by another law: records in a table of their own
    assert {record.name.split(".")[1] for record in found} == set(entry) - PLAIN - ends
    for end in ends:
        other = entry.table(end)
        assert set(other) <= {*entry, "cor_reference_change", "cor_slope_change"}
        of_end = all_records(other, f"{name}.{end}")
        assert len(of_end) == len(other)
        found += of_end
    for record in found:
        assert record.source in KEYS, record.name
        read = () if record.source == "recalled" else ("measured", "specified")  # from memory nothing was read
        assert record.kind in (*read, "derived", "fitted", "assumed"), record.name


@pytest.mark.parametrize("name", catalog.material_names())
def test_materials(name: str) -> None:
    material = catalog.material(name)
    assert material.shear > 0 and material.density > 0


@pytest.mark.parametrize("name", catalog.ball_names())
def test_balls(name: str) -> None:
    ball = catalog.ball(name)
    assert 0.002 < ball.mass < 0.21 and 0.01 < ball.radius < 0.06
    at_speed = 22.0 if ball.restitution.log_slope else 45.0  # shells lose most of their speed long before that
    assert 0.2 < ball.restitution.at(at_speed) < 0.8


def test_the_baseball_is_the_rule_books() -> None:
    ball = catalog.ball()
    assert ball.mass == pytest.approx(5.125 * OUNCE)
    on_rigid = ball.restitution.at(85 * 0.3048)
    held, rule = 0.016, 0.546  # what 4 in of northern white ash hold and give back, and the rule on it [kagan2004]
    on_ash = math.sqrt(held + (1 - held) * on_rigid**2)
    assert on_ash == pytest.approx(rule, abs=0.005)  # to the doubt of a league's mean ball


@pytest.mark.parametrize("name", catalog.bat_names())
def test_bats_weigh_what_is_measured(name: str) -> None:
    bat = catalog.bat(name)
    body = rigid_body(beam_model(bat))
    found = {"mass": body.mass, "balance_point": body.balance_point, "moi": body.moi(bat.moi_axis)}
    measured = {quantity: value for quantity in found if (value := getattr(bat, quantity)) is not None}
    assert {quantity: found[quantity] for quantity in measured} == pytest.approx(measured, rel=1e-9)


def test_corked_file_is_the_corked_flagship() -> None:
    made = catalog.bat("r161-ash").corked(diameter=0.0254, depth=0.254, fill=catalog.material("cork"), plug=0.0254)
    here, there = rigid_body(beam_model(made)), rigid_body(beam_model(catalog.bat("corked-r161")))
    assert (there.mass, there.balance_point) == pytest.approx((here.mass, here.balance_point), rel=1e-3)


def test_names_are_forgiving() -> None:
    assert catalog.bat("R161 Ash") == catalog.bat("r161_ash") == catalog.bat("r161-ash")
    with pytest.raises(InputError, match="Did you mean"):
        catalog.material("white-ashh")


def test_own_material_values() -> None:
    table: TomlTable = {
        "name": "tapped",
        "length": "33 in",
        "profile": [["0 in", "1 in"], ["33 in", "2.5 in"]],
        "material": {"like": "white ash", "longitudinal_modulus": "13 GPa", "damping_ratio": 0.01},
    }
    material = bat_from_table(table, "test").material
    assert material.longitudinal_modulus == pytest.approx(13e9) and material.damping_ratio == 0.01
    assert material.density == catalog.material("white ash").density


def test_turned_outline() -> None:
    sizes = {"length": 0.84, "knob": 0.05, "handle": 0.025, "barrel": 0.065}
    stations = Turned(**sizes, taper_start=0.3, taper_end=0.6).profile()
    places = [place for place, _ in stations]
    assert places == sorted(set(places)) and places[0] == 0.0 and places[-1] == pytest.approx(0.84)
    assert max(size for _, size in stations) == pytest.approx(0.065)
    for start, end in ((0.6, 0.3), (0.01, 0.6), (0.3, 0.83)):
        with pytest.raises(InputError, match="start before end"):
            Turned(**sizes, taper_start=start, taper_end=end).profile()

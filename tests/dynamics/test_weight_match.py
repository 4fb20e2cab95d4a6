"""A measured weight of a hollow bat is met by a wall or a weight at its ends, never by a metal of another density."""

from __future__ import annotations

import pytest

from sweetspot import catalog
from sweetspot.catalog.files.read import bat_from_table
from sweetspot.catalog.files.write import bat_table
from sweetspot.catalog.records import Entry
from sweetspot.dynamics.beam import beam_model
from sweetspot.dynamics.rigid import rigid_body
from sweetspot.dynamics.weight_match import ORDER, WeightBy, weighing, weight_matched, weights, with_barrel_wall
from sweetspot.equipment.bat import Bat
from sweetspot.errors import InputError
from sweetspot.units import OUNCE

BAT = catalog.bat("single-wall")  # 30.0 oz as drawn


def measured(ounces: float) -> Bat:
    return BAT.replaced(mass=ounces * OUNCE)


WITHIN_ALLOYS = (29.9, None)
"""oz, and nothing that is to be changed: what alloys differ by meets that weight."""


@pytest.mark.parametrize(
    ("ounces", "by"),
    [(ounces, by) for ounces in (29.9, 30.5, 31.5) for by in (None, *ORDER) if (ounces, by) != WITHIN_ALLOYS],
)
def test_the_weight_is_met_at_the_metals_own_density(ounces: float, by: WeightBy | None) -> None:
    found = weight_matched(measured(ounces), by)
    beam = beam_model(found)
    assert rigid_body(beam).mass == pytest.approx(ounces * OUNCE)
    assert beam.density_factor == pytest.approx(1.0)
    assert found.remark is not None and f"{ounces:.1f} oz" in found.remark


def test_a_weight_within_what_alloys_differ_by_changes_no_wall() -> None:
    ounces, by = WITHIN_ALLOYS
    found = weight_matched(measured(ounces), by)
    assert rigid_body(beam_model(found)).mass == pytest.approx(ounces * OUNCE)
    assert not found.remark


def test_the_barrel_is_left_alone_before_all_walls_are_scaled() -> None:
    heavy, light = weight_matched(measured(32.0)), weight_matched(measured(26.0))
    place = BAT.length - 0.15
    assert "handle" in heavy.remark and heavy.wall_at(place) == pytest.approx(BAT.wall_at(place))
    assert heavy.wall_at(0.2) > BAT.wall_at(0.2)
    assert "every wall" in light.remark and light.wall_at(place) < 0.9 * BAT.wall_at(place)


def test_what_cannot_be_is_refused_with_what_can() -> None:
    with pytest.raises(InputError, match=r"end cap: 29\.6 oz .* to 32\.6 oz"):
        weight_matched(measured(36.0), "end cap")
    with pytest.raises(InputError, match="wall: "):
        weight_matched(measured(80.0))


def test_a_bat_file_says_how_its_weight_was_met() -> None:
    table = bat_table(BAT) | {"mass": "31.5 oz"}
    assert "handle's wall" in bat_from_table(table, "here").remark
    shell = {**Entry("shell", table).table("shell"), "weight_by": "knob"}
    assert "knob" in bat_from_table({**table, "shell": shell}, "here").remark


def test_solid_bats_and_unweighed_ones_stay_as_they_are() -> None:
    wood = catalog.bat("r161-ash")
    assert weight_matched(wood) is wood and weight_matched(BAT) is BAT


def test_a_thicker_barrel_leaves_the_handle() -> None:
    thick = with_barrel_wall(BAT, 1.5)
    assert thick.wall_at(0.2) == pytest.approx(BAT.wall_at(0.2))
    assert thick.wall_at(BAT.length - 0.1) == pytest.approx(1.5 * BAT.wall_at(BAT.length - 0.1))
    with pytest.raises(InputError, match="solid"):
        with_barrel_wall(catalog.bat("r161-ash"), 1.5)


@pytest.mark.parametrize(("ounces", "by"), [(31.0, "an end cap"), (36.0, "walls 1.2"), (22.0, "walls 0.6")])
def test_a_hollow_bat_weighs_what_its_cap_or_its_walls_make_it(ounces: float, by: str) -> None:
    """Exact: the weight that was asked for."""
    weighed = weighing(catalog.bat("single-wall"), ounces * OUNCE)
    assert rigid_body(beam_model(weighed)).mass == pytest.approx(ounces * OUNCE, rel=1e-6)
    assert by in weighed.remark


def test_no_cap_and_no_wall_makes_any_weight() -> None:
    bat = catalog.bat("single-wall")
    for limit in weights(bat):
        assert rigid_body(beam_model(weighing(bat, limit))).mass == pytest.approx(limit, rel=1e-6)
    with pytest.raises(InputError, match="can weigh"):
        weighing(bat, 60 * OUNCE)
    with pytest.raises(InputError, match="solid"):
        weighing(catalog.bat("r161-ash"), 1.0)


@pytest.mark.parametrize("ounces", [24, 27, 30, 36])
def test_a_drawing_of_three_stations_is_met_too(ounces: float) -> None:
    bat = bat_from_table(
        {
            "name": "coarse",
            "length": "33 in",
            "mass": f"{ounces} oz",
            "material": "aluminium-7xxx",
            "profile": [["0 in", "1 in"], ["18 in", "2.6 in"], ["33 in", "2.6 in"]],
            "shell": {"wall": "2.4 mm", "end_cap_mass": "1 oz", "knob_mass": "1 oz"},
        },
        "coarse",
    )
    assert rigid_body(beam_model(bat)).mass == pytest.approx(ounces * OUNCE)

"""Changes of one piece: what they do to mass, balance and tones, that the piece stays the same, and what stays open.

Expected values: arithmetic of masses and moments, the published range of broken-in bats, and the published finding that
moisture changes a wooden bat's performance by its weight alone (drane2003).
"""

from __future__ import annotations

import numpy as np
import pytest

import sweetspot
from sweetspot import catalog
from sweetspot.answers.changes import CHANGES, changed, weight_texts
from sweetspot.dynamics.beam import beam_model
from sweetspot.dynamics.reduction import bending_frequencies
from sweetspot.dynamics.rigid import rigid_body
from sweetspot.equipment.bat import Bat
from sweetspot.errors import InputError
from sweetspot.numerics.interval import interval_of
from sweetspot.units import INCH, MPH, OUNCE


def half(number: object) -> float:
    ends = interval_of(number)  # type: ignore[arg-type]
    return (ends.high - ends.low) / 2


@pytest.mark.parametrize("name", sorted(CHANGES))
def test_every_change_can_be_made_as_its_example_says(name: str) -> None:
    of = {"slow-pitch": ("shaved", "rolled", "broken-in"), "cricket-bat": ("knocked-in", "pressed")}
    bat = catalog.implement(next((kind for kind, names in of.items() if name in names), "r161-ash"))
    made = changed(bat, CHANGES[name].example)
    assert made.implement.original == bat, "it is the piece that it was"
    assert made.implement.name == f"{bat.name}, {CHANGES[name].example}"
    assert (made.ends is not None) is (CHANGES[name].open_range is not None)
    assert rigid_body(beam_model(made.implement)).mass > 0


def test_weights_come_on_top_wherever_they_are() -> None:
    racket = catalog.load_implement("tennis-racket")
    (text,) = weight_texts(["6 g @ 52 cm, 6 g @ 12 cm"])
    before, after = (rigid_body(beam_model(each)) for each in (racket, changed(racket, text).implement))
    assert after.mass - before.mass == pytest.approx(0.012)
    moved = before.mass * before.balance_point + 0.006 * (0.52 + 0.12)
    assert after.balance_point == pytest.approx(moved / after.mass)


def test_several_on_one_bat_are_one_after_the_other() -> None:
    ash = catalog.bat("r161-ash")
    both = changed(ash, "cup 0.9 in, knob-weight 2 oz").implement
    assert isinstance(both, Bat) and both.cup is not None
    alone = rigid_body(beam_model(changed(ash, "cup 0.9in").implement)).mass
    assert rigid_body(beam_model(both)).mass - alone == pytest.approx(2 * OUNCE)


def test_water_is_weight_and_lowers_the_tones_as_it_lowers_the_stiffness() -> None:
    ash = catalog.bat("r161-ash")
    dry, moist = (beam_model(each) for each in (ash, changed(ash, "moisture 14 %").implement))
    assert rigid_body(moist).mass / rigid_body(dry).mass == pytest.approx(1.14 / 1.12)
    tones = bending_frequencies(moist, count=2) / bending_frequencies(dry, count=2)
    assert tones == pytest.approx(np.sqrt(np.exp(-0.03) * 1.12 / 1.14), rel=1e-6)


def test_knocking_in_takes_what_was_published() -> None:
    """0.24 % of the batted-ball speed [singh2008], between nothing and twice that; weight and tones stay."""
    bat = catalog.implement("cricket-bat")
    made = changed(bat, "knocked-in")
    assert made.ends is not None
    low, middle, high = (
        float(sweetspot.hit(each, at=bat.length - 0.15).exit_speed)
        / float(sweetspot.hit(bat, at=bat.length - 0.15).exit_speed)
        for each in (made.ends[0], made.implement, made.ends[1])
    )
    assert middle == pytest.approx(1 - 0.0024, abs=2e-4)
    assert low == pytest.approx(1.0)
    assert high == pytest.approx(1 - 0.0048, abs=6e-4)
    before, after = (beam_model(each) for each in (bat, made.implement))
    assert rigid_body(after).mass == pytest.approx(rigid_body(before).mass)
    assert bending_frequencies(after, count=2) == pytest.approx(bending_frequencies(before, count=2))
    with pytest.raises(InputError, match="says no amount; write for example 'pressed 20 %'"):
        changed(bat, "pressed")
    with pytest.raises(InputError, match="is no cricket bat"):
        changed(catalog.bat("r161-ash"), "knocked-in")


def test_a_shaved_barrel_loses_what_was_cut() -> None:
    """Exact for an even tube: 2 pi (inner radius) h per length, inside the barrel, at the density of the metal."""
    alloy = catalog.bat("single-wall")
    shaved = changed(alloy, "shaved 0.2 mm").implement
    assert isinstance(shaved, Bat) and shaved.shell is not None and alloy.shell is not None and shaved.altered
    assert float(shaved.wall_at(31 * INCH)) == pytest.approx(float(alloy.wall_at(31 * INCH)) - 0.2e-3)
    assert float(shaved.wall_at(10 * INCH)) == pytest.approx(float(alloy.wall_at(10 * INCH)))
    lost = rigid_body(beam_model(alloy)).mass - rigid_body(beam_model(shaved)).mass
    start, tip = 23.375 * INCH, 33 * INCH  # from 95 % of the greatest diameter on
    places = np.linspace(start, tip, 401)
    inner = alloy.diameter_at(places) / 2 - alloy.wall_at(places)
    area = np.pi * ((inner + 0.2e-3) ** 2 - inner**2)
    assert lost == pytest.approx(alloy.material.density * np.trapezoid(area, places), rel=0.01)


@pytest.mark.parametrize(("text", "most"), [("knob-weight 10 g", 0.1), ("moisture 14 %", 0.2), ("cup 0.9 in", 0.2)])
def test_a_known_change_opens_hardly_anything(text: str, most: float) -> None:
    answer = sweetspot.compare("r161-ash", what_if=[text])
    assert half(answer.bats[1].change) < most * MPH
    assert half(answer.bats[1].exit_speed) > 3 * MPH


def test_moisture_counts_by_its_weight_alone() -> None:
    """Published: no change of performance beyond that of the weight (drane2003)."""
    moist = sweetspot.compare("r161-ash", what_if=["moisture 16 %"], same_speed=True).bats[1]
    heavier = sweetspot.compare(
        catalog.bat("r161-ash"), catalog.bat("r161-ash").with_mass(31 * OUNCE * 1.16 / 1.12), same_speed=True
    ).bats[1]
    assert abs(float(moist.change) - float(heavier.change)) < 0.3 * MPH < float(moist.change)


def test_how_far_a_rolled_bat_softened_stays_open() -> None:
    """Published: slow-pitch bats gain 3 to 5 mph by 500 hits; the interval holds what the range leaves open."""
    rolled, known = sweetspot.compare("slow-pitch", what_if=["rolled", "rolled 61 %"]).bats[1:]
    ends = interval_of(rolled.change)
    assert ends.low < 3 * MPH < ends.value < ends.high < 5.5 * MPH
    assert half(rolled.change) > half(known.change) + 0.1 * MPH
    assert rolled.rules is not None and not rolled.rules.passed
    (used,) = sweetspot.compare("slow-pitch", what_if=["broken-in"]).bats[1:]
    assert float(used.change) == pytest.approx(float(rolled.change)) and used.rules is not None
    drawn = sweetspot.compare("slow-pitch", what_if=["rolled"], uncertainty=True)
    assert drawn.uncertainty is not None
    assert drawn.uncertainty.shares[f"how far {rolled.label} was changed"] > 0.05


@pytest.mark.parametrize(
    ("bat", "text", "why"),
    [
        ("r161-ash", "frozen", "names no change that is known"),
        ("r161-ash", "shaved 0.2 mm", "solid and has no wall"),
        ("single-wall", "shaved 2.95 mm", "nothing is left of a wall"),
        ("college-alloy", "rolled", "no resin breaks"),
        ("single-wall", "moisture 14 %", "not turned from wood"),
        ("r161-ash", "moisture 80 %", "more or less than can be"),
        ("r161-ash", "cup", "says no amount"),
        ("r161-ash", "lead 6 g", "says no place"),
        ("r161-ash", "cup 0.9 in @ 3 in", "takes no place"),
        ("r161-ash", "cup 9 g", "length"),
        ("tennis-racket", "cut 1 in", "not a round bat"),
        ("r161-ash", "", "names no change"),
    ],
)
def test_what_cannot_be_is_said(bat: str, text: str, why: str) -> None:
    with pytest.raises(InputError, match=why):
        changed(catalog.load_implement(bat), text)


def test_changes_are_made_to_one_bat() -> None:
    with pytest.raises(InputError, match="made to one"):
        sweetspot.compare("r161-ash", "mlb-a", what_if=["cup 0.9 in"])


def test_a_thinner_handle_and_a_drilled_barrel_say_what_they_do_to_the_strength() -> None:
    """Bending stress goes as the third power of the diameter: 3 % less of 0.98 in takes up to 9 % of the speed."""
    asked = sweetspot.compare("mlb-c", what_if=["handle -0.03 in", "handle 0.03 in", "cup 0.9 in"])
    whole, thin, thick, cup = (float(bat.breaking_speed) for bat in asked.bats)
    assert 0.91 < thin / whole < 0.99
    assert 1.01 < thick / whole < 1.09
    assert cup == pytest.approx(whole, rel=0.02)
    assert np.isnan(float(sweetspot.compare("slow-pitch").bats[0].breaking_speed))


@pytest.mark.parametrize(("name", "fill"), [("cork", "cork"), ("rubber", "rubber"), ("foam", "polyurethane-foam")])
def test_a_hole_has_a_depth_and_a_width(name: str, fill: str) -> None:
    """Exact: the bat that a workshop with these two numbers makes; its plug is an inch, or half of a shallow hole."""
    bat = catalog.bat("r161-ash")
    made = changed(bat, f"{name} 8in x 0.75in").implement
    plain = bat.corked(diameter=0.75 * INCH, depth=8 * INCH, fill=catalog.material(fill), plug=1 * INCH)
    assert made == plain.replaced(name=made.name)
    shallow = changed(bat, f"{name} 1.5 in").implement
    assert isinstance(shallow, Bat) and shallow.bores[0].plug == pytest.approx(0.75 * INCH)


@pytest.mark.parametrize("text", ["cup 0.9in x 1in", "lead 6g x 1in @ 27in", "cork 8in x 4in", "cork 8in x 1"])
def test_a_width_that_no_hole_has_is_refused(text: str) -> None:
    with pytest.raises(InputError, match=r"hole|unit"):
        changed(catalog.bat("r161-ash"), text)


def test_a_table_becomes_a_frame_of_a_row_for_each_cell() -> None:
    frame = sweetspot.what_if("r161-ash", {"mass": ["29 oz", "31 oz"], "bore_depth": [0.0, 0.2, 0.25]}).to_frame("us")
    assert frame.height == 6 and frame.columns[:2] == ["mass_oz", "bore_depth_in"]
    assert frame["mass_oz"].to_list() == pytest.approx([29.0] * 3 + [31.0] * 3)
    drilled = frame["exit_speed_mph"].to_list()
    assert drilled[0] > drilled[1] > drilled[2]  # what was drilled out is missing

"""What is measured on a bat of a search is what everybody else computes of it."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from sweetspot import analyse, catalog
from sweetspot.analysis.what_if import varied
from sweetspot.designs.batter import FROM_TIP
from sweetspot.designs.gain import present_measured
from sweetspot.designs.measures import Bench
from sweetspot.designs.spaces import hollow_space
from sweetspot.designs.turned import HANDLES, STATIONS, TurnedSpace, stations, turned_space, waist
from sweetspot.dynamics.beam import beam_model
from sweetspot.dynamics.rigid import rigid_body
from sweetspot.equipment.bat import Bat
from sweetspot.numerics.constants import STANDARD_AXIS
from sweetspot.units import INCH


def test_a_bat_of_the_search_is_the_bat_that_is_written(bench: Bench) -> None:
    """The same weight, moments, modes and exit speeds as the full analysis of the bat it becomes."""
    space = bench.space
    assert isinstance(space, TurnedSpace)
    low, high = (np.array([getattr(one, end) for one in space.variables]) for end in ("low", "high"))
    numbers = np.clip(space.start + 0.2 * (high - low) * np.sin(np.arange(len(low))), low, high)
    bat = space.made(numbers, "made")
    alike = replace(bench, batter=replace(bench.batter, law=None))
    measured = alike.measured(numbers)
    analysis = analyse(bat, bench.conditions)
    assert measured.values["mass"][0] == pytest.approx(analysis.body.mass, rel=1e-9)
    assert measured.values["moi"][0] == pytest.approx(analysis.body.moi(STANDARD_AXIS), rel=1e-9)
    assert measured.values["frequency"][0] == pytest.approx(analysis.free.frequency[2], rel=1e-9)
    scan = analysis.scan
    theirs = np.interp(bat.length - FROM_TIP, scan.position, scan.exit_speed)
    assert np.allclose(measured.curve[0], theirs, atol=0.02)
    assert measured.values["best"][0] == pytest.approx(float(scan.exit_speed.max()), abs=0.01)


def test_a_cup_lowers_the_moment_of_inertia(bench: Bench) -> None:
    numbers = np.tile(bench.space.start, (2, 1))
    numbers[1, len(HANDLES)] = 0.9 * INCH
    measured = bench.measured(numbers)
    assert measured.values["moi"][1] < measured.values["moi"][0]
    assert measured.values["mass"][1] < measured.values["mass"][0]


def test_the_speed_of_swings_scatters_without_changing_what_is_best(bench: Bench) -> None:
    """Exit speed is nearly straight in bat speed: its mean over 4 mph of scatter is that at the mean, to 0.01 m/s."""
    speeds = bench.batter.bat_speed + 1.8 * np.array([-np.sqrt(3), 0.0, np.sqrt(3)])
    mean = [
        float(
            replace(bench, batter=replace(bench.batter, bat_speed=float(speed)))
            .measured(bench.space.start)
            .values["exit_speed"][0]
        )
        for speed in speeds
    ]
    assert np.array(mean) @ [1 / 6, 2 / 3, 1 / 6] == pytest.approx(mean[1], abs=0.01)


def test_heavier_is_better_only_while_the_swing_does_not_mind(bench: Bench) -> None:
    """With one speed for all bats the heaviest wood is best; with one energy for all there is a best weight between."""
    law = bench.batter.law
    assert law is not None
    numbers = np.tile(bench.space.start, (9, 1))
    numbers[:, -1] = np.linspace(0.35, 1.6, 9)
    free = replace(bench, batter=replace(bench.batter, law=None)).measured(numbers).values["exit_speed"]
    assert np.all(np.diff(free) > 0)
    strict = replace(law, exponent=0.5, lightest_moi=0.01)
    worth = replace(bench, batter=replace(bench.batter, law=strict)).measured(numbers).values["exit_speed"]
    assert 0 < int(np.argmax(worth)) < 8


def test_a_thinner_barrel_is_harder_to_hit_well(bench: Bench) -> None:
    wide, narrow = bench.retained_of(np.array([[0.066], [0.050]]))
    assert narrow < wide < 1


def test_stations_follow_the_handles() -> None:
    diameters = np.linspace(0.025, 0.066, len(HANDLES))[None]
    place, size = stations(diameters, knob=np.array([0.05]), length=np.array([0.86]))
    assert place.shape == size.shape == (1, len(STATIONS))
    assert np.all(np.diff(place) > 0)
    assert np.interp(HANDLES * 0.86, place[0], size[0]) == pytest.approx(diameters[0], rel=1e-12)
    assert waist(diameters)[0] == 0
    diameters[0, 7] = 0.04
    assert waist(diameters)[0] == pytest.approx(diameters[0, 6] - 0.04)


def test_length_knob_and_width_of_the_cup_are_variables_where_asked(bench: Bench) -> None:
    """Each does what it must to the weights, and the bat that is made has it."""
    bat = catalog.bat("mlb-a")
    ranges = {"length": (0.83, 0.90), "knob": (0.040, 0.055), "cup_diameter": (0.026, 0.038)}
    space = turned_space(bat, ranges=ranges)
    own = replace(bench, space=space)
    names = [one.name for one in space.variables]
    start = space.start
    start[names.index("cup_depth")] = 0.02
    kept = turned_space(bat)
    as_before = replace(bench, space=kept).measured(start[: len(kept.variables)])
    assert own.measured(start).curve == pytest.approx(as_before.curve, rel=1e-12)
    rows = np.tile(start, (4, 1))
    for row, (name, (_, most)) in enumerate(ranges.items(), 1):
        rows[row, names.index(name)] = most
    values = own.measured(rows).values
    assert values["moi"][1] > values["moi"][0]  # longer
    assert values["mass"][2] > values["mass"][0] and values["balance_point"][2] < values["balance_point"][0]
    assert values["mass"][3] < values["mass"][0]  # more hollowed out
    for row, (name, (_, most)) in enumerate(ranges.items(), 1):
        assert values[name][row] == pytest.approx(most)
        again = replace(own, space=turned_space(space.made(rows[row], "made")))
        assert present_measured(again).values[name] == pytest.approx(most, rel=1e-3)


def test_another_wood_keeps_the_weight_of_wood_where_it_can(bench: Bench) -> None:
    """Its density starts at the present bat's, as far as the species has such; the present bat stays what it is."""
    bat = catalog.bat("mlb-a")
    space = turned_space(bat, wood=catalog.material("white_ash"))
    made = space.made(space.start, "ash")
    assert made.material == catalog.material("white_ash") and space.present.material == bat.material
    assert present_measured(replace(bench, space=space)).curve == pytest.approx(present_measured(bench).curve)
    assert rigid_body(beam_model(made)).mass == pytest.approx(rigid_body(beam_model(bat)).mass, rel=0.02)


def test_a_hollow_bat_of_another_material(bench: Bench) -> None:
    """Steel is heavier than aluminium; two and a half to three times."""
    bat = catalog.bat("single-wall")
    space = hollow_space(bat, material=catalog.material("steel"))
    made = space.made(space.start, "steel")
    assert isinstance(made, Bat) and made.material.name == catalog.material("steel").name
    wall = [rigid_body(beam_model(one)).mass for one in (bat.replaced(mass=None, moi=None, balance_point=None), made)]
    assert 1.6 < wall[1] / wall[0] < 3.0  # knob and cap stay


def test_a_cup_leaves_a_rim_at_a_narrow_tip() -> None:
    """A usual cup is 1.4 in wide; at a tip of 1.2 in it is narrower, in a table of variants as in a search."""
    bat = catalog.bat("mlb-a")
    profile = (*(station for station in bat.profile or () if station[0] < bat.length - 0.05), (bat.length, 1.2 * INCH))
    narrow = bat.replaced(profile=profile, cup=None, mass=None, balance_point=None, moi=None)
    space = turned_space(narrow)
    numbers = np.array([one.start for one in space.variables])
    numbers[-2] = 0.8 * INCH
    outlines = space.outlines(numbers[None])
    assert outlines.cup_diameter[0] == pytest.approx(0.95 * outlines.diameter[0, -1])
    cupped = varied(narrow, {"cup_depth": 0.8 * INCH}, fill=catalog.material("cork"))
    assert cupped.cup is not None and cupped.cup.diameter == pytest.approx(0.95 * 1.2 * INCH)
    assert varied(cupped, {"cup_depth": 0.0}, fill=catalog.material("cork")).cup is None

"""The motions without a browser: the same as in the report, and a tap's shares."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from sweetspot.answers.records import plain_data
from sweetspot.units import INCH
from sweetspot.web.errors import FieldError
from sweetspot.web.views import modes


def asked(**controls: Any) -> dict[str, Any]:
    return plain_data(modes.answer(modes.ModesState(**controls)))  # type: ignore[no-any-return]


def motion(answer: dict[str, Any], family: str, number: int) -> dict[str, Any]:
    found: list[dict[str, Any]] = answer["modes"]
    return next(row for row in found if (row["family"], row["number"]) == (family, number))


def test_they_are_the_reports(run_json: Callable[..., dict[str, Any]]) -> None:
    state = modes.ModesState(bat="single-wall")
    arguments = modes.recipe(state)["command"].removeprefix("sweetspot ").removesuffix(" --format json").split()
    reported = run_json(*arguments)["modes"]
    reported = [row for row in reported if row["frequency_hz"] < modes.HIGHEST]
    reported.sort(key=lambda row: row["frequency_hz"])
    shown = [row for row in modes.answer(state).modes if row.family != "rigid"]
    for mine, theirs in zip(shown, reported, strict=True):
        assert mine.frequency == pytest.approx(theirs["frequency_hz"], rel=1e-9)
        assert (mine.family, mine.harmonic) == (theirs["family"], theirs["harmonic"])
        bending = mine.family == "bending"  # the ends of a ringing barrel are nodes in the report alone
        assert not bending or mine.nodes == pytest.approx(theirs["nodes_m"], abs=1e-9)


@pytest.mark.parametrize("held", [False, True])
@pytest.mark.parametrize("bat", ["r161-ash", "single-wall"])
def test_shapes_are_one_high_and_cross_zero_at_their_nodes(bat: str, held: bool) -> None:
    answer = asked(bat=bat, held=held)
    places = answer["place_m"]
    for row in answer["modes"]:
        assert np.abs(row["shape"]).max() == pytest.approx(1.0)
        slope = np.abs(np.gradient(row["shape"], places)).max()
        for node in row["nodes_m"]:
            assert abs(np.interp(node, places, row["shape"])) < 0.3 * slope * (places[1] - places[0])


def test_hoop_modes_are_counted_along_the_barrel() -> None:
    """The m-th of a harmonic has m half waves, so m - 1 still rings."""
    rows = [row for row in asked(bat="single-wall")["modes"] if row["family"] == "hoop" and row["axial"] <= 3]
    assert len(rows) >= 4
    ringed = [row for row in rows if row["harmonic"] == 2]
    assert [len(row["nodes_m"]) for row in ringed] == [row["axial"] - 1 for row in ringed]


def test_shares_of_a_tap_sum_to_one_and_vanish_on_a_node() -> None:
    answer = asked(tap_ms=0.02)
    shares = [row["tap"]["energy_share"] for row in answer["modes"] if row["family"] != "rigid"]
    assert sum(shares) == pytest.approx(1.0)
    node = motion(answer, "bending", 1)["nodes_m"][-1]
    on_it = asked(tap_ms=0.02, tap_from_tip_in=(answer["bat"]["length_m"] - node) / INCH)
    assert (
        motion(on_it, "bending", 1)["tap"]["energy_share"] < 1e-6 < motion(on_it, "bending", 2)["tap"]["energy_share"]
    )


def test_a_longer_tap_leaves_the_fast_motions_alone() -> None:
    short, long = (motion(asked(tap_ms=ms), "bending", 4)["tap"]["energy_share"] for ms in (0.1, 2.0))
    assert long < 0.05 * short


def test_hands_damp() -> None:
    """Russell: even a tight grip damps strongly."""
    free, held = (motion(asked(held=held), "bending", 1) for held in (False, True))
    assert held["damping_ratio"] > 3 * free["damping_ratio"]
    assert held["decay_s"] < free["decay_s"] / 3


def test_a_tap_off_the_bat_is_refused() -> None:
    with pytest.raises(FieldError, match="the bat is 33 in long") as refused:
        asked(tap_from_tip_in=40)
    assert refused.value.field == "tap_from_tip_in"


@pytest.mark.parametrize("held", [False, True])
def test_the_recipe_gives_the_same_motions(held: bool) -> None:
    state = modes.ModesState(bat="single-wall", held=held)
    names: dict[str, Any] = {}
    exec(modes.recipe(state)["python"], names)
    lowest = np.sort(names["modes"].frequency)[2:8]
    shown = [row.frequency for row in modes.answer(state).modes if row.family != "rigid"]
    assert shown[:6] == pytest.approx(lowest, rel=1e-6)

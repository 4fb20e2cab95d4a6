"""`sweetspot sports` as a user meets it."""

from __future__ import annotations

import csv
import io
from collections.abc import Callable
from typing import Any

import pytest

from sweetspot.catalog.sports import certainty, sport_names

Run = Callable[..., tuple[int, str, str]]


def test_the_list(run: Run, run_json: Callable[..., Any]) -> None:
    code, out, _ = run("sports")
    assert code == 0 and "assumed" in out
    rows = run_json("sports")["sports"]
    assert [row["key"] for row in rows] == sport_names()
    for row in rows:
        assert row["key"] in out
        assert {kind: row[kind] for kind in certainty(row["key"])} == certainty(row["key"])
    code, out, _ = run("sports", "--format", "csv")
    assert [row["key"] for row in csv.DictReader(io.StringIO(out))] == sport_names()


@pytest.mark.parametrize("name", sport_names())
def test_one_sport(run: Run, name: str) -> None:
    code, out, _ = run("sports", name)
    assert code == 0
    assert "What the model does not cover" in out and "How sure" in out
    code, out, _ = run("sports", name, "--format", "csv")
    rows = list(csv.DictReader(io.StringIO(out)))
    assert {row["kind"] for row in rows} <= {"measured", "specified", "derived", "fitted", "assumed"}


def test_memory_is_marked_where_it_is_shown(run: Run, run_json: Callable[..., Any]) -> None:
    numbers = run_json("sports", "tennis")["numbers"]
    soft = [number for number in numbers if number["kind"] == "assumed"]
    _, out, _ = run("sports", "tennis")
    assert out.count("(assumed)") == len(soft) > 0
    assert all(number["unit"] for number in numbers if "restitution" not in number["name"])


def test_rule_book_drops_are_shown(run_json: Callable[..., Any]) -> None:
    formulas = run_json("sports", "table-tennis")["formulas"]
    on_steel = next(row for row in formulas if "steel" in row["quantity"])
    assert on_steel["paper"] == "240 to 260 mm" and 24 < on_steel["full_model"] < 26


def test_unknown_sport(run: Run) -> None:
    code, out, err = run("sports", "crickett")
    assert code == 2 and out == "" and "Did you mean cricket" in err


def test_a_flight_meets_the_court_of_its_ball(run: Run, run_json: Callable[..., Any]) -> None:
    serve = ("fly", "--ball", "tennis", "--exit-speed", "57m/s", "--launch-angle=-6deg", "--backspin=-1500rpm",
             "--height", "2.7m")  # fmt: skip
    code, out, _ = run(*serve)
    assert code == 0 and "It carries" in out and "over the net" in out
    court = run_json(*serve)["court"]
    assert court["sport"] == "tennis" and all(mark["good"] for mark in court["marks"])
    golf = run("fly", "--ball", "golf", "--exit-speed", "167mph", "--launch-angle", "10.9deg", "--backspin", "2686rpm",
               "--height", "0ft")[1]  # fmt: skip
    assert "It carries 273.5 yd" in golf  # radar mean 275 yd [trackman_tour]
    assert "court" not in run_json("fly", "--exit-speed", "100mph")


def test_unknown_ball_of_a_flight(run: Run) -> None:
    code, out, err = run("fly", "--ball", "shuttel")
    assert code == 2 and out == "" and "Did you mean shuttle" in err

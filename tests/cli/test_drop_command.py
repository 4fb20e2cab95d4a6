"""`sweetspot drop` as a user meets it."""

from __future__ import annotations

import csv
import io
import json
from collections.abc import Callable

import pytest

Run = Callable[..., tuple[int, str, str]]


def test_the_table_answers(run: Run) -> None:
    code, out, _ = run("drop", "--height", "1m", "--material", "white-ash", "--thickness", "10cm")
    assert code == 0
    for words in ("comes back to", "restitution e", "contact time", "energy kept by the ball", "lying on a floor"):
        assert words in out


def test_json_and_csv_agree(run: Run) -> None:
    arguments = ("--material", "aluminium-7xxx", "--thickness", "3mm", "--support", "clamped")
    code, out, _ = run("drop", *arguments, "--format", "json")
    assert code == 0
    found = json.loads(out)
    assert found["rebound_height_m"] == pytest.approx(found["energy_kept"], rel=1e-9)  # from 1 m
    assert set(found["energy_j"]) == {
        "incoming", "ball", "heat", "block_translation", "block_vibration", "block_damping",
    }  # fmt: skip
    code, out, _ = run("drop", *arguments, "--format", "csv")
    (row,) = csv.DictReader(io.StringIO(out))
    assert float(row["rebound_height_m"]) == found["rebound_height_m"]
    assert float(row["energy_heat_j"]) == found["energy_j"]["heat"]


def test_a_fired_ball_and_a_plate_bent_too_far(run: Run) -> None:
    code, out, _ = run(
        "drop", "--speed", "60mph", "--material", "aluminium-7xxx", "--thickness", "3mm", "--support", "clamped"
    )
    assert code == 0 and "26.82 m/s" in out and "Beware" in out and "comes back to" not in out


def test_a_reader_of_inches_is_told_of_no_millimetre_and_no_newton(run: Run) -> None:
    told = " ".join(run("drop", "--height", "3ft", "--thickness", "4in", "--units", "us")[1].split())
    assert "4.00 in thick" in told and "lbf" in told and "mm" not in told and "kN" not in told


def test_in_air_as_the_rule_books_do(run: Run) -> None:
    tennis = ("--ball", "tennis", "--height", "254cm", "--material", "concrete", "--size", "60cm")
    code, out, _ = run("drop", *tennis, "--in-air", "--format", "json")
    assert code == 0
    found = json.loads(out)
    assert 1.35 < found["rebound_height_m"] < 1.47 and found["fall_height_m"] == pytest.approx(2.54)
    assert found["terminal_speed_m_s"] > 20
    assert json.loads(run("drop", *tennis, "--format", "json")[1])["terminal_speed_m_s"] is None
    assert "terminal speed in the air" in run("drop", *tennis, "--in-air")[1]

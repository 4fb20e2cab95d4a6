"""Records become dictionaries with the unit in every key, and draws put intervals beside their numbers."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated

import numpy as np
import pytest

from sweetspot.answers.records import INTERNAL, Columns, Length, Mass, Ratio, Speed, to_dict, with_intervals
from sweetspot.numerics.arrays import Array
from sweetspot.numerics.interval import Band, Curve, Interval, Number
from sweetspot.uncertainty.intervals import Reach, reach_of_draws
from sweetspot.units import INCH, MPH
from sweetspot.units.dimensions import ENERGY, LENGTH


@dataclass(frozen=True)
class Parts:
    ball: Number
    heat: Number


@dataclass(frozen=True)
class Mode:
    nodes: Annotated[Curve, LENGTH]


@dataclass(frozen=True)
class Thrown:
    name: str
    speed: Speed
    place: Length
    share: Ratio
    parts: Annotated[Parts, ENERGY]
    modes: tuple[Mode, ...]
    secret: Annotated[object, INTERNAL]
    mass: Mass | None
    late: Speed | None = None


def thrown(**changes: object) -> Thrown:
    modes = (Mode(np.array([0.1, 0.2])), Mode(np.array([0.3])))
    values = {
        "name": "x",
        "speed": 10.0,
        "place": 0.254,
        "share": float("nan"),
        "parts": Parts(1.0, 2.0),
        "modes": modes,
    }
    return Thrown(**{**values, "secret": object(), "mass": None, **changes})  # type: ignore[arg-type]


def test_keys_carry_units_and_only_what_may_be_absent_is() -> None:
    assert to_dict(thrown()) == {
        "name": "x",
        "speed_m_s": 10.0,
        "place_m": 0.254,
        "share": None,
        "parts_j": {"ball": 1.0, "heat": 2.0},
        "modes": [{"nodes_m": [0.1, 0.2]}, {"nodes_m": [0.3]}],
        "mass_kg": None,
    }
    assert to_dict(thrown(late=3.0))["late_m_s"] == 3.0


def test_us_units_change_keys_and_numbers_alike() -> None:
    table = to_dict(thrown(speed=Interval(10 * MPH, 9 * MPH, 12 * MPH)), "us")
    assert table["speed_mph"] == pytest.approx(10)
    assert (table["speed_low_mph"], table["speed_high_mph"]) == pytest.approx((9, 12))
    assert table["place_in"] == pytest.approx(0.254 / INCH)
    assert table["modes"][1]["nodes_in"] == pytest.approx([0.3 / INCH])


def test_draws_put_intervals_beside_numbers_curves_and_those_of_inner_records() -> None:
    draws = np.concatenate([[10.0], np.linspace(8.0, 12.0, 401)])
    nodes = np.stack([draws / 100, draws / 50], axis=1)
    columns: Columns = {"speed": draws, "parts": {"heat": draws / 5}, "modes": ({"nodes": nodes}, {}), "mass": draws}
    found = with_intervals(thrown(), columns, reach_of_draws)
    assert isinstance(found.speed, Interval)
    assert (found.speed.low, found.speed.value, found.speed.high) == pytest.approx((8.2, 10.0, 11.8))
    assert isinstance(found.parts.heat, Interval) and found.parts.ball == 1.0
    assert isinstance(found.modes[0].nodes, Band)
    assert found.modes[0].nodes.low == pytest.approx([0.082, 0.164])
    assert found.mass is None  # what there is not has no interval
    assert to_dict(found)["parts_j"] == pytest.approx({"ball": 1.0, "heat": 2.0, "heat_low": 1.64, "heat_high": 2.36})


def test_a_number_whose_draws_have_no_ends_stays_alone() -> None:
    def nowhere(_: Array) -> Reach:
        return Reach(np.array(np.nan), np.array(np.nan))

    assert with_intervals(thrown(), {"speed": np.zeros(3)}, nowhere).speed == 10.0


def test_a_column_of_no_field_is_a_mistake() -> None:
    with pytest.raises(AttributeError):
        with_intervals(thrown(), {"sped": np.zeros(3)}, reach_of_draws)

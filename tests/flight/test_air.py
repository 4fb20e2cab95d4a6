"""The air: density against the published sheet and against physics, wind by height, refusals."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from sweetspot.errors import InputError
from sweetspot.flight.air import CALM, STANDARD_PRESSURE, VACUUM, Air, Wind, air_density, vapour_pressure
from sweetspot.units import FOOT, INCH_OF_MERCURY

SHEET = Air(temperature=38 / 1.8, pressure=29.92 * INCH_OF_MERCURY, humidity=0.5, elevation=15 * FOOT)
"""70 degF, 50 %, 29.92 inHg, 15 ft: the weather of the sheet's printed run."""


def test_density_of_the_sheet() -> None:
    assert SHEET.density == pytest.approx(1.1938, abs=5e-5)  # published: nathan_calculator


def test_denver_has_82_percent() -> None:
    at_sea = SHEET.replaced(elevation=0.0).density
    assert SHEET.replaced(elevation=5280 * FOOT).density / at_sea == pytest.approx(0.82, abs=0.005)  # published


def test_pressure_falls_with_height_as_on_the_sheet() -> None:
    """Published (nathan_calculator): exp(-1.217e-4 z), z in m; a scale height of 8217 m."""
    low, high = (Air(temperature=20.0, humidity=0.0, elevation=height).density for height in (0.0, 2000.0))
    assert math.log(low / high) == pytest.approx(2000.0 / 8217.0, rel=1e-3)


def test_dry_air_is_an_ideal_gas() -> None:
    """Exact: rho = p / (R T), R = 287.05 J/(kg K), but for 0.03 % in the sheet's constant."""
    for temperature in (-20.0, 0.0, 40.0):
        ideal = STANDARD_PRESSURE / (287.05 * (temperature + 273.15))
        assert Air(temperature=temperature, humidity=0.0).density == pytest.approx(ideal, rel=5e-4)


def test_water_boils_under_one_atmosphere() -> None:
    assert float(vapour_pressure(100.0)) == pytest.approx(STANDARD_PRESSURE, rel=0.005)  # exact: 100 degC
    assert float(vapour_pressure(0.0)) == pytest.approx(611.2, rel=0.002)  # exact: the triple point of water, Pa


@given(st.floats(-30, 45), st.floats(0, 1), st.floats(0, 3000))
def test_warm_moist_and_high_air_is_thinner(temperature: float, humidity: float, elevation: float) -> None:
    here = Air(temperature=temperature, humidity=humidity, elevation=elevation)
    assert here.replaced(temperature=temperature + 5).density < here.density
    assert here.replaced(elevation=elevation + 100).density < here.density
    assert here.replaced(humidity=0.0).density >= here.density


def test_arrays_are_the_same_as_numbers() -> None:
    many = air_density([10.0, 30.0], pressure=STANDARD_PRESSURE, humidity=0.3, elevation=[0.0, 500.0])
    assert many[1] == Air(temperature=30.0, humidity=0.3, elevation=500.0).density
    assert many.shape == (2,)


def test_a_vacuum_weighs_nothing() -> None:
    assert VACUUM.density == 0.0


@pytest.mark.parametrize(
    ("values", "words"),
    [
        ({"temperature": 451.0}, "temperature"),
        ({"humidity": 50.0}, "humidity"),
        ({"pressure": -1.0}, "pressure"),
        ({"pressure": 0.0}, "water vapour alone"),
        ({"elevation": 1e5}, "elevation"),
    ],
)
def test_air_that_cannot_be_is_refused(values: dict[str, float], words: str) -> None:
    with pytest.raises(InputError, match=words):
        Air(**values)


def test_wind_blows_where_it_says() -> None:
    assert Wind(speed=3.0).velocity == pytest.approx([0.0, 3.0, 0.0])  # out to centre field
    assert Wind(speed=3.0, direction=math.pi / 2).velocity == pytest.approx([3.0, 0.0, 0.0], abs=1e-15)
    assert CALM.velocity == pytest.approx([0.0, 0.0, 0.0])


def test_wind_grows_with_height() -> None:
    wind = Wind(speed=8.0, exponent=1 / 7, reference_height=10.0)
    assert wind.at(10.0) == pytest.approx(wind.velocity)
    assert wind.strength(20.0) == pytest.approx(2 ** (1 / 7))
    assert wind.strength(0.0) == 0.0
    assert Wind(speed=8.0).strength(0.0) == 1.0


def test_the_stands_shelter_the_field() -> None:
    wind = Wind(speed=8.0, calm_below=5.0)
    assert np.array_equal(wind.at(4.999), np.zeros(3)) and np.array_equal(wind.at(5.0), wind.velocity)


@pytest.mark.parametrize("values", [{"speed": -1.0}, {"speed": math.nan}, {"exponent": 2.0}, {"reference_height": 0.0}])
def test_wind_that_cannot_be_is_refused(values: dict[str, float]) -> None:
    with pytest.raises(InputError, match=next(iter(values))):
        Wind(**values)

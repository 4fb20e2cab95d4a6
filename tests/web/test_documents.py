"""Words that the library writes in both systems, for readers of one; checked in units.py's own words."""

from __future__ import annotations

import pytest

from sweetspot.units import format_density, format_length, format_mass
from sweetspot.web.documents import in_one_system
from sweetspot.web.errors import FieldError, fault


def test_each_reader_sees_one_unit() -> None:
    """Exact."""
    words = in_one_system(
        f"{format_mass(0.8788)} balances {format_length(0.5602)} from the knob; a head of {format_mass(-0.1)}"
    )
    assert words["us"] == "31.0 oz balances 22.1 in from the knob; a head of \N{MINUS SIGN}3.5 oz"
    assert words["si"] == "879 g balances 56.0 cm from the knob; a head of \N{MINUS SIGN}100 g"


def test_densities_speeds_and_distances_too() -> None:
    """Exact."""
    words = in_one_system(f"{format_density(301)}; 31.29 m/s (70 mph); 100 m (328.1 ft); 0.05 kg m^2 (2734 oz in^2)")
    assert words["us"] == "18.8 lb/ft³; 70.0 mph; 328 ft; 2734 oz in²"
    assert words["si"] == "301 kg/m³; 31.3 m/s; 100.0 m; 500 kg cm²"


@pytest.mark.parametrize("words", ["3 kg (2 kg)", "", "at most 30 in (see there)", "a density of 301 kg/m^3 (2 kinds)"])
def test_other_words_stay(words: str) -> None:
    assert in_one_system(words) == {"us": words, "si": words}


def test_a_fault_has_words_for_either_where_they_differ() -> None:
    assert fault(FieldError("bat", "there is no such bat")).words is None
    told = fault(FieldError("mass_oz", f"given was {format_mass(1.0)}"))
    assert told.message == "given was 1 kg (35.27 oz)"
    assert told.words == {"us": "given was 35.3 oz", "si": "given was 1000 g"}

"""Texts with units, as people write them."""

from __future__ import annotations

import math
import os
import subprocess
import sys
from contextlib import suppress
from pathlib import Path
from typing import cast

import pytest
from hypothesis import given
from hypothesis import strategies as st

from sweetspot.errors import InputError
from sweetspot.plausibility import parse, parse_position
from sweetspot.units import Kind
from sweetspot.units import text as units
from sweetspot.units.usual_units import TEMPERATURES, WRITTEN, written


@pytest.mark.parametrize(
    ("text", "kind", "expected"),
    [
        ("33 in", "length", 0.8382),  # exact: 1 in = 25.4 mm
        ("33in", "length", 0.8382),
        ("33 1/2 in", "length", 0.8509),  # pint alone reads 16.5 in
        ("1 lb 15 oz", "mass", 0.878835216875),  # exact: 31 oz
        ("33 IN", "length", 0.8382),
        ("1/2 in", "length", 0.0127),
        ("2 ft 9.5 in", "length", 0.8509),  # pint alone reads an area
        ("2 ft 9 1/2 in", "length", 0.8509),
        ("2' 9.5\"", "length", 0.8509),
        *((text, "length", 0.8382) for text in ('33"', "33''", "33\u2033", "33\u201d", "33 in.")),
        *((text, "length", 0.8382) for text in ("2'9\"", "2' 9", "2\u20329\u2033", "2 ft 9 in")),
        *((text, "length", 0.8509) for text in ('33 1/2"', '33-1/2"', "33½ in", '33½"', "2'9 1/2\"", "33,5 in")),
        *((text, "length", 0.0127) for text in ('1/2"', "½ in", "0,5 in", ",5 in")),
        ("2'", "length", 0.6096),
        ("33¾ in", "length", 0.85725),  # pint alone drops the fraction
        ("84 cm", "length", 0.84),
        ("84,5 cm", "length", 0.845),
        ("0,845 m", "length", 0.845),  # no thousands begin with nothing
        ("30,5 oz", "mass", 30.5 * 0.028349523125),
        ("31 oz", "mass", 31 * 0.028349523125),
        ("90mph", "speed", 90 * 0.44704),
        ("11000 oz*in^2", "moi", 11000 * 0.028349523125 * 0.0254**2),
        ("15.3 GPa", "pressure", 15.3e9),
        ("70 degF", "temperature", 21.111111),
        *((text, "temperature", 200 / 9) for text in ("72F", "72 °F", "72 f", "72 degrees F", "72 Fahrenheit")),
        *((text, "temperature", -5.0) for text in ("-5C", "-5°C", "-5 deg C", "-5 celsius", "268.15 K")),
        # the eight of the league's weather reports, an eighth of a turn apart, and what people say for them
        *((text, "wind direction", 0.0) for text in ("out", "Out To CF", "out-to-centre-field", "to center", "0deg")),
        *((text, "wind direction", math.pi / 4) for text in ("Out To RF", "out to right", "to-right-field", "45deg")),
        *((text, "wind direction", math.pi / 2) for text in ("L To R", "left-to-right", "from the left", "to right")),
        *((text, "wind direction", math.pi * 3 / 4) for text in ("In From LF", "from left field", "in from left")),
        *((text, "wind direction", math.pi) for text in ("in", "In From CF", "blowing in", "180deg")),
        *((text, "wind direction", -math.pi / 2) for text in ("R To L", "right-to-left", "from right")),
        ("50%", "ratio", 0.5),
        (0.5, "ratio", 0.5),
        ("27deg", "angle", math.radians(27)),
    ],
)
def test_parses(text: str | float, kind: Kind, expected: float) -> None:
    assert parse(text, kind) == pytest.approx(expected, rel=1e-6)


@pytest.mark.parametrize(
    "text", ["250cpm", "250 cpm", "250 CPM", "250rpm", "250/min", "250 cycles/min", "250 cycles per minute"]
)
def test_a_clamped_clubs_cycles_per_minute_are_no_tone(text: str) -> None:
    with pytest.raises(InputError, match=r"hung freely, in Hz; the cycles per minute of golf clubs .* another number"):
        parse(text, "frequency")


@pytest.mark.parametrize(
    "text", ["2 revolution/s", "2 cycle/s", "12.566370614 rad/s", "2 1/s", "2 cps", "0.002 kHz", "2 hertz"]
)
def test_a_turn_a_second_is_one_hertz(text: str) -> None:
    """`pint` alone makes 6.28 Hz of it."""
    assert parse(text, "frequency") == pytest.approx(2.0, rel=1e-9)


def test_the_short_table_says_what_pint_says() -> None:
    """Both read every unit of the table alike, to rounding; what is no number and unit is left to `pint`."""
    for kind, sizes in WRITTEN.items():
        for unit in sizes:
            text = f"12.5 {unit}"
            assert written(text, kind) == pytest.approx(units._in_si(text, cast(Kind, kind)), rel=1e-13), text
    for unit in TEMPERATURES:
        text = f"-4.5 {unit}"
        assert written(text, "temperature") == pytest.approx(units._in_si(text, "temperature"), rel=1e-12)
    assert [written(text, "length") for text in ("33 1/2 in", "33 oz", "2 in 3", "1 in^2", "in")] == [None] * 5


@pytest.mark.parametrize(
    ("text", "kind", "said"),
    [
        ("31", "length", "without a unit"),
        (31.0, "mass", "without a unit"),
        ("33 1/2", "length", "without a unit"),
        ("1/2", "length", "without a unit"),
        ("84,5", "length", "without a unit"),
        ("1,250 m", "length", "thousands without it and decimals after a point"),
        ("1,250.5 m", "length", "thousands without it and decimals after a point"),
        ("1,2,3 in", "length", "decimals after a point"),
        ("31 oz", "length", "not a length"),
        ("33 in", "mass", "not a mass"),
        ("33 furlongz", "length", "not known"),
        ("nan in", "length", "finite"),
        ("inf mph", "speed", "finite"),
        ("-inf kg", "mass", "finite"),
        ("1e400 m", "length", "finite"),
        ("thirty inches", "length", "write for example"),
        ("", "length", "write for example"),
        ("3 + in", "length", "write for example"),
    ],
)
def test_refuses_with_one_clear_message(text: str | float, kind: Kind, said: str) -> None:
    with pytest.raises(InputError) as caught:
        parse(text, kind, "length")
    message = str(caught.value)
    assert said in message and message.startswith("length was given as") and "\n" not in message


@given(st.floats(0.01, 100), st.sampled_from(["in", "mm", "cm", "m", "ft"]))
def test_units_scale_linearly(number: float, unit: str) -> None:
    assert parse(f"{number!r} {unit}", "length") == pytest.approx(number * parse(f"1 {unit}", "length"), rel=1e-12)


@given(st.integers(0, 60), st.integers(0, 15))
def test_mixed_fractions_are_sums(whole: int, sixteenths: int) -> None:
    expected = (whole + sixteenths / 16) * 0.0254
    assert parse(f"{whole} {sixteenths}/16 in", "length") == pytest.approx(expected, abs=1e-12)


def test_positions() -> None:
    assert parse_position("27in", length=0.8382) == pytest.approx(0.6858)
    assert parse_position("6in-from-tip", length=0.8382) == pytest.approx(0.6858)
    assert parse_position("0.152m-from-tip", length=0.8382) == pytest.approx(0.6862)
    assert parse_position("6 1/2 in-from-knob", length=0.8382) == pytest.approx(0.1651)
    assert parse_position('6 1/2" from tip', length=0.8382) == pytest.approx(0.8382 - 0.1651)
    with pytest.raises(InputError, match="without a unit"):
        parse_position("6-from-tip", length=0.8382)


@pytest.mark.parametrize("text", ["9**9**9 in", "2^64 in", "(9)**9 in", "9⁹⁹⁹⁹⁹⁹⁹⁹⁹ in", "1 in*" * 40 + "in"])
def test_what_would_be_calculated_without_end_is_refused_at_once(text: str) -> None:
    with pytest.raises(InputError, match="write a number and its unit"):
        parse(text, "length")


def test_powers_of_units_are_understood() -> None:
    assert parse("1 kg*m^2", "moi") == parse("1 kg m²", "moi") == parse("1 kg*m**2", "moi") == 1.0


def test_units_leave_nothing_on_disk(tmp_path: Path) -> None:
    """A cache that is cut off or half-written would make every quantity unreadable."""
    code = "from sweetspot.plausibility import parse; print(round(parse('33 in', 'length'), 4))"
    torn = tmp_path / "pint"
    torn.mkdir()
    environment = {**os.environ, "HOME": str(tmp_path), "XDG_CACHE_HOME": str(tmp_path)}
    result = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True, env=environment)
    assert result.stdout == "0.8382\n"
    assert [path for path in tmp_path.rglob("*") if path.is_file()] == []


def test_only_the_text_is_blamed_for_what_it_says(monkeypatch: pytest.MonkeyPatch) -> None:
    def broken() -> None:
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(units, "_registry", broken)
    with pytest.raises(OSError, match="No space left"):
        parse("33 furlong", "length")


@pytest.mark.parametrize("number", [10**400, -(10**400), float("nan"), float("inf")])
def test_numbers_beyond_all_floats_are_refused(number: float) -> None:
    with pytest.raises(InputError, match="finite"):
        parse(number, "ratio")


@given(st.text("0123456789. eE+-*/^()inmphozkgdegCF%'\"½²,;:[]{}=<>!#&|~`@_\\\n\t\0", max_size=14))
def test_no_text_is_a_fault_of_the_program(text: str) -> None:
    with suppress(InputError):
        assert math.isfinite(parse(text, "length"))

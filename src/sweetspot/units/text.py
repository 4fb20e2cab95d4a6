"""Units at the border: text with a unit in, SI out; SI in, people's units out.

Inside the package every number is SI and in radians. Usual units are read from a short table; ``pint`` reads
all others and loads only then.
"""

from __future__ import annotations

import math
import re
import sys
from functools import cache
from typing import Any, Literal
from unicodedata import normalize

from sweetspot.errors import InputError
from sweetspot.units.factors import FOOT, INCH, MPH, OUNCE
from sweetspot.units.usual_units import written
from sweetspot.units.wind import in_words

Kind = Literal[
    "length",
    "mass",
    "speed",
    "moi",
    "density",
    "pressure",
    "force",
    "time",
    "angle",
    "wind direction",
    "angular speed",
    "linear density",
    "areal density",
    "first moment",
    "temperature",
    "stiffness",
    "damping",
    "frequency",
    "ratio",
    "slope per speed",
    "slope per temperature",
]

GROUPED_FROM = 10_000
"""Four digits are read at a glance; what people type in has no commas at all."""

SI: dict[Kind, tuple[str, str]] = {
    "length": ("meter", "33 in or 0.84 m"),
    "mass": ("kilogram", "31 oz or 0.88 kg"),
    "speed": ("meter/second", "90 mph or 40 m/s"),
    "moi": ("kilogram*meter**2", "11000 oz*in^2 or 0.2 kg*m^2"),
    "density": ("kilogram/meter**3", "680 kg/m^3"),
    "pressure": ("pascal", "15 GPa"),
    "force": ("newton", "230 N, 24 kg or 52 lb"),
    "time": ("second", "1.6 s"),
    "angle": ("radian", "27deg"),
    "wind direction": ("radian", "out, in, left-to-right, out-to-right-field or 30deg"),
    "angular speed": ("radian/second", "45 rad/s"),
    "linear density": ("kilogram/meter", "1.2 kg/m"),
    "areal density": ("kilogram/meter**2", "2.4 kg/m^2"),
    "first moment": ("kilogram*meter", "213.5 in*oz"),
    "temperature": ("kelvin", "21 degC or 70 degF"),
    "stiffness": ("newton/meter", "20 kN/m"),
    "damping": ("newton*second/meter", "100 N*s/m"),
    "frequency": ("hertz", "170 Hz"),
    "ratio": ("dimensionless", "0.5"),
    "slope per speed": ("second/meter", "0.0008 1/mph"),
    "slope per temperature": ("1/kelvin", "0.001 1/delta_degC"),
}
"""Every kind of quantity with its SI unit and an example for messages. Temperatures come out in degC."""

FRACTION = re.compile(r"^\s*(\d+)(?:\s+|-)(\d+)/(\d+)\s*(.*)$")
PLAIN_FRACTION = re.compile(r"^\s*(\d+)/(\d+)\s*([^\d\s/].*)$")
FEET_INCHES = re.compile(
    r"^\s*(\d+(?:\.\d+)?)\s*(?:ft|feet|foot)\s*(\d+(?:\.\d+)?(?:(?:\s+|-)\d+/\d+)?)\s*(?:in|inch|inches)\s*$"
)
INCH_MARK = re.compile(r"\s*(?:[\"\u2033\u201d\u201c]|''|\u2032\u2032|\u2019\u2019)\s*$")
FOOT_MARK = re.compile(r"(?<=\d)\s*['\u2032\u2019]\s*(?=\d|$)")
"""Straight marks, primes, and quotation marks as phones write them."""
ONE_SIGN_FRACTION = re.compile("[¼-¾⅐-⅞]")
POUNDS_OUNCES = re.compile(r"^\s*(\d+(?:\.\d+)?)\s*(?:lbs?|pounds?)\s*(\d+(?:\.\d+)?)\s*(?:oz|ounces?)\s*$")
WITH_ERROR = re.compile(r"±|\+/-|\+-")
TWO_NUMBERS = re.compile(r"\d\.?\s+(?!1\s*/)[-+]?\.?\d")
"""`pint` would multiply them."""
NOT_FINITE = re.compile(r"^\s*[-+]?(nan|inf|infinity)\s*([^a-z]|$|mph|m/s|in\b|oz|kg|m\b|ft)", re.IGNORECASE)
LONGEST_TEXT = 100
LARGEST_NUMBER = sys.float_info.max
POWER_OF_NUMBER = re.compile(r"[\d.)]\s*(\*\*|\^|[⁰¹²³⁴⁵⁶⁷⁸⁹])")
"""`pint` calculates, and 9**9**9 would keep it busy for good."""
DIFFERENCE = re.compile(r"(?:[a-df-z]|(?<![\d.])e)\s*[-+]\s*\d", re.IGNORECASE)
"""A range in a person's eyes; `pint` would take the difference."""
DECIMAL_COMMA = re.compile(r"(?<![\d.,])(?:(0*),(\d+)|(\d+),(\d{1,2}|\d{4,}))(?![\d.,])")
"""Of one number: what has three digits behind the comma and is no part of one may be thousands."""
PER_MINUTE = re.compile(r"\d\s*[cr]pm\b|\bmin", re.IGNORECASE)
CLAMPED = (
    "a tone here is that of an implement hung freely, in Hz; the cycles per minute of golf clubs are measured with the "
    "grip clamped and tell another number; `calibrate --tone clamped:252cpm` reads them"
)
"""Why no frequency is read per minute: clubs have about 250 of them, 4.2 Hz; the catalogue's driver rings at 42."""
COMMA = re.compile(r"\d,|,\d")
"""`pint` would drop what follows the comma."""
GRAIN_OR_GRAM = re.compile(r"(?<![a-z])grs?\b\.?", re.IGNORECASE)
NUMBER = re.compile(r"^\s*[-+]?(\d+\.?\d*|\.\d+|(?:\d+(?:\s+|-))?\d+/\d+)([eE][-+]?\d+)?\s*$")


@cache
def _registry() -> Any:
    import pint

    return pint.UnitRegistry()  # a cache on disk saves 0.2 s and can be cut off or full


def grouped(value: float, digits: int = 0, *, sign: bool = False) -> str:
    """Return a number as answers write it: from 10,000 on with a comma at every third digit, never as minus zero.

    >>> grouped(10297.4), grouped(9999.0), grouped(-0.001, 1, sign=True)
    ('10,297', '9999', '+0.0')
    """
    text = f"{value:{'+' if sign else ''}z,.{digits}f}"
    return text if abs(round(value, digits)) >= GROUPED_FROM else text.replace(",", "")


def format_length(length: float) -> str:
    """Format a length given in m in metres and inches.

    >>> format_length(0.8382)
    '0.8382 m (33 in)'
    """
    return f"{length:.4g} m ({length / INCH:.4g} in)"


def format_mass(mass: float) -> str:
    """Format a mass given in kg in kilograms and ounces.

    >>> format_mass(0.8788)
    '0.8788 kg (31 oz)'
    """
    return f"{mass:.4g} kg ({mass / OUNCE:.4g} oz)"


def format_speed(speed: float) -> str:
    """Format a speed given in m/s in metres per second and miles per hour.

    >>> format_speed(40.2336)
    '40.2 m/s (90.0 mph)'
    """
    return f"{speed:.1f} m/s ({speed / MPH:.1f} mph)"


def format_density(density: float) -> str:
    """Format a density given in kg/m^3 in both systems.

    >>> format_density(680)
    '680 kg/m^3 (42.5 lb/ft^3)'
    """
    return f"{density:.0f} kg/m^3 ({density * FOOT**3 / (16 * OUNCE):.1f} lb/ft^3)"


def to_si(text: str | float, kind: Kind, what: str = "value", *, example: str = "") -> float:
    """Return a text with a unit as a number in SI.

    Understands mixed fractions (``33 1/2 in``), feet and inches (``2 ft 9.5 in``, ``2'9"``), pounds and ounces
    (``1 lb 15 oz``), and decimals behind a comma (``84,5 cm``).

    Raises `InputError` when the unit is missing, unknown or of another kind, the number is not finite or has a comma
    that may stand for thousands.

    Parameters
    ----------
    text : number and unit; a bare number only for ratios.
    example : of it as it might be written, for messages; "": that of its kind.

    >>> round(to_si("33 1/2 in", "length"), 6), round(to_si("2 ft 9.5 in", "length"), 6)
    (0.8509, 0.8509)
    """
    example = example or SI[kind][1]
    if isinstance(text, (int, float)) and not isinstance(text, bool):
        text = "inf" if abs(text) > LARGEST_NUMBER else repr(float(text))
    if not isinstance(text, str):
        raise InputError(f"{what} was given as {text!r}; give a number with its unit in quotes, for example {example}")
    if len(text) > LONGEST_TEXT or POWER_OF_NUMBER.search(text):
        raise InputError(f"{what} was given as {text[:LONGEST_TEXT]!r}; write a number and its unit, as in {example}")
    if NOT_FINITE.match(text):
        raise InputError(f"{what} was given as {text!r}; allowed is a finite number, for example {example}")
    if WITH_ERROR.search(text):
        raise InputError(
            f"{what} was given as {text!r}; write the value alone here, as in {example}: errors are for "
            "`sweetspot calibrate` and options of --uncertainty"
        )
    if DIFFERENCE.search(text):
        raise InputError(
            f"{what} was given as {text!r}; write one number and its unit, as in {example}; where a "
            "range is taken it is written from:to:count"
        )
    if COMMA.search(with_points(text)):
        raise InputError(
            f"{what} was given as {text!r}, whose comma may stand for thousands or before decimals: write thousands "
            f"without it and decimals after a point, as in {example}"
        )
    if kind == "frequency" and PER_MINUTE.search(text):
        raise InputError(f"{what} was given as {text!r}; write for example {example}: {CLAMPED}")
    if NUMBER.match(with_points(text)) and kind != "ratio":
        raise InputError(f"{what} was given as {text.strip()} without a unit; write {_with_unit(text, kind, example)}")
    if kind == "mass" and GRAIN_OR_GRAM.search(text):
        grams = GRAIN_OR_GRAM.sub("g", text)
        raise InputError(f"{what} was given as {text!r}: gr are grains, of which an ounce has 437.5; grams are {grams}")
    value = _understood(text, kind, what)
    if not math.isfinite(value):
        raise InputError(f"{what} was given as {text!r}; allowed is a finite number, for example {example}")
    return value


def _with_unit(text: str, kind: Kind, example: str) -> str:
    """Return a bare number with the unit of an example behind it."""
    alone = re.fullmatch(r"[-+\d.]+ (\S+)", example)
    return f"{text.strip()} {alone[1]}" if alone and kind in ("length", "mass") else f"for example {example}"


def _understood(text: str, kind: Kind, what: str) -> float:
    """Return a text in SI; only what the reading of the text raises is the text's fault."""
    try:
        spelled = _spelled_out(with_points(text), kind)
    except ArithmeticError:  # a fraction of nothing
        raise InputError(_not_a_number(text, kind, what)) from None
    if TWO_NUMBERS.search(spelled):
        raise InputError(_not_a_number(text, kind, what))
    if kind == "ratio":
        percent = spelled.removesuffix("%")
        try:
            return float(percent) / (100 if percent != spelled else 1)
        except ValueError:
            raise InputError(_not_a_number(text, kind, what)) from None
    if kind == "wind direction" and (blows_to := in_words(spelled)) is not None:
        return blows_to
    value = written(spelled, "angle" if kind == "wind direction" else kind)
    return _by_pint(text, spelled, kind, what) if value is None else value


def _by_pint(text: str, spelled: str, kind: Kind, what: str) -> float:
    from tokenize import TokenError

    from pint import PintError

    _registry()  # what fails here fails for every text
    try:
        return _in_si(spelled, kind)
    except (PintError, TokenError, ValueError, ArithmeticError, AssertionError, SyntaxError, TypeError) as error:
        raise InputError(_not_understood(text, kind, what, error)) from None


def _in_si(number: str, kind: Kind) -> float:
    registry = _registry()
    if kind == "temperature":
        match = re.match(r"^\s*([-+]?[\d.]+(?:[eE][-+]?\d+)?)\s*(\S+)\s*$", number)
        if match is None:
            raise ValueError("not a temperature")
        quantity = registry.Quantity(float(match[1]), match[2])
        return float(quantity.to("degC").magnitude)
    quantity = registry.Quantity(number)
    if kind == "frequency" and "radian" in dict(quantity.to_root_units().unit_items()):
        quantity /= registry.turn  # `pint` gives turns and radians no dimension: one turn a second was 6.28 Hz
    if kind == "force" and quantity.check("[mass]"):  # strings are pulled with 55 lb or 25 kg: the weight of that
        return float((quantity * registry.standard_gravity).to("newton").magnitude)
    return float(quantity.to(SI[kind][0]).magnitude)


def with_points(text: str) -> str:
    """Return the text with a comma that can only stand before decimals as a point."""
    return DECIMAL_COMMA.sub(lambda number: number[0].replace(",", "."), text, count=1)


def _spelled_out(text: str, kind: Kind) -> str:
    """Return the text with mixed fractions and feet-and-inches written as one decimal number and unit."""
    text = ONE_SIGN_FRACTION.sub(lambda sign: " " + normalize("NFKC", sign[0]).replace("\u2044", "/"), text)
    if kind == "length":
        text = INCH_MARK.sub(" in", text)
        text = FOOT_MARK.sub(" ft ", text)
        if re.search(r"ft \d[^a-z]*$", text):  # 2'9 is two feet and nine inches
            text += " in"
    if match := FEET_INCHES.match(text):
        feet, inches = float(match[1]), match[2].replace("-", " ").split()
        total = 12 * feet + float(inches[0])
        if len(inches) == 2:
            top, bottom = inches[1].split("/")
            total += float(top) / float(bottom)
        return f"{total!r} in"
    if match := POUNDS_OUNCES.match(text):
        return f"{16 * float(match[1]) + float(match[2])!r} oz"
    if match := FRACTION.match(text):
        return f"{float(match[1]) + float(match[2]) / float(match[3])!r} {match[4]}"
    if match := PLAIN_FRACTION.match(text):
        return f"{float(match[1]) / float(match[2])!r} {match[3]}"
    return text.strip()


def _not_understood(text: str, kind: Kind, what: str, error: Exception) -> str:
    import pint

    example = SI[kind][1]
    if isinstance(error, pint.DimensionalityError):
        article = "an" if kind[0] in "aeiou" else "a"
        return f"{what} was given as {text!r}, which is not {article} {kind}; write for example {example}"
    if isinstance(error, pint.UndefinedUnitError):
        unknown = "which is no direction known here" if kind == "wind direction" else "whose unit is not known"
        return f"{what} was given as {text!r}, {unknown}; write for example {example}"
    return _not_a_number(text, kind, what)


def _not_a_number(text: str, kind: Kind, what: str) -> str:
    return f"{what} was given as {text!r}, which is not a number with a unit; write for example {SI[kind][1]}"

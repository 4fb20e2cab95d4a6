"""A tap test as JSON and as tables for a terminal."""

from __future__ import annotations

from typing import Any

from rich.console import Group, RenderableType
from rich.text import Text

from sweetspot.calibration.bar import BarModulus
from sweetspot.calibration.measured import LEVEL, Measured
from sweetspot.calibration.naming import NamedTone
from sweetspot.calibration.tap_analysis import TapTest
from sweetspot.report.bat.table import names_table
from sweetspot.report.json_shapes import cleaned


def measured_json(value: Measured, name: str, unit: str) -> dict[str, float]:
    """Return value, standard error and ends of the 90 % interval under keys that end in the unit."""
    ends = {"": value.value, "_error": value.error, "_low": value.low, "_high": value.high}
    return {f"{name}{part}{unit}": number for part, number in ends.items()}


def tap_json(test: TapTest) -> dict[str, Any]:
    """Return everything that `sweetspot tap` knows, SI."""
    return cleaned(
        {
            "interval_level": LEVEL,
            "taps": [
                {"recording": tap.recording, "time_s": tap.start, "used": tap.good, "fault": tap.fault}
                for tap in test.taps
            ],
            "tones": tone_rows(test),
            "bar": None if test.bar is None else _bar_json(test.bar),
        }
    )


def tone_rows(test: TapTest) -> list[dict[str, Any]]:
    """Return one flat row per tone, lowest first."""
    return [cleaned(_tone_json(one)) for one in test.tones]


def tap_table(test: TapTest) -> Group:
    """Return a tap test for a terminal: the taps that were not used and why, the tones, the bar."""
    used = len(test.good)
    parts: list[RenderableType] = [Text(f"{used} of {len(test.taps)} taps used.", style="bold")]
    parts += [
        Text(f"  {tap.recording}, {tap.start:.2f} s: {tap.fault}", style="yellow") for tap in test.taps if not tap.good
    ]
    shown = [
        {
            "mode": str(one.name) if one.name else "?",
            "frequency Hz": shown_measured(one.tone.frequency),
            "expected Hz": "" if one.expected is None else f"{one.expected:.1f}",
            "damping %": shown_measured(one.tone.damping_ratio, 100),
            "Q": f"{one.tone.quality:.0f}" if one.tone.damping_ratio.low > 0 else "> " + _least_quality(one),
            "level": f"{one.tone.level:.3f}",
            "taps": f"{one.tone.taps}",
        }
        for one in test.tones
    ]
    parts += [Text(), names_table(shown, "Tones")]
    if test.bar is not None:
        parts += [Text(), names_table(_bar_rows(test.bar), "The bar")]
        ranked = sorted(test.bar.budget.items(), key=lambda entry: -entry[1])
        words = ", ".join(f"{name} {100 * share:.0f} %" for name, share in ranked if share >= 0.005)
        parts.append(Text(f"What the doubt about E comes from: {words}."))
    parts += [
        Text(),
        Text(f"Plus or minus: {100 * LEVEL:g} % intervals. Level: loudness over the loudest tone's.", style="dim"),
    ]
    return Group(*parts)


def shown_measured(value: Measured, scale: float = 1.0) -> str:
    """Return a value with its interval, both to the interval's second digit."""
    import math

    half = scale * (value.high - value.value)
    digits = max(0, 1 - math.floor(math.log10(half))) if half > 0 else 3
    return f"{scale * value.value:.{min(digits, 6)}f} ± {half:.{min(digits, 6)}f}"


def _least_quality(one: NamedTone) -> str:
    return f"{0.5 / max(one.tone.damping_ratio.high, 1e-12):.0f}"


def _tone_json(one: NamedTone) -> dict[str, Any]:
    tone = one.tone
    return {
        "family": one.name.family if one.name else None,
        "harmonic": one.name.harmonic if one.name else None,
        **measured_json(tone.frequency, "frequency", "_hz"),
        **measured_json(tone.damping_ratio, "damping_ratio", ""),
        "q_factor": tone.quality,
        "level": tone.level,
        "taps": tone.taps,
        "expected_hz": one.expected,
    }


def _bar_json(bar: BarModulus) -> dict[str, Any]:
    return {
        **measured_json(bar.modulus, "modulus", "_pa"),
        **measured_json(bar.density, "density", "_kg_m3"),
        **measured_json(bar.modulus_ratio, "modulus_ratio", ""),
        "budget": bar.budget,
    }


def _bar_rows(bar: BarModulus) -> list[dict[str, str]]:
    values = {
        "Young's modulus E, GPa": shown_measured(bar.modulus, 1e-9),
        "density, kg/m³": shown_measured(bar.density),
        "E / G": shown_measured(bar.modulus_ratio),
    }
    return [{"quantity": name, "value": value} for name, value in values.items()]

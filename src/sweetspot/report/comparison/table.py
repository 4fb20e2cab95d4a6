"""A comparison of bats as JSON, as rows and as a table for a terminal."""

from __future__ import annotations

import json
import math
from pathlib import Path
from typing import Any

from rich.console import Group
from rich.padding import Padding
from rich.table import Table
from rich.text import Text

from sweetspot.analysis.comparison import Compared, Comparison
from sweetspot.equipment.implement import Implement
from sweetspot.motion.swing_law import Interval
from sweetspot.numerics.constants import STANDARD_AXIS
from sweetspot.report.bat.conclusion import US, Readers
from sweetspot.report.json_shapes import bat_json, cleaned, conditions_json
from sweetspot.units import INCH, MPH, OUNCE, OUNCE_INCH_SQUARED

INTERVAL_MEANS = "95 % of the spread of the swing law's exponent, and nothing else"
BAT_COLUMNS = ("bat", "mass oz", "balance in", "MOI 6in oz in^2", "f1 Hz", "q max", "BBCOR max")
PLAY_COLUMNS = ("bat", "bat speed mph", "exit speed mph", "change mph", "break-even bat speed mph")


def comparison_json(comparison: Comparison[Implement], verdict: list[str]) -> dict[str, Any]:
    """Return everything about a comparison; the first bat is the reference."""
    law, reference = comparison.law, comparison.reference
    exponents = law.exponents if law else None
    return cleaned(
        {
            "reference": reference.label,
            "same": "speed" if law is None else "effort",
            "swing_law": law and exponents and {
                "name": law.name,
                "exponent": _interval(exponents),
                "axis_from_grip_m": law.axis,
                "lightest_moi_kg_m2": law.lightest_moi,
            },
            "interval": INTERVAL_MEANS,
            "bats": [_bat(found) for found in comparison.compared],
            "verdict": verdict,
            "conditions": conditions_json(reference.analysis.conditions),
        }
    )  # fmt: skip


def comparison_rows(comparison: Comparison[Implement]) -> list[dict[str, Any]]:
    """Return one flat row per bat."""
    rows = []
    for found in comparison.compared:
        described = _bat(found)
        row: dict[str, Any] = {"label": found.label}
        for key, value in described.items():
            if key == "bat":
                row |= {name: value[name] for name in ("mass_kg", "balance_point_m", "moi_6in_kg_m2", "moi_knob_kg_m2")}
            elif isinstance(value, dict) and "value" in value:
                stem = key.removesuffix("_m_s")
                row |= {key: value["value"], f"{stem}_low_m_s": value["low"], f"{stem}_high_m_s": value["high"]}
            elif isinstance(value, float | None):
                row[key] = value
        rows.append(cleaned(row))
    return rows


def comparison_table(comparison: Comparison[Implement], verdict: list[str]) -> Group:
    """Return what the bats are, what they do in play, what that assumes, and the verdict."""
    bats, play = _table("The bats", BAT_COLUMNS), _table("In play", PLAY_COLUMNS)
    for number, found in enumerate(comparison.compared):
        body = found.analysis.body
        bats.add_row(
            Text(found.label),
            f"{body.mass / OUNCE:.1f}",
            f"{body.balance_point / INCH:.2f}",
            f"{body.moi(STANDARD_AXIS) / OUNCE_INCH_SQUARED:.0f}",
            f"{first_frequency(found, 'bending'):.0f}",
            f"{found.collision_efficiency:.3f}",
            f"{found.bbcor:.3f}",
        )
        play.add_row(
            Text(found.label),
            _shown(found.bat_speed),
            _shown(found.exit_speed),
            _shown(found.change, sign="+") if number else "reference",
            "-" if math.isnan(found.break_even) else f"{found.break_even / MPH:.1f}",
        )
    words = [Padding(Text(paragraph), (1, 0, 0, 0)) for paragraph in verdict]
    return Group(bats, Text(), play, Text(), Text(assumptions(comparison), style="dim"), *words)


def _table(title: str, columns: tuple[str, ...]) -> Table:
    table = Table(
        title=title, title_justify="left", title_style="bold", header_style="bold", box=None, pad_edge=False
    )  # fmt: skip
    for number, column in enumerate(columns):
        table.add_column(column, justify="right" if number else "left")
    return table


def assumptions(comparison: Comparison[Implement], readers: Readers = US) -> str:
    """Return what the numbers were computed under, in words."""
    reference = comparison.reference.analysis
    conditions, law = reference.conditions, comparison.law
    from_tip = readers.place(reference.bat.length - conditions.swing.measured_at)
    text = (
        f"Pitch {readers.speeds(conditions.pitch.speed)}. Bat speed is that {from_tip} from the tip; q and "
        "BBCOR are the greatest on the barrel at this swing's closing speed. Break-even: the bat speed with which the "
        "ball leaves as fast as from the first bat. "
    )
    if law is None:
        return text + "All bats are swung at the same speed, as no player does with unequal bats."
    low, high = law.exponents.low, law.exponents.high
    return (
        f"{text}Same effort: bat speed goes as the moment of inertia about {_axis(law.axis, readers)} to the power "
        f"-{law.exponent:g} ({law.name}). In brackets: the interval from powers of -{low:.2f} to "
        f"-{high:.2f}: {INTERVAL_MEANS}."
    )


def first_frequency(found: Compared[Implement], family: str) -> float:
    """Return the lowest frequency in Hz of a family of modes, nan where the bat has none."""
    modes = found.analysis.modes
    return min(
        (float(modes.frequency[i]) for i, name in enumerate(modes.families) if name == family), default=float("nan")
    )


def write_comparison(comparison: Comparison[Implement], verdict: list[str], folder: Path) -> list[Path]:
    """Write compare.png, compare.svg and compare.json into a folder, all of them or none.

    Raises
    ------
    InputError
        when the folder cannot be made or written.
    """
    from sweetspot.report.comparison.picture import compare_figure
    from sweetspot.report.file_set import write_folder
    from sweetspot.report.pictures.files import png_bytes, svg_bytes

    figure = compare_figure(comparison)
    text = json.dumps(comparison_json(comparison, verdict), indent=1, allow_nan=False) + "\n"
    contents = {"compare.png": png_bytes(figure), "compare.svg": svg_bytes(figure), "compare.json": text.encode()}
    return write_folder(folder, contents)


def _bat(found: Compared[Implement]) -> dict[str, Any]:
    analysis = found.analysis
    return {
        "label": found.label,
        "bat": bat_json(analysis.bat.name, analysis.bat.length, analysis.body),
        "bending_1_hz": first_frequency(found, "bending"),
        "hoop_1_hz": first_frequency(found, "hoop"),
        "max_collision_efficiency": found.collision_efficiency,
        "max_bbcor": found.bbcor,
        "bat_speed_m_s": _interval(found.bat_speed),
        "exit_speed_m_s": _interval(found.exit_speed),
        "change_m_s": _interval(found.change),
        "break_even_bat_speed_m_s": found.break_even,
        "max_exit_speed_m": analysis.sweet_spots.max_exit_speed,
        "zone_m": analysis.sweet_spots.zone,
        "scan": {"position_m": analysis.scan.position, "exit_speed_m_s": analysis.scan.exit_speed},
    }


def _interval(interval: Interval) -> dict[str, float]:
    return {"value": interval.value, "low": interval.low, "high": interval.high}


def _shown(speed: Interval, *, sign: str = "") -> str:
    """Return a speed in mph, and the ends of its interval below it where it has any width."""
    value, low, high = (_tidy(f"{end / MPH:{sign}.1f}") for end in (speed.value, speed.low, speed.high))
    return value if speed.low == speed.high else f"{value} ({low} to {high})"


def _tidy(text: str) -> str:
    """Return a rounded number without the sign of a zero."""
    return text if float(text) else "0.0"


def _axis(axis: float, readers: Readers) -> str:
    return "the knob" if axis == 0 else f"{readers.place(axis)} above the bottom of the grip"

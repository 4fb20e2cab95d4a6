"""A calibration as JSON and as tables for a terminal: before and after, given and predicted, budget, contradictions."""

from __future__ import annotations

from typing import Any

from rich.console import Group, RenderableType
from rich.text import Text

from sweetspot.calibration.calibrated_file import Value, material_values, properties
from sweetspot.calibration.measured import LEVEL, Measured
from sweetspot.calibration.measurements import Measurement, predicted
from sweetspot.calibration.posterior import CONTRADICTION, Posterior, suspects
from sweetspot.report.bat.table import names_table
from sweetspot.report.json_shapes import cleaned
from sweetspot.report.tap.tap_report import measured_json, shown_measured
from sweetspot.units import INCH, OUNCE, OUNCE_INCH_SQUARED

UNITS = {"mass": "_kg", "balance_point": "_m", "moi": "_kg_m2", "period": "_s", "frequency": "_hz", "efficiency": ""}
SHOWN = {
    "mass": ("mass, oz", 1 / OUNCE),
    "balance_point": ("balance point from the knob, in", 1 / INCH),
    "moi": ("MOI about 6 in, oz in²", 1 / OUNCE_INCH_SQUARED),
    "longitudinal_modulus": ("modulus E along the grain, GPa", 1e-9),
    "shear_modulus": ("shear modulus G, GPa", 1e-9),
    "density": ("density, kg/m³", 1.0),
}
PEOPLE = {"mass": (1 / OUNCE, "oz"), "balance_point": (1 / INCH, "in"), "period": (1.0, "s"), "frequency": (1.0, "Hz"),
          "efficiency": (1.0, ""),
          "moi": (1 / OUNCE_INCH_SQUARED, "oz in²")}  # fmt: skip
WORDS = {
    "modulus": "modulus E", "shear_modulus": "shear modulus G", "density": "density", "wall": "wall thickness",
    "density_gradient": "density, middle to tip", "knob_mass": "mass at the knob", "end_mass": "mass of the end cap",
    "ball_restitution": "restitution of the shot balls", "handle": "handle diameter", "barrel": "barrel diameter",
}  # fmt: skip
LEAST_SHARE = 0.01


def calibration_json(posterior: Posterior, damping: Measured | None) -> dict[str, Any]:
    """Return everything that `sweetspot calibrate` knows, SI."""
    values: dict[str, Value] = {**properties(posterior), **material_values(posterior)}
    units = {"mass": "_kg", "balance_point": "_m", "moi": "_kg_m2", "density": "_kg_m3"}
    return cleaned(
        {
            "interval_level": LEVEL,
            "consistent": not posterior.contradictions,
            "contradictions": posterior.contradictions,
            "findings": contradictions(posterior),
            "bat": {
                name: {"kind": one.kind, **measured_json(one.value, name, units.get(name, "_pa"))}
                for name, one in values.items()
            },
            "damping_ratio": None if damping is None else measured_json(damping, "damping_ratio", ""),
            "unknowns": [
                {"name": one.name, "before_error": one.spread,
                 **measured_json(posterior.deviation(one.name), "deviation", "")}
                for one in posterior.unknowns
            ],
            "measurements": [
                {"name": one.name, **measured_json(one.value, "measured", UNITS[one.kind]),
                 f"fitted{UNITS[one.kind]}": fitted, "off_by_sigma": pull}
                for one, fitted, pull in _rows(posterior)
            ],
            "budget": {one.name: posterior.budget(one.name) for one in posterior.unknowns},
        }
    )  # fmt: skip


def calibration_table(posterior: Posterior, damping: Measured | None) -> Group:
    """Return a calibration for a terminal."""
    parts: list[RenderableType] = [Text(words, style="yellow") for words in contradictions(posterior)]
    values: dict[str, Value] = {**properties(posterior), **material_values(posterior)}
    rows = [
        {"the bat": SHOWN[name][0], "value": shown_measured(one.value, SHOWN[name][1]), "known from": one.kind}
        for name, one in values.items()
    ]
    if damping is not None:
        rows.append({"the bat": "damping, %", "value": shown_measured(damping, 100), "known from": "measured"})
    unknowns = [
        {"what was not known": WORDS[one.name], "before": _percent(Measured(0.0, one.spread)),
         "off the description by": _percent(posterior.deviation(one.name))}
        for one in posterior.unknowns
    ]  # fmt: skip
    measured = [
        {"measured": one.name, "value": f"{shown_measured(one.value, PEOPLE[one.kind][0])} {PEOPLE[one.kind][1]}",
         "the fitted bat": f"{fitted * PEOPLE[one.kind][0]:.5g}", "off by sigma": f"{pull:+.1f}"}
        for one, fitted, pull in _rows(posterior)
    ]  # fmt: skip
    parts += [names_table(rows, "The calibrated bat"), Text(), names_table(unknowns, "What the measurements changed"),
              Text(), names_table(measured, "The measurements"), Text(), Text(budget_words(posterior)), Text(),
              Text(f"Plus or minus: {100 * LEVEL:g} % intervals. Sigma: distance from all other sources together, "
                   "one for the measurement's and the model's error.", style="dim")]  # fmt: skip
    return Group(*parts)


def contradictions(posterior: Posterior) -> list[str]:
    """Return in words which measurement contradicts the others, by how much, and what it should have been."""
    if not posterior.contradictions:
        return []
    name, pull = next(iter(posterior.contradictions.items()))
    words = [
        f"The measurements contradict each other: {_source(name)} lies {abs(pull):.1f} sigma from what all the others "
        f"say together; allowed is {CONTRADICTION:g}."
    ]
    for suspect, without in suspects(posterior).items():
        one = next(one for one in posterior.measurements if one.name == suspect)
        scale, unit = PEOPLE[one.kind]
        should = scale * predicted(without.line, [one], livelier=without.livelier)[0]
        words.append(
            f"Without {suspect} all others agree; by them it should be {should:.4g} {unit} and not "
            f"{scale * one.value.value:.4g} {unit}. Measure it again, or --leave-out '{suspect}'."
        )
    if len(words) == 1:
        words.append(
            "No single measurement explains it: look for a wrong outline, another wood, or a bat that was not free."
        )
    return words


def _rows(posterior: Posterior) -> list[tuple[Measurement, float, float]]:
    """Return every measurement with what the fitted bat says to it, and its distance from the others in sigma."""
    pulls = posterior.pulls[: len(posterior.measurements)]
    return list(zip(posterior.measurements, posterior.predictions.tolist(), pulls.tolist(), strict=True))


def budget_words(posterior: Posterior) -> str:
    """Return in words what the doubt about the modulus comes from, and what a wrong handle would do to it."""
    shares = [f"{_source(n)} {100 * s:.0f} %" for n, s in posterior.budget("modulus").items() if s >= LEAST_SHARE]
    words = f"What the doubt about E comes from: {', '.join(shares)}."
    names = posterior.sources
    if "expected handle" in names:
        index = [one.name for one in posterior.unknowns].index("handle")
        gain = posterior.gains[0][names.index("expected handle")] / posterior.unknowns[index].spread
        words += f" A handle 1 % thinner than drawn would raise E by {abs(gain):.1f} %."
    return words


def _source(name: str) -> str:
    if not name.startswith("expected "):
        return name
    unknown = name.removeprefix("expected ")
    return WORDS[unknown] if unknown in ("handle", "barrel") else f"{WORDS[unknown]} as expected"


def _percent(value: Measured) -> str:
    return f"{100 * value.value:+z.1f} ± {100 * (value.high - value.value):.1f} %"

"""Results as tables for a terminal."""

from __future__ import annotations

from typing import Any

from rich.console import Group
from rich.padding import Padding
from rich.table import Table
from rich.text import Text

from sweetspot.analysis.bat_analysis import Analysis, exit_speed_of
from sweetspot.analysis.strain import Damage
from sweetspot.collision.closed_form import bbcor
from sweetspot.collision.impact import Impact
from sweetspot.dynamics.outline_doubt import moi_doubt
from sweetspot.dynamics.rigid import RigidBody
from sweetspot.equipment.implement import Implement
from sweetspot.motion.swing import Conditions
from sweetspot.numerics.constants import STANDARD_AXIS
from sweetspot.paper.formulas import Row, Value
from sweetspot.report.bat.words import answer, from_tip, told_with_doubt
from sweetspot.report.sports.table import sport_report
from sweetspot.report.sports.vocabulary import speaks_otherwise
from sweetspot.units import INCH, MPH, OUNCE, OUNCE_INCH_SQUARED

SHOWN_MODES = 5
SHOWN_HOOPS = 3

SPOT_NAMES = {
    "max_exit_speed": ("greatest exit speed", "where the ball leaves fastest for this swing"),
    "max_collision_efficiency": ("greatest efficiency q", "where the bat at rest throws a ball back fastest"),
    "min_sting": ("least vibration", "where the hands feel least sting"),
    "node_1": ("node of mode 1", "a hit here does not excite the first bending mode"),
    "node_2": ("node of mode 2", "a hit here does not excite the second bending mode"),
    "center_of_percussion": ("centre of percussion", "a hit here does not jolt the top hand"),
}
"""Field of `SweetSpots`: (name, what it means)."""


def report_table(analysis: Analysis[Implement]) -> Group:
    """Return the terminal report: the answer, sweet spots, exit speed along the bat, mass properties, modes."""
    if speaks_otherwise(analysis.bat):
        return sport_report(analysis)
    body, bat = analysis.body, analysis.bat
    title = Text(f"{bat.name}  ", style="bold")
    title.append(f"{bat.length / INCH:.2f} in, {body.mass / OUNCE:.1f} oz, {bat.made_of}", style="dim")
    words = [Padding(Text(paragraph), (0, 0, 1, 0)) for paragraph in answer(analysis)]
    return Group(
        title, Text(), *words, _spots(analysis), Text(), _along(analysis), Text(), _mass(analysis), Text(),
        _modes(analysis), Text(), _best(analysis), Text(), Text(_conditions_line(analysis.conditions), style="dim"),
    )  # fmt: skip


def hit_table(impact: Impact, *, body: RigidBody, conditions: Conditions, length: float) -> Table:
    """Return one hit."""
    table = _table("hit", "value", title=f"Hit {(length - impact.position) / INCH:.2f} in from the tip")
    efficiency = impact.collision_efficiency
    table.add_row("outcome", impact.outcome.sentence)
    table.add_row("exit speed", f"{exit_speed_of(impact, conditions) / MPH:.1f} mph")
    table.add_row("collision efficiency q", f"{efficiency:.4f}")
    table.add_row("BBCOR", f"{bbcor(efficiency, body=body, ball=conditions.ball, position=impact.position):.3f}")
    table.add_row("contact time", f"{1e3 * impact.contact_time:.3f} ms (force above 1 % of its peak)")
    table.add_row("peak force", f"{impact.peak_force / 1e3:.1f} kN")
    table.add_row("peak compression", f"{1e3 * impact.peak_compression:.1f} mm")
    energy = impact.energy
    for name in ("ball", "heat", "translation", "rotation", "bending", "hoop", "face", "damping"):
        joules = getattr(energy, name)
        if name == "face" and not joules:  # round bats have none
            continue
        part = 100 * joules / energy.incoming if energy.incoming else 0.0
        table.add_row(f"energy: {name}", f"{joules:7.1f} J  {part:5.1f} %")
    table.add_row("energy: sum misses", f"{energy.imbalance:+.1e} of {energy.incoming:.1f} J")
    return table


def damage_lines(found: Damage) -> Text:
    """Return the strains of one hit in words, with a warning for each limit that is passed."""
    text = Text(
        f"\nGreatest bending strain of the handle {100 * found.handle_strain:.2f} %, "
        f"{found.handle_position / INCH:.1f} in from the knob"
    )
    if found.wall_strain is not None:
        text.append(f"; of the barrel's wall {100 * found.wall_strain:.2f} %")
    text.append(".")
    for warning in found.warnings:
        text.append(f"\nWarning: {warning}", style="yellow")
    return text


def paper_table(rows: list[Row], title: str = "The paper's chain") -> Table:
    """Return the paper's chain, each statement with its comment below it."""
    table = _table("eq.", "statement", "paper", "computed", "full model", "unit", title=title)
    table.columns[1].ratio = 1
    table.columns[2].max_width = 14
    table.expand = True
    for row in rows:
        values = [_value(value) for value in (row.paper, row.computed, row.full_model)]
        statement = Text(row.quantity, style="bold")
        statement.append(f"\n{row.comment}\n", style="not bold dim")
        table.add_row(row.equation, statement, *(Text(value) for value in values), row.unit)
    return table


def names_table(rows: list[dict[str, Any]], title: str) -> Table:
    """Return any list of equal rows as a table."""
    table = _table(*rows[0], title=title)
    for row in rows:
        table.add_row(*(Text(str(value)) for value in row.values()))
    return table


def _table(*columns: str, title: str) -> Table:
    table = Table(title=title, title_justify="left", title_style="bold", header_style="bold", box=None, pad_edge=False)
    for number, column in enumerate(columns):
        table.add_column(column, no_wrap=number == 0 and len(columns) < 7)
    return table


def _spots(analysis: Analysis[Implement]) -> Table:
    table = _table("sweet spot", "in from tip", "cm from knob", "what it means", title="Where it hits best")
    for field, (name, meaning) in SPOT_NAMES.items():
        place = getattr(analysis.sweet_spots, field)
        table.add_row(name, f"{from_tip(analysis, place):.2f}", f"{100 * place:.1f}", meaning)
    return table


def _along(analysis: Analysis[Implement]) -> Table:
    import numpy as np

    scan = analysis.scan
    table = _table(
        "in from tip", "exit mph", "rigid mph", "q", "BBCOR", "hand impulse N s", "sting m/s",
        title="Along the barrel",
    )  # fmt: skip
    for inches in range(13):
        place = analysis.bat.length - inches * INCH
        if place < scan.position[0]:
            break

        def at(values: Any, place: float = place) -> float:
            return float(np.interp(place, scan.position, values))

        table.add_row(
            f"{inches}", f"{at(scan.exit_speed) / MPH:.1f}", f"{at(scan.rigid_exit_speed) / MPH:.1f}",
            f"{at(scan.collision_efficiency):.3f}", f"{at(scan.bbcor):.3f}", f"{at(scan.hand_impulse):+.2f}",
            f"{at(scan.sting):.1f}",
        )  # fmt: skip
    return table


def _mass(analysis: Analysis[Implement]) -> Table:
    body = analysis.body
    table = _table("mass property", "US", "SI", title="Weight and balance")
    table.add_row("mass", f"{body.mass / OUNCE:.2f} oz", f"{body.mass:.4f} kg")
    table.add_row("balance point, from knob", f"{body.balance_point / INCH:.2f} in", f"{body.balance_point:.4f} m")
    for name, axis in (
        ("MOI about 6 in", STANDARD_AXIS),
        ("MOI about the knob end", 0.0),
        ("MOI about the balance point", body.balance_point),
    ):
        value, doubt = body.moi(axis), moi_doubt(analysis.bat, body, axis)
        spread = f" ± {doubt:.2g}" if doubt else ""
        ounces = told_with_doubt(value / OUNCE_INCH_SQUARED, doubt / OUNCE_INCH_SQUARED)
        table.add_row(name, f"{ounces} oz in^2", f"{value:.4f}{spread} kg m^2")
    return table


def _modes(analysis: Analysis[Implement]) -> Table:
    modes = analysis.modes
    table = _table("mode", "frequency", "damping", "nodes, in from tip", title="Vibration")
    shown = modes.of_family("bending")[:SHOWN_MODES] + modes.of_family("hoop")[:SHOWN_HOOPS]
    for index in shown:
        nodes = ", ".join(f"{from_tip(analysis, node):.1f}" for node in modes.nodes(index)[::-1])
        hoop = modes.families[index] == "hoop"
        name = f"hoop, n = {modes.harmonics[index]}" if hoop else f"bending {modes.harmonics[index]}"
        table.add_row(name, f"{modes.frequency[index]:.0f} Hz", f"{100 * modes.damping_ratio[index]:.2f} %", nodes)
    return table


def _best(analysis: Analysis[Implement]) -> Table:
    return hit_table(analysis.best, body=analysis.body, conditions=analysis.conditions, length=analysis.bat.length)


def _conditions_line(conditions: Conditions) -> str:
    swing = conditions.swing
    return (
        f"Conditions: {conditions.ball.name}, pitch {conditions.pitch.speed / MPH:.1f} mph, bat "
        f"{swing.bat_speed / MPH:.1f} mph {swing.measured_at / INCH:.1f} in from the knob, turning about "
        f"{swing.pivot / INCH:.1f} in, hands at {conditions.hands.position / INCH:.1f} in."
    )


def _value(value: Value) -> str:
    if value is None:
        return "-"
    return value if isinstance(value, str) else f"{value:.5g}"

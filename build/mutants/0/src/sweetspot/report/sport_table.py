"""Reports and hits of other sports for a terminal: the sport's words, metres and centimetres, its own swing weight."""

from __future__ import annotations

from typing import Any

import numpy as np
from rich.console import Group
from rich.padding import Padding
from rich.table import Table
from rich.text import Text

from sweetspot.analysis import Analysis, exit_speed_of
from sweetspot.catalog.swing_weights import swing_weight
from sweetspot.collision.impact import Impact
from sweetspot.implement import Implement
from sweetspot.report.speech import Speech, speech
from sweetspot.report.sport_words import sport_answer
from sweetspot.rigid import RigidBody
from sweetspot.swing import Conditions

STATIONS = 11
"""Places shown along the face."""
SHOWN_MODES = 4
PARTS = ("ball", "heat", "translation", "rotation", "bending", "hoop", "face", "damping")
"""Of the energy ledger."""


def sport_report(analysis: Analysis[Implement]) -> Group:
    """Return the terminal report of a racket, club, stick or cricket bat."""
    said, bat = speech(analysis.bat.sport), analysis.bat
    title = Text(f"{bat.name}  ", style="bold")
    title.append(f"{100 * bat.length:.1f} cm, {1e3 * analysis.body.mass:.1f} g, {bat.made_of}", style="dim")
    paragraphs = [Padding(Text(paragraph), (0, 0, 1, 0)) for paragraph in sport_answer(analysis)]
    best = sport_hit(analysis.best, body=analysis.body, conditions=analysis.conditions, bat=bat)
    return Group(
        title, Text(), *paragraphs, _spots(analysis, said), Text(), _along(analysis, said), Text(),
        _mass(analysis, said), Text(), _modes(analysis, said), Text(), best, Text(), _conditions(analysis, said),
    )  # fmt: skip


def sport_hit(impact: Impact, *, body: RigidBody, conditions: Conditions, bat: Implement) -> Table:
    """Return one hit in the sport's words."""
    said = speech(bat.sport)
    words = said.words
    title = f"Hit {said.place(bat.length - impact.position)} from the {words.tip}"
    table = _columns(title, "hit", "value")
    leaves, swung = exit_speed_of(impact, conditions), conditions.swing.speed_at(impact.position)
    table.add_row("outcome", impact.outcome.sentence)
    table.add_row(words.exit_speed, said.speed(leaves))
    table.add_row(words.efficiency, f"{impact.collision_efficiency:.4f}")
    if words.smash_factor:
        table.add_row(words.smash_factor, f"{leaves / swung:.3f}")
    table.add_row("contact time", f"{1e3 * impact.contact_time:.3f} ms (force above 1 % of its peak)")
    table.add_row("peak force", f"{impact.peak_force / 1e3:.3g} kN")
    table.add_row(f"peak compression of the {words.incoming}", f"{1e3 * impact.peak_compression:.1f} mm")
    energy = impact.energy
    for name in PARTS:
        joules = getattr(energy, name)
        if joules or name in ("ball", "heat"):
            part = 100 * joules / energy.incoming if energy.incoming else 0.0
            table.add_row(f"energy: {name}", f"{joules:8.2f} J  {part:5.1f} %")
    table.add_row("energy: sum misses", f"{energy.imbalance:+.1e} of {energy.incoming:.2f} J")
    mass = 1e3 * body.mass
    table.add_row("masses", f"{words.implement} {mass:.0f} g, {words.incoming} {1e3 * conditions.ball.mass:.3g} g")
    return table


def _spots(analysis: Analysis[Implement], said: Speech) -> Table:
    words, bat = said.words, analysis.bat
    unit = words.place_unit
    table = _columns("Where it hits best", "spot", f"{unit} from the {words.tip}", f"{unit} from the {words.butt}", "")
    names = {
        "max_exit_speed": (f"greatest {words.exit_speed}", f"where the {words.incoming} leaves fastest for this swing"),
        "max_collision_efficiency": (
            words.strongest or f"greatest {words.efficiency}",
            f"where a {words.implement} at rest gives back most speed",
        ),
        "min_sting": ("least vibration", "where the hand feels least"),
        "node_1": ("node of mode 1", "a hit here does not excite the first bending mode"),
        "node_2": ("node of mode 2", "a hit here does not excite the second bending mode"),
        "center_of_percussion": ("centre of percussion", "a hit here does not jolt the hand"),
    }  # fmt: skip
    for field, (name, meaning) in names.items():
        place = getattr(analysis.sweet_spots, field)
        numbers = (said.place(distance).split()[0] for distance in (bat.length - place, place))
        table.add_row(name, *numbers, meaning)
    return table


def _along(analysis: Analysis[Implement], said: Speech) -> Table:
    scan, words = analysis.scan, said.words
    table = _columns(
        f"Along the {words.implement}", f"{words.place_unit} from the {words.tip}", words.exit_speed,
        "if it were rigid", "q", "jolt N s", "vibration m/s",
    )  # fmt: skip
    for place in np.linspace(scan.position[-1], scan.position[0], STATIONS):

        def at(values: Any, place: float = float(place)) -> float:
            return float(np.interp(place, scan.position, values))

        table.add_row(
            said.place(analysis.bat.length - float(place)).split()[0], said.speed(at(scan.exit_speed)),
            said.speed(at(scan.rigid_exit_speed)), f"{at(scan.collision_efficiency):+.3f}",
            f"{at(scan.hand_impulse):+.3f}", f"{at(scan.sting):.2f}",
        )  # fmt: skip
    return table


def _mass(analysis: Analysis[Implement], said: Speech) -> Table:
    body, bat, butt = analysis.body, analysis.bat, said.words.butt
    table = _columns("Weight and balance", "mass property", "value")
    table.add_row("mass", f"{1e3 * body.mass:.1f} g")
    table.add_row(f"balance point, from the {butt}", f"{100 * body.balance_point:.1f} cm")
    convention = swing_weight(bat.sport)
    axis = f"about {100 * convention.axis:.4g} cm from the {butt}" if convention.axis else f"about the {butt}"
    table.add_row(f"{convention.name}, {axis}", convention.shown(body))
    table.add_row("moment of inertia about the balance point", f"{1e4 * body.moi_cm:.1f} kg cm^2")
    table.add_row("twist weight, about the long axis", f"{1e4 * body.roll_moi:.2f} kg cm^2")
    return table


def _modes(analysis: Analysis[Implement], said: Speech) -> Table:
    modes, words = analysis.modes, said.words
    table = _columns("Vibration", "mode", "frequency", "damping", f"nodes, {words.place_unit} from the {words.tip}")
    for index in modes.of_family("bending")[:SHOWN_MODES]:
        nodes = ", ".join(said.place(analysis.bat.length - node).split()[0] for node in modes.nodes(index)[::-1])
        damping = f"{100 * modes.damping_ratio[index]:.2f} %"
        table.add_row(f"bending {modes.harmonics[index]}", f"{modes.frequency[index]:.0f} Hz", damping, nodes)
    return table


def _conditions(analysis: Analysis[Implement], said: Speech) -> Text:
    conditions, words = analysis.conditions, said.words
    swing = conditions.swing
    measured = said.place(analysis.bat.length - swing.measured_at)
    return Text(
        f"Conditions: {conditions.ball.name} at {said.speed(conditions.pitch.speed)}, {words.implement} "
        f"{said.speed(swing.bat_speed)} {measured} from the {words.tip}, turning about "
        f"{said.place(swing.pivot)}, hand at {said.place(conditions.hands.position)} from the {words.butt}.",
        style="dim",
    )


def _columns(title: str, *columns: str) -> Table:
    table = Table(title=title, title_justify="left", title_style="bold", header_style="bold", box=None, pad_edge=False)
    for column in columns:
        table.add_column(column)
    return table

"""A drop test as a document: how high the ball comes back, and where its energy goes."""

from __future__ import annotations

import math
from typing import Any

from sweetspot.analysis.drop_test import Rebound
from sweetspot.collision.impact import EnergyLedger
from sweetspot.report.document import Block, Cell, Column, Document, Paragraph, Table
from sweetspot.report.quantities import SI
from sweetspot.report.sentences import Slot, say

SUPPORTS = {"clamped": "clamped at its edges", "floor": "lying on a floor", "free": "free"}


def drop_document(rebound: Rebound, *, fired: bool) -> Document:
    """Return a drop test as a document; in SI unless somebody says otherwise, as its laboratories have it.

    Parameters
    ----------
    fired : whether the ball was fired at the block rather than dropped.
    """
    flat, ledger = _columns(rebound), _ledger(rebound.impact.energy)
    energies = {f"energy_{name}_j": joules for name, joules in ledger.items()}
    blocks: list[Block] = [Table("", [Column(""), Column("value", right=True)], _rows(rebound, fired=fired))]
    if rebound.deflection > rebound.block.thickness:
        bent = say(
            "Beware: the block gives way by {deflection}, more than its thickness: real plates are stiffer then.",
            deflection=Slot(rebound.deflection, "pressed", of="deflection_m"),
        )
        blocks.append(Paragraph(bent, "warning"))
    return Document(
        name="drop", title="A ball on a block", kind="Drop test", blocks=blocks,
        data=flat | {"energy_j": ledger, "outcome": rebound.impact.outcome.name.lower()},
        rows={name: [value] for name, value in (flat | energies).items()}, reader=SI,
    )  # fmt: skip


def _columns(rebound: Rebound) -> dict[str, Any]:
    """Return the answer without its energies, SI with the unit in every name."""
    block = rebound.block
    return {
        "material": block.material.name,
        "thickness_m": block.thickness,
        "side_m": block.length,
        "block_mass_kg": block.mass,
        "support": block.support,
        "ball": rebound.ball.name,
        "fall_speed_m_s": rebound.fall_speed,
        "fall_height_m": rebound.fall_height,
        "terminal_speed_m_s": None if rebound.terminal == math.inf else rebound.terminal,
        "rebound_speed_m_s": rebound.rebound_speed,
        "rebound_height_m": rebound.rebound,
        "restitution": rebound.restitution,
        "energy_kept": rebound.energy_kept,
        "block_share": rebound.share,
        "deflection_m": rebound.deflection,
        "contact_time_s": rebound.impact.contact_time,
        "peak_force_n": rebound.impact.peak_force,
        "peak_compression_m": rebound.impact.peak_compression,
    }


def _ledger(energy: EnergyLedger) -> dict[str, float]:
    return {
        "incoming": energy.incoming,
        "ball": energy.ball,
        "heat": energy.heat,
        "block_translation": energy.translation,
        "block_vibration": energy.bending,
        "block_damping": energy.damping,
    }


def _rows(rebound: Rebound, *, fired: bool) -> list[tuple[Cell, Cell]]:
    block, impact = rebound.block, rebound.impact
    made_of = say(
        "{material}, {thickness} thick, {mass}, {support}", material=block.material.name,
        support=SUPPORTS[block.support], thickness=Slot(block.thickness, "pressed"),
        mass=Slot(block.mass, "mass", of="block_mass_kg"),
    )  # fmt: skip
    rows: list[tuple[Cell, Cell]] = [
        ("block", made_of),
        ("the ball meets it at", Slot(rebound.fall_speed, "speed", 2, of="fall_speed_m_s")),
        ("leaves it at", Slot(rebound.rebound_speed, "speed", 2, of="rebound_speed_m_s")),
    ]
    if not fired:
        still = rebound.terminal == math.inf
        air: Cell = "none, no air" if still else Slot(rebound.terminal, "speed", of="terminal_speed_m_s")
        rows += [
            ("falls from", Slot(rebound.fall_height, "place")),
            ("comes back to", Slot(rebound.rebound, "place", of="rebound_height_m")),
            ("terminal speed in the air", air),
        ]
    rows += [
        ("restitution e", Slot(rebound.restitution, "ratio", 4, of="restitution")),
        ("energy kept by the ball", Slot(rebound.energy_kept, "share", 1, of="energy_kept")),
        ("energy the block would hold, pressed slowly", Slot(rebound.share, "share", 2, of="block_share")),
        ("contact time", Slot(impact.contact_time, "contact", 2, of="contact_time_s")),
        ("peak force", Slot(impact.peak_force, "weight", of="peak_force_n")),
    ]
    for name, joules in _ledger(impact.energy).items():
        size = say(
            "{joules}, {part}",
            joules=Slot(joules, "energy", 3, of=f"energy_j.{name}"),
            part=Slot(joules / impact.energy.incoming, "share", 1),
        )
        rows.append((f"energy: {name.replace('_', ' ')}", size))
    return rows

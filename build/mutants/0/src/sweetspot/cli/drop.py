"""The command `drop`: a ball falls on a block."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Annotated, Any, Literal

from cyclopts import Parameter

from sweetspot.cli.options import Format
from sweetspot.errors import InputError

if TYPE_CHECKING:
    from sweetspot.drop import Rebound

OutputFormat = Annotated[Format, Parameter(name="--format", help="table for people, json or csv for programs.")]
DEFAULT_HEIGHT = "1m"


def drop(
    *,
    material: Annotated[str, Parameter(help="Material of the catalogue; wood is hit across the grain.")] = "white-ash",
    thickness: Annotated[str, Parameter(help="Thickness of the block.")] = "10cm",
    size: Annotated[str, Parameter(help="Side of its square face.")] = "20cm",
    support: Annotated[
        Literal["clamped", "floor", "free"], Parameter(help="Held all round its edges, lying on a floor, or free.")
    ] = "floor",
    floor: Annotated[Literal["concrete", "rigid"], Parameter(help="What --support floor means.")] = "concrete",
    height: Annotated[str | None, Parameter(help="Height the ball falls from; 1m unless --speed is given.")] = None,
    speed: Annotated[str | None, Parameter(help="Fire the ball at this speed instead, for example 60mph.")] = None,
    ball: Annotated[str, Parameter(help="Ball of the catalogue.")] = "baseball",
    in_air: Annotated[bool, Parameter(help="Let air slow fall and rise, as in the tests of rule books.")] = False,
    format: OutputFormat = "table",
) -> None:
    """Drop or fire a ball on a block: rebound height, restitution, contact time and where the energy goes."""
    from sweetspot import catalog
    from sweetspot import drop as drops
    from sweetspot.block import FLOOR_MODULUS, Block
    from sweetspot.cli.output import print_json, print_rows_csv, print_table
    from sweetspot.units import parse

    if height is not None and speed is not None:
        raise InputError("give either --height or --speed, and only one of them")
    side = parse(size, "length", "--size")
    block = Block(
        material=catalog.material(material),
        thickness=parse(thickness, "length", "--thickness"),
        length=side,
        width=side,
        support=support,
        floor_modulus=FLOOR_MODULUS if floor == "concrete" else None,
    )
    what = catalog.ball(ball)
    if speed is not None:
        if in_air:
            raise InputError("--in-air slows a ball that falls; with --speed it arrives as it is told to")
        found = drops.fire(block, ball=what, speed=parse(speed, "speed", "--speed"))
    else:
        fall = parse(height or DEFAULT_HEIGHT, "length", "--height")
        found = drops.drop(block, ball=what, height=fall, air_density=drops.ROOM_AIR if in_air else 0.0)
    if format == "json":
        print_json(_nested(found))
    elif format == "csv":
        print_rows_csv([_flat(found)])
    else:
        print_table(_table(found, fired=speed is not None))


def _flat(found: Rebound) -> dict[str, Any]:
    """Return the answer as one row, SI with the unit in every name."""
    block, energy = found.block, found.impact.energy
    return {
        "material": block.material.name,
        "thickness_m": block.thickness,
        "side_m": block.length,
        "block_mass_kg": block.mass,
        "support": block.support,
        "ball": found.ball.name,
        "fall_speed_m_s": found.fall_speed,
        "fall_height_m": found.fall_height,
        "terminal_speed_m_s": None if found.terminal == math.inf else found.terminal,
        "rebound_speed_m_s": found.rebound_speed,
        "rebound_height_m": found.rebound,
        "restitution": found.restitution,
        "energy_kept": found.energy_kept,
        "block_share": found.share,
        "deflection_m": found.deflection,
        "contact_time_s": found.impact.contact_time,
        "peak_force_n": found.impact.peak_force,
        "peak_compression_m": found.impact.peak_compression,
        **{f"energy_{name}_j": joules for name, joules in _ledger(energy).items()},
    }


def _nested(found: Rebound) -> dict[str, Any]:
    """Return the answer with the ledger as an object of its own, as `hit` prints it."""
    flat = {name: value for name, value in _flat(found).items() if not name.startswith("energy_") or name == KEPT}
    return {**flat, "energy_j": _ledger(found.impact.energy), "outcome": found.impact.outcome.name.lower()}


KEPT = "energy_kept"


def _ledger(energy: Any) -> dict[str, float]:
    return {
        "incoming": energy.incoming,
        "ball": energy.ball,
        "heat": energy.heat,
        "block_translation": energy.translation,
        "block_vibration": energy.bending,
        "block_damping": energy.damping,
    }


def _table(found: Rebound, *, fired: bool) -> Any:
    from sweetspot.report.table import names_table
    from sweetspot.units import INCH, MPH

    block, impact = found.block, found.impact
    words = {"clamped": "clamped at its edges", "floor": "lying on a floor", "free": "free"}[block.support]
    rows = [
        ("block", f"{block.material.name}, {1e3 * block.thickness:.4g} mm thick, {block.mass:.3g} kg, {words}"),
        ("the ball meets it at", f"{found.fall_speed:.2f} m/s ({found.fall_speed / MPH:.1f} mph)"),
        ("leaves it at", f"{found.rebound_speed:.2f} m/s ({found.rebound_speed / MPH:.1f} mph)"),
    ]
    if not fired:
        rows.append(("falls from", f"{found.fall_height:.3f} m ({found.fall_height / INCH:.1f} in)"))
        rows.append(("comes back to", f"{found.rebound:.3f} m ({found.rebound / INCH:.1f} in)"))
        rows.append(("air", "none" if found.terminal == math.inf else f"carries it at {found.terminal:.1f} m/s"))
    rows += [
        ("restitution e", f"{found.restitution:.4f}"),
        ("energy kept by the ball", f"{100 * found.energy_kept:.1f} %"),
        ("energy the block would hold, pressed slowly", f"{100 * found.share:.2f} %"),
        ("contact time", f"{1e3 * impact.contact_time:.2f} ms"),
        ("peak force", f"{impact.peak_force / 1e3:.2f} kN"),
    ]
    for name, joules in _ledger(impact.energy).items():
        part = 100 * joules / impact.energy.incoming
        rows.append((f"energy: {name.replace('_', ' ')}", f"{joules:.3f} J  {part:.1f} %"))
    if found.deflection > block.thickness:
        bent = f"gives way by {1e3 * found.deflection:.1f} mm, more than its thickness: real plates are stiffer then"
        rows.append(("beware", bent))
    shown = [{"drop test": name, "value": value} for name, value in rows]
    return names_table(shown, "A ball on a block")

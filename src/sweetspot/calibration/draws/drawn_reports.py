"""A report's answers for many draws: sweet spots, curves, the best hit, its energies, misses, weight and modes."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from sweetspot.analysis.bat_analysis import Analysis
from sweetspot.analysis.miss_cost import Loss
from sweetspot.analysis.position_scan import Scan
from sweetspot.analysis.sweet_spot import held_speeds
from sweetspot.calibration.draws.drawn_energy import drawn_ledger
from sweetspot.calibration.draws.drawn_hits import Draws, HitsAlong, draws_of, hits_along
from sweetspot.calibration.draws.drawn_spots import drawn_nodes, highest, missed, zones
from sweetspot.calibration.draws.intervals import DrawnAnswers
from sweetspot.calibration.draws.sources import DRAWS, Sources
from sweetspot.collision.impact import Impact
from sweetspot.dynamics.modes import Modes
from sweetspot.equipment.bat import Bat
from sweetspot.equipment.implement import Implement
from sweetspot.numerics.arrays import Array
from sweetspot.numerics.constants import STANDARD_AXIS
from sweetspot.numerics.parabola import tops
from sweetspot.units import MPH

PLACES = 41
"""Along the bat that are hit in every draw; between them the difference from the described bat is straight."""
CURVES = {
    "exit_speed": "exit_speed_m_s", "rigid_exit_speed": "rigid_exit_speed_m_s",
    "collision_efficiency": "collision_efficiency", "bbcor": "bbcor", "hand_impulse": "hand_impulse_n_s",
    "sting": "sting", "bat_speed": "bat_speed_m_s",
}  # fmt: skip
"""Arrays of a scan, by their names in the data."""
OF_HIT = {
    "exit_speed": "exit_speed_m_s", "collision_efficiency": "collision_efficiency", "bbcor": "bbcor",
    "bat_speed": "bat_speed_m_s", "contact_time": "contact_time_s", "peak_force": "peak_force_n",
    "peak_compression": "peak_compression_m",
}  # fmt: skip
"""What is told of one hit."""
DESCRIBED = ("bending", "hoop", "face")
"""Families of modes whose frequencies and nodes are told."""


def drawn_report(
    analysis: Analysis[Implement],
    sources: Sources,
    *,
    misses: Sequence[tuple[float, Loss, Loss]] = (),
    count: int = DRAWS,
) -> DrawnAnswers:
    """Return the answers of draws to everything that a report tells with an interval, by their names in its data.

    What is told and not in the data has a name too: "told. ...", "misses. ...".

    Parameters
    ----------
    misses : distance in m, and what it costs towards the hands and towards the tip.
    """
    draws = draws_of(analysis.line, analysis.conditions, sources, count=count)
    scan, best = analysis.scan, analysis.sweet_spots.max_exit_speed
    places = np.append(np.linspace(scan.position[0], scan.position[-1], PLACES), best)
    along = hits_along(draws, places)
    hit = {f"best_hit.{name}": value for name, value in _of_hit(draws, along, PLACES, analysis.best).items()}
    curves = _curves(scan, along)
    values = {
        **hit, **_weights(draws), **_spots(draws, curves, analysis),
        **missed(scan.position, curves["exit_speed"], misses),
        **_why_not_the_end(draws, curves, along), **_frequencies(draws), **_nodes(draws, analysis.free),
        "conditions.pitch_speed_m_s": draws.pitch_speed, "conditions.bat_speed_m_s": draws.bat_speed,
        **_of_ball(draws),
    }  # fmt: skip
    return DrawnAnswers(draws.normal, sources.names, values)


def _of_hit(draws: Draws, along: HitsAlong, column: int, impact: Impact) -> dict[str, Array]:
    columns = {told: getattr(along, name)[:, column] for name, told in OF_HIT.items()}
    with np.errstate(divide="ignore", invalid="ignore"):
        columns["smash_factor"] = columns["exit_speed_m_s"] / columns["bat_speed_m_s"]
    energy, share = drawn_ledger(draws, along, column, impact)
    parts = {"energy_j": energy, "energy_share": share}
    return {**columns, **{f"{name}.{part}": values for name, own in parts.items() for part, values in own.items()}}


def _curves(scan: Scan, along: HitsAlong) -> dict[str, Array]:
    """Return the scan's curves for every draw, shape (draws, positions): the described one and the difference."""
    coarse, columns = along.position[:PLACES], {}
    cell = np.clip(np.searchsorted(coarse, scan.position) - 1, 0, PLACES - 2)
    part = (scan.position - coarse[cell]) / (coarse[cell + 1] - coarse[cell])
    for name in CURVES:
        values = getattr(along, name)[:, :PLACES]
        off = values - values[0]
        columns[name] = getattr(scan, name) + off[:, cell] * (1 - part) + off[:, cell + 1] * part
    return columns


def _spots(draws: Draws, curves: dict[str, Array], analysis: Analysis[Implement]) -> dict[str, Array]:
    """Return every sweet spot of every draw with the zone, and the curves themselves."""
    position = analysis.scan.position
    hands, body = analysis.conditions.hands.position, draws.bats.bending
    outer = position > analysis.body.balance_point
    zone = zones(position, curves["exit_speed"], curves["sting"])
    held = held_speeds(curves["exit_speed"], step=float(position[1] - position[0]))
    arm = body.balance_point - hands
    columns = {
        "center_of_percussion_m": hands + body.moi(hands) / (body.mass * arm),
        "max_exit_speed_m": highest(position, held),
        "max_collision_efficiency_m": highest(position[outer], curves["collision_efficiency"][:, outer]),
        "min_sting_m": highest(position[outer], -curves["sting"][:, outer]),
        "zone_m": zone, "zone_start_m": zone[:, 0], "zone_end_m": zone[:, 1], "zone_width_m": zone[:, 1] - zone[:, 0],
    }  # fmt: skip
    along = {f"scan.{told}": curves[name] for name, told in CURVES.items()}
    return {**{f"sweet_spots.{name}": value for name, value in columns.items()}, **along}


def _why_not_the_end(draws: Draws, curves: dict[str, Array], along: HitsAlong) -> dict[str, Array]:
    """Return what is told of the last place to be hit beside the best one."""
    speed = curves["exit_speed"]
    _, efficiency = tops(curves["collision_efficiency"])
    return {
        "told.gain_m_s": along.bat_speed[:, PLACES - 1] - along.bat_speed[:, PLACES],
        "told.less_m_s": along.exit_speed[:, PLACES] - speed[:, -1],
        "told.effective_mass_end_kg": _effective_mass(draws, float(along.position[PLACES - 1])),
        "told.effective_mass_best_kg": _effective_mass(draws, float(along.position[PLACES])),
        "told.end_exit_speed_m_s": speed[:, -1], "told.end_rigid_exit_speed_m_s": curves["rigid_exit_speed"][:, -1],
        "told.max_collision_efficiency": efficiency,
    }  # fmt: skip


def _effective_mass(draws: Draws, place: float) -> Array:
    body = draws.bats.bending
    return np.asarray(1 / (1 / body.mass + (place - body.balance_point) ** 2 / body.moi_cm))


def _nodes(draws: Draws, modes: Modes) -> dict[str, Array]:
    """Return the nodes of bending and wall modes, in the order of the data, and the last ones of the lowest two."""
    if not draws.sources.unknowns:
        return {}
    told = [index for index, family in enumerate(modes.families) if family in DESCRIBED]
    columns = {}
    for number, (index, nodes) in enumerate(zip(told, drawn_nodes(draws, DESCRIBED), strict=True)):
        if nodes.shape[1]:
            columns[f"modes.{number}.nodes_m"] = nodes
        if nodes.shape[1] and modes.families[index] == "bending" and modes.harmonics[index] in (1, 2):
            columns[f"sweet_spots.node_{modes.harmonics[index]}_m"] = nodes[:, -1]
    return columns


def _weights(draws: Draws) -> dict[str, Array]:
    body = draws.bats.bending
    if not isinstance(draws.line.bat, Bat) and not draws.sources.unknowns:
        return {}
    return {
        "bat.mass_kg": body.mass, "bat.balance_point_m": body.balance_point, "bat.moi_cm_kg_m2": body.moi_cm,
        "bat.moi_knob_kg_m2": body.moi(0.0), "bat.moi_6in_kg_m2": body.moi(STANDARD_AXIS),
        "bat.roll_moi_kg_m2": body.roll_moi,
    }  # fmt: skip


def _of_ball(draws: Draws) -> dict[str, Array]:
    laws = [ball.restitution for ball in draws.balls]
    return {
        "conditions.ball_mass_kg": draws.ball_mass,
        "conditions.ball_restitution": np.array([law.reference for law in laws]),
        "conditions.ball_restitution_slope_s_m": np.array([law.slope for law in laws]),
        "told.restitution_step": -10 * MPH * np.array([law.slope for law in laws]),
    }  # fmt: skip


def _frequencies(draws: Draws) -> dict[str, Array]:
    """Return the frequencies of bending and wall modes, in the order of the data."""
    if not draws.sources.unknowns:
        return {}
    if draws.bats.whole is not None:
        told = [index for index, family in enumerate(draws.bats.whole.families) if family in DESCRIBED]
        every = draws.bats.angular_frequency / (2 * np.pi)
        return {f"modes.{number}.frequency_hz": every[:, index] for number, index in enumerate(told)}
    omega = draws.bats.angular_frequency[:, 2:]
    columns = {f"modes.{index}.frequency_hz": omega[:, index] / (2 * np.pi) for index in range(omega.shape[1])}
    if draws.bats.walls:
        walls = omega[:, draws.bats.bending.omega.shape[1] :]
        columns["told.lowest_hoop_hz"] = walls.min(axis=1) / (2 * np.pi)
    return columns

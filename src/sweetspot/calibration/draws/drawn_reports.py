"""A report's answers for many draws: sweet spots, curves, the best hit, weight and modes."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from sweetspot.analysis.bat_analysis import Analysis
from sweetspot.analysis.position_scan import Scan
from sweetspot.analysis.sweet_spot import max_collision_efficiency, max_exit_speed, min_sting
from sweetspot.calibration.draws.drawn_hits import Draws, HitsAlong, draws_of, hits_along
from sweetspot.calibration.draws.intervals import DrawnAnswers
from sweetspot.calibration.draws.sources import DRAWS, Sources
from sweetspot.dynamics.beam import BeamModel
from sweetspot.equipment.bat import Bat
from sweetspot.equipment.implement import Implement
from sweetspot.motion.swing import Conditions
from sweetspot.numerics.arrays import Array
from sweetspot.numerics.constants import STANDARD_AXIS

PLACES = 41
"""Along the bat that are hit in every draw; between them the difference from the described bat is straight."""
NODE_PLACES = 121
CURVES = {
    "exit_speed": "exit_speed_m_s", "collision_efficiency": "collision_efficiency", "bbcor": "bbcor",
    "hand_impulse": "hand_impulse_n_s", "sting": "sting", "bat_speed": "bat_speed_m_s",
}  # fmt: skip
"""Arrays of a scan, by their names in the data."""
OF_HIT = {
    "exit_speed": "exit_speed_m_s", "collision_efficiency": "collision_efficiency", "bbcor": "bbcor",
    "bat_speed": "bat_speed_m_s", "contact_time": "contact_time_s", "peak_force": "peak_force_n",
    "peak_compression": "peak_compression_m",
}  # fmt: skip
"""What is told of one hit."""


def drawn_hit(
    line: BeamModel, conditions: Conditions, sources: Sources, position: float, *, count: int = DRAWS
) -> DrawnAnswers:
    """Return the answers of draws to one hit at a position in m from the knob end."""
    draws = draws_of(line, conditions, sources, count=count)
    return DrawnAnswers(draws.normal, sources.names, _of_hit(hits_along(draws, np.array([position])), 0))


def drawn_report(analysis: Analysis[Implement], sources: Sources, *, count: int = DRAWS) -> DrawnAnswers:
    """Return the answers of draws to everything that a report tells with an interval, by their names in its data."""
    draws = draws_of(analysis.line, analysis.conditions, sources, count=count)
    scan, best = analysis.scan, analysis.sweet_spots.max_exit_speed
    places = np.append(np.linspace(scan.position[0], scan.position[-1], PLACES), best)
    along = hits_along(draws, places)
    values = {
        **{f"best_hit.{name}": value for name, value in _of_hit(along, PLACES).items()},
        **_weights(draws), **_spots(draws, _curves(scan, along), analysis), **_frequencies(draws),
        "conditions.pitch_speed_m_s": draws.pitch_speed, "conditions.bat_speed_m_s": draws.bat_speed,
    }  # fmt: skip
    return DrawnAnswers(draws.normal, sources.names, values)


def _of_hit(along: HitsAlong, column: int) -> dict[str, Array]:
    return {told: getattr(along, name)[:, column] for name, told in OF_HIT.items()}


def _curves(scan: Scan, along: HitsAlong) -> dict[str, Array]:
    """Return the scan's curves for every draw, shape (draws, positions): the described one and the difference."""
    coarse, found = along.position[:PLACES], {}
    cell = np.clip(np.searchsorted(coarse, scan.position) - 1, 0, PLACES - 2)
    part = (scan.position - coarse[cell]) / (coarse[cell + 1] - coarse[cell])
    for name in CURVES:
        values = getattr(along, name)[:, :PLACES]
        off = values - values[0]
        found[name] = getattr(scan, name) + off[:, cell] * (1 - part) + off[:, cell + 1] * part
    return found


def _spots(draws: Draws, curves: dict[str, Array], analysis: Analysis[Implement]) -> dict[str, Array]:
    """Return every sweet spot of every draw, and the curves themselves."""
    rows = [replace(analysis.scan, **{name: curve[row] for name, curve in curves.items()}) for row in range(len(draws))]
    hands, body = analysis.conditions.hands.position, draws.bats.bending
    arm = body.balance_point - hands
    found = {
        "center_of_percussion_m": hands + body.moi(hands) / (body.mass * arm),
        "node_1_m": _nodes(draws, 1), "node_2_m": _nodes(draws, 2),
        "max_exit_speed_m": np.array([max_exit_speed(row) for row in rows]),
        "max_collision_efficiency_m": np.array([max_collision_efficiency(row, body=analysis.body) for row in rows]),
        "min_sting_m": np.array([min_sting(row, body=analysis.body) for row in rows]),
    }  # fmt: skip
    along = {f"scan.{told}": curves[name] for name, told in CURVES.items()}
    return {**{f"sweet_spots.{name}": value for name, value in found.items()}, **along}


def _nodes(draws: Draws, mode: int) -> Array:
    """Return the node of a bending mode that is nearest to the tip, m, shape (draws,)."""
    length = draws.line.bat.length
    places = np.linspace(0.3 * length, length, NODE_PLACES)
    shape = draws.bats.bending.shapes_at(np.broadcast_to(places, (len(draws), NODE_PLACES)).copy())[..., mode + 1]
    changes = shape[:, :-1] * shape[:, 1:] <= 0
    last = NODE_PLACES - 2 - np.argmax(changes[:, ::-1], axis=1)
    row = np.arange(len(draws))
    before, after = shape[row, last], shape[row, last + 1]
    step = places[1] - places[0]
    found = places[last] + step * before / np.where(before == after, 1.0, before - after)
    return np.where(changes.any(axis=1), found, np.nan)


def _weights(draws: Draws) -> dict[str, Array]:
    body = draws.bats.bending
    if not isinstance(draws.line.bat, Bat):
        return {}
    return {
        "bat.mass_kg": body.mass, "bat.balance_point_m": body.balance_point, "bat.moi_cm_kg_m2": body.moi_cm,
        "bat.moi_knob_kg_m2": body.moi(0.0), "bat.moi_6in_kg_m2": body.moi(STANDARD_AXIS),
    }  # fmt: skip


def _frequencies(draws: Draws) -> dict[str, Array]:
    """Return the frequencies of bending and wall modes, in the order of the data."""
    if not draws.sources.unknowns:
        return {}
    omega = draws.bats.angular_frequency[:, 2:]
    return {f"modes.{index}.frequency_hz": omega[:, index] / (2 * np.pi) for index in range(omega.shape[1])}

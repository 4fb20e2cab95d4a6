"""A report's answers to many draws: sweet spots, curves, the best hit, its energies, misses, weight and modes."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from sweetspot.analysis.bat_analysis import Analysis
from sweetspot.analysis.position_scan import Scan
from sweetspot.analysis.sweet_spot import without_spikes
from sweetspot.answers.answer import DrawnAnswer
from sweetspot.answers.conditions import conditions_columns, mass_columns
from sweetspot.answers.hit import hit_columns
from sweetspot.answers.records import Columns
from sweetspot.dynamics.modes import Modes
from sweetspot.equipment.implement import Implement
from sweetspot.numerics.arrays import Array
from sweetspot.numerics.interpolants import tops
from sweetspot.uncertainty.drawn_hits import Draws, HitsAlong, draws_of, hits_along
from sweetspot.uncertainty.drawn_spots import MissCost, best_positions, costs_of_misses, drawn_nodes, sweet_zones
from sweetspot.uncertainty.sources import DRAWS, Sources

PLACES = 41
"""Along the bat that are hit in every draw; between them the difference from the described bat is straight."""
CURVES = (
    "exit_speed",
    "rigid_exit_speed",
    "collision_efficiency",
    "bbcor",
    "hand_impulse",
    "sting",
    "bat_speed",
)
"""Fields of `CurvesAlong` that draws answer."""
DESCRIBED = ("bending", "hoop", "face")
"""Families of modes whose frequencies and nodes are answered."""


def drawn_report(
    analysis: Analysis[Implement],
    sources: Sources,
    *,
    misses: Sequence[MissCost] = (),
    count: int = DRAWS,
) -> DrawnAnswer:
    """Return the answers of draws to everything that a report answers with an interval.

    ``misses``: what they cost the implement as described.
    """
    draws = draws_of(analysis.beam, analysis.conditions, sources, count=count)
    scan, best = analysis.scan, analysis.sweet_spots.max_exit_speed
    places = np.append(np.linspace(scan.position[0], scan.position[-1], PLACES), best)
    along = hits_along(draws, places)
    curves = _curves(scan, along)
    frequencies, nodes = _frequencies(draws), drawn_nodes(draws, DESCRIBED) if draws.sources.unknowns else []
    columns: dict[str, Columns | Array | Sequence[Columns]] = {
        "bat": mass_columns(draws),
        "best_hit": hit_columns(draws, along, PLACES, analysis.best),
        "scan": curves,
        "sweet_spots": {**_spots(draws, curves, analysis), **_barrel_nodes(analysis.free, nodes)},
        "misses": costs_of_misses(scan.position, curves["exit_speed"], misses),
        "at_the_tip": _at_the_tip(draws, curves, along),
        "modes": _modes(analysis.modes, frequencies, nodes),
        "conditions": conditions_columns(draws),
        "greatest_efficiency": tops(curves["collision_efficiency"])[1],
    }
    hoop = _lowest_hoop(draws, frequencies)
    return DrawnAnswer(draws.normal, columns if hoop is None else {**columns, "lowest_hoop": hoop})


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
    """Return every sweet spot of every draw, with the zone, but for nodes."""
    position = analysis.scan.position
    hands, body = analysis.conditions.hands.position, draws.bats.bending
    outer = position > analysis.body.balance_point
    zone = sweet_zones(position, curves["exit_speed"], curves["sting"])
    held = without_spikes(curves["exit_speed"], step=float(position[1] - position[0]))
    arm = body.balance_point - hands
    return {
        "center_of_percussion": hands + body.moi(hands) / (body.mass * arm),
        "max_exit_speed": best_positions(position, held),
        "max_collision_efficiency": best_positions(position[outer], curves["collision_efficiency"][:, outer]),
        "min_sting": best_positions(position[outer], -curves["sting"][:, outer]),
        "zone": zone,
        "zone_width": zone[:, 1] - zone[:, 0],
    }


def _at_the_tip(draws: Draws, curves: dict[str, Array], along: HitsAlong) -> dict[str, Array]:
    """Return the last place to be hit beside the best one, by the fields of `AtTheTip`."""
    speed = curves["exit_speed"]
    return {
        "bat_speed_gain": along.bat_speed[:, PLACES - 1] - along.bat_speed[:, PLACES],
        "exit_speed_loss": along.exit_speed[:, PLACES] - speed[:, -1],
        "effective_mass": _effective_mass(draws, float(along.position[PLACES - 1])),
        "best_effective_mass": _effective_mass(draws, float(along.position[PLACES])),
        "exit_speed": speed[:, -1],
        "rigid_exit_speed": curves["rigid_exit_speed"][:, -1],
    }


def _effective_mass(draws: Draws, place: float) -> Array:
    body = draws.bats.bending
    return np.asarray(1 / (1 / body.mass + (place - body.balance_point) ** 2 / body.moi_cm))


def _modes(modes: Modes, frequencies: Sequence[Array], nodes: Sequence[Array]) -> list[dict[str, Array]]:
    """Return tones and nodes of every mode that is answered, in their order, by the fields of `VibrationMode`."""
    columns: list[dict[str, Array]] = [{} for family in modes.families if family in DESCRIBED]
    for column, frequency in zip(columns, frequencies, strict=False):
        column["frequency"] = frequency
    for column, places in zip(columns, nodes, strict=False):
        if places.shape[1]:
            column["nodes"] = places
    return columns


def _barrel_nodes(modes: Modes, nodes: Sequence[Array]) -> dict[str, Array]:
    """Return the nodes nearest to the tip of the two lowest bending modes, by the fields of `SweetSpotPlaces`."""
    described = [index for index, family in enumerate(modes.families) if family in DESCRIBED]
    return {
        f"node_{modes.harmonics[index]}": places[:, -1]
        for index, places in zip(described, nodes, strict=False)
        if places.shape[1] and modes.families[index] == "bending" and modes.harmonics[index] in (1, 2)
    }


def _frequencies(draws: Draws) -> list[Array]:
    """Return the tones in Hz of every mode that is answered, in their order; none where nothing of them is open."""
    if not draws.sources.unknowns:
        return []
    every = draws.bats.angular_frequency / (2 * np.pi)
    if draws.bats.whole is None:
        return list(every[:, 2:].T)
    return [every[:, index] for index, family in enumerate(draws.bats.whole.families) if family in DESCRIBED]


def _lowest_hoop(draws: Draws, frequencies: Sequence[Array]) -> Array | None:
    """Return the lowest tone of every draw's wall in Hz; None where it has none, or nothing is open."""
    if not frequencies or draws.bats.whole is not None or not draws.bats.walls:
        return None
    return np.asarray(np.min(frequencies[draws.bats.bending.omega.shape[1] :], axis=0))

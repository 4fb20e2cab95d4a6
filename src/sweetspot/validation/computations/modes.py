"""Frequencies and nodes: of a thin rod, of the catalogue's bats, of a bat in the hands."""

from __future__ import annotations

from functools import cache

import numpy as np

from sweetspot import catalog
from sweetspot.analysis.bat_analysis import TYPICAL_HAND
from sweetspot.dynamics.beam import beam_model, section
from sweetspot.dynamics.hands import held_modes
from sweetspot.dynamics.modes import Modes
from sweetspot.dynamics.reduction import bending_modes
from sweetspot.dynamics.rigid import centre_of_percussion
from sweetspot.equipment.bat import Bat
from sweetspot.motion.swing import Hands
from sweetspot.units import INCH
from sweetspot.validation.computations import shared

THIN_LENGTH, THIN_DIAMETER = 1.3, 0.005
"""m; the longest and thinnest rod that a bat may be: radius of gyration over length is 1/1040."""


def thin_rod_root(*, mode: int) -> float:
    """Return beta L of a thin aluminium rod hung freely, beta^4 = omega^2 mu / (E I)."""
    modes, ratio = _thin_rod()
    return float((modes.angular_frequency[modes.of_family("bending")[mode - 1]] ** 2 * ratio) ** 0.25 * THIN_LENGTH)


def thin_rod_node() -> float:
    """Return the outer node of its first mode, distance from the end over length."""
    modes, _ = _thin_rod()
    return float(modes.nodes(modes.of_family("bending")[0])[0] / THIN_LENGTH)


@cache
def _thin_rod() -> tuple[Modes, float]:
    """Return the rod's modes and its mass per length over bending stiffness."""
    bat = Bat(
        name="thin rod",
        length=THIN_LENGTH,
        material=catalog.material("aluminium_7xxx"),
        profile=((0.0, THIN_DIAMETER), (THIN_LENGTH, THIN_DIAMETER)),
    )
    beam = beam_model(bat)
    at = section(beam, np.array([THIN_LENGTH / 2]))
    return bending_modes(beam, count=3), float(at.mass[0] / at.bending_stiffness[0])


def frequency(*, bat: str, mode: int) -> float:
    """Return the frequency of a free bending mode."""
    modes = shared.free_modes(bat)
    return float(modes.frequency[modes.of_family("bending")[mode - 1]])


def node_from_tip(*, bat: str, mode: int, node: int) -> float:
    """Return how far from the tip a node lies; ``node`` counts from the tip."""
    modes = shared.free_modes(bat)
    return float(shared.length(bat) - modes.nodes(modes.of_family("bending")[mode - 1])[-node])


def node_from_knob(*, bat: str, mode: int, node: int) -> float:
    """Return how far from the knob end a node lies; ``node`` counts from the knob."""
    modes = shared.free_modes(bat)
    return float(modes.nodes(modes.of_family("bending")[mode - 1])[node - 1])


def node_percussion_distance(*, bat: str, pivot: float) -> float:
    """Return how much further from the tip the first mode's node is than the centre of percussion about ``pivot``."""
    percussion_from_tip = shared.length(bat) - centre_of_percussion(shared.body(bat), pivot=pivot)
    return node_from_tip(bat=bat, mode=1, node=1) - percussion_from_tip


def grip_frequency_change(*, bat: str) -> float:
    """Return the relative change of the first bending frequency in typical hands, 6 in from the knob end.

    The motion of the held bat that is most like the free mode is the one compared.
    """
    free = shared.free_modes(bat)
    held = held_modes(free, Hands(position=6 * INCH, **TYPICAL_HAND))
    first = free.of_family("bending")[0]
    places = np.linspace(0, shared.length(bat), 200)
    likeness = np.corrcoef(free.shape_at(places)[:, first], held.shape_at(places), rowvar=False)[0, 1:]
    return float(held.frequency[np.abs(likeness).argmax()] / free.frequency[first] - 1)


COMPUTATIONS = (
    thin_rod_root,
    thin_rod_node,
    frequency,
    node_from_tip,
    node_from_knob,
    node_percussion_distance,
    grip_frequency_change,
)

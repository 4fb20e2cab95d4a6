"""Bats, modes and analyses that several cases share, each computed once."""

from __future__ import annotations

from functools import cache

from sweetspot import catalog
from sweetspot.analysis.bat_analysis import Analysis, analyse
from sweetspot.catalog.standard_hit import standard_conditions
from sweetspot.dynamics.beam import BeamModel, beam_model
from sweetspot.dynamics.modes import Modes
from sweetspot.dynamics.reduction import all_modes
from sweetspot.dynamics.rigid import RigidBody, rigid_body


@cache
def beam(bat: str) -> BeamModel:
    """Return a catalogue bat as a beam."""
    return beam_model(catalog.bat(bat))


@cache
def body(bat: str) -> RigidBody:
    """Return a catalogue bat as a rigid body."""
    return rigid_body(beam(bat))


@cache
def free_modes(bat: str) -> Modes:
    """Return the motions of a catalogue bat hung freely, as the catalogue's baseball meets them."""
    return all_modes(beam(bat), catalog.ball())


@cache
def standard(bat: str) -> Analysis:
    """Return the full answer for a catalogue bat under the standard conditions: 90 mph pitch, 70 mph of bat speed."""
    described = catalog.bat(bat)
    return analyse(described, standard_conditions(described))


def length(bat: str) -> float:
    """Return the length of a catalogue bat in m."""
    return catalog.bat(bat).length

"""All motions of a bat that a ball can excite, in one list."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np

from sweetspot.dynamics.beam import BeamModel
from sweetspot.dynamics.bending import MODES, bending_modes
from sweetspot.dynamics.dent import blade_dent, dent_compliance
from sweetspot.dynamics.modes import Modes, joined
from sweetspot.dynamics.patch import patch_law
from sweetspot.equipment.ball import Ball, peak_compression
from sweetspot.equipment.bat import Bat
from sweetspot.equipment.cricket_bat import CricketBat

AHEAD = 2.0
"""Highest bending mode over the frequency at which ball and face swing against each other: q is then within 2e-4 of
that with eighty modes on a badminton racket, the slowest to converge."""
MOST_MODES = 48
WALL_SPEED = 30.0
"""m/s on a rigid wall, where the ball's steepness is taken; it changes little with speed."""
PLACES = np.linspace(0.4, 1.0, 25)
"""Parts of the length at which the surface is asked how light it is."""


def all_modes(line: BeamModel, ball: Ball, *, patch_factor: float = 1.0, count: int | None = None) -> Modes:
    """Return rigid motions and bending modes of a bat, and what its striking face or hollow barrel adds.

    A face adds roll and its own mode, damped as it damps this ball; a hollow barrel its hoop modes, which are felt
    through the ball's contact patch. A solid or drilled wood barrel has none that a ball could excite: it is dented,
    and gives way at once.

    Parameters
    ----------
    line : from `beam_model`.
    ball : that will hit the bat: hoop modes are felt through its patch, a face is damped by it.
    patch_factor : on the radius of the ball's contact patch, > 0; 1 unless its doubt is asked for (`PATCH_SPREAD`).
    count : of the bending modes beside a face; None: as many as a contact excites, see `excited_bending`.

    >>> from sweetspot import all_modes, beam_model, catalog
    >>> modes = all_modes(beam_model(catalog.bat("r161-ash")), catalog.ball())
    >>> modes, modes.frequency[2:4].round()  # Hz, of the first two bending modes
    (<Modes: 2 rigid, 12 bending>, array([172., 572.]))
    """
    if line.bat.face is not None:
        from sweetspot.dynamics.face_vibration import face_modes

        face = face_modes(line, ball)
        bending = excited_bending(line, face, ball) if count is None else bending_modes(line, count=count)
        if isinstance(line.bat, CricketBat):
            dent = blade_dent(line, law=patch_law(ball, factor=patch_factor))
            bending = replace(bending, compliances=(*bending.compliances, dent))
        return joined(bending, face)
    bending = bending_modes(line)
    if not isinstance(line.bat, Bat):
        return bending
    law = patch_law(ball, factor=patch_factor)
    if line.bat.shell is None:
        return replace(bending, compliances=(*bending.compliances, dent_compliance(line, law=law)))
    from sweetspot.dynamics.hoop import hoop_modes

    return joined(bending, hoop_modes(line, law=law))


def excited_bending(line: BeamModel, face: Modes, ball: Ball) -> Modes:
    """Return as many bending modes, by the dozen, as a quick contact excites: those up to `AHEAD` times its frequency.

    A hard ball of a few grams on light strings is over before a slender shaft's twelfth mode has swung once.
    """
    bending, count = bending_modes(line), MODES
    wanted = excited_frequency(bending, face, ball)
    while bending.frequency[-1] < wanted and count < MOST_MODES:
        count += MODES
        bending = bending_modes(line, count=count)
    return bending


def excited_frequency(bending: Modes, face: Modes, ball: Ball) -> float:
    """Return the frequency in Hz that the highest bending mode must reach beside this face; see `excited_bending`.

    Parameters
    ----------
    bending : the lowest `MODES`, and the rigid motions.
    """
    together = joined(bending, face)
    places = PLACES * bending.shapes.ends[-1]
    inverse_mass = 1 / ball.mass + float((together.shape_at(places) ** 2).sum(axis=-1).max())
    return AHEAD * math.sqrt(_steepness(ball) * inverse_mass) / (2 * math.pi)


def _steepness(ball: Ball) -> float:
    """Return dF/du in N/m where the ball turns, on a rigid wall at `WALL_SPEED`: n k U^(n-1)."""
    peak = peak_compression(ball, WALL_SPEED)
    return float(ball.exponent * ball.stiffness * peak ** (ball.exponent - 1))

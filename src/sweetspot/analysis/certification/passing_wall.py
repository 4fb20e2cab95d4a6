"""Which barrel wall would just pass: the thinnest that keeps a limit of the bat test and all thicker ones too."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from sweetspot.analysis.certification.simulated_test import BBCOR_SPEED, BPF_SPEED, bat_test, bpf
from sweetspot.dynamics.beam import beam_model
from sweetspot.dynamics.reduction import all_modes
from sweetspot.dynamics.rigid import rigid_body
from sweetspot.dynamics.weight_match import barrel_start, with_barrel_wall
from sweetspot.equipment.ball import Ball
from sweetspot.equipment.bat import Bat
from sweetspot.errors import InputError

FACTORS = np.geomspace(0.6, 3.0, 9)
THICKEST = 0.25
"""Of the barrel's radius: a thicker wall is no shell, and no bat."""
CLOSE = 1e-3
MEASURES = ("bbcor", "bpf")


@dataclass(frozen=True)
class PassingWall:
    """A bat with the thinnest barrel wall that keeps a limit.

    ``factor``: how many times as thick as drawn. ``thickness``: m at the middle of the barrel. ``mass``: kg of the bat
    then; knob, cap and handle as drawn.
    """

    bat: Bat
    factor: float
    thickness: float
    mass: float
    limit: float
    measure: str


def wall_that_passes(bat: Bat, *, ball: Ball, limit: float, measure: str = "bbcor") -> PassingWall:
    """Return the thinnest barrel wall with which a hollow bat keeps a limit, with all thicker ones.

    All of the barrel's wall is scaled alike, sleeve included; the handle's stays.

    ``measure``: "bbcor" (136 mph) or "bpf" (60 mph).
    """
    from scipy.optimize import brentq

    if measure not in MEASURES:
        raise InputError(f"measure was given as {measure!r}; allowed are {' and '.join(MEASURES)}")
    if bat.shell is None:
        raise InputError(f"{bat.name} is solid; only a hollow bat has a wall that could pass")
    middle = (barrel_start(bat) + bat.length) / 2
    drawn, radius = float(bat.wall_at(middle)), float(bat.diameter_at(middle)) / 2
    factors = FACTORS[drawn * FACTORS <= THICKEST * radius]

    def excess(factor: float) -> float:
        return _measured(with_barrel_wall(bat, factor), ball, measure) - limit

    above: float | None = None
    for factor, beyond in zip(factors[::-1], factors[::-1][1:], strict=False):
        if above is None and excess(float(factor)) > 0:
            break
        above = float(factor)
        if excess(float(beyond)) > 0:
            wall = float(brentq(excess, float(beyond), above, xtol=CLOSE))
            wall += 0.0 if excess(wall) <= 0 else CLOSE
            return _passing(bat, wall, middle, limit, measure)
    if above is not None:
        return _passing(bat, float(factors[0]), middle, limit, measure)
    raise InputError(
        f"no barrel wall of {bat.name} up to {1e3 * drawn * float(factors[-1]):.1f} mm keeps {measure.upper()} at "
        f"{limit:g}; rings or a disc inside the barrel ([[shell.ring]]) may"
    )


def _passing(bat: Bat, factor: float, middle: float, limit: float, measure: str) -> PassingWall:
    passing = with_barrel_wall(bat, factor)
    mass = rigid_body(beam_model(passing)).mass
    return PassingWall(passing, factor, float(passing.wall_at(middle)), mass, limit, measure)


def _measured(bat: Bat, ball: Ball, measure: str) -> float:
    beam = beam_model(bat)
    speed = BBCOR_SPEED if measure == "bbcor" else BPF_SPEED
    test = bat_test(beam, body=rigid_body(beam), modes=all_modes(beam, ball), ball=ball, closing_speed=speed)
    return test.best_bbcor if measure == "bbcor" else bpf(test.best_bbcor, ball_restitution=test.ball_restitution)

"""The trampoline effect: how much of the ball's energy a hollow barrel's wall takes, and how much it gives back."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from sweetspot.analysis.bat_analysis import Analysis, analyse, exit_speed_of
from sweetspot.collision.closed_form import bbcor
from sweetspot.collision.contact_law import loading_force
from sweetspot.collision.impact import Impact, bat_energy
from sweetspot.collision.modal_response import replayed
from sweetspot.dynamics.modes import Modes
from sweetspot.dynamics.weight_match import with_wall_factor
from sweetspot.equipment.ball import Ball
from sweetspot.equipment.bat import Bat
from sweetspot.errors import InputError
from sweetspot.motion.swing import Conditions


@dataclass(frozen=True)
class WallEnergy:
    """Work of a wall during one hit.

    Parameters
    ----------
    stored : J, the most energy the hoop modes held at one time.
    left : J, what they still held when the ball had gone.
    share : stored over the ball's incoming energy.
    restitution : sqrt(1 - left / stored), the paper's k of the bat; nan when nothing was stored.
    """

    stored: float
    left: float
    share: float
    restitution: float


@dataclass(frozen=True)
class WallPoint:
    """One wall of a sweep: thickness at the barrel (m), hoop frequency (Hz), and what the best hit gives."""

    thickness: float
    mass: float
    hoop_frequency: float
    bbcor: float
    exit_speed: float
    share: float
    energy: WallEnergy


def wall_stiffness_at(modes: Modes, position: float, *, closing_speed: float | None = None) -> float:
    """Return the wall's stiffness in N/m against a slow push at ``position``: 1 / (C + sum(s^2 / omega^2)).

    The sum is over hoop modes, C is the instantaneous compliance. Infinite for a bat without hoop modes.

    ``closing_speed``: m/s of the hit whose patch pushes; None: as at game speed.
    """
    hoop = modes.of_family("hoop")
    if not hoop:
        return math.inf
    give = np.sum((modes.shape_at(position, closing_speed=closing_speed)[hoop] / modes.angular_frequency[hoop]) ** 2)
    return float(1 / (give + modes.compliance_at(position, closing_speed=closing_speed)))


def wall_share(ball: Ball, *, modes: Modes, position: float, compression: float) -> float:
    """Return z = k_b / (k_b + k_w), the wall's share of the energy under a slow push [paper2014].

    ``compression``: m, of the ball; k_b is its force over it.
    """
    ball_stiffness = loading_force(ball, compression) / compression
    return ball_stiffness / (ball_stiffness + wall_stiffness_at(modes, position))


def wall_energy(impact: Impact, modes: Modes) -> WallEnergy:
    """Return the energy that the wall stored and returned in a hit, by driving the hoop modes with the recorded force.

    The instantaneous compliance under the ball stores C F^2 / 2, and returns all of it.
    """
    hoop = modes.selected(modes.of_family("hoop"))
    if len(hoop) == 0 or len(impact.force) < 3:
        return WallEnergy(0.0, 0.0, 0.0, math.nan)
    motion = replayed(impact, hoop)
    energy = bat_energy(hoop, motion.displacement, motion.velocity)[3]
    held = float(energy[-1])
    give = float(modes.compliance_at(impact.position, impact.lateral, closing_speed=impact.closing_speed))
    stored = float((energy[:-1] + give * impact.force**2 / 2).max())
    restitution = math.sqrt(max(0.0, 1 - held / stored)) if stored > 0 else math.nan
    return WallEnergy(stored, held, stored / impact.energy.incoming, restitution)


def wall_point(bat: Bat, conditions: Conditions) -> WallPoint:
    """Return wall, hoop frequency and best hit of one hollow bat."""
    return wall_point_of(analyse(bat, conditions))


def wall_point_of(analysis: Analysis) -> WallPoint:
    """Return wall, hoop frequency and best hit of a hollow bat that is analysed already."""
    modes, conditions = analysis.modes, analysis.conditions
    hoop = modes.of_family("hoop")
    if not hoop:
        raise InputError(f"{analysis.bat.name} has no hoop modes; give a bat with a shell")
    best, ball = analysis.best, conditions.ball
    return WallPoint(
        thickness=float(analysis.bat.wall_at(best.position)),
        mass=analysis.body.mass,
        hoop_frequency=float(modes.frequency[hoop].min()),
        bbcor=bbcor(best.collision_efficiency, body=analysis.body, ball=ball, position=best.position),
        exit_speed=exit_speed_of(best, conditions),
        share=wall_share(ball, modes=modes, position=best.position, compression=best.peak_compression),
        energy=wall_energy(best, modes),
    )


def wall_sweep(bat: Bat, conditions: Conditions, *, factors: tuple[float, ...]) -> list[WallPoint]:
    """Return one `WallPoint` per factor on the bat's wall thickness."""
    return [wall_point(with_wall_factor(bat, factor), conditions) for factor in factors]

"""How sure an answer is: what is not known of bat and ball, carried through the collision to exit speed, q and BBCOR.

Each source is moved one sigma up and down and the bat hit again all along its barrel. That gives slope and bend of
every answer; a sum of both over the sources is the answer for any bat and ball that might be meant. Intervals are
linear in the slopes; the place of the greatest exit speed, which no slope can tell, comes from draws of the sum
(Sobol's sequence).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from sweetspot.analysis.position_scan import scan
from sweetspot.calibration.ball_doubt import ball_off
from sweetspot.calibration.measured import REACH, Measured
from sweetspot.calibration.measurements import Measurement
from sweetspot.calibration.posterior import calibrate
from sweetspot.calibration.unknowns import Unknown, described, deviated, unknowns_of
from sweetspot.catalog.balls import ball_spreads
from sweetspot.dynamics.beam import BeamModel
from sweetspot.dynamics.mode_assembly import all_modes
from sweetspot.dynamics.rigid import rigid_body
from sweetspot.equipment.bat import Bat
from sweetspot.equipment.implement import Implement
from sweetspot.errors import InputError
from sweetspot.motion.swing import Conditions
from sweetspot.numerics.arrays import Array

PLACES = 41
"""Along the part of the bat that is looked at."""
REACHED = 0.3
"""m from the tip, the part of the bat that is looked at."""
WEIGHED, BALANCED, HUNG = 0.003, 0.0025, 0.01
"""One sigma of a weight, of a balance point in m, and of a moment of inertia, that a bat file gives without an error:
0.1 oz of 31, 0.1 in, 1 % (assumed)."""
OUTPUTS = ("exit_speed", "collision_efficiency", "bbcor")
DRAWS = 1024


@dataclass(frozen=True)
class Doubt:
    """What answers along a bat depend on.

    Parameters
    ----------
    sources : names of what is not known exactly, of the bat first.
    of_ball : for each source, whether it is the ball's.
    covariance : of the sources, shape (n, n).
    position : m from the knob end, shape (m,).
    values : of every output along the bat, shape (m,).
    slopes, bends : first derivative by every source, and half the second, shape (n, m).
    """

    sources: tuple[str, ...]
    of_ball: tuple[bool, ...]
    covariance: Array
    position: Array
    values: dict[str, Array]
    slopes: dict[str, Array]
    bends: dict[str, Array]

    def slope_at(self, output: str, position: float) -> Array:
        """Return the derivatives of an output at a place by every source, shape (n,)."""
        return np.array([np.interp(position, self.position, row) for row in self.slopes[output]])

    def at(self, output: str, position: float) -> Measured:
        """Return an output at a place in m with its error."""
        slope = self.slope_at(output, position)
        value = float(np.interp(position, self.position, self.values[output]))
        return Measured(value, float(np.sqrt(slope @ self.covariance @ slope)))

    def shares(self, output: str, position: float) -> dict[str, float]:
        """Return the parts of an output's variance that bat and each of the ball's sources cause, greatest first."""
        slope, ball = self.slope_at(output, position), np.array(self.of_ball, bool)
        total = max(float(slope @ self.covariance @ slope), 1e-300)
        bat = np.where(ball, 0.0, slope)
        found = {"bat": float(bat @ self.covariance @ bat) / total} if not ball.all() else {}
        for index in np.flatnonzero(ball):
            found[self.sources[index]] = float(slope[index] ** 2 * self.covariance[index, index]) / total
        return dict(sorted(found.items(), key=lambda entry: -entry[1]))

    def draws(self, output: str, *, count: int = DRAWS, seed: int = 1) -> Array:
        """Return an output along the bat for bats and balls that might be meant, shape (count, m); Sobol's sequence.

        Parameters
        ----------
        count : a power of two.
        """
        import scipy.stats

        even = scipy.stats.qmc.Sobol(len(self.sources), seed=seed).random(count)
        normal = scipy.stats.norm.ppf(np.clip(even, 1e-9, 1 - 1e-9))
        values, vectors = np.linalg.eigh(self.covariance)
        off = normal @ (vectors * np.sqrt(np.maximum(values, 0.0))).T
        return np.asarray(self.values[output] + off @ self.slopes[output] + off**2 @ self.bends[output])

    def best_place(self) -> Measured:
        """Return the place of the greatest exit speed in m from the knob end with its error, from draws."""
        curves = self.draws("exit_speed")
        top = np.clip(np.argmax(curves, axis=1), 1, len(self.position) - 2)
        before, here, after = (curves[np.arange(len(curves)), top + shift] for shift in (-1, 0, 1))
        bend = before - 2 * here + after
        shift = np.where(bend < 0, np.clip(0.5 * (before - after) / np.where(bend < 0, bend, -1.0), -1, 1), 0.0)
        places = self.position[top] + shift * (self.position[1] - self.position[0])
        return Measured(float(np.median(places)), float(np.std(places)))


def doubt(
    line: BeamModel,
    conditions: Conditions,
    *,
    known: tuple[Sequence[Unknown], Array] | None = None,
    positions: Array | None = None,
) -> Doubt:
    """Return what the answers about an implement depend on.

    Parameters
    ----------
    line : its beam, as it was analysed.
    conditions : of the hits.
    known : what is not known of the bat and its covariance, as `sweetspot calibrate` left it; None: what the catalogue
        allows for bats of this kind, after the weight, balance point and moment of inertia in its file.
    positions : m from the knob end; None: along the barrel or the face.

    Raises
    ------
    InputError
        when neither the bat nor the ball has a known spread.
    """
    unknowns, bat_covariance = expected_deviations(line.bat) if known is None else known
    ball = {name: size / REACH for name, size in ball_spreads(conditions.ball).items()}
    if not unknowns and not ball:
        raise InputError(f"the catalogue does not say how sure {line.bat.name} and {conditions.ball.name} are")
    places = _barrel(line.bat) if positions is None else positions
    count = len(unknowns)
    sigma = np.concatenate([np.sqrt(np.diag(bat_covariance)), np.array(list(ball.values()))])

    def answers(deviations: Array) -> Array:
        other = line if count == 0 else deviated(line, unknowns, deviations[:count])
        with_ball = ball_off(conditions.ball, dict(zip(ball, deviations[count:].tolist(), strict=True)))
        return _along(other, conditions.replaced(ball=with_ball), places)

    base = answers(np.zeros(len(sigma)))
    moved = [(answers(step), answers(-step)) for step in np.diag(sigma)]
    slopes = np.array([(up - down) / (2 * size) for (up, down), size in zip(moved, sigma, strict=True)])
    bends = np.array([(up + down - 2 * base) / (2 * size**2) for (up, down), size in zip(moved, sigma, strict=True)])
    covariance = np.zeros((len(sigma), len(sigma)))
    covariance[:count, :count] = bat_covariance
    covariance[count:, count:] = np.diag(sigma[count:] ** 2)
    return Doubt(
        sources=(*(one.name for one in unknowns), *(f"ball {name}".replace("_", " ") for name in ball)),
        of_ball=(False,) * count + (True,) * len(ball),
        covariance=covariance,
        position=places,
        values=dict(zip(OUTPUTS, base, strict=True)),
        slopes={name: slopes[:, index] for index, name in enumerate(OUTPUTS)},
        bends={name: bends[:, index] for index, name in enumerate(OUTPUTS)},
    )


def expected_deviations(bat: Implement) -> tuple[tuple[Unknown, ...], Array]:
    """Return what is not known of a bat that was not calibrated, after what its file says was measured.

    Other implements and bats of plies have none: their doubt is not modelled.
    """
    if not isinstance(bat, Bat):
        return (), np.zeros((0, 0))
    measured = bat.as_measured()
    try:
        unknowns = unknowns_of(measured)
    except InputError:
        return (), np.zeros((0, 0))
    given = []
    if measured.mass is not None:
        given.append(Measurement("mass", Measured(measured.mass, WEIGHED * measured.mass)))
    if measured.balance_point is not None:
        given.append(Measurement("balance_point", Measured(measured.balance_point, BALANCED)))
    if measured.moi is not None:
        given.append(Measurement("moi", Measured(measured.moi, HUNG * measured.moi), axis=measured.moi_axis))
    if not given:
        return unknowns, np.diag([one.spread**2 for one in unknowns])
    return unknowns, calibrate(described(measured), unknowns, given).covariance


def difference(first: Doubt, second: Doubt, places: tuple[float, float]) -> Measured:
    """Return by how much the second bat's exit speed at its place is above the first's, hit by the same ball.

    What is not known of the ball is the same for both and mostly cancels; the bats are independent.
    """
    slopes = [one.slope_at("exit_speed", place) for one, place in zip((first, second), places, strict=True)]
    values = [one.at("exit_speed", place).value for one, place in zip((first, second), places, strict=True)]
    bats = [np.where(one.of_ball, 0.0, slope) for one, slope in zip((first, second), slopes, strict=True)]
    variance = sum(float(bat @ one.covariance @ bat) for one, bat in zip((first, second), bats, strict=True))
    balls = [slope[np.array(one.of_ball, bool)] for one, slope in zip((first, second), slopes, strict=True)]
    shared = first.covariance[np.ix_(first.of_ball, first.of_ball)]
    apart = balls[1] - balls[0]
    return Measured(values[1] - values[0], float(np.sqrt(variance + apart @ shared @ apart)))


def _barrel(bat: Implement) -> Array:
    """Return places along what is meant for the ball: the last `REACHED` of a bat, or the face."""
    outline = bat.outline
    if outline is not None:
        return np.linspace(outline.start, outline.end, PLACES)
    return np.linspace(bat.length - REACHED, bat.length, PLACES)


def _along(line: BeamModel, conditions: Conditions, places: Array) -> Array:
    """Return the outputs at places along a bat, shape (outputs, m)."""
    modes = all_modes(line, conditions.ball)
    found = scan(line.bat, body=rigid_body(line), modes=modes, conditions=conditions, positions=places)
    return np.array([getattr(found, name) for name in OUTPUTS])

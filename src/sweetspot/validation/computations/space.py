"""Hits in space: spin off a tee, the bat's give around its axis, and a league's exit speeds against deflection."""

from __future__ import annotations

from functools import cache
from typing import NamedTuple

import numpy as np

from sweetspot import catalog
from sweetspot.collision.closed_form import exit_speed
from sweetspot.collision.hit_in_space import Contact, strike, strikes
from sweetspot.collision.kernel import hits
from sweetspot.collision.oblique_contact import SPHERE, USUAL_FRICTION, Friction
from sweetspot.dynamics.reduction import ReducedBat, reduced_bat
from sweetspot.equipment.bat import Bat
from sweetspot.motion.ball_motion import BallMotion, BallMotions, launch_angles
from sweetspot.motion.swing import SPEED_FROM_TIP, Swing
from sweetspot.motion.swing_path import SwingPath, Swings, path_axes, steep_enough
from sweetspot.numerics.arrays import Array
from sweetspot.units import DEGREE, INCH, MPH, RPM

STILL = BallMotion(np.zeros(3), np.zeros(3), np.zeros(3))


@cache
def _model(bat: str) -> ReducedBat[Bat]:
    return reduced_bat(catalog.bat(bat), ball=catalog.ball())


def tangential_recoil(*, bat: str) -> float:
    """Return r_x = (m alpha / (1 + alpha)) (1/M + b^2/I_cm + R^2/I_roll) of a rigid bat 6 in from the tip."""
    model = _model(bat)
    place = model.bat.length - SPEED_FROM_TIP
    radius = float(model.bat.diameter_at(np.array(place))) / 2
    body = model.body
    give = 1 / body.mass + (place - body.balance_point) ** 2 / body.moi_cm + radius**2 / body.roll_moi
    return catalog.ball().mass * SPHERE / (1 + SPHERE) * give


def tee_spin(*, bat: str, bat_speed: float, launch_angle: float) -> float:
    """Return the backspin of a ball at rest that a level bat sends off at ``launch_angle``."""
    from scipy.optimize import brentq

    model = _model(bat)
    place = model.bat.length - SPEED_FROM_TIP
    swing = Swing(bat_speed=bat_speed, measured_at=place)

    def hit(offset: float) -> BallMotion:
        struck = strike(
            model, ball=catalog.ball(), swing=swing, path=SwingPath(), pitch=STILL, contact=Contact(place, offset)
        )
        assert struck.launched is not None  # a tee hit off the middle of the barrel always leaves
        return struck.launched

    return hit(float(brentq(lambda offset: hit(offset).launch_angle - launch_angle, 0.0, 0.05, xtol=1e-6))).backspin


class LeagueHits(NamedTuple):
    """Fair hits of a simulated league, each field of shape (hits,); angles in rad, spins in rad/s."""

    over_ceiling: Array
    measured_speed: Array
    measured_bat_speed: Array
    deflection: Array
    exit_speed: Array
    launch_angle: Array
    spray: Array
    backspin: Array
    sidespin: Array


def ceiling_ratio(*, bat: str, deflection: float, other_deflection: float) -> float:
    """Return the 98th percentile of exit speed over ceiling between two deflections, relative to 0 to 5 degrees."""
    hits = simulated_league(bat)

    def edge(low: float, high: float) -> float:
        return float(np.percentile(hits.over_ceiling[(hits.deflection >= low) & (hits.deflection < high)], 98))

    return edge(deflection, other_deflection) / edge(0.0, 5 * DEGREE)


def edge_slope(*, bat: str) -> float:
    """Return the growth of the 98th percentile of exit speeds with bat speed, deflections within 20 degrees.

    Measured speeds, in groups of 2 mph from 60 to 80 mph, a straight line through the groups.
    """
    hits, middle, edge = simulated_league(bat), [], []
    straight = np.abs(hits.deflection) < 20 * DEGREE
    for low in range(60, 80, 2):
        group = straight & (np.abs(hits.measured_bat_speed / MPH - low - 1) <= 1)
        middle.append(hits.measured_bat_speed[group].mean())
        edge.append(np.percentile(hits.measured_speed[group], 98))
    return float(np.polyfit(middle, edge, 1)[0])


def edge_over_own_ceiling(*, bat: str) -> float:
    """Return the 98th percentile of exit speed over the best head-on hit of the measured bat speed at 82 mph pitches.

    Measured speeds, bat speeds above 60 mph, deflections within 20 degrees.
    """
    hits = simulated_league(bat)
    chosen = (np.abs(hits.deflection) < 20 * DEGREE) & (hits.measured_bat_speed > 60 * MPH)
    return float(np.percentile(hits.measured_speed[chosen] / own_ceiling(bat, hits.measured_bat_speed[chosen]), 98))


def own_ceiling(bat: str, bat_speed: Array) -> Array:
    """Return the exit speed of the best head-on hit at an 82 mph pitch for bat speeds 6 in from the tip, m/s."""
    model, from_tip = _model(bat), np.linspace(2 * INCH, 10 * INCH, 33)
    places, swings = model.bat.length - from_tip, np.linspace(40, 110, 15) * MPH
    speed = swings[:, None] * places / (model.bat.length - SPEED_FROM_TIP)
    closing = (speed + 82 * MPH).ravel()
    impacts = hits(model.modes, ball=catalog.ball(), position=np.tile(places, len(swings)), closing_speed=closing)
    efficiency = impacts.collision_efficiency.reshape(speed.shape)
    best = exit_speed(efficiency, ball_speed=82 * MPH, bat_speed=speed).max(axis=1)
    return np.asarray(np.interp(bat_speed, swings, best))


def below_edge(*, bat: str, percentile: str) -> float:
    """Return a percentile of exit speeds over their 98th, for balls that leave in line with a 71.5 mph swing.

    Hits are spread normally along the bat, and their mean and spread are those with which the 25th and the 50th
    percentile come out as in the tracked balls; all others follow.
    """
    mean, spread = _places_of_league(bat)
    return float(_percentiles(bat, mean, spread, np.array([float(percentile)]))[0])


TRACKED_QUARTILES = (0.8257, 0.9114)
"""25th and 50th percentile over the 98th, 4824 tracked balls [sure2026]: swings of 65 to 78 mph, 3 +- 10 deg."""


@cache
def _places_of_league(bat: str) -> tuple[float, float]:
    """Return mean and standard deviation of the distance from the tip that give the tracked quartiles, m."""
    from scipy.optimize import least_squares

    def misfit(guess: Array) -> Array:
        return _percentiles(bat, guess[0] * INCH, guess[1] * INCH, np.array([25.0, 50.0])) - TRACKED_QUARTILES

    mean, spread = least_squares(misfit, [7.5, 2.3], diff_step=[0.02, 0.02]).x * INCH
    return float(mean), float(spread)


def _percentiles(bat: str, mean: float, spread: float, wanted: Array) -> Array:
    """Return percentiles over the 98th of what radars see of hits spread along the bat, shape of ``wanted``."""
    from scipy.special import ndtri

    from_tip, speed = _along(bat)
    chance = (np.arange(4000) + 0.5) / 4000
    seen = np.interp(mean + spread * ndtri(chance), from_tip, speed) * (1 + _seen_spread())
    return np.asarray(np.percentile(seen, wanted) / np.percentile(seen, 98))


@cache
def _seen_spread() -> Array:
    """Relative errors of exit speed over ceiling: 1.5 mph of bat speed and 0.5 mph of exit speed, shape (4000,)."""
    return np.random.default_rng(2026).normal(0, np.hypot(1.23 * 1.5 / 107, 0.5 / 107), 4000)


@cache
def _along(bat: str) -> tuple[Array, Array]:
    """Return places from the tip, m, and head-on exit speeds of a 71.5 mph swing at an 82 mph pitch."""
    model, from_tip = _model(bat), np.linspace(0, 18 * INCH, 181)
    places = model.bat.length - from_tip
    swung = 71.5 * MPH * places / (model.bat.length - SPEED_FROM_TIP)
    impacts = hits(model.modes, ball=catalog.ball(), position=places, closing_speed=swung + 82 * MPH)
    return from_tip, exit_speed(impacts.collision_efficiency, ball_speed=82 * MPH, bat_speed=swung)


def league_backspin(*, bat: str, launch_angle: float) -> float:
    """Return the mean backspin of a league's fly balls to center field, from a plane fitted to all of them."""
    return float(_mean_spin(bat)[:, 0] @ [1.0, launch_angle, 0.0])


def league_sidespin(*, bat: str, launch_angle: float) -> float:
    """Return the mean side spin of its fly balls to center field by right-handed batters."""
    return float(_mean_spin(bat)[:, 1] @ [1.0, launch_angle, 0.0])


class SpinSlopes(NamedTuple):
    """Growth of backspin with launch angle and spray angle, and of side spin with the spray angle, rad/s per rad."""

    backspin: float
    backspin_by_spray: float
    sidespin_by_spray: float


def league_spin_slopes(*, bat: str) -> SpinSlopes:
    """Return the change of spin of a league's fly balls with their direction."""
    fit = _mean_spin(bat)
    return SpinSlopes(float(fit[1, 0]), float(fit[2, 0]), float(fit[2, 1]))


@cache
def _mean_spin(bat: str) -> Array:
    """Return constant, slope with launch angle and slope with spray of back and side spin, shape (3, 2).

    Fly balls of right-handed batters: 15 to 40 degrees up, at least 85 mph.
    """
    hits = simulated_league(bat, left_handed=0.0)
    high = (hits.launch_angle > 15 * DEGREE) & (hits.launch_angle < 40 * DEGREE) & (hits.exit_speed > 85 * MPH)
    terms = np.stack([np.ones_like(hits.spray), hits.launch_angle, hits.spray], axis=-1)[high]
    spins = np.stack([hits.backspin, hits.sidespin], axis=-1)[high]
    return np.asarray(np.linalg.lstsq(terms, spins)[0])


@cache
def simulated_league(
    bat: str,
    left_handed: float = 0.4,
    count: int = 60_000,
    seed: int = 2026,
    friction: Friction = USUAL_FRICTION,
    mean_tilt: float = 31.9 * DEGREE,
) -> LeagueHits:
    """Return the fair hits of a simulated league.

    Bat speed, attack angle and tilt have the printed means and spreads [sure2026]. The rest is assumed: pitches of
    82 +- 5 mph at the plate falling by 6.6 +- 1.8 degrees with up to fastball spin, contact 6.5 +- 2 in from the tip
    and 0.2 +- 0.9 in under the ball's centre. Measuring errors of 1.5 mph (bat), 0.5 mph (ball) and 3 degrees
    (attack) are assumed too. The ceiling is 1.23 bat speed + 0.23 x 82 mph, as printed.
    """
    model, draw = _model(bat), np.random.default_rng(seed)
    speed = draw.normal(71.5, 5.3, count).clip(50, 95) * MPH
    attack = draw.normal(8.6, 8.4, count) * DEGREE
    tilt = (mean_tilt / DEGREE + draw.normal(0, 6.7, count)).clip(0, 80) * DEGREE
    direction = draw.normal(0, 12, count) * DEGREE
    axes = path_axes(attack, direction, tilt=steep_enough(tilt, attack), left=draw.random(count) < left_handed)
    pitch, fall = draw.normal(82, 5, count) * MPH, draw.normal(6.6, 1.8, count) * DEGREE
    place = (model.bat.length - draw.normal(6.5, 2.0, count) * INCH).clip(0.3, model.bat.length)
    batted = strikes(
        model,
        ball=catalog.ball(),
        swings=Swings(speed * place / (model.bat.length - SPEED_FROM_TIP), axes),
        pitches=BallMotions(
            velocity=np.stack([0 * pitch, -pitch * np.cos(fall), -pitch * np.sin(fall)], axis=-1),
            spin=np.stack([draw.normal(-1000, 1200, count), 0 * pitch, draw.normal(0, 900, count)], axis=-1) * RPM,
        ),
        contact=Contact(place, draw.normal(0.2, 0.9, count) * INCH),
        friction=friction,
    )
    launch, spray, (back, side, _) = launch_angles(batted.velocity, batted.spin)
    seen = batted.exit_speed + draw.normal(0, 0.5, count) * MPH
    seen_bat = speed + draw.normal(0, 1.5, count) * MPH
    ceiling = 1.23 * seen_bat + 0.23 * 82 * MPH
    deflection = launch - attack - draw.normal(0, 3, count) * DEGREE
    fair = np.isfinite(batted.exit_speed) & (np.abs(spray) < 45 * DEGREE)
    every = (seen / ceiling, seen, seen_bat, deflection, batted.exit_speed, launch, spray, back, side)
    return LeagueHits(*(value[fair] for value in every))

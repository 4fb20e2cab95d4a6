"""Hits with many bats, balls and swings that may be meant."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import asdict, dataclass, replace
from functools import cached_property

import numpy as np

from sweetspot.analysis.bat_analysis import Analysis
from sweetspot.analysis.position_scan import stings
from sweetspot.collision.closed_form import (
    collision_efficiency,
    exit_speed,
    free_restitutions,
    restitution_from_efficiency,
)
from sweetspot.collision.impact import Impact, Impacts
from sweetspot.collision.kernel import STEP, struck
from sweetspot.collision.time_step import contact_step
from sweetspot.dynamics.beam import BeamModel
from sweetspot.dynamics.patch import contact_patch
from sweetspot.dynamics.reduction import all_modes
from sweetspot.equipment.ball import Ball
from sweetspot.equipment.implement import Implement
from sweetspot.equipment.paddle import Paddle
from sweetspot.motion.swing import Conditions
from sweetspot.numerics.arrays import Array
from sweetspot.numerics.constants import STANDARD_AXIS
from sweetspot.plausibility.table import MAX_SPEED
from sweetspot.uncertainty.bat_draws import DrawnBats, drawn_bats
from sweetspot.uncertainty.drawn_paddles import draw_paddles
from sweetspot.uncertainty.sources import PATCH, PITCH, SWING, Sources, one_by_one
from sweetspot.uncertainty.worth_measuring import Narrowing, narrowings

SLOWEST = 0.1
"""m/s that a drawn bat is swung at least."""


@dataclass(frozen=True)
class Draws:
    """What may be meant: the first is everything as described.

    ``normal``: standard normal numbers behind every draw, shape (draws, n); the first row is 0. ``patch``: factor on
    the radius of the patch beside that of each ball, shape (draws,). ``bat_speed``, ``pitch_speed``: m/s, where the
    swing is measured and of the ball, shape (draws,).
    """

    sources: Sources
    normal: Array
    beam: BeamModel
    conditions: Conditions
    bats: DrawnBats
    balls: tuple[Ball, ...]
    patch: Array
    bat_speed: Array
    pitch_speed: Array

    def __len__(self) -> int:
        return len(self.normal)

    def moi(self, axis: float) -> Array:
        """Return moments of inertia about an axis in m from the knob end, kg m^2, shape (draws,)."""
        return self.bats.bending.moi(axis)

    def swung(self, faster: Array) -> Draws:
        """Return the same draws swung ``faster`` times as fast, shape (draws,)."""
        speed = np.clip(self.bat_speed[0] * faster, SLOWEST, MAX_SPEED)
        return replace(self, bat_speed=speed)

    @cached_property
    def ball_mass(self) -> Array:
        """Of every ball in kg, shape (draws,)."""
        return np.array([ball.mass for ball in self.balls])

    def struck(self, position: Array, closing_speed: Array, *, keep_motion: bool = False) -> Impacts:
        """Return hits, every array shaped (draws, places).

        ``position``, ``closing_speed``: m from the knob end and m/s, broadcast together to (draws, places).
        """
        shape = np.broadcast_shapes(position.shape, closing_speed.shape, (len(self), 1))
        places, speeds = (np.ascontiguousarray(np.broadcast_to(values, shape)) for values in (position, closing_speed))
        return struck(
            self.bats, ball=self.balls, position=places, closing_speed=speeds, keep_motion=keep_motion, step=self._step
        )

    @cached_property
    def _step(self) -> float:
        """Time step in s: a light face needs shorter ones than a bat's barrel."""
        if self.beam.bat.face is None:
            return STEP
        return contact_step(all_modes(self.beam, self.conditions.ball), self.conditions.ball, longest=STEP)


def draws_of(
    beam: BeamModel, conditions: Conditions, sources: Sources, *, count: int, seed: int = 1, normal: Array | None = None
) -> Draws:
    """Return draws of what is not known, after one of everything as described.

    ``count``: a power of two. ``normal``: standard normal numbers to draw by, shape (count, n); None: Sobol's sequence.
    """
    drawn = sources.normal(count, seed=seed) if normal is None else normal
    normal = np.concatenate([np.zeros((1, len(sources.names))), drawn])
    off = sources.deviations(normal)
    off[0] = 0.0
    ball = conditions.ball
    balls = sources.balls(ball, off)
    swung, thrown = conditions.swing.bat_speed + sources.of(SWING, off), conditions.pitch.speed + sources.of(PITCH, off)
    of_bat = normal[:, : len(sources.doubt.behind)]
    if isinstance(beam.bat, Paddle) and sources.doubt.unknowns:
        drawn_ones = draw_paddles(beam, sources.doubt, of_bat)
    else:
        drawn_ones = drawn_bats(beam, sources.doubt, of_bat, ball=ball)
    patch = np.exp(sources.of(PATCH, off))
    radii = patch * np.array([contact_patch(kind) for kind in balls]) / contact_patch(ball)
    # a patch goes as v^(1 / (n + 1)): another radius at this speed is that of another speed
    pressing = (radii ** (ball.exponent + 1))[:, None]
    drawn_ones = replace(drawn_ones, pressing=pressing)
    swung, thrown = np.clip(swung, SLOWEST, MAX_SPEED), np.clip(thrown, 0.0, MAX_SPEED)
    return Draws(sources, normal, beam, conditions, drawn_ones, balls, patch, swung, thrown)


OF_HITS = (*("collision_efficiency", "contact_time", "peak_force", "peak_compression", "displacement", "velocity"),)
"""What `HitsAlong` has of the hits as they are."""


@dataclass(frozen=True)
class HitsAlong:
    """Hits of every draw at the same places; arrays have shape (draws, places), SI; see `Scan`."""

    position: Array
    closing_speed: Array
    collision_efficiency: Array
    bbcor: Array
    exit_speed: Array
    rigid_exit_speed: Array
    bat_speed: Array
    hand_impulse: Array
    sting: Array
    contact_time: Array
    peak_force: Array
    peak_compression: Array
    displacement: Array
    velocity: Array


def hits_along(draws: Draws, places: Array) -> HitsAlong:
    """Return hits of every draw at places in m from the knob end, shape (m,)."""
    conditions, body = draws.conditions, draws.bats.bending
    swing, hands = conditions.swing, conditions.hands
    turning = draws.bat_speed / (swing.measured_at - swing.pivot)
    bat = turning[:, None] * (places - swing.pivot)
    thrown, mass = draws.pitch_speed[:, None], draws.ball_mass[:, None]
    closing = thrown + bat
    outcome = draws.struck(places[None, :], closing, keep_motion=True)
    efficiency = outcome.collision_efficiency
    recoil = mass * (places - STANDARD_AXIS) ** 2 / body.moi(STANDARD_AXIS)[:, None]
    held = 1 - (body.mass * (body.balance_point - hands.position) / body.moi(hands.position))[:, None] * (
        places - hands.position
    )
    rigid = _rigid(draws, places, closing)
    return HitsAlong(
        position=places,
        closing_speed=closing,
        bbcor=restitution_from_efficiency(efficiency, recoil=recoil),
        exit_speed=exit_speed(efficiency, ball_speed=0.0, bat_speed=closing) - thrown,  # seen by the flying ball
        rigid_exit_speed=exit_speed(rigid, ball_speed=0.0, bat_speed=closing) - thrown,
        bat_speed=bat,
        hand_impulse=held * mass * closing * (1 + efficiency),
        sting=stings(draws.bats, outcome, hands=hands),
        **{name: getattr(outcome, name) for name in OF_HITS},
    )


def _rigid(draws: Draws, places: Array, closing: Array) -> Array:
    """Return q of bats without any vibration, shape (draws, places); see `rigid_efficiency`."""
    body = draws.bats.bending
    inverse_mass = 1 / body.mass[:, None] + (places - body.balance_point[:, None]) ** 2 / body.moi_cm[:, None]
    recoil = draws.ball_mass[:, None] * inverse_mass
    restitution = free_restitutions(draws.balls, closing_speed=np.maximum(closing, 1e-9), recoil=recoil)
    return np.asarray(np.where(closing > 0, collision_efficiency(restitution, recoil=recoil), np.nan))


KINDS = ("translation", "rotation", "bending", "hoop", "face")
"""Parts of the ledger that are motion of the implement."""


def drawn_ledger(
    draws: Draws, along: HitsAlong, column: int, impact: Impact
) -> tuple[dict[str, Array], dict[str, Array]]:
    """Return the parts of the energy of one hit in J, and as parts of it, by the fields of `EnergyLedger`.

    Motion at release is each draw's own. What the implement's damping takes during contact, a thousandth, goes as its
    vibration; the rest is heat in the ball, which makes the sum right.
    """
    closing = along.closing_speed[:, column]
    incoming = draws.ball_mass * closing**2 / 2
    parts = {"ball": along.collision_efficiency[:, column] ** 2 * incoming, **_motions(draws, along, column)}
    energies = asdict(impact.energy)
    ringing = parts["bending"] + parts["hoop"] + parts["face"]
    parts["damping"] = energies["damping"] * ringing / ringing[0] if ringing[0] > 0 else np.zeros(len(draws))
    parts["heat"] = incoming - sum(parts.values(), np.zeros(len(draws)))
    joules, shares = {}, {}
    for name, energy in parts.items():
        share = energy / incoming
        joules[name] = energies[name] + energy - energy[0]
        shares[name] = energies[name] / max(energies["incoming"], 1e-300) + share - share[0]
    return joules, shares


def _motions(draws: Draws, along: HitsAlong, column: int) -> dict[str, Array]:
    """Return the energy of every family of motions at release, J, shape (draws,)."""
    bats = draws.bats
    velocity, displacement = along.velocity[:, column], along.displacement[:, column]
    each = (velocity**2 + (bats.angular_frequency * displacement) ** 2) / 2
    bending = bats.bending.omega.shape[1]
    families = ("rigid", "rigid", *["bending"] * bending, *["hoop"] * (each.shape[1] - 2 - bending))
    if bats.whole is not None:
        families = bats.whole.families
    rigid = iter(KINDS)
    kinds = [next(rigid) if family == "rigid" else family for family in families]
    return {
        kind: each[:, [index for index, its_kind in enumerate(kinds) if its_kind == kind]].sum(axis=1) for kind in KINDS
    }


@dataclass(frozen=True)
class SpeedDoubt:
    """What is not known of an exit speed.

    ``error``: one standard deviation, m/s. ``shares``: part of the variance that every source adds, by its name, the
    greatest first. ``narrowings``: what it becomes once more is measured on the implement.
    """

    error: float
    shares: Mapping[str, float]
    narrowings: tuple[Narrowing, ...]


def speed_doubt(analysis: Analysis[Implement], sources: Sources) -> SpeedDoubt | None:
    """Return the uncertainty of the best hit's exit speed; None without a best hit, or without effect of any source.

    The place stays that of the bat as described.
    """
    count = len(sources.names)
    draws = draws_of(analysis.beam, analysis.conditions, sources, count=2 * count, normal=one_by_one(count))
    hit = hits_along(draws, np.array([analysis.sweet_spots.max_exit_speed]))
    if not np.isfinite(hit.exit_speed).all():
        return None
    up, down = hit.exit_speed[1:].reshape(2, count)
    variances = dict.fromkeys(sources.names, 0.0)
    slopes = (up - down) / 2
    for name, half in zip(sources.names, slopes.tolist(), strict=True):
        variances[name] += half**2
    whole = sum(variances.values())
    if not whole > 0:
        return None
    ranked = sorted(variances.items(), key=lambda variance: -variance[1])
    behind = dict(zip(sources.doubt.behind, slopes.tolist(), strict=False))
    others = float(np.linalg.norm(slopes[len(behind) :]))
    narrower = narrowings([(analysis.bat, sources.doubt)], behind, others=others)
    return SpeedDoubt(whole**0.5, {name: part / whole for name, part in ranked}, narrower)

"""One collision: how fast the ball leaves, how hard and how long it is pressed, and where the energy goes."""

from __future__ import annotations

from dataclasses import asdict, dataclass, field
from typing import Annotated

import numpy as np

from sweetspot.analysis.bat_analysis import TYPICAL_HAND, check_conditions, exit_speed_of, hit_at
from sweetspot.analysis.strain import Damage, breaking_speed, damage
from sweetspot.answers.answer import Answer, DrawnAnswer, Uncertainty, with_draws
from sweetspot.answers.conditions import MassProperties, mass_columns, mass_properties
from sweetspot.answers.handling import direction
from sweetspot.answers.records import (
    INTERNAL,
    Angle,
    Columns,
    Force,
    Length,
    Mass,
    Ratio,
    Speed,
    Spin,
    Time,
)
from sweetspot.answers.setups import SwungWith
from sweetspot.collision.closed_form import bbcor
from sweetspot.collision.hit_in_space import Strikes
from sweetspot.collision.impact import Impact, Impacts, Outcome
from sweetspot.dynamics.beam import BeamModel
from sweetspot.dynamics.modes import Modes
from sweetspot.dynamics.reduction import ReducedBat, reduced_bat
from sweetspot.dynamics.rigid import RigidBody
from sweetspot.equipment.ball import Ball
from sweetspot.equipment.bat import Bat
from sweetspot.equipment.implement import Implement
from sweetspot.motion.swing import Conditions
from sweetspot.numerics.arrays import Array
from sweetspot.numerics.interval import REACH, Number
from sweetspot.uncertainty.drawn_hits import Draws, HitsAlong, drawn_ledger, draws_of, hits_along
from sweetspot.uncertainty.sources import DRAWS, Sources, errors_by_ball
from sweetspot.units.dimensions import ENERGY, FORCE, LENGTH, TIME

OF_DRAWS = (
    "exit_speed",
    "collision_efficiency",
    "bbcor",
    "bat_speed",
    "contact_time",
    "peak_force",
    "peak_compression",
)  # of both `Hit` and `HitsAlong`
"""Fields of a hit that draws answer as they are."""


@dataclass(frozen=True)
class Energies:
    """Where the energy of a hit goes; see `EnergyLedger`."""

    incoming: Number
    ball: Number
    heat: Number
    translation: Number
    rotation: Number
    bending: Number
    hoop: Number
    damping: Number
    face: Number


@dataclass(frozen=True)
class HitHistory:
    """Force and compression during contact, shape (steps,)."""

    time: Annotated[Array, TIME]
    force: Annotated[Array, FORCE]
    compression: Annotated[Array, LENGTH]


@dataclass(frozen=True, kw_only=True)
class CollisionNumbers:
    """Quantities of any collision, also of one in a batch.

    ``position``, ``lateral``: from the knob end and beside the line. ``outcome``, ``outcome_text``: how it ended, for
    programs and for people.
    """

    position: Length
    lateral: Length
    outcome: str
    outcome_text: str
    closing_speed: Speed
    collision_efficiency: Ratio
    contact_time: Time
    peak_force: Force
    peak_compression: Length


@dataclass(frozen=True, kw_only=True)
class Collision(CollisionNumbers):
    """One collision as the implement at rest sees it; see `Impact`.

    ``energy``, ``energy_share``: parts of the energy, and as parts of what comes in. ``energy_imbalance``: what the
    parts miss of the whole, an error of the time steps. ``unrecovered_gain``: how much faster a ball leaves that has
    not recovered when it is touched again; None: it is not. ``first_touch_efficiency``: q by the first touch alone;
    None: the ball is pressed once.
    """

    release_time: Time
    energy: Annotated[Energies, ENERGY]
    energy_share: Energies
    energy_imbalance: float
    history: HitHistory
    unrecovered_gain: Speed | None = None
    first_touch_efficiency: Ratio | None = None


def collision_numbers(impact: Impact) -> CollisionNumbers:
    """Return the quantities of every collision."""
    return CollisionNumbers(
        position=impact.position,
        lateral=impact.lateral,
        outcome=impact.outcome.name.lower(),
        outcome_text=impact.outcome.sentence,
        closing_speed=impact.closing_speed,
        collision_efficiency=impact.collision_efficiency,
        contact_time=impact.contact_time,
        peak_force=impact.peak_force,
        peak_compression=impact.peak_compression,
    )


def numbers_in_batch(
    hits: Impacts | Strikes, *, position: float, closing_speed: float, lateral: float = 0.0
) -> CollisionNumbers:
    """Return the answer to the first hit of a batch."""
    outcome = Outcome(int(hits.outcome[0]))
    return CollisionNumbers(
        position=position,
        lateral=lateral,
        outcome=outcome.name.lower(),
        outcome_text=outcome.sentence,
        closing_speed=closing_speed,
        collision_efficiency=float(hits.collision_efficiency[0]),
        contact_time=float(hits.contact_time[0]),
        peak_force=float(hits.peak_force[0]),
        peak_compression=float(hits.peak_compression[0]),
    )


def collision_of(impact: Impact) -> Collision:
    """Return a collision without the swing that led to it."""
    energy, incoming = asdict(impact.energy), impact.energy.incoming
    return Collision(
        **vars(collision_numbers(impact)),
        release_time=impact.release_time,
        energy=Energies(**energy),
        energy_share=Energies(**{name: part / incoming if incoming else 0.0 for name, part in energy.items()}),
        energy_imbalance=impact.energy.imbalance,
        history=HitHistory(impact.times, impact.force, impact.compression),
        unrecovered_gain=None if impact.unrecovered is None else impact.unrecovered_gain,
        first_touch_efficiency=impact.first_touch_efficiency,
    )


@dataclass(frozen=True, kw_only=True)
class Hit(Collision):
    """One collision under its conditions.

    ``bat_speed``: at the place of the hit, before it. ``smash_factor``: exit speed over bat speed; None where the bat
    stands. ``exit_speed_unrecovered``: of a ball that has not recovered when it is touched again; None: it is touched
    once.
    """

    bat_speed: Speed
    exit_speed: Speed
    bbcor: Ratio
    smash_factor: Ratio | None
    exit_speed_unrecovered: Speed | None = None


def hit_of(impact: Impact, *, body: RigidBody, conditions: Conditions) -> Hit:
    """Return a collision with what bat and ball did before and after it."""
    leaves, swung = exit_speed_of(impact, conditions), conditions.swing.speed_at(impact.position)
    again = impact.unrecovered
    return Hit(
        **vars(collision_of(impact)),
        bat_speed=swung,
        exit_speed=leaves,
        bbcor=bbcor(impact.collision_efficiency, body=body, ball=conditions.ball, position=impact.position),
        smash_factor=leaves / swung if swung else None,
        exit_speed_unrecovered=None if again is None else exit_speed_of(again, conditions),
    )


def hit_columns(draws: Draws, along: HitsAlong, place: int, impact: Impact) -> Columns:
    """Return the sampled answers at one of the places hit, by the fields of `Hit`.

    ``along``: hits of every draw. ``place``: number of the place. ``impact``: the hit as described, from which the
    draws' energies count.
    """
    columns: dict[str, Array] = {name: getattr(along, name)[:, place] for name in OF_DRAWS}
    with np.errstate(divide="ignore", invalid="ignore"):
        columns["smash_factor"] = columns["exit_speed"] / columns["bat_speed"]
    energy, share = drawn_ledger(draws, along, place, impact)
    return {**columns, "energy": energy, "energy_share": share}


@dataclass(frozen=True)
class Strains:
    """Greatest strains of one hit as ratios; see `Damage`.

    ``least_breaking_speed``, ``most_breaking_speed``: closing speeds between which a hit there breaks the wood of the
    handle; see `sweetspot.analysis.strain.breaking_speed`.
    """

    handle_strain: Ratio
    handle_position: Length
    handle_strain_limit: float | None
    wall_strain: Ratio | None
    wall_strain_limit: float | None
    warnings: tuple[str, ...]
    least_breaking_speed: Speed | None = None
    most_breaking_speed: Speed | None = None


def strains_of(strains: Damage, breaking: tuple[float, float] | None = None) -> Strains:
    """Return the strains of a hit, and the speeds at which it would break the bat, as people ask for them."""
    low, high = breaking or (None, None)
    return Strains(
        handle_strain=strains.handle_strain,
        handle_position=strains.handle_position,
        handle_strain_limit=strains.strain_limit,
        wall_strain=strains.wall_strain,
        wall_strain_limit=strains.wall_limit,
        warnings=strains.warnings,
        least_breaking_speed=low,
        most_breaking_speed=high,
    )


@dataclass(frozen=True)
class HitQuestion:
    """One collision that is asked for.

    ``position``, ``lateral``: m from the knob end and beside the line of a face. ``sources``: what is not known, for an
    interval beside every number; None: only what the ball leaves to the exit speed. ``draws``: how many answers the
    intervals come from, a power of two.
    """

    implement: Implement
    conditions: Conditions
    position: float
    lateral: float = 0.0
    sources: Sources | None = None
    draws: int = field(default=DRAWS, kw_only=True)


@dataclass(frozen=True, kw_only=True)
class HitAnswer(Hit, Answer):
    """One collision with what was put in.

    Parameters
    ----------
    bat : what it weighs and how it balances.
    damage : None for what is no bat.
    aside, gear_spin : of a hit beside the line of a face, see `HitBeside`; None on the line.
    exit_speed_in_hands : the same hit with typical hands on the handle, whose mass and flesh are assumed; the other
        numbers are of an implement that no hands hold. None: hands are part of the question.
    exit_speed_half_by_ball : half of the interval in which the exit speeds of single balls of a kind scatter; None: not
        known, or part of the interval that stands there.
    exit_speed_half_by_kind : the same for what is not known of all of them alike, their mean and their law.
    uncertainty : what the intervals come from; None: there are none.
    """

    question: Annotated[HitQuestion, INTERNAL]
    impact: Annotated[Impact, INTERNAL]
    body: Annotated[RigidBody, INTERNAL]
    bat: MassProperties
    ball_mass: Mass
    damage: Strains | None = None
    aside: Angle | None = None
    gear_spin: Spin | None = None
    exit_speed_in_hands: Speed | None = None
    exit_speed_half_by_ball: Speed | None = None
    exit_speed_half_by_kind: Speed | None = None
    uncertainty: Uncertainty | None = None
    swung_with: SwungWith | None = None


def _strains(impact: Impact, beam: BeamModel, modes: Modes, ball: Ball) -> Strains | None:
    if not isinstance(beam.bat, Bat):
        return None
    strains, breaking = damage(impact, beam=beam, modes=modes), None
    if impact.closing_speed > 0:
        breaking = breaking_speed(impact, strains, beam=beam, modes=modes, ball=ball)
    return strains_of(strains, breaking)


def hit_answer(question: HitQuestion) -> HitAnswer:
    """Return one collision.

    Raises
    ------
    InputError
        for a place that is not on the implement, or a swing that does not go with it.
    """
    implement, conditions, position = question.implement, question.conditions, question.position
    implement.check_position(position, "position")
    implement.check_on_face(position, "position")
    implement.check_lateral(position, question.lateral)
    reduced = reduced_bat(implement, ball=conditions.ball)
    check_conditions(reduced, conditions)
    beam, body, modes = reduced.beam, reduced.body, reduced.modes
    impact = hit_at(position, modes=modes, conditions=conditions, lateral=question.lateral)
    way = direction(implement, body, impact, conditions)
    errors = None
    if question.sources is None:  # which have the ball among them
        errors = errors_by_ball(reduced, conditions, position)
    plain = HitAnswer(
        **vars(hit_of(impact, body=body, conditions=conditions)),
        question=question,
        impact=impact,
        body=body,
        bat=mass_properties(implement, body),
        ball_mass=conditions.ball.mass,
        aside=None if way is None else way.aside,
        gear_spin=None if way is None else way.gear_spin,
        exit_speed_in_hands=_in_hands(question, reduced),
        damage=_strains(impact, beam, modes, conditions.ball),
        exit_speed_half_by_ball=None if errors is None else REACH * errors.scatter,
        exit_speed_half_by_kind=None if errors is None else REACH * errors.common,
    )
    if question.sources is None:
        return plain
    draws = draws_of(beam, conditions, question.sources, count=question.draws)
    along = hits_along(draws, np.array([position]))
    columns = {
        **hit_columns(draws, along, 0, impact),
        "bat": mass_columns(draws),
        "ball_mass": draws.ball_mass,
    }
    return with_draws(plain, DrawnAnswer(draws.normal, columns), question.sources, of="exit_speed")


def _in_hands(question: HitQuestion, reduced: ReducedBat[Implement]) -> float | None:
    """Return the exit speed in m/s with typical hands on the handle; None where the question has hands of its own."""
    conditions = question.conditions
    if conditions.hands.mass:
        return None
    held = reduced.held(conditions.hands.replaced(**TYPICAL_HAND))
    impact = hit_at(question.position, modes=held.modes, conditions=conditions, lateral=question.lateral)
    return exit_speed_of(impact, conditions)

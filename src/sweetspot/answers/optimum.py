"""The best way to hit: how to swing at a pitch, how high to send a ball, and where a park is easiest to leave."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import lru_cache
from typing import Annotated

import numpy as np

from sweetspot.analysis.optimum import (
    NOTHING_HELD,
    BestSwing,
    EasiestHomeRun,
    Held,
    best_launch,
    best_swing,
    easiest_home_run,
)
from sweetspot.answers.answer import Answer, DrawnAnswer, Uncertainty, with_draws
from sweetspot.answers.flight import DRAG, dragged, draws_of_sources, flight_columns
from sweetspot.answers.play import PlayQuestion, drawn_play
from sweetspot.answers.records import INTERNAL, Angle, Columns, Distance, Length, Speed, Spin, Time
from sweetspot.answers.setups import SwungWith
from sweetspot.collision.hit_in_space import Contact
from sweetspot.dynamics.reduction import ReducedBat
from sweetspot.equipment.bat import Bat
from sweetspot.flight.conditions import FlightConditions
from sweetspot.flight.park import Park
from sweetspot.flight.pitch import PitchFlight
from sweetspot.motion.ball_motion import USUAL_CONTACT, BallMotion, BallMotions, batted_ball
from sweetspot.motion.swing import Conditions
from sweetspot.motion.swing_path import SwingPath, SwingPlane
from sweetspot.numerics.arrays import Array
from sweetspot.uncertainty.sources import DRAWS, Sources


@dataclass(frozen=True)
class SwingSearch:
    """The contact that carries farthest is searched for each of these pitches; see `best_swing`.

    ``reduced``: the bat, with what the hands do to it. ``tilt``: of the swing's plane, rad. ``held``: place and attack
    angle that are not searched.
    """

    reduced: ReducedBat[Bat]
    conditions: Conditions
    flying: FlightConditions
    pitches: tuple[PitchFlight, ...]
    tilt: float
    held: Held = NOTHING_HELD

    def best(self, pitch: PitchFlight) -> BestSwing:
        """Return the contact with one pitch that carries farthest."""
        return best_swing(
            self.reduced,
            self.flying,
            swing=self.conditions.swing,
            pitch=pitch.plate,
            plane=SwingPlane(tilt=self.tilt),
            held=self.held,
        )

    def play(self, best: BestSwing, pitch: PitchFlight) -> PlayQuestion:
        """Return the best contact with one pitch as a play."""
        return PlayQuestion(
            self.reduced,
            self.conditions,
            self.flying,
            path=SwingPath(attack_angle=best.attack_angle, tilt=max(self.tilt, abs(best.attack_angle))),
            pitch=pitch.plate,
            contact=Contact(best.position, best.offset),
        )


@dataclass(frozen=True)
class LaunchSearch:
    """The launch angle that carries farthest is searched for each exit speed (m/s) and a backspin (rad/s)."""

    flying: FlightConditions
    exit_speeds: tuple[float, ...]
    backspin: float


@dataclass(frozen=True)
class ParkSearch:
    """The slowest home run is searched in each park, with what is flown through there, and a backspin (rad/s)."""

    parks: tuple[tuple[Park, FlightConditions], ...]
    backspin: float


@dataclass(frozen=True)
class OptimumQuestion:
    """What is asked about the best way to hit; None: not asked.

    ``sources``: what is not known, of the hit and of the drag; None: no intervals are asked for. ``draws``: how many
    answers the intervals come from, a power of two.
    """

    bat: Bat
    swing: SwingSearch | None = None
    launch: LaunchSearch | None = None
    park: ParkSearch | None = None
    sources: Sources | None = None
    draws: int = DRAWS


@dataclass(frozen=True, kw_only=True)
class FarthestSwing:
    """The contact with a pitch that carries farthest; see `BestSwing`. What was searched has no interval."""

    pitch: str
    release_speed: Speed
    pitch_speed: Speed
    attack_angle: Angle
    offset: Length
    undercut: Length
    position: Length
    exit_speed: Speed
    launch_angle: Angle
    spray: Angle
    backspin: Spin
    sidespin: Spin
    carry: Distance
    hang_time: Time


@dataclass(frozen=True)
class FarthestLaunch:
    """The launch angle that carries farthest."""

    exit_speed: Speed
    backspin: Spin
    launch_angle: Angle
    carry: Distance


@dataclass(frozen=True, kw_only=True)
class SlowestHomeRun:
    """The slowest home run of a park; see `EasiestHomeRun`."""

    park: str
    team: str
    elevation: Distance
    exit_speed: Speed
    launch_angle: Angle
    direction: Angle
    fence_distance: Distance
    fence_height: Distance


@dataclass(frozen=True, kw_only=True)
class OptimumAnswer(Answer):
    """The best way to hit; None: not asked for.

    Parameters
    ----------
    swings : the best contact with each pitch.
    parks : the slowest home run of each park, the easiest to leave first.
    uncertainty : what the intervals come from; None: there are none.
    """

    question: Annotated[OptimumQuestion, INTERNAL]
    bat: str
    swings: tuple[FarthestSwing, ...] | None = None
    launches: tuple[FarthestLaunch, ...] | None = None
    parks: tuple[SlowestHomeRun, ...] | None = None
    uncertainty: Uncertainty | None = None
    swung_with: SwungWith | None = None


def optimum_answer(question: OptimumQuestion) -> OptimumAnswer:
    """Return the best way to hit.

    Raises
    ------
    InputError
        where no contact makes the ball fly, or no ball leaves a park.
    """
    swing, launch, park = question.swing, question.launch, question.park
    swings = [] if swing is None else [(swing.best(pitch), pitch) for pitch in swing.pitches]
    launches = (
        []
        if launch is None
        else [
            FarthestLaunch(speed, launch.backspin, best.launch_angle, best.carry)
            for speed in launch.exit_speeds
            for best in [best_launch(speed, launch.flying, backspin=launch.backspin)]
        ]
    )
    parks = () if park is None else _easiest(park)
    plain = OptimumAnswer(
        question=question,
        bat=question.bat.name,
        swings=None if swing is None else tuple(_farthest(*found) for found in swings),
        launches=None if launch is None else tuple(launches),
        parks=None if park is None else tuple(_slowest(found.best) for found in parks),
    )
    if question.sources is None:
        return plain
    drawn, main = drawn_optimum(
        question.sources,
        swings=[] if swing is None else [swing.play(*found) for found in swings],
        launches=[] if launch is None else [(_ball(found), launch.flying) for found in launches],
        parks=parks,
        backspin=0.0 if park is None else park.backspin,
        count=question.draws,
    )
    return with_draws(plain, drawn, question.sources, of=main)


@lru_cache(maxsize=32)
def _easiest(search: ParkSearch) -> tuple[AskedPark, ...]:
    """Return the slowest home runs, the slowest first; no bat makes a difference to them."""
    found = [AskedPark(easiest_home_run(park, here, backspin=search.backspin), here) for park, here in search.parks]
    return tuple(sorted(found, key=lambda park: park.best.exit_speed))


def _ball(found: FarthestLaunch) -> BallMotion:
    return batted_ball(
        speed=float(found.exit_speed),
        launch_angle=float(found.launch_angle),
        backspin=float(found.backspin),
        position=USUAL_CONTACT,
    )


def _farthest(best: BestSwing, pitch: PitchFlight) -> FarthestSwing:
    left = best.launched
    return FarthestSwing(
        pitch=pitch.delivery.name,
        release_speed=pitch.delivery.speed,
        pitch_speed=pitch.plate.speed,
        attack_angle=best.attack_angle,
        offset=best.offset,
        undercut=best.undercut,
        position=best.position,
        exit_speed=left.speed,
        launch_angle=left.launch_angle,
        spray=left.spray,
        backspin=left.backspin,
        sidespin=left.sidespin,
        carry=best.carry,
        hang_time=best.hang_time,
    )


def _slowest(best: EasiestHomeRun) -> SlowestHomeRun:
    return SlowestHomeRun(
        park=best.park.name,
        team=best.park.team,
        elevation=best.park.elevation,
        exit_speed=best.exit_speed,
        launch_angle=best.launch_angle,
        direction=best.direction,
        fence_distance=best.distance,
        fence_height=best.height,
    )


OF_PLAY = ("exit_speed", "launch_angle", "spray", "backspin", "sidespin", "pitch_speed", "carry", "hang_time")
"""Fields of a best swing that draws of its play answer."""


@dataclass(frozen=True)
class AskedPark:
    """The slowest home run of a park as described, and what it flies through."""

    best: EasiestHomeRun
    conditions: FlightConditions


def drawn_optimum(
    sources: Sources,
    *,
    swings: Sequence[PlayQuestion] = (),
    launches: Sequence[tuple[BallMotion, FlightConditions]] = (),
    parks: Sequence[AskedPark] = (),
    backspin: float = 0.0,
    count: int,
) -> tuple[DrawnAnswer, str]:
    """Return the sampled answers about the best way to hit, and the first number that was asked for.

    Parameters
    ----------
    sources : of the hit, and `drag_source`.
    swings : the best contact with every pitch.
    launches : balls as they leave best, and what they fly through.
    parks, backspin : slowest home runs, and with which spin they fly, rad/s.
    """
    normal, off = draws_of_sources(sources, count)
    drag = sources.of(DRAG, off)
    plays = [drawn_play(replace(asked, draws=count), sources) for asked in swings]
    of_swings = [{name: _of_play(play.columns, name) for name in OF_PLAY} for play in plays]
    flown = [flight_columns(_alike(left, len(off)), flying, drag) for left, flying in launches]
    of_launches = [{"carry": flight["carry"]} for flight in flown]
    of_parks = [{"exit_speed": _drawn_slowest(park, drag, backspin)} for park in parks]
    rows = {"swings": of_swings, "launches": of_launches, "parks": of_parks}
    columns = {name: row for name, row in rows.items() if row}
    first, name = next((row[0], name) for name, row in columns.items())
    number = "carry" if "carry" in first else "exit_speed"
    return DrawnAnswer(normal, columns), f"{name}.0.{number}"


def _of_play(columns: Columns, name: str) -> Array:
    flight = columns["flight"]
    column = flight[name] if isinstance(flight, Mapping) and name in flight else columns[name]
    return np.asarray(column)


def _alike(left: BallMotion, count: int) -> BallMotions:
    """Return a ball many times."""
    velocity = np.tile(np.asarray(left.velocity), (count, 1))
    return BallMotions(velocity=velocity, spin=np.asarray(left.spin), position=np.asarray(left.position))


def _drawn_slowest(park: AskedPark, drag: Array, backspin: float) -> Array:
    """Return the exit speed of the slowest home run over the fence that asks least, for every drag."""
    size, where = float(np.std(drag)), [park.best.direction]
    up, down = (
        easiest_home_run(
            park.best.park, dragged(park.conditions, sign * size), backspin=backspin, directions=where
        ).exit_speed
        for sign in (1.0, -1.0)
    )
    return np.asarray(park.best.exit_speed + drag / size * (up - down) / 2)

"""Curves of the explorer for hits all along a bat: met in the middle, or at an offset from the bat's axis."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, fields, replace
from functools import cache, lru_cache
from typing import Annotated

import numpy as np
from numpy.typing import ArrayLike

from sweetspot.analysis.bat_analysis import check_conditions, hit_at
from sweetspot.analysis.position_scan import Scan, energy_shares, scan, sting
from sweetspot.analysis.sweet_spot import SweetSpots, sweet_spots
from sweetspot.answers.records import GAPS, GRID
from sweetspot.collision.closed_form import bbcor, exit_speed
from sweetspot.collision.hit_in_space import Contact, Strikes, strikes
from sweetspot.collision.impact import Impacts
from sweetspot.collision.kernel import hits, hits_with_motion
from sweetspot.dynamics.reduction import ReducedBat
from sweetspot.dynamics.rigid import hand_impulse_ratio
from sweetspot.motion.ball_motion import BallMotions
from sweetspot.motion.swing import Conditions
from sweetspot.motion.swing_path import SwingPath, Swings
from sweetspot.numerics.arrays import Array
from sweetspot.references import cite, reference
from sweetspot.reports.hit.document import best_in_doubt, touched_again_between
from sweetspot.reports.sentences import Sentence, Slot, joined, say
from sweetspot.reports.sport_words import words_of
from sweetspot.units import INCH
from sweetspot.units.dimensions import ANGLE, IMPULSE, LENGTH, SPEED, VIBRATION, System
from sweetspot.validation.cases import Row, sources
from sweetspot.web.bats import ball_of, conditions_of, reduced
from sweetspot.web.controls import BatState, HitState, part_of
from sweetspot.web.documents import Sentences, in_both_systems, in_either_system
from sweetspot.web.recipes import is_catalogued

KEPT = 128
MIDDLE = {"impact_from_tip_in": 6.0, "offset_in": 0.0}
BESIDE = 3 * INCH
"""m from the best place within which a ball that is touched twice makes the best hit doubtful."""
ALONG, ABOVE = 49, 25
"""Places of the map along the barrel and above its axis."""
BARREL, EDGE = 18 * INCH, 0.98
"""m from the tip that the map shows; part of the greatest offset at which the bat still touches the ball."""


@dataclass(frozen=True, kw_only=True)
class CurvesOfHits:
    """Hits at every place along a bat, shape (n,), of a ball met so far off its axis; nan where nothing is known."""

    position: Annotated[Array, LENGTH]
    exit_speed: Annotated[Array, SPEED, GAPS]
    rigid_exit_speed: Annotated[Array, SPEED, GAPS]
    launch_angle: Annotated[Array | None, ANGLE, GAPS] = None
    collision_efficiency: Annotated[Array, GAPS]
    bbcor: Annotated[Array, GAPS]
    hand_impulse: Annotated[Array, IMPULSE, GAPS]
    sting: Annotated[Array, VIBRATION, GAPS]


@dataclass(frozen=True)
class HitsAlongBat:
    """The curves, parts of the energy, and where the ball is touched again."""

    curves: CurvesOfHits
    shares: Mapping[str, Array]
    touched_again: Sentences


@dataclass(frozen=True)
class PowerMap:
    """Exit speeds over the barrel and over how far off its axis the ball is met; nan: it is fouled back."""

    position: Annotated[Array, LENGTH]
    offset: Annotated[Array, LENGTH]
    exit_speed: Annotated[Array, SPEED, GRID, GAPS]


@dataclass(frozen=True)
class Met:
    """A bat and its swing, hit all along by a ball in the middle."""

    reduced: ReducedBat
    conditions: Conditions
    scan: Scan
    spots: SweetSpots
    doubts: list[Sentence]


def along(state: HitState) -> Met:
    """Return the hits all along a state's bat; where the ball is makes no difference."""
    return _along(part_of(state, HitState, **MIDDLE))


def curves(state: HitState) -> HitsAlongBat:
    """Return the curves along the bat at a state's offset, and where on the barrel the ball is touched again."""
    return _curves(part_of(state, HitState, impact_from_tip_in=6.0))


def struck(setup: Met, *, position: ArrayLike, offset: ArrayLike) -> Strikes:
    """Return hits by a level swing of a ball that comes level without spin; m from the knob end and off the axis."""
    swing, place = setup.conditions.swing, np.asarray(position, float)
    return strikes(
        setup.reduced,
        ball=setup.conditions.ball,
        swings=Swings(swing.angular_speed * (place - swing.pivot), SwingPath().axes, swing.pivot),
        pitches=BallMotions(velocity=(0.0, -setup.conditions.pitch.speed, 0.0), spin=(0.0, 0.0, 0.0)),
        contact=Contact(place, offset),
    )


def leaving(strikes: Strikes) -> tuple[Array, Array, Array]:
    """Return speed, launch angle from straight ahead (beyond a right angle: backwards) and backspin of struck balls."""
    out, up = strikes.velocity[:, 1], strikes.velocity[:, 2]
    angle = np.where(np.isfinite(out), np.arctan2(up, out), np.nan)
    return strikes.exit_speed, angle, strikes.spin[:, 0]


def power_map(state: HitState) -> PowerMap:
    """Return exit speeds over the barrel and over how far off its axis the ball is met; null: it is fouled back."""
    return _power_map(part_of(state, HitState, **MIDDLE))


def head_on(setup: Met, place: float) -> tuple[Impacts, float]:
    """Return the collision of a ball met in the middle, m from the knob end, and its exit speed, m/s."""
    conditions = setup.conditions
    bat_speed = conditions.swing.speed_at(place)
    closing = conditions.pitch.speed + bat_speed
    hit = hits(setup.reduced.modes, ball=conditions.ball, position=place, closing_speed=closing)
    efficiency = float(hit.collision_efficiency[0])
    return hit, exit_speed(efficiency, ball_speed=conditions.pitch.speed, bat_speed=bat_speed)


@lru_cache(maxsize=KEPT)
def _along(state: HitState) -> Met:
    model = reduced(state, ball_of(state))
    conditions = conditions_of(state, model.bat)
    check_conditions(model, conditions)
    scanned = scan(model, conditions)
    spots = sweet_spots(scanned, body=model.body, modes=model.modes, conditions=conditions)
    return Met(model, conditions, scanned, spots, _doubts(model, conditions, scanned, spots.max_exit_speed))


def touched_twice(scanned: Scan, place: float, *, within: float) -> bool:
    """Return whether a ball is touched twice so near to a place, both in m."""
    return bool(np.any(scanned.touches[np.abs(scanned.position - place) < within] > 1))


def _doubts(model: ReducedBat, conditions: Conditions, scanned: Scan, best: float) -> list[Sentence]:
    """Return the doubts about the best hit; computed, by a hit of its own, where balls beside it are touched twice."""
    if not touched_twice(scanned, best, within=BESIDE):
        return []
    return best_in_doubt(hit_at(best, modes=model.modes, conditions=conditions), words_of(model.bat.sport))


@lru_cache(maxsize=KEPT)
def _curves(state: HitState) -> HitsAlongBat:
    setup = along(state)
    scanned, angle = _scanned(state, setup, setup.scan)
    from_tip = setup.reduced.bat.length - scanned.position
    barrel = from_tip <= BARREL
    again = touched_again_between(from_tip[barrel], scanned.touches[barrel], words_of(setup.reduced.bat.sport))
    shares: dict[str, Array] = {
        name: part.round(5) for name, part in scanned.energy._asdict().items() if np.nanmax(part) > 0
    }
    names = [field.name for field in fields(CurvesOfHits) if hasattr(scanned, field.name)]
    values: dict[str, Array] = {name: getattr(scanned, name) for name in names}
    return HitsAlongBat(CurvesOfHits(**values, launch_angle=angle), shares, in_both_systems(again))


def _scanned(state: HitState, setup: Met, middle: Scan) -> tuple[Scan, Array | None]:
    """Return a scan of a ball met as far off the bat's axis as is asked, from one met on it, and its launch angles."""
    if state.offset_in == 0:
        return middle, None
    position, modes, ball = middle.position, setup.reduced.modes, setup.conditions.ball
    off = struck(setup, position=position, offset=state.offset_in * INCH)
    closing = np.nan_to_num(off.closing_speed)
    again = hits_with_motion(modes, ball=ball, position=position, closing_speed=closing)
    speed, angle, _ = leaving(off)
    efficiency, body, hands = off.collision_efficiency, setup.reduced.body, setup.conditions.hands
    ratio = hand_impulse_ratio(body, position, hands=hands.position)
    felt = sting(modes, hands=hands, displacement=again.displacement, velocity=again.velocity)
    changed = replace(
        middle,
        exit_speed=speed,
        rigid_exit_speed=np.full(len(position), math.nan),
        collision_efficiency=efficiency,
        bbcor=bbcor(efficiency, body=body, ball=ball, position=position),
        hand_impulse=ratio * ball.mass * closing * (1 + efficiency),
        sting=np.where(np.isfinite(efficiency), felt, np.nan),
        energy=energy_shares(again, modes=modes, ball=ball, closing_speed=closing),
        touches=off.touches,
    )
    return changed, angle


def beside(scanned: Scan, place: float) -> slice:
    """Return the slice of a scan's hits that are the neighbours of a place in m from the knob end."""
    beyond = int(np.searchsorted(scanned.position, place))
    return slice(max(0, beyond - 1), beyond + 1)


def jumps_at(setup: Met, place: float) -> bool:
    """Return whether values jump next to a place, m from the knob end: where a ball begins to be touched twice."""
    return bool(np.any(setup.scan.touches[beside(setup.scan, place)] > 1))


def scans_at(state: HitState, place: float) -> tuple[Scan, Scan]:
    """Return scans of one place: of a ball met in the middle, and of one met as far off the axis as is asked."""
    setup = along(state)
    middle = scan(setup.reduced, setup.conditions, np.array([place]))
    return middle, _scanned(state, setup, middle)[0]


@lru_cache(maxsize=KEPT)
def _power_map(state: HitState) -> PowerMap:
    setup = along(state)
    bat, ball = setup.reduced.bat, setup.conditions.ball
    position = np.linspace(max(bat.length - BARREL, setup.scan.position[0]), bat.length, ALONG)
    reach = EDGE * (ball.radius + float(np.max(bat.diameter_at(position))) / 2)
    offset = np.linspace(-reach, reach, ABOVE)
    places, above = np.meshgrid(position, offset)
    speed, angle, _ = leaving(struck(setup, position=places.ravel(), offset=above.ravel()))
    speed = np.where(np.abs(angle) < math.pi / 2, speed, np.nan).reshape(places.shape)
    return PowerMap(position, offset, np.round(speed, 3))


UNITS = {"in": INCH, "cm": 0.01}
PLACES = {"best_efficiency_from_tip": "collision_efficiency", "node_from_tip": "sting_m_s"}
"""Computations of places on a bat, and the curve beside which such a place is drawn."""
VALUES = {"whole_efficiency": "collision_efficiency"}
"""Computations of a curve's greatest value, whose place was not published."""


@dataclass(frozen=True)
class Publication:
    """One published number of a bat.

    Parameters
    ----------
    curve : beside which it is drawn.
    words, source : what it is and who published it, and where.
    place : the stretch of the bat of which it tells, from the knob end.
    values : ends of a curve's greatest value, whose place was not published.
    """

    curve: str
    words: Mapping[System, str]
    source: str
    place: Annotated[tuple[float, float], LENGTH]
    values: tuple[float, float] | None


def published(state: BatState, *, length: float, most_efficient: float) -> tuple[Publication, ...]:
    """Return the publications about a state's bat, as long as nothing of it was changed.

    Parameters
    ----------
    length, most_efficient : m; of the bat, and to the place of its greatest collision efficiency, from the knob end.
    """
    marks = _of_bat(state.bat, length) if is_catalogued(state) else ()
    return tuple(replace(mark, place=(most_efficient, most_efficient)) if mark.values else mark for mark in marks)


@cache
def _of_bat(name: str, length: float) -> tuple[Publication, ...]:
    """Return the publications about a bat of the catalogue; a value whose place was not published lies anywhere."""
    rows = [(row, case) for case in sources() for row in case.rows if row.inputs.get("bat") == name]
    marks = (_mark(row, case.source, name, length) for row, case in rows)
    return tuple(mark for mark in marks if mark is not None)


def _mark(row: Row, key: str, name: str, length: float) -> Publication | None:
    low, high = (row.value if end is None else end for end in (row.low, row.high))
    assert low is not None and high is not None
    source = reference(key)
    by = f"{source.authors.split(',')[0]} {source.fields.get('year', '')}".strip()
    about = f"{by}: {row.quantity.partition(',')[0].removesuffix(f' of {name}')}"
    if row.computation in PLACES and row.unit in UNITS:
        near, far = UNITS[row.unit] * low, UNITS[row.unit] * high
        words = say("{about}: {place} from the tip", about=about, place=_span(near, far, "place"))
        return Publication(
            PLACES[row.computation], in_either_system(words), cite(key), (length - far, length - near), None
        )
    if row.computation in VALUES:
        words = say("{about}: {value}", about=about, value=_span(*row.allowed, "ratio"))
        return Publication(VALUES[row.computation], in_either_system(words), cite(key), (0.0, length), row.allowed)
    return None


def _span(low: float, high: float, scale: str) -> Sentence:
    ends = [say("{end}", end=Slot(end, scale)) for end in ((low, high) if low < high else (low,))]
    return joined(ends, " to ")

"""What the explorer shows of hits all along a bat: met in the middle, or so far off the bat's axis."""

from __future__ import annotations

import math
from dataclasses import asdict, dataclass
from functools import lru_cache
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from sweetspot.analysis.bat_analysis import check_conditions, hit_at
from sweetspot.analysis.position_scan import Scan, energy_shares, scan, sting
from sweetspot.analysis.sweet_spot import SweetSpots, sweet_spots
from sweetspot.collision.closed_form import bbcor
from sweetspot.collision.hit_in_space import Contact, Strikes, strikes
from sweetspot.collision.kernel import hits_with_motion
from sweetspot.dynamics.reduction import ReducedBat
from sweetspot.dynamics.rigid import hand_impulse_ratio
from sweetspot.motion.ball_motion import BallMotions
from sweetspot.motion.swing import Conditions
from sweetspot.motion.swing_path import SwingPath, Swings
from sweetspot.numerics.arrays import Array
from sweetspot.report.hit.second_touch import best_in_doubt, touched_again_between
from sweetspot.report.sentences import Sentence
from sweetspot.report.sport_words import words_of
from sweetspot.units import INCH
from sweetspot.web.bats import ball_of, conditions_of, reduced
from sweetspot.web.documents import in_both_systems
from sweetspot.web.states import HitState

KEPT = 128
BESIDE = 3 * INCH
"""m from the best place within which a ball that is touched twice makes the best hit doubtful."""
ALONG, ABOVE = 49, 25
"""Places of the map along the barrel and above its axis."""
BARREL, EDGE = 18 * INCH, 0.98
"""m from the tip that the map shows; part of the greatest offset at which the bat still touches the ball."""


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
    return _along(HitState.model_construct(**{**_shared(state), "impact_from_tip_in": 6.0, "offset_in": 0.0}))


def curves(state: HitState) -> dict[str, Any]:
    """Return the curves along the bat at a state's offset, and where on the barrel the ball is touched again."""
    return _curves(HitState.model_construct(**{**_shared(state), "impact_from_tip_in": 6.0}))


def struck(met: Met, *, position: ArrayLike, offset: ArrayLike) -> Strikes:
    """Return hits by a level swing of a ball that comes level without spin; m from the knob end and off the axis."""
    swing, place = met.conditions.swing, np.asarray(position, float)
    return strikes(
        met.reduced,
        ball=met.conditions.ball,
        swings=Swings(swing.angular_speed * (place - swing.pivot), SwingPath().axes, swing.pivot),
        pitches=BallMotions(velocity=(0.0, -met.conditions.pitch.speed, 0.0), spin=(0.0, 0.0, 0.0)),
        contact=Contact(place, offset),
    )


def leaving(done: Strikes) -> tuple[Array, Array, Array]:
    """Return speed, launch angle from straight ahead (beyond a right angle: backwards) and backspin of struck balls."""
    out, up = done.velocity[:, 1], done.velocity[:, 2]
    angle = np.where(np.isfinite(out), np.arctan2(up, out), np.nan)
    return done.exit_speed, angle, done.spin[:, 0]


def power_map(state: HitState) -> dict[str, Any]:
    """Return exit speeds over the barrel and over how far off its axis the ball is met; null: it is fouled back."""
    return _power_map(HitState.model_construct(**{**_shared(state), "impact_from_tip_in": 6.0, "offset_in": 0.0}))


def _shared(state: HitState) -> dict[str, Any]:
    return {name: getattr(state, name) for name in HitState.model_fields}


@lru_cache(maxsize=KEPT)
def _along(state: HitState) -> Met:
    model = reduced(state, ball_of(state))
    conditions = conditions_of(state, model.bat)
    check_conditions(model.bat, conditions, body=model.body)
    scanned = scan(model.bat, body=model.body, modes=model.modes, conditions=conditions)
    spots = sweet_spots(scanned, body=model.body, modes=model.modes, conditions=conditions)
    return Met(model, conditions, scanned, spots, _doubts(model, conditions, scanned, spots.max_exit_speed))


def touched_twice(scanned: Scan, place: float, *, within: float) -> bool:
    """Return whether a ball is touched twice so near to a place, both in m."""
    return bool(np.any(scanned.touches[np.abs(scanned.position - place) < within] > 1))


def _doubts(model: ReducedBat, conditions: Conditions, scanned: Scan, best: float) -> list[Sentence]:
    """Return what is not known of the best hit; asked, by a hit of its own, where balls beside it are touched twice."""
    if not touched_twice(scanned, best, within=BESIDE):
        return []
    return best_in_doubt(hit_at(best, modes=model.modes, conditions=conditions), words_of(model.bat))


@lru_cache(maxsize=KEPT)
def _curves(state: HitState) -> dict[str, Any]:
    met = along(state)
    return _listed(_scanned(state, met, met.scan), met)


def _scanned(state: HitState, met: Met, middle: Scan) -> dict[str, Any]:
    """Return a scan's values of a ball met as far off the bat's axis as is asked; ``middle`` is of one met on it."""
    if state.offset_in == 0:
        return asdict(middle)
    position, modes, ball = middle.position, met.reduced.modes, met.conditions.ball
    done = struck(met, position=position, offset=state.offset_in * INCH)
    closing = np.nan_to_num(done.closing_speed)
    again = hits_with_motion(modes, ball=ball, position=position, closing_speed=closing)
    speed, angle, _ = leaving(done)
    efficiency, body, hands = done.collision_efficiency, met.reduced.body, met.conditions.hands
    ratio = hand_impulse_ratio(body, position, hands=hands.position)
    return {
        **asdict(middle),
        "exit_speed": speed,
        "rigid_exit_speed": np.full(len(position), math.nan),
        "launch_angle": angle,
        "collision_efficiency": efficiency,
        "bbcor": bbcor(efficiency, body=body, ball=ball, position=position),
        "hand_impulse": ratio * ball.mass * closing * (1 + efficiency),
        "sting": np.where(
            np.isfinite(efficiency),
            sting(modes, hands=hands, displacement=again.displacement, velocity=again.velocity),
            np.nan,
        ),
        "energy": energy_shares(again, modes=modes, ball=ball, closing_speed=closing),
        "touches": done.touches,
    }


def beside(scanned: Scan, place: float) -> slice:
    """Return which hits of a scan are the neighbours of a place in m from the knob end."""
    beyond = int(np.searchsorted(scanned.position, place))
    return slice(max(0, beyond - 1), beyond + 1)


def here(state: HitState, place: float) -> tuple[float | None, dict[str, Any]]:
    """Return how fast a ball met in the middle leaves a place, m from the knob end, and what curves do not tell there.

    Where a ball begins to be touched twice values jump, and lie between those of the neighbours nowhere; elsewhere
    they do, and nothing is worked out anew.
    """
    met = along(state)
    if not np.any(met.scan.touches[beside(met.scan, place)] > 1):
        return None, {}
    middle = scan(
        met.reduced.bat, body=met.reduced.body, modes=met.reduced.modes, conditions=met.conditions,
        positions=np.array([place]),
    )  # fmt: skip
    found = _scanned(state, met, middle)
    return float(middle.exit_speed[0]), {
        "hand_impulse_n_s": found["hand_impulse"][0],
        "sting_m_s": found["sting"][0],
        "energy_shares": {name: round(float(part[0]), 5) for name, part in found["energy"]._asdict().items()},
    }


def _listed(scanned: dict[str, Any], met: Met) -> dict[str, Any]:
    bat, from_tip = met.reduced.bat, met.reduced.bat.length - scanned["position"]
    shown = from_tip <= BARREL
    again = touched_again_between(from_tip[shown], scanned["touches"][shown], words_of(bat))
    names = {
        "position": "position_m", "exit_speed": "exit_speed_m_s", "rigid_exit_speed": "rigid_exit_speed_m_s",
        "launch_angle": "launch_angle_rad", "collision_efficiency": "collision_efficiency", "bbcor": "bbcor",
        "hand_impulse": "hand_impulse_n_s", "sting": "sting_m_s",
    }  # fmt: skip
    shares = {name: np.round(part, 5) for name, part in scanned["energy"]._asdict().items() if np.nanmax(part) > 0}
    curves = {key: scanned[name] for name, key in names.items() if name in scanned}
    return {"curves": curves, "energy": shares, "touched_again": in_both_systems(again)}


@lru_cache(maxsize=KEPT)
def _power_map(state: HitState) -> dict[str, Any]:
    met = along(state)
    bat, ball = met.reduced.bat, met.conditions.ball
    position = np.linspace(max(bat.length - BARREL, met.scan.position[0]), bat.length, ALONG)
    reach = EDGE * (ball.radius + float(np.max(bat.diameter_at(position))) / 2)
    offset = np.linspace(-reach, reach, ABOVE)
    places, above = np.meshgrid(position, offset)
    done = struck(met, position=places.ravel(), offset=above.ravel())
    speed, angle, _ = leaving(done)
    speed = np.where(np.abs(angle) < math.pi / 2, speed, np.nan).reshape(places.shape)
    return {"position_m": position, "offset_m": offset, "exit_speed_m_s": np.round(speed, 3)}

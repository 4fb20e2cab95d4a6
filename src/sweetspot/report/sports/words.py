"""The answer in plain words for other sports than baseball: the same findings in the sport's own words and units."""

from __future__ import annotations

import numpy as np

from sweetspot.analysis.bat_analysis import Analysis, exit_speed_of
from sweetspot.analysis.miss_cost import Loss, miss_costs
from sweetspot.analysis.sweet_spot import ZONE_LOSS
from sweetspot.dynamics.rigid import effective_mass
from sweetspot.equipment.implement import Implement
from sweetspot.paper.sports import dead_spot
from sweetspot.report.sports.vocabulary import Speech, speech

MISSES = (0.02, 0.04, 0.06)
"""m."""
WHY_TWO = (
    "In brackets: what a ball that loses its energy by how fast it is pressed, not by how far, allows as well; no "
    "measurement has settled that."
)
FOLLOWS = 0.005
"""Below minus this q is called negative."""


def sport_answer(analysis: Analysis[Implement]) -> list[str]:
    """Return the answer as a few paragraphs; every number that was assumed and not measured is said to be so."""
    said = speech(analysis.bat.sport)
    paragraphs = [_where(analysis, said), _bounce(analysis, said), _tip(analysis, said), _miss(analysis, said)]
    return [text for text in (*paragraphs, _hands(analysis, said), _assumed(analysis, said)) if text]


def _from_tip(analysis: Analysis[Implement], position: float) -> float:
    return analysis.bat.length - position


def _where(analysis: Analysis[Implement], said: Speech) -> str:
    words, spots, best = said.words, analysis.sweet_spots, analysis.best
    leaves = exit_speed_of(best, analysis.conditions)
    place = said.place(_from_tip(analysis, spots.max_exit_speed))
    text = (
        f"This {words.implement} hits best {place} from the {words.tip}: {_arriving(analysis, said)} leaves at "
        f"{said.speed(leaves)}. Its {words.efficiency} is {best.collision_efficiency:.2f} there."
    )
    if words.smash_factor:
        swung = analysis.conditions.swing.speed_at(best.position)
        text += f" Its {words.smash_factor}, {words.exit_speed} over {words.implement} speed, is {leaves / swung:.2f}."
    if spots.zone is None:
        return f"{text} No stretch is both fast and quiet: there is no {words.zone} by our measure."
    outer, inner = (said.place(_from_tip(analysis, end)) for end in spots.zone[::-1])
    return (
        f"{text} The {words.zone}, within {said.speed(ZONE_LOSS)} of that and with less than half the mean vibration "
        f"at the hands, reaches from {outer} to {inner} from the {words.tip}."
    )


def _arriving(analysis: Analysis[Implement], said: Speech) -> str:
    speed = analysis.conditions.pitch.speed
    return f"a {said.words.incoming} that comes at {said.speed(speed)}" if speed else f"a {said.words.incoming} at rest"


def _bounce(analysis: Analysis[Implement], said: Speech) -> str:
    """Return where a ball comes back best and worst, where the sport has words for it, and what a negative q means."""
    words, scan = said.words, analysis.scan
    parts = []
    if words.strongest:
        place = said.place(_from_tip(analysis, analysis.sweet_spots.max_collision_efficiency))
        most = float(np.nanmax(scan.collision_efficiency))
        parts.append(
            f"The {words.strongest} is {place} from the {words.tip}, where a {words.implement} at rest gives back "
            f"{100 * most:.0f} % of the speed."
        )
    dead = dead_spot(analysis)
    if words.deadest and dead is not None:
        place, mass = said.place(_from_tip(analysis, dead)), effective_mass(analysis.body, dead)
        parts.append(
            f"The {words.deadest} is {place} from the {words.tip}: a {words.incoming} there does not come back, for "
            f"its {1e3 * analysis.conditions.ball.mass:.0f} g meet only {1e3 * mass:.0f} g, and vibration takes more."
        )
    if analysis.best.collision_efficiency < -FOLLOWS:
        parts.append(
            f"The {words.efficiency} is negative: the {words.incoming} leaves slower than the {words.implement} came, "
            "and follows it."
        )
    return " ".join(parts)


def _tip(analysis: Analysis[Implement], said: Speech) -> str:
    words, scan, body = said.words, analysis.scan, analysis.body
    best, last = analysis.sweet_spots.max_exit_speed, float(scan.position[-1])
    top, end, rigid = exit_speed_of(analysis.best, analysis.conditions), scan.exit_speed[-1], scan.rigid_exit_speed[-1]
    swing = analysis.conditions.swing
    gain = swing.speed_at(last) - swing.speed_at(best)
    if not gain > 0 or not top > end:
        return ""
    here, there = 1e3 * effective_mass(body, best), 1e3 * effective_mass(body, last)
    face = analysis.bat.face
    springy = face is not None and face.stiffness is not None
    stiff = "" if springy else f"a rigid {words.implement} would send it off at {said.speed(rigid)}, "
    return (
        f"Why not at the {words.tip}? The last place to be hit moves {said.speed(gain)} faster, but there only "
        f"{there:.0f} g stand behind the {words.incoming} instead of {here:.0f} g: {stiff}this one sends it off at "
        f"{said.speed(end)}, {said.speed(top - end)} less than at its best."
    )


def _miss(analysis: Analysis[Implement], said: Speech) -> str:
    words, scan = said.words, analysis.scan
    best = analysis.sweet_spots.max_exit_speed
    costs = []
    hittable = tuple(miss for miss in MISSES if best - miss >= scan.position[0])
    for miss, (inside, outside) in zip(hittable, miss_costs(analysis, hittable) if hittable else [], strict=True):
        outer = "off it" if np.isnan(outside.value) else _spanned(outside, said)
        costs.append(f"{said.place(miss)}: {_spanned(inside, said)} towards the hands, {outer} towards the {words.tip}")
    return f"What a miss costs: {'; '.join(costs)}. {WHY_TWO}" if costs else ""


def _spanned(loss: Loss, said: Speech) -> str:
    return f"{said.speed(loss.value)} ({said.speed(loss.low)} to {said.speed(loss.high)})"


def _hands(analysis: Analysis[Implement], said: Speech) -> str:
    words, spots = said.words, analysis.sweet_spots

    def place(position: float) -> str:
        return said.place(_from_tip(analysis, position))

    return (
        f"The hands feel least vibration from a hit {place(spots.min_sting)} from the {words.tip}; a hit at the node "
        f"of the first bending mode, {place(spots.node_1)}, does not excite it; one at the centre of percussion, "
        f"{place(spots.center_of_percussion)}, does not jolt the hand. Typical hands change the {words.exit_speed} by "
        f"{100 * analysis.grip_effect:+.1f} %."
    )


def _assumed(analysis: Analysis[Implement], said: Speech) -> str:
    """Return which of the conditions are soft defaults of the sport, marked as they are everywhere."""
    stroke, conditions = said.sport.stroke, analysis.conditions
    used = ((stroke.swing_speed, conditions.swing.bat_speed), (stroke.ball_speed, conditions.pitch.speed))
    soft = [f"{one.name} {one.marked}" for one, value in used if one.kind == "assumed" and one.value == value]
    return f"Soft defaults: {'; '.join(soft)}." if soft else ""

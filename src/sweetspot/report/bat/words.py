"""The answer in plain words: where this bat hits best, why there and not at the end, what a miss costs."""

from __future__ import annotations

import math

import numpy as np

from sweetspot.analysis.bat_analysis import Analysis, exit_speed_of
from sweetspot.analysis.miss_cost import Loss, miss_costs
from sweetspot.dynamics.rigid import effective_mass
from sweetspot.equipment.implement import Implement
from sweetspot.report.sports.vocabulary import speaks_otherwise
from sweetspot.report.sports.words import WHY_TWO, sport_answer
from sweetspot.units import INCH, MPH, OUNCE

SMALL = 1e-3
MISSES = (1, 2, 3)
"""Inches."""


def answer(analysis: Analysis[Implement]) -> list[str]:
    """Return the answer as a few paragraphs, in the units that players and makers use."""
    if speaks_otherwise(analysis.bat):
        return sport_answer(analysis)
    words = [_where(analysis), _why_not_the_end(analysis), _miss(analysis), _hands(analysis)]
    if hoop := analysis.modes.of_family("hoop"):
        lowest = analysis.modes.frequency[hoop].min()
        words.append(
            f"This bat is hollow: its wall gives way and springs back. It rings at {lowest:.0f} Hz (lowest hoop mode); "
            "the lower that is, the more of the ball's lost energy the wall saves."
        )
    return words


def from_tip(analysis: Analysis[Implement], position: float) -> float:
    """Return a position's distance from the tip in inches."""
    return (analysis.bat.length - position) / INCH


def told_with_doubt(value: float, doubt: float) -> str:
    """Return a number with its standard deviation, both to two digits of that; alone where there is none."""
    if doubt <= 0:
        return f"{value:,.0f}"
    digits = 1 - math.floor(math.log10(doubt))
    return " ± ".join(f"{round(one, digits):,.{max(digits, 0)}f}" for one in (value, doubt))


def _where(analysis: Analysis[Implement]) -> str:
    spots = analysis.sweet_spots
    best = from_tip(analysis, spots.max_exit_speed)
    speed = exit_speed_of(analysis.best, analysis.conditions) / MPH
    text = f"This bat hits best {best:.1f} in from the tip: the ball leaves at {speed:.1f} mph"
    text += f" from a {analysis.conditions.pitch.speed / MPH:.0f} mph pitch."
    if spots.zone is None:
        return text + " No stretch of the barrel is both fast and quiet: there is no sweet zone by our measure."
    outer, inner = from_tip(analysis, spots.zone[1]), from_tip(analysis, spots.zone[0])
    return (
        f"{text} The sweet zone, within 3 mph of that and with less than half the mean vibration at the hands, "
        f"reaches from {outer:.1f} to {inner:.1f} in from the tip, {inner - outer:.1f} in wide."
    )


def _why_not_the_end(analysis: Analysis[Implement]) -> str:
    scan, body = analysis.scan, analysis.body
    best, tip = analysis.sweet_spots.max_exit_speed, analysis.bat.length
    speed_gain = (analysis.conditions.swing.speed_at(tip) - analysis.conditions.swing.speed_at(best)) / MPH
    here, there = effective_mass(body, best) / OUNCE, effective_mass(body, tip) / OUNCE
    rigid, real = scan.rigid_exit_speed[-1] / MPH, scan.exit_speed[-1] / MPH
    top = exit_speed_of(analysis.best, analysis.conditions) / MPH
    return (
        f"Why not the end? The tip moves {speed_gain:.0f} mph faster, but there the bat gives way by turning: the ball "
        f"meets only {there:.0f} oz of bat instead of {here:.0f} oz. A rigid bat would send it off the tip at "
        f"{rigid:.0f} mph. A real bat also bends and keeps that energy as vibration: {real:.0f} mph, "
        f"{top - real:.0f} mph less than at its best."
    )


def _miss(analysis: Analysis[Implement]) -> str:
    def cost(inches: int, inside: Loss, outside: Loss) -> str:
        outer = "off the bat" if np.isnan(outside.value) else in_mph(outside)
        return f"{inches} in: {in_mph(inside)} towards the hands, {outer} towards the tip"

    costs = miss_costs(analysis, tuple(inches * INCH for inches in MISSES))
    told = "; ".join(cost(inches, *both) for inches, both in zip(MISSES, costs, strict=True))
    return f"What a miss costs: {told}. {WHY_TWO}"


def in_mph(loss: Loss) -> str:
    """Return a cost and its interval in words."""
    return f"{loss.value / MPH:.1f} mph ({loss.low / MPH:.1f} to {loss.high / MPH:.1f})"


def _hands(analysis: Analysis[Implement]) -> str:
    spots = analysis.sweet_spots
    quiet, percussion = from_tip(analysis, spots.min_sting), from_tip(analysis, spots.center_of_percussion)
    return (
        f"The hands feel least vibration from a hit {quiet:.1f} in from the tip, between the nodes of the first "
        f"({from_tip(analysis, spots.node_1):.1f} in) and second ({from_tip(analysis, spots.node_2):.1f} in) bending "
        f"mode, and no jolt at the top hand from one at the centre of percussion, {percussion:.1f} in. How the bat is "
        f"held hardly matters to the ball: {_grip(analysis.grip_effect)}."
    )


def _grip(effect: float) -> str:
    if abs(effect) < SMALL:
        return f"typical hands change its speed by less than {100 * SMALL:g} %"
    return f"typical hands change its speed by {100 * effect:+.1f} %"

"""Claims of the paper without an equation: lighter bats, livelier balls, farther hits, no air."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

from sweetspot import catalog
from sweetspot.analysis.bat_analysis import Analysis, analyse, exit_speed_of
from sweetspot.analysis.comparison import speed_ratios
from sweetspot.dynamics.beam import beam_model
from sweetspot.dynamics.rigid import rigid_body
from sweetspot.equipment.implement import Implement
from sweetspot.flight.air import VACUUM, Air
from sweetspot.flight.conditions import FlightConditions
from sweetspot.flight.sweep import BattedBall
from sweetspot.flight.trajectory import fly
from sweetspot.papers.formulas import PaperRow
from sweetspot.papers.metal_wall import METAL_BAT
from sweetspot.papers.words import Number, Words, metres, miles_per_hour
from sweetspot.units import MPH

LAUNCH_ANGLE = math.radians(28)
"""Of a long fly ball; the paper names none."""
LIVELIER = 0.05
"""Of a ball's restitution: more than any two balls of one league differ by."""
STILL = 5e-3
"""m by which a best place may move and still be called the same: a player scatters by ten times as much."""


def hole_lightens(analysis: Analysis[Implement], other: Analysis[Implement]) -> PaperRow:
    """Return the claim that a bat weighs less when it is hollowed, as the other one is."""
    lost = analysis.body.mass - other.body.mass
    return PaperRow(
        "13", "mass of the bat, corked less plain", "g", "less", None, -1e3 * lost,
        "Right, and this, not a softer barrel, is what the hole does to a hit.",
    )  # fmt: skip


def metal_is_swung_faster(analysis: Analysis[Implement]) -> PaperRow:
    """Return the claim that a metal bat, being lighter, is swung faster with the same effort."""
    metal, bat = catalog.bat(METAL_BAT), analysis.bat
    body = rigid_body(beam_model(metal))
    ratio = speed_ratios(catalog.swing_law(), metal, body, bat, analysis.body)
    speed = analysis.conditions.swing.bat_speed
    faster, low, high = (speed * (each - 1) for each in (ratio.value, ratio.low, ratio.high))
    right = "Right in kind" if low > 0 else "Not so for this bat" if high < 0 else "Not decided here"
    return PaperRow(
        "W", "bat speed with the same effort, metal less this bat", "mph", "more", None, faster / MPH,
        Words(
            f"{right}: {{}} to {{}} by the law of {catalog.swing_law().name}. Not the mass counts but how far from "
            f"the hands it sits. The catalogue's {METAL_BAT} weighs {{}}, this bat {{}}.",
            miles_per_hour(low), miles_per_hour(high),
            *(Number(mass, "mass", f"{1e3 * mass:.0f} g") for mass in (body.mass, analysis.body.mass)),
        ),
    )  # fmt: skip


def carries(analysis: Analysis[Implement], *, speeds: Sequence[float]) -> Iterator[PaperRow]:
    """Yield the carries of the balls of the formula for W, without air, as in the paper, and with air.

    Parameters
    ----------
    speeds : with which they leave wood and metal, m/s.
    """
    ball = analysis.conditions.ball
    law = catalog.aerodynamics(catalog.sport(analysis.bat.sport).aerodynamics)

    def carry(speed: float, air: Air) -> float:
        hit = BattedBall(speed, LAUNCH_ANGLE, sidespin=0.0)
        return fly(hit.motion, FlightConditions(ball=ball, aerodynamics=law, air=air)).carry

    bare, real = ([carry(speed, air) for speed in speeds] for air in (VACUUM, Air()))
    yield PaperRow(
        "W", f"carry of that ball off wood, {math.degrees(LAUNCH_ANGLE):.0f}° up", "m", None, bare[0], real[0],
        "Computed: without air, which the paper leaves out. Full model: with it, at sea level.",
    )  # fmt: skip
    yield PaperRow(
        "W", "carry of that ball off metal", "m", "further", bare[1], real[1],
        Words(
            "Right. That leaving out the air hardly matters is not: it takes "
            f"{100 * (1 - real[0] / bare[0]):.0f} % of the carry, and of the {{}} between the two it leaves {{}}.",
            *(metres(farther - near, f"{farther - near:.0f}") for near, farther in (bare, real)),
        ),
    )  # fmt: skip


def livelier_ball(analysis: Analysis[Implement]) -> Iterator[PaperRow]:
    """Yield the cited claims on restitution: it does not move the best point and changes the speed a lot."""
    conditions = analysis.conditions
    ball = conditions.ball.with_restitution(conditions.ball.restitution.reference + LIVELIER)
    other = analyse(analysis.bat, conditions.replaced(ball=ball))
    moved = other.sweet_spots.max_exit_speed - analysis.sweet_spots.max_exit_speed
    gained = exit_speed_of(other.best, conditions) - exit_speed_of(analysis.best, conditions)
    yield PaperRow(
        "cited", f"best point moves towards the end, restitution of the ball + {LIVELIER:g}", "mm", "not at all", None,
        1e3 * moved, "Right." if abs(moved) < STILL else "Not quite: a livelier ball is best met further out.",
    )  # fmt: skip
    what = f"exit speed gains, restitution of the ball + {LIVELIER:g}"
    yield PaperRow("cited", what, "mph", "much", None, gained / MPH, "Right.")

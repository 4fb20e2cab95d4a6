"""Find what the baseball's law must be for each share of rate loss, so that all of them meet the same three tests.

The share s of what a ball loses by the rate of compression is not known (see docs/theory/ball.md). Whatever it is, a
ball pushes with the peak force that was published for a hit, bounces from the rule's wall of ash as the rule says, and
makes the best wood bat just legal. Stiffness, restitution and its slope follow from these for every s and exponent.

Run: PYTHONPATH=src .venv/bin/python tools/anchor_ball.py      (prints rows for balls.toml)
"""

from __future__ import annotations

import numpy as np
from scipy.optimize import fsolve

from sweetspot import all_modes, beam_model, catalog
from sweetspot.analysis.certification.simulated_test import BBCOR_SPEED, bat_test
from sweetspot.analysis.drop_test import fire
from sweetspot.catalog.standard_hit import standard_conditions
from sweetspot.collision.coupled import hit
from sweetspot.collision.impact import Impact
from sweetspot.dynamics.block import Block
from sweetspot.dynamics.rigid import rigid_body
from sweetspot.equipment.ball import Ball, damping_from_share
from sweetspot.units import INCH, MPH

PEAK_FORCE = 36.5e3
"""N, in the standard hit at 6 in: more than 8,000 lb, 35.6 kN [nathan_slides], 37 kN [russell_impulse]."""
ASH, ASH_SPEED = 0.546, 85 * 12 * INCH
"""Restitution on 4 in of ash at 85 ft/s, the middle of the rule [kagan2004]."""
WOOD = 0.4995
"""BBCOR of the best wood bat of the catalogue: just below the limit [ncaa_bbcor]."""
SHARE_SPEED = 136 * MPH
EXPONENT = 1.65
"""n; see the ball's force_exponent in balls.toml."""


def standard(ball: Ball) -> Impact:
    """Return the standard hit, 6 in from the tip of a wood bat."""
    bat = catalog.bat("r161-ash")
    conditions, place = standard_conditions(bat), bat.length - 6 * INCH
    closing = conditions.pitch.speed + conditions.swing.speed_at(place)
    return hit(all_modes(beam_model(bat), ball), ball=ball, position=place, closing_speed=closing)


def anchored(ball: Ball, share: float, exponent: float) -> Ball:
    """Return the ball of a share and an exponent that meets the three tests."""
    best = catalog.bat("mlb-d")
    wall = Block(material=catalog.material("white ash"), thickness=4 * INCH)
    law = ball.restitution

    def of(numbers: np.ndarray) -> Ball:
        stiffness, reference, slope = numbers * (1e7, 1.0, 1e-3)
        restitution = law.replaced(reference=float(reference), slope=float(slope))
        damping = damping_from_share(share, speed=SHARE_SPEED, restitution=restitution.at(SHARE_SPEED))
        return ball.replaced(stiffness=float(stiffness), exponent=exponent, restitution=restitution, damping=damping)

    def misses(numbers: np.ndarray) -> list[float]:
        tried = of(numbers)
        struck = standard(tried)
        wooden = bat_test(
            beam_model(best),
            modes=all_modes(beam_model(best), tried),
            body=rigid_body(beam_model(best)),
            ball=tried,
            closing_speed=BBCOR_SPEED,
        )
        return [
            struck.peak_force / PEAK_FORCE - 1,
            (fire(wall, ball=tried, speed=ASH_SPEED).restitution - ASH) * 10,
            (wooden.best_bbcor - WOOD) * 10,
        ]

    start = np.array([1.2 * 4.0 ** (exponent - 1.5) * (1 + share), law.reference, law.slope * 1e3])
    return of(fsolve(misses, start, xtol=1e-7))


if __name__ == "__main__":
    for share in (0.0, 0.1, 0.2, 0.3, 0.4, 0.5):
        ball = anchored(catalog.ball(), share, EXPONENT)
        struck = standard(ball)
        print(
            f"share {share}: k {ball.stiffness:.4e}, c {ball.damping:.5f}, e {ball.restitution.reference:.4f}, "
            f"slope {ball.restitution.slope:.4e}; hit {struck.peak_force / 1e3:.2f} kN, "
            f"{1e3 * struck.contact_time:.3f} ms, {1e3 * struck.peak_compression:.1f} mm",
            flush=True,
        )

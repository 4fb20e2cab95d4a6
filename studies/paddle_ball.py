"""Fit the pickleball's law of restitution, and the cores of two reference paddles: ``python -m studies.paddle_ball``.

What is measured is the paddle-ball restitution of paddles in two laboratories. Ball and core trade against each other:
a ball that loses less does what a softer core does. So the core is set to the middle of its maker's range, one number
of the ball is fitted in each laboratory, and with that ball the core of each single paddle. The tones of those cores
are predictions; a tap of the paddles would test them.
"""

from __future__ import annotations

import argparse
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from scipy.optimize import brentq

from sweetspot import catalog
from sweetspot.analysis.certification.simulated_paddle_test import PaddleTest, paddle_test
from sweetspot.dynamics.paddle_modes import Clamp, face_tone
from sweetspot.equipment.ball import Ball
from sweetspot.equipment.paddle import Paddle
from sweetspot.numerics.arrays import Array
from sweetspot.units import INCH, MPH

SWING_AXIS = 2 * INCH
MEAN_LEVEL = 0.402
"""Mean paddle-ball restitution of a laboratory's reference paddles at 50 mph [kewcor]."""
LIGHT, HEAVY = 12.15e-4, 33e-4
"""Clamps of two laboratories, kg m^2 [kewcor; technicalpickleball_clamp]."""
REACH = 0.09
"""m from the butt to where a clamp holds the handle (assumed)."""


@dataclass(frozen=True)
class Reference:
    """A measured paddle: swing weight in kg m^2, length and place from the tip in m, restitution at 50 mph."""

    name: str
    swing_weight: float
    length: float
    from_tip: float
    pbcor: float

    @property
    def paddle(self) -> Paddle:
        """The catalogue's paddle of this length and swing weight."""
        pattern = catalog.implement("pickleball-paddle")
        assert isinstance(pattern, Paddle)
        return pattern.replaced(length=self.length, moi=self.swing_weight)

    def test(self, ball: Ball, *, shear: float | None = None) -> float:
        """Return the restitution of the model at the measured place; ``shear``: of the core in Pa."""
        paddle = self.paddle if shear is None else self.paddle.replaced(core_shear=shear)
        at = np.array([self.length - self.from_tip])
        return float(tested(paddle, ball, positions=at, speed=50 * MPH, moi=LIGHT).pbcor[0])


REFERENCES = (
    Reference("CRBN1 TruFoam Genesis", 124.39e-4, 16.50 * INCH, 4.50 * INCH, 0.3834),
    Reference("CRBN3 TruFoam Waves", 121.17e-4, 16.42 * INCH, 4.42 * INCH, 0.4094),
)
"""[kewcor]."""


def tested(paddle: Paddle, ball: Ball, *, positions: Array | None, speed: float, moi: float) -> PaddleTest:
    """Return the test of a paddle in a clamp of a moment of inertia."""
    clamp = Clamp(axis=SWING_AXIS, reach=REACH, moi=moi)
    return paddle_test(paddle, ball=ball, speed=speed, clamp=clamp, positions=positions)


def with_log_slope(ball: Ball, slope: float) -> Ball:
    """Return a ball with another loss of restitution for every e-fold of speed."""
    return ball.replaced(restitution=ball.restitution.replaced(log_slope=slope))


def playing_ball() -> float:
    """Return the log slope with which the reference paddles have the mean level."""
    ball = catalog.ball("pickleball")

    def excess(slope: float) -> float:
        return float(np.mean([each.test(with_log_slope(ball, slope)) for each in REFERENCES])) - MEAN_LEVEL

    return float(brentq(excess, 0.2, 0.33, xtol=1e-4))


def filled_ball() -> float:
    """Return the log slope with which a paddle of 120 kg cm^2 has 0.40 at 60 mph in the heavy clamp."""
    ball = catalog.ball("pickleball-test")
    paddle = Reference("", 120e-4, 16.5 * INCH, 0.0, 0.0).paddle

    def excess(slope: float) -> float:
        test = tested(paddle, with_log_slope(ball, slope), positions=None, speed=60 * MPH, moi=HEAVY)
        return test.best_pbcor - 0.40

    return float(brentq(excess, 0.12, 0.33, xtol=1e-4))


def core_of(reference: Reference) -> float:
    """Return the shear modulus in Pa with which a paddle has its measured restitution."""
    ball = catalog.ball("pickleball")
    return float(brentq(lambda shear: reference.test(ball, shear=shear) - reference.pbcor, 3e6, 40e6, xtol=1e3))


def main(words: Sequence[str] | None = None) -> None:
    """Print the fits: of both balls and of every reference paddle, or of one paddle alone."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--only", help="the beginning of a paddle's name")
    only = parser.parse_args(words).only
    if only is None:
        print(f"playing ball: log slope {playing_ball():.3f}")
        print(f"test ball, holes filled: log slope {filled_ball():.3f}")
    for reference in REFERENCES:
        if only is not None and not reference.name.startswith(only):
            continue
        shear = core_of(reference)
        tone = face_tone(reference.paddle.replaced(core_shear=shear))
        print(f"{reference.name}: core {shear / 1e6:.1f} MPa, then a face tone of {tone:.0f} Hz")


if __name__ == "__main__":
    main()

"""The ball's patch: Hertz, how it goes with speed, and that a patch of one size stands for one that grows."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
import pytest

from sweetspot import catalog
from sweetspot.collision.contact_law import ContactLaw, damped_impulse, pressed_in_series
from sweetspot.collision.free_motion import modal_propagator_of
from sweetspot.collision.kernel import hits
from sweetspot.dynamics.beam import beam_model
from sweetspot.dynamics.hoop import OtherPatch
from sweetspot.dynamics.modes import Modes
from sweetspot.dynamics.patch import ByPatch, contact_patch, patch_law
from sweetspot.dynamics.reduction import all_modes
from sweetspot.equipment.ball import Ball, stored_on_wall
from sweetspot.numerics.arrays import Array


def test_the_patch_is_hertz_at_the_mean_that_counts(baseball: Ball) -> None:
    """a^2 = R u (Hertz), u = 0.91 of the compression that stops the ball at 60 m/s: k U^(n+1)/(n+1) is what it stores.

    Without loss by the rate that is m v^2 / 2.
    """
    compression = contact_patch(baseball) ** 2 / baseball.radius / 0.91
    area = baseball.stiffness * compression ** (baseball.exponent + 1) / (baseball.exponent + 1)
    stored = stored_on_wall(60.0, mass=baseball.mass, damping=baseball.damping)
    assert area == pytest.approx(stored) and stored < baseball.mass * 60.0**2 / 2
    assert stored_on_wall(60.0, mass=baseball.mass, damping=0.0) == pytest.approx(baseball.mass * 60.0**2 / 2)
    assert 0.02 < contact_patch(baseball) < 0.03


def test_a_slow_ball_presses_a_smaller_patch(baseball: Ball) -> None:
    """u goes with v^(2/(n+1)), a with its root; the recoil of a free bat takes sqrt(1.235) off the speed."""
    still = baseball.replaced(damping=0.0)
    fast, slow = contact_patch(still, 60.8), contact_patch(still, 26.8)
    assert slow / fast == pytest.approx((26.8 / 60.8) ** (1 / (still.exponent + 1)))
    damped = contact_patch(baseball, 26.8) / contact_patch(baseball, 60.8)
    assert slow / fast < damped < 1.03 * (slow / fast)  # the faster the blow, the more of it a damper takes
    assert contact_patch(baseball, 60.0 * np.sqrt(1.235)) == pytest.approx(contact_patch(baseball))
    for ball, within in ((still, 1e-9), (baseball, 0.04)):  # a damper lets slow balls press more than the power says
        law = patch_law(ball)
        for speed in (10.0, 26.8, 60.8):
            assert law.radius_at(speed) == pytest.approx(contact_patch(ball, speed), rel=within)
    assert patch_law(still, factor=1.2).radius_at(40.0) == pytest.approx(1.2 * contact_patch(still, 40.0))


def test_tables_are_interpolated_in_the_square_of_the_radius() -> None:
    """A cubic in a^2 through four radii is exact; it is evaluated for one speed and for many alike."""
    from sweetspot.numerics.piecewise import Piecewise

    law = patch_law(catalog.ball())
    squares = law.radii**2
    values = np.stack([1 + squares - 3e3 * squares**2 + 1e6 * squares**3, squares], axis=1)
    table = ByPatch(law, Piecewise(values[None, None], np.array([0.0, 1.0])))
    speeds = np.array([12.0, 26.8, 60.8])
    found = table(np.full(3, 0.5), speeds)
    expected = law.radius_at(speeds) ** 2
    assert found[:, 0] == pytest.approx(1 + expected - 3e3 * expected**2 + 1e6 * expected**3)
    assert found[:, 1] == pytest.approx(expected)
    assert table(np.array(0.5), 26.8) == pytest.approx(found[1])
    assert table.nominal()(0.5) == pytest.approx(table(np.array(0.5)))


class _Grown(NamedTuple):
    """A bat under a patch of any radius."""

    steady: Array
    hoop: ByPatch
    steady_give: float
    give: ByPatch
    place: float

    def under(self, radius: float) -> tuple[Array, float]:
        weights = self.hoop.law.weights_of(np.clip(radius, *self.hoop.law.radii[[0, -1]]))
        give = self.steady_give + float(weights @ self.give.tables(self.place))
        return np.concatenate([self.steady, weights @ self.hoop.tables(self.place)]), give


def _grown(modes: Modes, place: float) -> _Grown:
    assert modes.surface is not None and isinstance(modes.surface.basis, OtherPatch)
    felt = modes.surface.basis.felt
    *steady, last = modes.compliances
    assert isinstance(last, ByPatch)
    count = len(modes) - felt.tables.coefficients.shape[-1]
    give = sum(float(np.asarray(one(np.array(place)))) for one in steady)
    return _Grown(modes.shapes(place)[:count], felt, give, last, place)


def growing_efficiency(modes: Modes, ball: Ball, *, place: float, speed: float, step: float = 4e-6) -> float:
    """Return q where the patch is a = sqrt(R u) of the present compression u at every moment."""
    law, grown, drift = ContactLaw(ball), _grown(modes, place), modal_propagator_of(modes, step)
    displacement, velocity = np.zeros(len(modes)), np.zeros(len(modes))
    position, ball_speed, compression, peak = speed * step / 2, speed, 1e-6, 0.0
    turned: float | None = None
    while True:
        for _ in range(3):
            shape, give = grown.under(np.sqrt(ball.radius * compression))
            approach = position - float(shape @ displacement)
            if approach <= 0:
                return -ball_speed / speed
            compression, force, slope = pressed_in_series(law, approach=approach, compliance=give, turned_at=turned)
        if approach >= peak:
            peak = approach
        elif turned is None:
            turned = compression
        rate, lightness = ball_speed - float(shape @ velocity), 1 / ball.mass + float(shape @ shape)
        impulse, _ = damped_impulse(step * force, ball.damping / (1 + give * slope), rate, lightness, rate, 0.0, step)
        ball_speed -= impulse / ball.mass
        velocity = velocity + shape * impulse
        displacement, velocity = (
            drift[:, 0, 0] * displacement + drift[:, 0, 1] * velocity,
            drift[:, 1, 0] * displacement + drift[:, 1, 1] * velocity,
        )
        position += ball_speed * step


@pytest.mark.parametrize(("name", "within"), [("single-wall", 0.003), ("double-wall", 0.0065), ("composite", 0.002)])
@pytest.mark.parametrize("speed", [26.8, 60.8])
def test_a_patch_that_grows_with_the_force_is_one_of_the_mean_size(
    name: str, within: float, speed: float, baseball: Ball
) -> None:
    """The patch is fixed at the mean compression weighted with F^2, the one of the comparison grows and shrinks.

    At 60 mph and 136 mph. The double wall is so soft that the ball is pressed a tenth less than on a rigid wall.
    """
    beam = beam_model(catalog.bat(name))
    modes, place = all_modes(beam, baseball), beam.bat.length - 0.15
    fixed = hits(modes, ball=baseball, position=place, closing_speed=speed, step=4e-6).collision_efficiency[0]
    assert fixed == pytest.approx(growing_efficiency(modes, baseball, place=place, speed=speed), abs=within)

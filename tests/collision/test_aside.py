"""A ball beside the line of a face: how far the face turns under it, and where the ball goes."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from sweetspot import catalog
from sweetspot.catalog.standard_hit import standard_conditions
from sweetspot.collision.aside import aside_angle, mean_tilt
from sweetspot.collision.coupled import hit
from sweetspot.collision.impact import Impact
from sweetspot.dynamics.reduction import reduced_bat

TWIST = 14e-4  # kg m^2, of the catalogue's racket


@pytest.fixture(scope="module")
def impact() -> Impact:
    racket = catalog.implement("tennis-racket")
    assert racket.outline is not None
    ball = standard_conditions(racket).ball
    modes = reduced_bat(racket, ball=ball).modes
    return hit(modes, ball=ball, position=racket.outline.middle, lateral=0.05, closing_speed=22.0)


def test_the_tilt_of_a_half_sine_is_known(impact: Impact) -> None:
    """Exact: F = sin(pi t / T) turns by y/I (T/pi)(t - (T/pi) sin(pi t / T)); its force-weighted mean is
    y T^2 / (pi I) (1/2 - 1/4) = y T^2 / (4 pi I), an eighth of omega_end T with omega_end = 2 y T / (pi I)."""
    times = np.linspace(0.0, 5e-3, 4001)
    pulse = replace(impact, times=times, force=np.sin(np.pi * times / 5e-3))
    assert mean_tilt(pulse, roll_moi=TWIST) == pytest.approx(0.05 * 25e-6 / (4 * np.pi * TWIST), rel=1e-5)


def test_angles(impact: Impact) -> None:
    """Nothing on the line, odd in the side; without friction the whole impulse goes along the tilted normal."""
    face = catalog.implement("tennis-racket").face
    assert face is not None
    leaves = impact.collision_efficiency * 22.0  # of a racket at rest
    angle = aside_angle(impact, roll_moi=TWIST, face=face, leaves_at=leaves)
    slick = aside_angle(impact, roll_moi=TWIST, face=face.replaced(tangential_restitution=-1.0), leaves_at=leaves)
    q = impact.collision_efficiency
    assert np.tan(slick) == pytest.approx(mean_tilt(impact, roll_moi=TWIST) * (1 + q) / q)
    assert 0 < angle < slick
    other = replace(impact, lateral=-0.05)
    assert aside_angle(other, roll_moi=TWIST, face=face, leaves_at=leaves) == -angle
    assert aside_angle(replace(impact, lateral=0.0), roll_moi=TWIST, face=face, leaves_at=leaves) == 0.0
    assert aside_angle(impact, roll_moi=1.16 * TWIST, face=face, leaves_at=leaves) == pytest.approx(angle / 1.16, 2e-3)

"""Hands on the handle."""

from __future__ import annotations

import numpy as np
import pytest

from sweetspot.analysis import TYPICAL_HAND, Analysis, exit_speed_of, hit_at
from sweetspot.bat import Bat
from sweetspot.collision.propagator import propagator
from sweetspot.errors import InputError
from sweetspot.line import reduce
from sweetspot.swing import Hands
from sweetspot.vibration.beam import bending_modes
from sweetspot.vibration.hands import check_hands, gripped


def test_no_hands_is_the_free_bat(r161: Bat) -> None:
    free = bending_modes(reduce(r161))
    held = gripped(free, Hands(position=0.15))
    assert held.frequency == pytest.approx(free.frequency, abs=1e-4)
    assert np.abs(held.shape_at(0.7)) == pytest.approx(np.abs(free.shape_at(0.7)), rel=1e-6)


def test_hands_add_springs_and_damping(r161: Bat) -> None:
    free = bending_modes(reduce(r161))
    held = gripped(free, Hands(position=0.15, **TYPICAL_HAND))
    assert np.all(held.frequency[:2] > 1) and np.all(held.frequency[:2] < 60)  # the bat swings on the hands' springs
    assert np.all(held.damping_ratio[2:] >= free.damping_ratio[2:] - 1e-3)
    assert held.damping_ratio[2:4].max() > 0.02  # hands damp strongly (Russell, qualitatively)


@pytest.mark.parametrize("scale", [0.1, 1.0, 10.0, 1000.0])
def test_grip_hardly_changes_the_exit_speed(analysis: Analysis, scale: float) -> None:
    """Nathan 2000: grip does not matter for impacts on the barrel; within 1 % from loose to clamped."""
    hand = Hands(position=0.1524, **{name: scale * value for name, value in TYPICAL_HAND.items()})
    free = bending_modes(analysis.line)
    for position in analysis.bat.length - 0.0254 * np.array([4.0, 6.0, 8.0]):
        loose = hit_at(position, modes=free, conditions=analysis.conditions)
        held = hit_at(position, modes=gripped(free, hand), conditions=analysis.conditions)
        change = exit_speed_of(held, analysis.conditions) / exit_speed_of(loose, analysis.conditions) - 1
        assert abs(change) < 0.01


def test_neglected_damping_coupling_does_not_matter(analysis: Analysis) -> None:
    """The hands' dampers couple modes; keeping the full matrix in a small independent integration agrees."""
    hands = Hands(position=0.1524, **TYPICAL_HAND)
    free = bending_modes(analysis.line)
    matrices = {"m": np.eye(len(free)), "k": np.diag(free.angular_frequency**2), "c": np.diag(free.damping_rate)}
    for place in hands.places:
        outer = np.outer(free.shape_at(place), free.shape_at(place))
        matrices["m"] += hands.mass * outer
        matrices["k"] += hands.stiffness * outer
        matrices["c"] += hands.damping * outer
    held = hit_at(0.69, modes=gripped(free, hands), conditions=analysis.conditions)
    shape, step = free.shape_at(0.69), held.times[2] - held.times[1]
    inverse = np.linalg.inv(matrices["m"])
    q, p = np.zeros(len(free)), np.zeros(len(free))
    for force in held.force[1:]:  # the same force history on the full matrices, symplectic Euler
        p = p + step * inverse @ (shape * force - matrices["k"] @ q - matrices["c"] @ p)
        q = q + step * p
    moved = float(shape @ p)
    assert moved == pytest.approx(float(gripped(free, hands).shape_at(0.69) @ held.velocity), rel=0.03)


def test_overdamped_motion_is_exact(r161: Bat) -> None:
    """Two half steps of the exact propagator are one whole step, below and above critical damping."""
    held = gripped(bending_modes(reduce(r161)), Hands(position=0.15, stiffness=20e3, damping=5e3))
    assert held.damping_ratio.max() > 1
    half, full = propagator(held, 1e-5), propagator(held, 2e-5)
    assert half @ half == pytest.approx(full, rel=1e-9, abs=1e-9)


def test_hands_off_the_bat_are_refused(r161: Bat) -> None:
    with pytest.raises(InputError, match=r"hand position is 0.9 m \(35.43 in\)"):
        check_hands(r161, Hands(position=0.9))

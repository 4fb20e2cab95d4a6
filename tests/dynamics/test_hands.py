"""Hands on the handle."""

from __future__ import annotations

import dataclasses

import numpy as np
import pytest
import scipy.linalg

from sweetspot import catalog
from sweetspot.analysis.bat_analysis import TYPICAL_HAND, Analysis, exit_speed_of, hit_at
from sweetspot.collision.free_motion import modal_propagator_of, moved
from sweetspot.dynamics.beam import beam_model
from sweetspot.dynamics.hands import held_modes
from sweetspot.dynamics.reduction import all_modes, bending_modes
from sweetspot.equipment.bat import Bat
from sweetspot.motion.swing import Hands


def test_no_hands_is_the_free_bat(r161: Bat) -> None:
    free = bending_modes(beam_model(r161))
    assert held_modes(free, Hands(position=0.15)) is free
    held = held_modes(free, Hands(position=0.15, mass=0.3))  # a hand that nothing holds to the bat
    assert held.frequency[4:] == pytest.approx(free.frequency[2:]) and held.frequency[:4] == pytest.approx(0, abs=1e-3)


def test_hands_hardly_change_frequency_but_damp(r161: Bat) -> None:
    """Russell: even a tight grip damps strongly and does not significantly change frequencies."""
    free = bending_modes(beam_model(r161))
    held = held_modes(free, Hands(position=0.15, **TYPICAL_HAND))
    assert len(held) == len(free) + 2 and held.families.count("hand") == 2
    bending = held.of_family("bending")
    assert held.frequency[bending] == pytest.approx(free.frequency[free.of_family("bending")], rel=0.08)
    damped = np.sum(held.dashpots[:, bending] ** 2, axis=0) / (2 * held.angular_frequency[bending])
    assert damped[0] > 3 * free.damping_ratio[2]


def test_hoop_modes_keep_their_names() -> None:
    """The handle does not go out of round: every hoop mode of a held hollow bat has the frequency it had before."""
    bat = catalog.bat("single-wall")
    free = all_modes(beam_model(bat), catalog.ball())
    held = held_modes(free, Hands(position=0.15, **TYPICAL_HAND))
    assert held.families.count("hoop") == free.families.count("hoop") > 0
    assert held.frequency[held.of_family("hoop")] == pytest.approx(free.frequency[free.of_family("hoop")], rel=1e-9)
    bending = held.of_family("bending")
    assert [held.harmonics[index] for index in bending] == list(range(1, 1 + len(bending)))


def test_a_vice_pins_the_handle(r161: Bat) -> None:
    """Very stiff and heavy hands: every bending mode has a node at both of them."""
    held = held_modes(bending_modes(beam_model(r161), count=30), Hands(position=0.15, mass=1e4, stiffness=1e9))
    low = [index for index in held.of_family("bending") if held.frequency[index] < 2000]
    shapes = held.shape_at(np.array([0.15, 0.061]))[:, low]
    assert len(low) >= 2 and np.abs(shapes).max() < 0.05 * np.abs(held.shape_at(0.8)[low]).max()


def test_dashpots_are_the_damping_of_both_hands(r161: Bat) -> None:
    """D^T D is c s s^T summed over the hands in the new modes, with orthogonal rows: exact."""
    hands = Hands(position=0.15, **TYPICAL_HAND)
    held = held_modes(bending_modes(beam_model(r161)), hands)
    rows = held.dashpots @ held.dashpots.T
    assert rows[0, 1] == pytest.approx(0.0, abs=1e-9 * rows.max())
    assert np.trace(rows) > 0


@pytest.mark.parametrize("scale", [0.1, 1.0, 10.0, 1000.0])
def test_grip_hardly_changes_the_exit_speed(analysis: Analysis, scale: float) -> None:
    """Nathan 2000: grip does not matter for impacts on the barrel; 1 % allowed, from loose to clamped."""
    hand = Hands(position=0.1524, **{name: scale * value for name, value in TYPICAL_HAND.items()})
    free = bending_modes(analysis.beam)
    for position in analysis.bat.length - 0.0254 * np.array([3.0, 6.0, 9.0]):
        loose = hit_at(position, modes=free, conditions=analysis.conditions)
        held = hit_at(position, modes=held_modes(free, hand), conditions=analysis.conditions)
        change = exit_speed_of(held, analysis.conditions) / exit_speed_of(loose, analysis.conditions) - 1
        assert abs(change) < 0.003
        assert abs(held.energy.imbalance) < 1e-4


def test_hands_agree_with_full_matrices(analysis: Analysis) -> None:
    """The same force history on full mass, spring and damper matrices, integrated independently."""
    hands = Hands(position=0.1524, **TYPICAL_HAND)
    free = bending_modes(analysis.beam)
    count = len(free)
    mass = np.diag(np.concatenate([np.ones(count), [hands.mass] * 2]))
    spring = np.diag(np.concatenate([free.angular_frequency**2, [0.0, 0.0]]))
    damper = np.diag(np.concatenate([free.damping_rate, [0.0, 0.0]]))
    for number, place in enumerate(hands.places):
        flesh = np.zeros(count + 2)
        flesh[:count], flesh[count + number] = free.shape_at(place), -1.0
        spring += hands.stiffness * np.outer(flesh, flesh)
        damper += hands.damping * np.outer(flesh, flesh)
    held = hit_at(0.6, modes=held_modes(free, hands), conditions=analysis.conditions)
    push, step = np.concatenate([free.shape_at(0.6), [0.0, 0.0]]), held.times[2] - held.times[1]
    still, unit = np.zeros_like(mass), np.eye(count + 2)
    inverse = np.linalg.inv(mass)
    flow = scipy.linalg.expm(step * np.block([[still, unit], [-inverse @ spring, -inverse @ damper]]))
    state = np.zeros(2 * (count + 2))
    for force in held.force[1:]:
        state[count + 2 :] += inverse @ push * force * step
        state = flow @ state
    expected = float(free.shape_at(0.15) @ state[count + 2 : 2 * count + 2])
    together, late = held_modes(free, hands), held.times[-1] + step - held.release_time
    _, velocity = moved(together, held.displacement, held.velocity, late)  # the last kick comes after the release
    found = float(together.shape_at(0.15) @ velocity)
    assert found == pytest.approx(expected, rel=1e-3)


def test_overdamped_motion_is_exact(r161: Bat) -> None:
    """Two half steps of the exact propagator are one whole step, below and above critical damping."""
    modes = bending_modes(beam_model(r161))
    damped = dataclasses.replace(modes, damping_rate=np.geomspace(1.0, 1e6, len(modes)))
    assert damped.damping_ratio.max() > 1 > damped.damping_ratio[2]
    half, full = modal_propagator_of(damped, 1e-5), modal_propagator_of(damped, 2e-5)
    assert half @ half == pytest.approx(full, rel=1e-9, abs=1e-9)


def test_springs_of_the_hands_are_in_the_frequencies(r161: Bat) -> None:
    """Exact: the trace of M^-1 K is the sum of omega^2, whatever mixes with what."""
    free = bending_modes(beam_model(r161))
    hands = Hands(position=0.15, mass=0.5, stiffness=1e5, damping=0.0)
    held = held_modes(free, hands)
    at_hands = free.shape_at(np.array(hands.places))
    expected = (free.angular_frequency**2).sum() + 1e5 * (at_hands**2).sum() + 2 * 1e5 / 0.5
    added = (held.angular_frequency**2).sum() - (free.angular_frequency**2).sum()
    assert added == pytest.approx(expected - (free.angular_frequency**2).sum(), rel=1e-5)

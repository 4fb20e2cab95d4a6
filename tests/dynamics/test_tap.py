"""A tap against the motion that its push leaves when it is integrated step by step."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from sweetspot import catalog
from sweetspot.collision.free_motion import modal_propagator_of
from sweetspot.dynamics.beam import beam_model
from sweetspot.dynamics.modes import half_sine_gain, tapped
from sweetspot.dynamics.reduction import bending_modes
from sweetspot.errors import InputError

MODES = bending_modes(beam_model(catalog.bat("r161-ash")))


@pytest.mark.parametrize("duration", [0.2e-3, 1e-3, 2.9e-3])
def test_tap_is_what_a_half_sine_push_leaves(duration: float) -> None:
    # other code: the push in 4000 short kicks, each mode moved exactly between them, without damping
    modes = replace(MODES, damping_rate=np.zeros(len(MODES)))
    steps = 4000
    size = duration / steps
    drift, shape = modal_propagator_of(modes, size), modes.shape_at(0.6)
    displacement, velocity = np.zeros(len(modes)), np.zeros(len(modes))
    for moment in (np.arange(steps) + 0.5) / steps:
        push = np.pi / (2 * duration) * np.sin(np.pi * moment) * size
        displacement, velocity = (
            drift[:, 0, 0] * displacement + drift[:, 0, 1] * (velocity + shape * push),
            drift[:, 1, 0] * displacement + drift[:, 1, 1] * (velocity + shape * push),
        )
    left = np.sqrt(velocity**2 + (modes.angular_frequency * displacement) ** 2)
    found = tapped(modes, position=0.6, duration=duration)
    assert np.abs(found) == pytest.approx(left, rel=1e-4, abs=1e-5)


def test_gain_is_smooth_where_half_a_period_is_the_tap() -> None:
    # exact: pi / 4 by l'Hopital
    assert half_sine_gain(np.array([0.0, 1.0, 1 + 1e-5])) == pytest.approx([1.0, np.pi / 4, np.pi / 4], abs=1e-4)


def test_a_tap_on_a_node_leaves_its_mode_alone() -> None:
    node = MODES.nodes(2)[-1]
    speeds = np.abs(tapped(MODES, position=float(node), duration=0.5e-3))
    assert speeds[2] < 1e-9 * speeds[3]


def test_impossible_taps_are_refused() -> None:
    with pytest.raises(InputError, match="tap lasts nan s"):
        tapped(MODES, position=0.6, duration=float("nan"))

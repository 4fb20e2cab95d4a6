"""The directions of a swing: square to each other, in the plane they were asked for, mirrored for the other hand."""

from __future__ import annotations

from math import pi, radians

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from sweetspot.errors import InputError
from sweetspot.motion.swing_path import SwingPath, path_axes, steep_enough

angles = st.floats(-1.2, 1.2)


@given(attack=angles, direction=angles, tilt=st.floats(0.0, 1.5), left=st.booleans())
def test_axes_are_square_unit_vectors(attack: float, direction: float, tilt: float, left: bool) -> None:
    axes = np.array(path_axes(attack, direction, tilt=steep_enough(tilt, attack), left=left))
    assert axes @ axes.T == pytest.approx(np.eye(3), abs=1e-12)


@given(attack=angles, direction=angles, tilt=st.floats(0.0, 1.5), left=st.booleans())
def test_the_plane_has_the_tilt(attack: float, direction: float, tilt: float, left: bool) -> None:
    """Exact: the normal of the plane of path and bat stands at the tilt from the vertical, barrel below the hands."""
    forward, _, tip = path_axes(attack, direction, tilt=steep_enough(tilt, attack), left=left)
    normal = np.cross(tip, forward) * (-1 if left else 1)
    assert normal[2] == pytest.approx(np.cos(max(tilt, abs(attack))), abs=1e-9)
    assert forward[2] == pytest.approx(np.sin(attack))
    assert tip[2] <= 1e-12


def test_left_handed_mirrors_right_handed() -> None:
    right, left = (
        SwingPath(attack_angle=0.15, attack_direction=-0.2, tilt=0.55, bats=side) for side in ("right", "left")
    )
    for one, other in zip(right.axes, left.axes, strict=True):
        assert one * [-1, 1, 1] == pytest.approx(other)


def test_pulling_goes_to_the_batters_own_side() -> None:
    """Statcast: the attack direction is negative to the pull side; a right-handed batter pulls to left field."""
    assert SwingPath(attack_direction=-0.2).axes.forward[0] < 0
    assert SwingPath(attack_direction=-0.2, bats="left").axes.forward[0] > 0


def test_the_barrel_hangs_by_nearly_the_tilt() -> None:
    assert SwingPath(tilt=radians(32)).barrel_drop == pytest.approx(radians(32))
    assert SwingPath(attack_angle=0.1).barrel_drop == pytest.approx(0.0, abs=1e-9)


@pytest.mark.parametrize(
    ("fields", "words"),
    [
        ({"attack_angle": 0.3, "tilt": 0.2}, "no path in a plane is steeper"),
        ({"tilt": pi / 2}, "below 90 deg"),
        ({"attack_angle": 1.5}, "-80 to 80 deg"),
        ({"attack_direction": float("nan")}, "finite"),
        ({"bats": "both"}, "right"),
    ],
)
def test_impossible_paths_are_refused(fields: dict[str, float], words: str) -> None:
    with pytest.raises(InputError, match=words):
        SwingPath(**fields)


def test_many_paths_steeper_than_their_planes_are_refused() -> None:
    with pytest.raises(InputError, match=r"1 of 3 paths are steeper .* attack angle of -30 deg and a tilt of 20 deg"):
        path_axes(np.radians([10, -30, 20]), 0.0, tilt=radians(20), left=False)

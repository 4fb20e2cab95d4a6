"""The give of a long tube in harmonics 0 and 1, against Sanders' strains written down as they are in the books."""

from __future__ import annotations

import numpy as np
import pytest

from sweetspot.dynamics.hoop import _breathing, _shifting
from sweetspot.dynamics.patch import transform

WALL, MIDDLE, OUTER, PATCH = 2.9e-3, 0.0319, 0.03335, 0.014


@pytest.mark.parametrize("wave", [5.0, 30.0, 110.0, 400.0])
def test_each_wave_gives_way_as_sanders_has_it(wave: float) -> None:
    """U cos kx, V sin kx, W sin kx, solved plainly; waves long enough for that to lose digits are left out."""
    stretch = 71e9 * WALL / (1 - 0.33**2)
    law = np.array([[1, 0.33, 0], [0.33, 1, 0], [0, 0, 0.335]]) * stretch
    whole = np.block([[law, np.zeros((3, 3))], [np.zeros((3, 3)), law * WALL**2 / 12]])
    for n, work in ((0, _breathing), (1, _shifting)):
        strain = np.array([
            [-wave, 0, 0], [0, n / MIDDLE, 1 / MIDDLE], [-n / MIDDLE, wave, 0], [0, 0, wave**2],
            [0, n / MIDDLE**2, n**2 / MIDDLE**2],
            [n / (2 * MIDDLE**2), 1.5 * wave / MIDDLE, 2 * n * wave / MIDDLE],
        ])  # fmt: skip
        before, after = (float(transform(np.array(PATCH * np.hypot(m / OUTER, wave)))) for m in (n - 1, n + 1))
        outwards, around, lift = (before + after) / 2, (after - before) / 2, (OUTER - MIDDLE) / MIDDLE
        push = np.array([0, around * (1 + lift), outwards + around * n * lift])
        own = [0, 1, 2] if n else [0, 2]
        ring = (strain.T @ whole @ strain)[np.ix_(own, own)] * np.pi * MIDDLE * (1 if n else 2)
        expected = push[own] @ np.linalg.solve(ring, push[own])
        found = work(whole[None], np.array([[wave]]), np.array([[MIDDLE]]), np.array([[OUTER]]), np.array([PATCH]))
        assert float(found[0, 0, 0]) == pytest.approx(expected, rel=1e-7 if wave < 10 else 1e-10, abs=0)

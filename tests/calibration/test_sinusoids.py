"""Damped sinusoids: what was put in comes out, with honest errors; an independent method agrees."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from sweetspot.calibration.measured import Measured, pooled
from sweetspot.calibration.recording import BAT_BAND
from sweetspot.calibration.sinusoids import Sinusoid, _gram, _model, _slopes, fit_sinusoids
from sweetspot.numerics.arrays import Array
from sweetspot.numerics.interval import REACH

RATE = 12800.0
BAT = ((171.8, 0.0075, 0.3), (572.4, 0.0070, 0.7), (1117.9, 0.0080, 1.0), (1787.6, 0.0085, 0.8))
"""(Hz, damping ratio, amplitude)."""


def ringing(modes: tuple[tuple[float, float, float], ...], *, noise: float, seed: int, seconds: float = 0.45) -> Array:
    generator = np.random.default_rng(seed)
    time = np.arange(round(seconds * RATE)) / RATE
    sound = noise * generator.standard_normal(len(time))
    for (frequency, ratio, amplitude), phase in zip(modes, generator.uniform(0, 2 * np.pi, len(modes)), strict=True):
        decay = 2 * np.pi * frequency * ratio / np.sqrt(1 - ratio**2)
        sound += amplitude * np.exp(-decay * time) * np.cos(2 * np.pi * frequency * time + phase)
    return sound


def nearest(sinusoids: tuple[Sinusoid, ...], frequency: float) -> Sinusoid:
    return min(sinusoids, key=lambda one: abs(one.frequency.value - frequency))


def test_exact_without_noise() -> None:
    fit = fit_sinusoids(ringing(BAT, noise=0.0, seed=1), RATE, band=BAT_BAND)
    assert len(fit.sinusoids) == len(BAT)
    for one, (frequency, ratio, amplitude) in zip(fit.sinusoids, BAT, strict=True):
        assert one.frequency.value == pytest.approx(frequency, rel=1e-7)
        assert one.damping_ratio.value == pytest.approx(ratio, rel=1e-5)
        assert one.amplitude == pytest.approx(amplitude, rel=1e-5)
    assert fit.misfit < 1e-4


def test_intervals_cover_as_often_as_they_say() -> None:
    """90 % intervals of 20 sounds with four tones each; 160 draws scatter by 2.4 %."""
    inside = []
    for seed in range(20):
        fit = fit_sinusoids(ringing(BAT, noise=0.02, seed=seed), RATE, band=BAT_BAND)
        for frequency, ratio, _ in BAT:
            one = nearest(fit.sinusoids, frequency)
            inside += [one.frequency.low < frequency < one.frequency.high]
            inside += [one.damping_ratio.low < ratio < one.damping_ratio.high]
    assert 0.82 < np.mean(inside) < 0.97


def test_two_planes_of_one_mode_are_told_apart() -> None:
    pair = ((570.0, 0.003, 1.0), (577.0, 0.003, 0.6))
    fit = fit_sinusoids(ringing(pair, noise=0.01, seed=3), RATE, band=BAT_BAND)
    assert [one.frequency.value for one in fit.sinusoids] == pytest.approx([570.0, 577.0], abs=0.2)


def test_noise_alone_has_no_tones() -> None:
    noise = np.random.default_rng(2).standard_normal(6000)
    assert fit_sinusoids(noise, RATE, band=BAT_BAND).sinusoids == ()


def test_matrix_pencil_agrees() -> None:
    """An independent estimator: poles of the shift between two Hankel matrices [hua1990]."""
    modes = BAT[:2]
    sound = ringing(modes, noise=1e-4, seed=5, seconds=0.08)
    poles = _matrix_pencil(sound, order=2 * len(modes))
    found = sorted(np.abs(np.angle(poles)) * RATE / (2 * np.pi))[::2]
    fit = fit_sinusoids(sound, RATE, band=BAT_BAND)
    assert [one.frequency.value for one in fit.sinusoids] == pytest.approx(found, rel=2e-4)


def _matrix_pencil(samples: Array, *, order: int) -> Array:
    pencil = len(samples) // 3
    hankel = np.lib.stride_tricks.sliding_window_view(samples, pencil + 1)
    _, _, rows = np.linalg.svd(hankel, full_matrices=False)
    signal = rows[:order].T
    return np.asarray(np.linalg.eigvals(np.linalg.pinv(signal[:-1]) @ signal[1:]))


def test_pooled_errors() -> None:
    alike = pooled([Measured(10.0, 0.2)] * 4)
    assert (alike.value, alike.error) == pytest.approx((10.0, 0.1))
    assert alike.high - alike.value == pytest.approx(REACH * 0.1)
    unlike = pooled([Measured(9.0, 0.1), Measured(10.0, 0.1), Measured(11.0, 0.1)])
    assert unlike.error == pytest.approx(1 / np.sqrt(3))  # the standard error of the three values themselves
    assert Measured(1.0, 0.3).widened(0.4).error == pytest.approx(0.5)


@given(
    st.lists(
        st.tuples(st.floats(60, 5000), st.floats(0.001, 300), st.floats(-1, 1), st.floats(0.01, 1)),
        min_size=1,
        max_size=4,
    )
)
def test_sums_of_series_are_the_inner_products_of_the_derivatives(rows: list[tuple[float, ...]]) -> None:
    # exact: the derivatives written out at every sample and multiplied
    parameters, time = np.array(rows), np.arange(3000) / 12_800
    columns = []
    for frequency, decay, cosine, sine in rows:
        turn = np.exp((-decay + 2j * np.pi * frequency) * time)
        size = cosine - 1j * sine
        columns += [(2j * np.pi * time * size * turn).real, (-time * size * turn).real, turn.real, turn.imag]
    expected = np.array(columns) @ np.array(columns).T
    found = _gram(parameters, _slopes(parameters), time)
    scale = np.sqrt(np.outer(np.diag(expected), np.diag(expected)))
    np.testing.assert_allclose(found / scale, expected / scale, atol=1e-6)
    np.testing.assert_allclose(
        _model(parameters, time),
        sum(np.real((a - 1j * b) * np.exp((-d + 2j * np.pi * f) * time)) for f, d, a, b in rows),
        atol=1e-9,
    )

"""The same sound taken apart by other code: sdyPy's least-squares complex frequency method on its spectrum."""

from __future__ import annotations

import warnings

import numpy as np
import pytest

from sweetspot import catalog
from sweetspot.calibration.recording import BAT_BAND, tap_sound
from sweetspot.calibration.sinusoids import fit_sinusoids
from sweetspot.dynamics.beam import beam_model
from sweetspot.dynamics.reduction import all_modes

RATE = 8192.0


@pytest.mark.filterwarnings("ignore")
def test_frequencies_and_damping_agree_with_sdypy() -> None:
    """Other code: sdypy-EMA, poles of order 30 between 20 and 1,500 Hz. Both see the same noise."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        from sdypy import EMA

    bat = catalog.bat("r161-ash")
    modes = all_modes(beam_model(bat), catalog.ball("baseball"))
    sound = tap_sound(modes, position=bat.length - 0.0254, listened=bat.length - 0.03, rate=RATE, seconds=4.0)
    sound = sound / np.abs(sound).max() + 1e-4 * np.random.default_rng(1).standard_normal(len(sound))
    ours = fit_sinusoids(sound[: int(RATE / 2)], RATE, band=BAT_BAND).sinusoids[:3]
    frequency = np.fft.rfftfreq(len(sound), 1 / RATE)
    inside = (frequency > 20) & (frequency < 1500)
    response = np.fft.rfft(sound)[None, inside]
    model = EMA.Model(response, frequency[inside], lower=50, upper=1400, pol_order_high=30, frf_form="accelerance")
    model.get_poles(show_progress=False)
    poles = np.asarray(model.all_poles[-1])
    natural, ratio = np.abs(poles) / (2 * np.pi), -poles.real / np.abs(poles)
    for one in ours:
        near = int(np.argmin(np.abs(natural - one.frequency.value)))
        undamped = one.frequency.value / np.sqrt(1 - one.damping_ratio.value**2)
        assert natural[near] == pytest.approx(undamped, rel=2e-4)
        assert ratio[near] == pytest.approx(one.damping_ratio.value, rel=0.02)

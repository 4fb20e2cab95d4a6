"""The picture of a tap test: labels of crowded tones are clear of each other, whatever was named."""

from __future__ import annotations

import numpy as np
import pytest
from matplotlib.figure import Figure

from sweetspot.calibration.measured import Measured
from sweetspot.calibration.mode_naming import ModeFamily, ModeName, NamedTone
from sweetspot.calibration.recording import Recording
from sweetspot.calibration.sinusoids import Fit, Sinusoid
from sweetspot.calibration.tap_analysis import TapTest
from sweetspot.calibration.taps import Tap, Tone
from sweetspot.reports.pictures.tap import tap_figure
from tests.reports.pictures.labels import check_labels, texts

RATE, SECONDS = 12_000, 0.4
CROWDED = {
    "apart": [(172.0, True), (572.0, True), (1118.0, True), (1788.0, False)],
    "one on another": [(168.0, True), (2191.0, True), (2302.0, True), (4659.0, True), (4793.0, True)],
    "more than there is room for": [
        (frequency, number % 2 == 0) for number, frequency in enumerate(np.linspace(3000, 3300, 14))
    ],
}


def made_up(tones: list[tuple[float, bool]]) -> TapTest:
    """Return a test of one good tap and a rejected one whose tones ring at these frequencies; some have a name."""
    time = np.arange(round(RATE * SECONDS)) / RATE
    parts = [Sinusoid(Measured(tone, 1.0), Measured(0.005, 0.001), 0.1) for tone, _ in tones]
    samples = sum(np.exp(-0.005 * 2 * np.pi * tone * time) * np.cos(2 * np.pi * tone * time) for tone, _ in tones)
    fit = Fit(tuple(parts), 0.1, 0.1 * np.asarray(samples), 0.1 * np.asarray(samples), RATE)
    named = tuple(
        NamedTone(Tone(part.frequency, part.damping_ratio, 1 / (1 + number), 1), name, None)
        for number, part in enumerate(parts)
        for name in [ModeName("bending", number + 1) if tones[number][1] else None]
    )
    expected = ModeFamily((ModeName("bending", 1),), np.array([tones[0][0]]), np.ones(1), 0.1, 0.1)
    taps = (Tap("a", 0.1, None, fit), Tap("a", 0.3, "too quiet", None))
    return TapTest((Recording("a", fit.samples, RATE),), taps, named, (expected,))


@pytest.fixture(scope="module", params=CROWDED)
def drawn(request: pytest.FixtureRequest) -> tuple[str, Figure]:
    return request.param, tap_figure(made_up(CROWDED[request.param]), "A bat with a name")


def test_labels_are_clear_of_each_other(drawn: tuple[str, Figure]) -> None:
    check_labels(drawn[1])


def test_what_has_a_name_is_told_first(drawn: tuple[str, Figure]) -> None:
    words = [text for text, _ in texts(drawn[1]) if text.endswith(" Hz")]
    names = [text for text in words if text.startswith("bending")]
    tones = CROWDED[drawn[0]]
    known, crowded = sum(known for _, known in tones), drawn[0] == "more than there is room for"
    assert "bending 1" in names[0]
    assert 3 <= len(words) < len(tones) if crowded else (len(words), len(names)) == (len(tones), known)


def test_the_legend_lies_over_no_curve(drawn: tuple[str, Figure]) -> None:
    decay = drawn[1].axes[2]
    legend = decay.get_legend()
    assert legend is not None
    low = legend.get_window_extent().y0
    for line in decay.lines:
        points = decay.transData.transform(np.column_stack([line.get_xdata(), line.get_ydata()]))
        assert np.nanmax(points[:, 1]) < low

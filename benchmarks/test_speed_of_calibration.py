"""One bat measured: a tap taken apart, a bat fitted, and how sure a report is."""

from __future__ import annotations

import time
from collections.abc import Callable
from typing import Any

import pytest

from benchmarks.cases import duration, measured
from sweetspot import all_modes, beam_model, catalog
from sweetspot.answers.report_draws import drawn_report
from sweetspot.calibration.measured import Measured
from sweetspot.calibration.measurements import Measurement, of_tones
from sweetspot.calibration.posterior import calibrate
from sweetspot.calibration.recording import synthesised
from sweetspot.calibration.tap_analysis import tap_test
from sweetspot.calibration.unknowns import described, unknowns_of
from sweetspot.catalog.standard_hit import standard_analysis
from sweetspot.uncertainty.sources import DRAWS, sources_of


def test_a_tap_and_a_calibration(benchmark: Any, record: Callable[..., None]) -> None:
    bat = catalog.bat()
    modes = all_modes(beam_model(bat), catalog.ball())
    sound = synthesised(modes, position=bat.length - 0.025, listened=bat.length - 0.04, taps=1)
    places = [bat.length - 0.025]
    seconds = measured(benchmark, lambda: tap_test([sound], modes=modes, positions=places))
    record("one tap to named tones", duration(seconds), goal="1 s")
    tones = of_tones(tap_test([sound], modes=modes, positions=places).tones)
    beam, unknowns = described(bat), unknowns_of(bat)
    weighed = [Measurement("mass", Measured(0.8788, 0.001)), *tones]
    start = time.perf_counter()
    calibrate(beam, unknowns, weighed)
    record("weight and tones to a calibrated bat", duration(time.perf_counter() - start), goal="1 s")


@pytest.mark.parametrize("name", ["r161-ash", "college-alloy"])
def test_how_sure_a_report_is(benchmark: Any, record: Callable[..., None], name: str) -> None:
    """Every draw's beam, surface and hits along the bat, wood and hollow."""
    analysis = standard_analysis(name)
    sources = sources_of(analysis.bat, analysis.conditions)
    drawn_report(analysis, sources, count=4)
    seconds = measured(benchmark, lambda: drawn_report(analysis, sources))
    record(f"{DRAWS:,} draws of the report of {name}", duration(seconds), goal="250 ms")

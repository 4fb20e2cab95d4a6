"""From a bat to twelve modes, beside the same with scikit-fem's Hermite beam."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from benchmarks.cases import beam, best, child, duration, measured, modes
from benchmarks.rivals import thin_beam
from sweetspot import bending_modes

ONE_BLAS_THREAD = """
import os, time
os.environ["OPENBLAS_NUM_THREADS"] = "1"  # on a busy machine, threads of one small problem wait for each other
from sweetspot import bending_modes, catalog, beam_model
line, times = beam_model(catalog.bat("r161-ash")), []
for _ in range(30):
    start = time.perf_counter()
    bending_modes(line)
    times.append(time.perf_counter() - start)
print(min(times))
"""


def test_modes(benchmark: Any, record: Callable[..., None]) -> None:
    edges = modes().shapes.ends

    def rival() -> Any:
        return thin_beam.frequencies(beam(), edges, 12)

    thin = rival()
    seconds, rival_seconds = measured(benchmark, lambda: bending_modes(beam())), best(rival)
    record(
        "bat to 12 modes", duration(seconds), goal="5 ms",
        rival=f"scikit-fem Hermite beam, same elements: {duration(rival_seconds)}",
        ratio=f"{rival_seconds / seconds:.2f}",
    )  # fmt: skip
    alone = child(ONE_BLAS_THREAD)
    record("  in a process with one BLAS thread", duration(alone), goal="5 ms")
    ours = modes().frequency[2:]
    record(
        "  what leaving out shear costs", f"ours {ours[0]:.0f}, {ours[11]:.0f} Hz",
        rival=f"thin beam: mode 1 {thin[0] / ours[0] - 1:+.1%}, mode 12 {thin[11] / ours[11] - 1:+.0%}",
    )  # fmt: skip
    assert thin[11] > ours[11]

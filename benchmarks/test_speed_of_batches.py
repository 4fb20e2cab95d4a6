"""Many bats at once to mass properties and twelve modes, beside one by one with LAPACK and with ARPACK."""

from __future__ import annotations

import time
from collections.abc import Callable
from typing import Any

import numpy as np
import scipy.sparse
from scipy.sparse.linalg import eigsh

from benchmarks.cases import QUICK, ball, beam, duration, measured
from sweetspot import beam_model, catalog
from sweetspot.dynamics.batch.beams import SolidBats
from sweetspot.dynamics.batch.bending import bending_batch
from sweetspot.dynamics.batch.mesh import apart
from sweetspot.dynamics.batch.reduction import reduced_beams
from tests.dense_bending import dense_chain, dense_modes, mesh_matrices

BATS = 64 if QUICK else 1024
HOLLOW = 8 if QUICK else 64


def outlines(count: int) -> SolidBats:
    """Return bats like the benchmark's own, each a little thicker than the one before."""
    bat = beam().bat
    place, diameter = np.array(bat.profile).T  # type: ignore[attr-defined]
    one, none = np.ones(count), np.zeros((count, 0))
    widths = np.linspace(0.95, 1.05, count)[:, None] * diameter
    return SolidBats(bat.material, np.tile(place, (count, 1)), widths, one, one, 0 * one, 0 * one, none, none)  # type: ignore[attr-defined]


def processor(work: Callable[[], Any]) -> float:
    """Return the processor seconds of the quickest of three runs: what a busy machine does not change."""
    times = []
    for _ in range(3):
        start = time.process_time()
        work()
        times.append(time.process_time() - start)
    return min(times)


def test_many_bats(benchmark: Any, record: Callable[..., None]) -> None:
    bats = outlines(BATS)
    batch = bending_batch(bats)
    seconds, _ = measured(benchmark, lambda: bending_batch(bats)), None
    record(f"{BATS} bats to 12 modes", f"{BATS / seconds:,.0f} bats/s", goal="2,000 bats/s")
    ours = processor(lambda: bending_batch(bats, threads=1)) / BATS
    readable = processor(lambda: dense_modes(beam()))
    record(
        "  processor time of one of them", duration(ours),
        rival=f"one by one with LAPACK, the same elements: {duration(readable)}", ratio=f"{readable / ours:.0f}",
    )  # fmt: skip

    def sparse() -> Any:
        stiffness, inertia, shift = mesh_matrices(beam())
        matrices = scipy.sparse.csc_array(stiffness), scipy.sparse.csc_array(inertia)
        return eigsh(matrices[0], k=14, M=matrices[1], sigma=-shift)

    arpack = processor(sparse)
    record("", "", rival=f"one by one with ARPACK, shift and invert: {duration(arpack)}", ratio=f"{arpack / ours:.0f}")
    one = bats.part(slice(0, 1))
    alone = min(processor(lambda: bending_batch(one, threads=1)) for _ in range(5))
    record("  one bat alone", duration(alone), goal="1 ms")
    assert np.allclose(batch.frequency[BATS // 2], batch.frequency[BATS // 2 - 1], rtol=1e-2)
    assert len(apart([0.0, 1e-9, 1.0])) == 2


def test_hollow_bats(record: Callable[..., None]) -> None:
    names = ("single-wall", "double-wall", "composite", "two-piece")
    lines = [beam_model(catalog.bat(names[i % 4])) for i in range(HOLLOW)]
    reduced_beams(lines, ball=ball())
    start = time.perf_counter()
    reduced_beams(lines, ball=ball())
    seconds = time.perf_counter() - start
    ours = processor(lambda: reduced_beams(lines, ball=ball(), threads=1)) / HOLLOW
    readable = processor(lambda: [dense_chain(one, ball()) for one in lines[:4]]) / 4
    record(
        f"{HOLLOW} hollow bats to all modes", f"{HOLLOW / seconds:,.0f} bats/s", goal="200 bats/s",
        rival=f"processor time of one, {duration(ours)}: bending one by one with LAPACK {duration(readable)}",
        ratio=f"{readable / ours:.1f}",
    )  # fmt: skip

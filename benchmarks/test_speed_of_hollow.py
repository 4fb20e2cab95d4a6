"""Hollow bats: all modes, the certification test, and two-way tables."""

from __future__ import annotations

import time
from collections.abc import Callable
from functools import partial
from typing import Any

import numpy as np

from benchmarks.cases import QUICK, ball, duration, measured
from sweetspot import all_modes, beam_model, catalog, standard_conditions
from sweetspot.analysis.certification.simulated_test import certify
from sweetspot.analysis.what_if import Axis, what_if_table

table_of = partial(what_if_table, law=catalog.swing_law(), fill=catalog.material("cork"))

SIDE = 4 if QUICK else 20


def test_all_modes_of_a_hollow_bat(benchmark: Any, record: Callable[..., None]) -> None:
    beam = beam_model(catalog.bat("single-wall"))
    seconds = measured(benchmark, lambda: all_modes(beam, ball()))
    record("hollow bat to all modes, 12 bending and 24 hoop", duration(seconds), goal="60 ms")


def test_certification(benchmark: Any, record: Callable[..., None]) -> None:
    bat = catalog.bat("single-wall")
    seconds = measured(benchmark, lambda: certify(bat, ball=ball()))
    record("certify a hollow bat, 33 places at two speeds", duration(seconds), goal="0.3 s")


def test_two_way_tables(benchmark: Any, record: Callable[..., None]) -> None:
    wood, hollow = catalog.bat("r161-ash"), catalog.bat("single-wall")
    depth = Axis("bore_depth", tuple(np.linspace(0, 0.3, SIDE)))
    mass = Axis("mass", tuple(np.linspace(0.85, 0.92, SIDE)))
    wall = Axis("wall_factor", tuple(np.linspace(0.7, 1.4, SIDE)))
    added = Axis("mass", tuple(np.linspace(0.84, 0.95, SIDE)))

    def of_wood() -> Any:
        return table_of(wood, rows=mass, columns=depth, conditions=standard_conditions(wood))

    seconds = measured(benchmark, of_wood, rounds=1)
    record(f"table of weight and cork depth, {SIDE} x {SIDE}", duration(seconds), goal="20 s")
    start = time.perf_counter()
    table_of(hollow, rows=wall, columns=added, conditions=standard_conditions(hollow))
    record(f"table of wall and weight, {SIDE} x {SIDE}", duration(time.perf_counter() - start), goal="20 s")

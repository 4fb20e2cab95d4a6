"""The bound on the scatter of balls, on a made-up league whose balls scatter by what is put in."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import polars as pl
import pytest

from studies.ball_scatter import PITCH, RECOIL, main, tracked
from sweetspot.units import DEGREE, MPH
from sweetspot.validation.computations.space import simulated_league


def made_up(path: Path, scatter: float) -> str:
    """Write the table of a simulated league whose balls scatter in restitution."""
    hits = simulated_league("r161-ash")
    livelier = scatter * np.random.default_rng(8).standard_normal(len(hits.deflection))
    faster = livelier * (hits.measured_bat_speed + PITCH) / (1 + RECOIL)
    table = {
        "bat_speed": hits.measured_bat_speed / MPH,
        "launch_speed": (hits.measured_speed + faster) / MPH,
        "attack_angle": np.zeros(len(faster)),
        "launch_angle": hits.deflection / DEGREE,
    }
    pl.DataFrame(table).write_csv(path)
    return str(path)


def test_a_made_up_scatter_is_found_again(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """A league with 0.010 lies on that row of the study, and not on those of half and twice as much."""
    path = made_up(tmp_path / "hits.csv", 0.010)
    main([path])
    rows = [line.split("|")[1:-1] for line in capsys.readouterr().out.splitlines() if line.startswith("|")]
    found = {row[0].strip(): np.array([float(cell) for cell in row[1:]]) for row in rows[2:]}
    (table,) = [values for name, values in found.items() if name.startswith("tracked")]
    apart = {name: abs(values[2] - table[2]) for name, values in found.items() if name.startswith("simulated")}
    assert min(apart, key=lambda name: apart[name]) == "simulated, scatter 0.01"
    assert apart["simulated, scatter 0.0195"] > 10 * apart["simulated, scatter 0.01"]
    assert np.percentile(tracked(path, "r161-ash"), 99.5) == pytest.approx(table[2] * MPH, abs=0.01)

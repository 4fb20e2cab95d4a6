"""How often `sweetspot rank` keeps all twelve bats of an honest table: ``python -m studies.ranking_tables``.

Bats differ from their description as much as supposed. They are weighed, balanced, timed over twenty swings and tapped
with the errors of the usual instruments (`sweetspot.calibration.measured.FLOORS`), their tones are off the model's as
much as it deserves, and the readings are written with four digits and no ±, as tables come. Exit 1 where fewer than
`LEAST` of the tables of a case keep all their bats.
"""

from __future__ import annotations

import argparse
import csv
import sys
import tempfile
import warnings
from collections.abc import Sequence
from pathlib import Path

import numpy as np

from sweetspot import catalog
from sweetspot.answers.rank import RankQuestion, rank_answer
from sweetspot.calibration.bat_table import read_bats
from sweetspot.calibration.measured import FLOORS, Measured
from sweetspot.calibration.measurements import BENDING_ERROR, Measurement, predicted
from sweetspot.calibration.mode_naming import ModeName
from sweetspot.calibration.unknowns import described, deviated, unknowns_of
from sweetspot.catalog.standard_hit import standard_conditions
from sweetspot.dynamics.beam import BeamModel
from sweetspot.equipment.implement import Implement

DOZEN, LEAST = 12, 0.95
BODY = (
    Measurement("mass", Measured(1.0, FLOORS["mass"])),
    Measurement("balance_point", Measured(1.0, FLOORS["balance_point"])),
    Measurement("period", Measured(1.0, FLOORS["pendulum"])),
)
TONES = tuple(
    Measurement("frequency", Measured(1.0, FLOORS["tone"]), mode=ModeName("bending", number)) for number in (1, 2)
)
CASES = (("r161-ash", BODY), ("r161-ash", (*BODY, *TONES)), ("mlb-c", (*BODY, *TONES)), ("single-wall", BODY))
HEADINGS = ("mass_g", "balance_point_mm", "pendulum_s", "bending_1_hz", "bending_2_hz")
SIZES = (1e3, 1e3, 1.0, 1.0, 1.0)
DIGITS = (1, 2, 4, 2, 2)
"""Decimals of each column: more than its instrument deserves."""


def read_off(beam: BeamModel, asked: Sequence[Measurement], generator: np.random.Generator) -> list[str]:
    """Return the readings of one bat, with the instruments' errors, as they are written."""
    texts = []
    for reading, value, size, digits in zip(asked, predicted(beam, list(asked)).tolist(), SIZES, DIGITS, strict=False):
        of_model = BENDING_ERROR * value if reading.mode else 0.0
        seen = value + np.hypot(reading.value.error, of_model) * generator.standard_normal()
        texts.append(f"{size * seen:.{digits}f}")
    return texts


def kept_in_table(model: Implement, asked: Sequence[Measurement], seed: int, folder: Path) -> int:
    """Return the number of bats of one made-up table that are ranked."""
    generator = np.random.default_rng(seed)
    beam, unknowns = described(model), unknowns_of(model)
    spreads = np.array([unknown.spread for unknown in unknowns])
    table = folder / "dozen.csv"
    with table.open("w", encoding="utf-8", newline="") as file:
        writer = csv.writer(file)
        writer.writerow(["name", *HEADINGS[: len(asked)]])
        for number in range(1, DOZEN + 1):
            differing = deviated(beam, unknowns, spreads * generator.standard_normal(len(unknowns)))
            writer.writerow([f"No {number}", *read_off(differing, asked, generator)])
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        bats = read_bats(table, axis=model.swing_axis, sport=model.sport)
    conditions, law = standard_conditions(model), catalog.swing_law(catalog.sport(model.sport).swing_law)
    return len(rank_answer(RankQuestion(model, bats, conditions, law)).ranked)


def main(arguments: Sequence[str] | None = None) -> int:
    """Print a line per case; return 1 when one keeps too few tables whole."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--count", type=int, default=100, help="tables per case")
    count, bad = parser.parse_args(arguments).count, False
    with tempfile.TemporaryDirectory() as folder:
        for name, asked in CASES:
            model = catalog.bat(name)
            kept = np.array([kept_in_table(model, asked, seed, Path(folder)) for seed in range(count)])
            whole = float(np.mean(kept == DOZEN))
            bad |= whole < LEAST
            words = ", ".join(reading.name for reading in asked)
            print(
                f"{name}; {words}: {100 * whole:.0f} % of {count} tables keep all {DOZEN} bats, "
                f"{100 * kept.mean() / DOZEN:.2f} % of all bats are kept"
            )
    return int(bad)


if __name__ == "__main__":
    sys.exit(main())

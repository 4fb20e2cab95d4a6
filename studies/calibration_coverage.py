"""How often the 90 % intervals of `sweetspot calibrate` hold the truth: made-up bats whose every property is known.

Run with the number of bats per case; 200 take several minutes. With --wider 1.5 the made-up bats differ from their
description 1.5 times as much as is supposed. Exit 1 when a case, or one of its properties over all of a case's bats, is
not within 85 to 95 %, or a bat is refused.
"""

from __future__ import annotations

import argparse
import sys
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from sweetspot import catalog
from sweetspot.calibration.measured import Measured
from sweetspot.calibration.measurements import Measurement, predicted
from sweetspot.calibration.mode_naming import ModeName
from sweetspot.calibration.posterior import calibrate
from sweetspot.calibration.unknowns import described, deviated, unknowns_of
from sweetspot.dynamics.beam import BeamModel
from sweetspot.errors import InputError
from sweetspot.numerics.interval import REACH

SCALE = (("mass", 0.001), ("balance_point", 0.0015), ("period", 0.002))
"""Kinds and errors, SI: a kitchen scale, a balance on an edge, a pendulum timed over ten swings."""
TONES = 0.0015
"""Relative error of a frequency."""
CASES = (
    ("mlb-c", (), False), ("mlb-c", (1,), False), ("mlb-c", (1, 2, 3), False), ("single-wall", (1, 2), True),
)  # fmt: skip
LEAST, MOST = 0.85, 0.95


def measured(beam: BeamModel, *, bending: Sequence[int], hoop: bool, seed: int) -> list[Measurement]:
    """Return what would be measured on a bat, with errors of the instruments and of the model."""
    wanted = [Measurement(kind, Measured(1.0, error)) for kind, error in SCALE]  # type: ignore[arg-type]
    names = [ModeName("bending", number) for number in bending] + [ModeName("hoop", 2)] * hoop
    wanted += [Measurement("frequency", Measured(1.0, 1.0), mode=name) for name in names]
    generator = np.random.default_rng(seed)
    found = []
    for one, value in zip(wanted, predicted(beam, wanted).tolist(), strict=True):
        exact = replace(one, value=Measured(value, TONES * value if one.mode else one.value.error))
        noisy = value + exact.error * generator.standard_normal()
        found.append(replace(exact, value=Measured(noisy, exact.value.error)))
    return found


@dataclass(frozen=True)
class Coverage:
    """What became of the made-up bats of one case.

    Parameters
    ----------
    parts : of the calibrated bats, those whose interval holds the truth, per property.
    contradicting : bats whose measurements seem to contradict each other.
    refused : reasons of the bats that were not calibrated, by their seed.
    """

    parts: dict[str, float]
    contradicting: int
    refused: dict[int, str]


def coverage(name: str, bending: Sequence[int], hoop: bool, *, count: int, wider: float) -> Coverage:
    """Return how often the intervals of made-up bats hold the truth.

    Parameters
    ----------
    wider : how many times as much as supposed the bats differ from their description.
    """
    bat = catalog.bat(name)
    beam, unknowns = described(bat), unknowns_of(bat)
    spreads = np.array([one.spread for one in unknowns])
    inside, contradicting = [], 0
    refused: dict[int, str] = {}
    for seed in range(count):
        truth = wider * spreads * np.random.default_rng(seed).standard_normal(len(unknowns))
        taken = measured(deviated(beam, unknowns, truth), bending=bending, hoop=hoop, seed=seed + 10_000)
        try:
            found = calibrate(beam, unknowns, taken)
        except InputError as error:
            refused[seed] = str(error)
            continue
        inside.append(np.abs(found.deviations - truth) < REACH * np.sqrt(np.diag(found.covariance)))
        contradicting += bool(found.contradictions)
    parts = np.mean(inside, axis=0).tolist()
    return Coverage({str(one.name): part for one, part in zip(unknowns, parts, strict=True)}, contradicting, refused)


def main(arguments: Sequence[str] | None = None) -> int:
    """Print a line per case and one per property; return 1 when one is outside."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--count", type=int, default=200, help="bats per case")
    parser.add_argument("--wider", type=float, default=1.0, help="times the spreads supposed that the bats differ by")
    options = parser.parse_args(arguments)
    bad = False
    for name, bending, hoop in CASES:
        found = coverage(name, bending, hoop, count=options.count, wider=options.wider)
        part = float(np.mean(list(found.parts.values())))
        bad |= bool(found.refused) or not all(LEAST <= one <= MOST for one in (part, *found.parts.values()))
        tones = [f"bending {number}" for number in bending] + ["hoop"] * hoop
        print(
            f"{name}; weight, balance, pendulum{', ' + ', '.join(tones) if tones else ''}: {100 * part:.1f} % of the "
            f"truth inside, {found.contradicting} of {options.count} bats with a false contradiction"
        )
        print("    " + ", ".join(f"{unknown} {100 * one:.1f} %" for unknown, one in found.parts.items()))
        for seed, reason in found.refused.items():
            print(f"    bat {seed} refused: {reason}")
    return int(bad)


if __name__ == "__main__":
    sys.exit(main())

"""How well measured bats are answered: outlines drawn at random, their own mass, balance point and moi plus noise.

The noise is normal, with the stated standard deviation of the balance point and of the moi. Counted are the bats
answered, refused and failed, and the answered ones whose first three modes lie within 1 % of the true bat's.

Run: .venv/bin/python -m studies.measured_bats --count 2000
"""

from __future__ import annotations

import argparse
import os
from collections.abc import Sequence
from dataclasses import dataclass

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # small matrices: threads only get in each other's way

import numpy as np

from sweetspot import catalog
from sweetspot.catalog.files.turned import Turned
from sweetspot.dynamics.beam import beam_model
from sweetspot.dynamics.reduction import bending_modes
from sweetspot.dynamics.rigid import rigid_body
from sweetspot.equipment.bat import Bat
from sweetspot.errors import InputError
from sweetspot.units import INCH

NOISE = ((0.05, 0.005), (0.1, 0.01), (0.2, 0.02))  # in, relative
CLOSE = 0.01
MODES = slice(2, 5)


@dataclass
class Count:
    """Bats of one level of noise; ``misses`` are relative errors of the frequencies, one row a bat answered."""

    refused: list[str]
    failed: list[str]
    misses: list[np.ndarray]

    @property
    def answered(self) -> float:
        """Part of all bats."""
        return len(self.misses) / (len(self.misses) + len(self.refused) + len(self.failed))

    @property
    def close(self) -> float:
        """Part of the bats answered whose modes are right."""
        return float(np.mean(np.abs(self.misses).max(axis=1) < CLOSE))


def random_bat(random: np.random.Generator) -> Bat:
    """Return a turned wood bat of ordinary sizes, its wood as dense as that wood can be."""
    length = random.uniform(31, 34.5)
    sizes = {
        "knob": random.uniform(1.8, 2.4),
        "handle": random.uniform(0.9, 1.1),
        "barrel": random.uniform(2.35, 2.61),
        "taper_start": random.uniform(5, 13),
        "taper_end": random.uniform(21, length - 2.5),
    }
    wood = catalog.material(str(random.choice(["white-ash", "sugar-maple"])))
    lightest, heaviest = wood.density_range or (wood.density, wood.density)
    grown = wood.replaced(density=random.uniform(lightest, heaviest))
    profile = Turned(length=length * INCH, **{name: size * INCH for name, size in sizes.items()}).profile()
    return Bat(name="simulated", length=length * INCH, material=grown, profile=profile)


def simulated(count: int, *, balance_noise: float, moi_noise: float, seed: int = 1) -> Count:
    """Return what becomes of ``count`` bats; noise of the balance point in in, of the moi relative."""
    random = np.random.default_rng(seed)
    result = Count([], [], [])
    for _ in range(count):
        bat = random_bat(random)
        beam = beam_model(bat)
        body, frequency = rigid_body(beam), bending_modes(beam, count=3).frequency[MODES]
        usual = catalog.material("white-ash" if "ash" in bat.material.name else "sugar-maple")
        measured = bat.replaced(
            material=usual,
            mass=body.mass,
            balance_point=body.balance_point + random.normal(0, balance_noise) * INCH,
            moi=body.moi(bat.moi_axis) * (1 + random.normal(0, moi_noise)),
        )
        try:
            answer = bending_modes(beam_model(measured), count=3).frequency[MODES]
        except InputError as error:
            result.refused.append(str(error))
        except Exception as error:
            result.failed.append(repr(error))
        else:
            result.misses.append(answer / frequency - 1)
    return result


def main(arguments: Sequence[str] | None = None) -> None:
    """Print one line a level of noise."""
    options = argparse.ArgumentParser(description=__doc__)
    options.add_argument("--count", type=int, default=2000, help="bats of each level of noise")
    count = options.parse_args(arguments).count
    print("balance  moi     answered  refused  failed  modes within 1 %  largest miss")
    for balance, moi in NOISE:
        result = simulated(count, balance_noise=balance, moi_noise=moi)
        largest = float(np.abs(result.misses).max())
        print(
            f"{balance:.2f} in  {100 * moi:.1f} %   {result.answered:7.1%}  {len(result.refused):7}  "
            f"{len(result.failed):6}  {result.close:16.1%}  {largest:12.2%}"
        )


if __name__ == "__main__":
    main()

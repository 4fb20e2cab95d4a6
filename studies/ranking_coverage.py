"""How often the bat that `sweetspot rank` tells to be the best of a dozen is the best: made-up dozens, truth known.

Run with the number of dozens per case; 100 take some minutes. Truths are solved anew, bat by bat; the ranking follows
them by slope and bend. Exit 1 when a case's chances differ from what came true by more than 2.6 standard errors, or its
90 % intervals hold the truth less than 85 or more than 95 in a hundred times.
"""

from __future__ import annotations

import argparse
import math
import sys
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from studies.calibration_coverage import measured
from sweetspot import catalog
from sweetspot.analysis.position_scan import scan
from sweetspot.answers.rank import barrel_places, rank_bats
from sweetspot.calibration.posterior import calibrate
from sweetspot.calibration.unknowns import described, deviated, unknowns_of
from sweetspot.catalog.standard_hit import standard_conditions
from sweetspot.dynamics.beam import BeamModel
from sweetspot.dynamics.reduction import ReducedBat
from sweetspot.dynamics.rigid import rigid_body
from sweetspot.motion.swing import Conditions
from sweetspot.motion.swing_law import SwingLaw
from sweetspot.numerics.arrays import Array
from sweetspot.numerics.interval import REACH

CASES = (("mlb-c", (), False), ("mlb-c", (1,), False), ("single-wall", (1, 2), True))
DOZEN = 12
LEAST, MOST = 0.85, 0.95
SURELY = 2.6
"""Standard errors: one case in a hundred lies further off by chance."""


@dataclass(frozen=True)
class Outcome:
    """What became of the bats of one case.

    Parameters
    ----------
    first : told chances of the bats told first, one a dozen.
    first_won : whether these were the best.
    chances, won : the same of all bats.
    inside : whether the interval of an exit speed held the truth, of all bats.
    alike : dozens whose bats were told not to differ by more than what is not known.
    """

    first: Array
    first_won: Array
    chances: Array
    won: Array
    inside: Array
    alike: int


def true_speed(beam: BeamModel, conditions: Conditions, law: SwingLaw, *, reference: float) -> float:
    """Return how fast the ball leaves a bat at its best place, m/s.

    Parameters
    ----------
    reference : moment of inertia about the law's axis with which the bat is swung as given, kg m^2.
    """
    reduced, places = ReducedBat.of_beam(beam, conditions.ball), barrel_places(beam.bat)
    hit = scan(reduced, conditions, places)
    ratio = law.speed_ratio(reduced.body.moi(law.axis), reference_moi=reference)
    bat = ratio * conditions.swing.angular_speed * (places - conditions.swing.pivot)
    efficiency = hit.collision_efficiency
    return float(np.max(efficiency * conditions.pitch.speed + (1 + efficiency) * bat))


def ranked_dozens(name: str, bending: Sequence[int], hoop: bool, *, count: int, alike: float = 1.0) -> Outcome:
    """Return what became of made-up dozens.

    Parameters
    ----------
    alike : how many times as much as supposed the bats differ.
    """
    bat = catalog.bat(name)
    beam, unknowns = described(bat), unknowns_of(bat)
    spreads = np.array([one.spread for one in unknowns])
    conditions, law = standard_conditions(bat), catalog.swing_law()
    reference = rigid_body(beam).moi(law.axis)
    first, first_won, chances, won, inside, same = [], [], [], [], [], 0
    for dozen in range(count):
        truths, posteriors = {}, {}
        for number in range(DOZEN):
            seed = 1000 * dozen + number
            off = alike * spreads * np.random.default_rng(seed).standard_normal(len(unknowns))
            own = deviated(beam, unknowns, off)
            truths[str(number)] = true_speed(own, conditions, law, reference=reference)
            given = measured(own, bending=bending, hoop=hoop, seed=seed + 500_000)
            posteriors[str(number)] = calibrate(beam, unknowns, given)
        ranking = rank_bats(posteriors, conditions=conditions, law=law, seed=dozen)
        same += not ranking.beyond_doubt
        best = max((one.name for one in ranking.bats), key=truths.__getitem__)
        favourite = max(ranking.bats, key=lambda one: one.best_chance or 0.0)
        first.append(favourite.best_chance)
        first_won.append(favourite.name == best)
        for one in ranking.bats:
            chances.append(one.best_chance)
            won.append(one.name == best)
            inside.append(abs(one.exit_speed.value - truths[one.name]) < REACH * one.exit_speed.error)
    told, told_won, chance, every_won, held = (
        np.array(each, float) for each in (first, first_won, chances, won, inside)
    )
    return Outcome(told, told_won, chance, every_won, held, same)


def main(arguments: Sequence[str] | None = None) -> int:
    """Print a line per case; return 1 when one is off."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--count", type=int, default=100, help="dozens per case")
    count, bad = parser.parse_args(arguments).count, False
    for name, bending, hoop in CASES:
        found = ranked_dozens(name, bending, hoop, count=count)
        told, came = float(found.first.mean()), float(found.first_won.mean())
        error = math.sqrt(float(np.sum(found.first * (1 - found.first)))) / count
        part = float(found.inside.mean())
        bad |= abs(told - came) > SURELY * error or not LEAST <= part <= MOST
        tones = [f"bending {number}" for number in bending] + ["hoop"] * hoop
        print(
            f"{name}; weight, balance, pendulum{', ' + ', '.join(tones) if tones else ''}: the bat told first, with a "
            f"chance of {100 * told:.0f} % on average, was the best of {DOZEN} in {100 * came:.0f} % of {count} dozens "
            f"(± {100 * error:.0f}); {100 * part:.1f} % of true exit speeds inside; {found.alike} dozens may be alike"
        )
        for low, high in ((0.0, 0.05), (0.05, 0.2), (0.2, 0.5), (0.5, 0.8), (0.8, 1.01)):
            among = (found.chances >= low) & (found.chances < high)
            if among.any():
                print(
                    f"    told {100 * low:.0f} to {min(100 * high, 100):.0f} %: {int(among.sum())} bats, on average "
                    f"{100 * found.chances[among].mean():.1f} %, came true {100 * found.won[among].mean():.1f} %"
                )
    return int(bad)


if __name__ == "__main__":
    sys.exit(main())

"""How often the intervals of `report` hold the truth: made-up bats and balls, each solved anew.

A truth is drawn at random from what the report says is not known. Its beam, walls, face and ball are solved exactly,
where the report's draws follow them by slope and bend from the bat as described. Counted is how often the 90 % interval
of the draws, and that of the first sentence, hold it.

Run: .venv/bin/python -m studies.report_coverage [--count 200] [NAME ...]. Exit 1 when a share of all truths of an
implement is not within 85 to 95 %.
"""

from __future__ import annotations

import argparse
import os
import sys
from collections.abc import Callable, Mapping, Sequence

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # small matrices: threads only get in each other's way

import numpy as np

from sweetspot import catalog
from sweetspot.analysis.bat_analysis import Analysis, analyse
from sweetspot.analysis.position_scan import scan
from sweetspot.answers.hit import HitAnswer, HitQuestion, hit_answer
from sweetspot.calibration.unknowns import as_described, deviated
from sweetspot.catalog.standard_hit import standard_conditions
from sweetspot.dynamics.reduction import ReducedBat
from sweetspot.equipment.bat import Bat
from sweetspot.equipment.implement import Implement
from sweetspot.numerics.constants import STANDARD_AXIS
from sweetspot.numerics.interval import REACH, Interval, Number
from sweetspot.uncertainty.drawn_hits import speed_doubt
from sweetspot.uncertainty.sources import PATCH, Sources, sources_of

NAMES = (
    "r161-ash", "russell-b1", "youth-30", "college-alloy", "single-wall", "youth-alloy", "composite", "slow-pitch",
    "cricket-bat", "tennis-racket", "badminton-racket", "golf-driver", "hockey-stick",
)  # fmt: skip
TOLD: Mapping[str, Callable[[HitAnswer], Number]] = {
    "exit_speed_m_s": lambda hit: hit.exit_speed,
    "collision_efficiency": lambda hit: hit.collision_efficiency,
    "bbcor": lambda hit: hit.bbcor,
    "bat.moi_6in_kg_m2": lambda hit: hit.bat.moi_6in,
}
LEAST, MOST = 0.85, 0.95


def truths(analysis: Analysis[Implement], sources: Sources, count: int, seed: int) -> dict[str, np.ndarray]:
    """Return what is true of bats and balls drawn from what is not known, each solved by itself."""
    beam, conditions = analysis.beam, analysis.conditions
    own = beam if isinstance(beam.bat, Bat) else as_described(beam.bat)
    place = np.array([analysis.sweet_spots.max_exit_speed])
    off = sources.deviations(np.random.default_rng(seed).standard_normal((count, len(sources.names))))
    of_bat, rows = len(sources.unknowns), []
    for row in off:
        bat = deviated(own, sources.unknowns, row[:of_bat]) if of_bat else beam
        (ball,) = sources.balls(conditions.ball, row[None])
        patch = float(np.exp(sources.of(PATCH, row[None])[0]))
        reduced = ReducedBat.of_beam(bat, ball, patch_factor=patch)
        hit = scan(reduced, conditions.replaced(ball=ball), place)
        rows.append((hit.exit_speed[0], hit.collision_efficiency[0], hit.bbcor[0], reduced.body.moi(STANDARD_AXIS)))
    return dict(zip(TOLD, np.array(rows).T, strict=True))


def main(arguments: Sequence[str] | None = None) -> int:
    """Print a row for every implement."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0] if __doc__ else None)
    parser.add_argument("--count", type=int, default=200, help="truths of every implement")
    parser.add_argument("--seed", type=int, default=11)
    parser.add_argument("names", nargs="*", default=NAMES)
    options = parser.parse_args(arguments)
    outside = 0
    print("| implement | " + " | ".join((*TOLD, "first sentence")) + " |")
    for name in options.names:
        implement = catalog.load_implement(name)
        analysis = analyse(implement, standard_conditions(implement))
        sources = sources_of(implement, analysis.conditions)
        place = analysis.sweet_spots.max_exit_speed
        answer = hit_answer(HitQuestion(implement, analysis.conditions, place, sources=sources))
        intervals = {told: number(answer) for told, number in TOLD.items()}
        true = truths(analysis, sources, options.count, options.seed)
        held = {
            told: np.mean((sure.low <= true[told]) & (true[told] <= sure.high))
            for told, sure in intervals.items()
            if isinstance(sure, Interval) and sure.high > sure.low
        }
        doubt = speed_doubt(analysis, sources)
        assert doubt is not None
        first = np.abs(true["exit_speed_m_s"] - float(answer.exit_speed)) <= REACH * doubt.error
        held["first sentence"] = np.mean(first)
        outside += sum(not LEAST <= share <= MOST for share in held.values())
        cells = [f"{100 * held[told]:.1f} %" if told in held else "" for told in (*TOLD, "first sentence")]
        print(f"| {name} | " + " | ".join(cells) + " |", flush=True)
    return 1 if outside else 0


if __name__ == "__main__":
    sys.exit(main())

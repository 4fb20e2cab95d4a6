"""Do the intervals of answers hold what was published? Values that nothing was fitted to, of bats and other kinds.

Each line asks the draws of `--uncertainty` as the source did. A value printed as a range counts as held where the
interval and the range meet, and "about 6" is 5.5 to 6.5. What a bat or a ball of the catalogue was fitted to is left
out.

Run: .venv/bin/python -m studies.published_intervals [--only NAME]
"""

from __future__ import annotations

import argparse
import os
import sys
from collections.abc import Sequence
from dataclasses import dataclass

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # small matrices: threads only get in each other's way

from functools import cache
from typing import Any

from sweetspot import catalog
from sweetspot.analysis.bat_analysis import Analysis, analyse
from sweetspot.answers.hit import HitQuestion, hit_answer
from sweetspot.answers.report import ReportAnswer, report_of
from sweetspot.catalog.standard_hit import standard_conditions
from sweetspot.equipment.implement import Implement
from sweetspot.numerics.interval import Interval
from sweetspot.plausibility import insisting
from sweetspot.uncertainty.sources import sources_of
from sweetspot.units import INCH, MPH


@dataclass(frozen=True)
class Value:
    """What a source prints of an implement.

    Parameters
    ----------
    source, what, printed : key of the source, the quantity, and the number as printed.
    name : of the implement in the catalogue.
    answer : fields and numbers on the way to it in `ReportAnswer`, or in `HitAnswer` for one hit; behind "tip/":
        counted from the tip.
    low, high : ends of what is printed, in ``unit`` (SI size); equal for one number.
    from_tip : m; where it is hit, None: the whole report is asked.
    closing : m/s; None: the sport's usual hit.
    """

    source: str
    what: str
    printed: str
    name: str
    answer: str
    low: float
    high: float
    unit: float = 1.0
    from_tip: float | None = None
    closing: float | None = None


VALUES = (
    Value("russell_bendsweet", "frequency of mode 2, Hz", "670", "youth-30", "modes/1/frequency", 670, 670),
    Value("russell_bendsweet", "frequency of mode 3, Hz", "1252", "youth-30", "modes/2/frequency", 1252, 1252),
    Value("russell_batvibes", "frequency of mode 1, Hz", "170", "r161-ash", "modes/0/frequency", 170, 170),
    Value("russell_batvibes", "node of mode 1, in from the knob", "about 6", "r161-ash", "modes/0/nodes/0", 5.5,
          6.5, INCH),
    Value("nathan2003", "greatest q, in from the tip", "4 to 6", "r161-ash",
          "tip/sweet_spots/max_collision_efficiency", 4, 6, INCH),
    Value("nathan2011corked", "greatest q at 164 mph", "0.214", "r161-ash", "collision_efficiency", 0.214, 0.214,
          from_tip=6.7 * INCH, closing=164 * MPH),
    Value("nathan_slides", "exit speed per pitch speed and bat speed: q", "0.2", "r161-ash",
          "best_hit/collision_efficiency", 0.2, 0.2),
    Value("hockey2012", "q 2 cm from the toe, 19 m/s", "-0.32 ± 0.05", "hockey-stick", "collision_efficiency", -0.37,
          -0.27, from_tip=0.02, closing=19.0),
    Value("hockey2012", "q on the shaft, 16 m/s", "-0.18 ± 0.02", "hockey-stick", "collision_efficiency", -0.20, -0.16,
          from_tip=0.25, closing=16.0),
    Value("cross_cricket", "node of mode 1, cm from the toe", "about 15", "cricket-bat", "tip/sweet_spots/node_1",
          14.5, 15.5, 0.01),
    Value("cross1999racket", "contact time at 5 m/s, ms", "about 5", "tennis-racket", "contact_time", 4.5, 5.5, 1e-3,
          from_tip=0.16, closing=5.0),
    Value("trackman_tour", "ball speed of the driver, mph", "167", "golf-driver", "best_hit/exit_speed", 166.5,
          167.5, MPH),
    Value("golf_smash_tour", "smash factor", "1.48 to 1.49", "golf-driver", "best_hit/smash_factor", 1.48, 1.49),
    Value("cohen2015", "contact time of a shuttle, ms", "1", "badminton-racket", "contact_time", 0.5, 1.5, 1e-3,
          from_tip=0.13, closing=20.0),
)  # fmt: skip


@cache
def analysed(name: str) -> Analysis[Implement]:
    """Return an implement's analysis under its sport's usual conditions."""
    implement = catalog.load_implement(name)
    return analyse(implement, standard_conditions(implement))


@cache
def reported(name: str) -> ReportAnswer:
    """Return an implement's report with intervals."""
    analysis = analysed(name)
    return report_of(analysis, sources_of(analysis.bat, analysis.conditions), drawn=True)


def interval(value: Value) -> tuple[float, float, float]:
    """Return what the program says of it and the ends of its interval, in the value's unit."""
    analysis = analysed(value.name)
    if value.from_tip is None:
        found: Any = reported(value.name)
    else:
        assert value.closing is not None
        place, swing, thrown = (
            analysis.bat.length - value.from_tip,
            analysis.conditions.swing,
            value.closing / 2,
        )
        still = analysis.conditions.replaced(
            pitch=analysis.conditions.pitch.replaced(speed=thrown),
            swing=swing.replaced(
                bat_speed=(value.closing - thrown) * (swing.measured_at - swing.pivot) / (place - swing.pivot)
            ),
        )  # fmt: skip
        question = HitQuestion(analysis.bat, still, place, sources=sources_of(analysis.bat, still))
        with insisting(True):  # on the shaft, which is no face
            found = hit_answer(question)
    for step in value.answer.removeprefix("tip/").split("/"):
        found = found[int(step)] if step.isdigit() else getattr(found, step)
    sure: Interval = analysis.bat.length - found if value.answer.startswith("tip/") else found
    return sure.value / value.unit, sure.low / value.unit, sure.high / value.unit


def main(arguments: Sequence[str] | None = None) -> int:
    """Print a row for every value, and how many are held."""
    options = argparse.ArgumentParser(description=__doc__)
    options.add_argument("--only", help="values of this implement")
    only = options.parse_args(arguments).only
    values = [value for value in VALUES if only in (None, value.name)]
    held = 0
    print("| source | what | of | printed | ours | 90 % interval | held |\n| --- | --- | --- | --- | --- | --- | --- |")
    for value in values:
        said, least, most = interval(value)
        holds = least <= value.high and value.low <= most
        held += holds
        where = f"[{value.source}](#source-{value.source})"
        print(f"| {where} | {value.what} | `{value.name}` | {value.printed} | {said:.4g} | {least:.4g} to {most:.4g} | "
              f"{'yes' if holds else 'no'} |", flush=True)  # fmt: skip
    print(f"\n{held} of {len(values)} are held")
    return 0


if __name__ == "__main__":
    sys.exit(main())

"""Do the intervals of answers hold what was published? Values that nothing was fitted to, of bats and other kinds.

Each line asks the draws of `--uncertainty` as the source did. A value printed as a range counts as held where the
interval and the range meet, and "about 6" is 5.5 to 6.5. What a bat or a ball of the catalogue was fitted to is left
out.

Run: .venv/bin/python -m studies.published_intervals [--only NAME]. Exit 1 when the share of all values that are held
is not within 85 to 95 %.
"""

from __future__ import annotations

import argparse
import os
import sys
from collections.abc import Callable, Mapping, Sequence
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
        counted from the tip, behind "middle/" and "throat/" from there on a racket's face.
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
    Value("curtis2021", "moment about the handle's end, kg m²", "0.3512 ± 2 %", "cricket-bat", "bat/moi_knob", 0.3442,
          0.3582),
    Value("king2020", "shuttle speed over head speed", "1.59 ± 0.06", "badminton-racket", "best_hit/smash_factor", 1.53,
          1.65),
    Value("twu_power", "q at the center, 22 m/s", "41 %", "tennis-racket", "collision_efficiency", 0.39, 0.43,
          from_tip=0.16, closing=22.0),
    Value("twu_power", "q toward the tip, 22 m/s", "22 %", "tennis-racket", "collision_efficiency", 0.18, 0.26,
          from_tip=0.06, closing=22.0),
    Value("twu_power", "q near the throat, 22 m/s", "51 %", "tennis-racket", "collision_efficiency", 0.49, 0.53,
          from_tip=0.28, closing=22.0),
    Value("twu_power", "fastest shots, in from the middle to the tip", "0 to 3", "tennis-racket",
          "middle/sweet_spots/max_exit_speed", 0, 3, INCH),
    Value("usrsa_acor", "q at the center, 22 m/s", "0.45", "tennis-racket", "collision_efficiency", 0.425, 0.475,
          from_tip=0.16, closing=22.0),
    Value("usrsa_acor", "q at the tip, 22 m/s", "0.1", "tennis-racket", "collision_efficiency", 0.05, 0.15,
          from_tip=0.05, closing=22.0),
    Value("usrsa_acor", "q at the throat, 22 m/s", "0.50", "tennis-racket", "collision_efficiency", 0.475, 0.525,
          from_tip=0.28, closing=22.0),
    Value("cross_tennis", "node of mode 1, cm from the middle to the tip", "near", "tennis-racket",
          "middle/sweet_spots/node_1", -3, 3, 0.01),
    Value("cross1997dead", "best bounce, cm from the throat", "about 5", "tennis-racket",
          "throat/sweet_spots/max_collision_efficiency", 3.5, 6.5, 0.01),
    Value("mcdowell2005", "best hit, mph", "83.3 to 99.2", "slow-pitch", "best_hit/exit_speed", 83.3, 99.2, MPH),
    Value("nathan2003", "ball-bat restitution in the sweet zone", "0.45 to 0.50", "r161-ash", "best_hit/bbcor", 0.45,
          0.50),
    Value("nathan2011corked", "greatest q, corked, at 164 mph", "0.193", "corked-r161", "collision_efficiency", 0.193,
          0.193, from_tip=6.7 * INCH, closing=164 * MPH),
    Value("nathan_slides", "contact time, ms", "less than 1", "r161-ash", "best_hit/contact_time", 0.5, 1, 1e-3),
    Value("russell_impulse", "contact time, ms", "0.7", "r161-ash", "best_hit/contact_time", 0.65, 0.75, 1e-3),
    Value("fih_rules", "q of a lawful stick 5 cm from the toe, 22 m/s", "at most -0.02", "hockey-stick",
          "collision_efficiency", -0.6, -0.02, from_tip=0.05, closing=22.0),
    Value("cohen2015", "contact time of a shuttle, ms", "1", "badminton-racket", "contact_time", 0.5, 1.5, 1e-3,
          from_tip=0.13, closing=20.0),
)  # fmt: skip


ORIGINS: Mapping[str, Callable[[Any], tuple[float, float]]] = {
    "tip": lambda implement: (implement.length, -1.0),
    "middle": lambda racket: (racket.outline.middle, 1.0),
    "throat": lambda racket: (racket.outline.start, 1.0),
}
"""Where a place is counted from, m from the knob end, and +1 towards the tip or -1."""
LEAST, MOST = 0.85, 0.95


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
    *start, rest = value.answer.split("/", 1) if value.answer.partition("/")[0] in ORIGINS else (value.answer,)
    for step in rest.split("/"):
        found = found[int(step)] if step.isdigit() else getattr(found, step)
    origin, sign = ORIGINS[start[0]](analysis.bat) if start else (0.0, 1.0)
    sure: Interval = sign * (found - origin)
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
    share = held / len(values)
    print(f"\n{held} of {len(values)} are held: {100 * share:.0f} %")
    return 0 if LEAST <= share <= MOST or only else 1


if __name__ == "__main__":
    sys.exit(main())

"""What to measure so that an answer becomes surer, in a sentence."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from sweetspot.answers.worth_measuring import WorthMeasuring
from sweetspot.calibration.measurements import MeasuredKind
from sweetspot.reports.sentences import Sentence, Slot, listed, say

MUCH = 0.7
"""Part of an interval that a measurement may leave to be worth a sentence [our choice]."""
AS_WELL = 1.15
"""Times the narrowest interval within which less work does as well [our choice]."""
HOW_TO: Mapping[MeasuredKind, str] = {
    "mass": "weigh {it}",
    "balance_point": "balance {it} on an edge",
    "moi": "time how {it_swings} from a pivot (sweetspot pendulum)",
}


def what_to_measure(worth: Sequence[WorthMeasuring], half: float, *, beside: str = "") -> Sentence:
    """Return the least work that narrows an interval much; nothing where nothing does that.

    Parameters
    ----------
    half : of the interval now, in m/s.
    beside : label of the implement that is compared with the first one; "": there is one implement alone.
    """
    least = min((float(each.half_interval) for each in worth), default=half)
    if not worth or not least <= MUCH * half:  # without sources the interval is 0, and nothing narrows it
        return say("")
    chosen = next(each for each in worth if float(each.half_interval) <= AS_WELL * least)
    its = "it" if not beside else "both" if len(chosen.implements) > 1 else chosen.implements[0]
    swings = f"{its} swing" if its == "both" else f"{its} swings"
    ways = listed([HOW_TO[kind].format(it=its, it_swings=swings) for kind in chosen.measured])
    return say(" To know it within {half}, {ways}.", half=Slot(chosen.half_interval, "speed"), ways=ways)

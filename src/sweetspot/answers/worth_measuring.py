"""What to measure on implements so that an answer becomes surer, as people ask for it."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

from sweetspot.answers.records import Speed
from sweetspot.calibration.measurements import MeasuredKind
from sweetspot.numerics.interval import REACH
from sweetspot.uncertainty.worth_measuring import Narrowing


@dataclass(frozen=True)
class WorthMeasuring:
    """What to measure on which implements, and half of the interval of the answer's speed once that is done."""

    measured: tuple[MeasuredKind, ...]
    implements: tuple[str, ...]
    half_interval: Speed


def worth_measuring_of(narrowings: Iterable[Narrowing], labels: Sequence[str]) -> tuple[WorthMeasuring, ...]:
    """Return narrowings with the labels of their implements."""
    return tuple(
        WorthMeasuring(each.measured, tuple(labels[number] for number in each.of), REACH * each.error)
        for each in narrowings
    )

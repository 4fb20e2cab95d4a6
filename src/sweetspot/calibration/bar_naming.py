"""The names of a bar's tones: bent across its thickness or its width, or twisted."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace

from sweetspot.calibration.bar import FASTEST_WOOD, SPEED, SPEEDS, Bar
from sweetspot.calibration.naming import NamedTone, named, uniform_bar
from sweetspot.calibration.ring import Tone


def named_bar(bar: Bar, tones: Sequence[Tone]) -> tuple[NamedTone, ...]:
    """Return a bar's tones with their modes; of a plate without names.

    Twists are named anew once E is known, for G is then known better.
    """
    if bar.is_plate:
        return tuple(NamedTone(tone, None, None) for tone in tones)
    slowest, fastest = SPEEDS[0], FASTEST_WOOD if bar.is_wood else SPEEDS[1]
    families = uniform_bar(
        bar.usual_tones, sideways=bar.sideways_tones, twist=bar.twist_tones,
        farthest=(math.log(slowest / SPEED), math.log(fastest / SPEED)),
    )  # fmt: skip
    first = named(tones, families, doubt=0.0)  # what is told is E, which another name of a twist does not change
    usual = dict(zip(families[0].names, families[0].frequency, strict=True))
    scales = [math.log(one.tone.frequency.value / usual[one.name]) for one in first if one.name in usual]
    if not scales:
        return first
    scale = math.exp(sum(scales) / len(scales))
    tied = replace(families[1], frequency=scale * families[1].frequency, spread=bar.usual_ratio.error / 2)
    again = iter(named([one.tone for one in first if one.name not in usual], [tied], doubt=0.0))
    return tuple(one if one.name in usual else replace(next(again), expected=None) for one in first)

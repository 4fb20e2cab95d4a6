"""How balls without an exit speed bias what is said of those with one."""

from __future__ import annotations

from dataclasses import dataclass

from sweetspot.season.survey import Survey


@dataclass(frozen=True)
class Untracked:
    """What the untracked balls would change.

    Parameters
    ----------
    share : part of the balls in play that have no exit speed.
    tracked : mean exit speed of those that have, m/s.
    estimated : mean of all, if untracked balls are like tracked ones that ended alike, as far out, m/s.
    explained : part of the untracked balls for whose ending there are tracked ones.
    """

    share: float
    tracked: float
    estimated: float
    explained: float


def untracked_bias(survey: Survey) -> Untracked | None:
    """Return how the mean exit speed changes when untracked balls count as tracked ones that ended alike.

    Alike are event, kind of hit and how far out a ball was fielded; where none came down there, the first two.
    None where no table has endings, or every ball was tracked.

    Parameters
    ----------
    survey : the first look at the tables.
    """
    tracked = sum(count for count, _, _ in survey.endings.values())
    missed = sum(count for _, _, count in survey.endings.values())
    if not tracked or not missed:
        return None
    mean = sum(total for _, total, _ in survey.endings.values()) / tracked
    alike: dict[str, tuple[int, float]] = {}
    for (words, _), (count, total, _) in survey.endings.items():
        before = alike.get(words, (0, 0.0))
        alike[words] = (before[0] + count, before[1] + total)
    told, explained = 0.0, 0
    for (words, _), (count, total, lost) in survey.endings.items():
        balls, speeds = (count, total) if count else alike[words]
        told += lost * (speeds / balls if balls else mean)
        explained += lost if balls else 0
    estimated = (mean * tracked + told) / (tracked + missed)
    return Untracked(missed / (tracked + missed), mean, estimated, explained / missed)

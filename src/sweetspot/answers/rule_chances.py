"""How probable it is that a bat keeps a rule: by draws of a simulated test, or by the errors of measured shots."""

from __future__ import annotations

import numpy as np

from sweetspot.analysis.certification.rules import Check, Rule
from sweetspot.analysis.certification.shot_statistics import Estimate, ShotStatistics
from sweetspot.numerics.arrays import Array
from sweetspot.numerics.interval import REACH
from sweetspot.uncertainty.drawn_tests import DrawnTest

OF_SHOTS = ("bbcor", "bpf", "batted_ball_speed")
"""Quantities of rules that shots estimate, as fields of `ShotStatistics`."""
BY_RECOIL = ("bbcor", "bpf")
"""Those that are worked out with the bat's moment of inertia."""
NODES = 2001
"""Moments of inertia, equally probable, over which a probability is averaged."""


def chance_of_draws(check: Check, drawn: DrawnTest) -> float | None:
    """Return the part of the draws that keep a rule's limits; None where draws do not answer what it limits."""
    margins = drawn_margin(check, drawn)
    return None if margins is None else float(np.mean(margins[1:] >= 0))


def drawn_margin(check: Check, drawn: DrawnTest) -> Array | None:
    """Return the margin of every draw to a rule's nearer limit, shape (draws,); None for quantities without draws."""
    values = drawn.of_rule(check.rule.quantity) if _is_limited(check) else None
    if values is None:
        return None
    sides = [sign * (values - limit) for sign, limit in _limits(check.rule)]
    return np.asarray(np.min(sides, axis=0))


def _is_limited(check: Check) -> bool:
    return check.margin is not None and bool(_limits(check.rule))


def _limits(rule: Rule) -> list[tuple[int, float]]:
    """Return a rule's limits with the side of each on which it is kept."""
    return [(sign, limit) for sign, limit in ((1, rule.least), (-1, rule.most)) if limit is not None]


def chance_by_shots(check: Check, measured: ShotStatistics) -> float | None:
    """Return the probability that a rule is kept by the standard error of shots; None where they do not estimate it."""
    rule = check.rule
    if not _is_limited(check) or rule.quantity not in OF_SHOTS:
        return None
    estimate: Estimate | None = getattr(measured, rule.quantity)
    if estimate is None or not estimate.standard_error > 0:
        return None
    by_moi = measured.by_moi / REACH * estimate.mean if rule.quantity in BY_RECOIL else 0.0
    return within_limits(estimate, rule.least, rule.most, by_moi=by_moi)


def within_limits(estimate: Estimate, least: float | None, most: float | None, *, by_moi: float = 0.0) -> float:
    """Return the probability that what shots estimate lies within limits.

    The mean follows Student's t of its standard error, and what a moment of inertia in doubt adds is normal.

    Parameters
    ----------
    by_moi : one standard deviation that the moment leaves open, in the estimate's unit; 0: it was measured.
    """
    import scipy.special

    nodes = NODES if by_moi else 1
    off = by_moi * scipy.special.ndtri((np.arange(nodes) + 0.5) / nodes)

    def below(limit: float) -> float:
        apart = (limit - estimate.mean - off) / estimate.standard_error
        return float(np.mean(scipy.special.stdtr(max(estimate.count - 1, 1), apart)))

    return (1.0 if most is None else below(most)) - (0.0 if least is None else below(least))

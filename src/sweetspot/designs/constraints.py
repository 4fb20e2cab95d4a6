"""Constraints on a bat: bands of weight and balance, a league's rules, the lathe; and steps that satisfy them."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import lru_cache
from itertools import combinations

import numpy as np

from sweetspot.analysis.certification.rules import Finding, League, applies, construction_findings
from sweetspot.analysis.certification.simulated_test import Certification, certify
from sweetspot.designs.gain import present_measured
from sweetspot.designs.measures import MEASURES, Bench, MeasuredDesigns, weights_of
from sweetspot.designs.turned import TurnedSpace
from sweetspot.designs.variables import ranges, sizes_of
from sweetspot.dynamics.batch.bending import mass_properties
from sweetspot.dynamics.beam import beam_model
from sweetspot.dynamics.rigid import rigid_body
from sweetspot.equipment.ball import Ball
from sweetspot.equipment.bat import Bat
from sweetspot.equipment.implement import Implement
from sweetspot.errors import InputError
from sweetspot.numerics.arrays import Array

STEEPEST = 0.16
"""Greatest slope of the radius that is asked of a lathe without more ado (assumed; turned bats stay below 0.1)."""
SHARPEST = 4.0
"""Greatest bend of the outline in 1/m: a radius of 25 cm (assumed; the chisel's own is far smaller)."""
ROUNDING = 1e-6
"""Grains by which a value may lie beyond an end: rounding of units, nothing else."""
INSIDE = 1.0
"""Grains by which the bat that a search begins with stays inside its limits."""
STARTS = 3
ROUNDS = 6
STEP = 1e-4
"""Part of a variable's range by which it is moved for a slope."""
PULLED = 1e-3
"""Weight with which the pulled number itself may change, beside 1 for the others."""
WITHIN = 0.001
"""Part of a value by which what is kept may still differ [our choice]: less than a scale tells, so that no gain comes
from a heavier or lighter bat."""
GRIP_WITHIN = 0.002
"""The same for the grip, which hands know better."""
AS_IT_IS = "kept as it is"
"""Why such a limit holds."""
KEPT = ("mass", "moi", "balance_point", "handle", "density")
"""What can be kept as it is, the last of wood alone; the length always is."""


@dataclass(frozen=True)
class Limit:
    """A measure with its ends.

    ``measure``: key of `MEASURES`. ``least``, ``most``: SI; None: none on that side. ``why``: who wants it: the batter,
    a league, the lathe.
    """

    measure: str
    least: float | None
    most: float | None
    why: str

    def __post_init__(self) -> None:
        if self.measure not in MEASURES:
            raise InputError(f"a limit on {self.measure!r} is not known; allowed are {', '.join(MEASURES)}")
        if self.least is None and self.most is None:
            raise InputError(f"a limit on {self.measure} has no end; give least, most or both")
        if self.least is not None and self.most is not None and self.least > self.most:
            raise InputError(
                f"the limit on {MEASURES[self.measure].label} goes from {_number(self.least, self.measure)} down to "
                f"{_number(self.most, self.measure)}; give the smaller end first"
            )

    def excess(self, values: Array) -> Array:
        """Return the excess of values over the nearer end in grains: above 0 outside, shape (n,)."""
        grain = MEASURES[self.measure].grain
        below = -np.inf if self.least is None else (self.least - values) / grain
        above = -np.inf if self.most is None else (values - self.most) / grain
        return np.maximum(below, above) + 0 * values - ROUNDING


def league_limits(league: League, bat: Implement) -> tuple[Limit, ...]:
    """Return the limits of a league that an outline, a weight or a pendulum decides, for bats like this one."""
    return tuple(
        Limit(rule.quantity, rule.least, rule.most, league.name)
        for rule in league.rules
        if applies(rule, bat) and rule.quantity in MEASURES and (rule.least is not None or rule.most is not None)
    )


def lathe_limits() -> tuple[Limit, ...]:
    """Return the limits that a lathe sets to an outline."""
    return (
        Limit("slope", None, STEEPEST, "the lathe"),
        Limit("bend", None, SHARPEST, "the lathe"),
        Limit("waist", None, 2e-4, "the turner: one swelling"),
    )


def band(measure: str, value: float, *, part: float, why: str = AS_IT_IS) -> Limit:
    """Return a limit around a value (``part``: half of the band's width as a part of the value)."""
    return Limit(measure, value * (1 - part), value * (1 + part), why)


def drawn_values(bench: Bench, numbers: Array) -> dict[str, Array]:
    """Return the measures that need no hit, of many rows of numbers: quicker than `Bench.measured` by far."""
    numbers = np.atleast_2d(numbers)
    return bench.space.shapes(numbers) | weights_of(mass_properties(bench.space.beams(numbers)))


def check_limits(bench: Bench, limits: Sequence[Limit]) -> Array:
    """Return numbers of a bat that keeps every limit that a drawing decides, shape (variables,)."""
    drawn = [limit for limit in limits if not MEASURES[limit.measure].needs_hits and limit.measure not in IN_PLAY]
    closest, miss = _nearest(bench, drawn)
    if miss <= INSIDE:
        return closest
    for size in (1, 2):
        worst: tuple[float, tuple[Limit, ...], Array] | None = None
        for some in combinations(drawn, size):
            nearest, gap = _nearest(bench, some)
            if gap > INSIDE and (worst is None or gap > worst[0]):
                worst = gap, some, nearest
        if worst is not None:
            raise InputError(_quarrel(bench, worst[1], worst[2]))
    raise InputError(
        "no bat keeps all limits together, though every two of them go together; widen one of: "
        + ", ".join(MEASURES[limit.measure].label for limit in drawn)
    )


IN_PLAY = ("bat_speed", "swing_time")


def _nearest(bench: Bench, limits: Sequence[Limit]) -> tuple[Array, float]:
    """Return the numbers that miss the limits by least, and their worst miss in grains (up to `INSIDE`: none)."""
    from scipy.optimize import minimize

    variables = bench.space.variables
    low, high = ranges(variables)
    width = high - low

    def misses(parts: Array) -> Array:
        values = drawn_values(bench, low + np.clip(parts, 0, 1) * width)
        return np.array([limit.excess(values[limit.measure]) + INSIDE for limit in limits])

    def total(parts: Array) -> tuple[float, Array]:
        here, slopes = _with_slopes(lambda rows: (np.maximum(misses(rows), 0.0) ** 2).sum(axis=0)[None], parts, 1e-5)
        return float(here[0]), slopes[0]

    start = np.clip((bench.space.start - low) / width, 0.02, 0.98)
    best, worst = start, float(misses(start[None]).max(initial=-np.inf))
    generator = np.random.default_rng(1)
    for number in range(STARTS):
        if worst <= INSIDE:
            break
        begin = start if number == 0 else generator.random(len(start))
        solution = minimize(
            total, begin, jac=True, method="L-BFGS-B", bounds=[(0.0, 1.0)] * len(start), options={"maxiter": 200}
        )
        gap = float(misses(solution.x[None]).max())
        if gap < worst:
            best, worst = solution.x, gap
    return low + best * width, worst


def _quarrel(bench: Bench, limits: Sequence[Limit], numbers: Array) -> str:
    """Return the limits that cannot be kept, and the nearest values."""
    values = drawn_values(bench, numbers)
    limits_words = " and ".join(
        f"{MEASURES[limit.measure].label} {_band_words(limit)} ({limit.why})" for limit in limits
    )
    near = " and ".join(near_words(limit, values[limit.measure]) for limit in limits)
    if len(limits) == 1:
        return f"no bat here has a {limits_words}; the nearest that can be is {near}. Widen it, or let more change"
    return f"these two limits exclude each other: {limits_words}. The nearest bat has {near}. Widen one of them"


def near_words(limit: Limit, value: Array) -> str:
    """Return a value and by how much it misses a limit."""
    miss = max(float(limit.excess(value)[0]), 0.0) * MEASURES[limit.measure].grain
    near, gap = _number(float(value[0]), limit.measure), _number(miss, limit.measure)
    return f"{MEASURES[limit.measure].label} {near}, which misses by {gap}"


def _band_words(limit: Limit) -> str:
    low, high = (None if end is None else _number(end, limit.measure) for end in (limit.least, limit.most))
    if low is None:
        return f"at most {high}"
    if high is None:
        return f"at least {low}"
    return f"from {low} to {high}"


def _number(value: float, measure: str) -> str:
    from sweetspot.units import INCH, OUNCE, OUNCE_INCH_SQUARED, grouped

    scale = MEASURES[measure].scale
    if scale in ("length", "place"):
        return f"{value / INCH:.2f} in ({1e3 * value:.1f} mm)"
    if scale == "mass":
        return f"{value / OUNCE:.2f} oz ({1e3 * value:.0f} g)"
    if scale == "moi":
        return f"{grouped(value / OUNCE_INCH_SQUARED)} oz in² ({value:.4f} kg m²)"
    return f"{value:.4g}"


def kept_limits(
    bench: Bench,
    keep: Sequence[str],
    *,
    bands: Sequence[Limit] = (),
    league: League | None,
    handle: float | None = None,
    now: MeasuredDesigns | None = None,
) -> tuple[Limit, ...]:
    """Return the limits of a question about the bats of a bench.

    ``league``: whose rules are kept; None: no league's. ``handle``: smallest diameter of the grip, m; None: the present
    one's, so that the bat breaks no sooner. ``now``: the present bat, measured on this bench; None: it is measured
    here.
    """
    present = bench.space.present
    values = (now or present_measured(bench)).values
    limits = [band(name, float(values[name][0]), part=WITHIN) for name in keep if name != "handle" and name in values]
    limits += bands
    if league is not None:
        left_out = set() if bench.tested else {"bbcor", "bpf"}
        if "cup_diameter" not in {variable.name for variable in bench.space.variables}:
            left_out.add("cup_diameter")  # the cup keeps its width
        limits += [limit for limit in league_limits(league, present) if limit.measure not in left_out]
    if isinstance(bench.space, TurnedSpace):
        if "handle" in keep:
            limits.append(band("handle", float(values["handle"][0]), part=GRIP_WITHIN))
        else:
            least = float(values["handle"][0]) if handle is None else handle
            limits.append(Limit("handle", 0.999 * least, None, "breaking"))
        limits += lathe_limits()
    return tuple(limits)


def nearest_within_limits(bench: Bench, numbers: Array, limits: Sequence[Limit], *, pulled: int | None = None) -> Array:
    """Return numbers near those of a bat that keep some limits, as far as the ranges let them.

    Every round goes to the nearest ends of the limits' bands by the smallest change, counted in parts of the ranges,
    that the slopes ask for (Newton's method with the least norm), and leaves in place what earlier rounds went
    to. Numbers that meet the end of their range stay there.

    ``numbers``: of the bat as it was pulled, shape (variables,). ``pulled``: the number that a hand holds, which
    changes last; None: none is held.
    """
    low, high = ranges(bench.space.variables)
    width = high - low
    parts = np.clip((np.asarray(numbers, float) - low) / width, 0.0, 1.0)
    ready = np.ones(len(parts))
    if pulled is not None:
        ready[pulled] = PULLED
    grains = np.array([MEASURES[limit.measure].grain for limit in limits])

    def values(rows: Array) -> Array:
        drawn = drawn_values(bench, low + rows * width)
        return np.array([drawn[limit.measure] for limit in limits]).reshape(len(limits), len(rows))

    held: set[int] = set()
    for _ in range(ROUNDS):
        here, slopes = _with_slopes(values, parts, STEP)
        broken = [row for row, limit in enumerate(limits) if float(limit.excess(here[row : row + 1])[0]) > 0]
        if not broken:
            break
        held |= {*broken}
        rows = sorted(held)
        miss = np.array([_distance_inside(limits[row], float(here[row])) if row in broken else 0.0 for row in rows])
        slopes = slopes[rows] / grains[rows, None]
        parts = _least_step(parts, slopes, miss, ready)
    return np.asarray(low + parts * width)


def _with_slopes(values: Callable[[Array], Array], parts: Array, step: float) -> tuple[Array, Array]:
    """Return values, shape (k,), of many rows at once, (k, rows), and their central differences, shape (k, parts)."""
    count, steps = len(parts), step * np.eye(len(parts))
    every = values(np.concatenate([parts[None], parts + steps, parts - steps]))
    return every[:, 0], (every[:, 1 : count + 1] - every[:, count + 1 :]) / (2 * step)


def _distance_inside(limit: Limit, value: float) -> float:
    """Return the distance of a value to just inside its limit, in grains."""
    grain = MEASURES[limit.measure].grain
    if limit.least is not None and value < limit.least:
        return (limit.least - value) / grain + 0.01
    assert limit.most is not None
    return (limit.most - value) / grain - 0.01


def _least_step(parts: Array, slopes: Array, miss: Array, ready: Array) -> Array:
    """Return parts of the ranges after a step that makes up for what is missed; those at an end are left out of it."""
    free = np.ones(len(parts), bool)
    for _ in range(len(parts)):
        weight = np.where(free, ready, 0.0)
        some = slopes * weight
        step = weight * np.linalg.lstsq(some, miss, rcond=1e-9)[0] if free.any() else np.zeros(len(parts))
        beyond = free & ((parts + step < 0) | (parts + step > 1))
        if not beyond.any():
            return np.asarray(parts + step)
        parts = np.where(beyond, np.clip(parts + step, 0.0, 1.0), parts)
        miss = miss - slopes @ np.where(beyond, np.clip(step, -parts, 1 - parts), 0.0)
        free &= ~beyond
    return parts


def drawn_findings(implement: Implement) -> dict[str, Finding]:
    """Return the findings that a drawing and the weight hold, without any test."""
    if not isinstance(implement, Bat):
        return {name: Finding(size) for name, size in sizes_of(implement).items()}
    return construction_findings(implement, body=rigid_body(beam_model(implement)))


def findings_of(bat: Implement, measured: MeasuredDesigns, *, like: Implement, ball: Ball) -> dict[str, Finding]:
    """Return the findings to which rules apply: the drawing's own values, and BBCOR and BPF where it was fired at.

    ``like``: whose test says how much the ball's patch and the moment of inertia leave open of BBCOR and BPF: the bat
    itself, or one like it where there is no time for three tests of each.
    """
    drawn = drawn_findings(bat)
    values = {name: float(measured.values[name][0]) for name in ("bbcor", "bpf") if name in measured.values}
    left_open = _tested(like, ball).findings() if values and isinstance(like, Bat) else {}
    return {**drawn, **{name: left_open[name].moved_to(value) for name, value in values.items()}}


@lru_cache(maxsize=32)
def _tested(bat: Bat, ball: Ball) -> Certification:
    return certify(bat, ball=ball)

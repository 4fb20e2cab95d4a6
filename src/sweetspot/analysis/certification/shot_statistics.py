"""Statistics of measured shots: BBCOR at the best place, its uncertainty, outlying shots, and what a pass takes.

A limit holds for the greatest value along the bat, so a pass takes lower places on both sides of the best one; a fail
takes one place beyond the limit.
"""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from statistics import fmean, median, stdev

from sweetspot.analysis.certification.rules import Finding
from sweetspot.analysis.certification.shots import COR_SPEED, Shot, by_place
from sweetspot.analysis.certification.simulated_test import (
    BASEBALL_TEST,
    BBCOR_SPEED,
    BPF_SPEED,
    CLAMP,
    SwungTest,
    besr,
    bpf,
    swung_test,
)
from sweetspot.collision.closed_form import collision_efficiency, restitution_from_efficiency
from sweetspot.dynamics.rigid import RigidBody, effective_mass, moi_doubt
from sweetspot.equipment.ball import Ball
from sweetspot.equipment.bat import Bat
from sweetspot.errors import InputError
from sweetspot.numerics.interval import ENDS, REACH, ROBUST_SCALE
from sweetspot.plausibility import check
from sweetspot.tables.cells import BadRow
from sweetspot.units import INCH, MPH, format_length

BRACKET = 1.05 * INCH
"""m within which a place on either side of the best must have given less [our choice]."""
DEADEST = 0.02
"""Least q of a baseball at a bat's best place; less is a gate that did not see the ball come back [our choice]."""
LEAST_OF_BALL = 0.8
"""Of the ball's own restitution on a wall, which no bat's best place falls below: a wood bat has 1.03 [our choice]."""
MOST_UNUSED = 1 / 3
"""Part of a file's rows that may be left out of a pass [our choice]."""


@dataclass(frozen=True)
class Place:
    """Hits at one place: m from the knob end, how many, mean normalised BBCOR."""

    position: float
    count: int
    bbcor: float


def rows_doubt(used: int, unused: Sequence[BadRow]) -> str:
    """Return the reason why a file is no test of a bat: too many of its rows are no shots; "": it is a test."""
    if len(unused) <= MOST_UNUSED * (used + len(unused)):
        return ""
    (commonest, _), *_ = Counter(row.reason for row in unused).most_common(1)
    return (
        f"only {used} of {used + len(unused)} rows could be used, and a pass takes two thirds of them: mend the "
        f"file first (most often: {commonest})"
    )


def pass_doubt(
    places: Sequence[Place], best: Place, *, efficiency: float, ball_restitution: float, softball: bool, length: float
) -> str:
    """Return why a value within a limit is no pass yet, and what to shoot next; "": it is one.

    ``efficiency``: q there. ``softball``: whether q may be as small as a heavy ball makes it. ``length``: of the bat,
    m.
    """
    tip = length - best.position
    if best.bbcor < LEAST_OF_BALL * ball_restitution or (efficiency < DEADEST and not softball):
        return (
            f"the best place, {format_length(tip)} from the tip, gave q {efficiency:.4f} and a ball-bat restitution of "
            f"{best.bbcor:.3f}, where a wall gives {ball_restitution:.3f}: no bat is so dead where it hits best. "
            "Either its best place was not hit, or the gate that times the rebound, its unit or the end that places "
            "are counted from is wrong; shoot at 5, 6 and 7 in from the tip"
        )
    missing = [text for side in (1, -1) if (text := _not_lower(places, best, side, length))]
    if not missing:
        return ""
    return (
        f"the greatest value, {format_length(tip)} from the tip, may be greater beside it: {' and '.join(missing)}; "
        "shoot six balls there, until the best place lies between two that give less"
    )


def _not_lower(places: Sequence[Place], best: Place, side: int, length: float) -> str:
    """Return the fault on the side of the tip (1) or of the hands (-1); "" where a nearby place gave less."""
    where = "nearer to the tip" if side > 0 else "nearer to the hands"
    near = [place for place in places if 0 < side * (place.position - best.position) <= BRACKET]
    if not near:
        return f"{format_length(length - best.position - side * INCH)} from the tip, {where}, was not hit"
    if any(place.bbcor < best.bbcor for place in near):
        return ""
    nearest = min(near, key=lambda place: abs(place.position - best.position))
    return f"{format_length(length - nearest.position)} from the tip, {where}, gave no less"


VALID_HITS = 6
"""Hits that the mean at the best location takes [ncaa_bbcor]."""
SAME_PLACE = INCH / 8
"""m; hits within this stretch count as hits at one place. Our choice."""
SPEED_TOLERANCE = 0.05
"""Part by which the speed of a shot may differ from the test's; our choice, for the standard's was not read."""
OUTLIER = 3.5
"""Robust standard deviations beyond which a hit is named."""
FINEST = 0.001
"""Least robust standard deviation of BBCOR; smaller ones are rounding."""
FAR_FROM_TEST = 0.25
"""Part by which the speed of shots differs from the test's when a column in another unit is suspected."""


@dataclass(frozen=True)
class Estimate:
    """A mean with its standard error and 90 % interval (Student's t), from ``count`` values."""

    mean: float
    standard_error: float
    low: float
    high: float
    count: int


@dataclass(frozen=True)
class MeasuredShot:
    """A shot with its measures; ``normalised`` is BBCOR with a ball of standard restitution."""

    shot: Shot
    efficiency: float
    bbcor: float
    normalised: float


@dataclass(frozen=True)
class Outlier:
    """A hit that stands out at the best place: its row, its BBCOR, robust standard deviations from the median."""

    row: int
    bbcor: float
    deviation: float


@dataclass(frozen=True)
class ShotStatistics:
    """The measures of a bat from shots.

    Parameters
    ----------
    best_position : m from the knob end: greatest mean BBCOR among places with two hits or more.
    bbcor : normalised where the balls' restitution was measured.
    efficiency : q that goes with `bbcor`.
    bpf : as measured at 60 mph, over each ball's own restitution there; None where the shots do not give it.
    batted_ball_speed : m/s.
    without_outliers : BBCOR without the hits that stand out; None where none does.
    standard_restitution : ball restitution that BBCOR is normalised to; None: not normalised.
    slowest, fastest : closing speeds at the best place, m/s.
    ball_stiffness : mean N/m at the best place, reported and not corrected for; None: not measured.
    doubt_within : why a value within a limit is no pass yet, and what to shoot next; "": it is one.
    by_moi : half of the 90 % interval of BBCOR, as a part of it, that a moment of inertia computed from the outline
        leaves open; 0: it was measured.
    """

    places: tuple[Place, ...]
    best_position: float
    rows: tuple[int, ...]
    bbcor: Estimate
    raw_bbcor: Estimate
    efficiency: Estimate
    bpf: Estimate | None
    swung: SwungTest
    batted_ball_speed: Estimate
    outliers: tuple[Outlier, ...]
    without_outliers: Estimate | None
    standard_restitution: float | None
    slowest: float
    fastest: float
    ball_stiffness: float | None
    notes: tuple[str, ...]
    by_moi: float = 0.0
    doubt_within: str = ""

    def findings(self) -> dict[str, Finding]:
        """Return the measures as rules take them, with the reason where the shots cannot decide."""
        few = ""
        if self.bbcor.count < VALID_HITS:
            few = f"the rule takes the mean of {VALID_HITS} valid hits; the best place has {self.bbcor.count}"
        fast, slow = self._speed_doubt(BBCOR_SPEED), self._speed_doubt(BPF_SPEED)
        low, high = besr(self.efficiency.low), besr(self.efficiency.high)
        values = {
            "bbcor": self._finding(self.bbcor, fast or few),
            "besr": Finding(besr(self.efficiency.mean), fast, (low, high), doubt_within=self.doubt_within),
            "batted_ball_speed": Finding(
                self.batted_ball_speed.mean, self._speed_doubt(self.swung.closing_speed), doubt_within=self.doubt_within
            ),
            "bpf": Finding(None, slow or "the file has no ball_cor, which BPF is a ratio to"),
        }
        if self.bpf is not None:
            values["bpf"] = self._finding(self.bpf, "")
        return values

    def _finding(self, value: Estimate, doubt: str) -> Finding:
        """Return a measure that is worked out with the moment of inertia."""
        by_moi = self.by_moi * value.mean
        interval = (
            value.mean - math.hypot(value.mean - value.low, by_moi),
            value.mean + math.hypot(value.high - value.mean, by_moi),
        )
        of = "the 90 % interval, in which the moment of inertia was not measured" if by_moi else Finding.interval_is
        return Finding(value.mean, doubt, interval, interval_is=of, doubt_within=self.doubt_within)

    def _speed_doubt(self, speed: float) -> str:
        if _near(self.slowest, speed) and _near(self.fastest, speed):
            return ""
        message = (
            f"the shots closed at {self.slowest / MPH:.1f} to {self.fastest / MPH:.1f} mph, and the limit holds for "
            f"{speed / MPH:.0f} mph"
        )
        other_unit = ", which looks like a column of speeds in another unit"
        return message + (other_unit if abs(self.fastest / speed - 1) > FAR_FROM_TEST else "")


def measure(
    shots: Iterable[Shot],
    *,
    bat: Bat,
    body: RigidBody,
    ball: Ball,
    standard_restitution: float | None = None,
    unused: Sequence[BadRow] = (),
) -> ShotStatistics:
    """Return BBCOR, BESR, BPF and batted-ball speed at the best place, with uncertainty.

    Each shot gives q, and BBCOR = q (1 + r) + r about the clamp 6 in from the knob. Where the ball's own restitution
    was measured, BBCOR is multiplied by standard over measured restitution: ball-bat restitution grows with the
    ball's, as BPF supposes. The exact normalisation of [astm_f2219] was not read.

    ``body``: the bat's mass, balance and moment of inertia. ``standard_restitution``: to normalise to, in (0, 1]; None:
    the ball's at 60 mph.
    """
    shots = list(shots)
    standard = ball.restitution.at(COR_SPEED) if standard_restitution is None else standard_restitution
    if not 0 < standard <= 1:
        raise InputError(f"the standard ball's restitution was given as {standard:g}; allowed is above 0, up to 1")
    given = [shot.ball_cor is not None for shot in shots]
    if any(given) and not all(given):
        raise InputError("only some of the shots have a ball_cor; give it for all of them or for none")
    groups = [
        [_hit(shot, body=body, ball=ball, standard=standard) for shot in group]
        for group in by_place(shots, within=SAME_PLACE)
    ]
    _check_bbcor([hit for group in groups for hit in group])
    best = _best(groups)
    values = [hit.normalised for hit in best]
    outliers = _outliers(best)
    named = {outlier.row for outlier in outliers}
    remaining = [hit.normalised for hit in best if hit.shot.row not in named]
    efficiency = estimate([_normalised_efficiency(hit, body, ball) for hit in best])
    swung = swung_test(bat, ball)
    speeds = [swung.batted_ball_speed(_normalised_efficiency(hit, body, ball)) for hit in best]
    slow = all(_near(hit.shot.closing_speed, BPF_SPEED) for hit in best)
    pairs = [(hit.bbcor, hit.shot.ball_cor) for hit in best if slow and hit.shot.ball_cor is not None]
    factors = [bpf(value, ball_restitution=cor) for value, cor in pairs]
    by_moi = _by_moi(best, bat, body, ball)
    stiff = [hit.shot.ball_stiffness for hit in best if hit.shot.ball_stiffness is not None]
    return ShotStatistics(
        places=tuple(_place(group) for group in groups),
        best_position=_place(best).position,
        rows=tuple(sorted(hit.shot.row for hit in best)),
        bbcor=estimate(values),
        raw_bbcor=estimate([hit.bbcor for hit in best]),
        efficiency=efficiency,
        bpf=estimate(factors) if factors else None,
        swung=swung,
        batted_ball_speed=estimate(speeds),
        outliers=outliers,
        without_outliers=estimate(remaining) if outliers and len(remaining) > 1 else None,
        standard_restitution=standard if all(given) else None,
        slowest=min(hit.shot.closing_speed for hit in best),
        fastest=max(hit.shot.closing_speed for hit in best),
        ball_stiffness=fmean(stiff) if stiff else None,
        notes=_notes(groups, best, by_moi=by_moi, normalised=all(given), stiff=bool(stiff)),
        by_moi=by_moi,
        doubt_within=rows_doubt(len(shots), unused)
        or pass_doubt(
            [_place(group) for group in groups],
            _place(best),
            efficiency=efficiency.mean,
            ball_restitution=ball.restitution.at(fmean(hit.shot.closing_speed for hit in best)),
            softball=swung != BASEBALL_TEST,
            length=bat.length,
        ),
    )


def estimate(sample: Iterable[float]) -> Estimate:
    """Return mean, standard error and Student's 90 % interval of two values or more.

    >>> average = estimate([0.49, 0.50, 0.51])
    >>> round(average.mean, 3), round(average.high - average.mean, 4)  # t(2) = 2.920, times 0.01 / sqrt(3)
    (0.5, 0.0169)
    """
    from scipy.special import stdtrit

    values = sorted(sample)
    if len(values) < 2:
        raise InputError(f"{len(values)} value; an uncertainty takes two or more")
    mean, error = fmean(values), stdev(values) / math.sqrt(len(values))
    reach = float(stdtrit(len(values) - 1, ENDS[1])) * error
    return Estimate(mean, error, mean - reach, mean + reach, len(values))


def _near(speed: float, wanted: float) -> bool:
    return wanted * (1 - SPEED_TOLERANCE) <= speed <= wanted * (1 + SPEED_TOLERANCE)


def _recoil(shot: Shot, body: RigidBody, ball: Ball) -> float:
    mass = ball.mass if shot.ball_mass is None else shot.ball_mass
    return mass / effective_mass(body, shot.position, pivot=CLAMP)


def _by_moi(best: list[MeasuredShot], bat: Bat, body: RigidBody, ball: Ball) -> float:
    """Return the relative uncertainty of BBCOR = q (1 + r) + r, r = m z^2 / I, from a moment of inertia in doubt."""
    part = REACH * moi_doubt(bat, body, CLAMP) / body.moi(CLAMP)
    return part * fmean((1 + hit.efficiency) * _recoil(hit.shot, body, ball) / hit.bbcor for hit in best)


def _hit(shot: Shot, *, body: RigidBody, ball: Ball, standard: float) -> MeasuredShot:
    efficiency = shot.collision_efficiency
    restitution = restitution_from_efficiency(efficiency, recoil=_recoil(shot, body, ball))
    factor = 1.0 if shot.ball_cor is None else standard / shot.ball_cor
    return MeasuredShot(shot, efficiency, restitution, restitution * factor)


def _check_bbcor(hits: list[MeasuredShot]) -> None:
    """Raise `InputError` where a row gives a ball-bat restitution that cannot be, or that is not usual."""
    for hit in hits:
        if max(hit.bbcor, hit.normalised) >= 1:
            raise InputError(
                f"row {hit.shot.row} gives a BBCOR of {hit.normalised:.3g}; allowed is below 1, where ball and bat "
                "part as fast as they met. Check the speeds, the ball's restitution and the bat's moment of inertia"
            )
        check(hit.normalised, f"the BBCOR of row {hit.shot.row}", f"{hit.normalised:.3g}", quantity="bbcor")


def _normalised_efficiency(hit: MeasuredShot, body: RigidBody, ball: Ball) -> float:
    return collision_efficiency(hit.normalised, recoil=_recoil(hit.shot, body, ball))


def _place(group: list[MeasuredShot]) -> Place:
    return Place(fmean(hit.shot.position for hit in group), len(group), fmean(hit.normalised for hit in group))


def _best(groups: list[list[MeasuredShot]]) -> list[MeasuredShot]:
    repeated = [group for group in groups if len(group) > 1]
    if not repeated:
        count = sum(len(group) for group in groups)
        raise InputError(
            f"{count} good {'shot' if count == 1 else 'shots, each at another place'}: no uncertainty can be given; "
            f"repeat the best place until it has {VALID_HITS} valid hits, two at the very least"
        )
    return max(repeated, key=lambda group: _place(group).bbcor)


def _outliers(hits: list[MeasuredShot]) -> tuple[Outlier, ...]:
    """Return hits far from the median in median absolute deviations; none of fewer than four hits."""
    if len(hits) < 4:
        return ()
    middle = median(hit.normalised for hit in hits)
    scale = max(ROBUST_SCALE * median(abs(hit.normalised - middle) for hit in hits), FINEST)
    outliers = [Outlier(hit.shot.row, hit.normalised, (hit.normalised - middle) / scale) for hit in hits]
    return tuple(sorted((each for each in outliers if abs(each.deviation) > OUTLIER), key=lambda each: each.row))


def _notes(
    groups: list[list[MeasuredShot]], best: list[MeasuredShot], *, by_moi: float, normalised: bool, stiff: bool
) -> tuple[str, ...]:
    top = _place(best)
    facts: Mapping[str, bool] = {
        "The balls' own restitution was not measured (column ball_cor): BBCOR is not normalised to a standard ball.": (
            not normalised
        ),
        f"The bat's moment of inertia is computed from its outline, not measured: by it BBCOR is known to "
        f"± {by_moi * top.bbcor:.3f} only. Give moi in the bat file.": by_moi > 0,
        "Ball stiffness is reported; no correction for it is made.": stiff,
        "A place hit only once gave a greater BBCOR than the best place; repeat it.": any(
            len(group) == 1 and group[0].normalised > top.bbcor for group in groups
        ),
    }
    return tuple(text for text, holds in facts.items() if holds)

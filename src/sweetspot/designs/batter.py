"""The batter: the distribution of contacts along and across the bat, its uncertainty, and the swing."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from functools import cache

import numpy as np

from sweetspot.catalog.records import read_table
from sweetspot.collision.contact_table import tabled_bat
from sweetspot.collision.hit_in_space import Contact
from sweetspot.equipment.ball import Ball
from sweetspot.equipment.bat import Bat
from sweetspot.errors import InputError
from sweetspot.motion.ball_motion import BallMotions
from sweetspot.motion.swing_law import SwingLaw
from sweetspot.motion.swing_path import Swings, path_axes
from sweetspot.numerics.arrays import Array, IntArray
from sweetspot.units import DEGREE, INCH, format_length

FROM_TIP = np.arange(0.25, 13.0, 0.5) * INCH
"""m from the tip where every bat is hit."""
FARTHEST = 16 * INCH
LAST = FROM_TIP[-1] + 0.25 * INCH
LEAST_INSIDE = 2 / 3
"""Least part of the contacts that has to lie where hits are computed."""
PRIORS = "player_priors.toml"
USUAL_OF = ("position", "position_spread", "offset", "offset_spread")
SHAPE_BALLS = 20
"""Balls that a normal curve counts for beside a table's own shape (assumed: fewer show none)."""
SPREADS = np.linspace(-4.0, 4.0, 161)
"""Standard deviations of the prior at which the scatter of places is looked at."""
MEANS, MEAN_SHARES = np.polynomial.hermite_e.hermegauss(7)
"""Points of the mean for every scatter, in its standard deviations, and their weights."""
RARE = 0.02
"""Part of the contacts on either side that is left out: the farthest of a scatter would be met once in a career."""
USUAL_PLACES = 8
ATTACK, TILT, DESCENT = 9 * DEGREE, 35 * DEGREE, 6 * DEGREE
"""Usual attack angle and tilt of the swing and descent of the pitch; the part kept hardly depends on them (assumed)."""
SINES = np.linspace(0.0, 0.97, 33)
WIDTHS = np.linspace(0.0, 0.15, 301)
"""m; places thicker than that keep what the thickest keeps. No barrel is; a flat face keeps everything at any width."""
REACH = 2.0
"""Standard deviations of the offset that are looked at; contacts farther off are not counted."""
OFFSETS, OFFSET_SHARES = np.polynomial.legendre.leggauss(24)
"""Of the mean over offsets on one side of the axis."""


@dataclass(frozen=True)
class ContactPlaces:
    """Where a batter meets the ball.

    Parameters
    ----------
    weight : part of the contacts at every place of `FROM_TIP`, shape (places,), summing to 1.
    possible : such parts, of batters who may be the one who met these balls, shape (ways, places); none: no doubt.
    likely : probability of each of them, shape (ways,).
    balls : how many were seen; 0: none.
    """

    weight: Array
    possible: Array
    likely: Array
    balls: float

    @property
    def mean(self) -> float:
        """Mean place, m from the tip."""
        return float(self.weight @ FROM_TIP)

    @property
    def mean_doubt(self) -> float:
        """Standard deviation in m of where the mean lies."""
        return self.doubt_of(FROM_TIP)

    @property
    def spread(self) -> float:
        """Standard deviation of places in m, without what is not known of their mean."""
        whole = float(self.weight @ (FROM_TIP - self.mean) ** 2)
        return float(np.sqrt(max(whole - self.mean_doubt**2, 0.0)))

    def doubt_of(self, curve: Array) -> float:
        """Return the standard deviation of a curve's mean over the contacts, from not knowing the contacts better."""
        means = self.possible @ curve
        return float(np.sqrt(self.likely @ (means - self.likely @ means) ** 2))


@cache
def usual_batter() -> dict[str, float]:
    """Return the middles in m of what is known of players before any swing, by name (`player_priors.toml`)."""
    return {name: _prior(name)[0] for name in USUAL_OF}


def normal_contact(mean: float, spread: float) -> Array:
    """Return parts of contacts at `FROM_TIP` of a batter who meets the ball ``mean`` ± ``spread`` m from the tip."""
    if not 0 < mean < FARTHEST:
        raise InputError(
            f"contact is {format_length(mean)} from the tip; allowed is more than 0 and less than "
            f"{format_length(FARTHEST)}"
        )
    if not 0.1 * INCH <= spread <= 6 * INCH:
        raise InputError(
            f"the contacts spread by {format_length(spread)}; allowed is {format_length(0.1 * INCH)} to "
            f"{format_length(6 * INCH)}"
        )
    ends = (-mean, LAST - mean)
    inside = 0.5 * (math.erf(ends[1] / spread / math.sqrt(2)) - math.erf(ends[0] / spread / math.sqrt(2)))
    if inside < LEAST_INSIDE:
        raise InputError(
            f"{1 - inside:.0%} of contacts {format_length(mean)} from the tip, give or take {format_length(spread)}, "
            f"lie beyond the outer 13 in of the bat, where hits are computed; allowed is up to {1 - LEAST_INSIDE:.0%}"
        )
    weight = np.exp(-(((FROM_TIP - mean) / spread) ** 2) / 2)
    return np.asarray(weight / weight.sum())


def known_contact(mean: float, spread: float) -> ContactPlaces:
    """Return the contacts of a batter whose mean and scatter are given without doubt; see `normal_contact`."""
    weight = normal_contact(mean, spread)
    return ContactPlaces(weight, weight[None], np.ones(1), 0.0)


def fitted_contact(mean: tuple[float, float], spread: tuple[float, float], *, balls: float) -> ContactPlaces:
    """Return the contacts of a batter whose mean and scatter were fitted, each with its doubt.

    ``mean``: m from the tip, and its standard deviation in m. ``spread``: standard deviation of places in m, and the
    standard deviation of its logarithm.
    """
    normal_contact(mean[0], spread[0])
    means = mean[0] + mean[1] * MEANS
    spreads = spread[0] * np.exp(spread[1] * MEANS)
    likely = MEAN_SHARES / MEAN_SHARES.sum()
    return _mixed(np.repeat(means, len(MEANS)), np.tile(spreads, len(MEANS)), np.outer(likely, likely).ravel(), balls)


def contacts_at(place: Array, share: Array | None = None) -> ContactPlaces:
    """Return the contacts of a batter of whom single ones are known, and what they leave open.

    Places are normal about a mean with a scatter, both of which are known of players before any ball: the mean is
    normal, the logarithm of the scatter is (`player_priors.toml`). The scatter's posterior is summed on a grid; the
    mean's is normal for each. A table's own shape counts by its balls beside `SHAPE_BALLS` of the normal curves.

    ``place``: m from the tip, shape (n,). ``share``: how much each counts, shape (n,): whole numbers count balls,
    others are shares of as many balls as (sum share)^2 / sum share^2; None: one ball each.
    """
    share = np.ones(len(place)) if share is None else share
    usable = (place >= 0) & (place <= LAST)
    if not np.any(share[usable] > 0) or np.any(share < 0):
        raise InputError("no contact on the outer 13 in of a bat was given; check its unit and its weights")
    place, share = place[usable], share[usable]
    whole = bool(np.all(share == np.round(share)))
    balls = float(share.sum() if whole else share.sum() ** 2 / (share**2).sum())
    edges = np.concatenate([FROM_TIP - 0.25 * INCH, [LAST]])
    counts, _ = np.histogram(place, bins=edges, weights=share)
    table = np.convolve(counts, [0.25, 0.5, 0.25], mode="same")  # a table knows places to half an inch
    mean = float(share @ place / share.sum())
    about = _posterior(mean, float(share @ (place - mean) ** 2 / share.sum()), balls)
    part = balls / (balls + SHAPE_BALLS)
    weight = part * table / table.sum() + (1 - part) * about.weight
    return ContactPlaces(weight, about.possible, about.likely, balls)


def _posterior(mean: float, variance: float, balls: float) -> ContactPlaces:
    """Return the normal contacts that balls of this mean (m) and variance (m^2) leave possible."""
    (middle, width), (usual, ratio) = _prior("position"), _prior("position_spread")
    noise = read_table(PRIORS)["fixed"].quantity("position_noise", "length")
    spread = usual * np.exp(ratio * SPREADS)
    seen = spread**2 + noise**2  # of marks
    log = -(SPREADS**2) / 2 - balls * variance / (2 * seen) - (balls - 1) / 2 * np.log(seen)
    log -= (mean - middle) ** 2 / (2 * (width**2 + seen / balls)) + np.log(width**2 + seen / balls) / 2
    likely = np.exp(log - log.max())
    precision = 1 / width**2 + balls / seen
    centre = (middle / width**2 + mean * balls / seen) / precision
    means = centre[:, None] + MEANS / np.sqrt(precision)[:, None]
    return _mixed(means.ravel(), np.repeat(spread, len(MEANS)), np.outer(likely, MEAN_SHARES).ravel(), balls)


def _mixed(mean: Array, spread: Array, likely: Array, balls: float) -> ContactPlaces:
    """Return the contacts of one of many normal batters, who is not known better."""
    usable = (mean > 0) & (mean < FROM_TIP[-1])
    mean, spread, likely = mean[usable], np.maximum(spread[usable], 0.1 * INCH), likely[usable] / likely[usable].sum()
    possible = np.exp(-(((FROM_TIP - mean[:, None]) / spread[:, None]) ** 2) / 2)
    possible /= possible.sum(axis=1, keepdims=True)
    return ContactPlaces(likely @ possible, possible, likely, balls)


@cache
def _prior(name: str) -> tuple[float, float]:
    """Return the middle in m of a number of players, and the width in m or, of a scatter, of its logarithm."""
    entry = read_table(PRIORS)[name]
    width = entry.quantity("width", "length" if entry["scale"] == "plain" else "ratio")
    return entry.quantity("centre", "length"), width


@dataclass(frozen=True)
class Batter:
    """A batter with the present bat.

    Parameters
    ----------
    weight : part of the contacts at every place of `FROM_TIP`, shape (places,), summing to 1.
    offset, offset_spread : mean and standard deviation of the ball's centre above the bat's axis, m.
    bat_speed : m/s with the present bat, ``speed_from_tip`` m from its tip.
    pitch_speed : m/s at the plate; 0: a tee.
    law : of bat speed against moment of inertia; None: every bat is swung alike.
    doubt : standard deviation in m of where the mean contact lies, beyond what ``sample`` leaves open.
    speed_from_tip : m.
    sample : what balls tell of the contacts, and leave open; None: the contacts were given by the user.
    """

    weight: Array
    offset: float
    offset_spread: float
    bat_speed: float
    pitch_speed: float
    law: SwingLaw | None
    doubt: float
    speed_from_tip: float = 6 * INCH
    sample: ContactPlaces | None = None

    @property
    def mean_contact(self) -> float:
        """Mean place of contact, m from the tip."""
        return float(self.weight @ FROM_TIP)

    def moved(self, distance: float) -> Batter:
        """Return the same batter who meets every ball ``distance`` m nearer the hands; what leaves the bat is lost."""
        weight = np.interp(FROM_TIP - distance, FROM_TIP, self.weight, left=0.0, right=0.0)
        return replace(self, weight=weight / weight.sum())


def usual_places(batter: Batter) -> IntArray:
    """Return indices of `FROM_TIP` that are evenly spaced over all but a batter's rarest contacts, shape (places,)."""
    before = np.cumsum(batter.weight) - batter.weight
    inside = np.flatnonzero((before + batter.weight > RARE) & (before < 1 - RARE))
    return np.asarray(inside[np.unique(np.linspace(0, len(inside) - 1, USUAL_PLACES).round().astype(int))])


def off_centre(bat: Bat, ball: Ball, batter: Batter) -> tuple[Array, Array]:
    """Return sines of the line of centres' angle, and the part of the head-on exit speed that is left at each.

    That angle alone counts, sin = offset / (radius of ball + radius of barrel): a barrel that is thinner where the ball
    is met is a little harder to hit well, and that is all that its width does here.

    ``bat``: the present one, met at this batter's mean place.
    """
    place = bat.length - batter.mean_contact
    reach = ball.radius + float(bat.diameter_at(place)) / 2
    both = np.concatenate([SINES, -SINES])
    pitch = max(batter.pitch_speed, 1e-6) * np.array([0.0, -math.cos(DESCENT), -math.sin(DESCENT)])
    launched = tabled_bat(bat, ball=ball).launches(
        swings=Swings(batter.bat_speed, path_axes(ATTACK, 0.0, tilt=TILT, left=False)),
        pitches=BallMotions(velocity=pitch, spin=np.zeros(3)),
        contact=Contact(place, both * reach),
    )
    left = np.nan_to_num(np.linalg.norm(launched.velocity, axis=-1)).reshape(2, len(SINES)).mean(axis=0)
    return SINES, left / left[0]


def retained_at_widths(sine: Array, retained: Array, *, batter: Batter, ball: Ball) -> Array:
    """Return the part of the exit speed that a batter's scatter about the axis leaves at `WIDTHS`.

    The mean over offsets within `REACH` standard deviations, by quadrature on either side of the axis up to the last
    sine: what is farther out is a miss. So the mean follows the width without steps.

    ``sine``, ``retained``: see `off_centre`.
    """
    from scipy.interpolate import PchipInterpolator

    part = PchipInterpolator(sine, retained)
    farthest = sine[-1] * (ball.radius + WIDTHS / 2) if sine[-1] < 1 else np.full(len(WIDTHS), np.inf)
    ends = batter.offset + batter.offset_spread * np.array([-REACH, REACH])
    averages = np.zeros(len(WIDTHS))
    for low, high in ((ends[0], min(0.0, ends[1])), (max(0.0, ends[0]), ends[1])):
        first, last = np.clip(low, -farthest, farthest), np.clip(high, -farthest, farthest)
        half = np.maximum(last - first, 0.0) / 2
        offset = ((first + last) / 2)[:, None] + half[:, None] * OFFSETS
        density = np.exp(-(((offset - batter.offset) / batter.offset_spread) ** 2) / 2)
        angle = np.abs(offset) / (ball.radius + WIDTHS / 2)[:, None]
        averages += half * ((part(angle) * density) @ OFFSET_SHARES)
    return np.asarray(averages / (batter.offset_spread * math.sqrt(2 * math.pi) * math.erf(REACH / math.sqrt(2))))

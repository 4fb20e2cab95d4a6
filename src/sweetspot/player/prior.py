"""Prior knowledge of a player before the first swing is read, and how its numbers are separated from the data's."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache
from typing import Literal, get_args

import numpy as np
from numpy.typing import NDArray

from sweetspot.catalog.records import read_table
from sweetspot.catalog.swing_laws import swing_law
from sweetspot.motion.swing_law import GREATEST_EXPONENT
from sweetspot.numerics.arrays import Array
from sweetspot.numerics.interval import REACH, Interval
from sweetspot.units import Kind

FILE = "player_priors.toml"
PARAMETERS: dict[str, Kind] = {
    "bat_speed": "speed",
    "bat_speed_spread": "speed",
    "exponent": "ratio",
    "position": "length",
    "position_spread": "length",
    "offset": "length",
    "offset_spread": "length",
    "attack_angle": "angle",
    "efficiency_shift": "ratio",
    "exit_noise": "speed",
}
"""Every parameter of a player in the order of all arrays, and what kind of quantity it is."""
NAMES = tuple(PARAMETERS)
FIXED: dict[str, Kind] = {
    "bat_speed_noise": "speed",
    "attack_angle_spread": "angle",
    "deflection_noise": "angle",
    "position_noise": "length",
    "swing_tilt": "angle",
    "swing_tilt_spread": "angle",
    "pitch_descent": "angle",
    "pitch_descent_spread": "angle",
    "pitch_backspin": "angular speed",
    "pitch_backspin_spread": "angular speed",
    "slow_part": "ratio",
    "slow_by": "speed",
    "slow_spread": "speed",
    "model_noise": "speed",
    "bat_description": "ratio",
}


Scale = Literal["plain", "ratio"]


@dataclass(frozen=True)
class Prior:
    """What is known of one parameter before any data.

    ``name``: of the parameter, in words. ``scale``: "plain": the value is normal; "ratio": its logarithm is.
    ``centre``: the most likely value, SI; the median. ``width``: standard deviation of the value, or of its logarithm.
    """

    name: str
    scale: Scale
    centre: float
    width: float


@cache
def priors() -> dict[str, Prior]:
    """Return the priors of all parameters, in the order of `NAMES`.

    The exponent's centre is the baseball law's; its width is that between single players of the softball study, for
    the baseball study's own spread is that of a mean.

    >>> priors()["exponent"].centre, priors()["exponent"].width
    (0.29, 0.085)
    """
    table = read_table(FILE)
    by_name = {}
    for name, kind in PARAMETERS.items():
        entry = table[name]
        scale = entry.choice("scale", get_args(Scale))
        centre = swing_law().exponent if name == "exponent" else entry.quantity("centre", kind)
        by_name[name] = Prior(entry.name, scale, centre, entry.quantity("width", "ratio" if scale == "ratio" else kind))
    return by_name


@cache
def fixed(name: str) -> float:
    """Return a value in SI that is not learned from the swings.

    >>> round(fixed("position_noise"), 4)
    0.0127
    """
    return read_table(FILE)["fixed"].quantity(name, FIXED[name])


def natural(standard: Array) -> Array:
    """Return parameters in SI from standard ones, whose prior is normal with mean 0 and standard deviation 1.

    theta = centre + width z, or centre exp(width z).

    ``standard``: shape (..., 10), in the order of `NAMES`.

    >>> natural(np.zeros(10))[2].item()
    0.29
    """
    return np.where(_ratios(), _centres() * np.exp(_widths() * standard), _centres() + _widths() * standard)


def standardised(values: Array) -> Array:
    """Return standard parameters from those in SI; the inverse of `natural`."""
    with np.errstate(invalid="ignore", divide="ignore"):
        return np.where(_ratios(), np.log(values / _centres()) / _widths(), (values - _centres()) / _widths())


@dataclass(frozen=True)
class Population:
    """How players differ, in standard parameters: normal distributions, one for each.

    ``mean``, ``spread``: shape (10,), in the order of `NAMES`.
    """

    mean: Array
    spread: Array


ANYBODY = Population(np.zeros(len(NAMES)), np.ones(len(NAMES)))
"""A player of whom nothing is known, not even the league: the prior itself."""


def population_range(population: Population) -> dict[str, Interval]:
    """Return the median of a population and the range of 90 % of its players by parameter, SI."""
    ends = np.array([natural(population.mean + side * population.spread) for side in (0.0, -REACH, REACH)])
    return {name: Interval(*part) for name, part in zip(NAMES, ends.T.tolist(), strict=True)}


def log_prior(standard: Array, population: Population = ANYBODY) -> Array:
    """Return the logarithm of the prior's density up to a constant; -inf for an exponent outside 0 to 1/2.

    ``standard``: shape (..., 10).
    """
    exponent = natural(standard)[..., NAMES.index("exponent")]
    allowed = (exponent >= 0) & (exponent <= GREATEST_EXPONENT)
    apart = (standard - population.mean) / population.spread
    return np.where(allowed, -0.5 * np.sum(apart**2, axis=-1), -np.inf)


def prior_draws(count: int, seed: int, population: Population = ANYBODY) -> Array:
    """Return draws from the prior, standard parameters, shape (count, 10)."""
    generator = np.random.default_rng(seed)
    draws = np.empty((0, len(NAMES)))
    while len(draws) < count:
        fresh = population.mean + population.spread * generator.standard_normal((2 * count, len(NAMES)))
        draws = np.concatenate([draws, fresh[np.isfinite(log_prior(fresh))]])
    return draws[:count]


@cache
def _ratios() -> NDArray[np.bool_]:
    return np.array([prior.scale == "ratio" for prior in priors().values()])


@cache
def _centres() -> Array:
    # a plain centre of 0 is never divided by: `np.where` takes the other branch
    return np.array([prior.centre for prior in priors().values()])


@cache
def _widths() -> Array:
    return np.array([prior.width for prior in priors().values()])

"""Young's modulus of a uniform bar from the tones of a tap, and what makes it uncertain; see `bar` for the formula."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Annotated

import numpy as np

from sweetspot.calibration.bar import ROOTS, SPEEDS, Bar, frequency_factor
from sweetspot.calibration.measured import Measured
from sweetspot.calibration.naming import Expected, ModeName, NamedTone
from sweetspot.calibration.ring import Tone
from sweetspot.errors import InputError
from sweetspot.numerics.arrays import Array
from sweetspot.units.dimensions import DENSITY, MODULUS

FORMULA_ERROR = 0.005
"""One sigma of ln E that a higher tone deserves beside its frequency's error: Goens' formula and an even section."""
STEP = 0.1
"""Of a standard error, in the derivatives."""


@dataclass(frozen=True)
class BarModulus:
    """Elastic constants of a bar.

    Parameters
    ----------
    modulus : Young's modulus E along the bar.
    modulus_ratio : E / G; hardly known from the first tone of a thin bar.
    budget : part of the variance of E that each source causes, adding up to 1.
    """

    density: Annotated[Measured, DENSITY]
    modulus: Annotated[Measured, MODULUS]
    modulus_ratio: Measured
    budget: Mapping[str, float]


def bar_modulus(bar: Bar, tones: Sequence[NamedTone]) -> BarModulus:
    """Return E of a bar from its bending tones, with the error that sizes, weight and tones leave.

    Raises
    ------
    InputError
        when no tone is a bending mode.
    """
    heard = [(one.name.harmonic - 1, one.tone.frequency) for one in tones if one.name and one.name.family == "bending"]
    if not heard:
        raise InputError("none of the tones is a bending mode of a bar; tap it in the middle, held at its nodes")
    sizes = {"length": bar.length, "width": bar.width, "thickness": bar.thickness, "mass": bar.mass}
    sources = {**sizes, **{f"bending {mode + 1}": tone for mode, tone in heard}, "E/G": bar.usual_ratio}
    given = np.array([one.value for one in sources.values()])
    ratio_error = bar.usual_ratio.error
    centre = _log_moduli(given, heard, ratio_error)
    errors = np.array([one.error for one in sources.values()])
    steps = STEP * errors
    moved = [(_log_moduli(given + step, heard, ratio_error) - centre) / STEP for step in np.diag(steps)]
    effects = np.array(moved)  # of one sigma of every source on ln E and ln E/G
    shares = effects[:, 0] ** 2
    modulus, ratio = np.exp(centre)
    deviations = np.sqrt(np.sum(effects**2, axis=0))
    return BarModulus(
        Measured(bar.density, bar.density * math.sqrt(sum(one.relative**2 for one in sizes.values()))),
        Measured(float(modulus), float(modulus * deviations[0])),
        Measured(float(ratio), float(ratio * deviations[1])),
        {name: float(share / shares.sum()) for name, share in zip(sources, shares, strict=True)},
    )


def modelled_tones(bar: Bar, fit: BarModulus) -> Expected:
    """Return the bending modes of a bar as its tones made it."""
    tones = bar.tones_at(math.sqrt(fit.modulus.value / bar.density), fit.modulus_ratio.value)
    names = tuple(ModeName("bending", number + 1) for number in range(len(tones)))
    return Expected(names, np.array(tones), np.ones(len(tones)), fit.modulus.relative / 2)


def moduli_along(bar: Bar, tones: Sequence[NamedTone]) -> tuple[tuple[Tone, Measured], ...]:
    """Return E in Pa for each tone that a plate surely has, were it the first that bends the plate along.

    Tones that would make sound run faster or slower than in solids are left out.
    """
    first = ModeName("bending", 1)
    moduli = [(one.tone, bar_modulus(bar, [NamedTone(one.tone, first, None)]).modulus) for one in tones if one.tone.own]
    slowest, fastest = SPEEDS
    return tuple(
        (tone, modulus) for tone, modulus in moduli
        if slowest < math.sqrt(modulus.value / bar.density) < fastest
    )  # fmt: skip


def _log_moduli(given: Array, heard: Sequence[tuple[int, Measured]], ratio_error: float) -> Array:
    """Return ln E and ln E/G by least squares for sizes, weight, frequencies and expected ln E/G in this order.

    Parameters
    ----------
    ratio_error : one sigma of the expected ln E/G.
    """
    from scipy.optimize import least_squares

    length, width, thickness, mass = given[:4]
    tones, expected = given[4:-1], given[-1]
    density = mass / (length * width * thickness)

    def misses(unknowns: Array) -> Array:
        misfits = []
        for (mode, measured), tone in zip(heard, tones, strict=True):
            factor = frequency_factor(mode, slenderness=thickness / length, modulus_ratio=math.exp(unknowns[1]))
            modulus = 48 * math.pi**2 * density * length**4 * tone**2 / thickness**2 / ROOTS[mode] ** 4 * factor
            misfits.append(
                (math.log(modulus) - unknowns[0]) / math.hypot(2 * measured.relative, FORMULA_ERROR * (mode > 0))
            )
        return np.array([*misfits, (unknowns[1] - expected) / ratio_error])

    return np.asarray(least_squares(misses, [math.log(1e10), expected], method="lm").x)

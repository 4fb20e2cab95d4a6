"""A uniform bar of rectangular section, and the tones that it rings.

E = (m_n^-4) 48 pi^2 rho L^4 f_n^2 / t^2 (1 + r (F1 + s (E/G) F2)) with r = t^2 / (12 L^2), F1 = theta^2 + 6 theta,
F2 = theta^2 - 2 theta, theta = m |tan(m/2)|, s = 6/5: Goens' solution of the Timoshenko beam without its smallest term
[goens1931]. For n = 1 and E/G = 2 it is the formula that ASTM E1876 gives for slender bars,
E = 0.9465 (m f^2 / b) (L / t)^3 (1 + 6.585 (t / L)^2) [astm_e1876].
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Annotated

import numpy as np

from sweetspot.calibration.measured import Measured
from sweetspot.calibration.mode_naming import ModeFamily, ModeName, NamedTone, named, uniform_bar
from sweetspot.calibration.recording import BAT_BAND, FrequencyBand
from sweetspot.calibration.taps import Tone
from sweetspot.errors import InputError
from sweetspot.numerics.arrays import Array
from sweetspot.units.dimensions import DENSITY, MODULUS

ROOTS = (4.730040745, 7.853204624, 10.995607838, 14.137165491, 17.278759657)
"""m_n, of cos m cosh m = 1."""
SHEAR_SHAPE = 1.2
"""s = 6/5 of a rectangle."""
MODULUS_RATIO = Measured(math.log(6.0), 0.8)
"""ln(E / G) before the tones say more: 2.6 of metals to about 20 of softwood, both within 1.4 sigma (assumed)."""
WOOD, WOOD_RATIO = (250.0, 850.0), Measured(math.log(13.0), 0.35)
"""kg/m^3 between which a bar is wood, and its ln(E / G): 7 of cherry to 22 of balsa are within 1.8 sigma (table of
elastic ratios in the Wood Handbook, recalled). Foams are lighter, plastics begin at 900."""
ISOTROPIC, ISOTROPIC_RATIO = 2000.0, Measured(math.log(2.6), 0.06)
"""kg/m^3 from which on a bar is metal, glass or ceramic and the same in all directions, and its ln(E / G): 2 (1 + nu)
is 2.4 to 2.88 for a Poisson's ratio of 0.2 of glass to 0.44 of lead (recalled). Fibre composites are lighter."""
SQUARE = 0.1
"""Logarithm of width over thickness below which bending across the width and across the thickness are confused."""
WIDEST_WOOD, WIDEST = 0.25, 0.4
"""Width over length, of wood and of anything else, from which on bars bend across too before they bend along the third
time, 5.4 times the first tone, at (L / W)^2 sqrt(E across / E along) of it. With a fifteenth for wood (a twelfth to a
twenty-fifth, recalled) that is 0.22, for metal with 1 it is 0.43; made-up strips were separated up to 0.25 (chosen on
them). The tones of wider plates cannot be assigned to modes by their ratios."""
THICKEST = 0.2
"""Of the length; a thicker bar is no beam."""
SPEED, SPEEDS = 4000.0, (1200.0, 12900.0)
"""sqrt(E / rho) in m/s of a bar before it is tapped: the middle of lead's and beryllium's, between which solids lie
(both recalled); steel, aluminium, glass and spruce along its grain have about 5,000."""
FASTEST_WOOD = 7000.0
"""m/s of the same along wood. Its hollow cells run along it, so no wood is stiffer for its weight than their walls:
half cellulose of 138 GPa along its chains, and 1,500 kg/m^3 (recalled), are 6,800; spruce reaches 6,300 (recalled)."""
SLOW, FAST = 0.6, 3.0
"""Times `SPEED`: between which the first tone is listened for; plastics and lead are slower, and need --band."""
LIGHTEST, DENSEST = 20.0, 23000.0
"""kg/m^3 of a bar, from foams to osmium (recalled): what lies outside is a slip of a unit."""


@dataclass(frozen=True)
class Bar:
    """A bar with rectangular section, m and kg; it is tapped across its thickness."""

    length: Measured
    width: Measured
    thickness: Measured
    mass: Measured

    def __post_init__(self) -> None:
        sizes = (self.length, self.width, self.thickness, self.mass)
        if min(size.value for size in sizes) <= 0:
            raise InputError("a bar's length, width, thickness and mass must be more than 0")
        if self.thickness.value > THICKEST * self.length.value:
            raise InputError(
                f"the bar is {1e3 * self.thickness.value:.4g} mm thick and {1e3 * self.length.value:.4g} mm long; "
                f"allowed is a thickness up to {THICKEST:g} of the length: give length x width x thickness"
            )
        if not LIGHTEST <= self.density <= DENSEST:
            raise InputError(
                f"the bar's sizes and mass give a density of {self.density:.3g} kg/m3; allowed is {LIGHTEST:g} to "
                f"{DENSEST:g}: check the units"
            )

    @property
    def density(self) -> float:
        """kg/m^3."""
        return self.mass.value / (self.length.value * self.width.value * self.thickness.value)

    @property
    def is_wood(self) -> bool:
        """Whether it is as dense as wood, which it is then taken for."""
        return WOOD[0] <= self.density <= WOOD[1]

    @property
    def usual_ratio(self) -> Measured:
        """ln(E / G) before the tones say more: what is as dense as wood or metal is taken for that."""
        if self.density >= ISOTROPIC:
            return ISOTROPIC_RATIO
        return WOOD_RATIO if self.is_wood else MODULUS_RATIO

    @property
    def usual_tones(self) -> tuple[float, ...]:
        """Hz, of the bending modes were sqrt(E / rho) `SPEED`; shear draws those of a thick wooden bar together."""
        return self.tones_at(SPEED, math.exp(self.usual_ratio.value))

    def tones_at(self, speed: float, modulus_ratio: float) -> tuple[float, ...]:
        """Return the frequencies of bending in Hz for sqrt(E / rho) in m/s and E / G."""
        slender = self.thickness.value * speed / (2 * math.pi * math.sqrt(12) * self.length.value**2)
        thick = self.thickness.value / self.length.value
        factors = [frequency_factor(mode, slenderness=thick, modulus_ratio=modulus_ratio) for mode in range(len(ROOTS))]
        return tuple(root**2 * slender / math.sqrt(factor) for root, factor in zip(ROOTS, factors, strict=True))

    @property
    def sideways_tones(self) -> tuple[float, ...]:
        """The same of bending across the width; none of a bar that is about square."""
        if abs(math.log(self.width.value / self.thickness.value)) < SQUARE:
            return ()
        if self.width.value > THICKEST * self.length.value:  # no beam in this direction
            return ()
        return replace(self, width=self.thickness, thickness=self.width).usual_tones

    @property
    def twist_tones(self) -> tuple[float, ...]:
        """Hz, of the torsional modes were sqrt(E / rho) `SPEED` and E / G usual.

        f_n = n / (2 L) sqrt(G J / (rho I_p)) sqrt(1 + (E/G) (w / L)^2 pi^2 (n - 1/2)^2 / 48): Saint-Venant's torsion of
        a rectangle, and that a wide one is held against warping; n - 1/2 stands for its free ends, and is within 3 %
        of Ritz's method for plates up to 0.2 as wide as long, the first four modes.
        """
        thin, wide = sorted((self.thickness.value, self.width.value))
        slender, ratio = wide / self.length.value, math.exp(self.usual_ratio.value)
        stiff = wide * thin**3 / 3 * (1 - 0.63 * thin / wide * (1 - (thin / wide) ** 4 / 12))
        polar = wide * thin * (wide**2 + thin**2) / 12
        first = SPEED / math.sqrt(ratio) * math.sqrt(stiff / polar) / (2 * self.length.value)
        return tuple(
            number * first * math.sqrt(1 + ratio * slender**2 * math.pi**2 * (number - 0.5) ** 2 / 48)
            for number in range(1, len(ROOTS) + 1)
        )

    @property
    def is_plate(self) -> bool:
        """Whether it is so wide that the ratios of its tones do not tell which is which."""
        return self.width.value > (WIDEST_WOOD if self.is_wood else WIDEST) * self.length.value

    @property
    def band(self) -> FrequencyBand:
        """Where to listen: the band of bats, and as far as the first tone of a slow or a fast solid asks for."""
        first = self.usual_tones[0]
        return FrequencyBand(min(BAT_BAND.low, SLOW * first), max(BAT_BAND.high, FAST * first))


def frequency_factor(mode: int, *, slenderness: float, modulus_ratio: float) -> float:
    """Return 1 + r (F1 + s (E/G) F2), the factor by which shear and rotation make E larger than by Euler's beam.

    >>> round(frequency_factor(0, slenderness=0.05, modulus_ratio=2.0), 4)  # ASTM E1876: 1 + 6.585 x 0.05^2
    1.0165
    """
    theta = ROOTS[mode] * abs(math.tan(ROOTS[mode] / 2))
    bending, shear = theta**2 + 6 * theta, theta**2 - 2 * theta
    return 1 + slenderness**2 / 12 * (bending + SHEAR_SHAPE * modulus_ratio * shear)


def named_bar(bar: Bar, tones: Sequence[Tone]) -> tuple[NamedTone, ...]:
    """Return a bar's tones with their modes; of a plate without names.

    Twists are named anew once E is known, for G is then known better.
    """
    if bar.is_plate:
        return tuple(NamedTone(tone, None, None) for tone in tones)
    slowest, fastest = SPEEDS[0], FASTEST_WOOD if bar.is_wood else SPEEDS[1]
    families = uniform_bar(
        bar.usual_tones,
        sideways=bar.sideways_tones,
        twist=bar.twist_tones,
        farthest=(math.log(slowest / SPEED), math.log(fastest / SPEED)),
    )
    first = named(tones, families, doubt=0.0)  # the result is E, which another name of a twist does not change
    usual = dict(zip(families[0].names, families[0].frequency, strict=True))
    scales = [math.log(named.tone.frequency.value / usual[named.name]) for named in first if named.name in usual]
    if not scales:
        return first
    scale = math.exp(sum(scales) / len(scales))
    tied = replace(families[1], frequency=scale * families[1].frequency, spread=bar.usual_ratio.error / 2)
    again = iter(named([named.tone for named in first if named.name not in usual], [tied], doubt=0.0))
    return tuple(named if named.name in usual else replace(next(again), expected=None) for named in first)


FORMULA_ERROR = 0.005
"""One sigma of ln E that a higher tone deserves beside its frequency's error: Goens' formula and an even section."""
STEP = 0.1
"""Of a standard error, in the derivatives."""


@dataclass(frozen=True)
class BarModulus:
    """Elastic constants of a bar.

    ``modulus``: Young's modulus E along the bar. ``modulus_ratio``: E / G; hardly known from the first tone of a thin
    bar. ``budget``: part of the variance of E that each source causes, adding up to 1.
    """

    density: Annotated[Measured, DENSITY]
    modulus: Annotated[Measured, MODULUS]
    modulus_ratio: Measured
    budget: Mapping[str, float]


def bar_modulus(bar: Bar, tones: Sequence[NamedTone]) -> BarModulus:
    """Return E of a bar from its bending tones, with the error that sizes, weight and tones leave."""
    heard = [
        (named.name.harmonic - 1, named.tone.frequency)
        for named in tones
        if named.name and named.name.family == "bending"
    ]
    if not heard:
        raise InputError("none of the tones is a bending mode of a bar; tap it in the middle, held at its nodes")
    sizes = {"length": bar.length, "width": bar.width, "thickness": bar.thickness, "mass": bar.mass}
    sources = {**sizes, **{f"bending {mode + 1}": tone for mode, tone in heard}, "E/G": bar.usual_ratio}
    given = np.array([source.value for source in sources.values()])
    ratio_error = bar.usual_ratio.error
    centre = _log_moduli(given, heard, ratio_error)
    errors = np.array([source.error for source in sources.values()])
    steps = STEP * errors
    moved = [(_log_moduli(given + step, heard, ratio_error) - centre) / STEP for step in np.diag(steps)]
    effects = np.array(moved)  # of one sigma of every source on ln E and ln E/G
    shares = effects[:, 0] ** 2
    modulus, ratio = np.exp(centre)
    deviations = np.sqrt(np.sum(effects**2, axis=0))
    return BarModulus(
        Measured(bar.density, bar.density * math.sqrt(sum(size.relative**2 for size in sizes.values()))),
        Measured(float(modulus), float(modulus * deviations[0])),
        Measured(float(ratio), float(ratio * deviations[1])),
        {name: float(share / shares.sum()) for name, share in zip(sources, shares, strict=True)},
    )


def modelled_tones(bar: Bar, fit: BarModulus) -> ModeFamily:
    """Return the bending modes of a bar as its tones made it."""
    tones = bar.tones_at(math.sqrt(fit.modulus.value / bar.density), fit.modulus_ratio.value)
    names = tuple(ModeName("bending", number + 1) for number in range(len(tones)))
    return ModeFamily(names, np.array(tones), np.ones(len(tones)), fit.modulus.relative / 2)


def moduli_along(bar: Bar, tones: Sequence[NamedTone]) -> tuple[tuple[Tone, Measured], ...]:
    """Return E in Pa for each tone that a plate surely has, were it the first that bends the plate along.

    Tones that would make sound run faster or slower than in solids are left out.
    """
    first = ModeName("bending", 1)
    moduli = [
        (named.tone, bar_modulus(bar, [NamedTone(named.tone, first, None)]).modulus)
        for named in tones
        if named.tone.distinct
    ]
    slowest, fastest = SPEEDS
    return tuple(
        (tone, modulus) for tone, modulus in moduli if slowest < math.sqrt(modulus.value / bar.density) < fastest
    )


def _log_moduli(given: Array, heard: Sequence[tuple[int, Measured]], ratio_error: float) -> Array:
    """Return ln E and ln E/G by least squares for sizes, weight, frequencies and expected ln E/G in this order."""
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

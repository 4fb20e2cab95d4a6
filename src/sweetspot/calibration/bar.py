"""A uniform bar of rectangular section, and the tones that it rings.

E = (m_n^-4) 48 pi^2 rho L^4 f_n^2 / t^2 (1 + r (F1 + s (E/G) F2)) with r = t^2 / (12 L^2), F1 = theta^2 + 6 theta,
F2 = theta^2 - 2 theta, theta = m |tan(m/2)|, s = 6/5: Goens' solution of the Timoshenko beam without its smallest term
[goens1931]. For n = 1 and E/G = 2 it is the formula that ASTM E1876 gives for slender bars,
E = 0.9465 (m f^2 / b) (L / t)^3 (1 + 6.585 (t / L)^2) [astm_e1876].
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

from sweetspot.calibration.measured import Measured
from sweetspot.calibration.recording import BAT_BAND, Band
from sweetspot.errors import InputError

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
"""Logarithm of width over thickness below which bending sideways cannot be told from bending across the thickness."""
WIDEST_WOOD, WIDEST = 0.25, 0.4
"""Width over length, of wood and of anything else, from which on bars bend across too before they bend along the third
time, 5.4 times the first tone, at (L / W)^2 sqrt(E across / E along) of it. With a fifteenth for wood (a twelfth to a
twenty-fifth, recalled) that is 0.22, for metal with 1 it is 0.43; made-up strips were told well up to 0.25 (chosen on
them). Of wider plates nobody can tell by ratios which tone is which."""
THICKEST = 0.2
"""Of the length; a thicker bar is no beam."""
SPEED, SPEEDS = 4000.0, (1200.0, 12900.0)
"""sqrt(E / rho) in m/s of a bar that nobody has tapped: the middle of lead's and beryllium's, between which solids lie
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
        if min(one.value for one in sizes) <= 0:
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
    def band(self) -> Band:
        """Where to listen: the band of bats, and as far as the first tone of a slow or a fast solid asks for."""
        first = self.usual_tones[0]
        return Band(min(BAT_BAND.low, SLOW * first), max(BAT_BAND.high, FAST * first))


def frequency_factor(mode: int, *, slenderness: float, modulus_ratio: float) -> float:
    """Return 1 + r (F1 + s (E/G) F2): by how much shear and rotation make E larger than Euler's beam says.

    Parameters
    ----------
    mode : 0, 1, ...
    slenderness : t / L.

    >>> round(frequency_factor(0, slenderness=0.05, modulus_ratio=2.0), 4)  # ASTM E1876: 1 + 6.585 x 0.05^2
    1.0165
    """
    theta = ROOTS[mode] * abs(math.tan(ROOTS[mode] / 2))
    bending, shear = theta**2 + 6 * theta, theta**2 - 2 * theta
    return 1 + slenderness**2 / 12 * (bending + SHEAR_SHAPE * modulus_ratio * shear)

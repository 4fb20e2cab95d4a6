"""Tennis and badminton rackets: a frame known by its weight, balance, swing weight and first frequency, and strings.

Positions are metres from the butt end; the head's tip is the far end. Stiffness and moving mass of a bed of crossed
strings follow from tension, number and size.
"""

from __future__ import annotations

import math
from functools import cached_property
from typing import Annotated

import numpy as np
from numpy.polynomial.polynomial import polyval
from numpy.typing import ArrayLike
from pydantic import Field, model_validator

from sweetspot.equipment.base import Positive, Validated
from sweetspot.equipment.face import MEMBRANE_MEAN, Face, FaceOutline
from sweetspot.equipment.implement import Implement, Look
from sweetspot.equipment.mass_fit import maximum_entropy_mass
from sweetspot.equipment.section import CrossSection
from sweetspot.equipment.shell import Stations, between, check_order
from sweetspot.numerics.arrays import Array
from sweetspot.numerics.gauss_legendre import quadrature

LENGTH_RANGE = (0.4, 0.8)
GYRATION = 0.008
"""m, of a frame's sections about their own middle; so small that its size hardly matters (assumed)."""
SHEAR_OVER_BENDING = 2000.0
"""1/m^2, kappa G A over E I of a thin carbon tube about 2 cm wide; frames bend, they hardly shear (assumed)."""
OVAL = 0.9
"""Rounds off the ends of an oval hoop's mass per length, 1 / sqrt(1 - u^2), which would be infinite there."""
HOOP = 1.3
"""Mass per length of a head's two tubes over that of the shaft, as drawn; the measured values bend it right."""
HANDLE_RADIUS = 0.015
"""m, of gyration of handle and shaft about the racket's axis (assumed)."""
PIECES = 24
"""Pieces between which mass and stiffness are integrated: exact to 1e-10."""


MEAN_CHORD = math.pi / 4
"""Mean length of an ellipse's chords over its axis."""


class StringBed(Validated):
    """Strings of a racket.

    Parameters
    ----------
    tension : N in each string as it is now, the mean of mains and crosses.
    mains, crosses : number of strings along and across the racket.
    linear_density : kg/m of one string.
    restitution : part of its speed that a hard ball without losses keeps on the bed of a clamped head.
    patch : m, radius of the round patch through which the ball pushes.
    """

    tension: Positive
    mains: Annotated[int, Field(ge=4, le=60)]
    crosses: Annotated[int, Field(ge=4, le=60)]
    linear_density: Positive
    restitution: Annotated[float, Field(gt=0, le=1)]
    patch: Positive

    def surface_tension(self, outline: FaceOutline) -> float:
        """Return the force per length in N/m of a membrane like the bed: the mean of both directions.

        sqrt((T n_m / w) (T n_c / l)) with n_m mains over the width w and n_c crosses over the length l.
        """
        along, across = self.mains / outline.width, self.crosses / (outline.end - outline.start)
        return self.tension * math.sqrt(along * across)

    def mass(self, outline: FaceOutline) -> float:
        """Return the mass of the bed in kg: every chord of the oval."""
        length = self.mains * (outline.end - outline.start) + self.crosses * outline.width
        return self.linear_density * MEAN_CHORD * length

    def face(self, outline: FaceOutline) -> Face:
        """Return the bed as a face: a stretched membrane of radius R, pushed evenly over a patch of radius a.

        k = 2 pi tau / (ln(R / a) + 1/4), exact for a round membrane with a small patch in its middle; the mass that
        moves with the patch is m_strings / (2 (ln(R / a) + 1/4)^2), from the membrane's slow deflection. Stretching of
        the strings is left out: it stiffens the bed under hard hits.
        """
        softness = math.log(outline.mean_radius / self.patch) + MEMBRANE_MEAN
        return Face(
            stiffness=2 * math.pi * self.surface_tension(outline) / softness,
            moving_mass=self.mass(outline) / (2 * softness**2),
            restitution=self.restitution,
            edge="membrane",
            patch=self.patch,
        )


class Racket(Implement):
    """A strung racket.

    Its mass per length is the drawn one, bent until mass, balance point and swing weight are the measured ones
    (`distribution.tilt`); its stiffness has the drawn shape and the size that gives it its first frequency.

    Raises `InputError` without strings, with more tension than the frame bears, or when the measured values do not go
    together.

    Parameters
    ----------
    name, length, sport, mass, balance_point, moi, moi_axis, choke : as for every `Implement`; mass, balance point and
        swing weight (``moi``) of the strung racket are needed.
    head : the string bed's outline; the frame reaches from there to the tip.
    strings : the string bed; a racket without one cannot hit.
    first_frequency : Hz, of bending mode 1 of the racket hung freely.
    damping : fraction of critical damping of its bending modes, in [0, 0.5).
    handle_length : m.
    relative_stiffness : (position, stiffness) stations over the whole length; only the ratios count. None: the same
        all along.
    twist_moi : measured moment of inertia about the long axis, kg m^2 ("twist weight"); None: from the mass at the
        sides of the head.
    greatest_tension : N per string that the frame is made for; None: not known.
    frame : what it is made of.
    """

    length: Annotated[float, Field(ge=LENGTH_RANGE[0], le=LENGTH_RANGE[1])]
    head: FaceOutline
    strings: StringBed | None = None
    first_frequency: Positive
    damping: Annotated[float, Field(ge=0, lt=0.5)] = 0.01
    handle_length: Positive
    relative_stiffness: Stations | None = None
    twist_moi: Positive | None = None
    greatest_tension: Positive | None = None
    frame: str = "carbon-fibre frame"

    @model_validator(mode="after")
    def _holds_together(self) -> Racket:
        if self.strings is None:
            raise ValueError(f"{self.name} has no strings; a racket without strings cannot hit: give [strings]")
        if self.greatest_tension is not None and self.strings.tension > self.greatest_tension:
            raise ValueError(
                f"the strings are at {self.strings.tension:.0f} N; the frame of {self.name} bears up to "
                f"{self.greatest_tension:.0f} N. String it softer"
            )
        if self.mass is None or self.balance_point is None or self.moi is None:
            raise ValueError(f"{self.name} needs mass, balance_point and swing weight (moi); measure all three")
        if not self.handle_length < self.head.start < self.head.end <= self.length:
            raise ValueError(
                f"the handle ends at {self.handle_length:.4g} m and the strings run from {self.head.start:.4g} m to "
                f"{self.head.end:.4g} m of a {self.length:.4g} m racket; allowed is one after the other"
            )
        if self.relative_stiffness is not None:
            check_order(self.relative_stiffness, "relative_stiffness")
            if min(stiffness for _, stiffness in self.relative_stiffness) <= 0:
                raise ValueError("relative_stiffness must be above zero everywhere")
        _ = self._tilt  # refuses measured values that do not go together
        return self

    @property
    def bed(self) -> StringBed:
        """The strings, which every racket that could be made has."""
        assert self.strings is not None  # refused at construction
        return self.strings

    @property
    def made_of(self) -> str:
        """Frame and tension."""
        return self.frame

    @property
    def look(self) -> Look:
        """Drawn like a laminate."""
        return "laminate"

    @property
    def damping_ratio(self) -> float:
        """As given."""
        return self.damping

    @property
    def frequency(self) -> float:
        """As measured."""
        return self.first_frequency

    @property
    def outline(self) -> FaceOutline:
        """The string bed's."""
        return self.head

    @cached_property
    def face(self) -> Face:
        """The string bed."""
        return self.bed.face(self.head)

    def breakpoints(self) -> tuple[float, ...]:
        """Return the ends of the pieces: handle, shaft, head and equal parts of them."""
        corners = {0.0, self.handle_length, self.head.start, self.length}
        corners.update(place for place, _ in self.relative_stiffness or () if 0 < place < self.length)
        return tuple(np.union1d(np.linspace(0, self.length, PIECES + 1), sorted(corners)).tolist())

    def width_at(self, position: ArrayLike) -> Array:
        """Return the width of handle, shaft and head with its rim in m."""
        places = np.asarray(position, float)
        rim = self.length - self.head.end
        half_length = (self.length - self.head.start + rim) / 2
        middle = self.length - half_length
        across = np.sqrt(np.maximum(1 - ((places - middle) / half_length) ** 2, 0.0)) * (self.head.width + 2 * rim)
        return np.maximum(np.where(places <= self.handle_length, 0.032, np.where(across > 0, 0.0, 0.02)), across)

    def section_at(self, position: Array, scale: Array) -> CrossSection:  # noqa: ARG002 - its mass is measured, not scaled
        """Return the sections at positions in m; stiffness is right up to one factor (see `frequency`)."""
        mass = self._mass_per_length(position)
        stiffness = self._stiffness(position)
        roll = mass * self._twist_factor * self._side_gyration(position) ** 2
        return CrossSection(mass, mass * GYRATION**2, stiffness, stiffness * SHEAR_OVER_BENDING, roll)

    def _drawn(self, position: Array) -> Array:
        """Return the drawn mass per length of frame and strings, up to a factor."""
        along = (position - self.head.middle) / (self.length - self.head.middle)
        hoop = HOOP / np.sqrt(1 - OVAL * np.minimum(along**2, 1.0))
        return np.where(position > self.head.start, hoop, 1.0)

    def _mass_per_length(self, position: Array) -> Array:
        return self._drawn(position) * np.exp(polyval(2 * position / self.length - 1, self._tilt))

    def _side_gyration(self, position: Array) -> Array:
        """Return the distance of the mass from the racket's axis at positions, m: in the head at its sides."""
        return np.where(
            position > self.head.start, np.maximum(self.width_at(position) / 2, HANDLE_RADIUS), HANDLE_RADIUS
        )

    def _stiffness(self, position: Array) -> Array:
        if self.relative_stiffness is None:
            return np.ones_like(position)
        return between(self.relative_stiffness, position)

    @cached_property
    def _tilt(self) -> Array:
        """The three numbers that bend the drawn distribution of mass to the measured one."""
        assert self.mass is not None and self.balance_point is not None and self.moi is not None
        places, weights = quadrature(self.breakpoints())
        about_butt = self.moi + 2 * self.moi_axis * self.mass * self.balance_point - self.moi_axis**2 * self.mass
        first, second = self.mass * self.balance_point, about_butt - self.mass * GYRATION**2
        targets = np.array(
            [
                self.mass,
                2 * first / self.length - self.mass,
                4 * second / self.length**2 - 4 * first / self.length + self.mass,
            ]
        )
        return maximum_entropy_mass(self._drawn, places=places, weights=weights, length=self.length, targets=targets)

    @cached_property
    def _twist_factor(self) -> float:
        """Factor on the mass at the sides that gives the measured twist weight."""
        if self.twist_moi is None:
            return 1.0
        places, weights = quadrature(self.breakpoints())
        return self.twist_moi / float(
            np.sum(weights * self._mass_per_length(places) * self._side_gyration(places) ** 2)
        )

"""The unknowns of a bat before it is measured, and the bat that follows from a guess of them.

Each unknown is the deviation of a logarithm (moduli, density, wall, diameters, masses at knob and end cap) from the
description, or of the density's gradient itself. Before any measurement it is normal with mean 0 and the spread that
the catalogue gives for the material, or that is assumed here. The catalogue's spread is that of a mean; one billet
scatters more, so it counts as one sigma. A solid bat carries a few grams of tape and paint at its knob.

A racket, cricket bat, club or stick is known by what is measured on it: weight, balance point, radius of gyration about
that point (from a swing weight or a pendulum) and the frequency of its first bending mode, to which its stiffness is
scaled. A paddle is known by mass, swing weight, the share of its rim round the tip, which twist weight tells, and the
shear modulus of its core, which its tones tell. A golf club is weighed by its parts: head and grip take the place of
the first three.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import lru_cache
from typing import Literal

import numpy as np

from sweetspot.catalog.materials import material_spreads
from sweetspot.dynamics.beam import BeamModel, beam_model
from sweetspot.dynamics.reduction import bending_frequencies
from sweetspot.dynamics.rigid import rigid_body
from sweetspot.equipment.bat import Bat, PointMass
from sweetspot.equipment.cricket_bat import CricketBat
from sweetspot.equipment.golf_club import GolfClub
from sweetspot.equipment.hockey_stick import HockeyStick
from sweetspot.equipment.implement import Implement
from sweetspot.equipment.paddle import Paddle
from sweetspot.equipment.racket import Racket
from sweetspot.equipment.shell import Stations
from sweetspot.errors import InputError
from sweetspot.numerics.arrays import Array

SPREADS = {"mass": 0.06, "balance_point": 0.04, "gyration": 0.06, "first_frequency": 0.2}
"""One sigma of the logarithms before anything is measured: implements of one kind differ so (assumed)."""
OF_CLUB = {"end_mass": 0.06, "knob_mass": 0.3, "first_frequency": 0.2}
"""The same of a golf club's head, grip and frequency (assumed)."""
OF_PADDLE = {"mass": 0.03, "swing_weight": 0.03, "rim": 0.4, "core_shear": 0.3}
"""The same of a paddle, of its swing weight at the same mass (assumed): usual are 7.5 to 8.5 oz and 100 to 124 kg cm^2,
twist weights of 6.5 to 8 from a rim half as heavy again round the tip or two thirds of it; cores have 5 to 14 MPa."""


def implement_spreads(implement: Implement) -> dict[str, float]:
    """Return the unknowns of an implement that is not a bat, and one sigma of the logarithm of each."""
    if isinstance(implement, Paddle):
        return dict(OF_PADDLE)
    if not isinstance(implement, (Racket, CricketBat, HockeyStick, GolfClub)):
        raise InputError(
            f"{implement.name} is known by its plies and rubbers; calibrate knows bats, rackets, paddles, cricket "
            "bats, hockey sticks and golf clubs"
        )
    return dict(OF_CLUB if isinstance(implement, GolfClub) else SPREADS)


def as_described(implement: Implement) -> BeamModel:
    """Return an implement's beam with all that is measured on it written down, as far as the description says it."""
    if isinstance(implement, Paddle):
        return beam_model(implement.replaced(added=(), calibrated=True, original=None).with_its_rim())
    beam = beam_model(implement.replaced(added=()))
    body = rigid_body(beam)
    written: dict[str, float] = {}
    if not isinstance(implement, Racket):
        written["first_frequency"] = float(bending_frequencies(beam, count=1)[0])
    if not isinstance(implement, (Racket, GolfClub)):
        written |= {"mass": body.mass, "balance_point": body.balance_point, "moi": body.moi(implement.moi_axis)}
    return beam_model(implement.replaced(calibrated=True, original=None, **written))


def implement_deviated(beam: BeamModel, deviations: Mapping[str, float]) -> BeamModel:
    """Return an implement's beam with these deviations of logarithms from what `as_described` returned."""
    factor = {name: math.exp(off) for name, off in deviations.items()}
    implement = beam.bat
    changes: dict[str, object] = {}
    if isinstance(implement, Paddle):
        assert implement.mass is not None
        assert implement.moi is not None
        heavier = factor.get("mass", 1.0)
        return beam_model(
            implement.replaced(
                mass=implement.mass * heavier,
                moi=implement.moi * heavier * factor.get("swing_weight", 1.0),
                rim_at_tip=implement.rim_at_tip * factor.get("rim", 1.0),
                core_shear=implement.core_shear * factor.get("core_shear", 1.0),
            )
        )
    frequency = implement.frequency
    assert frequency is not None  # written by as_described
    changes["first_frequency"] = frequency * factor.get("first_frequency", 1.0)
    if isinstance(implement, GolfClub):
        head = implement.head
        changes["head"] = head.replaced(mass=head.mass * factor.get("end_mass", 1.0))
        changes["grip_mass"] = implement.grip_mass * factor.get("knob_mass", 1.0)
        return beam_model(implement.replaced(**changes))
    mass, balance, moi, axis = implement.mass, implement.balance_point, implement.moi, implement.moi_axis
    assert mass is not None
    assert balance is not None
    assert moi is not None
    gyration = moi / mass - (balance - axis) ** 2
    new_mass, new_balance = mass * factor.get("mass", 1.0), balance * factor.get("balance_point", 1.0)
    new_gyration = gyration * factor.get("gyration", 1.0) ** 2
    changes |= {
        "mass": new_mass,
        "balance_point": new_balance,
        "moi": new_mass * (new_gyration + (new_balance - axis) ** 2),
    }
    return beam_model(implement.replaced(**changes))


UnknownName = (
    Literal["modulus", "shear_modulus", "density", "density_gradient", "knob_mass", "end_mass", "wall", "handle"]
    | Literal[
        "knob_depth", "end_depth", "barrel", "ball_restitution", "mass", "balance_point", "gyration", "first_frequency"
    ]
    | Literal["swing_weight", "rim", "core_shear"]
)
OF_BALL: UnknownName = "ball_restitution"
"""The unknown that is not the bat's."""
GRADIENT_SPREAD = 0.05
"""One sigma of the density's relative change from the middle to the tip (assumed)."""
KNOB_EXTRA, KNOB_EXTRA_SPREAD = 0.005, 0.8
"""kg at the knob of a solid bat that no drawing has, and one sigma of its logarithm: mostly 1 to 19 g (assumed)."""
FITTING_SPREAD = 0.1
"""One sigma of the logarithm of a hollow bat's knob and end cap (assumed)."""
DEPTH_SPREAD = 0.5
"""One sigma of the logarithm of a depth of knob or end cap that was not measured: mostly 9 to 46 mm, and 4 to 23 mm
(assumed)."""
WALL_SPREAD = 0.08
"""One sigma of the wall's logarithm: makers do not publish walls (assumed)."""
DIAMETER_SPREAD = 0.003
"""One sigma of the logarithm of diameters: 0.1 mm of a handle, 0.2 mm of a barrel, a careful caliper (assumed)."""
ROOM = 0.98
"""Part of a hollow bat's radius that the thickest drawn walls fill."""


@dataclass(frozen=True)
class Unknown:
    """One thing that is not known exactly.

    ``spread``: one sigma before the measurements; of a logarithm, but for the density gradient.
    """

    name: UnknownName
    spread: float


def described(bat: Implement) -> BeamModel:
    """Return a bat's beam as described, without what was measured, with tape and paint at a solid bat's knob.

    A racket, club or stick is described by what was measured; see `as_described`.
    """
    if not isinstance(bat, Bat):
        return as_described(bat)
    bare = bat.replaced(mass=None, balance_point=None, moi=None, original=None)
    if bat.shell is None and not any(weight.position == 0 for weight in bat.point_masses):
        weights = (*bat.point_masses, PointMass(position=0.0, mass=KNOB_EXTRA, on_surface=True))
        bare = bare.replaced(point_masses=weights)
    return beam_model(bare)


def unknowns_of(bat: Implement, *, diameter_spread: float = DIAMETER_SPREAD) -> tuple[Unknown, ...]:
    """Return the unknowns of a bat of this kind."""
    if not isinstance(bat, Bat):
        return tuple(Unknown(name, size) for name, size in implement_spreads(bat).items())  # type: ignore[arg-type]
    if bat.shell is not None and (bat.shell.laminate is not None or bat.shell.handle_material is not None):
        raise InputError(
            f"{bat.name} has walls of plies or a handle of its own material, and only bats of one material can be "
            "fitted; write its mass, balance_point and moi into its file, and use report or compare"
        )
    if not 0 < diameter_spread < 0.1:
        raise InputError(f"the error of the diameters is {diameter_spread:g} of them; allowed is 0 to 0.1")
    spreads = material_spreads(bat.material.name)
    unknowns = [Unknown("modulus", spreads["longitudinal_modulus"])]
    if bat.material.shear_modulus is not None:
        unknowns.append(Unknown("shear_modulus", spreads["shear_modulus"]))
    unknowns += [Unknown("density", spreads["density"]), Unknown("density_gradient", GRADIENT_SPREAD)]
    if bat.shell is None:
        unknowns.append(Unknown("knob_mass", KNOB_EXTRA_SPREAD))
    else:
        unknowns = [
            unknown for unknown in unknowns if unknown.name != "density_gradient"
        ]  # metal is as dense everywhere
        unknowns += [Unknown("wall", WALL_SPREAD)]
        unknowns += [Unknown("knob_mass", FITTING_SPREAD)] * bool(bat.shell.knob_mass)
        unknowns += [Unknown("end_mass", FITTING_SPREAD)] * bool(bat.shell.end_cap_mass)
        unknowns += [Unknown("knob_depth", DEPTH_SPREAD)] * bool(bat.shell.knob_mass and bat.shell.knob_depth is None)
        unknowns += [Unknown("end_depth", DEPTH_SPREAD)] * bool(
            bat.shell.end_cap_mass and bat.shell.end_cap_depth is None
        )
    if bat.profile is not None:
        unknowns += [Unknown("handle", diameter_spread), Unknown("barrel", diameter_spread)]
    return tuple(unknowns)


def deviated(beam: BeamModel, unknowns: Sequence[Unknown], deviations: Array) -> BeamModel:
    """Return a bat's beam with these deviations from it, shape (n,)."""
    by: dict[str, float] = {entry.name: float(off) for entry, off in zip(unknowns, deviations, strict=True)}
    if not isinstance(beam.bat, Bat):
        return implement_deviated(beam, by)
    bat = _changed(beam.bat, by)
    first, second = beam.unplaced
    if {"balance_point", "gyration"} & by.keys():  # they move no mass that the beam knows of
        body = rigid_body(beam)
        balance = body.balance_point * math.exp(by.get("balance_point", 0.0))
        first += body.mass * (balance - body.balance_point)
        second += body.mass * (balance**2 - body.balance_point**2)
        second += body.moi_cm * math.expm1(2 * by.get("gyration", 0.0))
    return replace(
        beam,
        bat=bat,
        density_factor=beam.density_factor * math.exp(by.get("density", 0.0)),
        density_gradient=beam.density_gradient + by.get("density_gradient", 0.0),
        point_masses=(*bat.lumps(), *beam.point_masses[len(beam.bat.lumps()) :]),
        unplaced=(first, second),
    )


def _changed(bat: Bat, by: dict[str, float]) -> Bat:
    """Return the bat with other moduli, diameters, walls and masses at its ends.

    It is not checked again, which takes longer than all the rest: a wall that would fill the bat is as thick as fits.
    """
    factor = {name: math.exp(off) for name, off in by.items()}
    changes: dict[str, object] = {}
    stiff = {"longitudinal_modulus": "modulus", "shear_modulus": "shear_modulus"}
    moduli = {field: getattr(bat.material, field) * factor[name] for field, name in stiff.items() if name in by}
    changes["material"] = bat.material.unchecked(**moduli)
    knob = factor.get("knob_mass", 1.0)
    if bat.shell is not None:
        thicker = factor.get("wall", 1.0)
        shell = bat.shell.scaled(min(thicker, _thickest(bat)) if thicker > 1 else thicker)
        ends = {"knob_mass": shell.knob_mass * knob, "end_cap_mass": shell.end_cap_mass * factor.get("end_mass", 1.0)}
        usual = dict(zip(("knob_depth", "end_depth"), shell.depths, strict=True))
        fields = {"knob_depth": "knob_depth", "end_depth": "end_cap_depth"}
        depths = {fields[name]: usual[name] * factor[name] for name in fields if name in by}
        changes["shell"] = shell.unchecked(**ends, **depths)
    else:
        *_, piece = bat.lineage()
        tape = piece.point_masses if isinstance(piece, Bat) else ()  # what was put on since was weighed
        changes["point_masses"] = tuple(
            weight.unchecked(mass=weight.mass * knob) if weight.position == 0 and weight in tape else weight
            for weight in bat.point_masses
        )
    if "handle" in by and bat.profile is not None:
        diameters = np.array(bat.profile)[:, 1]
        part = barrel_parts(bat.profile, bat.length)
        scaled = diameters * np.exp(by["handle"] * (1 - part) + by["barrel"] * part)
        places = [position for position, _ in bat.profile]
        changes["profile"] = tuple(zip(places, scaled.tolist(), strict=True))
    return bat.unchecked(**changes)


def _thickest(bat: Bat) -> float:
    """Return the greatest factor of all wall thicknesses of a hollow bat, with a little room left for its diameters."""
    assert bat.shell is not None
    places = np.array(bat.breakpoints())
    walls, outside = bat.wall_at(places), bat.diameter_at(places) / 2
    if bat.shell.inner_wall is not None:
        sleeve = bat.shell.inner_wall.thickness_at(places)
        outside, walls = outside - bat.shell.inner_wall.gap * (sleeve > 0), walls + sleeve
    return max(1.0, ROOM * float(np.min(outside / walls)))


@lru_cache(maxsize=8)
def barrel_parts(profile: Stations, length: float) -> Array:
    """Return the share of the barrel's diameter error at every station: 0 on the handle to 1 on the barrel."""
    places, diameters = np.array(profile).T
    beyond_knob = np.linspace(0.15 * length, length, 200)
    there = np.interp(beyond_knob, places, diameters)
    thin, thick = np.min(there), np.max(there)
    part = np.clip((diameters - thin) / (thick - thin), 0, 1) if thick > thin else np.zeros(len(places))
    return np.asarray(np.where(places < beyond_knob[0], 0.0, part))

"""Bat tests: a ball fired at a bat in a clamp; a bat before and after drilling; a torpedo against its parent."""

from __future__ import annotations

from functools import cache
from typing import NamedTuple

import numpy as np

from sweetspot import catalog
from sweetspot.analysis.certification.simulated_test import BatTest, bat_test
from sweetspot.collision.closed_form import bbcor, exit_speed
from sweetspot.collision.kernel import hits
from sweetspot.dynamics.beam import beam_model
from sweetspot.dynamics.hands import held_modes
from sweetspot.dynamics.reduction import all_modes
from sweetspot.dynamics.rigid import RigidBody, rigid_body
from sweetspot.equipment.bat import Bat
from sweetspot.motion.swing import Hands
from sweetspot.numerics.arrays import Array
from sweetspot.numerics.constants import STANDARD_AXIS
from sweetspot.units import INCH, MPH
from sweetspot.validation.computations import shared

CLAMP = Hands(position=STANDARD_AXIS, spacing=0.0, mass=1e4, stiffness=1e9)
"""Heavy and stiff enough to hold its place still, free to turn."""
CLAMPED_PLACES = np.linspace(2 * INCH, 10 * INCH, 81)
DRILLED_PLACES = np.linspace(4 * INCH, 9 * INCH, 51)
"""m from the tip."""


@cache
def _clamped_test(bat: str, closing_speed: float) -> tuple[Array, float]:
    """Return q at `CLAMPED_PLACES` and the greatest BBCOR of a catalogue bat."""
    ball, body = catalog.ball(), shared.body(bat)
    clamped = held_modes(shared.free_modes(bat), CLAMP)
    places = shared.length(bat) - CLAMPED_PLACES
    efficiency = hits(clamped, ball=ball, position=places, closing_speed=closing_speed).collision_efficiency
    measured = (bbcor(q, body=body, ball=ball, position=place) for q, place in zip(efficiency, places, strict=True))
    return efficiency, float(max(measured))


def laboratory_bbcor(*, bat: str, closing_speed: float) -> float:
    """Return BBCOR at the place where it is greatest."""
    return _clamped_test(bat, closing_speed)[1]


def laboratory_exit_speed(*, bat: str, ball_speed: float, bat_speed: float) -> float:
    """Return the greatest exit speed by the test's rule of a bat that turns about the clamp.

    ``bat_speed`` is 6 in from the tip.
    """
    efficiency, length = _clamped_test(bat, ball_speed + bat_speed)[0], shared.length(bat)
    swing = bat_speed * (length - CLAMPED_PLACES - STANDARD_AXIS) / (length - 6 * INCH - STANDARD_AXIS)
    return float(exit_speed(efficiency, ball_speed=ball_speed, bat_speed=swing).max())


def laboratory_bbcor_spread(*, bats: list[str], closing_speed: float) -> float:
    """Return the range of the greatest BBCOR of several bats."""
    return float(np.ptp([_clamped_test(bat, closing_speed)[1] for bat in bats]))


def laboratory_besr_rise(*, bats: list[str], closing_speed: float) -> float:
    """Return BESR = q + 1/2 of the last bat less that of the first."""
    first, last = (_clamped_test(bat, closing_speed)[0].max() for bat in (bats[0], bats[-1]))
    return float(last - first)


class Corked(NamedTuple):
    """Changes of a bat by a corked hole: mass lost, shift of the balance point toward the tip."""

    mass_loss: float
    balance_shift: float


def corked(*, bat: str, **bore: float) -> Corked:
    """Return the changes of mass and balance point."""
    before, after = _body(catalog.bat(bat)), _body(_corked(bat, **bore))
    return Corked(before.mass - after.mass, after.balance_point - before.balance_point)


def whole_efficiency(*, bat: str, closing_speed: float) -> float:
    """Return the greatest q of the bat before drilling."""
    return _best(catalog.bat(bat), closing_speed)[0]


def corked_efficiency_loss(*, bat: str, closing_speed: float, **bore: float) -> float:
    """Return the decrease of the greatest q by a corked hole."""
    return _best(catalog.bat(bat), closing_speed)[0] - _best(_corked(bat, **bore), closing_speed)[0]


def corked_bbcor_change(*, bat: str, closing_speed: float, **bore: float) -> float:
    """Return the increase of the greatest BBCOR by a corked hole."""
    return _best(_corked(bat, **bore), closing_speed)[1] - _best(catalog.bat(bat), closing_speed)[1]


def _corked(bat: str, *, bore_diameter: float, bore_depth: float, plug: float) -> Bat:
    cork = catalog.material("cork")
    return catalog.bat(bat).corked(diameter=bore_diameter, depth=bore_depth, fill=cork, plug=plug)


@cache
def _body(bat: Bat) -> RigidBody:
    return rigid_body(beam_model(bat))


@cache
def _best(bat: Bat, closing_speed: float) -> tuple[float, float]:
    """Return the greatest q and the greatest BBCOR along the barrel for one closing speed."""
    ball, body, places = catalog.ball(), _body(bat), bat.length - DRILLED_PLACES
    modes = all_modes(beam_model(bat), ball)
    efficiency = hits(modes, ball=ball, position=places, closing_speed=closing_speed).collision_efficiency
    return float(efficiency.max()), float(bbcor(efficiency, body=body, ball=ball, position=places).max())


FATTEST = 6.5 * INCH
"""m from the tip: designers aim six or seven inches below it."""
SWELLING = 0.08 * INCH
"""m by which the barrel grows halfway from there to where it begins, 13 in from the tip."""
BARREL = 13 * INCH


class Torpedo(NamedTuple):
    """A torpedo against its parent: shift of the best place toward the hands, gain of the greatest BBCOR."""

    shift: float
    bbcor_gain: float


def torpedo(*, bat: str, thinner: float) -> Torpedo:
    """Return the changes when the fattest place moves inward at equal mass and equal moment of inertia."""
    parent = catalog.bat(bat)
    before, after = _tested(parent), _tested(_made_torpedo(parent, thinner=thinner))
    return Torpedo(before.best_position - after.best_position, after.best_bbcor - before.best_bbcor)


def torpedo_pair(*, bat: str, other: str) -> Torpedo:
    """Return the changes from an ordinary bat of the catalogue to another of it."""
    before, after = (_tested(catalog.bat(name)) for name in (bat, other))
    return Torpedo(before.best_position - after.best_position, after.best_bbcor - before.best_bbcor)


@cache
def _tested(bat: Bat) -> BatTest:
    beam, ball = beam_model(bat), catalog.ball()
    return bat_test(beam, body=rigid_body(beam), modes=all_modes(beam, ball), ball=ball, closing_speed=136 * MPH)


def _made_torpedo(bat: Bat, *, thinner: float) -> Bat:
    """Return a bat like another, thinner at its end by ``thinner`` m, as heavy and as hard to swing about 6 in."""
    body = _body(bat)
    place, diameter = np.array(bat.profile).T
    places = np.union1d(place, np.linspace(bat.length - BARREL, bat.length - 0.3 * INCH, 27))
    from_tip = bat.length - places
    part = np.clip(1 - from_tip / FATTEST, 0, 1)
    inside = (from_tip > FATTEST) & (from_tip < BARREL)
    swollen = np.where(inside, np.sin(np.pi * (from_tip - FATTEST) / (BARREL - FATTEST)), 0.0)
    new = np.interp(places, place, diameter) - thinner * part**2 * (3 - 2 * part) + SWELLING * swollen
    return bat.replaced(
        name=f"{bat.name}, torpedo",
        profile=tuple(zip(places.tolist(), new.tolist(), strict=True)),
        mass=body.mass,
        moi=body.moi(6 * INCH),
        moi_axis=6 * INCH,
        balance_point=None,
    )

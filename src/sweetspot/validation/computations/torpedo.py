"""A torpedo: the same bat with its fattest place moved inwards, at equal mass and equal moment of inertia."""

from __future__ import annotations

from functools import cache

import numpy as np

from sweetspot import catalog
from sweetspot.analysis.certification.simulated_test import BatTest, bat_test
from sweetspot.dynamics.beam import beam_model
from sweetspot.dynamics.reduction import all_modes
from sweetspot.dynamics.rigid import rigid_body
from sweetspot.equipment.bat import Bat
from sweetspot.units import INCH, MPH

TEST_SPEED = 136 * MPH
FATTEST = 6.5 * INCH
"""m from the tip: designers aim six or seven inches below it."""
SWELLING = 0.08 * INCH
"""m by which the barrel grows halfway from there to where it begins, 13 in from the tip."""
BARREL = 13 * INCH
AXIS = 6 * INCH


def made_torpedo(bat: Bat, *, thinner: float) -> Bat:
    """Return a bat like another, thinner at its end by ``thinner`` m, as heavy and as hard to swing about 6 in."""
    body = rigid_body(beam_model(bat))
    place, diameter = np.array(bat.profile).T
    places = np.union1d(place, np.linspace(bat.length - BARREL, bat.length - 0.3 * INCH, 27))
    from_tip = bat.length - places
    part = np.clip(1 - from_tip / FATTEST, 0, 1)
    inside = (from_tip > FATTEST) & (from_tip < BARREL)
    swollen = np.where(inside, np.sin(np.pi * (from_tip - FATTEST) / (BARREL - FATTEST)), 0.0)
    new = np.interp(places, place, diameter) - thinner * part**2 * (3 - 2 * part) + SWELLING * swollen
    profile = tuple(zip(places.tolist(), new.tolist(), strict=True))
    return bat.replaced(
        name=f"{bat.name}, torpedo", profile=profile, mass=body.mass, moi=body.moi(AXIS), moi_axis=AXIS,
        balance_point=None,
    )  # fmt: skip


@cache
def _tested(bat: str, thinner: float) -> BatTest:
    """Return the bat test of a catalogue bat, or of a torpedo made of it."""
    plain, ball = catalog.bat(bat), catalog.ball()
    beam = beam_model(made_torpedo(plain, thinner=thinner) if thinner else plain)
    modes = all_modes(beam, ball)
    return bat_test(beam, body=rigid_body(beam), modes=modes, ball=ball, closing_speed=TEST_SPEED)


def torpedo_shift(*, bat: str, thinner: float) -> float:
    """Return how far the place of the greatest BBCOR moves towards the hands."""
    return _tested(bat, 0.0).best_position - _tested(bat, thinner).best_position


def torpedo_bbcor_gain(*, bat: str, thinner: float) -> float:
    """Return how much the greatest BBCOR grows."""
    return _tested(bat, thinner).best_bbcor - _tested(bat, 0.0).best_bbcor


COMPUTATIONS = (torpedo_shift, torpedo_bbcor_gain)

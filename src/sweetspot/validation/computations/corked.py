"""A catalogue bat drilled, filled with cork and plugged, against itself."""

from __future__ import annotations

from functools import cache

import numpy as np

from sweetspot import catalog
from sweetspot.collision.closed_form import bbcor
from sweetspot.collision.kernel import hits
from sweetspot.dynamics.beam import beam_model
from sweetspot.dynamics.reduction import all_modes
from sweetspot.dynamics.rigid import RigidBody, rigid_body
from sweetspot.equipment.bat import Bat
from sweetspot.units import INCH

PLACES = np.linspace(4 * INCH, 9 * INCH, 51)
"""m from the tip."""


def corked_mass_loss(*, bat: str, **bore: float) -> float:
    """Return how much lighter the bat becomes."""
    return _body(catalog.bat(bat)).mass - _body(_corked(bat, **bore)).mass


def corked_balance_shift(*, bat: str, **bore: float) -> float:
    """Return how far the balance point moves towards the tip; negative: towards the hands."""
    return _body(_corked(bat, **bore)).balance_point - _body(catalog.bat(bat)).balance_point


def whole_efficiency(*, bat: str, closing_speed: float) -> float:
    """Return the greatest q of the bat before drilling."""
    return _best(catalog.bat(bat), closing_speed)[0]


def corked_efficiency_loss(*, bat: str, closing_speed: float, **bore: float) -> float:
    """Return how much the greatest q falls."""
    return _best(catalog.bat(bat), closing_speed)[0] - _best(_corked(bat, **bore), closing_speed)[0]


def corked_bbcor_change(*, bat: str, closing_speed: float, **bore: float) -> float:
    """Return how much the greatest BBCOR rises."""
    return _best(_corked(bat, **bore), closing_speed)[1] - _best(catalog.bat(bat), closing_speed)[1]


def _corked(bat: str, *, bore_diameter: float, bore_depth: float, plug: float) -> Bat:
    whole = catalog.bat(bat)
    return whole.corked(diameter=bore_diameter, depth=bore_depth, fill=catalog.material("cork"), plug=plug)


@cache
def _body(bat: Bat) -> RigidBody:
    return rigid_body(beam_model(bat))


@cache
def _best(bat: Bat, closing_speed: float) -> tuple[float, float]:
    """Return the greatest q and the greatest BBCOR along the barrel for one closing speed."""
    ball, body, places = catalog.ball(), _body(bat), bat.length - PLACES
    done = hits(all_modes(beam_model(bat), ball), ball=ball, position=places, closing_speed=closing_speed)
    efficiency = done.collision_efficiency
    return float(efficiency.max()), float(bbcor(efficiency, body=body, ball=ball, position=places).max())


COMPUTATIONS = (
    corked_mass_loss,
    corked_balance_shift,
    whole_efficiency,
    corked_efficiency_loss,
    corked_bbcor_change,
)

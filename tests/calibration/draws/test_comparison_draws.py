"""Draws of bats: how far their outlines leave moments of inertia open, and that a changed bat stays the bat it was."""

from __future__ import annotations

import numpy as np
import pytest

from sweetspot import catalog, compare
from sweetspot.calibration.draws.comparison_draws import drawn_comparison
from sweetspot.calibration.draws.drawn_hits import draws_of
from sweetspot.calibration.draws.sources import sources_of
from sweetspot.catalog.standard_hit import standard_conditions
from sweetspot.dynamics.beam import beam_model
from sweetspot.dynamics.outline_doubt import moi_doubt
from sweetspot.dynamics.rigid import rigid_body
from sweetspot.equipment.bat import Bat
from sweetspot.numerics.constants import STANDARD_AXIS
from sweetspot.units import INCH

CORK = 1 * INCH, 10 * INCH, 2 * INCH
"""Diameter, depth and plug of the usual hole, m."""


@pytest.mark.parametrize("name", ["r161-ash", "college-alloy"])
@pytest.mark.parametrize("balanced", [False, True])
def test_draws_leave_a_moment_as_open_as_plain_answers_say(name: str, balanced: bool) -> None:
    """Its own materials and walls add to that; a weight that was measured stays."""
    bat = catalog.bat(name)
    mass, balance = rigid_body(beam_model(bat)).mass, rigid_body(beam_model(bat)).balance_point
    bat = bat.replaced(mass=mass, balance_point=balance if balanced else None)
    line, conditions = beam_model(bat), standard_conditions(bat)
    drawn = draws_of(line, conditions, sources_of(bat, conditions), count=256).bats.bending
    told = moi_doubt(bat, rigid_body(line), STANDARD_AXIS)
    assert told < 1.05 * drawn.moi(STANDARD_AXIS).std() < 1.2 * told
    assert drawn.mass.std() < 0.006 * mass, "a weight on a scale"


def test_a_bat_that_was_changed_is_drawn_as_the_bat_it_was() -> None:
    """Corking changes moment and exit speed by much less than they are known; of another bat nothing is shared."""
    plain = catalog.bat("r161-ash")
    diameter, depth, plug = CORK
    corked = plain.corked(diameter=diameter, depth=depth, fill=catalog.material("cork"), plug=plug)
    other = plain.replaced(name="another", mass=1.001 * beam_mass(plain))
    conditions = standard_conditions(plain)
    compared = compare([plain, corked, other], conditions=conditions, law=catalog.swing_law())
    sources = [sources_of(one.analysis.bat, conditions) for one in compared.compared]
    answers = drawn_comparison(compared, sources, count=256)
    moments = [answers.values[f"bats.{index}.bat.moi_6in_kg_m2"][1:] for index in range(3)]
    assert np.corrcoef(moments[0], moments[1])[0, 1] > 0.99
    assert abs(np.corrcoef(moments[0], moments[2])[0, 1]) < 0.2
    changes = [answers.values[f"bats.{index}.change_m_s"].std() for index in (1, 2)]
    assert changes[0] < changes[1] / 3
    assert len(answers.names) == answers.normal.shape[1]


def beam_mass(bat: Bat) -> float:
    """Mass of a bat as it is described, kg."""
    return rigid_body(beam_model(bat)).mass

"""How far the handles of a design and of the present bat are bent."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from sweetspot.analysis.bat_analysis import hit_at
from sweetspot.analysis.strain import damage
from sweetspot.designs.batter import FROM_TIP, RARE, normal_contact, usual_places
from sweetspot.designs.gain import handle_bending
from sweetspot.designs.measures import Bench
from sweetspot.dynamics.beam import beam_model
from sweetspot.dynamics.reduction import all_modes
from sweetspot.equipment.bat import Bat
from sweetspot.motion.swing import Swing
from sweetspot.units import INCH
from tests.designs.conftest import met_at


def test_all_but_the_rarest_contacts_are_looked_at(bench: Bench) -> None:
    batter = replace(bench.batter, weight=normal_contact(6.5 * INCH, 1.8 * INCH))
    places = FROM_TIP[usual_places(batter)]
    within = batter.weight[(places[0] <= FROM_TIP) & (places[-1] >= FROM_TIP)].sum()
    assert 1 - 2 * RARE <= within < 1
    assert places[0] == pytest.approx(6.5 * INCH - 2.05 * 1.8 * INCH, abs=0.5 * INCH)
    assert places[-1] == pytest.approx(6.5 * INCH + 2.05 * 1.8 * INCH, abs=0.5 * INCH)


def test_it_is_the_strain_of_that_hit(bench: Bench) -> None:
    """Found by the batch's modes; the readable ones say the same of the same hit."""
    present = bench.space.present
    assert isinstance(present, Bat)
    found = handle_bending(bench, present)
    beam = beam_model(present)
    modes = all_modes(beam, bench.conditions.ball)
    batter, swing = bench.batter, bench.conditions.swing
    own = Swing(bat_speed=batter.bat_speed, measured_at=present.length - batter.speed_from_tip, pivot=swing.pivot)
    pitch = bench.conditions.pitch.replaced(speed=batter.pitch_speed)
    conditions = bench.conditions.replaced(swing=own, pitch=pitch)
    impact = hit_at(present.length - found.from_tip, modes=modes, conditions=conditions)
    assert found.strain == pytest.approx(damage(impact, beam=beam, modes=modes).handle_strain, rel=1e-5)
    assert found.limit is not None and found.strain > 0.005


def test_a_thinner_grip_and_jammed_balls_are_bent_further(bench: Bench) -> None:
    present = bench.space.present
    assert isinstance(present, Bat) and present.profile is not None
    thin = present.replaced(
        profile=[(place, width * (0.9 if place < 0.45 * present.length else 1.0)) for place, width in present.profile],
        mass=None,
        balance_point=None,
        moi=None,
    )
    as_drawn = present.replaced(mass=None, balance_point=None, moi=None)
    assert handle_bending(bench, thin).strain > 1.05 * handle_bending(bench, as_drawn).strain
    jammed = handle_bending(met_at(bench, 10.0), present)
    assert jammed.strain > handle_bending(met_at(bench, 6.5), present).strain
    assert np.isfinite(jammed.strain)

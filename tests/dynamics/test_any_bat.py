"""Modes of bats that nobody made: turned end for end, cut into finer elements, one by one and many at once."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given

from sweetspot import catalog
from sweetspot.collision.kernel import hits
from sweetspot.dynamics.batch.beams import BeamRow
from sweetspot.dynamics.batch.bending import bending_batch
from sweetspot.dynamics.beam import beam_model, section
from sweetspot.dynamics.reduction import bending_frequencies, bending_modes
from sweetspot.dynamics.rigid import rigid_body
from sweetspot.equipment.bat import Bat
from sweetspot.numerics.gauss_legendre import quadrature
from tests.dense_bending import dense_modes
from tests.random_bats import BATS, examples, solid_bats

BALL = catalog.ball()


@examples(8)
@given(bat=BATS)
def test_few_elements_have_the_frequencies_of_many(bat: Bat) -> None:
    beam = beam_model(bat)
    few, many = bending_frequencies(beam, count=12), bending_frequencies(beam, count=12, elements=64)
    assert few == pytest.approx(many, rel=2e-3)
    assert few[0] == pytest.approx(many[0], rel=5e-5)  # what it misses of a slow mode's give would count at once
    assert np.all(few > many * (1 - 1e-9))  # the motions of few are among those of many: never slower


@examples(15)
@given(bat=BATS)
def test_a_mode_moves_no_centre_of_mass(bat: Bat) -> None:
    # exact: nothing pushes a free bat
    beam = beam_model(bat)
    modes = bending_modes(beam)
    edges = sorted({*modes.shapes.ends.tolist(), *bat.breakpoints()})
    places, weights = quadrature(tuple(edges))
    momentum = (weights * section(beam, places).mass) @ modes.shape_at(places)
    for weight in beam.point_masses:
        momentum = momentum + weight.mass * modes.shape_at(weight.position)
    assert momentum[2:] == pytest.approx(np.zeros(12), abs=1e-6)
    assert momentum[0] == pytest.approx(np.sqrt(rigid_body(beam).mass), rel=1e-9)


@examples(6)
@given(bat=solid_bats(plain=True))
def test_a_bat_turned_end_for_end_is_the_same_bat(bat: Bat) -> None:
    # exact, but for the splines through what modes leave out: the knob is only the end where one begins to count
    assert bat.profile is not None
    turned = bat.replaced(profile=tuple((bat.length - x, size) for x, size in reversed(bat.profile)))
    modes, other = bending_modes(beam_model(bat)), bending_modes(beam_model(turned))
    assert other.frequency == pytest.approx(modes.frequency, rel=1e-7)
    places = np.linspace(0.55, 0.97, 7) * bat.length
    one = hits(modes, ball=BALL, position=places, closing_speed=60.0).collision_efficiency
    assert hits(other, ball=BALL, position=bat.length - places, closing_speed=60.0).collision_efficiency == (
        pytest.approx(one, rel=0, abs=3e-5)
    )


@examples(5)
@given(bat=BATS)
def test_the_compiled_beam_is_the_dense_twin(bat: Bat) -> None:
    beam = beam_model(bat)
    batch = bending_batch(BeamRow([beam, beam]), threads=1).modes(1)
    alone = dense_modes(beam)
    assert batch.frequency == pytest.approx(alone.frequency, rel=1e-7)
    places = np.linspace(0.4, 0.97, 7) * bat.length
    assert batch.compliance_at(places) == pytest.approx(alone.compliance_at(places), rel=1e-4, abs=1e-12)

"""Bats with all that a collision needs of them: compiled, and one by one."""

from __future__ import annotations

import math

import numpy as np
import pytest

from sweetspot import catalog
from sweetspot.collision.kernel import STEP, hits_with_motion, struck
from sweetspot.dynamics.batch.reduction import ReducedBats, reduced_beams
from sweetspot.dynamics.beam import BeamModel, beam_model
from sweetspot.dynamics.reduction import reduced_bat
from sweetspot.dynamics.rigid import rigid_body
from sweetspot.equipment.laminate import Laminate, Ply
from tests.dense_bending import dense_chain

NAMES = ("single-wall", "composite", "r161-ash", "corked-r161", "cricket-bat")


@pytest.fixture(scope="module")
def lines() -> list[BeamModel]:
    return [beam_model(catalog.load_implement(name)) for name in NAMES]


@pytest.fixture(scope="module")
def bats(lines: list[BeamModel]) -> ReducedBats:
    return reduced_beams(lines, ball=catalog.ball())


@pytest.mark.parametrize("name", NAMES)
def test_motions_are_those_of_the_dense_chain(name: str, lines: list[BeamModel], bats: ReducedBats) -> None:
    number, beam = NAMES.index(name), lines[NAMES.index(name)]
    modes, ours = dense_chain(beam, catalog.ball()), bats.modes(number)
    place = np.linspace(0.4, 1.0, 17) * beam.bat.length
    assert ours.families == modes.families
    assert np.allclose(ours.frequency, modes.frequency, rtol=1e-9, atol=1e-9)
    theirs, mine = modes.shape_at(place), ours.shape_at(place)
    mine = mine * np.sign(np.sum(mine * theirs, axis=0))  # the sign of a wall's mode is free
    assert np.abs(mine - theirs).max() < 1e-9 * np.abs(theirs).max()
    vibrating = modes.frequency > 0
    slow = np.sum(theirs[:, vibrating] ** 2 / modes.angular_frequency[vibrating] ** 2, axis=1).max()
    every = np.tile(place, (len(lines), 1))
    assert np.abs(bats.compliance_at(every)[number] - modes.compliance_at(place)).max() < 1e-9 * slow


def test_hits_of_many_bats_are_those_of_each(lines: list[BeamModel], bats: ReducedBats) -> None:
    ball = catalog.ball()
    place = np.array([beam.bat.length for beam in lines])[:, None] - np.linspace(0.08, 0.25, 9)
    done = struck(bats, ball=ball, position=place, closing_speed=np.full(place.shape, 60.0), keep_motion=True)
    for number in range(len(lines)):
        modes = bats.modes(number)
        one = hits_with_motion(modes, ball=ball, position=place[number], closing_speed=60.0, step=STEP)
        assert np.allclose(done.collision_efficiency[number], one.collision_efficiency, rtol=1e-9)
        assert np.allclose(done.velocity[number, :, : len(modes)], one.velocity, atol=1e-9)


def test_a_wall_that_gives_way_less_than_its_beam_counts_with_the_beam() -> None:
    """Of stiff plies the wall's own part is below zero: only its sum with the beam's is a give, and cut at none."""
    bat, ply = catalog.bat("composite"), catalog.material("carbon-ply")
    assert bat.shell is not None
    around = Laminate(plies=(Ply(material=ply, angle=math.radians(90), thickness=0.3e-3),) * 2)
    beam, ball = (
        beam_model(bat.replaced(shell=bat.shell.replaced(laminate=around), mass=None, moi=None)),
        catalog.ball(),
    )
    modes, ours = dense_chain(beam, ball), reduced_beams([beam], ball=ball)
    place, speed = beam.bat.length - np.linspace(0.034, 0.056, 7), np.full((1, 7), 60.0)
    wall = ours.walls[0]
    assert wall is not None and wall.give_at(place, closing_speed=speed[0]).max() < 0 < modes.compliance_at(place).min()
    give = ours.compliance_at(place[None], closing_speed=speed)[0]
    assert give == pytest.approx(modes.compliance_at(place, closing_speed=speed[0]), rel=1e-6)
    done = struck(ours, ball=ball, position=place[None], closing_speed=speed)
    one = hits_with_motion(modes, ball=ball, position=place, closing_speed=60.0, step=STEP)
    assert np.allclose(done.collision_efficiency[0], one.collision_efficiency, rtol=0, atol=1e-8)


def test_a_quick_contact_has_as_many_modes_as_in_the_dense_chain() -> None:
    beam, ball = beam_model(catalog.load_implement("badminton-racket")), catalog.ball("shuttle")
    modes, ours = dense_chain(beam, ball), reduced_beams([beam], ball=ball).modes(0)
    assert len(ours) == len(modes) > 40
    assert np.allclose(ours.frequency, modes.frequency, rtol=1e-8, atol=1e-9)


@pytest.mark.parametrize("name", ["r161-ash", "composite", "tennis-racket", "cricket-bat"])
def test_one_bat_is_a_batch_of_one(name: str) -> None:
    bat = catalog.load_implement(name)
    reduced, body = reduced_bat(bat, ball=catalog.ball()), rigid_body(beam_model(bat))
    assert reduced.bat is bat
    exact = (
        1e-6 if name == "tennis-racket" else 1e-12
    )  # a round head is no polynomial: quadrature by elements, by pieces
    assert (reduced.body.mass, reduced.body.balance_point) == pytest.approx((body.mass, body.balance_point), rel=exact)
    assert (reduced.body.moi_cm, reduced.body.roll_moi) == pytest.approx((body.moi_cm, body.roll_moi), rel=exact)
    dense = dense_chain(reduced.beam, catalog.ball())
    assert reduced.modes.families == dense.families and reduced.modes.harmonics == dense.harmonics
    assert np.allclose(reduced.modes.frequency, dense.frequency, rtol=1e-9, atol=1e-9)

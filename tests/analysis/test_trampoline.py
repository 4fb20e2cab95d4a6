"""The wall as a trampoline: limits, the paper's formula, published trends."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest

from sweetspot import catalog
from sweetspot.analysis.bat_analysis import analyse, exit_speed_of
from sweetspot.analysis.position_scan import scan
from sweetspot.analysis.trampoline import wall_energy, wall_point, wall_share, wall_stiffness_at, wall_sweep
from sweetspot.catalog.standard_hit import standard_conditions
from sweetspot.collision.kernel import hits
from sweetspot.dynamics.modes import Modes
from sweetspot.dynamics.reduction import bending_modes
from sweetspot.dynamics.weight_match import with_wall_factor
from sweetspot.equipment.ball import Ball
from sweetspot.errors import InputError
from sweetspot.numerics.piecewise import Piecewise
from sweetspot.papers import formulas as paper


def spring_wall(stiffness: float, frequency: float) -> Modes:
    """A fixed wall whose face is one light mass on a spring: as the frequency grows, a massless spring.

    A little damping lets the face follow the ball without shaking; what it takes vanishes with the frequency too.
    """
    shape = 2 * np.pi * frequency / math.sqrt(stiffness)
    still = Piecewise(np.array([[[0.0, shape]]]).reshape(1, 1, 2), np.array([0.0, 1.0]))
    rate = np.array([0.0, 4 * np.pi * 0.05 * frequency])
    return Modes(("rigid", "hoop"), (0, 2), np.array([0.0, frequency]), rate, still, np.zeros((2, 2)), np.zeros((0, 2)))


@pytest.mark.parametrize("share", [0.02, 0.10, 0.30])
def test_a_massless_wall_gives_the_papers_formula(baseball: Ball, share: float) -> None:
    """W = k_bat^2 z + k_ball^2 (1 - z) with a lossless wall, k_bat = 1: quasi-static limit, to 1e-3.

    A linear ball without loss by the rate, so that z is the same at every force.
    """
    ball = baseball.replaced(
        exponent=1.0,
        stiffness=2e6,
        damping=0.0,
        law_ends=None,
        restitution=baseball.restitution.replaced(reference=0.45, slope=0.0),
    )
    stiffness = 2e6 * (1 - share) / share
    modes = spring_wall(stiffness, 200e3)
    assert wall_share(ball, modes=modes, position=0.5, compression=0.01) == pytest.approx(share)
    done = hits(modes, ball=ball, position=0.5, closing_speed=60.0, step=12.5e-9)
    expected = paper.energy_returned(bat_restitution=1.0, ball_restitution=0.45, share=share)
    assert done.collision_efficiency[0] ** 2 == pytest.approx(expected, rel=1e-3)


@pytest.mark.parametrize("quicker", [20, 50, 120])
def test_a_stiff_wall_is_a_solid_bat(quicker: float) -> None:
    """What a wall gives falls with the square of its frequency, also where it swings many times in one step."""
    bat = catalog.bat("russell-b6")
    conditions = standard_conditions(bat)
    stiff = with_wall_factor(bat, 1.0)
    result = analyse(stiff, conditions)
    solid = scan(replace(result.held, modes=bending_modes(result.beam)), conditions)
    hoop = result.modes.of_family("hoop")
    harder = result.modes.selected(list(range(len(result.modes))))
    scaled = Modes(
        harder.families,
        harder.harmonics,
        np.where(np.isin(np.arange(len(harder)), hoop), quicker * harder.frequency, harder.frequency),
        harder.damping_rate,
        harder.shapes,
        harder.rigid_part,
        harder.dashpots,
        compliances=bending_modes(result.beam).compliances,
    )
    with_stiff_wall = scan(replace(result.held, modes=scaled), conditions)
    assert with_stiff_wall.exit_speed == pytest.approx(solid.exit_speed, rel=0, abs=4 / quicker**2)  # m/s
    assert wall_stiffness_at(bending_modes(result.beam), 0.7) == math.inf


def test_lower_hoop_frequency_makes_a_livelier_bat() -> None:
    """Russell 2004, Nathan 2011: BBCOR rises as the lowest hoop frequency falls; the ledger shows the wall's part."""
    bat = catalog.bat("russell-b6")
    points = wall_sweep(bat, standard_conditions(bat), factors=(2.0, 1.4, 1.0, 0.8))
    assert [point.hoop_frequency for point in points] == sorted((p.hoop_frequency for p in points), reverse=True)
    assert [point.bbcor for point in points] == sorted(point.bbcor for point in points)
    assert [point.energy.stored for point in points] == sorted(point.energy.stored for point in points)
    assert all(0 <= point.energy.left <= point.energy.stored for point in points)


def test_the_papers_aluminium_wall() -> None:
    """z = 10 % and k = 0.9 are what an aluminium barrel of about 2.6 mm does: found, not fitted."""
    bat = catalog.bat("russell-b6")
    points = wall_sweep(bat, standard_conditions(bat), factors=(1.0, 0.9, 0.8))
    shares = [point.energy.share for point in points]
    thickness = float(np.interp(0.10, shares, [point.thickness for point in points]))
    restitution = float(np.interp(0.10, shares, [point.energy.restitution for point in points]))
    assert 2.3e-3 < thickness < 3.0e-3 and restitution == pytest.approx(0.9, abs=0.05)


def test_metal_beats_wood_as_published() -> None:
    """Greenwald 2001 and Crisco 2002, at about the same distance from the tip; by how much, their rows ask."""
    wood, metal = catalog.bat("r161-ash"), catalog.bat("russell-b6")
    of_wood, of_metal = (analyse(bat, standard_conditions(bat)) for bat in (wood, metal))
    gain = exit_speed_of(of_metal.best, of_metal.conditions) - exit_speed_of(of_wood.best, of_wood.conditions)
    assert gain > 3 * 0.44704
    places = [bat.length - result.best.position for bat, result in ((wood, of_wood), (metal, of_metal))]
    assert abs(places[0] - places[1]) < 0.0254
    assert of_metal.best.energy.hoop > 0 and abs(of_metal.best.energy.imbalance) < 1e-4


def test_a_solid_bat_has_no_wall() -> None:
    wood = catalog.bat("r161-ash")
    result = analyse(wood, standard_conditions(wood))
    assert wall_energy(result.best, result.modes).stored == 0.0
    with pytest.raises(InputError, match="is solid"):
        with_wall_factor(wood, 0.5)
    with pytest.raises(InputError, match="no hoop modes"):
        wall_point(wood, standard_conditions(wood))
    with pytest.raises(InputError, match="above zero"):
        with_wall_factor(catalog.bat("russell-b6"), 0.0)

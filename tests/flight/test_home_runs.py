"""Chances of home runs: the kernel against paths judged one by one, the limit without scatter, and tracked balls."""

from __future__ import annotations

import math
from functools import cache
from typing import Any

import numpy as np
import pytest
from scipy.special import ndtri

from sweetspot import catalog
from sweetspot.flight.air import Air, Wind
from sweetspot.flight.batted_spin import backspin_scatter, batted_ball_spin
from sweetspot.flight.carry_scatter import carry_spread
from sweetspot.flight.conditions import FlightConditions
from sweetspot.flight.fence import fly_all_parks
from sweetspot.flight.fence_compiled import TABLE_STEP
from sweetspot.flight.home_runs import LINERS, NONE, SPIN_MEASURED, CarryScatter, HomeRuns, home_run_chances
from sweetspot.flight.sweep import BattedBall
from sweetspot.motion.ball_motion import BallMotions, spin_axes
from sweetspot.numerics.arrays import Array
from sweetspot.units import DEGREE, FOOT, MPH

BALL, LAW, AIR, PARKS = catalog.ball(), catalog.aerodynamics(), Air(temperature=22.0), catalog.parks()
FLYING: dict[str, Any] = {"aerodynamics": LAW, "wind": Wind()}
START = np.array([0.0, 2 * FOOT, 3 * FOOT])


@cache
def batted_ball(count: int) -> tuple[Array, Array]:
    """Return velocities and spins of balls that come near fences."""
    generator = np.random.default_rng(3)
    angle, turn = generator.uniform(0.3, 0.75, count), generator.uniform(-0.75, 0.75, count)
    axes = spin_axes(angle, turn)
    back, side = batted_ball_spin(angle, turn)
    speed = generator.uniform(92, 112, count) * MPH
    return speed[:, None] * axes[2], back[:, None] * axes[0] + side[:, None] * axes[1]


def asked(count: int, **changes: Any) -> HomeRuns:
    velocity, spin = batted_ball(count)
    through = {"ball": BALL, "air": AIR} | {name: changes.pop(name, usual) for name, usual in FLYING.items()}
    return home_run_chances(
        BallMotions(velocity=velocity, spin=spin, position=START),
        FlightConditions(**through),
        **{"parks": PARKS, **changes},
    )


@pytest.mark.parametrize("wind", [Wind(), Wind(speed=5.0, direction=2.0)])
def test_without_scatter_it_is_the_path_judged(wind: Wind) -> None:
    """Agreement to 3 cm in every park's own air: chords of a path of 161 points, and a parabola over the air.

    Left out are corners of a fence, which the kernel's table of directions cuts.
    """
    velocity, spin = batted_ball(300)
    found = asked(300, scatter=NONE, wind=wind)
    judged = fly_all_parks(
        BallMotions(velocity=velocity, spin=spin, position=START),
        FlightConditions(ball=BALL, aerodynamics=LAW, air=AIR, wind=wind),
        parks=PARKS,
    )
    clearance = np.stack([park.clearance for park in judged], axis=-1)
    corner = np.stack(
        [
            np.abs(where.direction[:, None] - np.array(park.fence)[:, 0]).min(axis=1) < TABLE_STEP
            for park, where in zip(PARKS, judged, strict=True)
        ],
        axis=-1,
    )
    both = np.isfinite(clearance) & ~corner
    assert both.sum() > 2000 and np.isfinite(found.clearance[both]).all()
    assert np.abs(found.clearance - clearance)[both].max() < 0.03
    out = np.stack([park.out for park in judged], axis=-1)
    sure = (np.abs(np.nan_to_num(clearance, nan=1.0)) > 0.03) & ~corner
    assert np.array_equal(out[sure], found.chance[sure] > 0.5)
    assert set(np.unique(found.chance[sure])) == {0.0, 1.0}


def test_longer_steps_change_little() -> None:
    """Convergence: steps of 0.4 s, as a season takes them, against 0.2 s; jumps of a fence's height stand apart."""
    fine, coarse = asked(2000), asked(2000, step=0.4)
    near = np.abs(np.nan_to_num(fine.clearance, nan=99.0)) < 10
    off = np.abs(coarse.clearance - fine.clearance)[near]
    assert near.sum() > 5000 and np.nanquantile(off, 0.99) < 0.016 * FOOT
    assert np.quantile(np.abs(coarse.chance - fine.chance), 0.99) < 0.002


def test_a_ball_level_with_the_top_is_a_coin() -> None:
    """Symmetry: clearance zero is a chance of one half, a spread above and below add to one."""
    found = asked(2000, scatter=CarryScatter(roof=0.06, open=0.06, roof_shift=0.0, open_shift=0.0, spin=0.0))
    level = np.abs(np.nan_to_num(found.clearance, nan=9.0)) < 0.05
    assert level.sum() > 30 and np.abs(found.chance[level] - 0.5).max() < 0.02
    assert (found.chance[np.nan_to_num(found.clearance) > 0] >= 0.5).all()


def test_drag_moves_the_height_as_much_as_flown_with_it() -> None:
    """Agreement: the height that chances take 4 % more drag to cost, against flights with it, to 10 %.

    A chance is that of a height in spreads, and a spread what its part of the drag costs of height.
    """
    parts = ("drag", "drag_per_active_spin", "drag_per_inverse_reynolds")
    heavy = LAW.replaced(**{name: 1.04 * getattr(LAW, name) for name in parts})
    spread = asked(400, scatter=CarryScatter(roof=0.04, open=0.04, roof_shift=0.0, open_shift=0.0, spin=0.0))
    flown = asked(400, scatter=NONE, aerodynamics=heavy)
    truly = spread.clearance - flown.clearance
    near = (np.abs(np.nan_to_num(spread.clearance, nan=99.0)) < 6) & np.isfinite(truly)
    near &= (np.abs(spread.chance - 0.5) > 0.05) & (np.abs(spread.chance - 0.5) < 0.49)
    lower = spread.clearance[near] / ndtri(spread.chance[near])
    assert near.sum() > 500 and truly[near].mean() > 0.5
    assert lower.mean() == pytest.approx(truly[near].mean(), rel=0.1)


def test_a_shift_of_the_drag_moves_the_chance_by_so_many_spreads() -> None:
    """Exact: both are parts of the drag; the clearance is the law's, whatever the shift."""
    plain = asked(400, scatter=CarryScatter(roof=0.05, open=0.05, roof_shift=0.0, open_shift=0.0, spin=0.0))
    shifted = asked(400, scatter=CarryScatter(roof=0.05, open=0.05, roof_shift=0.03, open_shift=0.03, spin=0.0))
    sure = np.isfinite(plain.clearance) & (np.abs(plain.chance - 0.5) < 0.4999)
    assert sure.sum() > 500
    assert ndtri(shifted.chance[sure]) == pytest.approx(ndtri(plain.chance[sure]) - 0.6, abs=1e-6)
    assert np.array_equal(shifted.clearance, plain.clearance, equal_nan=True)


def test_thin_air_and_a_roof() -> None:
    own, sea = asked(400), asked(400, own_elevation=False)
    coors = [park.name for park in PARKS].index("Coors Field")
    assert own.chance[:, coors].sum() > 1.2 * sea.chance[:, coors].sum()
    assert own.expected.shape == (400,) and (own.expected <= 30).all()


def test_what_cannot_fly_has_no_chance() -> None:
    velocity, spin = batted_ball(4)
    velocity = velocity.copy()
    velocity[0] = math.nan
    velocity[1] = [0.0, 40.0, -20.0]  # into the ground
    velocity[2] = [40.0, 5.0, 20.0]  # far foul
    found = home_run_chances(
        BallMotions(velocity=velocity, spin=spin, position=START),
        FlightConditions(ball=BALL, aerodynamics=LAW, air=AIR),
        parks=PARKS,
    )
    assert (found.chance[:3] == 0).all() and np.isnan(found.clearance[:2]).all()


def test_balls_hit_alike_come_down_apart() -> None:
    """Observed: tracked flies of 2022 scatter by 15 to 16 ft about their computed carry, 5 ft of it by their launch."""
    hit = BattedBall(exit_speed=103 * MPH, launch_angle=0.5).motion
    through = FlightConditions(ball=BALL, aerodynamics=LAW, air=AIR)
    assert carry_spread(hit, through) / FOOT == pytest.approx(13.5, abs=3)
    assert carry_spread(hit, through, drag_scatter=0.0, spin_scatter=0.0) == 0.0


def test_a_roof_that_moves_counts_by_its_own_games() -> None:
    """Definition: half a fixed roof in the games it is closed; none and a fixed one are the ends."""
    usual = CarryScatter()
    shift = {park.name: usual.of(park)[0] for park in PARKS}
    assert shift["Fenway Park"] == usual.open_shift and shift["Tropicana Field"] == usual.roof_shift
    span = usual.open_shift - usual.roof_shift
    for name, share in (("T-Mobile Park", 0.16), ("Rogers Centre", 0.37), ("Daikin Park", 0.99)):
        assert shift[name] == pytest.approx(usual.open_shift - share / 2 * span)


@pytest.mark.parametrize(("angle", "speed"), [(18, 108), (23, 101), (30, 99)])
def test_spin_of_liners_scatters_about_its_own(angle: float, speed: float) -> None:
    """Agreement: three nodes of spin against 2,000 drawn ones, to 4 points of a chance; flies have no such scatter."""
    axes = spin_axes(angle * DEGREE, 0.5)
    back, side = batted_ball_spin(angle * DEGREE, 0.5)

    def chance(more: Array | float, scatter: CarryScatter) -> Array:
        spin = (back + np.atleast_1d(more))[:, None] * axes[0] + side * axes[1]
        motions = BallMotions(velocity=speed * MPH * axes[2], spin=spin, position=START)
        through = FlightConditions(ball=BALL, air=AIR, **FLYING)
        return home_run_chances(motions, through, parks=PARKS[:6], scatter=scatter).chance

    measured, nodes = chance(0.0, SPIN_MEASURED)[0], chance(0.0, CarryScatter())[0]
    more = np.random.default_rng(5).normal(0, backspin_scatter(angle * DEGREE), 2000)
    drawn = chance(more, SPIN_MEASURED).mean(axis=0)
    assert np.abs(nodes - drawn).max() < (0.04 if angle * DEGREE < LINERS else 1)
    assert (np.abs(measured - nodes).max() > 0.02) == (angle * DEGREE < LINERS)

"""What bats that nobody made must have in common with others: heavier, stiffer, larger, turned, cut finer, split.

No number is known beforehand; two questions are asked, and how their answers hang together follows from mechanics.
`make metamorphic` tries a hundred times as many bats, and others each time a seed is given.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import cache

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from sweetspot import catalog
from sweetspot.collision.kernel import STEP, hits
from sweetspot.dynamics.beam import beam_model
from sweetspot.dynamics.reduction import all_modes, bending_modes
from sweetspot.dynamics.rigid import centre_of_percussion, effective_mass, rigid_body
from sweetspot.equipment.ball import Ball
from sweetspot.equipment.bat import Bat, Bore, PointMass
from sweetspot.numerics.arrays import Array
from tests.random_bats import BATS, examples, solid_bats

BALL = catalog.ball()
PLAIN = solid_bats(plain=True)
FACTORS = st.floats(0.7, 1.5)
SMALLER = st.floats(0.8, 1.2)
PARTS = np.linspace(0.6, 0.95, 5)
SPEED = 55.0
"""m/s of closing."""
MASS, BALANCE, MOI, ROLL, FIRST, SECOND, THIRD = range(7)
NODES = 7
Values = Array
"""Mass, balance point, moments about it and the axis, three frequencies and the nodes of the first mode, SI."""


@cache
def values_of(bat: Bat) -> Values:
    beam = beam_model(bat)
    body, modes = rigid_body(beam), bending_modes(beam)
    frequencies = modes.frequency[modes.of_family("bending")][:3]
    first = modes.nodes(modes.of_family("bending")[0])
    return np.array([body.mass, body.balance_point, body.moi_cm, body.roll_moi, *frequencies, *first])


def of_material(bat: Bat, *, density: float = 1.0, moduli: float = 1.0) -> Bat:
    made = bat.material
    return bat.replaced(
        material=made.replaced(
            density_range=None,
            density=made.density * density,
            longitudinal_modulus=made.longitudinal_modulus * moduli,
            shear_modulus=made.shear_modulus and made.shear_modulus * moduli,
            transverse_modulus=made.transverse_modulus and made.transverse_modulus * moduli,
        )
    )


def sized(bat: Bat, size: float) -> Bat:
    """Return a plain bat, every length of which is a factor longer."""
    assert bat.profile is not None
    return bat.replaced(length=size * bat.length, profile=tuple((size * x, size * wide) for x, wide in bat.profile))


def scaled(values: Values, *, mass: float, length: float, frequency: float) -> Values:
    moments = mass * length**2
    factors = [mass, length, moments, moments, *[frequency] * 3, *[length] * (len(values) - NODES)]
    return np.asarray(values * np.array(factors))


@examples(6)
@given(bat=PLAIN, factor=FACTORS)
def test_a_denser_bat(bat: Bat, factor: float) -> None:
    """Exact: mass and moments as the density, frequencies as its root, balance and nodes as before."""
    there = scaled(values_of(bat), mass=factor, length=1.0, frequency=factor**-0.5)
    assert values_of(of_material(bat, density=factor)) == pytest.approx(there, rel=1e-8)


@examples(6)
@given(bat=PLAIN, factor=FACTORS)
def test_a_stiffer_bat(bat: Bat, factor: float) -> None:
    """Exact: frequencies as the root of the moduli, nothing else."""
    there = scaled(values_of(bat), mass=1.0, length=1.0, frequency=factor**0.5)
    assert values_of(of_material(bat, moduli=factor)) == pytest.approx(there, rel=1e-8)


@examples(6)
@given(bat=PLAIN, size=SMALLER)
def test_a_larger_bat(bat: Bat, size: float) -> None:
    """Exact: mass as the third power of the size, moments as the fifth, frequencies as its inverse."""
    there = scaled(values_of(bat), mass=size**3, length=size, frequency=1 / size)
    assert values_of(sized(bat, size)) == pytest.approx(there, rel=1e-8)


def efficiencies(bat: Bat, ball: Ball = BALL, size: float = 1.0) -> Array:
    """Return q, times and forces of hits, followed in steps that are as much longer as all is larger."""
    modes = all_modes(beam_model(bat), ball)
    found = hits(modes, ball=ball, position=PARTS * bat.length, closing_speed=SPEED, step=size * STEP)
    return np.array([found.collision_efficiency, found.contact_time, found.peak_force])


def alike(ball: Ball, *, size: float = 1.0, density: float = 1.0) -> Ball:
    """Return a ball that takes part in the same hit where all is larger and all is denser and stiffer.

    k of F = k u^n: forces go as pressure and area, k as density size^(2 - n); losses per rate as time over length.
    """
    return ball.replaced(
        mass=ball.mass * density * size**3,
        radius=ball.radius * size,
        stiffness=ball.stiffness * density * size ** (2 - ball.exponent),
        law_ends=None,
        spread=None,
    )


@examples(4)
@given(bat=PLAIN, size=SMALLER)
def test_a_hit_where_all_is_larger(bat: Bat, size: float) -> None:
    """Exact (similarity): at equal speeds q is equal, times go as the size and forces as its square."""
    efficiency, time, force = efficiencies(bat)
    there = np.array([efficiency, size * time, size**2 * force])
    assert efficiencies(sized(bat, size), alike(BALL, size=size), size) == pytest.approx(there, rel=2e-5, abs=1e-6)


@examples(4)
@given(bat=PLAIN, factor=FACTORS)
def test_a_hit_where_all_is_denser_and_stiffer(bat: Bat, factor: float) -> None:
    """Exact (similarity): q and times are equal, forces go as the density."""
    efficiency, time, force = efficiencies(bat)
    there = np.array([efficiency, time, factor * force])
    heavy = of_material(bat, density=factor, moduli=factor)
    assert efficiencies(heavy, alike(BALL, density=factor)) == pytest.approx(there, rel=2e-5, abs=1e-6)


def cut_finer(bat: Bat) -> Bat:
    """Exact: between stations a bat is a cone, so more stations on it are the same bat."""
    assert bat.profile is not None
    halves = [
        station
        for (x, wide), (next_x, next_wide) in zip(bat.profile, bat.profile[1:], strict=False)
        for station in ((x, wide), (x + 0.37 * (next_x - x), wide + 0.37 * (next_wide - wide)))
    ]
    return bat.replaced(profile=(*halves, bat.profile[-1]))


def filled_with_itself(bat: Bat) -> Bat:
    """Exact: a hole filled with the bat's own wood is none."""
    return bat.replaced(bores=(Bore(diameter=0.4 * bat.profile[-1][1], depth=0.12, fill=bat.material),))  # type: ignore[index]


def weight_split(bat: Bat) -> Bat:
    """Exact: two halves of a weight at one place are the weight."""
    place = 0.3 * bat.length
    return bat.replaced(point_masses=(PointMass(position=place, mass=0.02), PointMass(position=place, mass=0.02)))


def one_weight(bat: Bat) -> Bat:
    return bat.replaced(point_masses=(PointMass(position=0.3 * bat.length, mass=0.04),))


def of_no_weight(bat: Bat) -> Bat:
    """Nearly exact: a weight of a ten-millionth of a gram is none."""
    return bat.replaced(point_masses=(PointMass(position=0.9 * bat.length, mass=1e-10),))


def with_own_gradient(bat: Bat) -> Bat:
    """Exact: a density that does not change along the bat is the density."""
    return bat.replaced(density_gradient=0.0)


def turned_by_grain(bat: Bat) -> Bat:
    """By definition: the slope of the grain tells where a bat breaks, not how it moves."""
    return bat.replaced(grain_slope=0.05)


def renamed(bat: Bat) -> Bat:
    """Exact: a name is no property."""
    return bat.replaced(name="another", remark="of another", altered=True)


def same(bat: Bat) -> Bat:
    return bat


@pytest.mark.parametrize(
    ("one", "other", "rel"),
    [
        pytest.param(same, cut_finer, 2e-4, id="stations"),
        pytest.param(same, filled_with_itself, 1e-4, id="own filling"),
        pytest.param(one_weight, weight_split, 1e-9, id="split weight"),
        pytest.param(same, of_no_weight, 1e-5, id="no weight"),
        pytest.param(same, with_own_gradient, 0.0, id="no gradient"),
        pytest.param(same, turned_by_grain, 1e-9, id="grain"),
        pytest.param(same, renamed, 0.0, id="name"),
    ],
)
@examples(3)
@given(bat=PLAIN)
def test_the_same_bat_in_other_words(
    one: Callable[[Bat], Bat], other: Callable[[Bat], Bat], rel: float, bat: Bat
) -> None:
    assert values_of(other(bat)) == pytest.approx(values_of(one(bat)), rel=rel, abs=0.0)


@examples(4)
@given(bat=BATS, order=st.randoms())
def test_weights_in_any_order(bat: Bat, order: st.DrawFn) -> None:
    """Exact, but for the order of sums."""
    weights = [PointMass(position=part * bat.length, mass=0.01 + 0.01 * part) for part in (0.1, 0.5, 0.85)]
    mixed = list(weights)
    order.shuffle(mixed)  # type: ignore[attr-defined]
    one, other = (bat.replaced(point_masses=tuple(each)) for each in (weights, mixed))
    assert values_of(other) == pytest.approx(values_of(one), rel=1e-9)


@examples(6)
@given(bat=BATS)
def test_its_own_weight_measured(bat: Bat) -> None:
    """Exact: what a description says of weight and balance, measured, changes nothing."""
    mass, balance, moi = values_of(bat)[:3]
    weighed = bat.replaced(mass=mass, balance_point=balance, moi=moi + mass * (balance - bat.moi_axis) ** 2)
    assert values_of(weighed) == pytest.approx(values_of(bat), rel=1e-6)


@examples(6)
@given(bat=BATS, axis=st.floats(0.0, 0.2))
def test_moments_about_other_axes(bat: Bat, axis: float) -> None:
    """Exact (Steiner): the moment about any axis, and back."""
    body = rigid_body(beam_model(bat))
    assert body.moi(axis) == pytest.approx(body.moi_cm + body.mass * (body.balance_point - axis) ** 2, rel=1e-12)
    before, after = body.balance_point - axis, centre_of_percussion(body, pivot=axis) - body.balance_point
    assert before * after == pytest.approx(body.moi_cm / body.mass, rel=1e-12)  # pivot and centre change places


@examples(6)
@given(bat=BATS, part=st.floats(0.1, 0.99))
def test_the_mass_that_a_ball_meets(bat: Bat, part: float) -> None:
    """Exact: 1 / m_eff = 1 / M + b^2 / I; at most the mass, at the balance point all of it."""
    body = rigid_body(beam_model(bat))
    met = effective_mass(body, part * bat.length)
    arm = part * bat.length - body.balance_point
    assert 1 / met == pytest.approx(1 / body.mass + arm**2 / body.moi_cm, rel=1e-12)
    assert met <= body.mass * (1 + 1e-12)
    assert effective_mass(body, body.balance_point) == pytest.approx(body.mass, rel=1e-12)


@examples(4)
@given(bat=BATS, order=st.permutations(range(5)))
def test_hits_do_not_know_of_each_other(bat: Bat, order: list[int]) -> None:
    """Exact: in any order, one by one and on other threads."""
    modes = all_modes(beam_model(bat), BALL)
    places = PARTS * bat.length
    together = hits(modes, ball=BALL, position=places, closing_speed=SPEED, threads=1).collision_efficiency
    mixed = hits(modes, ball=BALL, position=places[order], closing_speed=SPEED, threads=2).collision_efficiency
    alone = hits(modes, ball=BALL, position=places[2], closing_speed=SPEED).collision_efficiency
    assert mixed == pytest.approx(together[order], abs=1e-12)
    assert alone == pytest.approx(together[2:3], abs=1e-12)


@examples(4)
@given(bat=BATS, speed=st.floats(15.0, 70.0))
def test_no_hit_gives_back_more_than_came(bat: Bat, speed: float) -> None:
    """Exact: energy; and a ball that gives back more leaves faster from a place without second touches."""
    found = hits(all_modes(beam_model(bat), BALL), ball=BALL, position=PARTS * bat.length, closing_speed=speed)
    assert np.nanmax(np.abs(found.collision_efficiency)) < 1.0


@examples(3)
@given(bat=PLAIN, restitution=st.floats(0.4, 0.6))
def test_a_livelier_ball_leaves_faster(bat: Bat, restitution: float) -> None:
    livelier = BALL.with_restitution(restitution + 0.02), BALL.with_restitution(restitution)
    body = rigid_body(beam_model(bat))
    more, less = (efficiencies(bat, ball)[0] for ball in livelier)
    where = np.abs(PARTS * bat.length - centre_of_percussion(body, pivot=0.15)) < 0.12
    assert np.all((more > less)[where])


@examples(3)
@given(bat=PLAIN)
def test_a_rigid_bat_is_the_limit_of_stiff_ones(bat: Bat) -> None:
    """Known limit: moduli a million times as large leave no vibration, so q follows from the two masses and e."""
    stiff = of_material(bat, moduli=1e6)
    body = rigid_body(beam_model(stiff))
    places = PARTS * bat.length
    quick = hits(all_modes(beam_model(stiff), BALL), ball=BALL, position=places, closing_speed=SPEED)
    recoil = BALL.mass / np.array([effective_mass(body, float(place)) for place in places])
    restitution = quick.collision_efficiency * (1 + recoil) + recoil
    assert np.all((restitution > 0.3) & (restitution < 0.7)) and math.isclose(
        float(np.ptp(restitution)), 0.0, abs_tol=0.06
    )

"""The fast kernel is the readable collision, hit by hit, in any company.

It shares an approach between ball and surface by one step of Chebyshev's method a kick, from a guess that is wrong by
the square of the step: 1e-8 of the force at most with steps of 8 us, and at 20 us, on handles hit at 90 m/s, 2e-8 once
in thousands of hits. Soft surfaces are solved to the end (`test_soft_bats`).
"""

from __future__ import annotations

import math
from dataclasses import astuple, fields, replace
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from sweetspot import catalog
from sweetspot.collision.coupled import STEP, hit
from sweetspot.collision.impact import Impact, Impacts, Outcome
from sweetspot.collision.kernel import CHUNK, hits, hits_with_motion
from sweetspot.collision.one_hit import quick_hit
from sweetspot.dynamics.beam import beam_model
from sweetspot.dynamics.hands import held_modes
from sweetspot.dynamics.modes import Modes
from sweetspot.dynamics.reduction import all_modes, bending_modes
from sweetspot.motion.swing import Hands

BALL = catalog.ball()
BAT = catalog.bat("r161-ash")
MODES = bending_modes(beam_model(BAT))
NUMBERS = ("collision_efficiency", "contact_time", "release_time", "peak_force", "peak_compression")


def damped(ratio: float) -> Modes:
    return bending_modes(beam_model(BAT.replaced(material=BAT.material.replaced(damping_ratio=ratio))))


def held(mass: float, stiffness: float, damping: float) -> Modes:
    return held_modes(MODES, Hands(position=0.1524, mass=mass, stiffness=stiffness, damping=damping))


BATS = st.one_of(
    st.just(MODES),
    st.integers(2, 13).map(lambda count: MODES.selected(list(range(count)))),
    st.sampled_from([0.0, 0.02, 0.1, 0.3]).map(damped),
    st.builds(held, st.floats(0.05, 1.5), st.floats(1e2, 2e5), st.one_of(st.just(0.0), st.floats(1.0, 1e3))),
)


@settings(max_examples=120)
@given(
    modes=BATS,
    place=st.floats(0.0, BAT.length),
    closing=st.floats(0.5, 110.0),
    step=st.sampled_from([4e-6, 8e-6, 20e-6]),
)
def test_kernel_is_the_readable_version(modes: Modes, place: float, closing: float, step: float) -> None:
    one = hit(modes, ball=BALL, position=place, closing_speed=closing, step=step)
    many = hits_with_motion(modes, ball=BALL, position=place, closing_speed=closing, step=step)
    assert many.outcome[0] == one.outcome
    near = 1e-8 if step <= 8e-6 else 1e-7
    for name in NUMBERS:
        expected = getattr(one, name)
        scale = 1.0 if name == "collision_efficiency" else abs(expected)
        assert getattr(many, name)[0] == pytest.approx(expected, rel=0, abs=near * scale, nan_ok=True), name
    for name in ("displacement", "velocity"):
        expected = getattr(one, name)
        scale = np.abs(expected).max()
        # at release, an instant that the two find as nearly; quick modes move that much farther meanwhile
        assert getattr(many, name)[0] == pytest.approx(expected, rel=0, abs=4 * near * scale), name


@settings(max_examples=30)
@given(modes=BATS, place=st.floats(0.0, BAT.length), closing=st.floats(0.0, 110.0))
def test_quick_hit_is_the_readable_version(modes: Modes, place: float, closing: float) -> None:
    one = hit(modes, ball=BALL, position=place, closing_speed=closing)
    assert_alike(quick_hit(modes, ball=BALL, position=place, closing_speed=closing), one)


def assert_alike(quick: Impact, one: Impact) -> None:
    assert (quick.outcome, quick.touches) == (one.outcome, one.touches)
    assert astuple(quick.energy) == pytest.approx(astuple(one.energy), rel=0, abs=1e-9 * max(1.0, one.energy.incoming))
    for name in (*NUMBERS, "displacement", "velocity", "times", "force", "compression", "impulse"):
        there, expected = (np.array(getattr(each, name), dtype=float) for each in (quick, one))
        scale = np.abs(expected).max(initial=0.0)
        assert there == pytest.approx(expected, rel=0, abs=1e-9 * scale, nan_ok=True), name
    assert (quick.unrecovered is None) == (one.unrecovered is None)
    if quick.unrecovered is not None and one.unrecovered is not None:
        assert_alike(quick.unrecovered, one.unrecovered)


def test_quick_hit_touches_twice_as_the_readable_version() -> None:
    hands = Hands(position=0.1524, mass=0.35, stiffness=20e3, damping=100.0)
    modes = held_modes(all_modes(beam_model(BAT), BALL), hands)
    one = hit(modes, ball=BALL, position=0.35, closing_speed=30.0)
    assert one.touches == 2
    assert_alike(quick_hit(modes, ball=BALL, position=0.35, closing_speed=30.0), one)


def crowd(count: int) -> dict[str, Any]:
    generator = np.random.default_rng(7)
    return {"position": generator.uniform(0.3, 0.8382, count), "closing_speed": generator.uniform(2.0, 100.0, count)}


def assert_same(one: Impacts, other: Impacts) -> None:
    assert np.array_equal(one.outcome, other.outcome)
    for name in (*NUMBERS, "displacement", "velocity"):
        assert np.array_equal(getattr(one, name), getattr(other, name), equal_nan=True), name


def rows(done: Impacts, which: Any) -> Impacts:
    return replace(done, **{field.name: getattr(done, field.name)[which] for field in fields(done)})


def test_order_of_hits_does_not_matter() -> None:
    hits_ = crowd(1000)
    shuffled = np.random.default_rng(8).permutation(1000)
    straight = hits_with_motion(MODES, ball=BALL, **hits_)
    mixed = hits_with_motion(MODES, ball=BALL, **{name: values[shuffled] for name, values in hits_.items()})
    assert_same(rows(straight, shuffled), mixed)


def test_threads_do_not_matter() -> None:
    hits_ = crowd(2 * CHUNK + 123)
    assert_same(
        hits_with_motion(MODES, ball=BALL, threads=1, **hits_), hits_with_motion(MODES, ball=BALL, threads=3, **hits_)
    )


def test_company_does_not_matter() -> None:
    hits_ = crowd(1000)
    together = hits_with_motion(MODES, ball=BALL, **hits_)
    for row in range(0, 1000, 97):
        alone = hits_with_motion(MODES, ball=BALL, **{name: values[row] for name, values in hits_.items()})
        for name in (*NUMBERS, "displacement", "velocity"):
            expected = getattr(together, name)[row]
            scale = np.abs(expected).max()
            assert getattr(alone, name)[0] == pytest.approx(expected, rel=0, abs=1e-12 * scale), name


@pytest.mark.parametrize("count", [1, 5, 70, 1000])
def test_rows_without_contact_say_so_and_the_others_go_on(count: int) -> None:
    hits_ = crowd(count)
    expected = hits_with_motion(MODES, ball=BALL, **hits_)
    missing = [np.nan, 0.0, -0.0, -70.0, -np.inf]
    speeds = np.empty((count, 2))
    speeds[:, 0] = hits_["closing_speed"]
    speeds[:, 1] = np.resize(missing, count)
    places = np.repeat(hits_["position"], 2)
    done = hits_with_motion(MODES, ball=BALL, position=places, closing_speed=speeds.ravel())
    lost, kept = rows(done, slice(1, None, 2)), rows(done, slice(0, None, 2))
    assert np.all(lost.outcome == Outcome.NO_CONTACT)
    for name in NUMBERS:
        assert np.all(np.isnan(getattr(lost, name))), name
        assert getattr(kept, name) == pytest.approx(getattr(expected, name), rel=1e-12), name
    assert np.all(kept.outcome == Outcome.SEPARATED)


def test_readable_version_agrees_on_what_is_no_contact() -> None:
    for speed in (np.nan, 0.0, -5.0):
        one = hit(MODES, ball=BALL, position=0.7, closing_speed=speed)
        assert one.outcome is Outcome.NO_CONTACT
        assert np.isnan(one.collision_efficiency)


def test_the_motion_left_out_changes_no_number() -> None:
    speeds = np.array([40.0, np.nan, 60.0, 0.0, 20.0])
    bare, whole = (each(MODES, ball=BALL, position=0.7, closing_speed=speeds) for each in (hits, hits_with_motion))
    assert bare.displacement.shape == (0, len(MODES)) and whole.displacement.shape == (5, len(MODES))
    assert bare.outcome.tolist() == whole.outcome.tolist()
    for name in NUMBERS:
        assert np.array_equal(getattr(bare, name), getattr(whole, name), equal_nan=True), name


def test_answers_have_the_shape_of_the_question() -> None:
    places, speeds = np.linspace(0.6, 0.8, 3), np.array([[40.0], [60.0]])
    table = hits_with_motion(MODES, ball=BALL, position=places, closing_speed=speeds)
    assert table.collision_efficiency.shape == table.outcome.shape == (2, 3)
    assert table.velocity.shape == (2, 3, len(MODES))
    for row, speed in enumerate(speeds[:, 0]):
        one = hits_with_motion(MODES, ball=BALL, position=places, closing_speed=speed)
        assert np.array_equal(table.collision_efficiency[row], one.collision_efficiency)
        assert np.array_equal(table.velocity[row], one.velocity)
    assert hits(MODES, ball=BALL, position=0.7, closing_speed=60.0).collision_efficiency.shape == (1,)


def test_what_does_not_part_in_time_is_still_in_contact_in_both() -> None:
    """A ball ten million times as soft is pressed flat for longer than any hit lasts."""
    soft = BALL.replaced(stiffness=1e-7 * BALL.stiffness)
    one = hit(MODES, ball=soft, position=0.7, closing_speed=1.0)
    many = hits_with_motion(MODES, ball=soft, position=0.7, closing_speed=[1.0], step=STEP)
    assert many.outcome[0] == one.outcome == Outcome.STILL_IN_CONTACT
    assert math.isnan(one.release_time) and np.isnan(many.release_time[0]) and np.isnan(many.collision_efficiency[0])
    assert many.peak_force[0] == pytest.approx(one.peak_force, rel=1e-8)
    assert many.peak_compression[0] == pytest.approx(one.peak_compression, rel=3e-4)

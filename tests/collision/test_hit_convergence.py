"""The coupled collision: orders of convergence in the time step, the ledger's closure, the number of modes."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.typing import ArrayLike, NDArray
from scipy.integrate import solve_ivp

from sweetspot import catalog
from sweetspot.collision import coupled, kernel
from sweetspot.collision.contact_law import ContactLaw, pressed_in_series
from sweetspot.collision.coupled import hit
from sweetspot.collision.impact import Outcome
from sweetspot.collision.kernel import hits, hits_with_motion
from sweetspot.collision.time_step import first_kick_after_touch
from sweetspot.dynamics.beam import BeamModel, beam_model
from sweetspot.dynamics.hands import held_modes
from sweetspot.dynamics.modes import Modes, joined
from sweetspot.dynamics.reduction import all_modes, bending_modes
from sweetspot.equipment.ball import RestitutionLaw
from sweetspot.motion.swing import Hands
from sweetspot.numerics.piecewise import Piecewise, cubic_spline
from tests.dense_bending import lowest, mesh_matrices, static_compliance

Array = NDArray[np.float64]

BALL = catalog.ball()
LINE = beam_model(catalog.bat("r161-ash"))
MODES = bending_modes(LINE)
PLACES = (0.45, 0.60, 0.68, 0.75, 0.82)
PITCH = 40.0
"""m/s; exit speeds below are for this pitch."""


def order(steps: ArrayLike, errors: ArrayLike) -> float:
    """Return the slope of log error against log step: the order of convergence."""
    return float(np.polyfit(np.log(np.asarray(steps, float)), np.log(np.abs(np.asarray(errors, float))), 1)[0])


def rms(values: ArrayLike) -> float:
    return float(np.sqrt(np.mean(np.asarray(values, float) ** 2)))


def exit_speed(modes: Modes, *, places: Array, closing: Array, step: float) -> Array:
    """Return exit speeds in m/s: q * pitch + (1 + q) * (closing - pitch)."""
    q = hits(modes, ball=BALL, position=places, closing_speed=closing, step=step).collision_efficiency
    return np.asarray(q * PITCH + (1 + q) * (closing - PITCH))


def game_hits(count: int) -> tuple[Array, Array]:
    """Return positions (m) and closing speeds (m/s) spread over barrel and game."""
    generator = np.random.default_rng(20)
    return generator.uniform(0.60, 0.82, count), generator.uniform(60.0, 80.0, count)


def test_exit_speed_converges_at_third_order() -> None:
    # Four from corrected kicks; the peak, which a parabola through three of them finds, is known to third order.
    places, closing = game_hits(300)
    converged = exit_speed(MODES, places=places, closing=closing, step=0.05e-6)
    steps = np.array([20.0, 16.0, 8.0, 4.0, 2.0]) * 1e-6
    errors = [rms(exit_speed(MODES, places=places, closing=closing, step=step) / converged - 1) for step in steps]
    assert 2.4 < order(steps, errors) < 4.5  # what is left of the damper is of second order, and small
    assert errors[0] < 1.6e-5


@pytest.mark.parametrize("exponent", [1.0, 1.2, 1.5, 2.0, 2.5, 3.0])
def test_kicks_of_a_power_add_up_to_its_integral(exponent: float) -> None:
    # exact: the sum over kicks ends like Euler's and Maclaurin's, so only what the beginning adds is left to see
    begin, count = first_kick_after_touch(exponent), 2000
    places = np.arange(count) + begin
    end = places[-1] + 0.5
    integral = end ** (exponent + 1) / (exponent + 1) - exponent * end ** (exponent - 1) / 24
    integral += 7 / 5760 * exponent * (exponent - 1) * (exponent - 2) * end ** (exponent - 3)
    assert abs(np.sum(places**exponent) - integral) < 2e-3 * 0.5 ** (exponent + 1)


def test_the_turn_scatters_little_with_its_place_between_kicks() -> None:
    # Without the impulse that kicks leave out there the deviation is 1.3e-5; without the give of steps the mean -5e-5.
    closing = np.linspace(60.0, 80.0, 200)
    places = np.full_like(closing, 0.82)
    converged = exit_speed(MODES, places=places, closing=closing, step=1e-6)
    errors = exit_speed(MODES, places=places, closing=closing, step=20e-6) / converged - 1
    assert np.std(errors) < 1.4e-5
    assert abs(np.mean(errors)) < 4e-5


@pytest.mark.parametrize(("step", "allowed"), [(coupled.STEP, 1e-5), (kernel.STEP, 1e-4)])
def test_exit_speed_at_the_default_steps(step: float, allowed: float) -> None:
    places, closing = game_hits(3000)
    converged = exit_speed(MODES, places=places, closing=closing, step=0.5e-6)
    found = exit_speed(MODES, places=places, closing=closing, step=step)
    assert np.abs(found / converged - 1).max() < allowed


@pytest.mark.parametrize("place", PLACES)
@pytest.mark.parametrize("closing", [1.0, 10.0, 40.0, 60.0, 80.0])
def test_ledger_closes_at_the_default_step(place: float, closing: float) -> None:
    ledger = hit(MODES, ball=BALL, position=place, closing_speed=closing).energy
    assert abs(ledger.imbalance) < 1e-4


@pytest.mark.parametrize("closing", [5.0, 70.0])
def test_ledger_closes_at_second_order(closing: float) -> None:
    # The slope comes up to 2 from below: heat is a trapezoidal sum, whose start (F ~ u^1.5) adds a term of order 2.5.
    steps = np.array([4.0, 2.0, 1.0, 0.5]) * 1e-6
    imbalances = [
        rms([hit(MODES, ball=BALL, position=x, closing_speed=closing, step=h).energy.imbalance for x in PLACES])
        for h in steps
    ]
    assert order(steps, imbalances) > 1.9
    assert order(steps[-2:], imbalances[-2:]) > 1.93


@pytest.mark.parametrize(
    ("name", "ball", "speed", "count", "allowed"),
    [("torpedo", "baseball", 95.0, 12, 1e-4), ("college-alloy", "baseball", 71.5, 12, 2.5e-5),
     ("tennis-racket", "tennis", 45.0, 12, 1e-5), ("hockey-stick", "field-hockey", 45.0, 12, 1e-4),
     ("cricket-bat", "cricket", 60.0, 12, 1.5e-4), ("golf-driver", "golf", 70.0, 24, 2e-5),
     ("badminton-racket", "shuttle", 30.0, 48, 5e-4)],
)  # fmt: skip
def test_few_modes_and_what_gives_way_at_once_are_two_hundred_modes(
    name: str, ball: str, speed: float, count: int, allowed: float
) -> None:
    # The outer half of a bat, the whole face but its rim of 2 % (1.3 mm of the driver's, whose heel lies at a joint),
    # wherever the ball is touched once: what a second touch does is not known to a hundredth (the docs, "Release").
    # Without the static correction the same twelve miss 0.0003 (strings) to 0.007 (the stick). A golf ball is off the
    # club's face so soon that a second dozen is taken (`excited_frequency`).
    # Without the damper, which is taken across ball and surface (`pressed_in_series`): with it some miss 0.0006.
    beam, thrown = beam_model(catalog.implement(name)), catalog.ball(ball).replaced(damping=0.0)
    few = all_modes(beam, thrown)
    length, outline = beam.bat.length, beam.bat.outline
    edges = (0.5 * length, 0.998 * length) if outline is None else (outline.start, outline.end)
    rim = 0.0 if outline is None else 0.02
    places = edges[0] + np.linspace(rim, 1 - rim, 40) * (edges[1] - edges[0])
    touches = hits(few, ball=thrown, position=places, closing_speed=speed).touches
    places = places[touches == 1]
    assert len(places) >= 25
    many = bending_modes(beam, count=120, elements=140)  # with what they leave out at these very places: as 200
    kept = many.shape_at(places)[:, 2:] ** 2 @ many.angular_frequency[2:] ** -2.0
    rest = _softening(beam) * static_compliance(beam, places) - kept
    apart = [i for i, family in enumerate(few.families) if i > 1 and family != "bending"]
    many = replace(joined(many, few.selected(apart)), compliances=(cubic_spline(places, rest), *few.compliances[1:]))

    def efficiency(modes: Modes) -> Array:
        return hits(modes, ball=thrown, position=places, closing_speed=speed, step=2e-6).collision_efficiency

    assert few.families.count("bending") == count
    assert np.abs(efficiency(few) - efficiency(many)).max() < allowed


def _softening(beam: BeamModel) -> float:
    """Return the inverse of the factor by which a measured frequency scales the beam's stiffness."""
    if beam.bat.frequency is None:
        return 1.0
    stiffness, inertia, shift = mesh_matrices(beam)
    (drawn,), _ = lowest(stiffness, inertia, first=2, last=2, shift=shift)
    return float(drawn / (2 * np.pi * beam.bat.frequency) ** 2)


@settings(max_examples=40, deadline=None)
@given(st.floats(0.0, 3e-7), st.floats(1.0, 90.0), st.sampled_from([0.45, 0.62, 0.7, 0.82]))
def test_a_surface_that_gives_way_at_once_keeps_the_ledger_closed(give: float, closing: float, place: float) -> None:
    soft = replace(MODES, compliances=(Piecewise(np.full((1, 1), give), np.array([0.0, 1.0])),))
    impact = hit(soft, ball=BALL, position=place, closing_speed=closing)
    assert abs(impact.energy.imbalance) < 1e-4
    assert hits(soft, ball=BALL, position=place, closing_speed=closing, step=4e-6).collision_efficiency[0] == (
        pytest.approx(impact.collision_efficiency, abs=3e-7)
    )


def test_a_soft_surface_before_a_lossless_one_is_two_springs_in_a_row() -> None:
    # exact: a linear ball without loss on a heavy bat touches for pi sqrt(m (1/k + C)) and keeps all its speed
    law = RestitutionLaw(reference=1.0, reference_speed=20.0)
    ball = BALL.replaced(restitution=law, stiffness=2e6, exponent=1.0, damping=0.0)
    heavy = replace(MODES.selected([0]), shapes=Piecewise(np.full((1, 1, 1), 1e-4), np.array([0.0, 1.0])))
    soft = replace(heavy, compliances=(Piecewise(np.full((1, 1), 3e-7), np.array([0.0, 1.0])),))
    impact = hit(soft, ball=ball, position=0.7, closing_speed=30.0)
    assert impact.collision_efficiency == pytest.approx(1.0, abs=1e-5)
    assert impact.release_time == pytest.approx(np.pi * np.sqrt(ball.mass * (1 / 2e6 + 3e-7)), rel=1e-5)
    assert impact.peak_force == pytest.approx(30.0 * np.sqrt(ball.mass / (1 / 2e6 + 3e-7)), rel=1e-4)


def _integrated_until_gone(modes: Modes, place: float, closing: float, *, until: float) -> float:
    """Return -v_ball / v_closing at a time: ball and modes by scipy's DOP853, phase by phase, without the solver."""
    shape, give, law = modes.shape_at(place), float(modes.compliance_at(place)), ContactLaw(BALL)
    rate, stiffness, size = modes.damping_rate, modes.angular_frequency**2, len(modes)

    def approach(state: Array) -> float:
        return float(state[0] - shape @ state[2 : 2 + size])

    def closing_in(state: Array) -> float:
        return float(state[1] - shape @ state[2 + size :])

    state, now, phase, peak = np.concatenate([[0.0, closing], np.zeros(2 * size)]), 0.0, "load", 0.0
    while now < until:
        turned = None if phase == "load" else peak

        def push(state: Array, phase: str = phase, turned: float | None = turned) -> float:
            together = approach(state)
            if phase == "free" or together <= 0:
                return 0.0
            _, elastic, slope = pressed_in_series(law, approach=together, compliance=give, turned_at=turned)
            return max(0.0, elastic * (1 + BALL.damping / (1 + give * slope) * closing_in(state)))

        def motion(_: float, state: Array) -> Array:
            force, q, speed = push(state), state[2 : 2 + size], state[2 + size :]
            return np.concatenate([[state[1], -force / BALL.mass], speed, shape * force - rate * speed - stiffness * q])

        def turns(_: float, state: Array, phase: str = phase) -> float:
            return closing_in(state) if phase == "load" else approach(state) + (1e-12 if phase == "unload" else -1e-12)

        turns.terminal, turns.direction = True, 1.0 if phase == "free" else -1.0  # type: ignore[attr-defined]
        done = solve_ivp(motion, (now, until), state, method="DOP853", rtol=1e-8, atol=1e-10, events=turns)
        state, now = done.y[:, -1], float(done.t[-1])
        if phase == "load":
            peak, *_ = pressed_in_series(law, approach=approach(state), compliance=give, turned_at=None)
        phase = {"load": "unload", "unload": "free", "free": "load"}[phase]
    return -float(state[1]) / closing


@pytest.mark.parametrize("hands", [Hands(position=0.15), Hands(position=0.15, mass=0.9, stiffness=3e4)])
def test_a_bat_that_overtakes_the_ball_hits_it_again(hands: Hands) -> None:
    # A metal bat struck near its middle swings back on to the ball about 2 ms later. Truth: the same equations by an
    # adaptive integrator of order 8, phase by phase.
    beam = beam_model(catalog.bat("single-wall"))
    modes = held_modes(all_modes(beam, BALL), hands)
    place, closing = beam.bat.length - 0.45, 60.0  # where the second push rises once; the integrator knows no reloading
    impact = hit(modes, ball=BALL, position=place, closing_speed=closing)
    free = np.flatnonzero(impact.force[1:] == 0)
    assert impact.outcome is Outcome.SEPARATED
    assert len(free) > 10 and impact.force[free[-1] + 2] > 0
    assert abs(impact.energy.imbalance) < 1e-4
    once = _integrated_until_gone(modes, place, closing, until=float(impact.times[free[0] + 1]))
    assert impact.collision_efficiency == pytest.approx(
        _integrated_until_gone(modes, place, closing, until=impact.release_time + 1e-4), abs=5e-4
    )
    assert impact.collision_efficiency > once + 0.05
    assert impact.touches == 2
    unrecovered = impact.unrecovered
    assert unrecovered is not None and hit(MODES, ball=BALL, position=0.7, closing_speed=70.0).unrecovered is None
    assert unrecovered.touches >= 2 and abs(unrecovered.energy.imbalance) < 1e-4
    assert unrecovered.collision_efficiency > once
    assert abs(unrecovered.collision_efficiency - impact.collision_efficiency) > 0.02  # softer, and without loss
    many = hits_with_motion(modes, ball=BALL, position=place, closing_speed=closing, step=4e-6)
    assert many.collision_efficiency[0] == pytest.approx(impact.collision_efficiency, abs=1e-8)
    assert many.touches.tolist() == [2]
    three = hits(modes, ball=BALL, position=[0.7, place, 0.7], closing_speed=[closing, closing, -1.0])
    assert three.touches.tolist() == [1, 2, 0]
    assert many.release_time[0] == pytest.approx(impact.release_time, rel=1e-9)
    assert many.velocity[0] == pytest.approx(impact.velocity, abs=1e-7)


def test_release_is_found_between_steps() -> None:
    # Found at the first step past it, release would miss by a step; as a root it converges with the motion itself.
    def release(step: float) -> float:
        return hit(MODES, ball=BALL, position=0.7, closing_speed=70.0, step=step).release_time

    converged = release(0.25e-6)
    assert abs(release(4e-6) - converged) < 0.02 * 4e-6
    assert math.isclose(release(8e-6), converged, rel_tol=1e-4)

"""What changes a bat: a torpedo, a corked bat, the hands, and the motions that it has."""

from __future__ import annotations

from functools import cache

import numpy as np

from sweetspot import catalog
from sweetspot.analysis.bat_analysis import TYPICAL_HAND
from sweetspot.analysis.certification.simulated_test import BatTest, bat_test
from sweetspot.collision.closed_form import bbcor
from sweetspot.collision.coupled import hit
from sweetspot.collision.free_motion import modal_propagator_of
from sweetspot.collision.kernel import hits
from sweetspot.dynamics.beam import beam_model, section
from sweetspot.dynamics.hands import held_modes
from sweetspot.dynamics.modes import Modes
from sweetspot.dynamics.reduction import all_modes, bending_modes
from sweetspot.dynamics.rigid import RigidBody, centre_of_percussion, rigid_body
from sweetspot.equipment.bat import Bat
from sweetspot.motion.swing import Hands
from sweetspot.numerics.arrays import Array
from sweetspot.units import INCH, MPH
from sweetspot.validation.computations import shared

TEST_SPEED = 136 * MPH
FATTEST = 6.5 * INCH
"""m from the tip: designers aim six or seven inches below it."""
SWELLING = 0.08 * INCH
"""m by which the barrel grows halfway from there to where it begins, 13 in from the tip."""
SWOLLEN = 13 * INCH
AXIS = 6 * INCH


def made_torpedo(bat: Bat, *, thinner: float) -> Bat:
    """Return a bat like another, thinner at its end by ``thinner`` m, as heavy and as hard to swing about 6 in."""
    body = rigid_body(beam_model(bat))
    place, diameter = np.array(bat.profile).T
    places = np.union1d(place, np.linspace(bat.length - SWOLLEN, bat.length - 0.3 * INCH, 27))
    from_tip = bat.length - places
    part = np.clip(1 - from_tip / FATTEST, 0, 1)
    inside = (from_tip > FATTEST) & (from_tip < SWOLLEN)
    swollen = np.where(inside, np.sin(np.pi * (from_tip - FATTEST) / (SWOLLEN - FATTEST)), 0.0)
    new = np.interp(places, place, diameter) - thinner * part**2 * (3 - 2 * part) + SWELLING * swollen
    profile = tuple(zip(places.tolist(), new.tolist(), strict=True))
    return bat.replaced(
        name=f"{bat.name}, torpedo", profile=profile, mass=body.mass, moi=body.moi(AXIS), moi_axis=AXIS,
        balance_point=None,
    )  # fmt: skip


@cache
def _tested(bat: str, thinner: float) -> BatTest:
    """Return the bat test of a catalogue bat, or of a torpedo made of it."""
    plain, ball = catalog.bat(bat), catalog.ball()
    beam = beam_model(made_torpedo(plain, thinner=thinner) if thinner else plain)
    modes = all_modes(beam, ball)
    return bat_test(beam, body=rigid_body(beam), modes=modes, ball=ball, closing_speed=TEST_SPEED)


def torpedo_shift(*, bat: str, thinner: float) -> float:
    """Return how far the place of the greatest BBCOR moves towards the hands."""
    return _tested(bat, 0.0).best_position - _tested(bat, thinner).best_position


def torpedo_bbcor_gain(*, bat: str, thinner: float) -> float:
    """Return how much the greatest BBCOR grows."""
    return _tested(bat, thinner).best_bbcor - _tested(bat, 0.0).best_bbcor


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


HANDS = 6 * INCH
VICE = 1e9
"""N/m of each of two places 3.5 in apart: a handle that can neither move nor turn."""
BENCH = 1e4
"""kg behind each of them."""
BARREL = np.linspace(3 * INCH, 9 * INCH, 25)
"""m from the tip: barrel impacts."""
MANY_MODES = 40
"""Bending modes up to about 30 kHz, so that motion cannot arrive before the wave does."""
STEP = 2e-6
WATCHED = 3e-3
"""s after the touch in which the handle's greatest speed is looked for."""
ARRIVED = 0.1
"""Part of that speed at which the wave has arrived."""


def grip_change(*, bat: str) -> float:
    """Return the greatest relative change of exit speed on the barrel by typical hands and by a vice."""
    analysis = shared.standard(bat)
    conditions, free = analysis.conditions, shared.free_modes(bat)
    places = shared.length(bat) - BARREL
    swing = conditions.swing.angular_speed * (places - conditions.swing.pivot)

    def speeds(modes: Modes) -> Array:
        closing = conditions.pitch.speed + swing
        done = hits(modes, ball=conditions.ball, position=places, closing_speed=closing)
        efficiency = done.collision_efficiency
        return np.asarray(efficiency * conditions.pitch.speed + (1 + efficiency) * swing)

    alone = speeds(free)
    grips = (Hands(position=HANDS, **TYPICAL_HAND), Hands(position=HANDS, mass=BENCH, stiffness=VICE))
    return max(float(np.abs(speeds(held_modes(free, hands)) / alone - 1).max()) for hands in grips)


def impulse_given_at_arrival(*, bat: str) -> float:
    """Return which part of the impulse the ball has given when the wave of the best hit arrives at the top hand.

    The handle's motion is the sum of all modes driven by the recorded force, step by step.
    """
    conditions = shared.standard(bat).conditions
    place = shared.standard(bat).sweet_spots.max_exit_speed
    modes = bending_modes(shared.beam(bat), count=MANY_MODES, elements=MANY_MODES)
    closing = conditions.pitch.speed + conditions.swing.speed_at(place)
    force = hit(modes, ball=conditions.ball, position=place, closing_speed=closing, step=STEP).force
    drift, push, handle = modal_propagator_of(modes, STEP), modes.shape_at(place), modes.shape_at(HANDS)
    displacement, velocity = np.zeros(len(modes)), np.zeros(len(modes))
    speed = np.empty(round(WATCHED / STEP))
    for step in range(len(speed)):
        if step < len(force):
            velocity = velocity + push * force[step] * STEP
        displacement, velocity = (
            drift[:, 0, 0] * displacement + drift[:, 0, 1] * velocity,
            drift[:, 1, 0] * displacement + drift[:, 1, 1] * velocity,
        )
        speed[step] = abs(handle @ velocity)
    arrival = int(np.argmax(speed > ARRIVED * speed.max()))
    return float(force[: arrival + 1].sum() / force.sum())


THIN_LENGTH, THIN_DIAMETER = 1.3, 0.005
"""m; the longest and thinnest rod that a bat may be: radius of gyration over length is 1/1040."""


def thin_rod_root(*, mode: int) -> float:
    """Return beta L of a thin aluminium rod hung freely, beta^4 = omega^2 mu / (E I)."""
    modes, ratio = _thin_rod()
    return float((modes.angular_frequency[modes.of_family("bending")[mode - 1]] ** 2 * ratio) ** 0.25 * THIN_LENGTH)


def thin_rod_node() -> float:
    """Return the outer node of its first mode, distance from the end over length."""
    modes, _ = _thin_rod()
    return float(modes.nodes(modes.of_family("bending")[0])[0] / THIN_LENGTH)


@cache
def _thin_rod() -> tuple[Modes, float]:
    """Return the rod's modes and its mass per length over bending stiffness."""
    bat = Bat(
        name="thin rod",
        length=THIN_LENGTH,
        material=catalog.material("aluminium_7xxx"),
        profile=((0.0, THIN_DIAMETER), (THIN_LENGTH, THIN_DIAMETER)),
    )
    beam = beam_model(bat)
    at = section(beam, np.array([THIN_LENGTH / 2]))
    return bending_modes(beam, count=3), float(at.mass[0] / at.bending_stiffness[0])


def frequency(*, bat: str, mode: int) -> float:
    """Return the frequency of a free bending mode."""
    modes = shared.free_modes(bat)
    return float(modes.frequency[modes.of_family("bending")[mode - 1]])


def node_from_tip(*, bat: str, mode: int, node: int) -> float:
    """Return how far from the tip a node lies; ``node`` counts from the tip."""
    modes = shared.free_modes(bat)
    return float(shared.length(bat) - modes.nodes(modes.of_family("bending")[mode - 1])[-node])


def node_from_knob(*, bat: str, mode: int, node: int) -> float:
    """Return how far from the knob end a node lies; ``node`` counts from the knob."""
    modes = shared.free_modes(bat)
    return float(modes.nodes(modes.of_family("bending")[mode - 1])[node - 1])


def node_percussion_distance(*, bat: str, pivot: float) -> float:
    """Return how much further from the tip the first mode's node is than the centre of percussion about ``pivot``."""
    percussion_from_tip = shared.length(bat) - centre_of_percussion(shared.body(bat), pivot=pivot)
    return node_from_tip(bat=bat, mode=1, node=1) - percussion_from_tip


def grip_frequency_change(*, bat: str) -> float:
    """Return the relative change of the first bending frequency in typical hands, 6 in from the knob end.

    The motion of the held bat that is most like the free mode is the one compared.
    """
    free = shared.free_modes(bat)
    held = held_modes(free, Hands(position=6 * INCH, **TYPICAL_HAND))
    first = free.of_family("bending")[0]
    places = np.linspace(0, shared.length(bat), 200)
    likeness = np.corrcoef(free.shape_at(places)[:, first], held.shape_at(places), rowvar=False)[0, 1:]
    return float(held.frequency[np.abs(likeness).argmax()] / free.frequency[first] - 1)

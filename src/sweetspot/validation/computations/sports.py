"""Other sports: the arithmetic of rackets and clubs, drop tests of rule books, forces on their balls."""

from __future__ import annotations

import math
from dataclasses import replace
from functools import cache
from typing import NamedTuple

import numpy as np

from sweetspot import catalog
from sweetspot.analysis.bat_analysis import Analysis, analyse_reduced, dead_spot, exit_speed_of
from sweetspot.analysis.drop_test import fire, terminal_speed
from sweetspot.catalog.scaled_implements import Measures, scaled_to
from sweetspot.catalog.standard_hit import standard_conditions
from sweetspot.catalog.swing_laws import swing_law
from sweetspot.collision.coupled import hit
from sweetspot.collision.impact import Impact
from sweetspot.dynamics.beam import beam_model
from sweetspot.dynamics.reduction import ReducedBat, all_modes, bending_modes, reduced_bat
from sweetspot.dynamics.rigid import RigidBody, centre_of_percussion, effective_mass, rigid_body
from sweetspot.dynamics.swing_weight import pendulum_period
from sweetspot.equipment.ball import restitution_at
from sweetspot.equipment.cricket_bat import CricketBat
from sweetspot.equipment.implement import Implement
from sweetspot.equipment.racket import Racket
from sweetspot.equipment.table_tennis_racket import TableTennisRacket
from sweetspot.flight.air import Air
from sweetspot.flight.conditions import FlightConditions
from sweetspot.flight.trajectory import Flight, fly
from sweetspot.motion.ball_motion import batted_ball
from sweetspot.motion.swing import Conditions
from sweetspot.papers.sports import rule_book_drops
from sweetspot.validation.computations.rigid import listed_body


def racket_percussion(*, axis: float, **line: float) -> float:
    """Return the center of percussion from the butt of a racket that turns about ``axis``."""
    return centre_of_percussion(listed_body(axis=axis, **line), pivot=axis)


class ButtWeight(NamedTuple):
    """Changes of a racket by a weight at its butt: center of percussion, balance point, moment about the axis."""

    percussion: float
    balance_point: float
    swing_weight: float


def butt_weight(*, mass: float, balance_point: float, moi: float, axis: float, added_mass: float) -> ButtWeight:
    """Return the changes caused by a weight at the butt."""
    before = listed_body(mass=mass, balance_point=balance_point, moi=moi, axis=axis)
    heavier = mass + added_mass
    balance = mass * balance_point / heavier
    after = RigidBody(heavier, balance, before.moi(0.0) - heavier * balance**2, 0.0)
    shift = centre_of_percussion(after, pivot=axis) - centre_of_percussion(before, pivot=axis)
    return ButtWeight(shift, balance - balance_point, after.moi(axis) - moi)


def efficiency_of_speed_ratio(*, share: float) -> float:
    """Return q of an implement that sends a ball at rest off at this share of its own speed."""
    return share - 1


def rule_book_rebound(*, sport: str, test: str) -> float:
    """Return the height that the ball of a sport reaches in a drop test of its rule book."""
    return rule_book_drops(sport)[test].rebound


def swing_law_loss(*, moi: float, other_moi: float, speed: float) -> float:
    """Return the loss of head speed with ``other_moi`` against ``moi`` at ``speed``, by the bats' power law."""
    law = replace(swing_law(), lightest_moi=min(moi, other_moi))
    return speed * (1 - law.speed_ratio(other_moi, reference_moi=moi))


def struck(*, implement: str, from_tip: float, closing_speed: float, lateral: float = 0.0) -> Impact:
    """Return the hit of the usual ball, at rest, at a place of an implement that comes with ``closing_speed``."""
    reduced = _reduced(implement)
    place, ball = reduced.bat.length - from_tip, _conditions(implement).ball
    return hit(reduced.modes, ball=ball, position=place, lateral=lateral, closing_speed=closing_speed)


def first_node_from_tip(*, implement: str) -> float:
    """Return the node of the first mode nearest to the tip, from the tip."""
    analysis = _usual(implement)
    return analysis.bat.length - analysis.sweet_spots.node_1


def percussion_towards_hands(*, implement: str, axis: float) -> float:
    """Return the distance from the node of the first mode to the center of percussion about ``axis``, to the hands."""
    return _usual(implement).sweet_spots.node_1 - centre_of_percussion(_reduced(implement).body, pivot=axis)


def moi_about_end(*, implement: str) -> float:
    """Return the moment of inertia of an implement about the end that the hands hold."""
    return _reduced(implement).body.moi(0.0)


def swing_time_about_end(*, implement: str) -> float:
    """Return the period of an implement that swings about the end that the hands hold."""
    body = _reduced(implement).body
    return pendulum_period(body.moi(0.0), mass=body.mass, balance_point=body.balance_point, pivot=0.0)


def faster_ball(*, implement: str, share: float) -> float:
    """Return the relative gain of exit speed at the best place from a swing faster by ``share``."""
    analysis, conditions = _usual(implement), _conditions(implement)
    swing = conditions.swing
    faster = conditions.replaced(swing=swing.replaced(bat_speed=(1 + share) * swing.bat_speed))
    after = analyse_reduced(_reduced(implement), faster)
    return exit_speed_of(after.best, faster) / exit_speed_of(analysis.best, conditions) - 1


def best_bounce_from_throat(*, implement: str) -> float:
    """Return the place of the greatest q from the throat end of the strings."""
    analysis = _usual(implement)
    assert analysis.bat.outline is not None, "only rackets are asked"
    return analysis.sweet_spots.max_collision_efficiency - analysis.bat.outline.start


def node_from_middle(*, implement: str) -> float:
    """Return the distance from the middle of the face to the head's node of the first mode, towards the tip."""
    analysis = _usual(implement)
    assert analysis.bat.outline is not None, "only rackets are asked"
    return analysis.sweet_spots.node_1 - analysis.bat.outline.middle


def dead_spot_from_tip(*, implement: str) -> float:
    """Return the place near the tip where a ball is left with no speed, from the tip."""
    analysis = _usual(implement)
    place = dead_spot(analysis)
    assert place is not None, "only rackets with a dead spot are asked"
    return analysis.bat.length - place


def usual_smash_factor(*, implement: str) -> float:
    """Return exit speed over the implement's speed at its best place under the usual stroke."""
    best, conditions = _usual(implement).best, _conditions(implement)
    return exit_speed_of(best, conditions) / conditions.swing.speed_at(best.position)


def usual_exit_speed(*, implement: str) -> float:
    """Return the greatest exit speed under the usual stroke."""
    return exit_speed_of(_usual(implement).best, _conditions(implement))


def drag_from_two_cameras(*, ball: str, air: str, speed: float, distance: float) -> float:
    """Return the drag coefficient that two level speeds a distance apart give: 2 m ln(v1 / v2) / (rho pi R^2 x)."""
    flight = sport_flight(ball=ball, air=air, speed=speed, launch_angle=math.radians(5), backspin=0.0)
    thing = catalog.ball(ball)
    along = flight.positions[:, 1]
    index = int((along < distance).sum())
    first, second = (float(flight.velocities[k][1]) for k in (0, index))
    area = math.pi * thing.radius**2
    return 2 * thing.mass * math.log(first / second) / (SHEET_AIR.density * area * float(along[index]))


SHEET_AIR = Air(temperature=(70 - 32) / 1.8)
"""70 degF, sea level."""


@cache
def sport_flight(*, ball: str, air: str, speed: float, launch_angle: float, backspin: float) -> Flight:
    """Return the flight of a ball from the ground to the ground at 70 degF and sea level."""
    start = batted_ball(speed=speed, launch_angle=launch_angle, backspin=backspin)
    return fly(start, FlightConditions(ball=catalog.ball(ball), aerodynamics=catalog.aerodynamics(air), air=SHEET_AIR))


@cache
def _conditions(implement: str) -> Conditions:
    return standard_conditions(catalog.implement(implement))


@cache
def _reduced(implement: str) -> ReducedBat[Implement]:
    return reduced_bat(catalog.implement(implement), ball=_conditions(implement).ball)


@cache
def _usual(implement: str) -> Analysis[Implement]:
    return analyse_reduced(_reduced(implement), _conditions(implement))


def wall_restitution_of(*, ball: str, speed: float) -> float:
    """Return the restitution of a ball on a rigid wall."""
    return restitution_at(catalog.ball(ball).restitution, speed)


def squared_restitution(*, ball: str, speed: float) -> float:
    """Return rebound over fall of a ball that meets a rigid wall at a speed, without air."""
    return wall_restitution_of(ball=ball, speed=speed) ** 2


def plates_approach(*, ball: str, force: float) -> float:
    """Return the approach of two plates that press a ball with a slow force: twice the compression on a wall."""
    thing = catalog.ball(ball)
    return float(2 * (force / thing.stiffness) ** (1 / thing.exponent))


def best_above_middle(*, implement: str) -> float:
    """Return how much nearer the tip than the middle of the face the fastest ball leaves."""
    analysis = _usual(implement)
    assert analysis.bat.outline is not None, "only rackets are asked"
    return analysis.sweet_spots.max_exit_speed - analysis.bat.outline.middle


def grip_share(*, implement: str) -> float:
    """Return the relative change of the best hit's exit speed by typical hands."""
    return _usual(implement).grip_effect


def scaled_moi(*, implement: str, **measures: float) -> float:
    """Return the moment of inertia about the butt end of an implement with given length, mass and balance point."""
    tool, _ = scaled_to(catalog.implement(implement), Measures(**measures))
    return rigid_body(beam_model(tool)).moi(0.0)


def shape_spread(*, implement: str) -> float:
    """Return how much a cricket bat's moment about its end varies with its blade's shape, weight and balance alike."""
    bat = catalog.implement(implement)
    assert isinstance(bat, CricketBat)
    body = rigid_body(beam_model(bat))
    bat = bat.replaced(mass=body.mass, balance_point=body.balance_point)
    found = []
    for shift in (-0.06, -0.03, 0.0, 0.03, 0.06):
        for concavity in (1.0, 1.4, 2.0):
            spine = tuple(
                (place + (shift if 0 < index < len(bat.spine) - 1 else 0.0), size)
                for index, (place, size) in enumerate(bat.spine)
            )
            found.append(rigid_body(beam_model(bat.replaced(spine=spine, concavity=concavity))).moi(0.0))
    return max(found) / min(found) - 1


def _racket_with(implement: str, **changes: float) -> Racket:
    racket = catalog.implement(implement)
    assert isinstance(racket, Racket)
    return racket.replaced(**changes)


def node_shift_by_swing_weight(*, implement: str, moi: float, other_moi: float) -> float:
    """Return the shift of the head's node of mode 1 toward the tip when the swing weight grows from ``moi``."""
    nodes = []
    for weight in (moi, other_moi):
        beam = beam_model(_racket_with(implement, moi=weight))
        modes = all_modes(beam, _conditions(implement).ball)
        nodes.append(modes.nodes(modes.of_family("bending")[0])[-1])
    return float(nodes[1] - nodes[0])


def exit_change_by_swing_weight(*, implement: str, moi: float, other_moi: float, slower: float) -> float:
    """Return the change of the best exit speed when the swing weight grows and the head is ``slower``."""
    conditions, speeds = _conditions(implement), []
    for weight, lost in ((moi, 0.0), (other_moi, slower)):
        racket = _racket_with(implement, moi=weight)
        swung = conditions.replaced(swing=conditions.swing.replaced(bat_speed=conditions.swing.bat_speed - lost))
        speeds.append(exit_speed_of(analyse_reduced(reduced_bat(racket, ball=conditions.ball), swung).best, swung))
    return speeds[1] - speeds[0]


def efficiency_change_by_tension(*, implement: str, from_tip: float, closing_speed: float, tension: float) -> float:
    """Return the change of q at a place when strings are drawn tighter by ``tension`` newtons each."""
    racket = catalog.implement(implement)
    assert isinstance(racket, Racket) and racket.strings is not None
    tighter = racket.replaced(strings=racket.strings.replaced(tension=racket.strings.tension + tension))
    ball, found = _conditions(implement).ball, []
    for tool in (racket, tighter):
        modes = reduced_bat(tool, ball=ball).modes
        place = tool.length - from_tip
        found.append(hit(modes, ball=ball, position=place, closing_speed=closing_speed).collision_efficiency)
    return float(found[1] - found[0])


def skirt_drag(*, area: float) -> float:
    """Return the drag coefficient of a shuttle on the area of its skirt."""
    radius = catalog.ball("shuttle").radius
    return catalog.aerodynamics("shuttle").drag * math.pi * radius**2 / area


def steeper_fall(*, ball: str, air: str, speed: float, launch_angle: float) -> float:
    """Return how much steeper a ball lands than it started."""
    return (
        sport_flight(ball=ball, air=air, speed=speed, launch_angle=launch_angle, backspin=0.0).landing_angle
        - launch_angle
    )


def drag_per_length(*, ball: str, air: str) -> float:
    """Return the part of its speed that a ball without spin loses per metre of its way, rho C_D pi R^2 / (2 m)."""
    thing, law = catalog.ball(ball), catalog.aerodynamics(air)
    return SHEET_AIR.density * law.drag * math.pi * thing.radius**2 / (2 * thing.mass)


def half_speed_distance(*, ball: str, air: str) -> float:
    """Return the distance in which drag halves the speed of a ball."""
    return math.log(2) / drag_per_length(ball=ball, air=air)


def falling_speed(*, ball: str, air: str) -> float:
    """Return the terminal speed of a ball with the drag of its flights."""
    law = catalog.aerodynamics(air)
    return terminal_speed(catalog.ball(ball), air_density=SHEET_AIR.density, drag_coefficient=law.drag)


def time_to_slow(*, ball: str, air: str, speed: float, other_speed: float) -> float:
    """Return the time after which a ball hit level at 3 m is no faster than ``other_speed``."""
    start = batted_ball(speed=speed, launch_angle=0.0, position=(0.0, 0.0, 3.0))
    conditions = FlightConditions(ball=catalog.ball(ball), aerodynamics=catalog.aerodynamics(air), air=SHEET_AIR)
    flight = fly(start, conditions)
    speeds = np.linalg.norm(flight.velocities, axis=1)
    slow = int(np.argmax(speeds <= other_speed))
    assert slow, "only balls that become as slow are asked"
    return float(np.interp(-other_speed, -speeds[: slow + 1], flight.times[: slow + 1]))


def table_restitution(*, speed: float) -> float:
    """Return the restitution of the usual ball on half a table-tennis table."""
    return fire(
        rule_book_drops("table tennis")["bounce on the table"].block, ball=catalog.ball("table_tennis"), speed=speed
    ).restitution


def racket_restitution(*, implement: str, closing_speed: float) -> float:
    """Return e of ball and implement, q (1 + r) + r with r = m / M_eff, at its best place."""
    reduced, place = _reduced(implement), _usual(implement).best.position
    ball = _conditions(implement).ball
    recoil = ball.mass / effective_mass(reduced.body, place)
    found = hit(reduced.modes, ball=ball, position=place, closing_speed=closing_speed)
    return found.collision_efficiency * (1 + recoil) + recoil


def restitution_change(*, implement: str, closing_speed: float, other_speed: float) -> float:
    """Return the change of that restitution from one closing speed to another."""
    before, after = (
        racket_restitution(implement=implement, closing_speed=speed) for speed in (closing_speed, other_speed)
    )
    return after - before


def lost_off_best(*, implement: str, along: float = 0.0, lateral: float = 0.0) -> float:
    """Return the share of the best exit speed lost by a hit off the best place; of the ways along it the worse."""
    analysis, conditions = _usual(implement), _conditions(implement)
    speeds = []
    for place in (analysis.best.position - along, analysis.best.position + along):
        closing = conditions.pitch.speed + conditions.swing.speed_at(place)
        found = hit(
            _reduced(implement).modes, ball=conditions.ball, position=place, lateral=lateral, closing_speed=closing
        )
        speeds.append((1 + found.collision_efficiency) * closing - conditions.pitch.speed)
    return 1 - min(speeds) / exit_speed_of(analysis.best, conditions)


def line_shift(*, implement: str, shift: float) -> float:
    """Return the relative change of a cricket bat's moment about its end when its blade begins further out."""
    bat = catalog.implement(implement)
    assert isinstance(bat, CricketBat)
    body = rigid_body(beam_model(bat))
    bat = bat.replaced(mass=body.mass, balance_point=body.balance_point)
    blade = {
        name: ((stations[0][0] + shift, stations[0][1]), *stations[1:])
        for name, stations in (("width", bat.width), ("spine", bat.spine), ("edge", bat.edge))
    }
    end, diameter = bat.handle[-1]
    moved = bat.replaced(handle=(*bat.handle[:-1], (end + shift, diameter)), **blade)
    before, after = (rigid_body(beam_model(tool)).moi(0.0) for tool in (bat, moved))
    return abs(after / before - 1)


def lift_of(*, air: str, spin_factor: float) -> float:
    """Return the lift coefficient of a ball at a spin factor."""
    return catalog.aerodynamics(air).lift_coefficient(spin_factor)


def rubber_tone_change(*, implement: str, mode: int) -> float:
    """Return the relative change of a bending tone of a blade by gluing both rubbers on."""
    racket = catalog.implement(implement)
    assert isinstance(racket, TableTennisRacket) and racket.front is not None
    tones = []
    for tool in (racket.replaced(front=racket.front.replaced(areal_density=1e-6), back=None), racket):
        modes = bending_modes(beam_model(tool), count=max(mode, 2))
        tones.append(float(modes.frequency[modes.of_family("bending")[mode - 1]]))
    return tones[1] / tones[0] - 1


def faster_by_stiffness(*, implement: str, from_tip: float, closing_speed: float, factor: float) -> float:
    """Return the relative gain of the speed of a ball at rest from a stick stiffer by ``factor`` around the usual."""
    soft, stiff = (
        gain_by_stiffness(implement=implement, from_tip=from_tip, closing_speed=closing_speed, factor=factor**power)
        for power in (-0.5, 0.5)
    )
    usual = struck(implement=implement, from_tip=from_tip, closing_speed=closing_speed).collision_efficiency
    return (1 + usual + stiff) / (1 + usual + soft) - 1


def gain_by_stiffness(*, implement: str, from_tip: float, closing_speed: float, factor: float) -> float:
    """Return the gain of q at a place, first touch, when the material of a stick is stiffer by ``factor``."""
    stick = catalog.implement(implement)
    material = stick.materials[0]
    stiff = material.replaced(
        longitudinal_modulus=factor * material.longitudinal_modulus, shear_modulus=factor * material.shear
    )
    ball, found = _conditions(implement).ball, []
    for tool in (stick, stick.replaced(material=stiff)):
        modes = reduced_bat(tool, ball=ball).modes
        found.append(
            hit(modes, ball=ball, position=tool.length - from_tip, closing_speed=closing_speed).collision_efficiency
        )
    return found[1] - found[0]

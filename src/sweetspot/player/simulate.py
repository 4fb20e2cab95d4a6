"""Simulated swings of a player with known parameters, for tests of the fit."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from sweetspot.catalog.swing_laws import swing_law
from sweetspot.equipment.ball import Ball
from sweetspot.equipment.bat import Bat
from sweetspot.motion.swing import SPEED_FROM_TIP
from sweetspot.numerics.arrays import Array
from sweetspot.player.bat_response import BatResponse, response_of
from sweetspot.player.model import arm_ratio, speed_ratio
from sweetspot.player.off_centre import STEEPEST_LAUNCH, at_swings, deflection_noise
from sweetspot.player.player_swing import PlayerSwing
from sweetspot.player.prior import NAMES, fixed, priors


def simulated_swings(
    parameters: Array,
    *,
    bats: Sequence[Bat],
    ball: Ball,
    count: int,
    pitch_speed: float,
    seed: int,
    speed_from_tip: float = SPEED_FROM_TIP,
) -> tuple[PlayerSwing, ...]:
    """Return swings of a player with these parameters, everything but the contact position measured.

    Swing by swing bat speed, position, offset and attack angle are drawn, the hit is read off the bat's table, and
    the measuring errors are added. The bats take turns; swings that miss, and balls that leave too steeply for a hit,
    are drawn again.

    ``parameters``: shape (10,), SI, in the order of `NAMES`. ``bats``: the player's own first. ``pitch_speed``: m/s at
    the plate; 0: a tee.
    """
    values = dict(zip(NAMES, (float(value) for value in parameters), strict=True))
    generator = np.random.default_rng(seed)
    law = swing_law()
    tables = [response_of(bat, ball=ball, axis=law.axis) for bat in bats]
    exponent = np.array([values["exponent"]])
    swings = []
    for row in range(count):
        table = tables[row % len(tables)]
        ratio = float(speed_ratio(table, tables[0], law=law, speed_from_tip=speed_from_tip, exponent=exponent)[0])
        swing = _swing(values, table, ratio, pitch_speed, speed_from_tip, generator)
        swings.append(replace(swing, row=row + 2, bat="" if table is tables[0] else table.bat.name))
    return tuple(swings)


def _swing(
    values: dict[str, float],
    table: BatResponse,
    ratio: float,
    pitch: float,
    speed_from_tip: float,
    generator: np.random.Generator,
) -> PlayerSwing:
    draw = generator.standard_normal
    while True:
        speed = ratio * values["bat_speed"] + values["bat_speed_spread"] * draw()
        attack = values["attack_angle"] + fixed("attack_angle_spread") * draw()
        place = values["position"] + values["position_spread"] * draw()
        offset = values["offset"] + values["offset_spread"] * draw()
        if not (0 <= place <= table.from_tip[-1] and abs(offset) < table.offset[-1]):
            continue
        steeper = attack - priors()["attack_angle"].centre
        tabled = at_swings(table, np.array([pitch / speed]), np.array([steeper]), np.array([place]))
        retained, deflection = (float(np.interp(offset, table.offset, part[0, 0])) for part in tabled)
        noise = np.interp(offset, table.offset, deflection_noise(table, np.array([pitch / speed]))[0])
        launch = attack + deflection + noise * draw()
        if abs(launch) <= STEEPEST_LAUNCH:
            break
    there = speed * float(arm_ratio(table, np.array(place), speed_from_tip=speed_from_tip))
    closing = pitch + there
    efficiency = np.interp(place, table.from_tip, table.efficiency) + values["efficiency_shift"]
    efficiency += closing * np.interp(place, table.from_tip, table.efficiency_slope)
    scatter = np.hypot(values["exit_noise"], fixed("model_noise"))
    return PlayerSwing(
        row=0,
        bat_speed=float(speed + fixed("bat_speed_noise") * draw()),
        exit_speed=float((efficiency * closing + there) * retained + scatter * draw()),
        pitch_speed=pitch,
        launch_angle=float(launch),
        attack_angle=float(attack),
        position=None,
        bat="",
    )

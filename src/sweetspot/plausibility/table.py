"""The table: bounds of every quantity that people give, files hold and sliders set; no other place has any.

What is fine is wide: what players, laboratories and weather do lies well inside. These bounds are choices, not physics;
who means what he wrote insists (``--force`` on the command line, `insisting` in Python). What is impossible lies
outside what the models hold for.
"""

from __future__ import annotations

import math
from collections.abc import Mapping

from sweetspot.errors import InputError
from sweetspot.plausibility.bounds import Judged, PlausibleRange
from sweetspot.plausibility.implements import FROM_KNOB, SIZES
from sweetspot.units.factors import MPH
from sweetspot.units.text import Kind

Sports = Mapping[str, PlausibleRange]
"""Bounds by the sport's catalogue name; "": all others."""
MAX_SPEED = 70.0
"""m/s (157 mph): half as fast again as any recorded pitch or swing of a bat."""
_MOVING = (0.0, MAX_SPEED / MPH)
FILE_UNITS = "write the unit that the file is in behind the heading: _mph, _m_s or _km_h"
SPIN = "spins of balls stay below 15000 rpm; write rpm, or rad/s for radians"
SEA_LEVEL = (
    "a barometer is reduced to sea level, and the elevation is counted on top; for a pressure that was measured at the "
    "field give it with --elevation 0ft"
)
CENTER = "0deg is centre field, 45deg the right foul line"
TEE = "for a ball at rest say tee"
ROUND_BATS = ("baseball", "youth-baseball", "softball", "slow-pitch")
_OFF_BAT = "a little above the fastest that was measured; slow ones hardly leave"


def _off(high: float, low: float = 1, unit: str = "mph", *, why: str = _OFF_BAT) -> PlausibleRange:
    return PlausibleRange(low, high, unit, possible=(0, math.inf), why=why)


def _swung(high: float, why: str) -> PlausibleRange:
    return PlausibleRange(1, high, "mph", possible=_MOVING, why=why)


def _met(high: float, why: str) -> PlausibleRange:
    return PlausibleRange(1, high, "mph", TEE, _MOVING, absent=True, why=why)


def _together(high: float, why: str) -> PlausibleRange:
    hint = "it is that of ball and bat together"
    return PlausibleRange(0, high, "mph", hint, (0, 2 * MAX_SPEED / MPH), absent=True, why=why)


SPEEDS: Mapping[str, Sports] = {
    "pitch_speed": {
        "": PlausibleRange(10, 125, "mph", f"pitches come with up to 110mph; {TEE}", _MOVING, absent=True),
        "cricket": _met(110, "the fastest bowled is 100 mph (recalled)"),
        "tennis": _met(156, "the fastest serves leave at 164 mph and have lost a third at the racket (recalled)"),
        "table-tennis": _met(75, "the fastest smash is 70 mph (recalled)"),
        "badminton": _met(156, "smashes leave faster, and a shuttle loses half of that on the way (recalled)"),
        "golf": _met(60, "a ball that lies still: usga_ball"),
        "field-hockey": _met(110, "drag flicks leave at 75 to 100 mph (recalled)"),
        "pickleball": _met(85, "professionals smash at about 70 mph: stafford_speeds"),
        "squash": _met(156, "the fastest leave at 175 mph, and walls and floor take a third (recalled)"),
    },
    "release_speed": {"": PlausibleRange(15, 125, "mph", possible=(15, MAX_SPEED / MPH))},
    "bat_speed": {
        "": _swung(150, "rackets and clubs"),
        **dict.fromkeys(ROUND_BATS, _swung(110, "88 mph is the fastest tracked; checked swings are below 5")),
        "cricket": _swung(100, "20 to 30 m/s is usual (recalled), and half as fast again as the fastest"),
        "table-tennis": _swung(70, "10 to 20 m/s is usual (recalled), and half as fast again as the fastest"),
        "field-hockey": _swung(110, "a full hit is 30 m/s (recalled), and more than half as fast again"),
        "pickleball": _swung(90, "a smash of 70 mph off a ball that drops needs 60 mph: stafford_speeds; half again"),
    },
    "closing_speed": {
        "": _together(200, "the fastest pitch and the fastest swing make 195 mph; laboratories fire up to 140 mph"),
        **dict.fromkeys(ROUND_BATS, _together(235, "the fastest pitch and the fastest swing that are fine")),
        "cricket": _together(180, "the fastest swing is not made at the fastest ball"),
        "table-tennis": _together(110, "a smash met by a full swing"),
        "pickleball": _together(
            120, "a smash of 70 mph met by a drive; the ball's law was measured up to 60 mph: kewcor"
        ),
    },
    "rebound_speed": {"": PlausibleRange(0, 130, "mph", why="of a laboratory's ball: no faster than in play")},
    "exit_speed": {
        "": _off(170, 0.3, "m/s", why="the slowest and the fastest of all sports"),
        "baseball": _off(130, why="123 mph is the fastest tracked"),
        "youth-baseball": _off(110),
        "softball": _off(115),
        "slow-pitch": _off(125),
        "cricket": _off(60, 2, "m/s"),
        "tennis": _off(80, 1, "m/s"),
        "table-tennis": _off(40, 0.3, "m/s"),
        "badminton": _off(170, 0.5, "m/s"),
        "golf": _off(110, 1, "m/s"),
        "pickleball": _off(85, 1),
        "squash": _off(85, 1, "m/s"),
        "field-hockey": _off(65, 1, "m/s"),
    },
}
QUANTITIES: Mapping[str, PlausibleRange] = {
    "launch_angle": PlausibleRange(-89, 89, "deg", "0deg is level, 90deg straight up"),
    "spray": PlausibleRange(-90, 90, "deg", CENTER),
    "bearing": PlausibleRange(-90, 90, "deg", CENTER),
    "attack_angle": PlausibleRange(-60, 60, "deg", possible=(-65, 65), why="of a full swing"),
    "attack_direction": PlausibleRange(-90, 90, "deg"),
    "approach_angle": PlausibleRange(-60, 30, "deg"),
    "tilt": PlausibleRange(0, 85, "deg"),
    "backspin": PlausibleRange(-15000, 15000, "rpm", SPIN),
    "sidespin": PlausibleRange(-15000, 15000, "rpm", SPIN),
    "gyrospin": PlausibleRange(-15000, 15000, "rpm", SPIN),
    "pitch_backspin": PlausibleRange(-4000, 4000, "rpm"),
    "pitch_sidespin": PlausibleRange(-4000, 4000, "rpm"),
    "temperature": PlausibleRange(-40, 60, "degC"),
    "humidity": PlausibleRange(0, 1, "", "a ratio from 0 to 1, or a percentage: 50 % is 0.5"),
    "pressure": PlausibleRange(26, 32, "inHg", SEA_LEVEL, why="at sea level, a little beyond what was ever measured"),
    "elevation": PlausibleRange(-1400, 15000, "ft", why="the shore of the Dead Sea; the highest towns"),
    "wind_speed": PlausibleRange(0, 60, "mph", "the direction is given with --wind-direction"),
    "wind_direction": PlausibleRange(-360, 360, "deg", "the wind blows to there: 0deg is out to centre field"),
    "calm_below": PlausibleRange(0, 300, "ft"),
    "height": PlausibleRange(0, 40, "ft", "nothing is hit below the ground", (0, math.inf)),
    "fall_height": PlausibleRange(0.1, 40, "ft", "a ball falls from above the block", (0, math.inf)),
    "launch_height": PlausibleRange(
        0, 11, "ft", "a ball is hit from the ground up to a smash or a serve", (0, math.inf)
    ),
    "forward": PlausibleRange(-10, 10, "ft"),
    "offset": PlausibleRange(-3, 3, "in", "ball and barrel touch up to about 2.7 in"),
    "fired_speed": PlausibleRange(10, 100, "mph", "paddles are tested at 50 to 60 mph", (1, 150)),
    "clamp_inertia": PlausibleRange(0, 100, "kg*cm^2", "light clamps have 5, heavy ones 33 kg cm^2", (0, 1000)),
    "ball_cor": PlausibleRange(0.2, 0.97, "", possible=(0, math.inf)),
    "ball_mass": PlausibleRange(2, 500, "g", why="from table tennis to softball, and some more"),
    "ball_diameter": PlausibleRange(15, 150, "mm"),
    "ball_circumference": PlausibleRange(50, 450, "mm"),
    "ball_cor_reference": PlausibleRange(0.1, 0.98, "", "it is that on a rigid wall", (0, 1)),
    "ball_compression": PlausibleRange(130, 3600, "N", "it brings two plates a quarter inch nearer", (0, math.inf)),
    "bbcor": PlausibleRange(-0.2, 0.8, "", "bats have 0.2 to 0.6: check the speeds and their columns"),
    "measured_ball_cor": PlausibleRange(
        0.3, 0.7, "", "it is that of a ball on a rigid wall", why="balls of bat sports have 0.4 to 0.6 (assumed)"
    ),
    "measured_ball_stiffness": PlausibleRange(0.1, 20, "MN/m", why="dynamic; balls in use have 1 to 5 MN/m (assumed)"),
    "measured_ball_mass": PlausibleRange(0.02, 0.5, "kg", why="of balls that are hit with bats"),
    "balance_point": PlausibleRange(4, 60, "in", FROM_KNOB, (0, math.inf)),
    "period": PlausibleRange(
        0.5, 3, "s", "one swing is there and back; give the time of one, not of ten", (0, math.inf)
    ),
}
TRACKED: Mapping[str, PlausibleRange] = {
    "tracked_launch_angle": PlausibleRange(-90, 90, "deg", why="in whole degrees balls are tracked straight up"),
    "tracked_attack_angle": PlausibleRange(-90, 90, "deg", why="of any contact, lunges and checked swings too"),
    "tracked_tilt": PlausibleRange(-90, 90, "deg", why="of any contact"),
    "tracked_launch_direction": PlausibleRange(-180, 180, "deg", why="balls are fouled back"),
    "tracked_bearing": PlausibleRange(-180, 180, "deg", why="balls are fouled back"),
    "axial_offset": PlausibleRange(-1, 1, "m", why="longer than any bat"),
    "plate_side": PlausibleRange(-15, 15, "ft", why="wild pitches"),
    "plate_height": PlausibleRange(-15, 15, "ft", why="pitches that bounce are extrapolated below the ground"),
    "distance": PlausibleRange(0, 700, "ft", why="the longest home runs reach 505 ft in data, 575 ft in tales"),
    "hang_time": PlausibleRange(0, 15, "s"),
    "swing_length": PlausibleRange(0.5, 20, "ft", why="leagues list 5.9 to 9 ft on average"),
    "map_position": PlausibleRange(-100, 400, "m", why="coordinates on the scorer's map"),
    "velocity": PlausibleRange(-200, 200, "mph", why="components of a tracked velocity"),
    "acceleration": PlausibleRange(-300, 300, "ft/s^2", why="components; gravity is 32 and drag at most as much again"),
}
"""What trackers measure, beyond what can be asked for."""
MANY: Mapping[str, PlausibleRange] = {
    "median_exit_speed": PlausibleRange(42, 115, "mph", FILE_UNITS, why="41 mph is a major league's 91 mph in m/s"),
    "median_bat_speed": PlausibleRange(33, 95, "mph", FILE_UNITS, why="32 mph is a major league's 72 mph in m/s"),
    "median_release_speed": PlausibleRange(42, 105, "mph", FILE_UNITS),
    "median_plate_speed": PlausibleRange(40, 100, "mph", FILE_UNITS),
    "median_plate_height": PlausibleRange(1, 5, "ft"),
    "longest_distance": PlausibleRange(150, 550, "ft", why="the longest in a hundred"),
    "median_temperature": PlausibleRange(36, 108, "degF"),
    "median_pressure": PlausibleRange(990, 1040, "hPa"),
    "median_humidity": PlausibleRange(5, 100, "%"),
}
"""Of many values together; narrow enough that no table is still inside when it is read in another unit."""
LARGEST: Mapping[Kind, float] = {
    "length": 1e4,
    "mass": 1e3,
    "speed": 1e4,
    "moi": 1e3,
    "density": 1e5,
    "pressure": 1e13,
    "force": 1e8,
    "time": 1e6,
    "angle": 1e3,
    "wind direction": 1e3,
    "angular speed": 1e5,
    "linear density": 1e3,
    "areal density": 1e4,
    "first moment": 1e4,
    "temperature": 1e4,
    "stiffness": 1e12,
    "damping": 1e9,
    "frequency": 1e7,
    "ratio": 1e6,
    "slope per speed": 1e3,
    "slope per temperature": 1e3,
}
"""SI, what no quantity of its kind exceeds in any sport: arithmetic with more than that says nothing, or fails."""
SMALLEST = 1e-15
"""SI; less than that is zero, or a slip."""


def _lively(low: float, high: float, why: str) -> PlausibleRange:
    return PlausibleRange(low, high, "", "it is that on a rigid wall, at the speed of its test", (0, 1), why=why)


RESTITUTIONS: Sports = {
    "": _lively(0.2, 0.97, "a shuttle's cork or a cold squash ball, and a table-tennis ball"),
    **dict.fromkeys(ROUND_BATS, _lively(0.38, 0.62, "softballs are marked 0.40 to 0.52, baseballs have 0.50 to 0.57")),
    "cricket": _lively(0.4, 0.65, "0.50 to 0.55 (recalled)"),
    "tennis": _lively(0.68, 0.85, "0.755 to 0.789 by the rules' drop: itf_ball"),
    "table-tennis": _lively(0.85, 0.97, "0.92 to 0.96 by the rules' drop: ittf_bounce"),
    "golf": _lively(0.7, 0.86, "about 0.78 on a rigid plate: franklygolf; 0.83 off a thin face"),
    "field-hockey": _lively(0.4, 0.75, "0.47 to 0.63 (recalled)"),
    "pickleball": _lively(0.6, 0.75, "0.655 to 0.699 by the rules' drop of 30 to 34 in, with air: briffidi"),
    "squash": _lively(0.3, 0.65, "0.36 cold to 0.57 warm by the rules' drop: wsf_ball"),
}
"""Of balls on a rigid wall, at the speed of their laws."""
TABLE: Mapping[str, Sports] = {
    **SPEEDS,
    "ball_restitution": RESTITUTIONS,
    **{name: {"": record} for name, record in {**QUANTITIES, **TRACKED, **MANY, **SIZES}.items()},
}
"""By the name of the quantity, as options and columns have it."""


def bounds(quantity: str, sport: str = "") -> PlausibleRange:
    """Return the bounds of a quantity in a sport, of those that `TABLE` knows.

    >>> bounds("exit_speed", "baseball").high
    130
    """
    records = TABLE[quantity]
    return records.get(sport.replace(" ", "-")) or records[""]


def fine(quantity: str, sport: str = "") -> tuple[float, float]:
    """Return the least and greatest value of a quantity that is fine, SI."""
    return bounds(quantity, sport).fine


def verdict(quantity: str, value: float, sport: str = "") -> Judged:
    """Judge a value in SI.

    >>> verdict("pitch_speed", 40.0), verdict("pitch_speed", 60.0), verdict("pitch_speed", 80.0)
    ('fine', 'unusual', 'impossible')
    """
    return bounds(quantity, sport).verdict(value)


def quantity_named(what: str) -> str:
    """Return the quantity that an option or a phrase names: ``--wind-speed``, ``bat length``."""
    return what.removeprefix("--").replace("-", "_").replace(" ", "_")


def objection(quantity: str, value: float, what: str, given: object, sport: str = "", *, column: bool = False) -> str:
    """Say what is wrong with a value (SI) of a quantity; "" where it is fine, insisted on, or not in the table.

    Parameters
    ----------
    sport : catalogue name; "": any.
    """
    if quantity not in TABLE:
        return ""
    sport = sport.replace(" ", "-")
    of = f"in {sport.replace('-', ' ')}" if sport and sport in TABLE[quantity] else ""
    return bounds(quantity, sport).objection(value, what, given, of=of, column=column)


def check(value: float, what: str, given: object, *, quantity: str = "", sport: str = "") -> None:
    """Refuse a value (SI) that is impossible, or unusual and not insisted on; what is not in `TABLE` passes.

    Parameters
    ----------
    what : its option or column.
    given : as it was written.
    quantity : its name in the table; "": what ``what`` names.
    sport : catalogue name; "": any.

    >>> check(44.7, "--wind-speed", "100mph")
    Traceback (most recent call last):
    ...
    sweetspot.errors.InputError: --wind-speed was given as 100mph; usual is 0 to 60 mph; the direction is given with \
--wind-direction. Check the unit and the decimal point, or add --force if it is intended
    """
    if wrong := objection(quantity or quantity_named(what), value, what, given, sport):
        raise InputError(wrong)


def check_possible(value: float, what: str, quantity: str) -> None:
    """Refuse a value (SI) that is impossible, also where unusual ones are insisted on: the check of Python models."""
    record = bounds(quantity)
    if record.verdict(value) == "impossible":
        raise InputError(record.objection(value, what, f"{record.in_unit(value):.4g} {record.unit}"))

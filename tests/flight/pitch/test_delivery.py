"""Thrown pitches: limits that are exact, aims that are met, and pitches that do not arrive."""

from __future__ import annotations

import math

import numpy as np
import pytest

from sweetspot import catalog
from sweetspot.catalog.aerodynamic_laws import aerodynamics
from sweetspot.catalog.deliveries import usual_height
from sweetspot.errors import InputError
from sweetspot.flight.air import VACUUM, Air
from sweetspot.flight.pitch import MIDDLE, PLATE, RUBBER, Delivery, aimed, thrown
from sweetspot.numerics.constants import STANDARD_GRAVITY
from sweetspot.units import FOOT, MPH

BALL = catalog.ball()
LAW = aerodynamics("pitched-baseball")
AIR = Air(temperature=24.0)


def test_without_air_it_is_a_parabola() -> None:
    delivery = Delivery(speed=40.0, spin_rate=240.0, turn=0.01, side=-0.5)
    found = thrown(delivery, ball=BALL, aerodynamics=LAW, air=VACUUM)
    time = (RUBBER - delivery.extension - PLATE) / (40 * math.cos(0.01))
    assert found.time == pytest.approx(time, rel=1e-9)
    assert found.plate.position == pytest.approx(
        [-0.5 + 40 * math.sin(0.01) * time, PLATE, delivery.height - STANDARD_GRAVITY * time**2 / 2], abs=1e-6
    )
    assert found.vertical_approach_angle == pytest.approx(math.atan2(-STANDARD_GRAVITY * time, 40 * math.cos(0.01)))
    assert found.speed_ratio > 1


@pytest.mark.parametrize("name", catalog.delivery_names())
def test_every_pitch_is_aimed_over_the_plate(name: str) -> None:
    found = aimed(catalog.delivery(name), ball=BALL, aerodynamics=LAW, air=AIR)
    assert found.plate.position == pytest.approx([MIDDLE[0], PLATE, MIDDLE[1]], abs=1e-5)
    assert 0.90 < found.speed_ratio < 0.93
    spins = np.linalg.norm(found.plate.spin) / found.delivery.spin_rate
    assert 0.98 < spins < 0.99  # 1 to 2 % of the spin is lost on the way


def test_spin_pushes_the_way_it_is_named() -> None:
    """Backspin keeps a pitch up, topspin brings it down; a sinker runs to its right-hander, a curve away from him."""
    plain = Delivery(speed=40.0)
    falls = {
        axis: thrown(
            plain.replaced(spin_rate=230.0, spin_axis=math.radians(axis)), ball=BALL, aerodynamics=LAW, air=AIR
        )
        for axis in (0, 90, 180, 270)
    }
    still = thrown(plain, ball=BALL, aerodynamics=LAW, air=AIR).plate.position
    assert falls[180].plate.position[2] > still[2] > falls[0].plate.position[2]
    assert falls[90].plate.position[0] > still[0] > falls[270].plate.position[0]
    left = catalog.delivery("slider").replaced(throws="left")
    assert left.motion.gyrospin == pytest.approx(-catalog.delivery("slider").motion.gyrospin)
    assert catalog.delivery("slider").motion.gyrospin > 0


def test_usual_heights_are_pitches() -> None:
    assert all(1.4 * FOOT < usual_height(name) < 3 * FOOT for name in catalog.delivery_names())


@pytest.mark.parametrize("speed", [1.0, 8.0, 11.0])
def test_too_slow_to_reach_the_plate(speed: float) -> None:
    with pytest.raises(InputError, match=r"does not reach it; throw faster or higher"):
        thrown(Delivery(speed=speed), ball=BALL, aerodynamics=LAW, air=AIR)
    with pytest.raises(InputError, match=r"does not reach it|cannot be aimed"):
        aimed(Delivery(speed=speed), ball=BALL, aerodynamics=LAW, air=AIR)


def test_a_slow_lob_is_aimed_as_well() -> None:
    found = aimed(Delivery(speed=30 * MPH), ball=BALL, aerodynamics=LAW, air=AIR)
    assert found.plate.position[2] == pytest.approx(MIDDLE[1], abs=1e-5)
    assert found.delivery.launch_angle > math.radians(20) and found.vertical_approach_angle < math.radians(-25)


def test_out_of_reach_is_refused() -> None:
    with pytest.raises(InputError, match=r"cannot be aimed|does not reach it"):
        aimed(Delivery(speed=14.0), ball=BALL, aerodynamics=LAW, air=AIR, target=(0.0, 8.0))


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"speed": 80.0}, "speed was given as 179 mph; possible is 0 to 157 mph"),
        ({"extension": 19.0}, "extension is 19"),
        ({"launch_angle": 1.6}, "less than 90 deg"),
        ({"efficiency": 1.2}, "efficiency"),
    ],
)
def test_what_is_no_pitch_is_refused(change: dict[str, float], message: str) -> None:
    with pytest.raises(InputError, match=message):
        Delivery(speed=40.0).replaced(**change)


def test_an_unknown_pitch_names_the_nearest() -> None:
    with pytest.raises(InputError, match="Did you mean curve"):
        catalog.delivery("curv")


def test_what_never_comes_to_the_plate_that_high_is_refused() -> None:
    """Thrown at 5 m/s a ball falls 9 m on its way: no angle that is still a pitch brings it over the plate."""
    with pytest.raises(InputError):
        aimed(Delivery(speed=5.0), ball=BALL, aerodynamics=LAW, air=AIR)

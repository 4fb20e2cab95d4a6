"""Real flights: the published run of the trajectory calculator, and fly balls tracked indoors."""

from __future__ import annotations

import csv
import gzip
import math
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray

from sweetspot import catalog
from sweetspot.flight.air import Air
from sweetspot.flight.batted_spin import batted_ball_spin
from sweetspot.flight.forces import drag_and_lift
from sweetspot.flight.kernel import flights
from sweetspot.motion.ball_motion import spin_axes
from sweetspot.units import DEGREE, FOOT, MPH, RPM

DATA = Path(__file__).parents[3] / "shared" / "data"
BALL, LAW = catalog.ball(), catalog.aerodynamics("trajectory-calculator")
POUNDS = 0.06242796
"""lb/ft^3 in a kg/m^3; the sheet has 0.06261."""
SHEET_POUNDS, SHEET_DENSITY = 0.06261, 0.0747421
"""lb/ft^3: the sheet's conversion, and the density it prints."""


def table(name: str) -> list[dict[str, str]]:
    if not (DATA / name).exists():
        pytest.skip(f"the public file {name} is not here; it is no part of the project")
    with gzip.open(DATA / name, "rt", encoding="utf-8", newline="") as file:
        return list(csv.DictReader(file))


def column(rows: list[dict[str, str]], name: str) -> NDArray[np.float64]:
    return np.array([float(row[name]) for row in rows])


def test_forces_of_every_row_of_the_sheet() -> None:
    """Published: nathan_calculator. From a row's speed and spin follow its own drag and lift, to 1e-4.

    The spin that the sheet flies with is that of its column S; its air is 0.29 % too strong (see POUNDS).
    """
    rows = table("nathan_calculator_103mph_27p5_2500rpm.csv.gz")
    density = 1.1938 * SHEET_POUNDS / POUNDS
    velocity = FOOT * np.stack([column(rows, name) for name in ("vx", "vy", "vz")], axis=-1)
    factor, speed = column(rows, "S"), np.linalg.norm(velocity, axis=1)
    spin = factor * speed / BALL.radius
    for row, text in enumerate(rows):
        drag, lift = drag_and_lift(
            velocity[row], spin=np.array([spin[row], 0.0, 0.0]), ball=BALL, aerodynamics=LAW, density=density
        )
        assert LAW.drag_coefficient(factor[row], spin=spin[row]) == pytest.approx(float(text["Cd"]), abs=1e-5)
        assert LAW.lift_coefficient(factor[row]) == pytest.approx(float(text["Cl"]), abs=1e-6)
        for name, value in (("adragy", drag[1]), ("adragz", drag[2]), ("aMagy", lift[1]), ("aMagz", lift[2])):
            assert value / FOOT == pytest.approx(float(text[name]), rel=2e-4, abs=2e-3), (name, row)


def test_path_of_the_sheet() -> None:
    """Published: nathan_calculator; 601 rows, of which 553 are above the ground.

    1.3 ft: Euler's rule in the sheet costs up to 1 ft by the end, its stronger air 0.3 ft.
    """
    rows = [row for row in table("nathan_calculator_103mph_27p5_2500rpm.csv.gz") if float(row["z"]) >= 0]
    assert len(rows) == 552
    axes = spin_axes(27.5 * DEGREE, 0.0)
    found = flights(
        [0.0, 2 * FOOT, 3 * FOOT], 103 * MPH * axes[2], 2500 * RPM * axes[0], ball=BALL, aerodynamics=LAW,
        air=Air(temperature=38 / 1.8, pressure=29.92 * 3386.389, elevation=15 * FOOT), path_points=2000,
    )  # fmt: skip
    ours = [np.interp(column(rows, "t"), found.times[0], found.positions[0, :, axis]) / FOOT for axis in range(3)]
    assert np.abs(ours[0]).max() < 1e-9
    assert np.abs(ours[1] - column(rows, "y")).max() < 1.3
    assert np.abs(ours[2] - column(rows, "z")).max() < 0.3


def indoor_fly_balls() -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Return carry by the model and distance as tracked, ft.

    Batted in the air (fly balls and line drives) at 85 mph or more and 15 to 45 deg in the games under a roof of 2022,
    at 72 degF without wind: as in the published comparison.
    """
    needed = ("launch_speed", "launch_angle", "hit_distance_sc", "hc_x", "hc_y")
    rows = [
        row
        for row in table("savant_2022_contact_sample.csv.gz")
        if row["home_team"] == "TB"
        and row["bb_type"] in ("fly_ball", "line_drive")
        and all(row[name] for name in needed)
    ]
    rows = [row for row in rows if float(row["launch_speed"]) >= 85 and 15 <= float(row["launch_angle"]) <= 45]
    angle = column(rows, "launch_angle") * DEGREE
    spray = np.arctan2(column(rows, "hc_x") - 125.42, 198.27 - column(rows, "hc_y"))
    bats = np.where(np.array([row["stand"] for row in rows]) == "L", "left", "right")
    backspin, sidespin = batted_ball_spin(angle, spray, bats=bats)
    axes = np.array([spin_axes(*pair) for pair in zip(angle, spray, strict=True)])
    found = flights(
        [0.0, 2 * FOOT, 3 * FOOT], column(rows, "launch_speed")[:, None] * MPH * axes[:, 2],
        backspin[:, None] * axes[:, 0] + sidespin[:, None] * axes[:, 1], ball=BALL, aerodynamics=LAW,
        air=Air(temperature=40 / 1.8, elevation=15 * FOOT),
    )  # fmt: skip
    assert found.landed.all()
    return found.carry / FOOT, column(rows, "hit_distance_sc")


def test_unbiased_on_fly_balls_indoors() -> None:
    """Asked: |mean| <= 5 ft, SD <= 18.5 ft; the published comparison found +1.9 and 16.8 ft on the same 492 balls.

    It counts from the bat, as far as its other numbers tell, so 2 of our +4.9 ft are the 2 ft in front of the plate.
    """
    ours, tracked = indoor_fly_balls()
    apart = ours - tracked
    assert len(apart) == 492
    assert abs(apart.mean()) <= 5.0
    assert apart.std(ddof=1) <= 18.5


def test_the_usual_spin() -> None:
    """Published: nathan_calculator, -763 + 120 theta + 21 phi s and -849 s - 94 phi, in rpm and degrees."""
    back, side = batted_ball_spin(25 * DEGREE, np.array([-10.0, 10.0]) * DEGREE, bats=["right", "left"])
    assert back / RPM == pytest.approx([-763 + 3000 - 210, -763 + 3000 - 210])
    assert side / RPM == pytest.approx([-849 + 940, 849 - 940])


def test_left_handed_hits_are_mirror_images() -> None:
    angle, spray = 0.4, 0.3
    right, left = batted_ball_spin(angle, spray), batted_ball_spin(angle, -spray, bats="left")
    assert float(right[0]) == pytest.approx(float(left[0])) and float(right[1]) == pytest.approx(-float(left[1]))
    assert math.isfinite(float(right[0]))

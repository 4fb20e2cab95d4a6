"""Real flights: the published run of the trajectory calculator, and tracked fly balls."""

from __future__ import annotations

import csv
import gzip
import math
from functools import cache
from itertools import pairwise
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from sweetspot import catalog
from sweetspot.flight.aerodynamics import drag_and_lift
from sweetspot.flight.air import CALM, MEAN_BREEZE, Air
from sweetspot.flight.batted_spin import SHEET, TRACKED, batted_ball_spin
from sweetspot.flight.bearing import bearing_of_place, launched_to
from sweetspot.flight.conditions import FlightConditions
from sweetspot.flight.home_runs import home_run_chances
from sweetspot.flight.kernel import flights
from sweetspot.flight.pitch import aimed
from sweetspot.flight.sweep import BattedBall
from sweetspot.flight.trajectory import fly
from sweetspot.motion.ball_motion import BallMotions, spin_axes
from sweetspot.units import DEGREE, FOOT, INCH_OF_MERCURY, MPH, RPM
from sweetspot.validation.computations.space import simulated_league
from tests.real_data import real_file

BALL, LAW = catalog.ball(), catalog.aerodynamics("trajectory-calculator")
POUNDS = 0.06242796
"""lb/ft^3 in a kg/m^3; the sheet has 0.06261."""
SHEET_POUNDS, SHEET_DENSITY = 0.06261, 0.0747421
"""lb/ft^3: the sheet's conversion, and the density it prints."""


def table(name: str) -> list[dict[str, str]]:
    with gzip.open(real_file(name), "rt", encoding="utf-8", newline="") as file:
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
        BallMotions(velocity=103 * MPH * axes[2], spin=2500 * RPM * axes[0], position=[0.0, 2 * FOOT, 3 * FOOT]),
        FlightConditions(
            ball=BALL,
            aerodynamics=LAW,
            air=Air(temperature=38 / 1.8, pressure=29.92 * INCH_OF_MERCURY, elevation=15 * FOOT),
        ),
        path_points=2000,
    )
    ours = [np.interp(column(rows, "t"), found.times[0], found.positions[0, :, axis]) / FOOT for axis in range(3)]
    assert np.abs(ours[0]).max() < 1e-9
    assert np.abs(ours[1] - column(rows, "y")).max() < 1.3
    assert np.abs(ours[2] - column(rows, "z")).max() < 0.3


GLOVE = 5 * FOOT
"""m above the ground, where a fly is caught; see tools/fit_aerodynamics.py."""


@cache
def tracked_flies() -> dict[str, NDArray[Any]]:
    """Return fly balls and line drives of 80 mph or more at 15 to 45 deg, flown so that they land at their bearing.

    The weather in the open is not in the file: 72 degF without wind, as under the roof of the home games.
    """
    needed = ("launch_speed", "launch_angle", "hit_distance_sc", "hc_x", "hc_y")
    rows = [
        row
        for row in table("savant_2022_contact_sample.csv.gz")
        if row["bb_type"] in ("fly_ball", "line_drive") and all(row[name] for name in needed)
    ]
    rows = [row for row in rows if float(row["launch_speed"]) >= 80 and 15 <= float(row["launch_angle"]) <= 45]
    bearing = bearing_of_place(column(rows, "hc_x"), column(rows, "hc_y"))
    bats = np.where(np.array([row["stand"] for row in rows]) == "L", "left", "right")
    home = np.array([row["home_team"] for row in rows])
    spray, carry, steep = np.empty((3, len(rows)))
    for team in np.unique(home):
        here, park = home == team, catalog.park(team, 2022)
        spray[here], flown = launched_to(
            bearing[here],
            exit_speed=column(rows, "launch_speed")[here] * MPH,
            launch_angle=column(rows, "launch_angle")[here] * DEGREE,
            bats=bats[here],
            conditions=FlightConditions(
                ball=BALL,
                aerodynamics=catalog.aerodynamics_in(park, catalog.aerodynamics()),
                air=Air(temperature=40 / 1.8, elevation=park.elevation),
            ),
        )
        assert flown.landed.all()
        carry[here], steep[here] = flown.carry, flown.landing_angle
    assert np.isfinite(spray).all()
    axes = spin_axes(column(rows, "launch_angle") * DEGREE, spray)
    backspin, sidespin = batted_ball_spin(column(rows, "launch_angle") * DEGREE, spray, bats=bats)
    caught = np.isin([row["events"] for row in rows], ["field_out", "sac_fly", "double_play"])
    distance = column(rows, "hit_distance_sc")
    return {
        "roof": np.array([row["home_team"] == "TB" for row in rows]),
        "pulled": np.where(bats == "right", -1, 1) * bearing / DEGREE,
        "speed": column(rows, "launch_speed"),
        "angle": column(rows, "launch_angle"),
        "game": column(rows, "game_pk"),
        "ground": carry / FOOT - distance,
        "glove": (carry - caught * GLOVE / np.tan(steep)) / FOOT - distance,
        "spray": spray,
        "bearing": bearing,
        "velocity": column(rows, "launch_speed")[:, None] * MPH * axes[2],
        "spin": backspin[:, None] * axes[0] + sidespin[:, None] * axes[1],
        "home": home,
        "home_run": np.array([row["events"] == "home_run" for row in rows]),
    }


def test_unbiased_in_the_open_and_under_the_roof() -> None:
    """Asked: |mean| <= 3 ft of all, and SD <= 16 ft under a roof.

    Under the roof by the law of still air, in the open by that of the mean park. To the ground, as if no glove had been
    in the way, everything is 3 ft longer.
    """
    flies = tracked_flies()
    roof = flies["roof"]
    assert roof.sum() == 549 and (~roof).sum() == 615
    for where in (roof, ~roof):
        assert abs(flies["glove"][where].mean()) <= 1.5 and abs(flies["ground"][where].mean()) <= 5
        assert flies["glove"][where].std() <= 16.5
    assert flies["glove"][roof].std() <= 14.5


@pytest.mark.parametrize(("by", "edges", "most"), [
    ("pulled", (-46, -30, -15, 0, 15, 30, 46), 4), ("speed", (80, 85, 90, 95, 100, 105, 125), 4.5),
    ("angle", (15, 20, 25, 30, 35, 40, 45.1), 5.5),
])  # fmt: skip
def test_no_part_of_the_field_no_speed_and_no_angle_is_off(by: str, edges: tuple[float, ...], most: float) -> None:
    """Asked: 5 ft in each sixth of the field, in the open and under the roof; the standard error of one is 2 ft."""
    flies = tracked_flies()
    for where in (flies["roof"], ~flies["roof"]):
        parts = [where & (flies[by] >= low) & (flies[by] < high) for low, high in pairwise(edges)]
        assert all(abs(flies["glove"][part].mean()) <= most and part.sum() > 50 for part in parts)


def test_the_usual_spin_is_the_collision_s_in_kind() -> None:
    """Agreement: made-up swings through full collisions say 5, -105 and -27 rpm a degree; flights 21, -96 and -24.

    Sidespin within twice the flights' standard errors. Backspin with spray has the collision's sign, and is a quarter
    of the flights'; the measured one, 15 +- 3, lies between.
    """
    hits = simulated_league("r161-ash", left_handed=0.0)
    high = (hits.launch_angle > 15 * DEGREE) & (hits.launch_angle < 45 * DEGREE) & (hits.exit_speed > 80 * MPH)
    known = np.stack([np.ones_like(hits.spray), hits.launch_angle / DEGREE, hits.spray / DEGREE], axis=-1)[high]
    (_, _, opposite), (_, slices, hooks) = (
        np.linalg.lstsq(known, spin[high] / RPM)[0] for spin in (hits.backspin, hits.sidespin)
    )
    assert 0 < opposite < TRACKED.backspin[2]
    assert hooks == pytest.approx(TRACKED.sidespin[1], abs=13)
    assert slices == pytest.approx(TRACKED.sidespin[2], abs=34) and slices < -15


def test_balls_left_out_of_the_fit_are_met() -> None:
    """Held out: the level of one half of the games, and the line of spin of both, meets the other half within 4 ft."""
    flies = tracked_flies()
    even, roof = flies["game"] % 2 == 0, flies["roof"]
    for half in (even, ~even):
        for where in (roof, ~roof):
            assert abs(flies["glove"][half & where].mean() - flies["glove"][~half & where].mean()) <= 4


def test_a_breeze_tells_the_open_from_the_roof() -> None:
    """In the mean breeze the law of still air is that of hits in the mean park, to 2 ft."""
    still, hits = catalog.aerodynamics("baseball-in-still-air"), catalog.aerodynamics()
    hit = BattedBall(exit_speed=100 * MPH, launch_angle=28 * DEGREE).motion
    carry, blown, calm = (
        fly(hit, FlightConditions(ball=BALL, aerodynamics=law, air=Air(), wind=wind)).carry / FOOT
        for law, wind in ((hits, CALM), (still, MEAN_BREEZE), (still, CALM))
    )
    assert carry == pytest.approx(blown, abs=2.5) and calm - carry > 5


def test_the_same_breeze_tells_pitches_apart() -> None:
    """Pitches under the roof have a drag of 0.3135; the mean breeze makes them those of the mean park, to 0.1 mph."""
    pitches = catalog.aerodynamics("pitched-baseball")
    still = pitches.replaced(drag=0.3135)
    for name in ("four-seam", "curve", "changeup"):
        speed, pushed, slow = (
            aimed(catalog.delivery(name), ball=BALL, aerodynamics=law, air=Air(), wind=wind).plate.speed / MPH
            for law, wind in ((pitches, CALM), (still, MEAN_BREEZE), (still, CALM))
        )
        assert speed == pytest.approx(pushed, abs=0.1) and slow < speed - 0.2


def test_home_runs_leave_the_bat_fair() -> None:
    """Home runs landed fair; read as launch directions their bearings would be up to 12 deg off, and many foul."""
    flies = tracked_flies()
    spray, bearing = (np.degrees(flies[name][flies["home_run"]]) for name in ("spray", "bearing"))
    assert np.abs(spray).max() < 45 and np.abs(bearing).max() < 48  # the map is drawn by hand
    assert np.abs(spray - bearing).mean() > 2


@cache
def chances() -> tuple[NDArray[np.float64], NDArray[np.bool_], NDArray[np.bool_]]:
    """Return the chance of a home run in its own park of each tracked fly, whether it was one, and whether roofed."""
    flies = tracked_flies()
    velocity, spin, home = (flies[name] for name in ("velocity", "spin", "home"))
    chance = np.zeros(len(home))
    for team in np.unique(home):
        here = home == team
        chance[here] = home_run_chances(
            BallMotions(velocity=velocity[here], spin=spin[here], position=[0.0, 2 * FOOT, 3 * FOOT]),
            FlightConditions(ball=BALL, aerodynamics=catalog.aerodynamics(), air=Air(temperature=40 / 1.8)),
            parks=[catalog.park(team, 2022)],
        ).chance[:, 0]
    return chance, flies["home_run"], flies["roof"]


def test_home_runs_add_up() -> None:
    """Asked: the sum of chances within 8 % of what was hit, Brier score at most 0.050; 171 home runs of 1164 flies."""
    chance, hit, roof = chances()
    assert hit.sum() > 160
    assert chance.sum() == pytest.approx(hit.sum(), rel=0.08)
    assert np.mean((chance - hit) ** 2) <= 0.045
    for part in (roof, ~roof):  # by chance alone 90 of them scatter by 5
        assert abs(chance[part].sum() - hit[part].sum()) < 2.5 * np.sqrt(np.sum((chance * (1 - chance))[part]))


@pytest.mark.parametrize(("low", "high"), [(0.0, 0.1), (0.1, 0.4), (0.4, 0.7), (0.7, 0.9), (0.9, 1.01)])
def test_chances_are_frequencies(low: float, high: float) -> None:
    """Calibration: in each band as many home runs as chances say, to 3 standard errors of a count."""
    chance, hit, _ = chances()
    band = (chance >= low) & (chance < high)
    expected, error = chance[band].sum(), np.sqrt(np.sum((chance * (1 - chance))[band]))
    assert band.sum() > 20 and abs(hit[band].sum() - expected) < 3 * error + 2


def test_the_usual_spin() -> None:
    """Published: nathan_calculator, -763 + 120 theta + 21 phi s and -849 s - 94 phi, in rpm and degrees."""
    turns = np.array([-10.0, 10.0]) * DEGREE
    back, side = batted_ball_spin(25 * DEGREE, turns, bats=["right", "left"], line=SHEET)
    assert back / RPM == pytest.approx([-763 + 3000 - 210, -763 + 3000 - 210])
    assert side / RPM == pytest.approx([-849 + 940, 849 - 940])


def test_left_handed_hits_are_mirror_images() -> None:
    angle, spray = 0.4, 0.3
    right, left = batted_ball_spin(angle, spray), batted_ball_spin(angle, -spray, bats="left")
    assert float(right[0]) == pytest.approx(float(left[0])) and float(right[1]) == pytest.approx(-float(left[1]))
    assert math.isfinite(float(right[0]))

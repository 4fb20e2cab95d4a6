"""Fit what pitches say of drag, and the scatter of home runs: ``python tools/fit_aerodynamics.py ../shared/data``.

How drag changes with active spin and Reynolds's number comes from pitches, compared only within a game, so that weather
and a park's cameras drop out, and within a kind of pitch, so that its grip on the seams does. Their active spin is read
from their movement with the lift of the trajectory calculator, which is everybody's lift. Which balls left their parks
gives shift and scatter of home runs. Nothing is written: what is printed goes into ``catalog/aerodynamics.toml`` and
``flight/home_runs.py`` by hand. The law of batted balls is fitted by ``studies/air_law.py``.
"""

from __future__ import annotations

import argparse
import csv
import gzip
import math
from dataclasses import dataclass, replace
from itertools import pairwise
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from sweetspot import catalog
from sweetspot.errors import InputError
from sweetspot.flight.aerodynamics import REFERENCE_REYNOLDS, VISCOSITY, Aerodynamics
from sweetspot.flight.air import Air
from sweetspot.flight.batted_spin import batted_ball_spin
from sweetspot.flight.bearing import bearing_of_place, launched_to
from sweetspot.flight.conditions import FlightConditions
from sweetspot.flight.home_runs import USUAL, CarryScatter, home_run_chances
from sweetspot.flight.pitch import PLATE, nine_parameters, spin_from_movement
from sweetspot.motion.ball_motion import BallMotions, spin_axes
from sweetspot.units import DEGREE, FOOT, MPH, RPM

Array = NDArray[np.float64]
Rows = list[dict[str, str]]

HITS = "savant_2022_contact_sample.csv.gz"
PITCHES = ("savant_2019_homeruns.csv.gz", "savant_2020-09-03_allpitches.csv.gz", HITS,
           "savant_2024-04-02_999pitches.csv.gz", "savant_2024-07-25_cease_nohitter_full118col.csv.gz")  # fmt: skip
ROOF = "TB"
"""Whose games were under a roof at a known temperature."""
TEMPERATURE = 40 / 1.8
"""degC, 72 degF: under the roof; in the open the weather is not known and the same is taken."""
GLOVE = 5 * FOOT
"""m above the ground, where a fly is caught (assumed; 1 ft more or less is 0.6 ft of distance)."""
CAUGHT = ("field_out", "sac_fly", "double_play", "sac_fly_double_play")
FAIR = 45.5 * DEGREE
"""The map is drawn by hand; three home runs are marked farther out than this."""
KRPM = 1000 * RPM


@dataclass(frozen=True)
class Pitches:
    """Tracked pitches half-way to the plate: m/s and m/s^2 of shape (n, 3), kg/m^3, the file and the game of each."""

    velocity: Array
    acceleration: Array
    density: Array
    file: NDArray[np.str_]
    game: NDArray[np.str_]
    kind: NDArray[np.str_]
    roof: NDArray[np.bool_]


@dataclass(frozen=True)
class Hits:
    """Balls hit in the air and where they ended: SI, shape (n,)."""

    exit_speed: Array
    launch_angle: Array
    bearing: Array
    bats: NDArray[np.str_]
    density: Array
    height: Array
    distance: Array
    game: NDArray[np.str_]
    home: NDArray[np.str_]
    home_run: NDArray[np.bool_]
    roof: NDArray[np.bool_]
    month: Array

    def where(self, rows: NDArray[np.bool_] | NDArray[np.int64]) -> Hits:
        """Return some of the rows."""
        return Hits(**{name: values[rows] for name, values in vars(self).items()})


def read(path: Path) -> Rows:
    """Return the rows of a public file; raises `InputError` where it is missing."""
    if not path.exists():
        raise InputError(f"{path} is not there; give the folder that has the public files")
    with gzip.open(path, "rt", encoding="utf-8", newline="") as file:
        return list(csv.DictReader(file))


def column(rows: Rows, name: str) -> Array:
    """Return a column as numbers, NaN where empty."""
    return np.array([float(row[name] or "nan") for row in rows])


def density_of(rows: Rows) -> Array:
    """Return the density of the air of each row, by the elevation of its park."""
    known: dict[str, float] = {}
    for row in rows:
        if row["home_team"] not in known:
            park = catalog.park(row["home_team"])
            known[row["home_team"]] = Air(temperature=TEMPERATURE, elevation=park.elevation).density
    return np.array([known[row["home_team"]] for row in rows])


def read_pitches(folder: Path) -> Pitches:
    """Return the pitches of every file that have all nine parameters."""
    parts = []
    for name in PITCHES:
        rows = read(folder / name)
        values = {field: column(rows, field) for field in ("vx0", "vy0", "vz0", "ax", "ay", "az", "release_pos_y")}
        whole: NDArray[np.bool_] = np.asarray(np.isfinite(np.stack(list(values.values()))).all(axis=0))
        rows = [row for row, good in zip(rows, whole, strict=True) if good]
        velocity, acceleration = (
            FOOT * np.stack([values[field][whole] for field in fields], axis=-1)
            for fields in (("vx0", "vy0", "vz0"), ("ax", "ay", "az"))
        )
        tracked = nine_parameters(velocity, acceleration=acceleration)
        _, midway = tracked.at((PLATE + FOOT * values["release_pos_y"][whole]) / 2)
        file = name.removeprefix("savant_").split("_")[0]
        parts.append(
            Pitches(
                midway, acceleration, density_of(rows), np.full(len(rows), file),
                np.array([file + row["game_pk"] for row in rows]), np.array([row["pitch_type"] for row in rows]),
                np.array([row["home_team"] == ROOF for row in rows]),
            )
        )  # fmt: skip
    return Pitches(*(np.concatenate([getattr(part, name) for part in parts]) for name in vars(parts[0])))


def read_hits(folder: Path) -> Hits:
    """Return fly balls and line drives of 80 mph or more at 15 to 45 deg."""
    needed = ("launch_speed", "launch_angle", "hit_distance_sc", "hc_x", "hc_y")
    rows = [
        row
        for row in read(folder / HITS)
        if row["bb_type"] in ("fly_ball", "line_drive") and all(row[name] for name in needed)
    ]
    rows = [row for row in rows if float(row["launch_speed"]) >= 80 and 15 <= float(row["launch_angle"]) <= 45]
    return Hits(
        exit_speed=column(rows, "launch_speed") * MPH,
        launch_angle=column(rows, "launch_angle") * DEGREE,
        bearing=bearing_of_place(column(rows, "hc_x"), column(rows, "hc_y")),
        bats=np.array(["left" if row["stand"] == "L" else "right" for row in rows]),
        density=density_of(rows),
        height=np.array([GLOVE if row["events"] in CAUGHT else 0.0 for row in rows]),
        distance=column(rows, "hit_distance_sc") * FOOT,
        game=np.array([row["game_pk"] for row in rows]),
        home=np.array([row["home_team"] for row in rows]),
        home_run=np.array([row["events"] == "home_run" for row in rows]),
        roof=np.array([row["home_team"] == ROOF for row in rows]),
        month=np.array([float(row["game_date"].split("/")[0]) for row in rows]),
    )


def drag_seen(pitches: Pitches, law: Aerodynamics) -> tuple[Array, Array, Array, NDArray[np.bool_]]:
    """Return Cd of pitches, what goes with active spin (krpm) and with Re_0 / Re - 1, and which rows are sound."""
    ball = catalog.ball()
    speed = np.linalg.norm(pitches.velocity, axis=-1)
    spin = spin_from_movement(
        pitches.velocity, acceleration=pitches.acceleration, ball=ball, aerodynamics=law, density=pitches.density
    )
    active = np.linalg.norm(spin, axis=-1) / KRPM
    push = pitches.acceleration + np.array([0.0, 0.0, 9.80665])
    strength = pitches.density * math.pi * ball.radius**2 / (2 * ball.mass)
    seen = -np.sum(push * pitches.velocity, axis=-1) / (strength * speed**3)
    thinner = REFERENCE_REYNOLDS * VISCOSITY / (2 * pitches.density * ball.radius * speed) - 1
    usual = 0.305 + 0.02 * np.nan_to_num(active)
    return seen, active, thinner, np.isfinite(active) & (active < 5) & (np.abs(seen - usual) < 0.1)


def within(values: Array, *groups: NDArray[np.int64]) -> Array:
    """Return values less the means of their groups, by turns until nothing is left of them."""
    for group in groups * 30:
        values = values - (np.bincount(group, values) / np.bincount(group))[group]
    return values


def fit_shape(pitches: Pitches, law: Aerodynamics, rows: NDArray[np.bool_] | None = None) -> tuple[Array, Array]:
    """Return by how much Cd grows per krpm of active spin and per Re_0 / Re - 1, with standard errors."""
    seen, active, thinner, sound = drag_seen(pitches, law)
    sound = sound if rows is None else sound & rows
    game, kind = (np.unique(names[sound], return_inverse=True)[1] for names in (pitches.game, pitches.kind))
    known = np.stack([within(values[sound], game, kind) for values in (active, thinner)], axis=-1)
    wanted = within(seen[sound], game, kind)
    found: Array = np.asarray(np.linalg.lstsq(known, wanted, rcond=None)[0], float)
    left = wanted - known @ found
    inverse = np.linalg.inv(known.T @ known)
    sums = np.stack([np.bincount(game, left * side) for side in known.T], axis=-1)  # errors go together in a game
    return found, np.sqrt(np.diag(inverse @ sums.T @ sums @ inverse))


def chances(hits: Hits, scatter: CarryScatter) -> Array:
    """Return each ball's chance of a home run in its own park."""
    law = catalog.aerodynamics()
    spray, _ = launched_to(
        hits.bearing,
        exit_speed=hits.exit_speed,
        launch_angle=hits.launch_angle,
        bats=hits.bats,
        conditions=FlightConditions(ball=catalog.ball(), aerodynamics=law, air=hits.density),
    )
    axes = spin_axes(hits.launch_angle, spray)
    backspin, sidespin = batted_ball_spin(hits.launch_angle, spray, bats=hits.bats)
    chance = np.zeros(len(spray))
    for team in np.unique(hits.home):
        here = hits.home == team
        chance[here] = home_run_chances(
            BallMotions(
                velocity=(hits.exit_speed[:, None] * axes[2])[here],
                spin=(backspin[:, None] * axes[0] + sidespin[:, None] * axes[1])[here],
                position=[0.0, 2 * FOOT, 3 * FOOT],
            ),
            FlightConditions(ball=catalog.ball(), aerodynamics=law, air=Air(temperature=TEMPERATURE)),
            parks=[catalog.park(team, 2022)],
            scatter=scatter,
        ).chance[:, 0]
    return chance


def fit_scatter(hits: Hits) -> None:
    """Print which shift and scatter of drag have the least Brier score of home runs: those of `CarryScatter`."""
    even = np.array([int(game) % 2 == 0 for game in hits.game])
    known = np.abs(hits.bearing) < FAIR
    halves = (("all games", known), ("even games", known & even), ("odd games", known & ~even))
    sides = ("roof", hits.roof), ("open", ~hits.roof)
    best = {(where, name): (np.inf, 0.0, 0.0) for where, _ in sides for name, _ in halves}
    for spread in (0.045, 0.055, 0.065, 0.075, 0.085):
        for shift in np.arange(-0.04, 0.06, 0.005).tolist():
            for where, rows in sides:
                scatter = replace(USUAL, **{where: spread, f"{where}_shift": shift})
                missed = (chances(hits, scatter) - hits.home_run) ** 2
                for name, half in halves:
                    best[where, name] = min(best[where, name], (float(missed[rows & half].mean()), spread, shift))
    for (where, name), (score, spread, shift) in best.items():
        print(
            f"home runs, {where}, {name}: Brier {score:.4f} by scatter {spread:.3f}, shift {shift:+.3f} "
            "of the drag coefficient"
        )


def home_runs(hits: Hits) -> None:
    """Print how many home runs the balls should have been in their own parks, and were, by chance."""
    chance = chances(hits, USUAL)
    for name, rows in (("roof", hits.roof), ("open", ~hits.roof), ("all", chance >= 0)):
        brier = np.mean((chance - hits.home_run)[rows] ** 2)
        print(
            f"home runs, {name}: {chance[rows].sum():.1f} expected, {hits.home_run[rows].sum()} hit, Brier {brier:.4f}"
        )
    for low, high in pairwise((0, 0.02, 0.1, 0.25, 0.5, 0.75, 0.9, 0.98, 1.01)):
        rows = (chance >= low) & (chance < high)
        print(f"  chance {low:4.2f} up: {rows.sum():4} balls, {chance[rows].mean():.3f} expected, "
              f"{hits.home_run[rows].mean():.3f} hit")  # fmt: skip


def of_pitches(pitches: Pitches, sheet: Aerodynamics, shape: Array) -> None:
    """Print shape and level of the drag of pitches by file, and by roof."""
    seen, active, thinner, sound = drag_seen(pitches, sheet)
    rest = seen - shape[0] * active - shape[1] * thinner
    print("pitches: per krpm, per Re_0 / Re, and the drag without what spin and Reynolds's number do by the law:")
    groups = {str(file): pitches.file == file for file in np.unique(pitches.file)}
    season = pitches.file == "2022"
    groups |= {"roof, 2022": season & pitches.roof, "open, 2022": season & ~pitches.roof}
    for name, chosen in groups.items():
        rows = chosen & sound
        games = np.unique(pitches.game[rows])
        own, about = fit_shape(pitches, sheet, rows) if len(games) > 1 else (np.full(2, np.nan), np.full(2, np.nan))
        means = [rest[rows & (pitches.game == game)].mean() for game in games]
        print(
            f"  {name:12} n {rows.sum():5}  {own[0]:.4f} +- {about[0]:.4f}, {own[1]:+.4f} +- {about[1]:.4f}; drag "
            f"{rest[rows].mean():.4f} +- {np.std(means) / max(len(games) - 1, 1) ** 0.5:.4f}, "
            f"scatter {rest[rows].std():.4f}"
        )


def main() -> None:
    """Fit the drag of pitches and the scatter of home runs, and print how sure."""
    options = argparse.ArgumentParser(description=__doc__)
    options.add_argument("folder", type=Path, help="folder of the public tables")
    folder = options.parse_args().folder
    pitches, hits = read_pitches(folder), read_hits(folder)
    sheet = catalog.aerodynamics("trajectory-calculator")
    shape, errors = fit_shape(pitches, sheet)
    print(f"all pitches, per krpm {shape[0]:.4f} +- {errors[0]:.4f}, per Re_0 / Re {shape[1]:.4f} +- {errors[1]:.4f}")
    of_pitches(pitches, sheet, shape)
    fit_scatter(hits)
    home_runs(hits)


if __name__ == "__main__":
    main()

"""Chances of home runs park by park, beside what was counted: ``python -m studies.park_ranking``.

The same tracked flies of 2022 are judged in every park, at 72 degF. Their number in a park, over the mean of all, is
set beside home runs at home against those on the road (2019), a public index of home runs and a public list of how much
farther balls carry; none of the three went into the chances. That with a closed roof that moves counted as none, as a
half and as a fixed one. The last lines ask Denver: what elevation does to its chances, and what more carry would.
"""

from __future__ import annotations

import argparse
import csv
from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from sweetspot import catalog
from sweetspot.flight.air import Air
from sweetspot.flight.bearing import launched_to
from sweetspot.flight.carry_scatter import MORE_DRAG, braked, usual_launch
from sweetspot.flight.conditions import FlightConditions
from sweetspot.flight.home_runs import NONE, USUAL, CarryScatter, home_run_chances
from sweetspot.flight.kernel import flights
from sweetspot.flight.park import Park
from sweetspot.motion.ball_motion import BallMotions
from sweetspot.numerics.arrays import Array
from sweetspot.units import DEGREE, FOOT, MPH
from tests.real_data import FOLDER
from tools.fit_aerodynamics import FAIR, TEMPERATURE, read, read_hits

LAW, BALL = catalog.aerodynamics(), catalog.ball()
NOW = 2023
"""Season of the parks that the public index and the public carries are of, within a year or two."""
DENVER, SEA_LEVEL = "COL", "BOS"
OLDER = {"AZ": "ARI"}


@dataclass(frozen=True)
class Published:
    """What is known of each park: letters, logarithms of two ratios of home runs, m of carry beyond the mean park."""

    clubs: list[str]
    counted: Array
    index: Array
    carry: Array


def published() -> Published:
    """Return what was counted and listed."""
    runs = read(FOLDER / "savant_2019_homeruns.csv.gz")
    home, road = Counter(row["home_team"] for row in runs), Counter(row["away_team"] for row in runs)
    with (FOLDER / "mlb_ballparks_elev_wall_minmax.csv").open(newline="") as file:
        listed = list(csv.DictReader(file))
    clubs = [row["team_name"] for row in listed]
    old = [OLDER.get(club, club) for club in clubs]
    return Published(
        clubs,
        np.log([home[club] / road[club] for club in old]),
        np.log([float(row["hr_park_effects"]) for row in listed]),
        FOOT * np.array([float(row["extra_distance"]) for row in listed]),
    )


def tracked_flies(most: int | None = None) -> tuple[BallMotions, NDArray[np.bool_]]:
    """Return how the flies of 2022 set out, and which of them were hit at 95 mph and more and 22 to 35 degrees."""
    hits = read_hits(FOLDER)
    hits = hits.where(np.abs(hits.bearing) < FAIR)
    hits = hits.where(np.arange(len(hits.bearing)) < (most or len(hits.bearing)))
    through = FlightConditions(ball=BALL, aerodynamics=LAW, air=hits.density)
    spray, _ = launched_to(hits.bearing, exit_speed=hits.exit_speed, launch_angle=hits.launch_angle, bats=hits.bats,
                           conditions=through)  # fmt: skip
    far = (hits.exit_speed > 95 * MPH) & (hits.launch_angle > 22 * DEGREE) & (hits.launch_angle < 35 * DEGREE)
    return usual_launch(hits.exit_speed, hits.launch_angle, spray, left=hits.bats == "left"), far


def chances(balls: BallMotions, parks: list[Park], scatter: CarryScatter, own_elevation: bool = True) -> Array:
    """Return the logarithms of how many home runs the balls would be, shape (parks,)."""
    through = FlightConditions(ball=BALL, aerodynamics=LAW, air=Air(temperature=TEMPERATURE))
    found = home_run_chances(balls, through, parks=parks, own_elevation=own_elevation, scatter=scatter)
    return np.asarray(np.log(found.chance.sum(axis=0)))


def mean_carries(balls: BallMotions, far: NDArray[np.bool_], parks: list[Park], scatter: CarryScatter) -> Array:
    """Return the mean carry of the far balls in each park, m."""
    carries = []
    for park in parks:
        air = Air(temperature=TEMPERATURE, elevation=park.elevation)
        through = [FlightConditions(ball=BALL, aerodynamics=law, air=air) for law in (LAW, braked(LAW))]
        plain, slower = (flights(balls, one).carry[far] for one in through)
        carries.append(np.mean(plain + scatter.of(park)[0] * (slower - plain) / np.log1p(MORE_DRAG)))
    return np.array(carries)


def main(arguments: Sequence[str] | None = None) -> None:
    """Rank the parks, and ask Denver."""
    options = argparse.ArgumentParser(description=__doc__)
    options.add_argument("--flies", type=int, default=None, help="take only so many of the tracked ones")
    known, (balls, far) = published(), tracked_flies(options.parse_args(arguments).flies)
    then, now = ([catalog.park(club, year) for club in known.clubs] for year in (2019, NOW))
    moves = np.array([park.roof == "retractable" for park in now])
    print("| a closed roof that moves is | counts of 2019 | public index | public carry | ft, roofs that move |")
    print("|---|---|---|---|---|")
    for closed in (0.0, 0.25, 0.5, 0.75, 1.0):
        scatter = replace(USUAL, closed=closed)
        carry = mean_carries(balls, far, now, scatter)
        apart = (known.carry - known.carry.mean() - carry + carry.mean())[moves] / FOOT
        pairs = ((chances(balls, then, scatter), known.counted), (chances(balls, now, scatter), known.index),
                 (carry, known.carry))  # fmt: skip
        cells = [f"{np.corrcoef(ours, theirs)[0, 1]:.2f}" for ours, theirs in pairs]
        missed = f"{apart.mean():+.1f}, rms {np.sqrt(np.mean(apart**2)):.1f}"
        print(f"| {closed:g} of a fixed one | {' | '.join(cells)} | {missed} |")
    ours = np.exp(chances(balls, now, USUAL))
    for place in np.argsort(-ours).tolist():
        told = f"{ours[place] / ours.mean():.2f}, index {np.exp(known.index[place]) / 100:.2f}"
        print(f"{known.clubs[place]}: {told}")
    denver(balls, far, now[known.clubs.index(DENVER)], float(ours.mean()))


def denver(balls: BallMotions, far: NDArray[np.bool_], park: Park, mean: float) -> None:
    """Print what elevation does to carries and chances in Denver, and what less drag would."""
    here, there = mean_carries(balls, far, [park, catalog.park(SEA_LEVEL)], NONE)
    high, low = (np.exp(chances(balls, [park], USUAL, own)[0]) for own in (True, False))
    print(f"{DENVER}: carry {here / FOOT:.0f} ft, {SEA_LEVEL} {there / FOOT:.0f}, ratio {here / there:.4f}; "
          f"home runs {high / mean:.2f} of the mean park's, {low / mean:.2f} with air at sea level")  # fmt: skip
    for less in (0.02, 0.03, 0.04):
        other = replace(USUAL, open_shift=USUAL.open_shift - less)
        more = mean_carries(balls, far, [park], other) - mean_carries(balls, far, [park], USUAL)
        print(f"  with {more[0] / FOOT:.1f} ft more carry {np.exp(chances(balls, [park], other)[0]) / mean:.2f}")


if __name__ == "__main__":
    main()

"""How much do baseballs differ? What the fastest of many tracked hits leave room for.

No hit that is measured without error can leave faster than the best head-on hit of its bat speed, unless its ball is
livelier than the mean. So the upper end of exit speed over that ceiling bounds the scatter of balls, once the errors of
the measured bat speeds and the pitches, which the table does not have, are put into simulated hits too. Printed are
percentiles of exit speed less the ceiling for the measured bat speed and an 82 mph pitch, deflections below 20 degrees
and bat speeds above 60 mph: of the table, and of a simulated league whose balls scatter by so much in restitution.

Run: .venv/bin/python -m studies.ball_scatter TABLE.csv [--bat r161-ash]. TABLE: a row for each batted
ball, with bat_speed, launch_speed (mph), attack_angle and launch_angle (deg).
"""

from __future__ import annotations

import argparse
from collections.abc import Sequence

import numpy as np
import polars as pl

from sweetspot import catalog
from sweetspot.catalog.balls import ball_doubts
from sweetspot.numerics.arrays import Array
from sweetspot.units import DEGREE, MPH
from sweetspot.validation.computations.space import own_ceiling, simulated_league

PERCENTILES = (90.0, 98.0, 99.5, 99.9)
SCATTERS = (0.0, 0.003, 0.004, 0.005, 0.007, 0.010, 0.0195)
"""Standard deviations of restitution; the last is what the rule's tolerance would be as a 90 % interval."""
RECOIL = 0.22
"""m / M_eff where bats hit best: q = (e - r) / (1 + r), so a ball gains its restitution's excess over 1 + r of the
closing speed."""
STRAIGHT, SLOWEST, PITCH = 20 * DEGREE, 60 * MPH, 82 * MPH


def above_ceiling(bat: str, *, bat_speed: Array, exit_speed: Array, deflection: Array) -> Array:
    """Return exit speeds less the ceiling of the bat speed, m/s, of the hits that count."""
    counts = (np.abs(deflection) < STRAIGHT) & (bat_speed > SLOWEST)
    return np.asarray(exit_speed[counts] - own_ceiling(bat, bat_speed[counts]))


def tracked(path: str, bat: str) -> Array:
    """Return the exit speeds of a table less their ceiling, m/s."""
    columns = ("bat_speed", "launch_speed", "attack_angle", "launch_angle")
    rows = pl.read_csv(path, infer_schema_length=None, null_values=["NA", ""])
    table = rows.select(pl.col(name).cast(pl.Float64) for name in columns).drop_nulls()
    bat_speed, exit_speed, attack, launch = (table[name].to_numpy() for name in columns)
    return above_ceiling(
        bat, bat_speed=bat_speed * MPH, exit_speed=exit_speed * MPH, deflection=(launch - attack) * DEGREE
    )


def main(arguments: Sequence[str] | None = None) -> int:
    """Print percentiles of the table and of simulated leagues."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0] if __doc__ else None)
    parser.add_argument("table")
    parser.add_argument("--bat", default="r161-ash")
    options = parser.parse_args(arguments)
    measured = tracked(options.table, options.bat)
    print("| hits | " + " | ".join(f"{each:g} %" for each in PERCENTILES) + " |")
    print("|---|" + "---|" * len(PERCENTILES))
    _row(f"tracked ({len(measured)})", measured)
    league, draw = simulated_league(options.bat), np.random.default_rng(1)
    normal = draw.standard_normal(len(league.measured_speed))
    for scatter in SCATTERS:
        livelier = scatter * normal * (league.measured_bat_speed + PITCH) / (1 + RECOIL)
        values = above_ceiling(
            options.bat,
            bat_speed=league.measured_bat_speed,
            exit_speed=league.measured_speed + livelier,
            deflection=league.deflection,
        )
        _row(f"simulated, scatter {scatter:g}", values)
    ball = catalog.ball()
    print(f"Taken for {ball.name}: " + "; ".join(f"{each.part} {dict(each.deviation)}" for each in ball_doubts(ball)))
    return 0


def _row(name: str, values: Array) -> None:
    cells = np.percentile(values, PERCENTILES) / MPH
    print(f"| {name} | " + " | ".join(f"{cell:.2f}" for cell in cells) + " |")


if __name__ == "__main__":
    raise SystemExit(main())

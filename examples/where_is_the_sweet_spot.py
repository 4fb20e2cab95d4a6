"""Where does this bat hit best? Every meaning of "sweet spot" for one bat, in inches from the tip.

Run: python examples/where_is_the_sweet_spot.py [BAT]     a name of the catalogue or a TOML file
"""

import sys

from sweetspot import analyse, catalog, standard_conditions
from sweetspot.analysis.bat_analysis import exit_speed_of
from sweetspot.units import INCH, MPH

bat = catalog.load_bat(sys.argv[1] if len(sys.argv) > 1 else "r161-ash")
result = analyse(bat, standard_conditions(bat))
spots = result.sweet_spots

meanings = {
    "greatest exit speed": spots.max_exit_speed,
    "greatest efficiency q": spots.max_collision_efficiency,
    "centre of percussion": spots.center_of_percussion,
    "node of mode 1": spots.node_1,
    "node of mode 2": spots.node_2,
    "least sting": spots.min_sting,
}
for name, position in meanings.items():
    print(f"{name:24} {(bat.length - position) / INCH:5.2f} in from the tip")

best = (bat.length - spots.max_exit_speed) / INCH
speed = exit_speed_of(result.best, result.conditions) / MPH
print(f"{bat.name} hits best {best:.2f} in from the tip: {speed:.1f} mph")

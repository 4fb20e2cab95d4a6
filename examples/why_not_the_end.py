"""Why not the end? The speed lost at the tip, split into what turning takes and what bending takes.

Run: python examples/why_not_the_end.py
"""

from sweetspot import analyse, catalog, effective_mass, standard_conditions
from sweetspot.analysis.bat_analysis import exit_speed_of
from sweetspot.units import MPH, OUNCE

bat = catalog.bat("r161-ash")
result = analyse(bat, standard_conditions(bat))
best, tip, swing = result.sweet_spots.max_exit_speed, bat.length, result.conditions.swing

top = exit_speed_of(result.best, result.conditions) / MPH
rigid = result.scan.rigid_exit_speed[-1] / MPH
real = result.scan.exit_speed[-1] / MPH

print(f"bat speed       best place {swing.speed_at(best) / MPH:5.1f} mph   tip {swing.speed_at(tip) / MPH:5.1f} mph")
for name, place in (("best place", best), ("tip", tip)):
    print(f"effective mass  {name:10} {effective_mass(result.body, place) / OUNCE:5.1f} oz")
print(f"exit speed      best place {top:5.1f} mph")
print(f"                tip, if the bat could not bend {rigid:5.1f} mph")
print(f"                tip, as it is {real:5.1f} mph")
print(f"The end costs {top - real:.1f} mph: {top - rigid:.1f} mph by turning and {rigid - real:.1f} mph by bending")

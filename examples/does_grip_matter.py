"""Does grip matter? The same hit with a free bat, with typical hands, and with a vice in place of the hands.

Run: python examples/does_grip_matter.py
"""

from sweetspot import analyse, catalog, held_modes, standard_conditions
from sweetspot.analysis.bat_analysis import TYPICAL_HAND, exit_speed_of, hit_at
from sweetspot.units import MPH

bat = catalog.bat("r161-ash")
conditions = standard_conditions(bat)
result = analyse(bat, conditions)
place = result.sweet_spots.max_exit_speed

grips = {
    "typical hands": conditions.hands.replaced(**TYPICAL_HAND),
    "a vice on the handle": conditions.hands.replaced(mass=50.0, stiffness=5e6, damping=100.0),
}
base = exit_speed_of(result.best, conditions)
print(f"{'free':20} {base / MPH:7.2f} mph")
for name, hands in grips.items():
    held = exit_speed_of(hit_at(place, modes=held_modes(result.free, hands), conditions=conditions), conditions)
    print(f"{name:20} {held / MPH:7.2f} mph   {100 * (held / base - 1):+.3f} %")

print(f"Grip changes the exit speed of {base / MPH:.1f} mph by {100 * result.grip_effect:+.4f} %")

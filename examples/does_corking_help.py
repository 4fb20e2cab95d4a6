"""Does corking help? The same player with a bat whole, drilled and corked, and what corking would have to bring.

Run: python examples/does_corking_help.py
"""

from sweetspot import catalog, standard_conditions
from sweetspot.analysis.comparison import compare
from sweetspot.units import INCH, MPH, OUNCE

whole = catalog.bat("r161-ash")
hole = {"diameter": 1 * INCH, "depth": 10 * INCH}
bats = {
    "whole": whole,
    "drilled": whole.drilled(**hole),
    "corked": whole.corked(**hole, fill=catalog.material("cork"), plug=1 * INCH),
}
found = compare(list(bats.values()), conditions=standard_conditions(whole), law=catalog.swing_law(), labels=list(bats))

print("bat         oz      q   bat mph  exit mph")
for bat in found.compared:
    mass, q = bat.analysis.body.mass / OUNCE, bat.collision_efficiency
    print(
        f"{bat.label:8} {mass:5.1f}  {q:.3f}     {bat.bat_speed.value / MPH:.1f}     {bat.exit_speed.value / MPH:.1f}"
    )

first, corked = found.reference, found.compared[-1]
gained = (corked.bat_speed.value - first.bat_speed.value) / MPH
needed = (corked.break_even - first.bat_speed.value) / MPH
low, high = corked.change.low / MPH, corked.change.high / MPH
print(
    f"Corking brings {gained:.1f} mph of bat speed and needs {needed:.1f} mph: the ball leaves "
    f"{corked.change.value / MPH:+.1f} mph ({low:+.1f} to {high:+.1f})"
)

"""Is it out? One swing at a fastball, the ball met a little lower each time, and the parks it leaves.

Run: python examples/is_it_out.py
"""

from math import pi

from sweetspot import Air, Contact, FlightConditions, Swing, SwingPath, batted_ball, catalog, fly_all_parks
from sweetspot.analysis.full_play import play
from sweetspot.dynamics.reduction import reduced_bat
from sweetspot.units import DEGREE, FOOT, INCH, MPH, RPM

bat, ball, wings = catalog.bat("r161-ash"), catalog.ball(), catalog.aerodynamics("baseball")
model = reduced_bat(bat, ball=ball)
place = bat.length - 6 * INCH
fastball = batted_ball(
    speed=85 * MPH, launch_angle=-6 * DEGREE, spray=pi, backspin=2200 * RPM, position=(0.0, 2 * FOOT, 3 * FOOT)
)
swing = Swing(bat_speed=74 * MPH, measured_at=place)
path = SwingPath(attack_angle=9 * DEGREE, attack_direction=-12 * DEGREE, tilt=32 * DEGREE)
usual = FlightConditions(ball=ball, aerodynamics=wings, air=Air())
parks = [catalog.park(name) for name in catalog.park_names()]
best = (0, 0.0, 0.0)
for tenths in range(2, 13, 2):
    offset = tenths / 10 * INCH
    played = play(model, usual, swing=swing, path=path, pitch=fastball, contact=Contact(place, offset))
    hit = played.strike.launched
    ends = fly_all_parks(hit, usual, parks=parks)
    out = sum(int(end.out.sum()) for end in ends)
    carry = played.flight.carry / FOOT
    up = hit.launch_angle / DEGREE
    print(f"{offset / INCH:.1f} in below: {hit.speed / MPH:5.1f} mph, {up:4.1f} deg up, {carry:3.0f} ft, out in {out}")
    best = max(best, (out, carry, offset / INCH))

out, carry, low = best
print(f"Met {low:.1f} in below its centre the ball carries {carry:.0f} ft and is out in {out} of {len(parks)} parks")

"""What is an inch worth? A made-up player's swings, what they say, and what better contact would bring.

Run: python examples/what_is_an_inch_worth.py
"""

import numpy as np

from sweetspot import catalog
from sweetspot.catalog.aerodynamic_laws import aerodynamics
from sweetspot.flight.air import Air
from sweetspot.player.advice import advise
from sweetspot.player.goal import Goal
from sweetspot.player.model import player_model
from sweetspot.player.posterior import fit_player
from sweetspot.player.prior import natural
from sweetspot.player.simulate import simulated_swings
from sweetspot.units import INCH, MPH

bat, ball = catalog.bat("r161-ash"), catalog.ball()
usual = natural(np.zeros(10))  # the most likely player before any swing was seen
swings = simulated_swings(usual, bats=[bat], ball=ball, count=120, pitch_speed=80 * MPH, seed=1)
found = fit_player(player_model(swings, bat=bat, ball=ball), seed=1)

speed, scatter = found.learned["bat_speed"].interval, found.learned["position_spread"].interval
print(f"bat speed {speed.value / MPH:.1f} mph ({speed.low / MPH:.1f} to {speed.high / MPH:.1f})")
print(f"scatter along the bat {scatter.value / INCH:.1f} in ({scatter.low / INCH:.1f} to {scatter.high / INCH:.1f})")
advice = advise(found, goal=Goal("exit-speed"), aerodynamics=aerodynamics(), air=Air())
inch, mile = advice.worth["position_spread"].gain, advice.worth["bat_speed"].gain
print(
    f"An inch less scatter along the bat is worth {inch.value / MPH:.1f} mph of exit speed "
    f"({inch.low / MPH:.1f} to {inch.high / MPH:.1f}), a mile an hour of bat speed {mile.value / MPH:.1f} mph"
)

"""Known values: materials, balls and bats, each number with unit, spread, source and kind.

Data live in TOML files beside this module; physics never reads them.
"""

from sweetspot.catalog.aerodynamic_laws import aerodynamics, aerodynamics_in, aerodynamics_names
from sweetspot.catalog.ballparks import park, park_names, parks
from sweetspot.catalog.balls import ball, ball_names, ball_sport
from sweetspot.catalog.bats import bat, bat_names, load_bat
from sweetspot.catalog.deliveries import delivery, delivery_names
from sweetspot.catalog.implements import implement, implement_names, load_implement
from sweetspot.catalog.materials import material, material_names
from sweetspot.catalog.sports import aerodynamics_of_ball, sport, sport_names
from sweetspot.catalog.swing_laws import swing_law, swing_law_names

__all__ = [
    "aerodynamics",
    "aerodynamics_in",
    "aerodynamics_names",
    "aerodynamics_of_ball",
    "ball",
    "ball_names",
    "ball_sport",
    "bat",
    "bat_names",
    "delivery",
    "delivery_names",
    "implement",
    "implement_names",
    "load_bat",
    "load_implement",
    "material",
    "material_names",
    "park",
    "park_names",
    "parks",
    "sport",
    "sport_names",
    "swing_law",
    "swing_law_names",
]

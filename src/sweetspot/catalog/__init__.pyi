"""The catalogue's loaders; `lazy_loader` reads this file, and so do type checkers."""

from .aerodynamic_laws import aerodynamics, aerodynamics_in, aerodynamics_names, conditions_in
from .ballparks import park, park_names, parks
from .balls import ball, ball_names, ball_sport
from .bats import bat, bat_names, load_bat
from .deliveries import delivery, delivery_names
from .implements import implement, implement_names, load_implement
from .materials import material, material_names
from .sports import aerodynamics_of_ball, sport, sport_implements, sport_names
from .swing_laws import swing_law, swing_law_names

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
    "conditions_in",
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
    "sport_implements",
    "sport_names",
    "swing_law",
    "swing_law_names",
]

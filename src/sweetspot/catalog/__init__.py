"""Known values: materials, balls and bats, each number with unit, spread, source and kind.

Data live in TOML files beside this module; physics never reads them.
"""

from sweetspot.catalog.balls import ball, ball_names
from sweetspot.catalog.bats import bat, bat_names, load_bat
from sweetspot.catalog.materials import material, material_names
from sweetspot.catalog.parks import park, park_names, parks

__all__ = [
    "ball",
    "ball_names",
    "bat",
    "bat_names",
    "load_bat",
    "material",
    "material_names",
    "park",
    "park_names",
    "parks",
]

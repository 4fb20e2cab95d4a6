"""sweetspot: the open laboratory of the ball-bat collision.

Describe a real bat, find where it hits best and why. Names here load their module when first used, so that
``import sweetspot`` stays fast::

    from sweetspot import analyse, catalog, standard_conditions

    bat = catalog.bat("r161-ash")
    result = analyse(bat, standard_conditions(bat))
    result.sweet_spots.max_exit_speed  # m from the knob end
"""

from __future__ import annotations

import lazy_loader

__version__ = "0.1.0"

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)

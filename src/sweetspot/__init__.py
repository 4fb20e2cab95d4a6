"""sweetspot: the open laboratory of the ball-bat collision.

Describe a real bat, find where it hits best and why. Names here load their module when first used, so that
``import sweetspot`` stays fast::

    from sweetspot import analyse, catalog, standard_conditions

    bat = catalog.bat("r161-ash")
    result = analyse(bat, standard_conditions(bat))
    result.sweet_spots.max_exit_speed  # m from the knob end

What to ask, and what to give. Plain numbers are in SI units and radians, positions are metres from the knob end;
`pint` quantities and texts with a unit (``"103 mph"``, ``"28 deg"``) are converted. Where a bat is wanted, its name in
the catalogue or its file will do:

- a bat or anything else that hits: `bat`, `implement`, `catalog`; its usual swing: `standard_conditions`;
- where it hits best and why: `analyse`, or `standard_analysis` in one call; beside other bats: `compare`;
- whether rules let it pass: `certify`;
- one collision: `hit`; many: `hits`; in space, with spin: `strike`, `strikes`;
- a ball in the air: `launched`, then `fly` in the air of `standard_flight`; in every park: `landings_everywhere`;
- a pitch that is hit: `play`, `plays`;
- what a bat is made of inside: `beam_model`, `rigid_body`, `all_modes`, `gripped`;
- the implemented paper: `paper_rows`.

``help(sweetspot.hit)`` and its like tell parameters, units, errors and an example.
"""

from __future__ import annotations

from types import FunctionType
from typing import Any

import lazy_loader

from sweetspot.numerics.notebook_display import Renderer, ShownInNotebooks

__version__ = "0.1.0"


def _reports() -> Renderer:
    """Load what shows answers in notebooks, when one asks."""
    from sweetspot.report import notebook

    return notebook


ShownInNotebooks.renderer = staticmethod(_reports)

_attached, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)


def __getattr__(name: str) -> Any:
    """Load a name when it is first used; a function's door takes names, files and quantities too."""
    thing = _attached(name)
    if isinstance(thing, FunctionType):
        from sweetspot.front_door import opened

        thing = opened(thing)
    globals()[name] = thing
    return thing

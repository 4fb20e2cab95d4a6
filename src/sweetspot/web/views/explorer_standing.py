"""Where a bat's numbers stand among those of the catalogue's bats that are sold for its sport."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache

import numpy as np

from sweetspot import catalog
from sweetspot.numerics.constants import STANDARD_AXIS
from sweetspot.web.catalogue import STUDIED
from sweetspot.web.controls import BatState, HitState
from sweetspot.web.views.explorer_curves import along

FEWEST = 6
"""Other bats below which a place among them says nothing."""
MORE = {"mass": "heavier than", "moi_6in": "more swing weight than", "collision_efficiency": "livelier than"}
"""What it means to be above another bat, by quantity."""


@dataclass(frozen=True)
class BatStanding:
    """Where a bat stands.

    Parameters
    ----------
    below : by quantity, how many of the others it is above, in words; empty where there are too few of them.
    among : what they are, in words.
    """

    below: Mapping[str, str]
    among: str


def standing(state: HitState) -> BatStanding | None:
    """Rank a bat by weight, swing weight and liveliness among bats that are sold; None: there are few.

    Bats are hit as is usual in their sport, so that how this one is swung makes no difference.
    """
    this = HitState(**{name: getattr(state, name) for name in BatState.model_fields})
    sport = along(this).reduced.bat.sport
    others = [numbers for key, numbers in _sold(sport).items() if key != this.bat or this.bat_toml is not None]
    if len(others) < FEWEST:
        return None
    numbers = _numbers(this)
    below = {
        name: f"{more} {sum(other[name] < numbers[name] for other in others)} of {len(others)}"
        for name, more in MORE.items()
    }
    among = f"Small, below a number: among the catalog's {len(others)} other {catalog.sport(sport).name.lower()} bats."
    return BatStanding(below, among)


@cache
def _sold(sport: str) -> dict[str, dict[str, float]]:
    """Return the numbers of the catalogue's bats of a sport that are sold, by their keys."""
    keys = (name for name in catalog.bat_names() if not name.startswith(STUDIED))
    return {key: _numbers(HitState(bat=key)) for key in keys if catalog.bat(key).sport == sport}


def _numbers(state: HitState) -> dict[str, float]:
    setup = along(state)
    body = setup.reduced.body
    return {
        "mass": body.mass,
        "moi_6in": body.moi(STANDARD_AXIS),
        "collision_efficiency": float(np.nanmax(setup.scan.collision_efficiency)),
    }

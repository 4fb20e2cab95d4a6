"""Where one batter of a season met the ball: from the folder that a season was written to."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import polars as pl

from sweetspot.errors import InputError, nearest_names
from sweetspot.numerics.arrays import Array
from sweetspot.units import INCH

HEADS = {"from_tip_in": INCH, "from_tip_m": 1.0}


def contact_places(folder: Path, batter: str) -> Array:
    """Return the medians of where a batter's balls were met, m from the tip, shape (balls,).

    Balls whose place could not be told are left out. Each median is drawn towards the season's mean, and whether a ball
    was met inside or outside of the best place is often not known: the scatter is a rough one.

    Parameters
    ----------
    folder : that a season was written to, with ``balls`` in it.
    batter : number or name as in the table's column ``batter``.

    Raises
    ------
    InputError
        when the folder holds no such balls, or none of this batter.
    """
    parts = sorted((folder / "balls").glob("*.parquet"))
    if not parts:
        raise InputError(f"{folder} holds no balls/*.parquet; give the folder that sweetspot season --out wrote")
    table = pl.scan_parquet(parts)
    heads = table.collect_schema().names()
    head = next((name for name in HEADS if name in heads), None)
    if head is None or "batter" not in heads:
        raise InputError(f"{folder} tells no batters or no places along a bat; run the season without --flight-only")
    who = pl.col("batter").cast(pl.String)
    places = table.filter(who == batter).select(head).drop_nulls().collect()[head].to_numpy()
    if not len(places):
        known = table.select(who.unique()).collect()["batter"].drop_nulls().to_list()
        raise InputError(f"no place of a ball of the batter {batter!r} is known. {nearest_names(batter, known)}")
    return np.asarray(places * HEADS[head], float)

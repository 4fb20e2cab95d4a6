"""A grouping's table with a unit in every column's name, as it leaves the program."""

from __future__ import annotations

import polars as pl

from sweetspot.report.quantities import SCALES
from sweetspot.season.counted import WITH
from sweetspot.season.standings import MEASURES, Standing

PARTS = ("", "_mean", "_spread", "_low50", "_high50", "_low90", "_high90")
ENDINGS = (*PARTS, "_balls", "_reliability", "_percentile")
US_NAMES = {"mph": "_mph", "in": "_in", "ft": "_ft"}
EV20 = "ev20"


def with_units(one: Standing, *, system: str) -> pl.DataFrame:
    """Return a grouping's table in a system's units, with the unit in every column's name."""
    changed = []
    scales = {name: scale for name, (scale, _) in MEASURES.items()} | {EV20: "speed"}
    names = one.table.columns
    scales |= {name: "speed" for name in names if name.startswith(WITH) and f"{name}_balls" in names}
    for column in one.table.get_columns():
        stem, part = _split(column.name, scales)
        if stem is None:
            changed.append(column)
            continue
        ending, size = _unit(scales[stem], system)
        label = stem.removeprefix(WITH).replace("-", "_") if stem.startswith(WITH) else stem
        label = f"gain_with_{label}" if stem.startswith(WITH) else label
        values = column / size if size != 1 and part in PARTS else column
        changed.append(values.alias(f"{label}{part}{ending if part in PARTS else ''}"))
    return pl.DataFrame(changed)


def _split(name: str, scales: dict[str, str]) -> tuple[str | None, str]:
    fits = [stem for stem in scales if name == stem or (name.startswith(f"{stem}_") and name[len(stem) :] in ENDINGS)]
    if not fits:
        return None, ""
    stem = max(fits, key=len)
    return stem, name[len(stem) :]


def _unit(scale: str, system: str) -> tuple[str, float]:
    if scale in ("share", "ratio"):
        return "", 1.0
    if system == "si":
        return SCALES[scale].ending, 1.0
    unit = SCALES[scale].us
    return US_NAMES[unit.name], unit.size

"""The command `parks`: the catalogue's fences."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Annotated, Any

from cyclopts import Parameter

from sweetspot.cli.options import Format

if TYPE_CHECKING:
    from sweetspot.park import Park

OutputFormat = Annotated[Format, Parameter(name="--format", help="table for people, json or csv for programs.")]
NAMED = {"left_field": -45.0, "left_center": -22.5, "center_field": 0.0, "right_center": 22.5, "right_field": 45.0}
"""Directions that people know by name, degrees from centre field."""


def parks(
    park: Annotated[str | None, Parameter(help="Park, old name of it, team or its letters; default: all.")] = None,
    /,
    *,
    format: OutputFormat = "table",
) -> None:
    """List the Major League parks with elevation, roof and fence, or one park's fence all the way round."""
    from sweetspot import catalog
    from sweetspot.cli.output import print_json, print_rows_csv, print_table
    from sweetspot.report.table import names_table

    if park is None:
        found = [(name, catalog.park(name)) for name in catalog.park_names()]
        rows = [{"key": key, **park_json(one)} for key, one in found]
        if format == "json":
            print_json({"parks": rows})
        elif format == "csv":
            print_rows_csv(rows)
        else:
            print_table(names_table([_short(key, one) for key, one in found], "Parks: elevation, and fence in ft"))
        return
    one = catalog.park(park)
    fence = [{"direction_rad": turn, "distance_m": far, "height_m": high} for turn, far, high in one.fence]
    if format == "json":
        print_json({**park_json(one), "fence": fence})
    elif format == "csv":
        print_rows_csv(fence)
    else:
        print_table(names_table(_round(one), f"{one.name}, {one.team}: the fence from left to right"))


def park_json(park: Park) -> dict[str, Any]:
    """Return a park's facts as other programs get them; distances in the directions people have names for."""
    heights = [height for _, _, height in park.fence]
    return {
        "name": park.name,
        "team": park.team,
        "city": park.city,
        "elevation_m": park.elevation,
        "roof": park.roof,
        **{f"{name}_m": park.distance_at(math.radians(angle)) for name, angle in NAMED.items()},
        "lowest_fence_m": min(heights),
        "highest_fence_m": max(heights),
    }


def _short(key: str, park: Park) -> dict[str, str]:
    from sweetspot.units import FOOT

    heights = [height / FOOT for _, _, height in park.fence]
    far = dict(zip(("left", "LC", "centre", "RC", "right"), NAMED.values(), strict=True))
    return {
        "name": key,
        "team": park.team,
        "elev.": f"{park.elevation / FOOT:.0f}",
        "roof": {"open": "", "retractable": "moves", "fixed": "fixed"}[park.roof],
        **{name: f"{park.distance_at(math.radians(angle)) / FOOT:.0f}" for name, angle in far.items()},
        "wall": f"{min(heights):.0f} to {max(heights):.0f}",
    }


def _round(park: Park) -> list[dict[str, str]]:
    from sweetspot.units import FOOT

    return [
        {
            "deg from centre": f"{math.degrees(turn):+.0f}",
            "distance ft": f"{far / FOOT:.0f}",
            "distance m": f"{far:.1f}",
            "height ft": f"{high / FOOT:.1f}",
            "height m": f"{high:.1f}",
        }
        for turn, far, high in park.fence
    ]

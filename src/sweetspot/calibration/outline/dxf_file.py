"""The curves of a DXF drawing: lines, polylines, arcs, splines, also inside blocks."""

from __future__ import annotations

from collections.abc import Iterable
from itertools import islice
from pathlib import Path
from typing import Any

import numpy as np

from sweetspot.calibration.outline.curves import MOST_POINTS, check_drawn
from sweetspot.errors import InputError
from sweetspot.numerics.arrays import Array
from sweetspot.numerics.text_files import check_ordinary

DRAWN = {"LINE", "LWPOLYLINE", "POLYLINE", "ARC", "ELLIPSE", "SPLINE"}
LAYERS = ("OUTLINE", "PROFILE", "CONTOUR")
"""Of the bat's outline; where there is one, all others are left out."""
FLATNESS = 2e-5
"""Of the drawing's size, by which straight pieces may miss a curve."""
MOST_PIECES = 20_000
"""Things drawn at most; others may lie on other layers."""
UNDER_WAY = -1
"""Instead of how many things a block shows, while they are counted."""
LARGEST = 4_000_000
"""Bytes of a drawing."""


def dxf_curves(path: Path) -> tuple[list[Array], float | None]:
    """Return the curves of a DXF file and its unit in m; None where the file names none.

    Raises
    ------
    InputError
        when the file is no DXF, is damaged, or shows more than an outline takes.
    """
    from ezdxf.lldxf.const import DXFError

    check_ordinary(path, most=LARGEST, advice="keep only the bat's outline")
    try:
        return _drawn(path)
    except InputError:
        raise
    except OSError as error:
        if error.strerror is None:  # what ezdxf raises for other files
            raise InputError(f"{path} is not a DXF drawing; save it as DXF (ASCII, any release)") from None
        raise InputError(f"{path} cannot be read: {error.strerror.lower()}") from None
    except (DXFError, UnicodeDecodeError, ValueError) as error:
        raise InputError(f"{path} is not a DXF drawing: {error}") from None
    except Exception:  # ezdxf stumbles over damage in any way: StopIteration, IndexError, AttributeError, ...
        raise InputError(f"{path} is a damaged DXF drawing; keep only the bat's outline and save it as R2000") from None


def _drawn(path: Path) -> tuple[list[Array], float | None]:
    """Return the curves and the unit of a file that may be damaged."""
    from ezdxf import disassemble, units
    from ezdxf import path as paths
    from ezdxf.enums import InsertUnits
    from ezdxf.filemanagement import readfile

    drawing = readfile(path)
    if _pieces(drawing.modelspace(), drawing.blocks, {}) > MOST_PIECES:
        raise InputError(f"{path} shows more than {MOST_PIECES} things; keep only the bat's outline")
    entities = [one for one in disassemble.recursive_decompose(drawing.modelspace()) if one.dxftype() in DRAWN]
    outline = [one for one in entities if one.dxf.layer.upper() in LAYERS]
    chosen = [one for one in map(paths.make_path, outline or entities) if len(one)]
    points = [np.array([(p.x, p.y) for p in one.control_vertices()]) for one in chosen]
    check_drawn(points, str(path))
    flatness = FLATNESS * max((float(np.ptp(one, axis=0).max()) for one in points), default=1.0)
    curves = [
        np.array([(point.x, point.y) for point in islice(one.flattening(flatness or 1.0), MOST_POINTS + 1)])
        for one in chosen
    ]
    if drawing.units == 0:
        return curves, None
    return curves, units.conversion_factor(InsertUnits(drawing.units), InsertUnits.Meters)


def _pieces(things: Iterable[Any], blocks: Any, known: dict[str, int]) -> int:
    """Return how many things are drawn, those of blocks as often as they are inserted, before any is.

    Raises
    ------
    InputError
        when a block holds itself.
    """
    count = 0
    for one in things:
        name = one.dxf.get("name", "") if one.dxftype() == "INSERT" else ""
        if not name or name not in blocks:
            count += 1
            continue
        if known.get(name) == UNDER_WAY:
            raise InputError(f"the block {name[:60]!r} of the drawing holds itself; keep only the bat's outline")
        if name not in known:
            known[name] = UNDER_WAY
            known[name] = max(1, _pieces(blocks[name], blocks, known))
        count += max(1, one.mcount) * known[name]
    return count

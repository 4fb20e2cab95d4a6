"""The curves of a DXF drawing: lines, polylines, arcs, splines, also inside blocks."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from sweetspot.errors import InputError
from sweetspot.numerics.arrays import Array
from sweetspot.numerics.text_files import check_ordinary

DRAWN = {"LINE", "LWPOLYLINE", "POLYLINE", "ARC", "ELLIPSE", "SPLINE"}
LAYERS = ("OUTLINE", "PROFILE", "CONTOUR")
"""Of the bat's outline; where there is one, all others are left out."""
FLATNESS = 2e-5
"""Of the drawing's size, by which straight pieces may miss a curve."""
LARGEST = 4_000_000
"""Bytes of a drawing."""


def dxf_curves(path: Path) -> tuple[list[Array], float | None]:
    """Return the curves of a DXF file and its unit in m; None where the file names none.

    Raises
    ------
    InputError
        when the file is no DXF.
    """
    from ezdxf import disassemble, units
    from ezdxf import path as paths
    from ezdxf.enums import InsertUnits
    from ezdxf.filemanagement import readfile
    from ezdxf.lldxf.const import DXFError

    check_ordinary(path, most=LARGEST, advice="keep only the bat's outline")
    try:
        drawing = readfile(path)
    except OSError as error:
        if error.strerror is None:  # what ezdxf raises for other files
            raise InputError(f"{path} is not a DXF drawing; save it as DXF (ASCII, any release)") from None
        raise InputError(f"{path} cannot be read: {error.strerror.lower()}") from None
    except (DXFError, UnicodeDecodeError, ValueError) as error:
        raise InputError(f"{path} is not a DXF drawing: {error}") from None
    except (IndexError, KeyError, TypeError, AttributeError):  # what ezdxf stumbles over in damaged solids and the like
        raise InputError(f"{path} is a damaged DXF drawing; keep only the bat's outline and save it as R2000") from None
    entities = [one for one in disassemble.recursive_decompose(drawing.modelspace()) if one.dxftype() in DRAWN]
    outline = [one for one in entities if one.dxf.layer.upper() in LAYERS]
    chosen = [paths.make_path(one) for one in outline or entities]
    sizes = [np.ptp(np.array([(p.x, p.y) for p in one.control_vertices()]), axis=0).max() for one in chosen if len(one)]
    flatness = FLATNESS * max(map(float, sizes), default=1.0)
    curves = [np.array([(point.x, point.y) for point in one.flattening(flatness)]) for one in chosen if len(one)]
    if drawing.units == 0:
        return curves, None
    return curves, units.conversion_factor(InsertUnits(drawing.units), InsertUnits.Meters)

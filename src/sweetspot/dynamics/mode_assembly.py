"""All motions of a bat that a ball can excite, in one list."""

from __future__ import annotations

from dataclasses import replace

from sweetspot.dynamics.beam import BeamModel
from sweetspot.dynamics.bending import bending_modes
from sweetspot.dynamics.dent import dent_compliance
from sweetspot.dynamics.modes import Modes, joined
from sweetspot.dynamics.patch import patch_law
from sweetspot.equipment.ball import Ball
from sweetspot.equipment.bat import Bat


def all_modes(line: BeamModel, ball: Ball, *, patch_factor: float = 1.0) -> Modes:
    """Return rigid motions and bending modes of a bat, and what its striking face or hollow barrel adds.

    A face adds roll and its own mode, damped as it damps this ball; a hollow barrel its hoop modes, which are felt
    through the ball's contact patch. A solid or drilled wood barrel has none that a ball could excite: it is dented,
    and gives way at once.

    Parameters
    ----------
    patch_factor : on the radius of the ball's contact patch, > 0; 1 unless its doubt is asked for (`PATCH_SPREAD`).
    """
    bending = bending_modes(line)
    if line.bat.face is not None:
        from sweetspot.dynamics.face_vibration import face_modes

        return joined(bending, face_modes(line, ball))
    if not isinstance(line.bat, Bat):
        return bending
    law = patch_law(ball, factor=patch_factor)
    if line.bat.shell is None:
        return replace(bending, compliances=(*bending.compliances, dent_compliance(line, law=law)))
    from sweetspot.dynamics.hoop import hoop_modes

    return joined(bending, hoop_modes(line, law=law))

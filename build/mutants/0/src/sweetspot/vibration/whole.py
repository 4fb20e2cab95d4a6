"""All motions of a bat that a ball can excite, in one list."""

from __future__ import annotations

from sweetspot.ball import Ball
from sweetspot.bat import Bat
from sweetspot.line import Line
from sweetspot.vibration.beam import bending_modes
from sweetspot.vibration.modes import Modes, joined


def modes_of(line: Line, ball: Ball) -> Modes:
    """Return rigid motions and bending modes of a bat, and what its striking face or hollow barrel adds.

    A face adds roll and its own mode, damped as it damps this ball; a hollow barrel its hoop modes, which are felt
    through the ball's contact patch. A solid or drilled wood barrel has none that matter: its hoop frequencies lie far
    above those a ball can excite.
    """
    bending = bending_modes(line)
    if line.bat.face is not None:
        from sweetspot.vibration.face import face_modes

        return joined(bending, face_modes(line, ball))
    if not isinstance(line.bat, Bat) or line.bat.shell is None:
        return bending
    from sweetspot.vibration.hoop import contact_patch, hoop_modes

    return joined(bending, hoop_modes(line, patch=contact_patch(ball)))

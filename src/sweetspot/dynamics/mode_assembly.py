"""All motions of a bat that a ball can excite, in one list."""

from __future__ import annotations

from sweetspot.dynamics.batch.reduction import reduced_beams
from sweetspot.dynamics.beam import BeamModel
from sweetspot.dynamics.modes import Modes
from sweetspot.equipment.ball import Ball


def all_modes(beam: BeamModel, ball: Ball, *, patch_factor: float = 1.0, count: int | None = None) -> Modes:
    """Return rigid motions and bending modes of a bat, and what its striking face or hollow barrel adds.

    A face adds roll and its own mode, damped as it damps this ball; a hollow barrel its hoop modes, which are felt
    through the ball's contact patch. A solid or drilled wood barrel has none that a ball could excite: it is dented,
    and gives way at once.

    Parameters
    ----------
    beam : from `beam_model`.
    ball : that will hit the bat: hoop modes are felt through its patch, a face is damped by it.
    patch_factor : on the radius of the ball's contact patch, > 0; 1 unless its doubt is asked for (`PATCH_SPREAD`).
    count : of the bending modes; None: a dozen, and beside a face as many dozens as a contact excites.

    >>> from sweetspot import all_modes, beam_model, catalog
    >>> modes = all_modes(beam_model(catalog.bat("r161-ash")), catalog.ball())
    >>> modes, modes.frequency[2:4].round()  # Hz, of the first two bending modes
    (<Modes: 2 rigid, 12 bending>, array([172., 572.]))
    """
    return reduced_beams([beam], ball=ball, patch_factor=patch_factor, count=count).modes(0)

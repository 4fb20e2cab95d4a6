"""What a tap of an implement may ring: the modes that its tones may be, where they lie, and when it counts as held."""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache

from sweetspot.calibration.measurements import Measurement
from sweetspot.calibration.naming import ModeName
from sweetspot.calibration.recording import BAT_BAND, Band
from sweetspot.calibration.tap_faults import HELD
from sweetspot.catalog.standard_hit import standard_conditions
from sweetspot.dynamics.beam import beam_model
from sweetspot.dynamics.mode_assembly import all_modes
from sweetspot.dynamics.modes import Modes
from sweetspot.equipment.bat import Bat
from sweetspot.equipment.implement import Implement

BELOW_FIRST = 0.6
"""Part of the lowest mode's frequency at which the band of a limp implement begins."""
TIMES_OWN = 2.0
"""Times the damping of the described implement's lowest mode, from which on it may be held (assumed)."""
FREEST, GRIP_TAPE = 0.015, 0.006
"""Damping ratio that a freely hung bat in general, and one of metal with tape on its handle, has at most (assumed).
Hands on made-up bats of metal leave it at 0.008 to 0.02, and lower its second and third tones by 3 and 5 %."""


@lru_cache(maxsize=32)
def modes_to_name(implement: Implement) -> Modes:
    """Return the modes that tones may be, with the ball of the implement's sport."""
    return all_modes(beam_model(implement), standard_conditions(implement).ball)


def usual_band(modes: Modes | None) -> Band:
    """Return the frequencies that are looked at unless somebody says: those of bats, and lower for a golf club."""
    bending = [] if modes is None else modes.of_family("bending")
    if modes is None or not bending:
        return BAT_BAND
    return Band(min(BAT_BAND.low, BELOW_FIRST * float(modes.frequency[bending[0]])), BAT_BAND.high)


def frame_modes(implement: Implement) -> Modes:
    """Return the modes that a tap on the frame, the shaft or the blade rings: strings and rubber are held still."""
    modes = modes_to_name(implement)
    return modes.selected([index for index, family in enumerate(modes.families) if family != "face"])


def free_damping(modes: Modes | None) -> float:
    """Return the damping ratio that a freely hung implement has at most; None: a bat in general.

    Twice that of its lowest mode as described, and `GRIP_TAPE` at least.
    """
    bending = [] if modes is None else modes.of_family("bending")
    return (
        FREEST if modes is None or not bending else max(GRIP_TAPE, TIMES_OWN * float(modes.damping_ratio[bending[0]]))
    )


def usual_held(modes: Modes | None) -> float:
    """Return the damping ratio from which on an implement counts as held: a blade of wood and rubber loses more."""
    return HELD if modes is None else max(HELD, free_damping(modes))


def telling(measurements: Sequence[Measurement], own: Implement) -> list[Measurement]:
    """Return the tones that tell something: of a racket, club or stick the first, to which its stiffness is scaled."""
    first = ModeName("bending", 1)
    return [one for one in measurements if isinstance(own, Bat) or one.mode == first]

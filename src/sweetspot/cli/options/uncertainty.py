"""How sure an answer is: the option, and the speeds that were written with an error."""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated

from cyclopts import Parameter

if TYPE_CHECKING:
    from sweetspot.cli.options.swing import SwingOptions
    from sweetspot.equipment.implement import Implement
    from sweetspot.motion.swing import Conditions
    from sweetspot.uncertainty.sources import Sources

Uncertainty = Annotated[
    bool,
    Parameter(negative="", help="Put intervals beside the numbers, and say what they come from. Speeds: 70mph±2mph."),
]


def sources_for(name: str | None, bat: Implement, conditions: Conditions, swing: SwingOptions) -> Sources:
    """Return what is not known about a hit; a calibrated bat's file knows its own part.

    Parameters
    ----------
    name : of the bat's file or catalogue entry; None: it has none of its own.
    swing : as it was asked for; a speed without ± is known to one unit of its last digit, and what was not given is as
        usual and taken as it is.
    """
    from sweetspot.calibration.calibrated_file import deviations_of
    from sweetspot.cli.options.written_errors import error_of
    from sweetspot.uncertainty.sources import sources_of

    return sources_of(
        bat, conditions, known=None if name is None else deviations_of(name),
        bat_speed_error=error_of(swing.bat_speed, "speed", "--bat-speed"),
        pitch_speed_error=error_of(swing.pitch_speed, "speed", "--pitch-speed"),
    )  # fmt: skip

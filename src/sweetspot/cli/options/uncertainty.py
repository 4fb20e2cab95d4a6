"""How sure an answer is: the option of commands that have intervals only where they are asked for."""

from __future__ import annotations

from typing import Annotated

from cyclopts import Parameter

Uncertainty = Annotated[
    bool,
    Parameter(negative="", help="Put intervals beside the numbers, and say what they come from. Speeds: 70mph±2mph."),
]

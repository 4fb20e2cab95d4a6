"""The paddle that tests of paddles change."""

from __future__ import annotations

from sweetspot import catalog
from sweetspot.equipment.paddle import Paddle


def paddle(**changes: object) -> Paddle:
    """Return the catalogue's pickleball paddle, changed."""
    tool = catalog.implement("pickleball-paddle")
    assert isinstance(tool, Paddle)
    return tool.replaced(**changes)

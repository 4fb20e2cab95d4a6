"""A pitch by its name, thrown through the air that the other options describe."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from sweetspot.air import Air, Wind
    from sweetspot.ball import Ball
    from sweetspot.pitch import PitchFlight


def pitched(name: str, release_speed: str | None, *, ball: Ball, air: Air, wind: Wind) -> PitchFlight:
    """Return the catalogue's pitch of a name, over the middle of the plate; ``release_speed`` None: as is usual."""
    from sweetspot import catalog
    from sweetspot.pitch import aimed
    from sweetspot.units import parse

    delivery = catalog.delivery(name)
    if release_speed is not None:
        delivery = delivery.replaced(speed=parse(release_speed, "speed", "--release-speed"))
    return aimed(delivery, ball=ball, aerodynamics=catalog.aerodynamics("pitched-baseball"), air=air, wind=wind)

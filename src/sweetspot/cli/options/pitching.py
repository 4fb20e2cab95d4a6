"""A pitch by its name, thrown through the air that the other options describe."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from sweetspot.flight.conditions import FlightConditions
    from sweetspot.flight.pitch import PitchFlight


def pitched(name: str, release_speed: str | None, flying: FlightConditions) -> PitchFlight:
    """Return the catalogue's pitch of a name, over the middle of the plate; ``release_speed`` None: as is usual."""
    from sweetspot import catalog
    from sweetspot.catalog.sports import pitched_aerodynamics
    from sweetspot.flight.pitch import aimed
    from sweetspot.plausibility import parse

    delivery = catalog.delivery(name)
    if release_speed is not None:
        delivery = delivery.replaced(speed=parse(release_speed, "speed", "--release-speed"))
    return aimed(
        delivery, ball=flying.ball, aerodynamics=pitched_aerodynamics(name), air=flying.one_air, wind=flying.one_wind
    )

"""The ball that a season flies, by which law of drag and lift, and the field of balls whose table names none."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from sweetspot.catalog.aerodynamic_laws import DEFAULT_AERODYNAMICS, aerodynamics, usual_spin_line
from sweetspot.catalog.ballparks import park
from sweetspot.catalog.balls import ball, ball_sport
from sweetspot.catalog.sports import aerodynamics_of_ball
from sweetspot.errors import InputError
from sweetspot.flight.air import USUAL_AIR, Air
from sweetspot.flight.batted_spin import NO_SPIN
from sweetspot.flight.park import Park

if TYPE_CHECKING:
    from sweetspot.seasons.flight_columns import FlightSetting

LEAST_DRAG, MOST_DRAG = 0.5, 2.0
"""Of the law's, that may be given: all balls of a sport are far inside [our choice]."""


@dataclass(frozen=True, kw_only=True)
class FlightChoice:
    """How the balls of tables fly, and over which fence where the tables do not say.

    Parameters
    ----------
    ball : its name in the catalogue; its sport's drag and lift are taken.
    law : name of another law of drag and lift; None: the sport's.
    drag : over the law's, 0.5 to 2; None: what the distances of the tables say, and 1 where they say nothing.
    park : where balls were hit whose table names no park of the catalogue: a name, or a park; None: unknown.

    Raises
    ------
    InputError
        for a drag beyond any ball's.
    """

    ball: str = "baseball"
    law: str | None = None
    drag: float | None = None
    park: str | Park | None = None

    def __post_init__(self) -> None:
        """Refuse a drag that no ball has."""
        if self.drag is not None and not LEAST_DRAG <= self.drag <= MOST_DRAG:
            raise InputError(
                f"drag was given as {self.drag:g} of the law's; allowed is {LEAST_DRAG:g} to {MOST_DRAG:g}"
            )

    def setting(self, air: Air | None = None, *, threads: int | None = None) -> FlightSetting:
        """Return how flights are computed, in air that the tables do not give; None: the usual.

        >>> softball = FlightChoice(ball="softball-12in-fast").setting()
        >>> softball.major, softball.line == NO_SPIN
        (False, True)
        """
        from sweetspot.seasons.flight_columns import FlightSetting  # which needs polars

        baseball = ball_sport(self.ball) == "baseball"
        return FlightSetting(
            ball(self.ball),
            aerodynamics(self.law) if self.law else aerodynamics_of_ball(self.ball),
            air or USUAL_AIR,
            drag=self.drag,
            line=usual_spin_line(self.law or DEFAULT_AERODYNAMICS) if baseball else NO_SPIN,
            field=park(self.park) if isinstance(self.park, str) else self.park,
            major=baseball,
            threads=threads,
        )


USUAL_FLIGHT = FlightChoice()
"""A baseball by its own law, with the drag of its season."""

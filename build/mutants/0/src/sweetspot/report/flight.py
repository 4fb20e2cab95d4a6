"""A flight as JSON and in words, with the fence it met."""

from __future__ import annotations

from typing import Any

from sweetspot.flight.fence import Landing
from sweetspot.flight.trajectory import Flight, FlightOutcome
from sweetspot.motion import BallMotion
from sweetspot.park import Park
from sweetspot.report.border import cleaned
from sweetspot.units import DEGREE, FOOT, MPH, RPM


def flight_json(flight: Flight, *, path: bool = True) -> dict[str, Any]:
    """Return a flight with a unit in every name; ``path`` adds where the ball was at every step."""
    found: dict[str, Any] = {
        "outcome": flight.outcome.name.lower(),
        "carry_m": flight.carry,
        "hang_time_s": flight.hang_time,
        "apex_m": flight.apex_height,
        "apex_time_s": flight.apex_time,
        "landing_speed_m_s": flight.landing.speed,
        "landing_angle_rad": flight.landing_angle,
    }
    if path:
        right, out, up = flight.positions.T
        found["path"] = {"time_s": flight.times, "right_m": right, "out_m": out, "up_m": up}
    return cleaned(found)


def landing_json(landing: Landing, park: Park) -> dict[str, Any]:
    """Return where a flight ends in a park."""
    return cleaned(
        {
            "park": park.name,
            "outcome": landing.outcome,
            "direction_rad": landing.direction,
            "distance_m": landing.distance,
            "height_m": landing.height,
            "clearance_m": landing.clearance,
        }
    )


def flight_words(flight: Flight) -> str:
    """Return a flight in a sentence, in feet and miles per hour."""
    if flight.outcome is not FlightOutcome.LANDED:
        return flight.outcome.sentence[0].upper() + flight.outcome.sentence[1:] + "."
    return (
        f"It carries {flight.carry / FOOT:.0f} ft in {flight.hang_time:.1f} s, at most "
        f"{flight.apex_height / FOOT:.0f} ft high, and comes down {flight.landing_angle / DEGREE:.0f} deg steep at "
        f"{flight.landing.speed / MPH:.0f} mph."
    )


def landing_words(landing: Landing, park: Park) -> str:
    """Return in a sentence what that is in a park."""
    if landing.outcome == "foul":
        return f"At {park.name} it is foul."
    if landing.clearance is None:
        return f"At {park.name} it stays in the field of play."
    over = "over" if landing.clearance > 0 else "below"
    return (
        f"At {park.name} it reaches the fence {landing.distance / FOOT:.0f} ft away "
        f"{abs(landing.clearance) / FOOT:.0f} ft {over} its top: {landing.outcome}."
    )


def spin_words(ball: BallMotion) -> str:
    """Return a hit ball's spin, as "2200 rpm of backspin and 849 rpm that bend it right"."""
    back = signed(ball.backspin / RPM, "rpm of backspin", "rpm of topspin", 0)
    return f"{back} and {signed(ball.sidespin / RPM, 'rpm that bend it left', 'rpm that bend it right', 0)}"


def signed(value: float, positive: str, negative: str, digits: int = 1) -> str:
    """Return a number's size with the words that say its sign."""
    return f"{abs(value):.{digits}f} {positive if value >= 0 else negative}"

"""One flight with everything that was put in, as JSON, in words and as files."""

from __future__ import annotations

import json
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from rich.console import Group
from rich.text import Text

from sweetspot.aerodynamics import Aerodynamics
from sweetspot.ball import Ball
from sweetspot.flight.fence import Landing, landing
from sweetspot.flight.trajectory import Flight, FlightOutcome, fly
from sweetspot.flight.what_if import BattedBall
from sweetspot.park import Park
from sweetspot.report.border import cleaned
from sweetspot.report.flight import flight_json, flight_words, landing_json, landing_words, signed, spin_words
from sweetspot.units import DEGREE, FOOT, MPH


@dataclass(frozen=True)
class FlyReport:
    """A flight, and where it ends in a park if one was named.

    Parameters
    ----------
    out_in, parks : in how many of how many parks it is a home run; 0 of 0 where nobody asked for a park.
    """

    hit: BattedBall
    flight: Flight
    park: Park | None = None
    landing: Landing | None = None
    out_in: int = 0
    parks: int = 0

    @classmethod
    def of(
        cls, hit: BattedBall, *, ball: Ball, aerodynamics: Aerodynamics, park: Park | None, own_elevation: bool = True
    ) -> FlyReport:
        """Return the report of a hit.

        Parameters
        ----------
        park : where it is hit; its fence counts, and the hit is tried in every other park too.
        own_elevation : whether the other parks lie at their own elevation, or all where the hit says.
        """
        flight = fly(hit.motion, ball=ball, aerodynamics=aerodynamics, air=hit.air, wind=hit.wind)
        if park is None or flight.outcome is not FlightOutcome.LANDED:
            return cls(hit, flight)
        from sweetspot import catalog
        from sweetspot.flight.everywhere import landings_everywhere

        motion, parks = hit.motion, catalog.parks()
        everywhere = landings_everywhere(
            motion.position, motion.velocity, motion.spin, parks=parks, ball=ball, aerodynamics=aerodynamics,
            air=hit.air, wind=hit.wind, own_elevation=own_elevation,
        )  # fmt: skip
        out_in = sum(bool(found.out.all()) for found in everywhere)
        return cls(hit, flight, park, landing(flight.positions, park), out_in, len(parks))


def fly_json(report: FlyReport) -> dict[str, Any]:
    """Return a flight with a unit in every name."""
    launch = report.flight.launch
    found = {
        "launch": {
            "exit_speed_m_s": launch.speed,
            "launch_angle_rad": report.hit.launch_angle,
            "spray_rad": report.hit.spray,
            "backspin_rad_s": launch.backspin,
            "sidespin_rad_s": launch.sidespin,
            "gyrospin_rad_s": launch.gyrospin,
            "height_m": float(launch.position[2]),
        },
        "air_density_kg_m3": report.hit.air.density,
        **flight_json(report.flight),
    }
    if report.park is not None and report.landing is not None:
        found["fence"] = landing_json(report.landing, report.park)
        found["out_in"], found["parks"] = report.out_in, report.parks
    return cleaned(found)


def fly_words(report: FlyReport) -> list[str]:
    """Return a flight as a few sentences, in the units of players."""
    hit, launch = report.hit, report.flight.launch
    usual = " (what such hits usually have)" if hit.backspin is None and hit.sidespin is None else ""
    words = [
        f"A ball leaves at {launch.speed / MPH:.1f} mph, {signed(hit.launch_angle / DEGREE, 'deg up', 'deg down')} and "
        f"{_direction(hit.spray / DEGREE)}, with {spin_words(launch)}{usual}.",
        flight_words(report.flight),
    ]
    if report.park is not None and report.landing is not None:
        words.append(landing_words(report.landing, report.park))
        words.append(f"It is a home run in {report.out_in} of {report.parks} parks.")
    return words


def fly_table(report: FlyReport) -> Group:
    """Return what a terminal shows."""
    hit = report.hit
    wind = (
        "no wind"
        if hit.wind_speed == 0
        else f"wind {hit.wind_speed / MPH:.0f} mph towards {_direction(hit.wind_direction / DEGREE)}"
    )
    weather = (
        f"Air {32 + 1.8 * hit.temperature:.0f} degF, {100 * hit.humidity:.0f} % humid, {hit.elevation / FOOT:.0f} ft "
        f"above the sea: {hit.air.density:.4f} kg/m^3; {wind}."
    )
    return Group(Text(" ".join(fly_words(report))), Text(), Text(weather, style="dim"))


def write_fly(report: FlyReport, folder: Path) -> list[Path]:
    """Write fly.png, fly.svg and fly.json into a folder, all of them or none.

    Raises
    ------
    InputError
        when the folder cannot be made or written.
    """
    from sweetspot.plot.flight import flight_figure
    from sweetspot.plot.save import png_bytes, svg_bytes, write_folder

    figure = flight_figure(report.flight, report.park)
    text = json.dumps(fly_json(report), indent=1, allow_nan=False) + "\n"
    return write_folder(folder, {"fly.png": png_bytes(figure), "fly.svg": svg_bytes(figure), "fly.json": text.encode()})


def _direction(degrees: float) -> str:
    """Return a direction over the field in words."""
    if abs(degrees) < 0.05:
        return "to centre field"
    if abs(abs(degrees) - 180) < 0.05:
        return "to home plate"
    return f"{abs(degrees):.1f} deg {'right' if degrees > 0 else 'left'} of centre field"

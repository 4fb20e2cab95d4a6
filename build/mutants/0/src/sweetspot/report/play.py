"""A play as JSON, in words, as a table and as files: contact, launch, flight and fence."""

from __future__ import annotations

import json
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from sweetspot.ball import Ball
from sweetspot.bat import Bat
from sweetspot.flight.fence import Landing
from sweetspot.motion import BallMotion
from sweetspot.park import Park
from sweetspot.play import Play
from sweetspot.report.border import cleaned
from sweetspot.report.flight import flight_json, flight_words, landing_json, landing_words, signed, spin_words
from sweetspot.swing_path import SwingPath
from sweetspot.units import DEGREE, INCH, MPH


@dataclass(frozen=True)
class PlayReport:
    """A play with everything that was put in.

    Parameters
    ----------
    position, offset : m, where bat and ball met.
    park, landing : where the flight ends, if a park was asked for.
    """

    play: Play
    bat: Bat
    ball: Ball
    position: float
    offset: float
    path: SwingPath
    pitch: BallMotion
    park: Park | None = None
    landing: Landing | None = None

    @property
    def bat_radius(self) -> float:
        """Radius of the barrel where they met, m."""
        return float(self.bat.width_at(self.position)) / 2


def play_json(report: PlayReport) -> dict[str, Any]:
    """Return a play with a unit in every name; what a miss does not have is None."""
    struck, ball, impact = report.play.strike, report.play.strike.launched, report.play.strike.impact
    return cleaned(
        {
            "bat": report.bat.name,
            "outcome": struck.outcome.name.lower(),
            "position_m": report.position,
            "offset_m": report.offset,
            "pitch_speed_m_s": report.pitch.speed,
            "bat_speed_m_s": struck.bat_speed,
            "closing_speed_m_s": impact and impact.closing_speed,
            "collision_efficiency": impact and impact.collision_efficiency,
            "contact_time_s": impact and impact.contact_time,
            "peak_force_n": impact and impact.peak_force,
            "exit_speed_m_s": ball and ball.speed,
            "launch_angle_rad": ball and ball.launch_angle,
            "spray_rad": ball and ball.spray,
            "backspin_rad_s": ball and ball.backspin,
            "sidespin_rad_s": ball and ball.sidespin,
            "gyrospin_rad_s": ball and ball.gyrospin,
            "travel_along_m": struck.travel_along,
            "travel_around_m": struck.travel_around,
            "gripped": struck.gripped,
            "flight": report.play.flight and flight_json(report.play.flight),
            "fence": landing_json(report.landing, report.park) if report.landing and report.park else None,
        }
    )


def path_columns(report: PlayReport) -> dict[str, list[float]]:
    """Return the path of the ball as columns; empty after a miss."""
    flight = report.play.flight
    if flight is None:
        return {"time_s": [], "right_m": [], "out_m": [], "up_m": []}
    found: dict[str, list[float]] = flight_json(flight)["path"]
    return found


def play_words(report: PlayReport) -> list[str]:
    """Return what happened as a few sentences, in the units of players."""
    struck, ball = report.play.strike, report.play.strike.launched
    side = "below" if report.offset >= 0 else "above"
    from_tip = (report.bat.length - report.position) / INCH
    met = f"{from_tip:.1f} in from the tip, {abs(report.offset) / INCH:.2f} in {side} the ball's centre"
    if ball is None or report.play.flight is None:
        return [f"The bat came {met}: {struck.outcome.sentence}."]
    words = [
        f"The bat meets the ball {met}, at {struck.bat_speed / MPH:.1f} mph. The ball leaves at "
        f"{ball.speed / MPH:.1f} mph, {signed(ball.launch_angle / DEGREE, 'deg up', 'deg down')} and "
        f"{signed(ball.spray / DEGREE, 'deg to right field', 'deg to left field')}, with "
        f"{spin_words(ball)}.",
        flight_words(report.play.flight),
    ]
    if not struck.gripped:
        words[0] += " It slides on the bat all through the contact: friction cannot turn it further."
    if report.landing is not None and report.park is not None:
        words.append(landing_words(report.landing, report.park))
    return words


def play_table(report: PlayReport) -> Any:
    """Return what a terminal shows."""
    from rich.console import Group
    from rich.text import Text

    title = Text(f"{report.bat.name}: {report.pitch.speed / MPH:.0f} mph pitch", style="bold")
    return Group(title, Text(" ".join(play_words(report))))


def write_play(report: PlayReport, folder: Path) -> list[Path]:
    """Write play.png, play.svg and play.json into a folder, all of them or none.

    Raises
    ------
    InputError
        when the folder cannot be made or written.
    """
    from sweetspot.plot.play import play_figure
    from sweetspot.plot.save import png_bytes, svg_bytes, write_folder

    figure = play_figure(
        report.play, ball=report.ball, bat_radius=report.bat_radius, offset=report.offset, path=report.path,
        pitch=report.pitch, park=report.park, words=play_words(report),
    )  # fmt: skip
    text = json.dumps(play_json(report), indent=1, allow_nan=False) + "\n"
    return write_folder(
        folder, {"play.png": png_bytes(figure), "play.svg": svg_bytes(figure), "play.json": text.encode()}
    )

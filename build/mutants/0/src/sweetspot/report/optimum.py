"""The best way to hit: as JSON, as rows and as tables."""

from __future__ import annotations

import math
from typing import Any

from rich.table import Table

from sweetspot.optimum import BestLaunch, BestSwing, EasiestHomeRun
from sweetspot.pitch import PitchFlight
from sweetspot.report.table import names_table
from sweetspot.units import FOOT, INCH, MPH, RPM


def swing_row(best: BestSwing, pitch: PitchFlight) -> dict[str, Any]:
    """Return the best contact with one pitch as other programs get it."""
    left = best.launched
    return {
        "pitch": pitch.delivery.name,
        "release_speed_m_s": pitch.delivery.speed,
        "pitch_speed_m_s": pitch.plate.speed,
        "attack_angle_rad": best.attack_angle,
        "offset_m": best.offset,
        "undercut_m": best.undercut,
        "position_m": best.position,
        "exit_speed_m_s": left.speed,
        "launch_angle_rad": left.launch_angle,
        "spray_rad": left.spray,
        "backspin_rad_s": left.backspin,
        "sidespin_rad_s": left.sidespin,
        "carry_m": best.carry,
        "hang_time_s": best.hang_time,
    }


def launch_row(best: BestLaunch, *, exit_speed: float, backspin: float) -> dict[str, Any]:
    """Return the best launch angle of one exit speed."""
    return {
        "exit_speed_m_s": exit_speed,
        "backspin_rad_s": backspin,
        "launch_angle_rad": best.launch_angle,
        "carry_m": best.carry,
    }


def park_row(best: EasiestHomeRun) -> dict[str, Any]:
    """Return the slowest home run of one park."""
    return {
        "park": best.park.name,
        "team": best.park.team,
        "elevation_m": best.park.elevation,
        "exit_speed_m_s": best.exit_speed,
        "launch_angle_rad": best.launch_angle,
        "direction_rad": best.direction,
        "fence_distance_m": best.distance,
        "fence_height_m": best.height,
    }


def swings_table(rows: list[dict[str, Any]], *, length: float) -> Table:
    """Return the best contacts for people; ``length`` of the bat in m."""
    shown = [
        {
            "pitch": row["pitch"],
            "mph": f"{row['pitch_speed_m_s'] / MPH:.0f}",
            "attack": f"{math.degrees(row['attack_angle_rad']):.1f} deg",
            "offset": f"{row['offset_m'] / INCH:.2f} in",
            "undercut": f"{row['undercut_m'] / INCH:.2f} in",
            "in from tip": f"{(length - row['position_m']) / INCH:.1f}",
            "exit mph": f"{row['exit_speed_m_s'] / MPH:.1f}",
            "launch deg": f"{math.degrees(row['launch_angle_rad']):.1f}",
            "rpm": f"{row['backspin_rad_s'] / RPM:.0f}",
            "carry ft": f"{row['carry_m'] / FOOT:.0f}",
        }
        for row in rows
    ]
    return names_table(shown, "Contact that carries farthest (mph: the pitch at the plate; rpm: backspin of the hit)")


def launches_table(rows: list[dict[str, Any]]) -> Table:
    """Return the best launch angles for people."""
    shown = [
        {
            "exit speed mph": f"{row['exit_speed_m_s'] / MPH:.0f}",
            "backspin rpm": f"{row['backspin_rad_s'] / RPM:.0f}",
            "best launch deg": f"{math.degrees(row['launch_angle_rad']):.1f}",
            "carry ft": f"{row['carry_m'] / FOOT:.0f}",
        }
        for row in rows
    ]
    return names_table(shown, "Launch angle that carries farthest")


def parks_table(rows: list[dict[str, Any]]) -> Table:
    """Return the slowest home runs for people."""
    shown = [
        {
            "park": row["park"],
            "exit speed mph": f"{row['exit_speed_m_s'] / MPH:.1f}",
            "launch deg": f"{math.degrees(row['launch_angle_rad']):.1f}",
            "towards": _towards(row["direction_rad"]),
            "fence ft": f"{row['fence_distance_m'] / FOOT:.0f}",
            "wall ft": f"{row['fence_height_m'] / FOOT:.0f}",
        }
        for row in rows
    ]
    return names_table(shown, "Slowest home run, each park in its own air")


def _towards(direction: float) -> str:
    """Return a direction in degrees with its side of the field."""
    angle = round(math.degrees(direction))
    side = "left" if angle < 0 else "right" if angle > 0 else "centre"
    return f"{abs(angle)} deg {side}" if angle else side

"""The standard hit: the conditions that the command line, the docs and the published comparisons start from."""

from __future__ import annotations

from pathlib import Path

from sweetspot import catalog
from sweetspot.analysis.bat_analysis import Analysis, analyse
from sweetspot.catalog.sports import sport
from sweetspot.equipment.implement import Implement
from sweetspot.flight.air import Air
from sweetspot.flight.conditions import FlightConditions
from sweetspot.motion.swing import Conditions, Hands, Pitch, Swing


def standard_conditions(
    implement: Implement, *, pitch_speed: float | None = None, bat_speed: float | None = None
) -> Conditions:
    """Return the usual stroke at the usual ball of an implement's sport, turning about the bottom of the grip.

    For a baseball bat that is a 90 mph pitch and 70 mph of bat speed 6 in from the tip; a softball bat meets a
    softball at a softball's speed.

    Parameters
    ----------
    pitch_speed, bat_speed : m/s, in place of the usual ones; 0 is a ball on a tee.

    >>> standard_conditions(catalog.bat("slow-pitch")).ball.name
    'softball, 12 in, slow pitch'
    """
    usual = sport(implement.sport)
    stroke = usual.stroke
    return Conditions(
        pitch=Pitch(speed=stroke.ball_speed.value if pitch_speed is None else pitch_speed),
        swing=Swing(
            bat_speed=stroke.swing_speed.value if bat_speed is None else bat_speed,
            measured_at=implement.length - stroke.from_tip,
            pivot=implement.choke + stroke.pivot,
        ),
        hands=Hands(position=implement.choke + stroke.hands),
        ball=catalog.ball(usual.balls[0]),
    )


def standard_analysis(implement: Implement | str | Path, **speeds: float) -> Analysis[Implement]:
    """Return everything about an implement under the usual stroke of its sport: where it hits best, and why.

    Parameters
    ----------
    implement : itself, its name in the catalogue, or its file.
    speeds : ``pitch_speed`` and ``bat_speed`` in m/s, in place of the usual ones.

    >>> round(standard_analysis("r161-ash", pitch_speed=30.0).sweet_spots.max_exit_speed, 2)
    0.69
    """
    given = implement if isinstance(implement, Implement) else catalog.load_implement(str(implement))
    return analyse(given, standard_conditions(given, **speeds))


def standard_flight(ball: str = "baseball") -> FlightConditions:
    """Return the usual flight conditions of a ball of the catalogue: still air, 21 degrees C, half humid, at sea level.

    Parameters
    ----------
    ball : name in the catalogue, which brings its drag law.

    >>> standard_flight().one_air.temperature
    21.0
    """
    return FlightConditions(ball=catalog.ball(ball), aerodynamics=catalog.aerodynamics_of_ball(ball), air=Air())

"""Options that mean the same in every command, and what they become."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Annotated, Literal

from cyclopts import Parameter

from sweetspot.errors import InputError

if TYPE_CHECKING:
    from sweetspot.bat import Bat
    from sweetspot.swing import Conditions

Format = Literal["table", "json", "csv"]


@Parameter(name="*")
@dataclass(frozen=True)
class SwingOptions:
    """Pitch, swing, hands and ball; every quantity takes a unit."""

    pitch_speed: Annotated[str, Parameter(help="Speed of the ball at the plate: 90mph, 40m/s, or tee.")] = "90mph"
    bat_speed: Annotated[str, Parameter(help="Speed of the bat before impact at --bat-speed-at.")] = "70mph"
    bat_speed_at: Annotated[str, Parameter(help="Where the bat speed is measured.")] = "6in-from-tip"
    pivot: Annotated[
        str | None, Parameter(help="Axis the bat turns about, from the knob end; default: the bottom of the grip.")
    ] = None
    hands: Annotated[
        str | None,
        Parameter(help="Centre of the top hand, from the knob end; default: 6in above the bottom of the grip."),
    ] = None
    ball: Annotated[str, Parameter(help="Ball of the catalogue.")] = "baseball"
    ball_cor: Annotated[
        str | None,
        Parameter(help="Restitution of the ball as bought, at its law's speed, in place of the catalogue's."),
    ] = None
    ball_humidity: Annotated[
        str | None, Parameter(help="Relative humidity the ball was stored at, as a ratio: 0.5 or 50%.")
    ] = None
    ball_temperature: Annotated[str | None, Parameter(help="Temperature of the ball, for example 40degF.")] = None


def conditions_for(bat: Bat, options: SwingOptions) -> Conditions:
    """Return the conditions that the options describe for a bat."""
    from sweetspot import catalog
    from sweetspot.standard import HANDS
    from sweetspot.swing import Conditions, Hands, Pitch, Swing
    from sweetspot.units import parse, parse_position

    def place(text: str | None, default: float, what: str) -> float:
        return default if text is None else parse_position(text, length=bat.length, what=what)

    ball = catalog.ball(options.ball)
    if options.ball_cor is not None:
        ball = ball.with_restitution(parse(options.ball_cor, "ratio", "--ball-cor"))
    if options.ball_humidity is not None or options.ball_temperature is not None:
        humid, warm = options.ball_humidity, options.ball_temperature
        ball = ball.conditioned(
            humidity=None if humid is None else parse(humid, "ratio", "--ball-humidity"),
            temperature=None if warm is None else parse(warm, "temperature", "--ball-temperature"),
        )
    return Conditions(
        pitch=Pitch(speed=_pitch_speed(options.pitch_speed)),
        swing=Swing(
            bat_speed=parse(options.bat_speed, "speed", "--bat-speed"),
            measured_at=parse_position(options.bat_speed_at, length=bat.length, what="--bat-speed-at"),
            pivot=place(options.pivot, bat.choke, "--pivot"),
        ),
        hands=Hands(position=place(options.hands, bat.choke + HANDS, "--hands")),
        ball=ball,
    )


def _pitch_speed(text: str) -> float:
    """Return the pitch speed in m/s; 0 must be meant, so it is written ``tee``."""
    from sweetspot.units import parse

    if text.strip().lower() == "tee":
        return 0.0
    speed = parse(text, "speed", "--pitch-speed")
    if speed <= 0:
        raise InputError(
            f"--pitch-speed was given as {text!r}; allowed is a speed above zero towards the bat, "
            "or tee for a ball at rest"
        )
    return speed

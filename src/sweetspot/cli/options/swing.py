"""Options that mean the same in every command, and what they become."""

from __future__ import annotations

import warnings
from dataclasses import dataclass
from typing import TYPE_CHECKING, Annotated

from cyclopts import Parameter

from sweetspot.cli.options.reading import option, read
from sweetspot.errors import UnusualWarning

if TYPE_CHECKING:
    from sweetspot.answers.setups import HitSetup
    from sweetspot.equipment.implement import Implement
    from sweetspot.motion.swing import Conditions


@Parameter(name="*", allow_leading_hyphen=True)
@dataclass(frozen=True)
class StrokeOptions:
    """Swing, hands and ball; every quantity takes a unit. Defaults are the usual stroke of the bat's sport."""

    bat_speed: Annotated[
        str | None, Parameter(help="Speed of the bat before impact at --bat-speed-at; default: its sport's.")
    ] = None
    bat_speed_at: Annotated[
        str | None, Parameter(help="Where the bat speed is measured; default: 6in-from-tip for a bat.")
    ] = None
    pivot: Annotated[
        str | None, Parameter(help="Axis the bat turns about, from the knob end; default: the bottom of the grip.")
    ] = None
    hands: Annotated[
        str | None,
        Parameter(help="Centre of the top hand, from the knob end; default: 6in above the bottom of the grip."),
    ] = None
    ball: Annotated[
        str | None, Parameter(help="Ball of the catalogue, or a TOML file; default: the first of its sport.")
    ] = None
    ball_cor: Annotated[
        str | None,
        Parameter(help="Restitution of the ball as bought, at its law's speed, in place of the catalogue's."),
    ] = None
    ball_humidity: Annotated[
        str | None, Parameter(help="Relative humidity the ball was stored at, as a ratio: 0.5 or 50%.")
    ] = None
    ball_temperature: Annotated[str | None, Parameter(help="Temperature of the ball, for example 40degF.")] = None
    same_speed: Annotated[
        bool,
        Parameter(
            negative="",
            help="Swing other bats, or one that was changed or is choked up, at the same speed instead of with the "
            "same effort.",
        ),
    ] = False

    def setup(self, implement: Implement, *, errors: bool = True) -> HitSetup:
        """Return the setup that the options describe; ``errors``: whether errors written after ± count."""
        from sweetspot.answers.setups import HitSetup, Owner, value_of
        from sweetspot.catalog.sports import sport

        setup = read(HitSetup, self, of=Owner(implement.length, implement.sport), errors=errors)
        stroke = sport(implement.sport).stroke
        speeds = {"bat_speed": stroke.swing_speed.value, "pitch_speed": stroke.ball_speed.value}
        for name, speed in speeds.items():
            given = getattr(setup, name)
            if given is not None:
                _warn_of_unusual(option(name), getattr(self, name), value_of(given), speed)
        return setup


@Parameter(name="*", allow_leading_hyphen=True)
@dataclass(frozen=True)
class SwingOptions(StrokeOptions):
    """Pitch, swing, hands and ball; every quantity takes a unit. Defaults are the usual stroke of the bat's sport."""

    pitch_speed: Annotated[
        str | None, Parameter(help="Speed of the ball as it arrives: 90mph, 40m/s, or tee; default: its sport's.")
    ] = None


DEFAULT_SWING = SwingOptions()


def _warn_of_unusual(name: str, text: str, speed: float, usual: float) -> None:
    """Warn of a speed that is many times its sport's usual; a ball at rest is none."""
    from sweetspot.plausibility.implements import STROKES

    low, high = STROKES
    if usual and speed and not low <= speed / usual <= high:
        words = f"{name} was given as {text}, {speed / usual:.2g} times its sport's usual; check the unit"
        warnings.warn(words, UnusualWarning, stacklevel=3)


def conditions_for(implement: Implement, options: SwingOptions) -> Conditions:
    """Return the conditions that the options describe for an implement, with the bat speed that they give."""
    return options.setup(implement, errors=False).conditions(implement)

"""Options that mean the same in every command, and what they become."""

from __future__ import annotations

import warnings
from dataclasses import dataclass
from typing import TYPE_CHECKING, Annotated

from cyclopts import Parameter

from sweetspot.cli.options.unused import refuse_unused
from sweetspot.errors import InputError, UnusualWarning

if TYPE_CHECKING:
    from sweetspot.analysis.same_effort import Changed
    from sweetspot.equipment.implement import Implement
    from sweetspot.motion.swing import Conditions
    from sweetspot.report.document import Document


HandsAt = Annotated[
    str | None,
    Parameter(help="Centre of the top hand, from the knob end; default: 6in above the bottom of the grip."),
]
BallCor = Annotated[
    str | None,
    Parameter(help="Restitution of the ball as bought, at its law's speed, in place of the catalogue's."),
]
BallHumidity = Annotated[
    str | None, Parameter(help="Relative humidity the ball was stored at, as a ratio: 0.5 or 50%.")
]
BallTemperature = Annotated[str | None, Parameter(help="Temperature of the ball, for example 40degF.")]
SameSpeed = Annotated[
    bool,
    Parameter(
        negative="",
        help="Swing other bats, or one that was changed or is choked up, at the same speed instead of with the same "
        "effort.",
    ),
]


@Parameter(name="*", allow_leading_hyphen=True)
@dataclass(frozen=True)
class SwingOptions:
    """Pitch, swing, hands and ball; every quantity takes a unit. Defaults are the usual stroke of the bat's sport."""

    pitch_speed: Annotated[
        str | None,
        Parameter(help="Speed of the ball as it arrives: 90mph, 40m/s, or tee; default: its sport's."),
    ] = None
    bat_speed: Annotated[
        str | None,
        Parameter(help="Speed of the bat before impact at --bat-speed-at; default: its sport's."),
    ] = None
    bat_speed_at: Annotated[
        str | None, Parameter(help="Where the bat speed is measured; default: 6in-from-tip for a bat.")
    ] = None
    pivot: Annotated[
        str | None, Parameter(help="Axis the bat turns about, from the knob end; default: the bottom of the grip.")
    ] = None
    hands: HandsAt = None
    ball: Annotated[str | None, Parameter(help="Ball of the catalogue; default: the first of its sport.")] = None
    ball_cor: BallCor = None
    ball_humidity: BallHumidity = None
    ball_temperature: BallTemperature = None
    same_speed: SameSpeed = False


DEFAULT_SWING = SwingOptions()


@dataclass(frozen=True)
class SwungBat:
    """A bat as it is swung.

    Parameters
    ----------
    changed : the bat beside what it was before it was changed or choked up; None: nothing was changed of it.
    same_speed : whether a changed bat is swung as fast as before, and not with the same effort.
    """

    conditions: Conditions
    changed: Changed | None
    same_speed: bool

    def told(self, document: Document) -> Document:
        """Return an answer with the sentence that says how a changed bat is swung."""
        from sweetspot.report.swung_with import with_effort

        return with_effort(document, self.changed, self.conditions, same_speed=self.same_speed)


def swung_bat(bat: Implement, options: SwingOptions) -> SwungBat:
    """Return how a bat alone is swung: one that was changed, or is choked up, with the same effort as before."""
    from sweetspot import catalog
    from sweetspot.analysis.same_effort import Changed

    changed = Changed.of(bat, law=catalog.swing_law(catalog.sport(bat.sport).swing_law))
    if changed is None and options.same_speed:
        refuse_unused(["--same-speed"], "a bat that was changed or is choked up", "give the file of one")
    given = conditions_for(bat, options)
    turned = given if changed is None or options.same_speed else changed.with_same_effort(given)
    return SwungBat(turned, changed, options.same_speed)


def conditions_for(bat: Implement, options: SwingOptions) -> Conditions:
    """Return the conditions that the options describe for a bat, with the bat speed that they give."""
    from sweetspot import catalog
    from sweetspot.catalog.standard_hit import standard_conditions
    from sweetspot.cli.options.written_errors import without_error
    from sweetspot.motion.swing import Conditions, Hands, Pitch, Swing
    from sweetspot.plausibility import parse, parse_position

    usual = standard_conditions(bat)

    def place(text: str | None, default: float, what: str) -> float:
        return default if text is None else parse_position(text, length=bat.length, what=what)

    ball = usual.ball if options.ball is None else catalog.ball(options.ball)
    if options.ball is not None:
        say_if_of_another_sport(bat, options.ball)
    if options.ball_cor is not None:
        ball = ball.with_restitution(parse(options.ball_cor, "ratio", "--ball-cor"))
    if options.ball_humidity is not None or options.ball_temperature is not None:
        humid, warm = options.ball_humidity, options.ball_temperature
        ball = ball.conditioned(
            humidity=None if humid is None else parse(humid, "ratio", "--ball-humidity"),
            temperature=None if warm is None else parse(warm, "temperature", "--ball-temperature"),
        )
    conditions = Conditions(
        pitch=usual.pitch if options.pitch_speed is None else Pitch(speed=_pitch_speed(options.pitch_speed, bat.sport)),
        swing=Swing(
            bat_speed=(
                usual.swing.bat_speed
                if options.bat_speed is None
                else parse(without_error(options.bat_speed), "speed", "--bat-speed", sport=bat.sport)
            ),
            measured_at=place(options.bat_speed_at, usual.swing.measured_at, "--bat-speed-at"),
            pivot=place(options.pivot, usual.swing.pivot, "--pivot"),
        ),
        hands=Hands(position=place(options.hands, usual.hands.position, "--hands")),
        ball=ball,
    )
    if options.bat_speed is not None:
        _say_if_unusual("--bat-speed", options.bat_speed, conditions.swing.bat_speed / usual.swing.bat_speed)
    if options.pitch_speed is not None and usual.pitch.speed:
        _say_if_unusual("--pitch-speed", options.pitch_speed, conditions.pitch.speed / usual.pitch.speed)
    return conditions


def _say_if_unusual(option: str, text: str, of_usual: float) -> None:
    """Warn of a speed that is so many times its sport's usual; a ball at rest is none."""
    from sweetspot.plausibility.implements import STROKES

    low, high = STROKES
    if of_usual and not low <= of_usual <= high:
        words = f"{option} was given as {text}, {of_usual:.2g} times its sport's usual; check the unit"
        warnings.warn(words, UnusualWarning, stacklevel=2)


def say_if_of_another_sport(bat: Implement, ball_name: str) -> None:
    """Say on stderr that a ball belongs to another sport than what it is hit with; that is allowed."""
    import sys

    from sweetspot.catalog import ball_sport, sport
    from sweetspot.catalog.records import canonical

    its, theirs = ball_sport(ball_name), sport(bat.sport).name.lower()
    if sport(its).key != sport(bat.sport).key and canonical(ball_name) not in sport(bat.sport).balls:
        print(f"sweetspot: {ball_name} is a ball of {its}, {bat.name} is made for {theirs}; computed all the same",
              file=sys.stderr)  # fmt: skip


def _pitch_speed(text: str, sport: str) -> float:
    """Return the pitch speed in m/s; 0 must be meant, so it is written ``tee``."""
    from sweetspot.cli.options.written_errors import without_error
    from sweetspot.plausibility import parse

    if text.strip().lower() == "tee":
        return 0.0
    speed = parse(without_error(text), "speed", "--pitch-speed", sport=sport)
    if speed <= 0:
        raise InputError(
            f"--pitch-speed was given as {text!r}; allowed is a speed above zero towards the bat, "
            "or tee for a ball at rest"
        )
    return speed

"""What a question is asked of, as plain numbers: each field left out is what is usual in the implement's sport.

The command line fills these from its options and Python from keywords, so that both ask the same. Everything is SI, and
places count from the knob end.
"""

from __future__ import annotations

import math
import warnings
from dataclasses import dataclass
from typing import Annotated, Any, Literal, NamedTuple

from sweetspot import catalog
from sweetspot.analysis.comparison import ChangedBat
from sweetspot.answers.places import PlaceName, place_name, position_of
from sweetspot.answers.records import INTERNAL, Speed
from sweetspot.calibration.calibrated_file import known_deviations
from sweetspot.calibration.measured import SEPARATOR, Measured, parse_measured
from sweetspot.catalog.implements import Loaded
from sweetspot.catalog.records import canonical
from sweetspot.catalog.standard_hit import standard_conditions
from sweetspot.dynamics.block import FLOOR_MODULUS, Block, Support
from sweetspot.equipment.ball import Ball
from sweetspot.equipment.bat import Bat
from sweetspot.equipment.implement import Implement
from sweetspot.errors import InputError, UnusualWarning
from sweetspot.motion.swing import Conditions, Hands, Pitch, Swing
from sweetspot.motion.swing_path import Side, SwingPath
from sweetspot.plausibility import check, insisted, parse, parse_position
from sweetspot.uncertainty.sources import Sources, sources_of
from sweetspot.units import INCH, Kind, format_length
from sweetspot.units.quantities import KIND_OF

Written = float | Measured
"""A number, or one that was written with its standard error."""
Place = float
"""m from the knob end; a text may count from the tip."""
Exact = Written
"""A number that is exact unless its error is written: what is asked about, as a swing, is no measurement."""
ExactPlace = Written
"""A place that is exact unless its error is written."""


def value_of(written: Written) -> float:
    """Return a number without its error."""
    return written.value if isinstance(written, Measured) else written


def error_of(written: Written | None) -> float:
    """Return the standard error that a number was written with; 0: none."""
    return written.error if isinstance(written, Measured) else 0.0


@dataclass(frozen=True)
class SwungWith:
    """How a bat is swung that was changed or is choked up.

    ``same``: what is the same as before the change, "effort" or "speed".
    """

    same: Literal["effort", "speed"]
    bat_speed: Speed
    bat_speed_before: Speed
    changed: Annotated[ChangedBat, INTERNAL]
    conditions: Annotated[Conditions, INTERNAL]

    @classmethod
    def of(cls, changed: ChangedBat, conditions: Conditions, *, same_speed: bool) -> SwungWith:
        """Return the swing of a changed bat under these conditions."""
        speed = conditions.swing.bat_speed
        before = speed if same_speed else changed.speed_before(conditions)
        return cls("speed" if same_speed else "effort", speed, before, changed, conditions)


@dataclass(frozen=True, kw_only=True)
class HitSetup:
    """Pitch, swing, hands and ball of a hit; None: as is usual in the implement's sport.

    Parameters
    ----------
    pitch_speed : of the ball as it arrives, m/s; 0, or "tee" as a text: it is at rest.
    bat_speed, bat_speed_at : of the bat before impact, m/s, and where that is measured, m from the knob end.
    pivot : m from the knob end, the axis that the bat turns about.
    hands : m from the knob end, the centre of the top hand.
    ball : its name in the catalogue, or its TOML file.
    ball_cor : restitution of the ball as bought, at its law's speed.
    ball_humidity, ball_temperature : relative humidity that it was stored at, 0 to 1, and its temperature, degC.
    same_speed : whether a changed bat, or each of several, is swung at the same speed in place of the same effort.
    """

    pitch_speed: Exact | None = None
    bat_speed: Exact | None = None
    bat_speed_at: Place | None = None
    pivot: Place | None = None
    hands: Place | None = None
    ball: str | None = None
    ball_cor: float | None = None
    ball_humidity: float | None = None
    ball_temperature: float | None = None
    same_speed: bool = False

    def conditions(self, implement: Implement) -> Conditions:
        """Return the conditions of a hit with an implement, with the bat speed as given."""
        usual = standard_conditions(implement)
        ball = usual.ball if self.ball is None else catalog.ball(self.ball)
        if self.ball is not None:
            _warn_of_other_sport(implement, self.ball)
        if self.ball_cor is not None:
            ball = with_cor(ball, self.ball_cor)
        if self.ball_humidity is not None or self.ball_temperature is not None:
            ball = ball.conditioned(humidity=self.ball_humidity, temperature=self.ball_temperature)
        conditions = Conditions(
            pitch=usual.pitch if self.pitch_speed is None else Pitch(speed=value_of(self.pitch_speed)),
            swing=Swing(
                bat_speed=usual.swing.bat_speed if self.bat_speed is None else value_of(self.bat_speed),
                measured_at=usual.swing.measured_at if self.bat_speed_at is None else self.bat_speed_at,
                pivot=usual.swing.pivot if self.pivot is None else self.pivot,
            ),
            hands=Hands(position=usual.hands.position if self.hands is None else self.hands),
            ball=ball,
        )
        check_closing_speed(conditions, implement.sport)
        return conditions

    def swung(self, implement: Implement) -> tuple[Conditions, SwungWith | None]:
        """Return how an implement alone is swung: one that was changed or is choked up with the effort of before."""
        given = self.conditions(implement)
        if implement.before_changes() is implement:
            if self.same_speed:
                raise InputError(
                    "same_speed belongs to a bat that was changed or is choked up; give the file of one, or leave it "
                    "out"
                )
            return given, None
        changed = ChangedBat.of(implement, law=catalog.swing_law(catalog.sport(implement.sport).swing_law))
        turned = given if self.same_speed else changed.with_same_effort(given)
        return turned, SwungWith.of(changed, turned, same_speed=self.same_speed)

    def sources(self, loaded: Loaded, conditions: Conditions) -> Sources:
        """Return the unknowns of a hit; those of a calibrated implement come from its file."""
        return sources_of(
            loaded.implement,
            conditions,
            calibration=known_deviations(loaded.table),
            bat_speed_error=error_of(self.bat_speed),
            pitch_speed_error=error_of(self.pitch_speed),
        )


def with_cor(ball: Ball, cor: float) -> Ball:
    """Return a ball with another restitution at its law's speed; one that no ball of its sport has is refused."""
    check(cor, "ball_cor", f"{cor:.4g}", quantity="ball_restitution", sport=ball.sport)
    return ball.with_restitution(cor)


def check_closing_speed(conditions: Conditions, sport: str) -> None:
    """Refuse a ball and a bat that are fast enough each, and together faster than any hit of a sport."""
    speed = conditions.pitch.speed + conditions.swing.bat_speed
    check(speed, "closing speed", f"{speed:.4g} m/s", quantity="closing_speed", sport=sport)


def _warn_of_other_sport(implement: Implement, ball: str) -> None:
    """Warn of a ball of another sport than the implement's, which is allowed."""
    its, sport = catalog.ball_sport(ball), catalog.sport(implement.sport)
    if catalog.sport(its).key != sport.key and canonical(ball) not in sport.balls:
        warnings.warn(
            f"{ball} is a ball of {its}, {implement.name} is made for {sport.name.lower()}; computed all the same",
            UnusualWarning,
            stacklevel=4,
        )


@dataclass(frozen=True, kw_only=True)
class PathSetup:
    """Where the bat goes at contact; the defaults are the mean of the major leagues [sure2026].

    Parameters
    ----------
    attack_angle, attack_direction : rad, how steeply the barrel rises, and where it goes over the ground, 0 to centre
        field and negative to the pull side.
    tilt : rad, of the plane of the swing against the ground.
    bats : side the batter bats from.
    """

    attack_angle: float = math.radians(9)
    attack_direction: float = 0.0
    tilt: float = math.radians(32)
    bats: Side = "right"

    @property
    def path(self) -> SwingPath:
        """The swing's path."""
        return SwingPath(**vars(self))


@dataclass(frozen=True, kw_only=True)
class ContactSetup:
    """Where bat and ball meet.

    Parameters
    ----------
    at : m from the knob end, or "sweet-spot", "barrel" or "tip"; None: 6 in from the tip.
    offset : m by which the bat is under the ball's centre, square to its path; negative: over it.
    """

    at: ExactPlace | PlaceName | None = None
    offset: Exact = 0.6 * INCH

    def position(self, implement: Implement, conditions: Conditions) -> float:
        """Return the contact position along an implement, m from the knob end."""
        usual = implement.length - 6 * INCH
        at = self.at if isinstance(self.at, str) else usual if self.at is None else value_of(self.at)
        return position_of(at, implement, conditions)


@dataclass(frozen=True, kw_only=True)
class BlockSetup:
    """A block, and what holds it.

    Parameters
    ----------
    material : its name in the catalogue; wood is hit across the grain.
    thickness, size : m, of the block and of the side of its square face.
    support : held all round its edges, lying on a floor, or free.
    floor : what "floor" means.
    """

    material: str = "white-ash"
    thickness: float = 0.1
    size: float = 0.2
    support: Support = "floor"
    floor: Literal["concrete", "rigid"] = "concrete"

    @property
    def block(self) -> Block:
        """The block."""
        return Block(
            material=catalog.material(self.material),
            thickness=self.thickness,
            length=self.size,
            width=self.size,
            support=self.support,
            floor_modulus=FLOOR_MODULUS if self.floor == "concrete" else None,
        )


@dataclass(frozen=True, kw_only=True)
class FallSetup:
    """A ball that comes down on a block, or is fired at it.

    Parameters
    ----------
    height : m that it falls; None: 1 m unless ``speed`` is given.
    speed : m/s with which it is fired in place of a fall.
    ball : its name in the catalogue, or its TOML file.
    in_air : whether air slows fall and rise, as in the tests of rule books.
    """

    height: float | None = None
    speed: Exact | None = None
    ball: str = "baseball"
    in_air: bool = False


AS_USUAL = HitSetup()


def round_bat(loaded: Loaded) -> Bat:
    """Return the round bat that was loaded; refuse anything else."""
    if not isinstance(loaded.implement, Bat):
        raise InputError(f"{loaded.implement.name} is not a bat; give a round bat")
    return loaded.implement


def check_beyond_hands(position: float, hands: float) -> None:
    """Refuse a hit on the hands: a place that was meant from the tip counts from the knob end."""
    if position <= hands and not insisted():
        raise InputError(
            f"at was given as {format_length(position)} from the end of the grip, from which places count; there the "
            f"hands are, up to {hands / INCH:.3g} in. From the tip write it as 6in-from-tip, or add --force if it is "
            "intended"
        )


TEE = "tee"
"""A pitch speed of 0, which must be meant."""


class Owner(NamedTuple):
    """What a number belongs to: an implement ``length`` m long, and a ``sport``; "": any."""

    length: float = 0.0
    sport: str = ""


ANYONE = Owner()


def number_of_text(
    text: str,
    name: str,
    annotation: str,
    *,
    what: str,
    of: Owner = ANYONE,
    quantity: str = "",
    errors: bool = True,
) -> Written:
    """Return the number that a text gives, SI.

    Parameters
    ----------
    text : number and unit; what its annotation allows may have its error behind ±, or count from the tip.
    name, annotation : of the field of a setup, or of the parameter.
    what : its name for messages.
    of : the implement on which a place lies, and whose sport's bounds hold.
    quantity : its name in the table of bounds; "": the field's.
    errors : whether errors count; else what is written behind ± is left out.
    """
    kind = KIND_OF[name]
    alone = SEPARATOR.split(text, maxsplit=1)[0]
    if name == "pitch_speed" and text.strip().lower() == TEE:
        return 0.0
    if "Place" in annotation:
        place = parse_position(alone if "Exact" in annotation else text, length=of.length, what=what)
        return _with_error(place, error_behind(text, kind, what) if errors and "Exact" in annotation else 0.0)
    can_err = "Written" in annotation or "Exact" in annotation
    value = parse(alone if can_err else text, kind, what, sport=of.sport, quantity=quantity)
    if name == "pitch_speed" and value <= 0:
        raise InputError(
            f"{what} was given as {text!r}; allowed is a speed above zero towards the bat, or tee for a ball at rest"
        )
    if not errors or not can_err:
        return value
    return _with_error(
        value, error_behind(text, kind, what) if "Exact" in annotation else parse_measured(text, kind, what).error
    )


def value_of_text(text: str, name: str, annotation: str, **further: Any) -> Written | PlaceName:
    """Return the name of a place where its annotation allows one, else what `number_of_text` does."""
    named = place_name(text) if "PlaceName" in annotation else None
    return named or number_of_text(text, name, annotation, **further)


def _with_error(value: float, error: float) -> Written:
    return Measured(value, error) if error else value


def error_behind(text: str, kind: Kind, what: str) -> float:
    """Return the error behind a quantity's ±, SI; 0 where there is none: a place that was asked about is exact.

    >>> error_behind("6in-from-tip±0.5in", "length", "--at"), error_behind("6in-from-tip", "length", "--at")
    (0.0127, 0.0)
    """
    behind = SEPARATOR.split(text, maxsplit=1)[1:]
    error = parse(behind[0], kind, f"the error of {what}") if behind else 0.0
    if behind and not error > 0:
        raise InputError(f"the error of {what} was given as {behind[0]!r}; allowed is more than 0")
    return error

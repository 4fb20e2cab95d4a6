"""The command `optimum`: how to swing, how high to send the ball, and where a park is easiest to leave."""

from __future__ import annotations

from dataclasses import dataclass, fields, replace
from typing import TYPE_CHECKING, Annotated, Literal

from cyclopts import Parameter

from sweetspot.cli.options.output import DEFAULT_OUTPUT, OutputOptions
from sweetspot.cli.options.swing import BallCor, BallHumidity, BallTemperature, HandsAt, SameSpeed, SwingOptions
from sweetspot.cli.options.uncertainty import Uncertainty, sources_for
from sweetspot.cli.options.unused import given, refuse_unused
from sweetspot.cli.options.weather import DEFAULT_AIR, AirOptions
from sweetspot.errors import InputError

if TYPE_CHECKING:
    from sweetspot.answers.optimum import LaunchSearch, ParkSearch, SwingSearch
    from sweetspot.equipment.bat import Bat
    from sweetspot.motion.swing import Conditions

ALL = "all"
SPEEDS, SLOWER = ("90mph", "100mph", "110mph"), ("60mph", "70mph", "80mph")
"""Exit speeds that are asked for: where bats are swung at 65 mph and more, and where slower."""
FAST_SWING = 29.0
"""m/s."""


@Parameter(name="*")
@dataclass(frozen=True)
class ContactOptions:
    """The bat's motion and what of the contact is not searched."""

    bat_speed: Annotated[
        str | None, Parameter(help="Speed of the bat before impact at --bat-speed-at; default: its sport's.")
    ] = None
    bat_speed_at: Annotated[str | None, Parameter(help="Where the bat speed is measured; default: 6in-from-tip.")] = (
        None
    )
    pivot: Annotated[
        str | None, Parameter(help="Axis the bat turns about, from the knob end; default: the bottom of the grip.")
    ] = None
    hands: HandsAt = None
    at: Annotated[str | None, Parameter(help="Hit with this place of the bat; default: the best one is searched.")] = (
        None
    )
    attack_angle: Annotated[str | None, Parameter(help="Swing this steeply; default: the best is searched.")] = None
    tilt: Annotated[str, Parameter(help="Of the plane of the swing; 0deg keeps the bat level.")] = "32deg"
    ball: Annotated[str | None, Parameter(help="Ball of the catalogue; default: the first of the bat's sport.")] = None
    ball_cor: BallCor = None
    ball_humidity: BallHumidity = None
    ball_temperature: BallTemperature = None
    same_speed: SameSpeed = False
    uncertainty: Uncertainty = False


@Parameter(name="*")
@dataclass(frozen=True)
class PitchOptions:
    """What is thrown, for the first question."""

    pitch: Annotated[
        tuple[str, ...],
        Parameter(help="Pitches by name or letters; may be given again; default: its sport's.", negative=""),
    ] = ()
    release_speed: Annotated[str | None, Parameter(help="Throw them all this fast; default: as is usual.")] = None


@Parameter(name="*")
@dataclass(frozen=True)
class SentOptions:
    """How the ball leaves, for the other two questions."""

    exit_speed: Annotated[
        tuple[str, ...],
        Parameter(help="For the best launch angle; may be given again; default: three of its sport.", negative=""),
    ] = ()
    backspin: Annotated[str, Parameter(help="Of the ball in the last two questions.")] = "2200rpm"


DEFAULT_CONTACT, DEFAULT_PITCH, DEFAULT_SENT = ContactOptions(), PitchOptions(), SentOptions()


def optimum(
    bat: Annotated[str, Parameter(help="Name in the catalogue (see `sweetspot bats`) or a TOML file.")] = "r161-ash",
    /,
    *,
    pitch: PitchOptions = DEFAULT_PITCH,
    contact: ContactOptions = DEFAULT_CONTACT,
    sent: SentOptions = DEFAULT_SENT,
    air: AirOptions = DEFAULT_AIR,
    show: Annotated[
        Literal["all", "swing", "launch", "parks"],
        Parameter(help="One of the three questions only; csv answers one, swing unless said; parks: --park all."),
    ] = "all",
    output: OutputOptions = DEFAULT_OUTPUT,
) -> int:
    """Find the swing and the launch angle that carry farthest, and with --park (or --park all) the slowest home run."""
    from sweetspot import catalog
    from sweetspot.answers.flight_draws import drag_source
    from sweetspot.answers.optimum import OptimumQuestion, optimum_answer
    from sweetspot.cli.options.swing import swung_bat
    from sweetspot.cli.options.weather import through
    from sweetspot.cli.output import patience, present
    from sweetspot.report.optimum.document import optimum_document
    from sweetspot.uncertainty.sources import NOTHING

    _check_shown(show, pitch, contact, sent)
    everywhere = air.park == ALL or (show == "parks" and air.park is None)
    weather = replace(air, park=None) if everywhere else air
    asked: tuple[str, ...] = ("swing", "launch", "parks") if show == "all" else (show,)
    if output.format == "csv":
        asked = asked[:1]
    described, parks = catalog.load_bat(bat), everywhere or air.park is not None
    its = catalog.sport(described.sport)
    ball = contact.ball or its.balls[0]
    contact, pitch = replace(contact, ball=ball), replace(pitch, pitch=pitch.pitch or its.pitches)
    sent = replace(
        sent, exit_speed=sent.exit_speed or (SPEEDS if its.stroke.swing_speed.value > FAST_SWING else SLOWER)
    )
    stroke = _stroke(contact)
    player = swung_bat(described, stroke) if "swing" in asked else None
    with patience():
        question = OptimumQuestion(
            described,
            swing=None if player is None else _swing_search(described, pitch, contact, weather, player.conditions),
            launch=_launch_search(sent, ball, weather) if "launch" in asked else None,
            park=_park_search(sent.backspin, ball, weather, everywhere) if "parks" in asked and parks else None,
        )
        if contact.uncertainty:
            of_hit = NOTHING if player is None else sources_for(bat, described, player.conditions, stroke)
            drag = drag_source(through(weather, ball).aerodynamics)
            question = replace(question, sources=of_hit.with_source(drag))
        document = optimum_document(optimum_answer(question))
    return present(document if player is None else player.told(document), output)


def _check_shown(show: str, pitch: PitchOptions, contact: ContactOptions, sent: SentOptions) -> None:
    """Refuse what belongs to a question that is left out."""
    if show in ("launch", "parks"):
        swung = given(contact, *(one.name for one in fields(contact) if one.name not in ("ball", "uncertainty")))
        refuse_unused([*given(pitch, "pitch", "release_speed"), *swung], "the best swing", "leave --show out")
    if show in ("swing", "parks"):
        refuse_unused(given(sent, "exit_speed"), "the best launch", "leave --show out")
    if show == "swing":
        refuse_unused(given(sent, "backspin"), "the best launch", "leave --show out")


def _stroke(contact: ContactOptions) -> SwingOptions:
    """Return the options of the contact that other commands have too."""
    return SwingOptions(
        **{one.name: getattr(contact, one.name) for one in fields(SwingOptions) if hasattr(contact, one.name)}
    )


def _swing_search(
    bat: Bat, pitch: PitchOptions, contact: ContactOptions, weather: AirOptions, conditions: Conditions
) -> SwingSearch:
    from sweetspot.analysis.optimum.swing import Held
    from sweetspot.answers.optimum import SwingSearch
    from sweetspot.cli.options.pitching import pitched
    from sweetspot.cli.options.weather import through
    from sweetspot.dynamics.reduction import reduced_bat
    from sweetspot.equipment.implement import check_position
    from sweetspot.plausibility import parse, parse_position

    flying = replace(through(weather, str(contact.ball)), ball=conditions.ball)
    position = None if contact.at is None else parse_position(contact.at, length=bat.length, what="--at")
    if position is not None:
        check_position(bat, position, "--at")
    steep = None if contact.attack_angle is None else parse(contact.attack_angle, "angle", "--attack-angle")
    return SwingSearch(
        reduced_bat(bat, ball=conditions.ball).held(conditions.hands),
        conditions,
        flying,
        pitches=tuple(pitched(name, pitch.release_speed, flying) for name in pitch.pitch),
        tilt=parse(contact.tilt, "angle", "--tilt"),
        held=Held(position=position, attack_angle=steep),
    )


def _launch_search(sent: SentOptions, ball: str, weather: AirOptions) -> LaunchSearch:
    from sweetspot.answers.optimum import LaunchSearch
    from sweetspot.catalog.balls import ball_sport
    from sweetspot.cli.options.weather import through
    from sweetspot.plausibility import parse

    speeds = tuple(parse(text, "speed", "--exit-speed", sport=ball_sport(ball)) for text in sent.exit_speed)
    return LaunchSearch(through(weather, ball), speeds, parse(sent.backspin, "angular speed", "--backspin"))


def _park_search(backspin: str, ball: str, weather: AirOptions, everywhere: bool) -> ParkSearch:
    """Return every park that was asked for, and what is flown through there."""
    from sweetspot import catalog
    from sweetspot.answers.optimum import ParkSearch
    from sweetspot.cli.options.weather import park_of, through
    from sweetspot.plausibility import parse

    flying = through(weather, ball)
    if flying.one_wind.speed > 0:
        raise InputError(
            "--park was given with a wind; the slowest home run is found in still air only, so leave out --wind-speed "
            "or ask with --show swing or --show launch"
        )
    named = park_of(weather)
    parks = list(catalog.parks()) if everywhere or named is None else [named]
    own = everywhere and weather.elevation is None
    return ParkSearch(
        tuple((park, catalog.conditions_in(park, flying, own_elevation=own)) for park in parks),
        parse(backspin, "angular speed", "--backspin"),
    )

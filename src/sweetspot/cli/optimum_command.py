"""The command `optimum`: how to swing, how high to send the ball, and where a park is easiest to leave."""

from __future__ import annotations

from dataclasses import dataclass, fields, replace
from typing import TYPE_CHECKING, Annotated, Literal, NamedTuple

from cyclopts import Parameter

from sweetspot.cli.options.output import DEFAULT_OUTPUT, OutputOptions
from sweetspot.cli.options.swing import BallCor, BallHumidity, BallTemperature, HandsAt, SameSpeed, SwingOptions
from sweetspot.cli.options.uncertainty import Uncertainty, sources_for
from sweetspot.cli.options.unused import given, refuse_unused
from sweetspot.cli.options.weather import DEFAULT_AIR, AirOptions
from sweetspot.errors import InputError

if TYPE_CHECKING:
    from sweetspot.analysis.optimum import BestSwing, EasiestHomeRun
    from sweetspot.answers.play_question import PlayQuestion
    from sweetspot.cli.options.swing import SwungBat
    from sweetspot.dynamics.reduction import ReducedBat
    from sweetspot.equipment.bat import Bat
    from sweetspot.flight.conditions import FlightConditions
    from sweetspot.flight.park import Park
    from sweetspot.flight.pitch import PitchFlight
    from sweetspot.motion.swing import Conditions
    from sweetspot.report.document import Document
    from sweetspot.report.optimum.answers import AskedLaunch
    from sweetspot.uncertainty.sources import Sources

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
    from sweetspot.cli.options.weather import through
    from sweetspot.cli.output import patience, present
    from sweetspot.report.optimum.answers import Optimum
    from sweetspot.report.optimum.document import optimum_document
    from sweetspot.units import parse

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
    spin = parse(sent.backspin, "angular speed", "--backspin")
    with patience():
        swung = _swings(described, pitch, contact, weather) if "swing" in asked else None
        launches = _launches(sent, ball, weather) if "launch" in asked else None
        searched = _parks(sent.backspin, ball, weather, everywhere) if "parks" in asked and parks else None
        optimum = Optimum(
            described, swings=None if swung is None else swung.rows, launches=launches,
            parks=None if searched is None else [best for best, _ in searched],
        )  # fmt: skip
        document = optimum_document(optimum, held=contact.uncertainty)
        if contact.uncertainty:
            sources = None if swung is None else sources_for(bat, described, swung.conditions, swung.told)
            document = _sure(
                document, swung, launches or [], searched or [], through(weather, ball), sources=sources, backspin=spin
            )
    if swung is not None:
        document = swung.player.told(document)
    return present(document, output)


def _check_shown(show: str, pitch: PitchOptions, contact: ContactOptions, sent: SentOptions) -> None:
    """Refuse what belongs to a question that is left out."""
    if show in ("launch", "parks"):
        swung = given(contact, *(one.name for one in fields(contact) if one.name not in ("ball", "uncertainty")))
        refuse_unused([*given(pitch, "pitch", "release_speed"), *swung], "the best swing", "leave --show out")
    if show in ("swing", "parks"):
        refuse_unused(given(sent, "exit_speed"), "the best launch", "leave --show out")
    if show == "swing":
        refuse_unused(given(sent, "backspin"), "the best launch", "leave --show out")


class _Swung(NamedTuple):
    """The best contact with every pitch, and what it was searched with."""

    rows: list[tuple[BestSwing, PitchFlight]]
    model: ReducedBat[Bat]
    conditions: Conditions
    flying: FlightConditions
    tilt: float
    told: SwingOptions
    player: SwungBat


def _sure(
    document: Document,
    swung: _Swung | None,
    launches: list[AskedLaunch],
    searched: list[tuple[EasiestHomeRun, FlightConditions]],
    flying: FlightConditions,
    *,
    sources: Sources | None,
    backspin: float,
) -> Document:
    """Return the answer with an interval beside what follows from the best contact, launch angle and park."""
    from sweetspot.answers.flight_draws import drag_source
    from sweetspot.answers.optimum_draws import AskedPark, drawn_optimum
    from sweetspot.motion.ball_motion import USUAL_CONTACT, launched
    from sweetspot.report.uncertainty.uncertainty_section import uncertain
    from sweetspot.uncertainty.sources import NOTHING

    known = (sources or NOTHING).with_source(drag_source(flying.aerodynamics))
    left = [
        launched(
            speed=one.exit_speed, launch_angle=one.best.launch_angle, backspin=one.backspin, position=USUAL_CONTACT
        )
        for one in launches
    ]
    answers = drawn_optimum(
        known, backspin=backspin, swings=[] if swung is None else _played(swung),
        launches=[(one, flying) for one in left],
        parks=[AskedPark(best, here) for best, here in searched],
    )  # fmt: skip
    main = "swings.0.carry_m" if swung is not None else "launches.0.carry_m" if launches else "parks.0.exit_speed_m_s"
    named = "slowest home run" if main.startswith("parks") else "first farthest carry"
    return uncertain(document, answers, main=main, named=named, where=known.described)


def _played(swung: _Swung) -> list[PlayQuestion]:
    """Return the best contact with every pitch as a play."""
    from sweetspot.answers.play_question import PlayQuestion
    from sweetspot.collision.hit_in_space import Contact
    from sweetspot.motion.swing_path import SwingPath

    conditions, plays = swung.conditions, []
    for best, thrown in swung.rows:
        path = SwingPath(attack_angle=best.attack_angle, tilt=max(swung.tilt, abs(best.attack_angle)))
        pitched = conditions.replaced(pitch=conditions.pitch.replaced(speed=thrown.plate.speed))
        contact = Contact(best.position, best.offset)
        plays.append(PlayQuestion(swung.model, pitched, swung.flying, path, thrown.plate, contact))
    return plays


def _swings(bat: Bat, pitch: PitchOptions, contact: ContactOptions, weather: AirOptions) -> _Swung:
    from sweetspot.analysis.optimum import best_swing
    from sweetspot.analysis.optimum.swing import Held
    from sweetspot.cli.options.pitching import pitched
    from sweetspot.cli.options.swing import swung_bat
    from sweetspot.cli.options.weather import through
    from sweetspot.dynamics.reduction import reduced_bat
    from sweetspot.equipment.implement import check_position
    from sweetspot.motion.swing_path import SwingPlane
    from sweetspot.units import parse, parse_position

    told = SwingOptions(
        **{one.name: getattr(contact, one.name) for one in fields(SwingOptions) if hasattr(contact, one.name)}
    )
    player = swung_bat(bat, told)
    conditions = player.conditions
    flying = replace(through(weather, str(contact.ball)), ball=conditions.ball)
    position = None if contact.at is None else parse_position(contact.at, length=bat.length, what="--at")
    if position is not None:
        check_position(bat, position, "--at")
    steep = None if contact.attack_angle is None else parse(contact.attack_angle, "angle", "--attack-angle")
    model = reduced_bat(bat, ball=conditions.ball).held(conditions.hands)
    rows, tilt = [], parse(contact.tilt, "angle", "--tilt")
    for name in pitch.pitch:
        thrown = pitched(name, pitch.release_speed, flying)
        best = best_swing(
            model,
            flying,
            swing=conditions.swing,
            pitch=thrown.plate,
            plane=SwingPlane(tilt=tilt),
            held=Held(position=position, attack_angle=steep),
        )
        rows.append((best, thrown))
    return _Swung(rows, model, conditions, flying, tilt, told, player)


def _launches(sent: SentOptions, ball: str, weather: AirOptions) -> list[AskedLaunch]:
    from sweetspot.analysis.optimum import best_launch
    from sweetspot.catalog.balls import ball_sport
    from sweetspot.catalog.sports import check_exit_speed
    from sweetspot.cli.options.weather import through
    from sweetspot.report.optimum.answers import AskedLaunch
    from sweetspot.units import parse

    spin = parse(sent.backspin, "angular speed", "--backspin")
    flying = through(weather, ball)
    rows = []
    for text in sent.exit_speed:
        speed = parse(text, "speed", "--exit-speed")
        check_exit_speed(speed, ball_sport(ball), "--exit-speed", text)
        best = best_launch(speed, flying, backspin=spin)
        rows.append(AskedLaunch(speed, spin, best))
    return rows


def _parks(
    backspin: str, ball: str, weather: AirOptions, everywhere: bool
) -> list[tuple[EasiestHomeRun, FlightConditions]]:
    """Return the slowest home run of every park that was asked for, and what was flown through there.

    The park that is easiest to leave is the first.
    """
    from sweetspot import catalog
    from sweetspot.analysis.optimum import easiest_home_run
    from sweetspot.cli.options.weather import park_of, through
    from sweetspot.units import parse

    flying = through(weather, ball)
    if flying.one_wind.speed > 0:
        raise InputError(
            "--park was given with a wind; the slowest home run is found in still air only, so leave out --wind-speed "
            "or ask with --show swing or --show launch"
        )
    spin = parse(backspin, "angular speed", "--backspin")
    named = park_of(weather)
    parks: list[Park] = list(catalog.parks()) if everywhere or named is None else [named]
    rows = []
    for park in parks:
        own = everywhere and weather.elevation is None
        here = catalog.conditions_in(park, flying, own_elevation=own)
        rows.append((easiest_home_run(park, here, backspin=spin), here))
    return sorted(rows, key=lambda row: row[0].exit_speed)

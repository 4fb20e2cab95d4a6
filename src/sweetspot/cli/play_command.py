"""`sweetspot play`: from the pitch over the bat to the fence."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Annotated, Literal

from cyclopts import Parameter

from sweetspot.cli.options.output import DEFAULT_OUTPUT, OutputOptions
from sweetspot.cli.options.swing import DEFAULT_SWING, SwingOptions
from sweetspot.cli.options.uncertainty import Uncertainty, sources_for
from sweetspot.cli.options.unused import given, refuse_unused
from sweetspot.cli.options.weather import DEFAULT_AIR, AirOptions
from sweetspot.cli.options.written_errors import error_behind, without_error
from sweetspot.errors import InputError

if TYPE_CHECKING:
    from sweetspot.flight.conditions import FlightConditions
    from sweetspot.motion.ball_motion import BallMotion
    from sweetspot.motion.swing_path import SwingPath


@Parameter(name="*", allow_leading_hyphen=True)
@dataclass(frozen=True)
class PathOptions:
    """Where the bat goes at contact; the defaults are the mean of the major leagues [sure2026]."""

    attack_angle: Annotated[str, Parameter(help="How steeply the barrel rises: 9deg.")] = "9deg"
    attack_direction: Annotated[
        str, Parameter(help="Where the barrel goes over the ground: 0deg to centre field, negative to the pull side.")
    ] = "0deg"
    tilt: Annotated[str, Parameter(help="Of the plane of the swing against the ground: 32deg.")] = "32deg"
    bats: Annotated[Literal["right", "left"], Parameter(help="Side the batter bats from.")] = "right"


@Parameter(name="*", allow_leading_hyphen=True)
@dataclass(frozen=True)
class ArrivalOptions:
    """How the pitch arrives: by its name, or with --pitch-speed and these."""

    pitch: Annotated[
        str | None,
        Parameter(help="By name, thrown over the middle in place of the others: fastball, curve, ..."),
    ] = None
    release_speed: Annotated[str | None, Parameter(help="Throw that pitch this fast; default: as is usual.")] = None

    approach_angle: Annotated[
        str, Parameter(help="Of the pitch at the plate, below the level negative: -6deg is usual.")
    ] = "-6deg"
    pitch_backspin: Annotated[str, Parameter(help="Of the pitch, negative for a curve.")] = "2200rpm"
    pitch_sidespin: Annotated[str, Parameter(help="Of the pitch, positive bends it to its own left.")] = "0rpm"
    height: Annotated[str, Parameter(help="Of contact above the ground.")] = "3ft"
    forward: Annotated[str, Parameter(help="Of contact in front of the plate's tip.")] = "2ft"


@Parameter(name="*", allow_leading_hyphen=True)
@dataclass(frozen=True)
class MeetingOptions:
    """Where bat and ball meet."""

    at: Annotated[
        str, Parameter(help="Where the ball meets the bat: 27in, 6in-from-tip; with an error 6in-from-tip±0.5in.")
    ] = "6in-from-tip"
    offset: Annotated[
        str, Parameter(help="How far the bat is under the ball's centre, square to its path; negative: over it.")
    ] = "0.6in"
    uncertainty: Uncertainty = False


DEFAULT_MEETING, DEFAULT_PATH, DEFAULT_ARRIVAL = MeetingOptions(), PathOptions(), ArrivalOptions()


def play(
    bat: Annotated[str, Parameter(help="Name in the catalogue (see `sweetspot bats`) or a TOML file.")] = "r161-ash",
    /,
    *,
    meeting: MeetingOptions = DEFAULT_MEETING,
    swing: SwingOptions = DEFAULT_SWING,
    path: PathOptions = DEFAULT_PATH,
    arrival: ArrivalOptions = DEFAULT_ARRIVAL,
    air: AirOptions = DEFAULT_AIR,
    output: OutputOptions = DEFAULT_OUTPUT,
) -> int:
    """Follow one pitch: how the bat meets it, how the ball leaves, how far it flies and whether it is out."""
    from sweetspot import catalog
    from sweetspot.analysis.bat_analysis import check_conditions
    from sweetspot.answers.play import play_answer
    from sweetspot.answers.play_draws import play_sources
    from sweetspot.answers.play_question import PlayQuestion
    from sweetspot.cli.hit_command import check_beyond_hands
    from sweetspot.cli.options.swing import swung_bat
    from sweetspot.cli.options.weather import park_of, through
    from sweetspot.cli.output import patience, present
    from sweetspot.collision.hit_in_space import Contact
    from sweetspot.dynamics.reduction import reduced_bat
    from sweetspot.plausibility import parse, parse_position
    from sweetspot.report.play.document import play_document

    described = catalog.load_bat(bat)
    swung = swung_bat(described, swing)
    conditions = swung.conditions
    model = reduced_bat(described, ball=conditions.ball).held(conditions.hands)
    check_conditions(described, conditions, body=model.body)
    position = parse_position(without_error(meeting.at), length=described.length, what="--at")
    check_beyond_hands(position, conditions.hands.position, meeting.at)
    offset = parse(without_error(meeting.offset), "length", "--offset")
    place_error = error_behind(meeting.at, "length", "--at")
    offset_error = error_behind(meeting.offset, "length", "--offset")
    ball = swing.ball or catalog.sport(described.sport).balls[0]
    flying = replace(through(air, ball), ball=conditions.ball)
    sources = None
    if meeting.uncertainty:
        sources = play_sources(
            sources_for(bat, described, conditions, swing),
            flying.aerodynamics,
            place_error=place_error,
            offset_error=offset_error,
        )
    question = PlayQuestion(
        model,
        conditions,
        flying,
        path=path_of(path),
        pitch=_pitch_at_plate(arrival, swing, conditions.pitch.speed, flying),
        contact=Contact(position, offset),
        park=park_of(air),
        outdoors=catalog.aerodynamics_of_ball(ball),
        sources=sources,
    )
    with patience():
        answer = play_answer(question)
    return present(swung.told(play_document(answer)), output)


def _pitch_at_plate(arrival: ArrivalOptions, swing: SwingOptions, speed: float, flying: FlightConditions) -> BallMotion:
    """Return the pitch as it arrives: thrown by its name, or with a speed in m/s and the options' angles and spins."""
    from sweetspot.cli.options.pitching import pitched

    if arrival.pitch is not None and swing.pitch_speed is not None:
        raise InputError("--pitch and --pitch-speed were both given; say --release-speed for a named pitch")
    if arrival.pitch is None and arrival.release_speed is not None:
        raise InputError("--release-speed is of a pitch that is thrown; name it with --pitch, or give --pitch-speed")
    if arrival.pitch is None:
        return arriving(arrival, speed)
    its_own = given(arrival, "approach_angle", "pitch_backspin", "pitch_sidespin", "height", "forward")
    refuse_unused(its_own, "a pitch without a name", "give --pitch-speed in place of --pitch")
    return pitched(arrival.pitch, arrival.release_speed, flying).plate


def path_of(options: PathOptions) -> SwingPath:
    """Return the swing's path that the options describe."""
    from sweetspot.motion.swing_path import SwingPath
    from sweetspot.plausibility import parse

    return SwingPath(
        attack_angle=parse(options.attack_angle, "angle", "--attack-angle"),
        attack_direction=parse(options.attack_direction, "angle", "--attack-direction"),
        tilt=parse(options.tilt, "angle", "--tilt"),
        bats=options.bats,
    )


def arriving(options: ArrivalOptions, speed: float) -> BallMotion:
    """Return the pitch at the plate that the options describe."""
    import math

    from sweetspot.motion.ball_motion import launched
    from sweetspot.plausibility import check, parse

    height = parse(options.height, "length", "--height")
    check(height, "--height", options.height, quantity="launch_height")
    return launched(
        speed=speed,
        launch_angle=parse(options.approach_angle, "angle", "--approach-angle"),
        spray=math.pi,
        backspin=parse(options.pitch_backspin, "angular speed", "--pitch-backspin"),
        sidespin=parse(options.pitch_sidespin, "angular speed", "--pitch-sidespin"),
        position=(0.0, parse(options.forward, "length", "--forward"), height),
    )

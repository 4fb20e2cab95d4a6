"""`sweetspot play`: from the pitch over the bat to the fence."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Annotated, Literal

from cyclopts import Parameter

from sweetspot.cli.options.output import DEFAULT_OUTPUT, OutputOptions
from sweetspot.cli.options.reading import Uncertainty, given, read, refuse_unused
from sweetspot.cli.options.swing import DEFAULT_SWING, SwingOptions
from sweetspot.cli.options.weather import DEFAULT_AIR, AirOptions
from sweetspot.errors import InputError

if TYPE_CHECKING:
    from sweetspot.answers.flight_setups import PitchSetup


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
        str, Parameter(help="Where the ball meets the bat: 27in, 6in-from-tip±0.5in, or sweet-spot, barrel, tip.")
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
    from sweetspot.answers.ask_flight import play as asked
    from sweetspot.answers.setups import ContactSetup, Owner, PathSetup
    from sweetspot.catalog.implements import loaded_bat
    from sweetspot.cli.options.weather import setup_of
    from sweetspot.cli.output import present

    _check_arrival(arrival, swing)
    loaded, sure = loaded_bat(bat), meeting.uncertainty
    implement = loaded.implement
    answer = asked(
        loaded,
        contact=read(ContactSetup, meeting, of=Owner(implement.length, implement.sport)),
        setup=swing.setup(implement, errors=sure),
        path=read(PathSetup, path),
        arrival=_arriving(arrival),
        weather=setup_of(air),
        uncertainty=sure,
    )
    return present(answer, output)


def _arriving(arrival: ArrivalOptions) -> PitchSetup:
    from sweetspot.answers.flight_setups import PitchSetup
    from sweetspot.plausibility import check

    setup = read(PitchSetup, arrival)
    check(setup.height, "--height", arrival.height, quantity="launch_height")
    return setup


def _check_arrival(arrival: ArrivalOptions, swing: SwingOptions) -> None:
    """Refuse what belongs to another way in which the pitch arrives."""
    if arrival.pitch is not None and swing.pitch_speed is not None:
        raise InputError("--pitch and --pitch-speed were both given; say --release-speed for a named pitch")
    if arrival.pitch is None and arrival.release_speed is not None:
        raise InputError("--release-speed is of a pitch that is thrown; name it with --pitch, or give --pitch-speed")
    if arrival.pitch is not None:
        its_own = given(arrival, "approach_angle", "pitch_backspin", "pitch_sidespin", "height", "forward")
        refuse_unused(its_own, "a pitch without a name", "give --pitch-speed in place of --pitch")

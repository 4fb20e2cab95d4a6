"""The command `optimum`: how to swing, how high to send the ball, and where a park is easiest to leave."""

from __future__ import annotations

from dataclasses import dataclass, fields
from typing import Annotated, Literal

from cyclopts import Parameter

from sweetspot.cli.options.output import DEFAULT_OUTPUT, OutputOptions
from sweetspot.cli.options.reading import Uncertainty, given, read, refuse_unused
from sweetspot.cli.options.swing import StrokeOptions
from sweetspot.cli.options.weather import DEFAULT_AIR, AirOptions


@Parameter(name="*")
@dataclass(frozen=True)
class ContactOptions(StrokeOptions):
    """The bat's motion and what of the contact is not searched."""

    at: Annotated[str | None, Parameter(help="Hit with this place of the bat; default: the best one is searched.")] = (
        None
    )
    attack_angle: Annotated[str | None, Parameter(help="Swing this steeply; default: the best is searched.")] = None
    tilt: Annotated[str, Parameter(help="Of the plane of the swing; 0deg keeps the bat level.")] = "32deg"
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
    from sweetspot.answers.ask_flight import Searched
    from sweetspot.answers.ask_flight import optimum as asked
    from sweetspot.answers.flight_setups import SearchSetup, SentSetup
    from sweetspot.answers.setups import Owner
    from sweetspot.catalog.implements import loaded_bat
    from sweetspot.cli.options.weather import setup_of
    from sweetspot.cli.output import present

    _check_shown(show, pitch, contact, sent)
    searched: tuple[Searched, ...] = ("swing", "launch", "parks") if show == "all" else (show,)
    if show == "all" and air.park is None:
        searched = searched[:2]
    if output.format == "csv":
        searched = searched[:1]
    loaded = loaded_bat(bat)
    implement, ball = loaded.implement, contact.ball or catalog.sport(loaded.implement.sport).balls[0]
    answer = asked(
        loaded,
        search=read(SearchSetup, contact, pitch, of=Owner(implement.length, implement.sport)),
        sent=read(SentSetup, sent, of=Owner(sport=catalog.ball_sport(ball))),
        setup=contact.setup(implement, errors=contact.uncertainty),
        weather=setup_of(air),
        show=searched,
        uncertainty=contact.uncertainty,
    )
    return present(answer, output)


def _check_shown(show: str, pitch: PitchOptions, contact: ContactOptions, sent: SentOptions) -> None:
    """Refuse what belongs to a question that is left out."""
    if show in ("launch", "parks"):
        swung = given(contact, *(field.name for field in fields(contact) if field.name not in ("ball", "uncertainty")))
        refuse_unused([*given(pitch, "pitch", "release_speed"), *swung], "the best swing", "leave --show out")
    if show in ("swing", "parks"):
        refuse_unused(given(sent, "exit_speed"), "the best launch", "leave --show out")
    if show == "swing":
        refuse_unused(given(sent, "backspin"), "the best launch", "leave --show out")

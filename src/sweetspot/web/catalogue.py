"""The catalogue over the API: what can be chosen, and whether an uploaded bat is one."""

from __future__ import annotations

from functools import cache

from fastapi import APIRouter
from fastapi.responses import JSONResponse

from sweetspot import catalog
from sweetspot.answers.conditions import mass_properties
from sweetspot.answers.records import to_dict
from sweetspot.catalog.ballparks import field_names
from sweetspot.catalog.deliveries import delivery_names, other_delivery_names
from sweetspot.catalog.entries import terms as all_terms
from sweetspot.catalog.rules import league, league_names
from sweetspot.dynamics.beam import beam_model
from sweetspot.dynamics.rigid import rigid_body
from sweetspot.equipment.bat import Bat
from sweetspot.reports.quantity_table import quantity_data, words_in_both_systems
from sweetspot.web.bats import bat_from_text
from sweetspot.web.documents import in_both_systems, in_one_system
from sweetspot.web.errors import about
from sweetspot.web.schemas import BatFacts, BatText, Choice, Described, Meaning, Tool
from sweetspot.web.wizard import Form, Wanted, described_by, forms

USES = (
    "Youth baseball",
    "Baseball, of wood",
    "Baseball, of metal or composite",
    "Fast-pitch softball",
    "Slow-pitch softball",
    "From studies",
)
"""Headings of the list of bats, in the order in which people look for theirs."""
OF_SPORT = {"youth-baseball": USES[0], "softball": USES[3], "slow-pitch": USES[4]}
STUDIED = ("corked-r161", "russell-", "textbook", "torpedo-designed", "torpedo-twin", "uniform-rod")
"""Beginnings of the names of bats that no one buys: measured, modified or imagined in a study."""


def catalogue_routes(api: APIRouter) -> None:
    """Add the routes that list what can be chosen, and those that ask about a bat of one's own."""
    _implement_lists(api)
    _other_lists(api)
    _own_routes(api)


def _implement_lists(api: APIRouter) -> None:
    """Add the routes that list bats and other implements, balls and materials."""

    @api.get("/bats", tags=["catalogue"])
    def bats() -> list[BatFacts]:
        """Return the bats of the catalogue."""
        return list(_bats())

    @api.get("/implements", tags=["catalogue"])
    def implements() -> list[Tool]:
        """Return everything in the catalogue that one hits a ball with, sport by sport."""
        return list(_implements())

    @api.get("/balls", tags=["catalogue"])
    def balls() -> list[Choice]:
        """Return the catalogue's balls."""
        return [Choice(key=name, name=catalog.ball(name).name) for name in catalog.ball_names()]

    @api.get("/materials", tags=["catalogue"])
    def materials() -> list[str]:
        """Return the names of the catalogue's materials."""
        return catalog.material_names()


def _other_lists(api: APIRouter) -> None:
    """Add the routes that list rules, fields, pitches, quantities and words."""

    @api.get("/leagues", tags=["catalogue"])
    def leagues() -> list[Choice]:
        """Return the leagues whose rules for round bats are known."""
        every = [league(name) for name in league_names()]
        blades = "cricket bat"
        return [
            Choice(key=book.key, name=book.name)
            for book in every
            if {rule.construction for rule in book.rules} != {blades}
        ]

    @api.get("/parks", tags=["catalogue"])
    def parks() -> list[Choice]:
        """Return the ball parks of the catalogue, then the fields of youth and softball."""
        return [Choice(key=name, name=catalog.park(name).name) for name in (*catalog.park_names(), *field_names())]

    @api.get("/quantities", tags=["catalogue"])
    def quantities() -> JSONResponse:
        """Return the display of numbers: scales and endings of names in both systems, labels and colours."""
        return JSONResponse(quantity_data())

    @api.get("/pitches", tags=["catalogue"])
    def pitches() -> list[Choice]:
        """Return the kinds of pitches of the catalogue."""
        names = (*delivery_names(), *other_delivery_names())
        return [Choice(key=name, name=catalog.delivery(name).name) for name in names]

    @api.get("/terms", tags=["catalogue"])
    def terms() -> list[Meaning]:
        """Return the meanings of the words on the page, each with its source."""
        return [
            Meaning(names=list(term.names), words=words_in_both_systems(term.words), source=term.cited)
            for term in all_terms()
        ]


def _own_routes(api: APIRouter) -> None:
    """Add the routes that ask about an implement of one's own."""

    @api.get("/questions", tags=["catalogue"])
    def questions() -> list[Form]:
        """Return the questions about a bat, racket, club or stick of one's own, sport by sport."""
        return list(forms())

    @api.post("/describe", tags=["catalogue"])
    def describe(wanted: Wanted) -> Described:
        """Return the file of a bat, racket, club or stick from a few answers, or which answer cannot be."""
        toml, changes, assumed = described_by(wanted)
        return Described(toml=toml, told=in_one_system(changes), assumed=in_both_systems(assumed))

    @api.post("/bat", tags=["catalogue"])
    def bat(text: BatText) -> BatFacts:
        """Return the facts of a bat written as TOML, or what is wrong with it."""
        with about("toml"):
            bat = bat_from_text(text.toml)
            return _facts(bat.name, bat)


def load_lists() -> None:
    """Read what the longest lists are made of, before anyone asks."""
    _bats()
    _implements()


@cache
def _bats() -> tuple[BatFacts, ...]:
    every = (_facts(name, catalog.bat(name)) for name in catalog.bat_names())
    return tuple(sorted(every, key=lambda bat: USES.index(bat.use)))


@cache
def _implements() -> tuple[Tool, ...]:
    tools = ((key, catalog.implement(key)) for key in catalog.implement_names())
    listed = (Tool(key=key, name=tool.name, sport=catalog.sport(tool.sport).name) for key, tool in tools)
    return tuple(sorted(listed, key=lambda tool: (tool.sport, tool.name.casefold())))


def _facts(key: str, bat: Bat) -> BatFacts:
    facts = to_dict(mass_properties(bat, rigid_body(beam_model(bat))))
    return BatFacts(key=key, hollow=bat.shell is not None, sport=bat.sport, use=_use(key, bat), **facts)


def _use(key: str, bat: Bat) -> str:
    """Return the heading under which people look for a bat."""
    if key.startswith(STUDIED):
        return USES[5]
    return OF_SPORT.get(bat.sport, USES[1] if bat.shell is None else USES[2])

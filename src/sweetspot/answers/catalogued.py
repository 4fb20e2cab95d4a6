"""What the catalogue holds of ball parks and of sports."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Annotated

from sweetspot import catalog
from sweetspot.answers.answer import Answer
from sweetspot.answers.records import INTERNAL, Distance, Speed
from sweetspot.catalog.ballparks import field_names
from sweetspot.catalog.sports import certainty, sport, sport_implements, sport_names
from sweetspot.equipment.sport import Fact, Sport
from sweetspot.flight.park import Park
from sweetspot.papers.formulas import PaperRow
from sweetspot.papers.sports import sport_rows
from sweetspot.units.dimensions import ANGLE

NAMED_DIRECTIONS = {
    "left_field": -45.0,
    "left_center": -22.5,
    "center_field": 0.0,
    "right_center": 22.5,
    "right_field": 45.0,
}
"""Degrees from centre field."""


@dataclass(frozen=True, kw_only=True)
class ParkFacts:
    """A park: its elevation, and how far away and how high its fence is in the directions that people name.

    ``key`` is its name in the catalogue, where several are listed.
    """

    key: str | None = None
    name: str
    team: str
    city: str
    elevation: Distance
    roof: str
    left_field: Distance
    left_center: Distance
    center_field: Distance
    right_center: Distance
    right_field: Distance
    lowest_fence: Distance
    highest_fence: Distance

    @property
    def distances(self) -> tuple[float, ...]:
        """Distances of the fence from left field to right field, m."""
        return tuple(float(getattr(self, name)) for name in NAMED_DIRECTIONS)


@dataclass(frozen=True)
class FenceCorner:
    """A corner of a fence: direction from centre field, distance from home plate, and height."""

    direction: Annotated[float, ANGLE]
    distance: Distance
    height: Distance


@dataclass(frozen=True, kw_only=True)
class ParkAnswer(ParkFacts, Answer):
    """One park with its fence all the way round."""

    fence: tuple[FenceCorner, ...]
    park: Annotated[Park, INTERNAL]


@dataclass(frozen=True, kw_only=True)
class ParksAnswer(Answer):
    """Every Major League park; ``fields`` are those of other leagues, with usual distances."""

    parks: tuple[ParkFacts, ...]
    fields: Annotated[tuple[ParkFacts, ...], INTERNAL]


def park_answer(name: str) -> ParkAnswer:
    """Return a park by its name, an old name of it, or its team."""
    park = catalog.park(name)
    corners = tuple(FenceCorner(*corner) for corner in park.fence)
    return ParkAnswer(**vars(_park_facts(park)), fence=corners, park=park)


def parks_answer() -> ParksAnswer:
    """Return every park of the catalogue."""
    return ParksAnswer(parks=_listed(catalog.park_names()), fields=_listed(field_names()))


def _listed(names: Sequence[str]) -> tuple[ParkFacts, ...]:
    return tuple(_park_facts(catalog.park(name), name) for name in names)


def _park_facts(park: Park, key: str | None = None) -> ParkFacts:
    heights = [height for _, _, height in park.fence]
    return ParkFacts(
        key=key,
        name=park.name,
        team=park.team,
        city=park.city,
        elevation=park.elevation,
        roof=park.roof,
        **{name: park.distance_at(math.radians(angle)) for name, angle in NAMED_DIRECTIONS.items()},
        lowest_fence=min(heights),
        highest_fence=max(heights),
    )


@dataclass(frozen=True, kw_only=True)
class SportSummary:
    """A sport: its balls and implements, its usual stroke, and how many of its numbers rest on what."""

    key: str
    name: str
    balls: tuple[str, ...]
    implements: tuple[str, ...]
    swing_speed: Speed
    swing_speed_kind: str
    ball_speed: Speed
    ball_speed_kind: str
    measured: int
    specified: int
    derived: int
    fitted: int
    assumed: int


@dataclass(frozen=True)
class SportNumber:
    """A number of a sport in its unit, as its source writes it, and what it rests on."""

    name: str
    value: float
    unit: str
    written: str
    kind: str
    source: str
    where: str


@dataclass(frozen=True, kw_only=True)
class SportAnswer(SportSummary, Answer):
    """Everything about one sport; ``formulas`` are the paper's with its numbers."""

    words: Mapping[str, str]
    numbers: tuple[SportNumber, ...]
    formulas: tuple[PaperRow, ...]
    terms: Mapping[str, str]
    not_covered: tuple[str, ...]
    sport: Annotated[Sport, INTERNAL]


@dataclass(frozen=True, kw_only=True)
class SportsAnswer(Answer):
    """All sports in short."""

    sports: tuple[SportSummary, ...]


def sports_answer() -> SportsAnswer:
    """Return all sports of the catalogue in short."""
    return SportsAnswer(sports=tuple(_summary(sport(name)) for name in sport_names()))


def sport_answer(name: str) -> SportAnswer:
    """Return everything about one sport of the catalogue."""
    described = sport(name)
    return SportAnswer(
        **vars(_summary(described)),
        words=described.words.model_dump(),
        numbers=_numbers(described.numbers()),
        formulas=tuple(sport_rows(described)),
        terms=dict(described.terms),
        not_covered=tuple(described.not_covered),
        sport=described,
    )


def _summary(described: Sport) -> SportSummary:
    stroke, counts = described.stroke, certainty(described.key)
    return SportSummary(
        key=described.key,
        name=described.name,
        balls=tuple(described.balls),
        implements=sport_implements(described.key),
        swing_speed=stroke.swing_speed.value,
        swing_speed_kind=stroke.swing_speed.kind,
        ball_speed=stroke.ball_speed.value,
        ball_speed_kind=stroke.ball_speed.kind,
        **{str(kind): count for kind, count in counts.items()},
    )


def _numbers(facts: Sequence[Fact]) -> tuple[SportNumber, ...]:
    return tuple(
        SportNumber(fact.name, fact.value, fact.unit, fact.written, fact.kind, fact.source, fact.where)
        for fact in facts
    )

"""Design: its controls, from them to the bench on which every bat is measured, and the search for better ones."""

from __future__ import annotations

import hashlib
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from functools import lru_cache
from typing import Annotated, Literal

import numpy as np
from pydantic import Field

from sweetspot.analysis.certification.rules import League
from sweetspot.catalog.rules import league, usual_league
from sweetspot.catalog.swing_laws import swing_law
from sweetspot.designs.batter import Batter, normal_contact
from sweetspot.designs.constraints import AS_IT_IS, Limit, kept_limits, nearest_within_limits
from sweetspot.designs.gain import present_measured
from sweetspot.designs.local_search import design_front
from sweetspot.designs.measures import Bench, MeasuredDesigns, bench_of
from sweetspot.designs.pareto import DesignSearch, Front, Generation
from sweetspot.designs.spaces import space_of
from sweetspot.designs.turned import TurnedSpace
from sweetspot.designs.variables import Space
from sweetspot.equipment.bat import Bat
from sweetspot.numerics.arrays import Array
from sweetspot.units import INCH, MPH
from sweetspot.web.bats import conditions_of, described
from sweetspot.web.controls import Name, SwungState
from sweetspot.web.drawings import DrawnOutline
from sweetspot.web.errors import about
from sweetspot.web.jobs import Say

LONGEST_TABLE = 40_000
"""Letters of a table of swings, or of an answer of fit-player."""
USUAL_LEAGUE, NO_LEAGUE = "usual", "none"
Want = Literal["exit_speed", "zone", "best", "sting", "swing_time", "durability"]
LOCKS = {
    "keep_mass": "mass",
    "keep_moi": "moi",
    "keep_wood": "density",
    "keep_balance": "balance_point",
    "keep_grip": "handle",
}
"""Fields that lock, and what they lock."""


class DesignState(SwungState):
    """The batter's present bat and swing, where the ball is met, the bat that is being shaped, and what must stay."""

    contact_in: float = Field(6.5, gt=0.5, le=13, description="where the ball is met on average, from the tip")
    contact_spread_in: float = Field(1.8, ge=0.2, le=6, description="standard deviation of that")
    contact_doubt_in: float = Field(0.5, ge=0, le=4, description="how well the mean is known")
    miss_in: float = Field(0.2, ge=-2, le=2, description="ball's centre above the bat's axis on average")
    miss_spread_in: float = Field(1.1, ge=0.1, le=3.5, description="standard deviation of that")
    swing_law: Literal["baseball", "none"] = Field("baseball", description="how bat speed depends on the bat")
    design_si: Annotated[tuple[float, ...], Field(min_length=1, max_length=30)] | None = Field(
        None, description="the bat's numbers, in the order of the answer's variables, SI; empty: the present bat's"
    )
    design_for: Annotated[str, Field(max_length=40)] | None = Field(
        None, description="the answer's key of the present bat that design_si belongs to; empty: whatever bat it is"
    )
    pulled: Annotated[int, Field(ge=0, le=29)] | None = Field(None, description="which number is held by hand")
    keep_mass: bool = Field(True, description="the weight stays within 1 %")
    keep_moi: bool = Field(True, description="the moment of inertia about 6 in stays within 1 %")
    keep_wood: bool = Field(True, description="the density of a wooden bat's wood stays within 1 %")
    keep_balance: bool = Field(False, description="the balance point stays within 1 %")
    keep_grip: bool = Field(False, description="the smallest diameter of the grip stays")
    deepest_cup_in: float = Field(1.0, ge=0, le=1.25, description="of a wooden bat")
    league: Name = Field(USUAL_LEAGUE, description="whose rules hold: a league, usual for the bat, or none")
    want: Want = Field("exit_speed", description="what is to be better first")
    also_want: Want = Field("zone", description="and what besides; the same: nothing else")
    generations: int = Field(30, ge=1, le=400, description="how long is searched")
    seed: int = Field(1, ge=0, le=2**31 - 1, description="of the random numbers")
    swings_csv: Annotated[str, Field(max_length=LONGEST_TABLE)] | None = Field(
        None, description="a table of swings or an answer of fit-player, to read the batter from"
    )
    swings_of: Annotated[str, Field(min_length=1, max_length=80)] | None = Field(
        None, description="which batter of that table"
    )


_OF_BENCH = (
    *SwungState.model_fields,
    "contact_in",
    "contact_spread_in",
    "contact_doubt_in",
    "miss_in",
    "miss_spread_in",
    "swing_law",
    "deepest_cup_in",
)
_FIRST = DesignState()


@dataclass(frozen=True)
class ShapedBat:
    """A bench with the present bat on it, and the bat that is being shaped.

    Parameters
    ----------
    key : of the present bat.
    now : the present bat, measured.
    sizes : what the outline by handles says of it, by measure.
    left_out : what of the present bat the design does not have, in words.
    """

    bench: Bench
    key: str
    now: MeasuredDesigns
    sizes: Mapping[str, Array]
    left_out: tuple[str, ...]


def asked(state: DesignState) -> ShapedBat:
    """Return the bench of a state; only another bat, swing or batter makes it anew."""
    bench = {name: getattr(state, name) for name in _OF_BENCH}
    return _asked(_FIRST.model_copy(update=bench), "durability" in (state.want, state.also_want))


@lru_cache(maxsize=64)
def _asked(state: DesignState, durable: bool) -> ShapedBat:
    bat, left_out = _plain(described(state))
    conditions = conditions_of(state, bat)
    with about("bat"):
        space, sizes = _space(bat, state.deepest_cup_in * INCH)
    with about("contact_in"):
        weight = normal_contact(state.contact_in * INCH, state.contact_spread_in * INCH)
    batter = Batter(
        weight=weight,
        offset=state.miss_in * INCH,
        offset_spread=state.miss_spread_in * INCH,
        bat_speed=conditions.swing.bat_speed,
        pitch_speed=conditions.pitch.speed,
        law=None if state.swing_law == "none" else swing_law(state.swing_law),
        doubt=state.contact_doubt_in * INCH,
        speed_from_tip=bat.length - conditions.swing.measured_at,
    )
    with about("bat"):
        bench = bench_of(space, batter, conditions, durable=durable)
    key = hashlib.blake2b(bat.model_dump_json().encode(), digest_size=9).hexdigest()
    return ShapedBat(bench, key, present_measured(bench), sizes, left_out)


@lru_cache(maxsize=32)
def _space(bat: Bat, deepest_cup: float) -> tuple[Space, Mapping[str, Array]]:
    """Return the design space of a bat, and the sizes of the outline that it begins with."""
    space = space_of(bat, deepest_cup=deepest_cup)
    return space, space.shapes(space.start[None])


def _plain(bat: Bat) -> tuple[Bat, tuple[str, ...]]:
    """Return a bat without what no design has, and what that was."""
    if not bat.bores:
        return bat, ()
    return bat.replaced(bores=(), mass=None, balance_point=None, moi=None, original=None), (
        "The hole in the barrel is left out: a design is one piece.",
    )


def limits_of(state: DesignState) -> tuple[Limit, ...]:
    """Return every limit of the search."""
    return _limits(
        _FIRST.model_copy(
            update={name: getattr(state, name) for name in (*_OF_BENCH, *LOCKS, "league", "want", "also_want")}
        )
    )


@lru_cache(maxsize=64)
def _limits(state: DesignState) -> tuple[Limit, ...]:
    request = asked(state)
    locks = [measure for field, measure in LOCKS.items() if getattr(state, field)]
    return kept_limits(request.bench, locks, league=league_of(state, request), now=request.now)


def locks_of(state: DesignState) -> tuple[Limit, ...]:
    """Return the limits that hold while a hand pulls."""
    locks = {measure for field, measure in LOCKS.items() if getattr(state, field)}
    return tuple(limit for limit in limits_of(state) if limit.measure in locks and limit.why == AS_IT_IS)


def numbers_of(state: DesignState, request: ShapedBat) -> tuple[Array, bool]:
    """Return the numbers of the bat that is being shaped, and whether those of the state belong to it."""
    space = request.bench.space
    shaped = state.design_si is not None and len(state.design_si) == len(space.variables)
    shaped = shaped and state.design_for in (None, request.key)
    low, high = (np.array([getattr(variable, end) for variable in space.variables]) for end in ("low", "high"))
    numbers = np.clip(np.array(state.design_si), low, high) if shaped else space.start
    locks = locks_of(state)
    return (
        nearest_within_limits(request.bench, numbers, locks, pulled=state.pulled) if shaped and locks else numbers
    ), shaped


def league_of(state: DesignState, request: ShapedBat) -> League | None:
    """Return the league whose rules hold; None: no league's."""
    if state.league == NO_LEAGUE:
        return None
    chosen = usual_league(request.bench.space.present) if state.league == USUAL_LEAGUE else state.league
    with about("league"):
        return None if chosen is None else league(chosen)


def question_of(state: DesignState) -> DesignSearch:
    """Return the design search of a state."""
    wants = tuple(dict.fromkeys((state.want, state.also_want)))
    return DesignSearch(wants, limits_of(state), seed=state.seed, generations=state.generations)


@dataclass(frozen=True)
class BatterControls:
    """A batter as fields of a state; what is not known is left out."""

    contact_in: float | None = None
    contact_spread_in: float | None = None
    contact_doubt_in: float | None = None
    miss_in: float | None = None
    miss_spread_in: float | None = None
    bat_speed_mph: float | None = None
    pitch_speed_mph: float | None = None


def batter_controls(values: Mapping[str, float]) -> BatterControls:
    """Return a batter's fields from parameters in m and m/s by the names of a player's parameters."""
    names = ("position", "position_spread", "position_doubt", "offset", "offset_spread", "bat_speed", "pitch_speed")
    sizes = (INCH, INCH, INCH, INCH, INCH, MPH, MPH)
    return BatterControls(
        *(round(values[name] / size, 2) if name in values else None for name, size in zip(names, sizes, strict=True))
    )


MEASURED = [
    "exit_speed",
    "best",
    "best_from_tip",
    "zone",
    "sting",
    "swing_time",
    "durability",
    "mass",
    "moi",
    "diameter",
]
"""What is said of every bat of a front."""


@dataclass(frozen=True)
class FrontBat:
    """One bat of a front: its numbers and measures, SI, and its outline where outlines differ."""

    numbers: tuple[float, ...]
    values: Mapping[str, float]
    outline: DrawnOutline | None = None


@dataclass(frozen=True)
class FrontProgress:
    """The front after a generation, and the present bat, whose ``key`` is that of the answer."""

    key: str
    generation: int
    generations: int
    wants: tuple[str, ...]
    front: tuple[FrontBat, ...] = ()
    present: Mapping[str, float] = field(default_factory=dict)


def search(state: DesignState, *, after: Generation | None, say: Say) -> FrontProgress:
    """Look for better bats: begins a search whose front the page sees growing."""
    task = asked(state)
    question = question_of(state)
    begun = 0 if after is None else after.number
    if after is not None and begun >= question.generations:  # asked to go on beyond its end
        question = replace(question, generations=min(2000, begun + state.generations))
    nothing = FrontProgress(task.key, begun, question.generations, question.wants)
    present = {name: float(task.now.values[name][0]) for name in question.wants}

    def progress_at(generation: int, front: Front) -> FrontProgress:
        return replace(nothing, generation=generation, front=_bats(task.bench, front), present=present)

    def grown(generation: int, front: Front) -> None:
        say(progress_at(generation, front), front.last if generation else None)

    say(nothing, after)
    front = design_front(task.bench, question, after=after, progress=grown)
    return progress_at(front.generation, front)


def _bats(bench: Bench, front: Front) -> tuple[FrontBat, ...]:
    values = {name: front.measured.values[name] for name in MEASURED if name in front.measured.values}
    numbers = np.asarray(front.numbers)
    outlines: list[DrawnOutline | None] = [None] * len(numbers)
    if isinstance(bench.space, TurnedSpace):
        shapes = bench.space.outlines(numbers)
        outlines = list(map(DrawnOutline, shapes.position, shapes.diameter))
    return tuple(
        FrontBat(tuple(row), {name: float(column[index]) for name, column in values.items()}, outline)
        for index, (row, outline) in enumerate(zip(numbers.tolist(), outlines, strict=True))
    )

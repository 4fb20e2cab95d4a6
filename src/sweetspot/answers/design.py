"""A bat shaped for a batter: the best in each want, the front between them, one bat picked, and what it gains."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Annotated

import numpy as np

from sweetspot.answers.answer import Answer, Progress
from sweetspot.answers.certify import RuleCheck, rule_check
from sweetspot.answers.design_question import Designed, DesignQuestion, all_searched, designed_bat
from sweetspot.answers.records import INLINE, INTERNAL, Length, Speed, Time, to_dict
from sweetspot.designs.batter import FROM_TIP
from sweetspot.designs.constraints import Limit
from sweetspot.designs.gain import Gain, GainVerdict, HandleBending
from sweetspot.designs.local_search import best_of, best_value
from sweetspot.designs.measures import MeasuredDesigns
from sweetspot.designs.pareto import Front
from sweetspot.numerics.arrays import Array, IntArray
from sweetspot.numerics.interval import Curve, Interval, Number
from sweetspot.units.dimensions import CURVATURE, FREQUENCY, LENGTH, MASS, MOI, RATIO, SPEED, TIME, VIBRATION, System

if TYPE_CHECKING:
    import polars

Measurement = Number | Curve | None
"""Of one bat, of many, or not measured."""


@dataclass(frozen=True, kw_only=True)
class DesignMeasures:
    """What is measured on bats; see `sweetspot.designs.measures.MEASURES`. None: not measured."""

    length: Annotated[Measurement, LENGTH] = None
    diameter: Annotated[Measurement, LENGTH] = None
    handle: Annotated[Measurement, LENGTH] = None
    cup_depth: Annotated[Measurement, LENGTH] = None
    cup_diameter: Annotated[Measurement, LENGTH] = None
    knob: Annotated[Measurement, LENGTH] = None
    blade_width: Annotated[Measurement, LENGTH] = None
    blade_depth: Annotated[Measurement, LENGTH] = None
    blade_edge: Annotated[Measurement, LENGTH] = None
    slope: Annotated[Measurement, RATIO] = None
    bend: Annotated[Measurement, CURVATURE] = None
    waist: Annotated[Measurement, LENGTH] = None
    density: Annotated[Measurement, RATIO] = None
    exit_speed: Annotated[Measurement, SPEED] = None
    best: Annotated[Measurement, SPEED] = None
    best_from_tip: Annotated[Measurement, LENGTH] = None
    zone: Annotated[Measurement, LENGTH] = None
    sting: Annotated[Measurement, VIBRATION] = None
    bat_speed: Annotated[Measurement, SPEED] = None
    swing_time: Annotated[Measurement, TIME] = None
    mass: Annotated[Measurement, MASS] = None
    balance_point: Annotated[Measurement, LENGTH] = None
    moi: Annotated[Measurement, MOI] = None
    bbcor: Annotated[Measurement, RATIO] = None
    bpf: Annotated[Measurement, RATIO] = None
    durability: Annotated[Measurement, RATIO] = None
    drop: Annotated[Measurement, RATIO] = None
    frequency: Annotated[Measurement, FREQUENCY] = None


@dataclass(frozen=True)
class DesignVariable:
    """A number that may be changed, SI: of the design and of the present bat, and its range."""

    value: float
    present: float
    low: float
    high: float


@dataclass(frozen=True)
class MaterialBest:
    """The best of a material's front in every want; none: no bat of it keeps every limit."""

    name: str
    best: Annotated[DesignMeasures, INLINE]


@dataclass(frozen=True, kw_only=True)
class DesignGain:
    """What a design gains over the present bat in the batter's hands; see `sweetspot.designs.gain.Gain`.

    ``half_interval``: of ``expected_exit_speed``, of which the next six are standard deviations. ``balls``,
    ``balls_needed``: that tell of the contacts, and from how many the gain would be seen; None: no number.
    ``present_is_better_within_from_tip``: nearer the tip the present bat is better; None: nowhere.
    """

    shift_towards_hands: Length
    zone_wider: Length
    greatest_exit_speed: Speed
    expected_exit_speed: Speed
    half_interval: Speed
    verdict: str
    probability: float
    seen: bool
    between_two_of_a_dozen: Speed
    from_wood: Speed
    from_wood_chosen_by_weight: Speed
    from_swing: Speed
    from_contact: Speed
    from_few_balls: Speed
    balls: float
    balls_needed: int | None
    time_to_contact: Time
    present_is_better_within_from_tip: Length | None


@dataclass(frozen=True)
class GainCurve:
    """Change of the exit speed by place, and its standard deviation from two pieces of wood, arrays of shape (n,)."""

    from_tip: Annotated[Array, LENGTH]
    exit_speed: Annotated[Array, SPEED]
    wood: Annotated[Array, SPEED]


@dataclass(frozen=True, kw_only=True)
class DesignFront:
    """The bats of the front: number, measures and variables, the last in SI; arrays of one shape (n,)."""

    bat: IntArray
    measures: Annotated[DesignMeasures, INLINE]
    variables: Annotated[Mapping[str, Array], INLINE]


@dataclass(frozen=True)
class BentHandle:
    """The greatest bending strain of a handle, the place of the ball that caused it, and the material's limit."""

    strain: float
    from_tip: Length
    linear_limit: float | None


@dataclass(frozen=True)
class BentHandles:
    """How far the handles of the present bat and of the design are bent."""

    present: BentHandle
    design: BentHandle


@dataclass(frozen=True, kw_only=True)
class DesignAnswer(Answer):
    """A bat shaped for a batter; places from the tip where their names say so.

    Parameters
    ----------
    bat, present : names of the design and of the present bat.
    generations : how many were looked at.
    picked : which bat of the front this is, from 1.
    materials : that were looked at, where there were several.
    difference : of the exit speed by place.
    rules : the league's, held against the design.
    """

    designed: Annotated[Designed, INTERNAL]
    bat: str
    present: str
    wants: tuple[str, ...]
    limits: tuple[Limit, ...]
    seed: int
    generations: int
    picked: int
    variables: Mapping[str, DesignVariable]
    materials: tuple[MaterialBest, ...]
    measures: DesignMeasures
    present_measures: DesignMeasures
    gain: DesignGain
    difference: GainCurve
    front: DesignFront
    handle_bending: BentHandles | None
    rules: tuple[RuleCheck, ...]

    @property
    def complete(self) -> bool:
        """Whether the search ran to its end."""
        return self.generations >= self.designed.question.generations

    def to_frame(self, units: System = "si") -> polars.DataFrame:
        """Return a frame of a row for every bat of the front, the best in the first want first."""
        import polars

        return polars.DataFrame(to_dict(self.front, units))


def design_answer(
    question: DesignQuestion,
    *,
    progress: Progress | None = None,
    first: Callable[[Designed], None] | None = None,
) -> DesignAnswer:
    """Return a bat shaped for a batter, and the front that it was picked from; Ctrl-C ends the search earlier.

    ``progress``: called with the progress of the search. ``first``: called as soon as the best bat in the first want is
    there, seconds after the beginning, with that bat alone, before any rule or bent handle is looked at.

    Raises
    ------
    InputError
        for limits that exclude each other, an implement of which nothing can be changed, or a bat that the front has
        not.
    """
    every = all_searched(question, progress, first)
    best = [(bench, search, front) for bench, search, front in every if front is not None]
    bench, search, front = best[best_of([front for _, _, front in best], question.wants[0])]
    materials = [
        MaterialBest(material.name, _best(front, question.wants))
        for material, (_, _, front) in zip(question.materials, every, strict=False)
    ]
    design = designed_bat(bench, search, front, pick=question.pick, league=question.league)
    return answer_of(design, tuple(materials) if len(materials) > 1 else ())


def _best(front: Front | None, wants: Sequence[str]) -> DesignMeasures:
    return DesignMeasures(**({} if front is None else {want: best_value(front, want) for want in wants}))


def answer_of(design: Designed, materials: tuple[MaterialBest, ...] = ()) -> DesignAnswer:
    """Return the answer whose design is there already."""
    space, front, league = design.bench.space, design.front, design.league
    return DesignAnswer(
        designed=design,
        bat=design.bat.name,
        present=space.present.name,
        wants=design.question.wants,
        limits=design.question.limits,
        seed=design.question.seed,
        generations=front.generation,
        picked=design.picked + 1,
        variables={
            variable.name: DesignVariable(value, variable.start, variable.low, variable.high)
            for variable, value in zip(space.variables, design.numbers.tolist(), strict=True)
        },
        materials=materials,
        measures=_measures(front.measured, design.picked),
        present_measures=_measures(design.now, 0),
        gain=_gain(design.gain),
        difference=GainCurve(FROM_TIP, design.gain.curve, design.gain.noise),
        front=DesignFront(
            bat=np.arange(1, len(front) + 1),
            measures=DesignMeasures(**front.measured.values),
            variables={each.name: front.numbers[:, index] for index, each in enumerate(space.variables)},
        ),
        handle_bending=None if design.bent is None else BentHandles(*map(_bent_handle, design.bent)),
        rules=() if league is None else tuple(rule_check(league, check) for check in design.checks),
    )


def _measures(measured: MeasuredDesigns, row: int) -> DesignMeasures:
    return DesignMeasures(**{name: float(values[row]) for name, values in measured.values.items()})


def _bent_handle(bending: HandleBending) -> BentHandle:
    return BentHandle(bending.strain, bending.from_tip, bending.limit)


def _gain(gain: Gain) -> DesignGain:
    return DesignGain(
        shift_towards_hands=gain.shift,
        zone_wider=gain.wider,
        greatest_exit_speed=gain.greatest,
        expected_exit_speed=Interval(gain.expected, gain.expected - gain.doubt, gain.expected + gain.doubt),
        half_interval=gain.doubt,
        verdict=gain.verdict.value,
        probability=gain.odds,
        seen=gain.verdict is GainVerdict.SEEN,
        between_two_of_a_dozen=gain.pieces,
        from_wood=gain.wood,
        from_wood_chosen_by_weight=gain.by_weight,
        from_swing=gain.law,
        from_contact=gain.contact,
        from_few_balls=gain.sample,
        balls=gain.balls,
        balls_needed=gain.balls_needed,
        time_to_contact=gain.time,
        present_is_better_within_from_tip=gain.turning_place,
    )

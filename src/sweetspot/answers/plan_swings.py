"""The next experiment with a player: which bats, how many swings, in which order; and when to stop."""

from __future__ import annotations

from dataclasses import dataclass, replace
from pathlib import Path
from typing import Annotated, Literal

from sweetspot import catalog
from sweetspot.answers.answer import Answer
from sweetspot.answers.player_question import FitPlayerQuestion, player_posterior, read_player
from sweetspot.answers.records import INTERNAL, NESTED, OF_RECORD, Mass, MomentOfInertia
from sweetspot.dynamics.beam import beam_model
from sweetspot.dynamics.rigid import rigid_body
from sweetspot.equipment.bat import Bat
from sweetspot.errors import InputError
from sweetspot.numerics.constants import STANDARD_AXIS
from sweetspot.numerics.interval import Interval, Number
from sweetspot.player.planning import Aim, SwingPlan, SwingScatter, swing_plan
from sweetspot.player.posterior import PlayerPosterior
from sweetspot.units.dimensions import LENGTH, RATIO, Dimension

BATCH = 20
"""Swings after which it is asked whether to stop. Our choice: two blocks with each of two bats."""
Verdict = Literal["swing", "known", "too many", "stop", "go on"]


@dataclass(frozen=True, kw_only=True)
class PlanSwingsQuestion:
    """An experiment with a player.

    Parameters
    ----------
    bats : at hand, the player's own first.
    aim : what is to be found.
    within : half the width of the 90 % interval wanted, of the exponent or in m.
    bat_speed, bat_speed_spread, position_spread : what is thought of the player, SI; None: what is usual.
    lead : whether lead tape may go on the player's own bat.
    filled : sheet with the swings made so far; None: there are none.
    pitch_speed : m/s at the plate, for rows of the sheet without one; 0: a tee.
    batch : swings after which it is asked whether to stop.
    """

    bats: tuple[Bat, ...]
    aim: Aim
    within: float
    bat_speed: float | None = None
    bat_speed_spread: float | None = None
    position_spread: float | None = None
    lead: bool = True
    filled: Path | None = None
    pitch_speed: float | None = None
    batch: int = BATCH

    @property
    def scatter(self) -> SwingScatter:
        """What is thought of the player before the swings."""
        names = ("bat_speed", "bat_speed_spread", "position_spread")
        given = {name: value for name in names if (value := getattr(self, name)) is not None}
        return replace(SwingScatter.usual(), **given)


@dataclass(frozen=True)
class PlannedBat:
    """A bat to swing, and how often."""

    name: str
    swings: int
    mass: Mass
    moi_6in: MomentOfInertia


@dataclass(frozen=True, kw_only=True)
class PlanSwingsAnswer(Answer):
    """An experiment with a player, and how far it has come.

    Parameters
    ----------
    aim : what is to be found: "exponent" or "position".
    verdict : "swing" the plan; "known" without any; "too many" swings are needed; "stop" or "go on" after those made.
    within, expected_error : half the width of the 90 % interval wanted, and expected after the plan.
    bats : to swing.
    order : the bat of every swing of the plan, or of the next batch.
    swings_made : that the sheet holds.
    further : swings that are still expected to be needed, or the most that are planned.
    estimate : what the swings made say; None: none were made.
    """

    question: Annotated[PlanSwingsQuestion, INTERNAL]
    aim: Aim
    verdict: Verdict
    within: Annotated[float, OF_RECORD]
    expected_error: Annotated[float, OF_RECORD]
    bats: tuple[PlannedBat, ...]
    order: tuple[str, ...]
    swings_made: int
    further: int
    estimate: Annotated[Number | None, OF_RECORD, NESTED]

    @property
    def dimension(self) -> Dimension:
        """Of what is to be found."""
        return RATIO if self.aim == "exponent" else LENGTH


def plan_swings_answer(question: PlanSwingsQuestion) -> PlanSwingsAnswer:
    """Return the swings to make; with a filled sheet whether to stop, and else the next batch.

    Raises
    ------
    InputError
        for bats or errors that no plan can be made with, or a sheet that cannot be read.
    """
    if not question.bats:
        raise InputError("no bat was given; give the player's own first")
    if question.batch < 1:
        raise InputError(f"batch was given as {question.batch}; allowed is a whole number from 1 up")
    law = catalog.swing_law(catalog.sport(question.bats[0].sport).swing_law)
    plan = swing_plan(
        question.bats,
        aim=question.aim,
        within=question.within,
        law=law,
        scatter=question.scatter,
        lead=question.lead,
    )
    if question.filled is None:
        verdict: Verdict = "known" if plan.each == 0 else "swing" if plan.enough else "too many"
        order = plan.order if plan.enough else ()
        return _answer(question, plan, verdict, order, made=0, further=len(plan.order), estimate=None)
    posterior = fitted_sheet(question, plan)
    found = posterior.learned[question.aim].interval
    further = len(plan.bats) * after(plan, posterior, question.within).further(found.half_width, question.within)
    made = len(posterior.model.swings)
    batch = plan.order_of(min(question.batch, further))
    return _answer(question, plan, "go on" if further else "stop", batch, made=made, further=further, estimate=found)


def after(plan: SwingPlan, posterior: PlayerPosterior, within: float) -> SwingPlan:
    """Return a plan for the same bats and the scatter that a player's swings have shown."""
    seen = SwingScatter(
        *(posterior.learned[name].interval.value for name in ("bat_speed", "bat_speed_spread", "position_spread"))
    )
    return swing_plan(plan.bats, aim=plan.aim, within=within, law=posterior.model.law, scatter=seen, lead=False)


def fitted_sheet(question: PlanSwingsQuestion, plan: SwingPlan) -> PlayerPosterior:
    """Return the fit to the swings of a filled sheet, whose bats are those of the plan by name."""
    assert question.filled is not None
    swings = read_player(
        FitPlayerQuestion(
            question.filled,
            bat=plan.bats[0],
            named_bats={bat.name: bat for bat in plan.bats},
            pitch_speed=question.pitch_speed,
        )
    )
    return player_posterior(swings)


def _answer(
    question: PlanSwingsQuestion,
    plan: SwingPlan,
    verdict: Verdict,
    order: tuple[Bat, ...],
    *,
    made: int,
    further: int,
    estimate: Interval | None,
) -> PlanSwingsAnswer:
    bodies = [(bat, rigid_body(beam_model(bat))) for bat in plan.bats]
    return PlanSwingsAnswer(
        question=question,
        aim=plan.aim,
        verdict=verdict,
        within=question.within,
        expected_error=plan.expected_error,
        bats=tuple(
            PlannedBat(bat.name, order.count(bat), body.mass, body.moi(bat.choke + STANDARD_AXIS))
            for bat, body in bodies
        ),
        order=tuple(bat.name for bat in order),
        swings_made=made,
        further=further,
        estimate=estimate,
    )

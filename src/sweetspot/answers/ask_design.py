"""A bat shaped for a batter as a plain function: what is wanted in, a typed answer out."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from sweetspot import catalog
from sweetspot.answers.batter import BatterSetup
from sweetspot.answers.setups import AS_USUAL, HitSetup
from sweetspot.catalog.implements import Loaded
from sweetspot.designs.pareto import GENERATIONS, POPULATION
from sweetspot.units import INCH

if TYPE_CHECKING:
    from sweetspot.answers.design import DesignAnswer

USUAL_BATTER = BatterSetup()


@dataclass(frozen=True, kw_only=True)
class LimitSetup:
    """What is wanted of a new shape, and what it has to keep.

    Parameters
    ----------
    want : measures to improve, one to three of exit_speed, zone, best, sting, swing_time, durability.
    keep : measures that stay within 1 % of the present bat's.
    woods : names of the materials to try; none: the present bat's.
    league : whose rules are kept; None: that of the bat's sport, "none": no one's.
    deepest_cup : deepest cupped end that may be turned, m.
    handle : smallest diameter of the grip, m; None: the present one.
    """

    want: Sequence[str] = ("exit_speed", "zone")
    keep: Sequence[str] = ("mass", "moi", "density")
    woods: Sequence[str] = ()
    league: str | None = None
    deepest_cup: float = 1 * INCH
    handle: float | None = None


@dataclass(frozen=True, kw_only=True)
class FrontSetup:
    """How long to search, and which bat of the front to describe.

    Parameters
    ----------
    pick : which bat of the front, from 1: the best in the first want.
    seed, population, generations : of the search; 48 bats of 30 generations take minutes.
    resume : a saved search to go on from.
    """

    pick: int = 1
    seed: int = 1
    population: int = POPULATION
    generations: int = GENERATIONS
    resume: Path | None = None


USUAL_LIMITS, USUAL_FRONT = LimitSetup(), FrontSetup()


def design(
    implement: Loaded,
    *,
    limits: LimitSetup = USUAL_LIMITS,
    front: FrontSetup = USUAL_FRONT,
    player: BatterSetup = USUAL_BATTER,
    setup: HitSetup = AS_USUAL,
) -> DesignAnswer:
    """Shape a bat for a batter: where the wood should go, and what that gains.

    Parameters
    ----------
    implement : the present bat, racket or golf club, its name in the catalogue, or its file.

    Raises
    ------
    InputError
        when no bat keeps every limit, or a measure, wood or league is not known.
    """
    from sweetspot.answers.design import design_answer
    from sweetspot.answers.design_question import DesignQuestion
    from sweetspot.catalog.rules import league, usual_league

    conditions, _ = setup.swung(implement.implement)
    rules = None if limits.league == "none" else limits.league or usual_league(implement.implement)
    question = DesignQuestion(
        bat=implement.implement,
        batter=player.of(implement.implement, conditions),
        conditions=conditions,
        wants=tuple(limits.want),
        keep=tuple(limits.keep),
        handle=limits.handle,
        deepest_cup=limits.deepest_cup,
        materials=tuple(catalog.material(name) for name in limits.woods),
        league=None if rules is None else league(rules),
        **vars(front),
    )
    return design_answer(question)

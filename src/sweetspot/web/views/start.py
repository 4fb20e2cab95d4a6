"""Start: one bat, one ball to drag, what a hit there gives and sounds like, and the ways on."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Annotated

import numpy as np

from sweetspot.answers.hit import numbers_in_batch
from sweetspot.answers.records import GAPS, Length, Speed
from sweetspot.collision.impact import Outcome
from sweetspot.numerics.arrays import Array
from sweetspot.reports.page_words import cost_of_misses, hits_fastest, leaves_here, place_words
from sweetspot.reports.sentences import Sentence
from sweetspot.reports.sport_words import words_of
from sweetspot.units import INCH
from sweetspot.units.dimensions import LENGTH, SPEED, System
from sweetspot.web.bats import place_of
from sweetspot.web.controls import HitState, PlacedState
from sweetspot.web.documents import Sentences, in_both_systems, in_either_system
from sweetspot.web.drawings import BallPicture, BatPicture, ball_picture, bat_picture
from sweetspot.web.view import View
from sweetspot.web.views import explorer
from sweetspot.web.views.explorer_curves import HitsAlongBat, Met, along, beside, curves, head_on
from sweetspot.web.views.modes import ToneOfHit, tones

MISS = 2 * INCH
"""m that the sentence moves the ball along the bat to each side: [our choice], about a ball's radius more than one."""
DOORS = {
    "explorer": ("My bat", "Everything along it: speed, sting, slow motion, how it rings, and why."),
    "compare": ("Which bat", "Bats side by side at the same effort; the best for a player; one of your own design."),
    "paper": ("Learn", "Six claims about sweet spots, corked bats and metal ones, each tried on the full model."),
}
"""Ways on by the view that they lead to: what each is called, and what is behind it."""
TITLE = "Where does your bat hit best?"
LEAD = "Drag the ball along the bat. The collision is computed anew at every place."


class StartState(PlacedState):
    """The bat, the swing, the ball, and where along the bat they meet, in its middle."""


@dataclass(frozen=True)
class Door:
    """A way on: the view that it leads to, and its words."""

    view: str
    title: str
    words: str


@dataclass(frozen=True)
class StartWords:
    """The words of the first page that stay."""

    title: str
    lead: str
    doors: tuple[Door, ...]


@dataclass(frozen=True)
class SpeedsAlong:
    """Exit speeds along a bat, from the knob end, shape (n,)."""

    position: Annotated[Array, LENGTH]
    exit_speed: Annotated[Array, SPEED, GAPS]


@dataclass(frozen=True, kw_only=True)
class StartAnswer:
    """A bat, its best place, and the hit at the chosen place: its speed, what a miss costs, and its tones.

    Parameters
    ----------
    exit_speed : None: the ball does not leave.
    sentence : the speed here and what a miss to each side costs; the best place.
    """

    front: StartWords
    bat: BatPicture
    ball: BallPicture
    hands: Annotated[tuple[float, ...], LENGTH]
    best: Length
    scan: SpeedsAlong
    position: Length
    exit_speed: Speed | None
    place: Mapping[System, str]
    sentence: Sentences
    tones: tuple[ToneOfHit, ...]


START_WORDS = StartWords(TITLE, LEAD, tuple(Door(view, *words) for view, words in DOORS.items()))


def answer(state: StartState) -> StartAnswer:
    """Return a bat, its best place, and the hit at the chosen place in one sentence."""
    wide = _in_the_middle(state)
    setup, found = along(wide), curves(wide)
    bat, conditions = setup.reduced.bat, setup.conditions
    words = words_of(bat.sport)
    place = place_of(state, bat, conditions)
    hit, speed = head_on(setup, place)
    best = setup.spots.max_exit_speed
    fastest = float(np.nanmax(setup.scan.exit_speed[beside(setup.scan, best)]))
    from_tip = bat.length - place
    leaves = hit.outcome[0] == Outcome.SEPARATED
    if leaves:
        here = cost_of_misses(speed, _losses(setup, found, place, speed), step=MISS, words=words)
    else:
        numbers = numbers_in_batch(
            hit, position=place, closing_speed=conditions.pitch.speed + conditions.swing.speed_at(place)
        )
        here = leaves_here(from_tip, None, ends=numbers.outcome_text, words=words)
    sentences: list[Sentence] = [here, hits_fastest(bat.name, bat.length - best, fastest, words=words), *setup.doubts]
    return StartAnswer(
        front=START_WORDS,
        bat=bat_picture(state, setup.reduced),
        ball=ball_picture(state, conditions.ball),
        hands=conditions.hands.places,
        best=best,
        scan=SpeedsAlong(found.curves.position, found.curves.exit_speed),
        position=place,
        exit_speed=speed if leaves else None,
        place=in_either_system(place_words(from_tip, words=words)),
        sentence=in_both_systems(sentences),
        tones=tones(state, place, float(hit.contact_time[0])) if leaves else (),
    )


def _losses(setup: Met, found: HitsAlongBat, place: float, speed: float) -> dict[str, float]:
    """Return the loss of a hit `MISS` further to each side m/s, by the side's name; none beyond the ends."""
    ends = {"hands": place - MISS, "tip": place + MISS}
    first, last = setup.conditions.hands.position, setup.reduced.bat.length
    there = {
        side: float(np.interp(end, found.curves.position, found.curves.exit_speed))
        for side, end in ends.items()
        if first <= end <= last
    }
    return {side: speed - value for side, value in there.items() if np.isfinite(value)}


def _in_the_middle(state: StartState) -> HitState:
    return HitState.model_construct(**{name: getattr(state, name) for name in PlacedState.model_fields}, offset_in=0.0)


def recipe(state: StartState) -> dict[str, str]:
    """Return the lines that give the hit, and the curves along the bat."""
    fields = {name: getattr(state, name) for name in PlacedState.model_fields}
    return explorer.recipe(explorer.ExplorerState.model_construct(**fields, offset_in=0.0))


VIEW = View("start", "Start", StartState, answer, recipe)

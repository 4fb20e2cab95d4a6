"""What the full model says of each of the paper's questions, and the paper's formulas with the numbers of now."""

from __future__ import annotations

import math

from sweetspot.analysis.bat_analysis import Analysis
from sweetspot.dynamics.rigid import RigidBody, centre_of_percussion
from sweetspot.equipment.bat import Bat
from sweetspot.numerics.constants import STANDARD_GRAVITY
from sweetspot.papers import formulas
from sweetspot.papers.choices import Choices
from sweetspot.papers.formulas import PaperRow
from sweetspot.reports.sentences import Sentence, Slot, say
from sweetspot.units import MPH

FORCE_GROWS = 0.005
"""kN from which a force is said to grow."""
THICK = 0.02
"""m from which a block is no trampoline however it is held."""
NO_HEIGHT = "no height, for it does not come off in one contact"
MANY_MEANINGS = (
    "“Sweet spot” has at least six meanings, each with its own place: they differ because the ball asks for speed, the "
    "hands for quiet. And air matters a great deal to a batted ball: the view Flight shows by how much. Other sports "
    "need other balls, other faces and other rules, not only other coefficients: the view Every sport has them."
)
Told = tuple[list[Sentence], list[Sentence]]
"""Sentences, and formulas with the numbers of now."""


def paper_words(question: str, analysis: Analysis[Bat], choices: Choices, rows: list[PaperRow]) -> Told:
    """Return the full model's answer to a question, and the question's formulas with its numbers."""
    return QUESTIONS[question](analysis, choices, rows)


def _numbers(rows: list[PaperRow], equation: str, column: str = "full_model") -> list[float]:
    """Return a column of the rows of an equation; nan where there is no number."""
    values = [getattr(row, column) for row in rows if row.equation == equation]
    return [value if isinstance(value, float) else math.nan for value in values]


def _from_tip(analysis: Analysis[Bat], place: float) -> Slot:
    return Slot(analysis.bat.length - place, "place")


def _end(analysis: Analysis[Bat], _: Choices, rows: list[PaperRow]) -> Told:
    elastic, travel = (_numbers(rows, "S", column)[-1] * 1e-3 for column in ("computed", "full_model"))
    scan = analysis.scan
    words = say(
        "The ball does shift, by {travel:length}, but it is hit best {place} from the tip: S is far too short to "
        "explain it. The conclusion is right for another reason. At the tip even a rigid bat recoils by turning "
        "({rigid:speed}), and the real one also bends and keeps that energy ({end:speed}); at its best place it gives "
        "{best:speed}.",
        travel=travel,
        place=_from_tip(analysis, analysis.sweet_spots.max_exit_speed),
        rigid=float(scan.rigid_exit_speed[-1]),
        end=float(scan.exit_speed[-1]),
        best=float(scan.exit_speed.max()),
    )
    limit = say("0 ≤ S ≤ v_1 sin \N{GREEK SMALL LETTER ALPHA} T = {length}", length=Slot(elastic, "length"))
    return [words], [limit, say("S_real = {length:length}", length=travel)]


def percussion_places(analysis: Analysis[Bat], choices: Choices) -> tuple[RigidBody, float, float, float, float]:
    """Return the paper's rod, and m from the knob: where its, the bat's and the moved hands' percussion centres lie.

    The last is where the moved hands are.
    """
    bat, body, hands = analysis.bat, analysis.body, analysis.conditions.hands.position
    rod = formulas.rod(bat.length, body.mass)
    moved = min(hands + choices.hands_moved, bat.length / 2)
    return (
        rod,
        centre_of_percussion(rod, pivot=choices.rod_hands),
        centre_of_percussion(body, pivot=hands),
        centre_of_percussion(body, pivot=moved),
        moved,
    )


def _percussion(analysis: Analysis[Bat], choices: Choices, __: list[PaperRow]) -> Told:
    length, best = analysis.bat.length, analysis.sweet_spots.max_exit_speed
    _body, rod, bat, moved, _place = percussion_places(analysis, choices)

    def tipwards(place: float) -> Sentence:
        side = "beyond" if place > length else "from"
        return say(f"{{place}} {side} the tip", place=Slot(abs(length - place), "place"))

    words = say(
        "The mechanics hold for any rigid bat. Held as here, the rod's centre of percussion lies {rod}, this bat's "
        "{bat}, and when the hands move up, {moved}. But it is the place where the top hand feels no jolt, not the "
        "place where the ball leaves fastest: that is {best} from the tip, {gap} further "
        + ("out" if best > bat else "in")
        + ", and it hardly moves with the hands.",
        rod=tipwards(rod),
        bat=tipwards(bat),
        moved=tipwards(moved),
        best=_from_tip(analysis, best),
        gap=Slot(abs(best - bat), "place"),
    )
    hands = analysis.conditions.hands.position
    return [words], [
        say("b_rod = {length:place}", length=rod - choices.rod_hands),
        say("b_bat = {length:place}", length=bat - hands),
    ]


def _corking(_: Analysis[Bat], __: Choices, rows: list[PaperRow]) -> Told:
    before, after = _numbers(rows, "13")[-2:]  # of the plain bat, then of the corked one
    long, longer, fast, faster = _numbers(rows, "14")[-4:]
    change = (faster - fast) * MPH
    plain, corked = (Slot(1e3 * force, "weight") for force in (before, after))
    words = say(
        f"The force {'grows' if after > before + FORCE_GROWS else 'does not grow'}: {{plain}} for the plain bat, "
        "{corked} for the corked one. Contact lasts {long} and {longer}. At the same bat speed the ball leaves "
        f"{{change}} {'slower' if change < 0 else 'faster'}. What drilling changes is the weight: a lighter barrel is "
        "pushed back more. Whether the lighter bat is swung enough faster to make up for it is the player's matter; "
        "the view Compare answers it.",
        plain=plain,
        corked=corked,
        long=Slot(long * 1e-3, "contact"),
        longer=Slot(longer * 1e-3, "contact"),
        change=Slot(abs(change), "speed"),
    )
    momentum = Slot(_numbers(rows, "14", "computed")[0], "impulse")
    return [words], [
        say("m ( v_2 \N{MINUS SIGN} v_1 ) = {momentum}", momentum=momentum),
        say("F_plain = {plain} , F_corked = {corked}", plain=plain, corked=corked),
    ]


def _drop(analysis: Analysis[Bat], choices: Choices, rows: list[PaperRow]) -> Told:
    heights = [row.full_model if isinstance(row.full_model, float) else None for row in rows[:2]]
    wood, metal = (NO_HEIGHT if height is None else Slot(height, "place") for height in heights)
    thick = choices.block_support == "floor" or choices.block_thickness > THICK
    why = (
        "On a thick block nearly all of the loss is in the ball, and the two hardly differ: the experiment measures "
        "the ball. Clamp the blocks and make them as thin as a bat's wall to see a trampoline."
        if thick
        else "A thin, clamped plate is a trampoline: it takes energy that the ball would lose, and gives it back in "
        "time. That is what a metal bat's wall does, and what a thick block cannot show."
    )
    words = say("From wood the ball comes back to {wood}, from metal to {metal}.", wood=wood, metal=metal)
    weight = STANDARD_GRAVITY * analysis.conditions.ball.mass
    lost = ["?" if height is None else f"{weight * (choices.drop_height - height):.3f} J" for height in heights]
    return [words, say(why)], [say("E_wood = {wood} , E_metal = {metal}", wood=lost[0], metal=lost[1])]


def _energy(_: Analysis[Bat], choices: Choices, rows: list[PaperRow]) -> Told:
    (wood, metal), (wood_model, metal_model) = _numbers(rows, "W", "computed")[:2], _numbers(rows, "W")[:2]
    words = say(
        "The formula is exact for two springs in series: e = √W is {wood:ratio} for wood and {metal:ratio} for metal "
        "here. The full model gives {wood_model:ratio} for this bat, and {metal_model:ratio} for an aluminium bat "
        "whose wall takes a tenth of the energy: one {wall:pressed} thick. A metal bat does hit faster. The dotted "
        "line joins aluminium bats with thicker (left) and thinner (right) walls.",
        wood=math.sqrt(wood),
        metal=math.sqrt(metal),
        wood_model=wood_model,
        metal_model=metal_model,
        wall=_numbers(rows, "z")[1] * 1e-3,
    )
    ball = choices.ball_restitution
    pairs = ((choices.wood_restitution, choices.wood_share), (choices.metal_restitution, choices.metal_share))
    lines = [
        f"W_{number} = {k:.2f}^2 · {z:.3f} + {ball:.2f}^2 · {1 - z:.3f} = {k * k * z + ball * ball * (1 - z):.4f}"
        for number, (k, z) in enumerate(pairs, start=1)
    ]
    return [words], [say(line) for line in lines]


def _verdict(analysis: Analysis[Bat], _: Choices, __: list[PaperRow]) -> Told:
    spots = analysis.sweet_spots
    words = say(
        "{name} hits fastest {place} from the tip",
        name=analysis.bat.name,
        place=_from_tip(analysis, spots.max_exit_speed),
    )
    if spots.zone is not None:
        words += say(
            ", and hits fast and quietly from {outer} to {inner}",
            outer=_from_tip(analysis, spots.zone[1]),
            inner=_from_tip(analysis, spots.zone[0]),
        )
    return [words + ".", say(MANY_MEANINGS)], []


QUESTIONS = {
    "end": _end,
    "percussion": _percussion,
    "corking": _corking,
    "drop": _drop,
    "energy": _energy,
    "verdict": _verdict,
}

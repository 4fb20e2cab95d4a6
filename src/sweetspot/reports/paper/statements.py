"""What each statement of the implemented paper says, and the comment on it: sentences by the statement's name."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import NamedTuple

from sweetspot.papers.formulas import PaperRow, Value
from sweetspot.reports.quantities import SI, US, Reader, System, Unit
from sweetspot.reports.sentences import Line, Sentence, tell
from sweetspot.units import INCH

SUPPORTS = {"floor": "lying on concrete", "clamped": "clamped at its edges", "free": "lying free"}
INCHES = {"place": Unit("in", INCH, 2)}
PAPER_READERS: Mapping[System, Reader] = {"us": Reader({**US.units, **INCHES}), "si": SI}
"""Readers on the page, who see sizes of holes as they set them."""
CHAIN = Reader({**SI.units, **INCHES, **{scale: US.units[scale] for scale in ("speed", "speed_change")}})
"""The reader of the chain as the command prints it: places in inches, speeds in mph, all else metric."""


class Wording(NamedTuple):
    """What is stated, and the comment on it."""

    quantity: Sequence[Line]
    comment: Sequence[Line]


def _wording(quantity: str, comment: str) -> Wording:
    return Wording((Line(quantity),), (Line(comment),))


def _of_rod(quantity: str, comment: str) -> Wording:
    """Return a statement on the paper's rod, with where it is held."""
    inside = Line(", rod held {hands:place, round} from its end", "held_inside")
    return Wording((Line(quantity), inside, Line(", rod held at its end", unless="held_inside")), (Line(comment),))


ENTRY = {
    "path acceleration": _wording(
        "acceleration along the path at half the peak force, alpha = {angle:angle, round}",
        "a = F cos(alpha) / m0. The force is no constant: the full model's figure is the peak.",
    ),
    "path radius": _wording(
        "radius of the path at half the peak force, alpha = {angle:angle, round}",
        "F sin(alpha) = m0 v1^2 / r. True at one instant only; nothing in the answer rests on it.",
    ),
    "speed along": _wording(
        "ball speed along the bat, alpha = {angle:angle, round}",
        "v sin(alpha). The paper prints the same symbol in equations 3 and 4.",
    ),
    "speed across": _wording("ball speed across the bat, alpha = {angle:angle, round}", "v cos(alpha)."),
    "plastic travel": _wording(
        "travel along the bat, plastic contact",
        "Ball and bat move as one, so S = 0. That the best point is then the end does not follow: it asks where on the "
        "bat the ball was met.",
    ),
    "elastic travel": _wording(
        "travel along the bat, elastic contact without friction",
        "S = v sin(alpha) T. A real ball grips the wood, which gives the full model's figure between the two limits. "
        "The best point lies {from_tip:place, 1} from the end: S is far too short to explain it.",
    ),
}
PERCUSSION = {
    "moment of inertia": _of_rod(
        "J_D = J_C + m l^2",
        "The parallel-axis theorem. A bat is thicker at the far end, so it is harder to turn than the rod.",
    ),
    "turning": _of_rod(
        "angular speed per N s at the tip, (l + x) / J_D",
        "Printed with 1 + x for l + x. Full model: this bat, this grip, held like the rod: its place can't move.",
    ),
    "mass centre": _of_rod(
        "speed of the mass centre per N s at the tip, l (l + x) / J_D",
        "More than 1/m: the hands push the same way as the blow, F = I - m a_c is negative.",
    ),
    "beyond the mass centre": _of_rod(
        "x = J_C / (m l)",
        "Printed with 1 + x for l + x in equations 5 to 9. L/6 for a uniform rod. Full model: this bat, this grip.",
    ),
    "centre of percussion": _of_rod(
        "b = J_D / (m l)",
        "The centre of percussion, 2L/3 for a uniform rod; full model: distance from this bat's grip. The hands feel "
        "no jolt there, but the ball does not leave fastest there.",
    ),
    "hand force": _wording(
        "hand force over blow, hit at the {where}",
        "(J_C - m x l) / (J_C + m l^2). Positive: the hands must hold on against being thrown back.",
    ),
    "hands moved": _wording(
        "percussion centre moves when the hands move {moved:place, round} up",
        "The paper is right: hands further from the mass centre bring it closer to the centre, so hands moved up push "
        "it to the tip. The place of greatest exit speed hardly moves: the hands are out of the collision.",
    ),
}
CORKING = {
    "momentum": _wording(
        "F t = m (v2 - v1): momentum given to the ball",
        "The momentum theorem holds. Full model: the area under its force curve.",
    ),
    "mean force": _wording("mean force over the contact time", "Full model: the peak."),
    "mass of the corked bat": _wording(
        "mass of the bat, corked less plain", "Right, and this, not a softer barrel, is what the hole does to a hit."
    ),
    "force, plain": _wording("F = k x: peak force, plain bat", "Full model: this bat."),
    "force, corked": _wording(
        "F = k x: peak force, corked {diameter:place, round} by {depth:place, round}",
        "Softer means more travel at less force, not more of both. A drilled barrel is still far stiffer than the "
        "ball, and the force falls a little because the bat is lighter.",
    ),
    "contact time, plain": _wording("contact time, plain bat", "Full model: this bat."),
    "contact time, corked": _wording("contact time, corked", "Full model: the same bat with the hole."),
    "exit speed, plain": _wording("exit speed, plain bat", "Full model: this bat."),
    "exit speed, corked": _wording(
        "exit speed at the same bat speed, corked",
        "Wrong: q falls from {q_before:ratio} to {q_after:ratio}. The lighter bat must be swung "
        "{extra:speed_change, 1} faster just to break even. In the laboratory q fell from 0.214 to 0.193, which asks "
        "for {published:speed_change, 1} (Nathan and others, 2011).",
    ),
}
REBOUND = Wording(
    (
        Line("rebound from {height:distance, 2, round} on a "),
        Line("thick ", "thick"),
        Line("{block} block"),
    ),
    (
        Line("Wrong for these blocks: metal is no higher, but {behind:length, 1} lower than wood without ", "wrong"),
        Line("losses. ", "wrong"),
        Line("Right for these blocks. ", "right"),
        Line("Full model: {thickness:length, 1, round} thick, {support}. m g dH = E_D is the energy lost, "),
        Line("{lost:energy, 2}, and not an elastic one. The block takes {share:share, 2} of the energy. "),
        Line("Wood that gives back all it takes beats metal by a hair, since the block is the better spring; ", "wood"),
        Line("real wood loses some of it.", "wood"),
        Line("A thick block measures the ball. It tells next to nothing about a thin wall: the same metal ", "metal"),
        Line("as a plate of {plate:pressed, round}, clamped at its edges {apart:length, 1, round} apart, ", "metal"),
        Line("would hold {sprung_share:share} of the energy and throw the ball back to ", "metal"),
        Line("{sprung_height:distance, 2}: a trampoline.", "metal"),
    ),
)
MEANS = "e = {restitution:ratio}, which on this bat means {speed:speed_change, 1}. Full model: "
ENERGY = {
    "energy returned, wood": _wording(
        "W1, wood: energy returned over energy stored",
        MEANS + "this bat at its best point. The paper's 0.45 for the ball is low.",
    ),
    "energy returned, metal": _wording(
        "W2, metal: energy returned over energy stored",
        MEANS + "an aluminium bat whose wall takes a tenth of the energy, at its best point.",
    ),
    "share of ash": _wording(
        "share of the energy that solid ash takes",
        "From the wood's own stiffness across the grain under the ball: the paper's 2 % is right for solid wood. This "
        "is at the force of the best hit: pressed less, as in Fig. 6, wood takes a little less, since the ball "
        "stiffens as it is pressed and the wood does not.",
    ),
    "metal wall": _wording(
        "wall for which an aluminium bat takes that share",
        "z = 10 %, from the hoop modes of the catalogue's {bat} with other walls; nothing fitted. {speed:speed, 0}.",
    ),
    "restitution of the wall": _wording(
        "restitution of that wall",
        "What the wall gives back before the ball has gone, as the square root of the part of the energy.",
    ),
    "metal swung faster": Wording(
        (Line("bat speed with the same effort, metal less this bat"),),
        (
            Line("Right in kind", "right"),
            Line("Not so for this bat", "wrong"),
            Line("Not decided here", "open"),
            Line(": {low:speed_change, 1} to {high:speed_change, 1} by the law of {law}. Not the mass counts but how "),
            Line("far from the hands it sits. The catalogue's {bat} weighs {metal:mass}, this bat {own:mass}."),
        ),
    ),
    "carry off wood": _wording(
        "carry of that ball off wood, {angle:angle, 0} up",
        "Computed: without air, which the paper leaves out. Full model: with it, at sea level.",
    ),
    "carry off metal": _wording(
        "carry of that ball off metal",
        "Right. That leaving out the air hardly matters is not: it takes {taken:share} of the carry, and of the "
        "{without:distance, 0} between the two it leaves {left:distance, 0}.",
    ),
}
VERDICT = {
    "best point": Wording(
        (Line("best point, distance from the end"),),
        (
            Line(
                "Not at the end, as the paper says, but for other reasons: out there the bat is light (it recoils by "
            ),
            Line("turning) and its bending takes energy that comes back too late."),
            Line(" The sweet zone is {width:place, 1} wide.", "zone"),
        ),
    ),
    "livelier ball, place": Wording(
        (Line("best point moves towards the end, restitution of the ball + {livelier:ratio, 2}"),),
        (Line("Right.", "still"), Line("Not quite: a livelier ball is best met further out.", unless="still")),
    ),
    "livelier ball, speed": _wording("exit speed gains, restitution of the ball + {livelier:ratio, 2}", "Right."),
}
OTHER_SPORTS = {
    "percussion in a sport": _wording(
        "b = J_D / (m l): centre of percussion of {bat}",
        "From the butt. Computed: a uniform rod of this length held at its end. Full model: this mass, balance and "
        "swing weight, held {hands:place, 0} from the butt. Same formula, other coefficients: exact for both.",
    ),
    "hand force in a sport": _wording(
        "hand force over blow, hit at the far end", "Negative: the hand is jerked forwards."
    ),
    "share of the face": _wording(
        "share of the stored energy that the face takes",
        "At the best place, pressed slowly; a ball on a rigid wall at {speed:speed, 1} would store as much.",
    ),
    "energy returned in a sport": _wording(
        "W = k_bat^2 z + k_ball^2 (1 - z): energy returned over energy stored",
        "k_bat = {face:ratio} (face alone), k_ball = {ball:ratio} (at the speed of its share); e = {formula:ratio}, "
        "full model {model:ratio}. The formula knows no bending, and a face that follows without delay.",
    ),
    "drop of the rules": _wording(
        "{rule}: rebound from {height:place, round}",
        "The claim is the rule's. The formula leaves the air out, the full model does not: e = {restitution:ratio} at "
        "{speed:speed, 2}, while sqrt(rebound / fall) = {root:ratio}.",
    ),
}
STATEMENTS: Mapping[str, Wording] = {
    **ENTRY,
    **PERCUSSION,
    **CORKING,
    "rebound": REBOUND,
    **ENERGY,
    **VERDICT,
    **OTHER_SPORTS,
}


def statement(row: PaperRow) -> tuple[Sentence, Sentence]:
    """Return the statement of a row, and the comment on it."""
    wording, facts = STATEMENTS[row.name], dict(row.facts)
    if "support" in facts:
        facts["support"] = SUPPORTS[str(facts["support"])]
    return tell(wording.quantity, **facts), tell(wording.comment, **facts)


@dataclass(frozen=True)
class StatedRow:
    """A row with its words for one reader."""

    equation: str
    quantity: str
    unit: str
    paper: Value
    computed: Value
    full_model: Value
    comment: str
    name: str


def stated(row: PaperRow, reading: Reader = CHAIN) -> StatedRow:
    """Return a row with its words as a reader sees them."""
    quantity, comment = (sentence.read(reading) for sentence in statement(row))
    return StatedRow(row.equation, quantity, row.unit, row.paper, row.computed, row.full_model, comment, row.name)

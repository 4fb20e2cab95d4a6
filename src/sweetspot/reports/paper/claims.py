"""What the implemented paper claims, in words, and what decides each claim."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from sweetspot.papers.claims import ClaimVerdict, PaperClaim
from sweetspot.reports.document import Cell, Marked, Table, table_head
from sweetspot.reports.sentences import Sentence, say

CLAIMS: Mapping[str, tuple[str, str]] = {
    "not the end": (
        "The best place to hit is not the end of the bat.",
        "{bat} hits best {place:place} from the end.",
    ),
    "within the shift": (
        "It lies within S of the end, the ball's shift along the bat during contact.",
        "S is at most {shift:length}, and the best place is {place:place} from the end.",
    ),
    "quiet hands": (
        "A hit at the centre of percussion leaves the hands at rest.",
        "The force on the hands changes its sign between the mass centre and the tip.",
    ),
    "percussion is best": (
        "The centre of percussion is the best place to hit.",
        "The ball leaves fastest {gap:place} from it.",
    ),
    "hands moved": (
        "Hands further from the mass centre bring the centre of percussion closer to it.",
        "Hands moved {hands:place, round} up, towards the mass centre, move it {moved:length} towards the tip.",
    ),
    "corking lightens": ("A corked bat is lighter.", "By {lost:mass}."),
    "corking adds force": (
        "A softer barrel is pressed in further, so the force grows.",
        "{before:blow} for the plain bat, {after:blow} for the corked one.",
    ),
    "corking lengthens contact": (
        "Contact lasts longer.",
        "{before:contact} for the plain bat, {after:contact} for the corked one.",
    ),
    "corking speeds the ball": (
        "So the ball leaves a corked bat faster.",
        "At the same bat speed its exit speed changes by {change:speed_change, sign}.",
    ),
    "metal rebounds higher": (
        "A ball comes back higher from a metal block than from a wooden one.",
        "From {height:distance, 2, round} {metal:distance, 3} from metal, {wood:distance, 3} from wood.",
    ),
    "metal returns more": (
        "A metal bat returns more of the energy.",
        "{metal:share} of it, where this bat returns {wood:share}.",
    ),
    "metal swung faster": (
        "A metal bat is swung faster with the same effort.",
        "By {faster:speed_change, sign} ({low:speed_change, bare} to {high:speed_change, bare}).",
    ),
    "metal carries further": ("So its ball carries further.", "By {further:distance}."),
    "air hardly matters": (
        "Leaving out the air hardly matters.",
        "The air takes {taken:share} of the carry.",
    ),
    "livelier ball, same place": (
        "A livelier ball has the same best place.",
        "It moves by {moved:place} where the ball's restitution is {livelier:ratio, 2} higher.",
    ),
    "livelier ball, faster": ("And leaves faster.", "By {gained:speed_change}."),
}
"""By the name of a claim: what the paper says, and the numbers that decide it."""
MARKS = {ClaimVerdict.HOLDS: "hit", ClaimVerdict.FAILS: "missed", ClaimVerdict.OPEN: ""}


def claims_headline(claims: Sequence[PaperClaim]) -> str:
    """Return how many claims hold, how many do not, and how many are open."""
    holding, failing, undecided = (sum(claim.verdict is verdict for claim in claims) for verdict in (*ClaimVerdict,))
    return f"{len(claims)} claims: {holding} hold, {failing} do not, {undecided} open."


def claims_table(claims: Sequence[PaperClaim]) -> Table:
    """Return the claims with their verdicts and what decides them."""
    rows: list[list[Cell]] = [
        [CLAIMS[claim.name][0], Marked(claim.verdict, MARKS[claim.verdict]), claim_reason(claim)] for claim in claims
    ]
    return Table("", table_head("the paper says | verdict | the full model says"), rows, name="claims")


def claim_reason(claim: PaperClaim) -> Sentence:
    """Return the numbers that decide a claim, in words."""
    return say(CLAIMS[claim.name][1], **claim.facts)

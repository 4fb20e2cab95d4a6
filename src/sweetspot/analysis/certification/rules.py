"""Rules of leagues: what is limited, for which bats, and whether one bat keeps the limit.

A rule is data with a source and a year; a check compares it with what is known about a bat. A limit that no source
states is no limit: the check then says "not decidable" and why.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, replace
from enum import StrEnum
from typing import Literal

from sweetspot.dynamics.rigid import RigidBody, moi_doubt
from sweetspot.equipment.bat import Bat
from sweetspot.equipment.cricket_bat import CricketBat
from sweetspot.equipment.golf_club import GolfClub
from sweetspot.equipment.implement import Implement
from sweetspot.equipment.paddle import Paddle
from sweetspot.errors import InputError
from sweetspot.numerics.constants import STANDARD_AXIS
from sweetspot.units import INCH, OUNCE

Construction = Literal[
    "any", "wood", "not wood", "not one piece of wood", "composite", "cricket bat", "paddle", "golf club"
]
Reading = Literal["primary", "secondary", "recalled"]
SLACK = 1e-6
"""Relative tolerance of a limit, for rounding of units alone."""
WEIGHING = 0.005
"""The same for the drop, in ounces: half of a hundredth, to which bats are weighed."""
CALIPER = 0.2e-3
"""Of a barrel's diameter, m: what a careful caliper tells (assumed); an outline that was fitted is off by less."""

QUANTITIES: dict[str, tuple[str, str]] = {
    "length": ("length", "m"),
    "diameter": ("greatest diameter", "m"),
    "drop": ("drop: inches less ounces", "in - oz"),
    "cup_depth": ("depth of the cupped end", "m"),
    "cup_diameter": ("width of the cupped end", "m"),
    "solid_wood": ("one piece of solid wood", "yes or no"),
    "unaltered": ("no drilling, no filling", "yes or no"),
    "bbcor": ("BBCOR", "-"),
    "besr": ("BESR", "-"),
    "bpf": ("BPF", "-"),
    "batted_ball_speed": ("batted-ball speed", "m/s"),
    "moi": ("moment of inertia", "kg m^2"),
    "blade_width": ("width of the blade", "m"),
    "blade_depth": ("depth of the blade", "m"),
    "blade_edge": ("thickness of the edges", "m"),
    "grip_length": ("length of the grip", "m"),
    "ring_gauge": ("ring gauge", "-"),
    "break_in": ("BBCOR after break-in", "-"),
    "youth_performance": ("performance like wood", "-"),
    "pbcor": ("PBCoR", "-"),
    "pef": ("PEF", "-"),
    "length_and_width": ("length and width together", "m"),
    "deflection_force": ("force that presses the face in by 1/16 in", "N"),
    "characteristic_time": ("characteristic time of the face", "s"),
    "cor": ("restitution of the face", "-"),
    "head_moi": ("moment of inertia of the head about the vertical", "kg m^2"),
}
"""Quantities that a rule can limit: name for people, unit."""
PERFORMANCE = frozenset({"bbcor", "besr", "bpf", "batted_ball_speed", "pbcor", "pef", "characteristic_time", "cor"})
"""Of these what a test of a bat measures: how lively it is."""
STATED_FOR: dict[Construction, str] = {
    "any": "every bat",
    "wood": "wood bats",
    "not wood": "bats that are not wood",
    "not one piece of wood": "bats that are not made of one piece of wood; this one is",
    "composite": "composite bats",
    "cricket bat": "cricket bats",
    "paddle": "paddles",
    "golf club": "golf clubs",
}


NOT_SURE = ", not sure"
"""Behind a verdict that what is not known of the value may turn."""


class Verdict(StrEnum):
    """Outcome of one check."""

    PASS = "pass"
    FAIL = "fail"
    NOT_DECIDABLE = "not decidable"
    NOT_APPLICABLE = "does not apply"


@dataclass(frozen=True)
class Rule:
    """One limit of a league.

    Parameters
    ----------
    quantity : key of `QUANTITIES`.
    least, most : the limits in SI; None: none on that side.
    undecided : why the rule can never be decided here, though its limit may be known; "": it can.
    doubt_beyond : why a value beyond the limit is not yet a fail; "": it is.
    source, where, year : where the limit was read; ``year`` None where the source gives none.
    reading : primary (the text itself), secondary (quoted elsewhere) or recalled (then there is no limit).
    """

    quantity: str
    least: float | None
    most: float | None
    construction: Construction
    undecided: str
    doubt_beyond: str
    source: str
    where: str
    year: int | None
    reading: Reading

    def __post_init__(self) -> None:
        if self.quantity not in QUANTITIES:
            raise InputError(f"rule on {self.quantity!r}; known quantities: {', '.join(QUANTITIES)}")
        limited = self.least is not None or self.most is not None
        if not limited and not self.undecided:
            raise InputError(f"rule on {self.quantity}: give a limit or the reason why there is none")
        if limited and self.reading == "recalled":
            raise InputError(f"rule on {self.quantity}: a limit known only from memory is no limit")


@dataclass(frozen=True)
class League:
    """A league's rules for bats.

    ``ball``: name in the catalogue of the ball that bats are tested with. ``superseded``: since when and by what the
    rules hold no more; "": they do.
    """

    key: str
    name: str
    ball: str
    rules: tuple[Rule, ...]
    superseded: str = ""


@dataclass(frozen=True)
class Finding:
    """Knowledge about one quantity of a bat.

    Parameters
    ----------
    value : in SI; None: nothing.
    doubt : why it cannot decide a rule; "": it can.
    doubt_within : why a value within the limits is not yet a pass, though one beyond them is a fail; "": it is.
    absent : what the bat does not have, so that no rule on it applies; "": it has it.
    """

    value: float | None
    doubt: str = ""
    interval: tuple[float, float] | None = None
    absent: str = ""
    interval_is: str = "the 90 % interval"
    doubt_within: str = ""

    def moved_to(self, value: float) -> Finding:
        """Return another value of which as much is known."""
        if self.value is None or self.interval is None:
            return replace(self, value=value)
        low, high = (value + end - self.value for end in self.interval)
        return replace(self, value=value, interval=(low, high))


@dataclass(frozen=True)
class Check:
    """A rule held against a bat; ``margin`` is the distance inside the nearer limit, negative outside."""

    rule: Rule
    verdict: Verdict
    value: float | None
    margin: float | None
    reason: str

    @property
    def applies(self) -> bool:
        """Whether the rule holds for what was tested at all."""
        return self.verdict is not Verdict.NOT_APPLICABLE

    @property
    def decided(self) -> bool:
        """Whether it is a pass or a fail."""
        return self.verdict in (Verdict.PASS, Verdict.FAIL)

    @property
    def sure(self) -> bool:
        """Whether it is a pass or a fail that the uncertainty of the value cannot reverse."""
        return self.decided and not self.reason

    @property
    def words(self) -> str:
        """The verdict for display, with its doubt."""
        return f"{self.verdict}{NOT_SURE}" if self.decided and not self.sure else self.verdict.value


def check_rules(league: League, *, bat: Implement, findings: Mapping[str, Finding]) -> list[Check]:
    """Return the outcome of every rule of a league for a bat and the findings about it.

    A quantity with one limit for wood and another for the rest is checked by the one that applies.
    """
    limited = {rule.quantity for rule in league.rules if applies(rule, bat)}
    return [
        check_rule(rule, bat=bat, finding=findings.get(rule.quantity))
        for rule in league.rules
        if applies(rule, bat) or rule.quantity not in limited
    ]


def check_rule(rule: Rule, *, bat: Implement, finding: Finding | None) -> Check:
    """Return pass, fail, not decidable or does not apply, with margin and reason."""
    if not applies(rule, bat):
        return Check(
            rule, Verdict.NOT_APPLICABLE, None, None, f"the source states it for {STATED_FOR[rule.construction]}"
        )
    if finding is not None and finding.absent:
        return Check(rule, Verdict.NOT_APPLICABLE, None, None, finding.absent)
    value = None if finding is None else finding.value
    if rule.undecided:
        return Check(rule, Verdict.NOT_DECIDABLE, value, None, rule.undecided)
    if finding is None or value is None or not math.isfinite(value):
        reason = (finding.doubt if finding else "") or f"nothing is known about this bat's {title(rule)}"
        return Check(rule, Verdict.NOT_DECIDABLE, None, None, reason)
    verdict, reason = _verdict(rule, value, finding)
    margin = None if QUANTITIES[rule.quantity][1] == "yes or no" else _margin(rule, value)
    return Check(rule, verdict, value, margin, reason)


def applies(rule: Rule, bat: Implement) -> bool:
    """Return whether the source states the rule for a bat of this construction, judged by its barrel."""
    if not isinstance(bat, Bat):
        kind = {"cricket bat": CricketBat, "paddle": Paddle, "golf club": GolfClub}.get(rule.construction)
        return kind is not None and isinstance(bat, kind)
    wood = bat.material.family == "wood"
    laminate = bat.material.family == "laminate"
    if bat.shell is not None:
        inner = bat.shell.inner_wall
        laminate = laminate or bat.shell.laminate is not None or (inner is not None and inner.laminate is not None)
    stated: dict[Construction, bool] = {
        "any": True,
        "wood": wood and not laminate,
        "not wood": not wood or laminate,
        "not one piece of wood": not is_one_piece(bat),
        "composite": laminate,
        "cricket bat": False,
        "paddle": False,
        "golf club": False,
    }
    return stated[rule.construction]


def is_one_piece(bat: Bat) -> bool:
    """Return whether a bat was turned from a single piece of wood, whatever was drilled into it afterwards."""
    return bat.material.family == "wood" and not bat.material.laminated and bat.shell is None


def construction_findings(bat: Bat, *, body: RigidBody) -> dict[str, Finding]:
    """Return the findings from the description alone: sizes, weight, and whether the bat is one piece of wood.

    A bat given by its mass per length has no measured outline; its diameter follows from the material's density.
    """
    widest = max(float(bat.diameter_at(place)) for place in bat.breakpoints())
    if bat.linear_density is not None:
        outline = Finding(widest, "the bat is given by its mass per length, not by its outline")
    else:
        outline = Finding(widest)
    moi, doubt = body.moi(STANDARD_AXIS), 2 * moi_doubt(bat, body, STANDARD_AXIS)
    findings = {
        "length": Finding(bat.length),
        "diameter": outline,
        "drop": Finding(bat.length / INCH - body.mass / OUNCE),
        "moi": Finding(moi, interval=(moi - doubt, moi + doubt) if doubt else None),
        "solid_wood": _solid_wood(bat),
        "unaltered": Finding(0.0 if bat.bores or bat.altered else 1.0),
        "grip_length": Finding(None, "a bat file does not say how far the grip reaches"),
    }
    if bat.cup is None:
        findings["cup_depth"] = findings["cup_diameter"] = Finding(None, absent="the bat has no cupped end")
    else:
        findings["cup_depth"], findings["cup_diameter"] = Finding(bat.cup.depth), Finding(bat.cup.diameter)
    return findings


def title(rule: Rule) -> str:
    """Return the name of what a rule limits."""
    return QUANTITIES[rule.quantity][0]


def _solid_wood(bat: Bat) -> Finding:
    if not is_one_piece(bat) or bat.bores:
        return Finding(0.0)
    if not all(weight.on_surface for weight in bat.point_masses):
        return Finding(
            1.0,
            "a weight is fixed to the bat, and its file does not say whether it sits inside the wood; write "
            "on_surface = true with a weight that does not",
        )
    return Finding(1.0)


def _verdict(rule: Rule, value: float, finding: Finding) -> tuple[Verdict, str]:
    """Return verdict and reason for a rule that applies, has a limit, and a value to hold against it."""
    if finding.doubt:
        return Verdict.NOT_DECIDABLE, finding.doubt
    slack = SLACK * max(abs(limit) for limit in (rule.least, rule.most) if limit is not None)
    if rule.quantity == "drop":
        slack = WEIGHING
    if _margin(rule, value) >= -slack:
        if finding.doubt_within:
            return Verdict.NOT_DECIDABLE, finding.doubt_within
        return Verdict.PASS, _straddles(rule, finding)
    if rule.quantity == "diameter" and _margin(rule, value) >= -CALIPER:
        return Verdict.PASS, "it lies beyond the limit by less than a caliper tells"
    if rule.doubt_beyond:
        return Verdict.NOT_DECIDABLE, rule.doubt_beyond
    return Verdict.FAIL, _straddles(rule, finding)


def _margin(rule: Rule, value: float) -> float:
    above = math.inf if rule.most is None else rule.most - value
    below = math.inf if rule.least is None else value - rule.least
    return min(above, below)


def _straddles(rule: Rule, finding: Finding) -> str:
    if finding.interval is None:
        return ""
    low, high = finding.interval
    if any(limit is not None and low < limit < high for limit in (rule.least, rule.most)):
        ends = f", {low:.4f} to {high:.4f}," if QUANTITIES[rule.quantity][1] == "-" else ""
        return f"{finding.interval_is}{ends} reaches across the limit"
    return ""

"""One published number beside ours."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

Kind = Literal["identity", "quantitative", "band", "trend"]
Tag = Literal["P", "S", "D"]
Evidence = Literal["prediction about bats", "other prediction", "identity", "same law", "calibrated"]

KINDS: tuple[Kind, ...] = ("identity", "quantitative", "band", "trend")
TAGS: dict[Tag, str] = {
    "P": "read in the primary source",
    "S": "quoted by a secondary source",
    "D": "derived here by plain arithmetic from such numbers",
}
"""How a printed number was read. Numbers recalled from memory are never cases."""


EVIDENCE: dict[Evidence, str] = {
    "prediction about bats": "a number or statement about real bats, or hits with them, that went into nothing of ours",
    "other prediction": "the same about flights, pitches and other sports",
    "identity": "arithmetic: follows from the source's own numbers by a definition or an exact formula",
    "same law": "the source and we integrate or solve the same law: shows that the code is right, not that the law is",
    "calibrated": "went into our data: shows that it comes out again",
}
"""What a row is worth. Only the first two can tell whether the model is right."""


@dataclass(frozen=True)
class Result:
    """A case with its verdict.

    Parameters
    ----------
    source : key of the bibliography.
    name, quantity : which case, and what is compared.
    printed : the value as the source prints it, text.
    computed : ours, in ``unit``.
    unit : of printed and computed; empty for ratios.
    tolerance : what is allowed, as text.
    reason : why just that much.
    kind : identity (exact arithmetic), quantitative, band, or trend (a sign or an order).
    tag : how the printed value was read, see `TAGS`.
    ok : whether ours lies within the tolerance.
    comment : what else a reader should know.
    evidence : what the row is worth, see `EVIDENCE`.
    expected_miss : why ours differs, where the physics says so; empty otherwise.
    ours, ours_tolerance : of such a miss: what this version of the model is expected to say, in ``unit``; anything
        else fails, a hit too.
    """

    source: str
    name: str
    quantity: str
    printed: str
    computed: float
    unit: str
    tolerance: str
    reason: str
    kind: Kind
    tag: Tag
    ok: bool
    comment: str
    evidence: Evidence
    expected_miss: str
    ours: float | None = None
    ours_tolerance: float = 0.0

    @property
    def passed(self) -> bool:
        """Whether the row lets a run pass: within its tolerance, or just the miss that is explained."""
        if self.ours is None:
            return self.ok
        return abs(self.computed - self.ours) <= self.ours_tolerance

    @property
    def status(self) -> str:
        """The verdict in words."""
        if self.ours is None:
            return "ok" if self.ok else "MISS"
        return "MISS (explained)" if self.passed else f"MISS (explained was {self.expected_of_us})"

    @property
    def expected_of_us(self) -> str:
        """The value and band that an explained miss must keep, as text; empty for other rows."""
        return "" if self.ours is None else f"{self.ours:g} ± {self.ours_tolerance:g}"

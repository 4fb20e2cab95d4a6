"""One published number beside ours."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

Kind = Literal["identity", "quantitative", "band", "trend"]
Tag = Literal["P", "S", "D"]

KINDS: tuple[Kind, ...] = ("identity", "quantitative", "band", "trend")
TAGS: dict[Tag, str] = {
    "P": "read in the primary source",
    "S": "quoted by a secondary source",
    "D": "derived here by plain arithmetic from such numbers",
}
"""How a printed number was read. Numbers recalled from memory are never cases."""


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
    calibrated : the printed value went into our data, so the row shows that it comes out again, and predicts nothing.
    expected_miss : why ours differs, where the physics says so; empty otherwise.
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
    calibrated: bool
    expected_miss: str

    @property
    def passed(self) -> bool:
        """Whether the row lets a run pass: within its tolerance, or a miss that is explained."""
        return self.ok or bool(self.expected_miss)

    @property
    def status(self) -> str:
        """The verdict in words."""
        if self.ok:
            return "ok"
        return "MISS (explained)" if self.expected_miss else "MISS"

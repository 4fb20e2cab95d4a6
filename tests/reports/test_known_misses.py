"""Answers say where they are known to be off, with the numbers that the model has today."""

from __future__ import annotations

import re
from collections.abc import Callable

import pytest

from sweetspot.validation.computations.sports import first_node_from_tip, struck


@pytest.mark.parametrize(("from_tip", "printed"), [(0.28, "0.51"), (0.06, "0.22")])
def test_a_racket(run: Callable[..., tuple[int, str, str]], from_tip: float, printed: str) -> None:
    text = " ".join(run("hit", "tennis-racket", "--at", f"{100 * from_tip:.0f}cm-from-tip")[1].split())
    measured, ours = re.findall(r"0\.\d\d", text[text.index("Known to be off") :])[:2]
    q = struck(implement="tennis-racket", from_tip=from_tip, closing_speed=22.0).collision_efficiency
    assert measured == printed and float(ours) == pytest.approx(q, abs=0.006)
    assert "Known to be off" not in run("hit", "tennis-racket", "--at", "16cm-from-tip")[1]


def test_a_cricket_bat(run: Callable[..., tuple[int, str, str]]) -> None:
    text = " ".join(run("report", "cricket-bat")[1].split())
    (ours,) = re.findall(r"ours is (\d+) cm", text)
    assert float(ours) == pytest.approx(100 * first_node_from_tip(implement="cricket-bat"), abs=0.6)

"""Implements of different kinds side by side: each is held against the rules of its own sport, or against none."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest

from sweetspot.catalog import load_implement
from sweetspot.equipment.bat import Bat


@pytest.mark.parametrize(
    "names",
    [
        ("golf-driver", "r161-ash"),
        ("corked-r161", "tennis-racket"),
        ("hockey-stick", "corked-r161", "cricket-bat"),
        ("slow-pitch", "r161-ash"),
    ],
)
def test_kinds_beside_each_other(run_json: Callable[..., Any], names: tuple[str, ...]) -> None:
    told = run_json("compare", *names, "--force")["bats"]
    assert [("rules" in bat) for bat in told] == [isinstance(load_implement(name), Bat) for name in names]

"""Slips in a bat's drawing are told: turned round, radii, a wall in inches, keys misspelt; short forms are taken."""

from __future__ import annotations

from typing import Any

import pytest

from sweetspot.catalog.files.read import bat_from_table
from sweetspot.errors import InputError
from sweetspot.plausibility import insisting

OUTLINE = [["0 in", "2 in"], ["1.25 in", "1 in"], ["12 in", "1 in"], ["24 in", "2.3 in"], ["33 in", "2.5 in"]]
PLAIN: dict[str, Any] = {"name": "mine", "length": "33 in", "material": "white ash", "profile": OUTLINE}
METAL = {**PLAIN, "material": "aluminium-7xxx"}


def turned(pairs: list[list[str]]) -> list[list[str]]:
    return [[f"{33 - float(place.split()[0])} in", size] for place, size in reversed(pairs)]


@pytest.mark.parametrize(
    ("changes", "words"),
    [
        ({"profile": turned(OUTLINE)}, "positions count from the knob end"),
        ({"profile": [[place, f"{float(size.split()[0]) / 2} in"] for place, size in OUTLINE]}, "not radii"),
        ({"material": "aluminium-7xxx", "shell": {"wall": "0.028 in"}}, "2 to 5 mm"),
    ],
)
def test_slips_of_a_drawing_are_refused_unless_insisted_on(changes: dict[str, Any], words: str) -> None:
    with pytest.raises(InputError, match=words):
        bat_from_table(PLAIN | changes, "bat.toml")
    with insisting():
        assert bat_from_table(PLAIN | changes, "bat.toml").length == pytest.approx(0.8382)


@pytest.mark.parametrize(
    ("changes", "words"),
    [
        ({"balence_point": "22 in"}, "unknown key 'balence_point': did you mean 'balance_point'"),
        ({"mass": 31}, "mass was given as 31: write the unit too"),
        ({"profile": [[0, 1.75], ["33 in", "2.5 in"]]}, "profile was given as 0: write the unit too"),
        ({"material": {"longitudnal_modulus": "15 GPa"}}, "did you mean 'longitudinal_modulus'"),
        ({"mass": "30,500 oz"}, "decimals after a point"),
    ],
)
def test_every_refusal_says_how_to_mend_it(changes: dict[str, Any], words: str) -> None:
    with pytest.raises(InputError, match=words) as refused:
        bat_from_table(PLAIN | changes, "bat.toml")
    assert "MaterialTable" not in str(refused.value)


def test_short_forms_are_the_long_ones() -> None:
    even = bat_from_table(METAL | {"shell": {"wall": "2.8 mm"}}, "bat.toml")
    pairs = bat_from_table(METAL | {"shell": {"wall": [["0 in", "2.8 mm"], ["33 in", "2.8 mm"]]}}, "bat.toml")
    assert even == pairs
    bore = {"diameter": "1 in", "depth": "10 in"}
    assert bat_from_table(PLAIN | {"bore": bore}, "b") == bat_from_table(PLAIN | {"bore": [bore]}, "b")

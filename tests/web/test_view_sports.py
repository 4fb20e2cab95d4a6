"""Every sport's answers: the hit at a place is the map's there, and words and map come apart."""

from __future__ import annotations

import pytest

from sweetspot.units import INCH
from sweetspot.web.views.sports import SportsState, answer, face, sentences


def test_the_map_and_the_hit_agree() -> None:
    usual, found = answer(SportsState()), face(SportsState()).face
    assert usual.has_face and found is not None
    row = len(found.lateral) // 2
    from_tip = float(usual.tool.length) - found.position[20]
    state = SportsState(met_from_tip_in=from_tip / INCH, aside_in=found.lateral[row] / INCH)
    assert answer(state).hit.exit_speed == pytest.approx(found.exit_speed[row][20], abs=2e-3)


def test_what_has_no_face_has_no_map() -> None:
    bat = SportsState(implement="cricket-bat")
    assert answer(bat).has_face == (face(bat).face is not None)


def test_words_come_in_both_systems() -> None:
    told = sentences(SportsState(implement="cricket-bat", swing_mph=50)).sentences
    assert "mph" in told["us"][0] and "m/s" in told["si"][0] and "mph" not in told["si"][0]

"""Every sport's answers: the hit at a place is the map's there, and words and map come apart."""

from __future__ import annotations

import pytest

from sweetspot.web.views.sports import SportsState, answer, face, sentences


def test_the_map_and_the_hit_agree() -> None:
    found = face(SportsState())["face"]
    assert answer(SportsState())["has_face"]
    row = len(found["lateral_m"]) // 2
    place = found["position_m"][20]
    tool = answer(SportsState())["tool"]["length_m"]
    state = SportsState(met_from_tip_in=(tool - place) / 0.0254, aside_in=found["lateral_m"][row] / 0.0254)
    assert answer(state)["hit"]["exit_speed_m_s"] == pytest.approx(found["exit_speed_m_s"][row][20], abs=2e-3)


def test_what_has_no_face_has_no_map() -> None:
    bat = SportsState(implement="cricket-bat")
    assert answer(bat)["has_face"] == (face(bat)["face"] is not None)


def test_words_come_in_both_systems() -> None:
    told = sentences(SportsState(implement="cricket-bat", swing_mph=50))["sentences"]
    assert "mph" in told["us"][0] and "m/s" in told["si"][0] and "mph" not in told["si"][0]

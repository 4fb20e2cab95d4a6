"""The paper's answers: its numbers as printed, its formulas with other numbers, the full model beside them."""

from __future__ import annotations

import re
import shlex
from collections.abc import Callable
from typing import Any

import pytest

from sweetspot.answers.records import to_dict
from sweetspot.papers.chain import PARTS
from sweetspot.web.errors import FieldError
from sweetspot.web.views.paper import VIEW, PaperState
from sweetspot.web.views.paper import answer as paper_answer


def answer(state: PaperState) -> dict[str, Any]:
    return to_dict(paper_answer(state))


def asked(**controls: Any) -> dict[str, Any]:
    return answer(PaperState.model_validate(controls))


def value(found: dict[str, Any], equation: str, column: str, start: str = "") -> Any:
    return next(
        row[column] for row in found["rows"] if row["equation"] == equation and row["quantity"].startswith(start)
    )


@pytest.mark.parametrize("question", PARTS)
def test_every_question_has_statements_and_a_picture(question: str) -> None:
    found = asked(question=question)
    assert found["question"] == question and found["rows"] and found["picture"]


def test_printed_numbers_of_the_energy() -> None:
    """20 % and 26 % [paper2014]."""
    found = asked(question="energy")
    assert round(value(found, "W", "computed", "W1"), 2) == value(found, "W", "paper", "W1") == 0.20
    assert round(value(found, "W", "computed", "W2"), 2) == value(found, "W", "paper", "W2") == 0.26
    other = asked(question="energy", metal_share=0.3, metal_restitution=1.0, ball_restitution=0.5)
    assert value(other, "W", "computed", "W2") == pytest.approx(0.3 + 0.7 * 0.25)


def test_entry_angle_moves_the_travel() -> None:
    small, large = (asked(question="end", entry_angle_deg=angle) for angle in (5, 20))
    assert large["picture"]["elastic_travel_m"] > large["picture"]["travel_m"] > small["picture"]["travel_m"] > 0
    straight = asked(question="end", entry_angle_deg=0)
    assert straight["picture"]["travel_m"] == 0


def test_rod_held_at_its_end_has_its_percussion_centre_at_two_thirds() -> None:
    found = asked(question="percussion", rod_hands_in=0)
    assert found["picture"]["rod_percussion_m"] == pytest.approx(2 / 3 * found["bat"]["length_m"])
    zero = min(range(121), key=lambda i: abs(found["picture"]["rod_ratio"][i]))
    assert found["picture"]["position_m"][zero] == pytest.approx(2 / 3 * found["bat"]["length_m"], abs=0.01)


def test_corking_shows_both_forces() -> None:
    found = asked(question="corking", hole_depth_in=10)
    assert max(found["picture"]["corked_force_n"]) < max(found["picture"]["force_n"])


def test_thin_clamped_blocks_are_trampolines() -> None:
    thick, thin = (
        asked(question="drop", block_support=support, block_thickness_m=size)["picture"]["metal"]["rebound_m"]
        for support, size in (("floor", 0.1), ("clamped", 0.004))
    )
    assert thin > 1.3 * thick
    assert (
        asked(question="drop", block_support="clamped", block_thickness_m=0.001)["picture"]["wood"]["rebound_m"] is None
    )


@pytest.mark.parametrize(
    ("controls", "field", "words"),
    [
        ({"question": "corking", "bat": "russell-b6"}, "bat", "choose a solid wood bat"),
        ({"question": "corking", "hole_diameter_in": 2}, "hole_diameter_in", "make it narrower"),
        ({"question": "corking", "hole_fill": "feathers"}, "hole_fill", "not in the catalogue"),
        ({"hands_in": 12, "choke_up_in": 8}, "hands_in", "beyond the middle of the bat"),
    ],
)
def test_faults_name_their_control(controls: dict[str, Any], field: str, words: str) -> None:
    with pytest.raises(FieldError, match=words) as caught:
        asked(**controls)
    assert caught.value.field == field


def test_python_lines_give_the_same_numbers() -> None:
    state = PaperState(question="end", entry_angle_deg=25, bat_speed_mph=64)
    assert VIEW.recipe is not None
    lines = VIEW.recipe(state)
    names: dict[str, Any] = {}
    exec(lines["python"], names)
    shown = [row.computed for row in names["paper"].rows]
    expected = [row["computed"] for row in answer(state)["rows"]]
    assert shown[: len(expected)] == pytest.approx(expected)  # the paper begins with this question
    assert "--entry-angle 25deg" in lines["command"] and "--bat-speed 64mph" in lines["command"]


def test_the_command_line_gives_the_same_numbers(run_json: Callable[..., Any]) -> None:
    state = PaperState(question="drop", drop_height_m=2.0, block_support="clamped", block_thickness_m=0.01)
    assert VIEW.recipe is not None
    rows = run_json(*shlex.split(VIEW.recipe(state)["command"])[1:])["rows"]
    expected = [{key: value for key, value in row.items() if key != "words"} for row in answer(state)["rows"]]
    assert [row for row in rows if row["equation"] == "Fig. 6"] == expected


@pytest.mark.parametrize("question", PARTS)
def test_numbers_in_words_are_in_the_readers_units(question: str) -> None:
    """As they are told in the chain, or worked out anew; no text is searched for units."""
    rows = asked(question=question)["rows"]
    told = {system: " ".join(text for row in rows for text in row["words"][system].values()) for system in ("us", "si")}
    assert not re.search(r"\d (in|ft|mph)\b", told["si"])
    assert not re.search(r"\d (m|cm|m/s)\b", told["us"])
    corked = ("corked 1 in by 10 in" in told["us"], "corked 2.5 cm by 25.4 cm" in told["si"])
    assert corked == (question == "corking",) * 2


def test_no_hole_of_the_question_is_wider_than_the_bat() -> None:
    bounds = answer(PaperState(question="corking"))["bat"]["bounds"]
    widest = bounds["hole_diameter_in"][1]
    assert 1.5 < widest < 2
    assert answer(PaperState(question="corking", hole_diameter_in=widest))["rows"]

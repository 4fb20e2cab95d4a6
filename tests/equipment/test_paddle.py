"""Paddles: what mass and swing weight decide, and what is refused."""

from __future__ import annotations

import tomllib

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from sweetspot import beam_model, rigid_body
from sweetspot.catalog.files.read import implement_from_table
from sweetspot.catalog.files.write import implement_toml
from sweetspot.equipment.paddle import Paddle
from sweetspot.equipment.stretch import stretched
from sweetspot.errors import InputError
from tests.paddles import paddle

USUAL = "pickleball-paddle"
LEADED = """
like = "pickleball-paddle"

[[point_mass]]
position = "27.5 cm"
mass = "12 g"
beside = "9.5 cm"
"""


def test_it_weighs_and_swings_as_measured() -> None:
    tool = paddle()
    body = rigid_body(beam_model(tool))
    assert body.mass == pytest.approx(0.227) and body.moi(0.0508) == pytest.approx(117e-4)


@pytest.mark.parametrize("swing", [112e-4, 117e-4, 124.4e-4])
def test_twist_weight_follows(swing: float) -> None:
    """6 to 8 kg cm^2 are published [technicalpickleball_offcenter]; more mass at the rim twists less easily."""
    assert 6.8 < 1e4 * rigid_body(beam_model(paddle(moi=swing))).roll_moi < 8.2


@pytest.mark.parametrize(
    ("like", "twist"), [("pickleball-ruby", 7.9), ("pickleball-paddle", 7.338 + 1.083)], ids=["measured", "usual"]
)
def test_lead_at_three_and_nine(like: str, twist: float) -> None:
    """117 to 123 and 6.8 to 7.9 kg cm^2 by 12 g, with the twist weight measured before [technicalpickleball_offcenter].

    The other paddle's own twist weight follows; 12 g 9.5 cm beside the line add 1.083 (exact).
    """
    leaded = rigid_body(beam_model(implement_from_table(tomllib.loads(LEADED.replace(USUAL, like)), "leaded.toml")))
    assert 1e4 * leaded.moi(0.0508) == pytest.approx(123, abs=0.1)
    assert 1e4 * leaded.roll_moi == pytest.approx(twist, abs=0.05)


@given(st.floats(6.3e-4, 7.8e-4), st.floats(112e-4, 121e-4))
@settings(max_examples=20, deadline=None)
def test_a_measured_twist_weight_is_kept(twist: float, swing: float) -> None:
    """Exact: three measured numbers, three masses; mass and swing weight stay, and what twist weight says, too."""
    tool = paddle(twist_moi=twist, moi=swing)
    body = rigid_body(beam_model(tool))
    assert (body.mass, body.moi(0.0508), body.roll_moi) == pytest.approx((0.227, swing, twist), rel=1e-9)
    freed = tool.with_its_rim()
    assert freed.twist_moi is None and rigid_body(beam_model(freed)).roll_moi == pytest.approx(twist, rel=1e-9)


def test_twist_weight_of_a_file_counts_the_lead_and_follows_a_wider_head() -> None:
    """A file with lead says what was measured with it on; a parent's twist weight is that of its own head."""
    leaded = implement_from_table(
        tomllib.loads("twist_weight = 7.9\n" + LEADED.replace(USUAL, "pickleball-ruby")), "leaded.toml"
    )
    assert 1e4 * rigid_body(beam_model(leaded)).roll_moi == pytest.approx(7.9, abs=1e-6)
    narrow = implement_from_table({"like": "pickleball-ruby", "head_width": "7.3 in"}, "narrow.toml")
    assert 6.3e-4 < rigid_body(beam_model(narrow)).roll_moi < 6.7e-4
    longer = stretched(paddle(twist_moi=6.8e-4), 0.43)
    assert isinstance(longer, Paddle) and longer.twist_moi is None


def test_its_file_gives_it_again() -> None:
    tool = paddle()
    assert implement_from_table(tomllib.loads(implement_toml(tool)), "again.toml") == tool


def test_a_longer_one_keeps_its_handle() -> None:
    tool = paddle()
    longer = stretched(tool, 0.43)
    assert isinstance(longer, Paddle)
    assert longer.length == 0.43 and longer.handle_length == tool.handle_length
    assert longer.moi is not None and longer.moi == pytest.approx(117e-4 * (0.43 / tool.length) ** 2)


@pytest.mark.parametrize(
    ("changes", "words"),
    [
        ({"mass": 0.15}, "the rim of"),
        ({"moi": 150e-4}, "the handle, beyond its part of the plate"),
        ({"moi": None}, "needs mass and swing weight"),
        ({"balance_point": 0.25}, "follows from mass and swing weight"),
        ({"twist_moi": 12e-4}, "swing weight and twist weight"),
        ({"handle_length": 0.35}, "leave room for the face"),
        ({"corner_radius": 0.1}, "more than handle and two corners"),
    ],
)
def test_what_cannot_be_is_refused(changes: dict[str, object], words: str) -> None:
    with pytest.raises(InputError, match=words):
        paddle(**changes)

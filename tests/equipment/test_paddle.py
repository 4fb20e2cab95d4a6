"""Paddles: what mass and swing weight decide, and what is refused."""

from __future__ import annotations

import tomllib

import pytest

from sweetspot import beam_model, rigid_body
from sweetspot.catalog.files.read import implement_from_table
from sweetspot.catalog.files.write import implement_toml
from sweetspot.equipment.paddle import Paddle
from sweetspot.equipment.stretch import stretched
from sweetspot.errors import InputError
from tests.paddles import paddle

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


def test_lead_at_three_and_nine() -> None:
    """117 to 123 and +1.1 kg cm^2 by 12 g [technicalpickleball_offcenter]."""
    plain, leaded = (
        rigid_body(beam_model(tool)) for tool in (paddle(), implement_from_table(tomllib.loads(LEADED), "leaded.toml"))
    )
    assert 1e4 * leaded.moi(0.0508) == pytest.approx(123, abs=0.1)
    assert 1e4 * (leaded.roll_moi - plain.roll_moi) == pytest.approx(1.1, abs=0.05)


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
        ({"handle_length": 0.35}, "leave room for the face"),
        ({"corner_radius": 0.1}, "more than handle and two corners"),
    ],
)
def test_what_cannot_be_is_refused(changes: dict[str, object], words: str) -> None:
    with pytest.raises(InputError, match=words):
        paddle(**changes)

"""A paddle is calibrated by scale, swing weight, twist weight, stiffness of the face and tones."""

from __future__ import annotations

from pathlib import Path

import pytest

from sweetspot.answers.calibrate import CalibrateAnswer, CalibrateQuestion, calibrate_answer
from sweetspot.calibration.measured import Measured
from sweetspot.calibration.measurements import (
    FACE_TONE,
    TONES,
    Measurement,
    of_face_stiffness,
    of_tone,
    of_twist_weight,
    predicted,
)
from sweetspot.catalog.implements import load_implement
from sweetspot.dynamics.beam import beam_model
from sweetspot.dynamics.paddle_modes import bending_tone, face_stiffness, face_tone
from sweetspot.equipment.paddle import Paddle
from sweetspot.errors import InputError
from tests.paddles import paddle

MINE = paddle(mass=0.231, moi=0.0119, core_shear=9.6e6, rim_at_tip=1.3)
"""The paddle that was measured."""


def measured(*kinds: str) -> list[Measurement]:
    """Return measurements of that paddle, exact but with usual errors."""
    errors = {"mass": 5e-4, "moi": 5e-5, "twist_weight": 1e-5, "face_stiffness": 3e3}
    given = [
        Measurement(kind, Measured(1, error), axis=MINE.moi_axis)  # type: ignore[arg-type]
        for kind, error in errors.items()
        if kind in kinds
    ]
    given += [
        of_tone(Measurement("frequency", Measured(1, 2), mode=TONES[name]), MINE) for name in kinds if name in TONES
    ]
    values = predicted(beam_model(MINE), given).tolist()
    return [
        Measurement(
            each.kind, Measured(value, each.value.error), axis=each.axis, mode=each.mode, of_plate=each.of_plate
        )
        for each, value in zip(given, values, strict=True)
    ]


def calibrated(*kinds: str) -> CalibrateAnswer:
    return calibrate_answer(CalibrateQuestion(paddle(), measured(*kinds)))


def test_everything_together_gives_the_paddle_back() -> None:
    answer = calibrated("mass", "moi", "twist_weight", "face_stiffness", "face", "bending-1")
    assert answer.consistent
    known = answer.bat.by_name
    expected = {
        "mass": MINE.mass,
        "moi": MINE.moi,
        "core_shear": MINE.core_shear,
        "face_tone": face_tone(MINE),
        "face_stiffness": face_stiffness(MINE),
    }
    for name, value in expected.items():
        found = known[name].value
        assert abs(found.value - float(value or 0)) < 2 * found.error, name
    assert known["core_shear"].kind == "fitted"
    assert known["core_shear"].value.error / MINE.core_shear < 0.08
    assert "first_frequency" not in known


def test_what_was_not_measured_stays_in_doubt(tmp_path: Path) -> None:
    by_scale, by_tone = calibrated("mass", "moi").bat, calibrated("mass", "moi", "face").bat
    assert by_scale.core_shear is not None
    assert by_tone.core_shear is not None
    assert by_scale.core_shear.kind == "assumed"
    assert by_scale.core_shear.value.error / by_scale.core_shear.value.value == pytest.approx(0.3, rel=0.05)
    assert by_tone.core_shear.value.error < by_scale.core_shear.value.error / 3


def test_the_file_is_a_paddle_that_knows_what_it_is(tmp_path: Path) -> None:
    path = tmp_path / "mine.toml"
    path.write_text(calibrated("mass", "moi", "face").to_toml(), encoding="utf-8")
    again = load_implement(str(path))
    assert isinstance(again, Paddle)
    assert again.calibrated
    assert again.as_drawn().calibrated
    assert face_tone(again) == pytest.approx(face_tone(MINE), rel=0.02)


def test_stiffness_of_the_face_in_either_way_of_saying_it() -> None:
    # exact: 45 lbf for 1/16 in are 720 lbf/in, 126 kN/m
    assert of_face_stiffness("45lbf±1lbf").value.value == pytest.approx(126.1e3, rel=1e-3)
    assert of_face_stiffness("126kN/m±1kN/m").value.error == pytest.approx(1e3)
    assert of_twist_weight("7.2").value.value == pytest.approx(7.2e-4)


def test_a_bending_tone_is_the_plates() -> None:
    given = [Measurement("frequency", Measured(1, 1), mode=TONES["bending-1"])]
    assert predicted(beam_model(MINE), given)[0] == pytest.approx(bending_tone(MINE))
    assert TONES["face"] == FACE_TONE


def test_nothing_else_has_a_twist_weight(run) -> None:  # type: ignore[no-untyped-def]
    code, out, said = run("calibrate", "tennis-racket", "--twist-weight", "12")
    assert code == 2 and not out and "that of a paddle" in said
    with pytest.raises(InputError, match="not a moi"):
        of_twist_weight("7.2 m")

"""A paddle's core by a tap: sound, merely softer, or crushed."""

from __future__ import annotations

import pytest

from sweetspot import catalog
from sweetspot.analysis.certification.simulated_paddle_test import paddle_test
from sweetspot.answers import certify_paddle as paddle_rules
from sweetspot.answers.paddle_core import SURE, core_verdict
from sweetspot.calibration.paddle_core import CRUSHED, SHEAR_LEFT, CoreState, core_states, with_shear_left
from sweetspot.calibration.recording import BAT_BAND, synthesised
from sweetspot.calibration.tap_analysis import frame_modes
from sweetspot.calibration.taps import find_taps, tones_of
from sweetspot.dynamics.paddle_modes import Clamp, face_tone
from sweetspot.equipment.paddle import Paddle, SoftSpot
from tests.paddles import paddle

INCH = 0.0254


def heard(tapped: Paddle, described: Paddle) -> tuple[CoreState, ...]:
    """Return the states of a core by made-up taps in the middle of the face."""
    place = tapped.outline.middle
    sound = synthesised(frame_modes(tapped), position=place, listened=place)
    return core_states(tones_of(find_taps(sound, band=BAT_BAND)), described, positions=[place])


def crushed(states: tuple[CoreState, ...]) -> float:
    return sum(state.probability for state in states if state.shear_left < CRUSHED)


@pytest.mark.parametrize("radius", [0.045, 0.065, 0.085])
def test_a_quarter_of_the_shear_lowers_the_face_and_livens_the_ball(radius: float) -> None:
    # published: e_A 0.26 -> 0.35 when a core is crushed; a prototype of the plate has 0.34 to 0.39 at 50 mph and tones
    # lower by 13 to 40 %
    sound = paddle()
    soft = sound.replaced(soft_spot=SoftSpot(position=sound.length - 5 * INCH, radius=radius, factor=0.25))
    assert 0.6 < face_tone(soft) / face_tone(sound) < 0.87
    ball = catalog.ball("pickleball")
    slow = 50 / 60 * paddle_rules.TEST_SPEED
    test = paddle_test(soft, ball=ball, speed=slow, clamp=Clamp(axis=2 * INCH, reach=0.09, moi=12.15e-4))
    assert 0.33 < test.best_rebound < 0.41
    soft_test, sound_test = (paddle_rules.tested_as_by_the_rules(each, ball) for each in (soft, sound))
    assert soft_test.best_pbcor > sound_test.best_pbcor + 0.06


@pytest.mark.parametrize("shear", [6e6, 8e6, 11e6])
def test_a_paddle_that_is_softer_all_over_is_not_called_crushed(shear: float) -> None:
    states = heard(paddle(core_shear=shear), paddle())
    assert crushed(states) < 1 - SURE
    likeliest = max(states, key=lambda state: state.probability)
    assert likeliest.shear_left == 1.0
    assert likeliest.paddle.core_shear == pytest.approx(shear, rel=0.05)
    assert likeliest.face_tone == pytest.approx(face_tone(paddle(core_shear=shear)), rel=0.02)


def test_a_crushed_core_is_found_and_is_over_the_limit() -> None:
    described = paddle()
    states = heard(with_shear_left(described, 0.25), described)
    assert [state.shear_left for state in states] == list(SHEAR_LEFT)
    assert sum(state.probability for state in states) == pytest.approx(1.0)
    core = core_verdict(states, described)
    assert core.verdict == "crushed"
    assert float(core.over_limit_probability or 0) > 0.9
    assert float(core.face_tone) == pytest.approx(face_tone(with_shear_left(described, 0.25)), rel=0.02)
    assert [float(each.pbcor) for each in core.softening] == sorted(float(each.pbcor) for each in core.softening)
    assert [float(each.face_tone) for each in core.softening] == sorted(
        (float(each.face_tone) for each in core.softening), reverse=True
    )


def test_a_tap_of_the_new_paddle_makes_the_verdict_surer() -> None:
    tapped = with_shear_left(paddle(), 0.35)
    open_before, sure_after = crushed(heard(tapped, paddle())), crushed(heard(tapped, paddle(calibrated=True)))
    assert sure_after > SURE > open_before

"""What is asked of one's own bats: outline, tap, calibration and ranking, each as dictionary, frame and page."""

from __future__ import annotations

from dataclasses import replace

import pytest

from sweetspot import catalog
from sweetspot.answers.answer import Answer
from sweetspot.answers.calibrate import CalibrateQuestion, calibrate_answer
from sweetspot.answers.outline import OutlineQuestion, bat_of_outline, outline_answer
from sweetspot.answers.rank import RankQuestion, rank_answer
from sweetspot.answers.tap import TapQuestion, tap_answer
from sweetspot.calibration.measured import Measured
from sweetspot.calibration.measurements import Measurement
from sweetspot.calibration.outline.measured_outline import MeasuredOutline
from sweetspot.calibration.recording import synthesised
from sweetspot.calibration.tap_analysis import frame_modes
from sweetspot.catalog.standard_hit import standard_conditions
from sweetspot.equipment.bat import Bat
from sweetspot.errors import InputError
from sweetspot.units import INCH, OUNCE

MASS = Measurement("mass", Measured(31.0 * OUNCE, 0.05 * OUNCE))
BALANCE = Measurement("balance_point", Measured(22.05 * INCH, 0.05 * INCH))


def page_of(answer: Answer) -> str:
    """Return the page of an answer, which has a frame of one row too."""
    assert answer.to_frame("us").height == 1
    return answer._repr_html_()


def test_an_outline_says_what_it_would_weigh(r161: Bat) -> None:
    assert r161.profile is not None
    outline = MeasuredOutline(r161.profile)
    answer = outline_answer(OutlineQuestion(outline, bat_of_outline(outline, material=r161.material, name="mine")))
    table = answer.to_dict("us")
    assert table["length_in"] == pytest.approx(33.0) and table["profile"]["diameter_in"][-1] > 0
    assert "mine" in page_of(answer)


def test_a_tap_gives_what_a_calibration_takes(r161: Bat) -> None:
    place = r161.length - INCH
    sound = synthesised(frame_modes(r161), position=place, listened=place, taps=1)
    tapped = tap_answer(TapQuestion([sound], r161, [place]))
    assert [tap.used for tap in tapped.taps] == [True]
    assert {"frequency_hz", "frequency_error_hz", "frequency_low_hz"} <= tapped.to_dict()["tones"][0].keys()
    assert "Tones" in page_of(tapped)
    question = CalibrateQuestion(r161, [MASS, BALANCE, *tapped.measurements], damping=tapped.damping)
    answer = calibrate_answer(question)
    mass = answer.to_dict("us")["bat"]["mass"]
    assert answer.consistent and mass["kind"] == "measured" and mass["mass_oz"] == pytest.approx(31.0, abs=0.1)
    assert answer.bat.longitudinal_modulus is not None and answer.bat.longitudinal_modulus.kind == "fitted"
    assert "calibrated" in answer.to_toml() and "What the measurements changed" in page_of(answer)
    assert len(calibrate_answer(replace(question, left_out=["mass"])).measurements) == len(answer.measurements) - 1
    with pytest.raises(InputError, match="'weight' cannot be left out"):
        calibrate_answer(replace(question, left_out=["weight"]))


def test_a_contradiction_has_its_suspects_and_no_bat(r161: Bat) -> None:
    wrong = replace(BALANCE, value=Measured(22.05 / 100, 0.001))
    answer = calibrate_answer(CalibrateQuestion(r161, [wrong]))
    assert answer.to_dict()["bat"] == {} and not answer.unknowns
    (suspect,) = answer.suspects
    assert suspect.should == pytest.approx(22.05 * INCH, abs=5e-3)
    assert [slip.words for slip in suspect.meant] == ["inches and not centimetres"]
    with pytest.raises(InputError, match="contradict"):
        answer.to_toml()


def test_bats_are_ranked(r161: Bat) -> None:
    bats = {
        name: [MASS, replace(BALANCE, value=Measured(inches * INCH, 0.001))]
        for name, inches in (("A", 22.0), ("B", 22.2))
    }
    question = RankQuestion(r161, bats, standard_conditions(r161), catalog.swing_law())
    counts: list[tuple[int, int]] = []
    answer = rank_answer(question, step=lambda count, of: counts.append((count, of)))
    assert counts == [(1, 2), (2, 2)]
    assert {bat.name for bat in answer.ranked} == {"A", "B"} and not answer.unranked
    assert answer.to_dict("us")["bats"][0]["properties"]["mass"]["kind"] == "measured"
    assert "of being the best of 2" in page_of(answer)

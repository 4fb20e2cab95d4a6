"""What of a gain can be seen."""

from __future__ import annotations

import numpy as np
import pytest

from sweetspot.analysis.certification.rules import Verdict
from sweetspot.catalog.rules import league
from sweetspot.design.answer import Designed, designed, told
from sweetspot.design.batter import FROM_TIP
from sweetspot.design.fronts import Question
from sweetspot.design.gain import gain_of, present_measured
from sweetspot.design.limits import Limit
from sweetspot.design.measures import Bench
from sweetspot.equipment.bat import Bat
from sweetspot.errors import InputError
from sweetspot.report.design.document import design_document
from sweetspot.report.quantities import US
from sweetspot.report.sentences import read
from sweetspot.units import INCH
from tests.design.conftest import met_at


@pytest.fixture(scope="module")
def design(bench: Bench, limits: tuple[Limit, ...]) -> Designed:
    there = met_at(bench, 8.0)
    question = Question(("exit_speed", "zone"), limits, population=12, generations=1)
    return told(there, question, designed(there, question), pick=1, league=league("mlb"))


def test_the_present_bat_gains_nothing_over_itself(bench: Bench) -> None:
    now = present_measured(bench)
    gain = gain_of(bench, bench.space.start, now, now)
    assert gain.expected == pytest.approx(0.0, abs=1e-12)
    assert not gain.seen
    assert gain.doubt > 0.2  # m/s: wood alone


def test_a_torpedo_for_who_meets_the_ball_inside(design: Designed) -> None:
    gain = design.gain
    assert gain.seen and gain.shift > 0.3 * INCH
    assert gain.at(2 * INCH) < 0 < gain.at(8 * INCH)
    assert gain.turning_place is not None and 4 * INCH < gain.turning_place < 7 * INCH
    assert gain.by_weight < gain.wood
    assert gain.curve.shape == gain.noise.shape == FROM_TIP.shape
    assert all(check.verdict is not Verdict.FAIL for check in design.checks)


def test_shift_and_width_come_before_the_maximum(design: Designed) -> None:
    document = design_document(design)
    text = read(document.blocks[0].words, US)  # type: ignore[union-attr]
    assert text.index("best place moves") < text.index("zone") < text.index("greatest exit speed")
    warning = read(document.blocks[2].words, US)  # type: ignore[union-attr]
    assert "should not use it" in warning
    assert isinstance(design.bat, Bat)
    files = {name: make(US) for name, make in document.attachments.items()}
    assert set(files) == {
        "search.json",
        "designed-bat.toml",
        "designed-bat.svg",
        "designed-bat.dxf",
        "designed-bat.csv",
    }
    assert document.data["gain"]["seen"] is True
    assert len(document.rows["exit_speed_m_s"]) == len(design.front)
    assert np.isfinite(document.data["measures"]["exit_speed_m_s"])


def test_a_bat_that_is_not_on_the_front_is_refused(design: Designed) -> None:
    with pytest.raises(InputError, match="bat 999 of the front"):
        told(design.bench, design.question, design.front, pick=999, league=None)

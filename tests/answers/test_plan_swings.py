"""An experiment with a player: the sheet that is printed is read back, and says stop or go on."""

from __future__ import annotations

import csv
from pathlib import Path

import numpy as np
import pytest

from sweetspot import catalog
from sweetspot.answers.plan_swings import PlanSwingsAnswer, PlanSwingsQuestion, plan_swings_answer
from sweetspot.equipment.bat import Bat
from sweetspot.errors import InputError
from sweetspot.player.planning import leaded
from sweetspot.player.prior import NAMES, natural
from sweetspot.reports.player.plan import HEADINGS, lead_words, plan_document, sheet_csv
from sweetspot.reports.quantities import US
from sweetspot.reports.sentences import read
from sweetspot.units import INCH, MPH, OUNCE

OWN = catalog.bat("r161-ash")


def question(**changes: object) -> PlanSwingsQuestion:
    given = {"bats": (OWN,), "aim": "exponent", "within": 0.09, "bat_speed_spread": 2 * MPH} | changes
    return PlanSwingsQuestion(**given)  # type: ignore[arg-type]


def filled(answer: PlanSwingsAnswer, path: Path, exponent: float, *, seed: int) -> Path:
    """Fill the sheet of an answer with the speeds of a player with this exponent, behind those already in the file."""
    random = np.random.default_rng(seed)
    rows = list(csv.DictReader(sheet_csv(answer).decode().splitlines()))
    moments = {bat.name: float(bat.moi_6in) for bat in answer.bats}
    for row in rows:
        mean = 66 * (moments[row["bat"]] / moments[OWN.name]) ** -exponent
        row["bat_speed_mph"] = f"{mean + 2 * random.standard_normal():.1f}"
    earlier = list(csv.DictReader(path.read_text(encoding="utf-8").splitlines())) if path.exists() else []
    with path.open("w", encoding="utf-8", newline="") as file:
        writer = csv.DictWriter(file, HEADINGS)
        writer.writeheader()
        writer.writerows([*earlier, *rows])
    return path


def test_the_sheet_has_a_row_for_every_swing() -> None:
    answer = plan_swings_answer(question())
    rows = list(csv.DictReader(sheet_csv(answer).decode().splitlines()))
    assert [row["bat"] for row in rows] == list(answer.order) and tuple(rows[0]) == HEADINGS
    assert [int(row["swing"]) for row in rows] == list(range(1, len(rows) + 1))
    assert sum(bat.swings for bat in answer.bats) == len(rows) == answer.further
    assert answer.verdict == "swing" and answer.expected_error <= answer.within
    assert read(lead_words(answer), US).startswith(f"{len(rows)} swings with R161, white ash and R161, white ash with")


def test_swings_go_on_until_the_error_is_small_enough(tmp_path: Path) -> None:
    """The sheet is filled batch by batch: it asks for more, then says stop; bats are known by their names in it."""
    answer, verdicts = plan_swings_answer(question()), []
    sheet = tmp_path / "sheet.csv"
    for number in range(8):
        answer = plan_swings_answer(question(filled=filled(answer, sheet, 0.2, seed=number), batch=10))
        verdicts.append(answer.verdict)
        assert not isinstance(answer.estimate, float) and answer.estimate is not None
        assert (answer.estimate.high - answer.estimate.low <= 2 * answer.within) == (answer.verdict == "stop")
        if answer.verdict == "stop":
            break
        assert 0 < len(answer.order) <= 10 and read(lead_words(answer), US).startswith("Go on: after ")
    assert verdicts[-1] == "stop" and answer.order == () and read(lead_words(answer), US).startswith("Stop: after ")
    assert not plan_document(answer).attachments


def test_few_swings_of_a_plan_go_on(tmp_path: Path) -> None:
    first = plan_swings_answer(question(within=0.05, bats=(OWN, leaded(OWN, 6 * OUNCE))))
    sheet = filled(first, tmp_path / "sheet.csv", 0.2, seed=1)
    sheet.write_text("\n".join(sheet.read_text(encoding="utf-8").splitlines()[:11]), encoding="utf-8")
    answer = plan_swings_answer(question(within=0.05, bats=(OWN, leaded(OWN, 6 * OUNCE)), filled=sheet))
    assert answer.verdict == "go on" and answer.swings_made == 10


def test_what_is_known_of_any_player_and_what_cannot_be_found() -> None:
    known = plan_swings_answer(question(within=0.2))
    assert known.verdict == "known" and known.order == ()
    alike = (OWN, OWN.weighted(position=OWN.length - INCH, mass=0.2 * OUNCE).replaced(name="alike"))
    never = plan_swings_answer(question(bats=alike, lead=False))
    assert never.verdict == "too many" and never.order == () and never.expected_error > never.within
    assert read(lead_words(never), US).startswith("These bats cannot find")


@pytest.mark.parametrize(
    ("changes", "message"),
    [({"bats": ()}, "no bat was given"), ({"within": -1.0}, "allowed is above 0"), ({"batch": 0}, "from 1 up")],
)
def test_what_no_plan_can_be_made_of(changes: dict[str, tuple[Bat, ...] | float], message: str) -> None:
    with pytest.raises(InputError, match=message):
        plan_swings_answer(question(**changes))


def test_the_place_is_found_from_marks(tmp_path: Path) -> None:
    """The mean of the marks, to about their standard error; within the error that was asked for."""
    asked = question(aim="position", within=0.5 * INCH)
    answer = plan_swings_answer(asked)
    random = np.random.default_rng(4)
    rows = list(csv.DictReader(sheet_csv(answer).decode().splitlines()))
    marks = 5.2 + 1.2 * random.standard_normal(len(rows))
    speeds = 66 + random.standard_normal(len(rows))
    lines = [f'{row["swing"]},"{row["bat"]}"' for row in rows]
    lines = [f"{line},{speed:.1f},,,{mark:.1f}" for line, speed, mark in zip(lines, speeds, marks, strict=True)]
    sheet = tmp_path / "sheet.csv"
    sheet.write_text("\n".join([",".join(HEADINGS), *lines]), encoding="utf-8")
    found = plan_swings_answer(question(aim="position", within=0.5 * INCH, filled=sheet))
    assert found.verdict == "stop" and found.estimate is not None
    assert float(found.estimate) / INCH == pytest.approx(marks.mean(), abs=0.15)


def test_the_prior_is_what_is_usual() -> None:
    assert (
        question(bat_speed_spread=None).scatter.bat_speed_spread
        == natural(np.zeros(10))[NAMES.index("bat_speed_spread")]
    )

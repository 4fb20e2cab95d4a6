"""A measuring day: the sheet asks for what the table's reader knows, and what comes back is the truth."""

from __future__ import annotations

import csv
import warnings
from pathlib import Path

import numpy as np
import pytest
import segno

import sweetspot
from sweetspot import catalog
from sweetspot.answers.calibrate import CalibrateQuestion, calibrate_answer
from sweetspot.answers.kit import MOST_PIECES
from sweetspot.calibration.bat_table import check_same_model, expected_values, read_bat, read_bats
from sweetspot.dynamics.rigid import rigid_body
from sweetspot.equipment.bat import Bat
from sweetspot.errors import InputError
from sweetspot.reports.kit import kit_document, sheet_csv, sheet_html
from sweetspot.reports.quantities import SYSTEMS, System
from sweetspot.tables.vocabulary import UNITS, quantities
from tools.tutorial_files import DAY, differing, measured

CALIBRATED = (
    "r161-ash",
    "college-alloy",
    "corked-r161",
    "tennis-racket",
    "cricket-bat",
    "golf-driver",
    "hockey-stick",
    "pickleball-paddle",
)


@pytest.mark.parametrize("system", ["us", "si"])
@pytest.mark.parametrize("name", CALIBRATED)
def test_the_sheet_asks_for_what_the_table_reader_knows(name: str, system: System, tmp_path: Path) -> None:
    """Filled with what is expected of the model it is read without a word, and is that model."""
    asked = sweetspot.kit(name, pieces=2)
    empty = list(csv.reader(sheet_csv(asked, SYSTEMS[system]).splitlines()))
    assert [row[0] for row in empty] == ["name", "No 1", "No 2"]
    texts = []
    for heading, field in zip(empty[0][1:], asked.fields, strict=True):
        unit = UNITS[quantities()[field.quantity].kind][heading.removeprefix(f"{field.quantity}_")]
        texts.append(f"{field.expected / unit:.6g}")
    table = tmp_path / "measured.csv"
    table.write_text("\n".join(",".join(row) for row in (empty[0], ["a", *texts], ["b", *texts])) + "\n")
    model = catalog.implement(name).as_drawn()
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        bats = read_bats(table, axis=model.swing_axis, sport=model.sport)
    check_same_model(bats, model, axis=model.swing_axis)
    assert len(bats["a"]) == len([field for field in asked.fields if field.quantity != "moisture"])
    expected = expected_values(model, axis=model.swing_axis)
    for measurement in bats["a"]:
        mode, kind = measurement.mode, {"period": "pendulum"}.get(measurement.kind, measurement.kind)
        column = f"{mode.family}_{mode.harmonic}" if mode else kind
        own = expected.get(column, measurement.value.value)  # of hoop modes there is none
        assert measurement.value.value == pytest.approx(own, rel=1e-5)


def test_the_page_has_every_field_once_and_the_table_as_a_code() -> None:
    asked = sweetspot.kit("r161-ash", pieces=3)
    page = sheet_html(asked, SYSTEMS["us"])
    headings = sheet_csv(asked, SYSTEMS["us"]).splitlines()[0].split(",")[1:]
    assert [page.count(f'data-heading="{heading}"') for heading in headings] == [3] * len(headings)
    code = segno.make(f"name,{','.join(headings)}\nNo 1\nNo 2\nNo 3", error="m", micro=False)
    assert code.svg_inline(omitsize=True, border=4, svgclass="code") in page
    document = kit_document(asked)
    assert list(document.attachments) == ["sheet.html", "measured.csv", "bat.toml"]
    as_file = document.attachments["bat.toml"](SYSTEMS["us"]).decode()
    assert 'name = "R161, white ash"' in as_file


def test_more_pieces_than_a_code_holds_and_kinds_that_are_not_calibrated() -> None:
    with pytest.raises(InputError, match="allowed is 1 to 40"):
        sweetspot.kit("r161-ash", pieces=MOST_PIECES + 1)
    with pytest.raises(InputError, match="known by its plies"):
        sweetspot.kit("table-tennis-racket")


def test_the_truth_lies_inside_the_intervals(tmp_path: Path) -> None:
    """Eight made-up bats with the instruments' errors: of weight, balance, MOI and E at 90 % most of 32 (binomial)."""
    model = catalog.bat("r161-ash")
    rows, truths = [], {}
    for number in range(1, 9):
        beam = differing(model, number, by=0.7)
        mass, balance, period, *tones = measured(beam, DAY, 100 + number)
        rows.append(f"No {number},{1e3 * mass:.1f},{1e3 * balance:.1f},{20 * period:.2f},{tones[0]:.1f},{tones[1]:.1f}")
        body = rigid_body(beam)
        assert isinstance(beam.bat, Bat)
        truths[f"No {number}"] = {
            "mass": body.mass,
            "balance_point": body.balance_point,
            "moi": body.moi(model.swing_axis),
            "longitudinal_modulus": beam.bat.material.longitudinal_modulus,
        }
    table = tmp_path / "measured.csv"
    table.write_text(
        "\n".join(["name,mass_g,balance_point_mm,twenty_swings_s,bending_1_hz,bending_2_hz", *rows]) + "\n"
    )
    held = []
    for name, truth in truths.items():
        readings = read_bat(table, model, name=name, axis=model.swing_axis)
        found = calibrate_answer(CalibrateQuestion(model, readings))
        assert found.consistent
        known = found.bat.by_name
        held += [known[what].value.low < value < known[what].value.high for what, value in truth.items()]
    assert np.mean(held) >= 0.78  # of 32 at 90 % each, fewer than one run in a hundred has less

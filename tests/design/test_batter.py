"""Whom a bat is for."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

from sweetspot.design.batter import FROM_TIP, contacts_of_file, fitted_player, normal_contact
from sweetspot.errors import InputError
from sweetspot.units import INCH


def test_contacts_around_a_place() -> None:
    weight = normal_contact(6.5 * INCH, 1.5 * INCH)
    assert weight.sum() == pytest.approx(1.0)
    assert weight @ FROM_TIP == pytest.approx(6.5 * INCH, abs=0.01 * INCH)
    with pytest.raises(InputError, match="contact is"):
        normal_contact(-1.0 * INCH, INCH)
    with pytest.raises(InputError, match="contacts spread"):
        normal_contact(6 * INCH, 0.0)


def test_a_table_of_contacts(tmp_path: Path) -> None:
    file = tmp_path / "contacts.csv"
    file.write_text("from_tip_in,weight\n5.25,1\n8.25,3\n", encoding="utf-8")
    assert contacts_of_file(file) @ FROM_TIP == pytest.approx(7.5 * INCH)


def test_one_batter_of_a_seasons_table(tmp_path: Path) -> None:
    """Lines without a place are left out, those of others too."""
    file = tmp_path / "balls.csv"
    file.write_text("batter,from_tip_in\n7,5.25\n9,2.0\n7,\n7,8.25\n", encoding="utf-8")
    assert contacts_of_file(file, batter="7") @ FROM_TIP == pytest.approx(6.75 * INCH)
    with pytest.raises(InputError, match="2 batters; name one of them by --batter: 7"):
        contacts_of_file(file)
    with pytest.raises(InputError, match="no contact of the batter '8'"):
        contacts_of_file(file, batter="8")
    file.write_text("from_tip_in\n5\n", encoding="utf-8")
    with pytest.raises(InputError, match="no column batter"):
        contacts_of_file(file, batter="7")


@pytest.mark.parametrize(
    ("text", "fault"),
    [
        ("", "holds no contact"),
        ("from_tip_in\n", "holds no contact"),
        ("place\n5\n", "name one of them from_tip_in"),
        ("from_tip_in\nfive\n", "line 2: 'five' was given"),
        ("from_tip_in\n55\n", "no contact on the outer 13 in"),
        ("from_tip_in,weight\n5,0\n", "no contact on the outer 13 in"),
    ],
)
def test_tables_that_are_none(tmp_path: Path, text: str, fault: str) -> None:
    file = tmp_path / "contacts.csv"
    file.write_text(text, encoding="utf-8")
    with pytest.raises(InputError, match=fault):
        contacts_of_file(file)


def test_a_fitted_player(tmp_path: Path) -> None:
    file = tmp_path / "player.json"
    parameters = {name: {"value_m": 0.1 + number} for number, name in enumerate(
        ("position", "position_spread", "offset", "offset_spread"))}  # fmt: skip
    parameters["bat_speed"] = {"value_m_s": 31.0}
    file.write_text(json.dumps({"parameters": parameters, "pitch_speed_m_s": 38.0}), encoding="utf-8")
    found = fitted_player(file)
    assert found["position"] == pytest.approx(0.1) and found["bat_speed"] == 31.0 and found["pitch_speed"] == 38.0
    file.write_text("{}", encoding="utf-8")
    with pytest.raises(InputError, match="not an answer of sweetspot fit-player"):
        fitted_player(file)
    assert np.all(np.diff(FROM_TIP) > 0)

"""Whom a bat is for."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest
from scipy.special import ndtri

from sweetspot import catalog
from sweetspot.designs.batter import FROM_TIP, contacts_at, fitted_contact, known_contact, normal_contact
from sweetspot.designs.batter_files import contacts_of_file, fitted_player, law_of_player
from sweetspot.errors import InputError
from sweetspot.numerics.interval import LEVEL, REACH
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
    file.write_text("from_tip_in,weight\n5.25,1000\n8.25,3000\n", encoding="utf-8")
    found = contacts_of_file(file)
    assert found.balls == 4000 and found.mean == pytest.approx(7.5 * INCH, abs=0.01 * INCH)
    file.write_text("from_tip_in,weight\n5.25,0.25\n8.25,0.75\n", encoding="utf-8")
    assert contacts_of_file(file).balls == pytest.approx(1.6)  # shares say nothing of how many balls there were


@pytest.mark.parametrize("count", [1, 3, 30])
def test_what_balls_leave_open_is_the_posterior(count: int) -> None:
    """By brute force: means 6.5 +- 1 in, scatters 1.8 in times exp(+- 0.4), marks half an inch wide."""
    place = 8.0 + 1.2 * ndtri((np.arange(count) + 0.5) / count)
    mean, log = np.meshgrid(np.linspace(0.1, 13, 261), np.linspace(np.log(1.8) - 2, np.log(1.8) + 2, 161))
    seen = np.exp(2 * log) + 0.5**2
    density = -((mean - 6.5) ** 2) / 2 - ((log - np.log(1.8)) / 0.4) ** 2 / 2
    density -= count / 2 * np.log(seen) + sum((one - mean) ** 2 for one in place) / (2 * seen)
    likely = np.exp(density - density.max())
    likely /= likely.sum()
    middle = (likely * mean).sum()
    found = contacts_at(place * INCH)
    means = found.possible @ FROM_TIP / INCH
    assert found.likely @ means == pytest.approx(middle, abs=0.05)  # cut at the bat's tip
    assert found.mean_doubt / INCH == pytest.approx(np.sqrt((likely * (mean - middle) ** 2).sum()), rel=0.08)
    assert found.balls == count and found.weight.sum() == pytest.approx(1.0)


def test_a_fit_brings_its_own_doubt() -> None:
    found = fitted_contact((7 * INCH, 0.4 * INCH), (1.5 * INCH, 0.2), balls=40)
    assert found.mean == pytest.approx(7 * INCH, abs=0.05 * INCH)
    assert found.mean_doubt == pytest.approx(0.4 * INCH, rel=0.05)
    assert found.spread == pytest.approx(1.5 * INCH, rel=0.06)
    assert known_contact(7 * INCH, 1.5 * INCH).mean_doubt == 0


@pytest.mark.parametrize(
    "text",
    [
        "From tip (in)\n7\n7\n",
        "from_tip_cm;weight\n17,78;2\n",
        "from tip\n7 in\n177.8mm\n",
        "\ufefffrom_tip_in\n7\n\n7\n",
    ],
)
def test_headings_and_values_with_their_units(tmp_path: Path, text: str) -> None:
    file = tmp_path / "contacts.csv"
    file.write_text(text, encoding="utf-8")
    assert contacts_of_file(file).mean == pytest.approx(contacts_at(np.full(2, 7 * INCH)).mean, abs=1e-9)


def test_contacts_beside_the_bat_are_refused() -> None:
    with pytest.raises(InputError, match=r"50% of contacts .+ lie beyond the outer 13 in"):
        normal_contact(13 * INCH, 1.8 * INCH)
    assert normal_contact(1.0 * INCH, 0.5 * INCH).sum() == pytest.approx(1.0)


def test_one_batter_of_a_seasons_table(tmp_path: Path) -> None:
    """Lines without a place are left out, those of others too."""
    file = tmp_path / "balls.csv"
    file.write_text("batter,from_tip_in\n7,5.25\n9,2.0\n7,\n7,8.25\n", encoding="utf-8")
    found = contacts_of_file(file, batter="7")
    assert found.balls == 2 and 6.5 * INCH < found.mean < 6.75 * INCH
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
        ("from_tip_in\nfive\n", "line 2: from_tip was given as 'five'"),
        ("from_tip_in\n55\n", "line 2: 55 was given, 1.397 m .55 in. from the tip; .+ check the unit"),
        ("from_tip_in\n25\n", "no contact on the outer 13 in"),
        ("from_tip_in\n6,5\n", "line 2 has 2 values for 1 columns; write decimals with a point"),
        ("from_tip_in,weight\n5,1\n6,-1\n", "line 3: the weight -1 was given"),
        ("from tip\n6\n", "line 2: from_tip was given as 6 without a unit"),
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
    parameters = {
        name: {"value_m": 0.1 + number}
        for number, name in enumerate(("position", "position_spread", "offset", "offset_spread"))
    }
    parameters["bat_speed"] = {"value_m_s": 31.0}
    parameters["exponent"] = {"value": 0.35, "low": 0.3, "high": 0.4}
    file.write_text(json.dumps({"parameters": parameters, "pitch_speed_m_s": 38.0}), encoding="utf-8")
    found = fitted_player(file)
    assert found["position"] == pytest.approx(0.1) and found["bat_speed"] == 31.0 and found["pitch_speed"] == 38.0
    parameters["position"] |= {"low_m": 0.06, "high_m": 0.14}
    for level, reach in ({"interval_level": LEVEL}, REACH), ({}, 1.959964):  # 0.1 wrote 95 % and did not say so
        file.write_text(json.dumps({"parameters": parameters, "pitch_speed_m_s": 38.0} | level), encoding="utf-8")
        assert fitted_player(file)["position_doubt"] == pytest.approx(0.04 / reach, rel=1e-6)
    law = law_of_player(catalog.swing_law(), found)
    assert law.exponent == 0.35 and law.exponent_spread == pytest.approx(0.05 / 1.959964, rel=1e-6)
    file.write_text("{}", encoding="utf-8")
    with pytest.raises(InputError, match="not what fit-player writes: it has no parameters"):
        fitted_player(file)
    assert np.all(np.diff(FROM_TIP) > 0)

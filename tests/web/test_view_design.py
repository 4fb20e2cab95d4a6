"""Design: what is locked stays while a number is pulled, rules and gains beside it, files, and who is refused."""

from __future__ import annotations

import json
from typing import Any

import httpx
import numpy as np
import pytest

from sweetspot.designs.gain import GainVerdict
from sweetspot.units import INCH
from sweetspot.web.bats import bat_from_text, described
from sweetspot.web.controls import BatState

URL = "/api/v1/design"


def asked(client: httpx.Client, path: str = "", **fields: Any) -> dict[str, Any]:
    response = client.post(f"{URL}{path}", json=fields)
    assert response.status_code == 200, response.text
    return dict(response.json())


def measure(answer: dict[str, Any], name: str) -> dict[str, Any]:
    return next(one for one in answer["measures"] if one["name"] == name)


@pytest.fixture
def pulled(client: httpx.Client) -> dict[str, Any]:
    """The numbers of the first bat with the eighth handle 5 % thicker, as fields."""
    first = asked(client)
    numbers = [one["value"] for one in first["variables"]]
    numbers[7] *= 1.05
    return {"design_si": numbers, "design_for": first["key"], "pulled": 7}


def test_the_first_answer_is_the_present_bat(client: httpx.Client) -> None:
    answer = asked(client)
    assert not answer["shaped"] and len(answer["design"]["stations"]) == 11
    assert {one["change"] for one in answer["measures"] if one["change"] is not None} == {0.0}
    assert set(answer["curves"]["difference_m_s"]) == {0.0}
    assert answer["design"]["outline"] == answer["present"]["outline"]
    assert asked(client, "/gain")["expected_m_s"] == 0.0
    handles = {**{"design_si": [one["value"] for one in answer["variables"]], "design_for": answer["key"]}}
    smooth = measure(asked(client, **handles), "exit_speed")
    assert abs(smooth["change"]) < 0.05  # m/s: eleven handles say what the bat's stations did
    assert all(one["holds"] for one in answer["locks"] + answer["limits"])
    assert {one["verdict"] for one in answer["rules"]} <= {"pass", "not decidable", "does not apply"}


def test_what_is_locked_stays_and_what_is_pulled_stays_pulled(client: httpx.Client, pulled: dict[str, Any]) -> None:
    free = asked(client, **pulled, keep_mass=False, keep_moi=False)
    kept = asked(client, **pulled)
    assert measure(free, "mass")["change"] > 0.011  # kg
    for name in ("mass", "moi"):
        assert abs(measure(kept, name)["change"]) <= 0.0101 * measure(kept, name)["present"]
    assert kept["variables"][7]["value"] == pytest.approx(pulled["design_si"][7], rel=2e-3)
    assert all(one["holds"] for one in kept["locks"])
    tight = asked(client, **{**pulled, "design_si": [one["high"] for one in free["variables"]]}, keep_balance=True)
    assert all(one["holds"] for one in tight["locks"])


def test_numbers_of_another_bat_are_left_out(client: httpx.Client, pulled: dict[str, Any]) -> None:
    assert asked(client, **pulled)["shaped"]
    assert not asked(client, **pulled, bat="mlb-a")["shaped"]
    hollow = asked(client, bat="single-wall")
    assert hollow["design"]["stations"] == [] and len(hollow["variables"]) == 5
    assert any(one["title"] == "BBCOR" and one["verdict"] == "fail" for one in hollow["rules"])
    assert asked(client, bat="corked-r161")["left_out"]


def test_a_rule_that_is_broken_is_a_red_light(client: httpx.Client, pulled: dict[str, Any]) -> None:
    thick = [*pulled["design_si"]]
    thick[9] = 2.75 * INCH
    answer = asked(client, **{**pulled, "design_si": thick, "pulled": 9}, keep_mass=False, keep_moi=False)
    assert next(one for one in answer["rules"] if one["quantity"] == "diameter")["verdict"] == "fail"
    assert asked(client, **pulled, league="none")["rules"] == []


def test_a_gain_stands_beside_what_wood_differs(client: httpx.Client, pulled: dict[str, Any]) -> None:
    found = asked(client, "/gain", **pulled)
    assert found["expected_m_s"] < found["likely_from_m_s"] < found["half_interval_m_s"] < found["seen_from_m_s"]
    assert GainVerdict.HIDDEN in found["sentences"]["us"][1]
    assert found["gained"]["us"][0].endswith(f"(90 %): {GainVerdict.HIDDEN}.")
    high, low = np.array(found["noise_high_m_s"]), np.array(found["noise_low_m_s"])
    assert np.all(high > 0) and np.allclose(high, -low)
    assert found["expected_m_s"] == pytest.approx(measure(asked(client, **pulled), "exit_speed")["change"], abs=1e-6)
    assert "mph" not in " ".join(found["sentences"]["si"]).replace("within 3 mph", "")  # which is what a zone is


def test_the_files_are_the_bat(client: httpx.Client, pulled: dict[str, Any]) -> None:
    found = asked(client, "/files", **pulled)
    facts = client.post("/api/v1/bat", json={"toml": found["toml"]}).json()
    assert facts["mass_kg"] == pytest.approx(asked(client, **pulled)["design"]["mass_kg"], rel=1e-4)
    assert found["us"]["svg"].startswith("<") and "SECTION" in found["us"]["dxf"] and "," in found["si"]["csv"]
    command = asked(client, "/recipe", **pulled, league="ncaa")["command"]
    assert command.startswith("sweetspot design r161-ash --want exit-speed --want zone --keep mass --keep moi")
    assert "--league ncaa" in command
    changed = asked(client, "/recipe", weight_oz=1.0, mass_oz=30.3)
    assert bat_from_text(changed["toml"]) == described(BatState(weight_oz=1.0, mass_oz=30.3))  # to the last bit


def test_a_batter_comes_from_a_fit_or_is_refused_in_a_line(client: httpx.Client) -> None:
    values = {
        "position": 0.2,
        "position_spread": 0.05,
        "offset": 0.0,
        "offset_spread": 0.03,
        "bat_speed": 30.0,
        "exponent": 0.3,
    }
    text = json.dumps({"parameters": {name: {"value": one} for name, one in values.items()}, "pitch_speed_m_s": 36.0})
    found = asked(client, "/batter", swings_csv=text)
    assert found["contact_in"] == pytest.approx(7.87) and found["bat_speed_mph"] == pytest.approx(67.11)
    assert asked(client, "/batter") == {}
    season = "batter,from_tip_in\n7,6\n7,8\n7,\n"  # of a season's table: a ball that no barrel met has no place
    few = asked(client, "/batter", swings_csv=season)
    assert 6.5 < few["contact_in"] < 7.0 and 0.8 < few["contact_doubt_in"] < 1.2  # two balls, and what all players do
    for wrong in ("{", "{}", "from_tip_in\n", "a,b\n1,2\n"):
        response = client.post(f"{URL}/batter", json={"swings_csv": wrong})
        assert response.status_code == 422 and response.json()["error"]["field"] == "swings_csv"
        assert "/tmp" not in response.text and "Traceback" not in response.text


@pytest.mark.parametrize(
    ("fields", "control"),
    [
        ({"bat": "textbook"}, "bat"),
        ({"league": "moon"}, "league"),
        ({"contact_in": 13, "contact_spread_in": 0.01}, "contact_spread_in"),
        ({"design_si": []}, "design_si"),
    ],
)
def test_what_cannot_be_is_told_beside_its_control(client: httpx.Client, fields: dict[str, Any], control: str) -> None:
    response = client.post(URL, json=fields)
    assert response.status_code == 422 and response.json()["error"]["field"] == control

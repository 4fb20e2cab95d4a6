"""What answers a few questions is a file that every command reads, and has the values that were answered."""

from __future__ import annotations

import re
from collections.abc import Callable
from pathlib import Path
from typing import Any

import httpx
import numpy as np
import pytest
from playwright.sync_api import Page, expect

from sweetspot import catalog
from sweetspot.catalog.implements import load_implement
from sweetspot.catalog.swing_laws import swing_weight
from sweetspot.dynamics.beam import beam_model
from sweetspot.dynamics.rigid import rigid_body
from sweetspot.units import INCH, OUNCE, OUNCE_INCH_SQUARED
from sweetspot.web.bats import bat_from_text
from sweetspot.web.errors import FieldError
from sweetspot.web.wizard import PATTERNS, Wanted, described_by, forms
from tests.web.parts import Wait, bench, visit

KINDS = [(sport, key) for sport, patterns in PATTERNS.items() for key in patterns]
ASKED: dict[str, dict[str, Any]] = {
    "baseball": {"length_in": 33.5, "mass_oz": 31.5, "balance_in": 22.6, "swing_weight_oz_in2": 11400},
    "softball": {"length_in": 33, "mass_oz": 24},
    "slow-pitch": {"length_in": 34, "mass_oz": 27, "balance_in": 20.9},
    "youth-baseball": {"length_in": 30, "mass_oz": 20, "barrel_in": 2.5},
    "cricket": {"length_in": 33, "mass_oz": 42, "balance_in": 19.4},
    "tennis": {"length_in": 27, "mass_oz": 10.9, "swing_weight_oz_in2": 1750, "ra": 66, "string_tension_n": 240},
    "badminton": {"length_in": 26.4, "mass_oz": 3.1, "balance_in": 11.7, "swing_weight_oz_in2": 500},
    "table-tennis": {"length_in": 10.2, "mass_oz": 6.1, "balance_in": 6.2, "front": "short-pips"},
    "golf": {"length_in": 45, "mass_oz": 11, "swing_points": "D2"},
    "field-hockey": {"length_in": 37.5, "mass_oz": 21, "swing_weight_oz_in2": 12600, "tone_hz": 110},
}


@pytest.mark.parametrize("sport", PATTERNS)
def test_every_sport_s_file_answers_at_the_command_line(
    sport: str, tmp_path: Path, run_json: Callable[..., Any]
) -> None:
    """Exact: what was asked for."""
    asked = ASKED[sport]
    text, *_ = described_by(Wanted(sport=sport, pattern=next(iter(PATTERNS[sport])), name="Mine", **asked))
    file = tmp_path / "mine.toml"
    file.write_text(text, encoding="utf-8")
    answer = run_json("report", str(file))
    told = answer["bat"]
    assert told["name"] == "Mine" and load_implement(str(file)).sport == sport
    assert told["length_m"] / INCH == pytest.approx(asked["length_in"], rel=1e-6)
    assert told["mass_kg"] / OUNCE == pytest.approx(asked["mass_oz"], rel=1e-6)
    body = rigid_body(beam_model(load_implement(str(file))))
    moi = told["moi_cm_kg_m2"] + told["mass_kg"] * (told["balance_point_m"] - swing_weight(sport).axis) ** 2
    sizes = {
        "balance_in": (told["balance_point_m"] / INCH, 1e-6),
        "swing_weight_oz_in2": (moi / OUNCE_INCH_SQUARED, 1e-4),
    }
    for name, (value, precision) in sizes.items():
        assert value == pytest.approx(asked.get(name, value), rel=precision), name
    assert swing_weight(sport).text_of(body) == "D2.0" or "swing_points" not in asked
    best = f"{answer['sweet_spots']['max_exit_speed_m']}m"
    assert run_json("hit", str(file), "--at", best)["exit_speed_m_s"] > 0


@pytest.mark.parametrize(("sport", "key"), KINDS)
def test_first_answers_are_the_pattern_and_within_their_bounds(sport: str, key: str) -> None:
    form = next(form for form in forms() if form.sport == sport)
    asked = next(pattern for pattern in form.patterns if pattern.key == key).questions
    numbers = [(one.least, one.value, one.most) for one in asked if isinstance(one.value, float)]
    assert len(numbers) > 1
    for least, number, most in numbers:
        assert least is not None and most is not None and least < number < most
    first = {one.field: one.value for one in asked if one.value is not None}
    text, told, assumed = described_by(Wanted(sport=sport, pattern=key, **first))
    assert f'like = "{key}"' in text or f'sport = "{sport}"' in text or sport == "baseball"
    assert len(assumed) > 1  # what was not measured
    assert told == "" or form.sport == "golf" or catalog.bat(key).shell is not None


@pytest.mark.parametrize(
    ("wanted", "field", "words"),
    [
        ({"mass_oz": 14}, "mass_oz", "density"),
        ({"pattern": "../../etc/passwd"}, "pattern", "no"),
        ({"sport": "chess"}, "sport", "chess"),
        ({"material": "butter"}, "material", "butter"),
        ({"sport": "tennis", "pattern": "tennis-racket", "ra": 190}, "ra", "frames have"),
        ({"sport": "tennis", "pattern": "tennis-racket", "string_tension_n": 400}, "string_tension_n", "bears"),
        ({"sport": "tennis", "pattern": "tennis-racket", "swing_weight_oz_in2": 9000}, "swing_weight_oz_in2", "weight"),
        ({"sport": "golf", "pattern": "golf-driver", "swing_points": "H2"}, "swing_points", "such as D2"),
        ({"sport": "golf", "pattern": "golf-driver", "mass_oz": 5}, "mass_oz", "head"),
        ({"sport": "baseball", "pattern": "single-wall", "mass_oz": 58}, "mass_oz", "wall"),
    ],
)
def test_the_answer_that_cannot_be_is_named(wanted: dict[str, Any], field: str, words: str) -> None:
    with pytest.raises(FieldError, match=words) as raised:
        described_by(Wanted(**wanted))
    assert raised.value.field == field


def test_a_racket_by_questions_lies_on_the_bench(page: Page, server: str, settled: Wait) -> None:
    page.goto(f"{server}/sports")
    settled(page)
    bench(page).get_by_role("button", name="Describe yours by questions").click()
    expect(page.locator("#wizard-sport")).to_have_value("tennis")
    expect(page.get_by_label("Name", exact=True)).to_have_value("my racket")
    unit = page.locator(".wizard .control", has_text="Swing weight about the axis 10 cm from the butt").locator(".unit")
    expect(unit).to_have_text("kg cm²")  # in the sport's own unit, whatever the page's are
    page.locator("#wizard-mass_oz").fill("300")
    page.get_by_role("button", name="Put it on the bench").click()
    expect(page.locator("#wizard-mass_oz-fault")).to_have_text(re.compile(r"Allowed is 7\.05. to 14\.8. oz\."))
    page.locator("#wizard-mass_oz").fill("10.58")
    page.get_by_role("button", name="Put it on the bench").click()
    expect(page.locator("#bench-chip")).to_contain_text("my racket")
    settled(page)
    expect(page.locator("dt", has_text=re.compile("^Weight")).locator("+ dd")).to_have_text("10.6 oz")
    expect(page.locator("#bench-chip")).to_contain_text("your own file")
    bench(page)
    page.get_by_role("button", name="Describe yours").click()
    page.locator("#wizard-sport").select_option("golf")
    page.get_by_role("button", name="Put it on the bench").click()
    expect(page.locator("#bench")).to_contain_text(
        "a shaft of 2.6 oz and a head of 7.1 oz"
    )  # what makes its weight is said
    expect(page.locator("#bench-chip")).to_contain_text("my club")


def test_the_weight_follows_the_shaft_the_wood_and_the_length(page: Page, server: str, answered: Any) -> None:
    """Exact: a steel shaft of the same stiffness is heavier, and hickory cannot be as light as ash."""
    page.goto(f"{server}/explorer")
    answered(page)
    bench(page)
    page.get_by_role("button", name="Describe yours").click()
    weight, put = page.locator("#wizard-mass_oz"), page.get_by_role("button", name="Put it on the bench")
    expect(weight).to_have_value("31")
    page.locator("#wizard-length_in").fill("30")
    page.locator("#wizard-length_in").press("Tab")
    expect(weight).to_have_value("28.18")  # 31 oz at 33 in
    page.locator("#wizard-material").select_option("hickory")
    light = float(weight.input_value())
    assert light > 31
    weight.fill("26")
    put.click()
    expect(page.locator("#wizard-mass_oz-fault")).to_contain_text("Allowed is 29.2")  # 26.07 (690 / 560) (30 / 33)
    expect(weight).to_be_focused()
    page.locator("#wizard-sport").select_option("golf")
    expect(weight).to_have_value("11.41")
    page.locator("#wizard-material").select_option("steel")
    expect(weight).to_have_value(re.compile("^15"))
    put.click()
    expect(page.locator("#bench-name")).to_have_text("my club")
    expect(page.locator("#bench")).not_to_contain_text("kg")


def test_what_was_answered_is_kept_until_it_lies_on_the_bench(page: Page, server: str, settled: Any) -> None:
    """The way back, as on a phone, closes the questions; opened again, they stand as they were, in the units shown."""
    page.goto(f"{server}/explorer?units=us")
    settled(page)
    visit(page, "modes")
    settled(page)

    def asked() -> None:
        bench(page)
        page.get_by_role("button", name="Describe yours").click()

    asked()
    length, weight = page.locator("#wizard-length_in"), page.locator("#wizard-mass_oz")
    length.fill("30")
    length.press("Tab")
    weight.fill("29")
    page.go_back()
    expect(page.locator(".wizard")).to_have_count(0)
    settled(page)
    asked()
    expect(length).to_have_value("30")
    expect(weight).to_have_value("29")
    page.locator(".wizard").get_by_role("button", name="Close").click()
    page.locator("input[name=units][value=si]").check()
    settled(page)
    asked()
    expect(length).to_have_value("76.2")
    expect(weight).to_have_value("822.1")
    page.get_by_role("button", name="Put it on the bench").click()
    expect(page.locator("#bench-chip")).to_contain_text("my bat")
    asked()
    expect(length).not_to_have_value("76.2")


def test_a_refusal_tells_its_weights_in_the_reader_s_units(client: httpx.Client) -> None:
    wanted = {"sport": "golf", "pattern": "golf-driver", "material": "steel", "mass_oz": 8}
    fault = client.post("/api/v1/describe", json=wanted).json()["error"]
    assert fault["field"] == "mass_oz" and "kg (" in fault["message"]
    assert " g " in fault["words"]["si"] and "oz" not in fault["words"]["si"] and "kg" not in fault["words"]["us"]


def test_what_stands_on_a_bat_describes_it(page: Page, server: str, settled: Any) -> None:
    """Exact: a drop of 10 at 30 in is 20 oz; the barrel is as wide as it says; what was not asked is listed."""
    page.goto(server)
    settled(page)
    page.get_by_role("button", name="Describe your bat").click()
    page.locator("#wizard-sport").select_option("youth-baseball")
    expect(page.locator("#wizard-pattern option").first).to_have_text("hollow, of metal, stamp USA Baseball")
    page.locator("#wizard-length_in").fill("30")
    page.locator("#wizard-drop").fill("-10")
    page.locator("#wizard-drop").press("Tab")
    expect(page.locator("#wizard-mass_oz")).to_have_value("20")
    page.locator("#wizard-barrel_in").fill("2.5")
    page.get_by_role("button", name="Put it on the bench").click()
    expect(page.locator("#bench")).to_contain_text("Balance point not measured: 1")
    expect(page.locator("#bench")).to_contain_text("USABat alloy")
    expect(page.locator("#verdict")).to_contain_text("my bat hits fastest")
    settled(page)
    bench(page).locator("summary", has_text="Draw the outline").click()
    expect(page.get_by_label(re.compile("diameter, in")).first).to_be_visible()
    widths = page.get_by_label(re.compile("diameter, in")).evaluate_all("all => all.map((one) => Number(one.value))")
    assert max(widths) == pytest.approx(2.5, abs=1e-3)
    page.get_by_role("radio", name="USABat alloy").check()
    expect(page.get_by_text("What was assumed of it")).to_be_hidden()


def test_a_barrel_keeps_handle_and_knob() -> None:
    wanted = Wanted(sport="baseball", pattern="r161-ash", barrel_in=2.4)
    bat, pattern = bat_from_text(described_by(wanted)[0]), catalog.bat("r161-ash")
    place = np.linspace(0, 0.25 * bat.length, 40)
    np.testing.assert_allclose(bat.diameter_at(place), pattern.diameter_at(place), atol=2e-4)
    assert float(np.max(bat.diameter_at(np.linspace(0, bat.length, 400)))) == pytest.approx(2.4 * INCH, rel=1e-3)
    with pytest.raises(FieldError, match="no barrel") as raised:
        described_by(Wanted(sport="tennis", pattern="tennis-racket", barrel_in=2.4))
    assert raised.value.field == "barrel_in"

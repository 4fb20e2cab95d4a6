"""What Player, Season, Own bat, Design, Compare and The paper say: the answer's numbers and directions."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from functools import cache
from typing import Any

import pytest
from playwright.sync_api import BrowserContext

from sweetspot.answers.records import plain_data, to_dict
from sweetspot.designs.gain import GainVerdict
from sweetspot.reports.season.page_words import balls_words
from sweetspot.units import INCH, OUNCE, OUNCE_INCH_SQUARED, grouped
from sweetspot.web.views import compare, design, own, paper, player
from sweetspot.web.views.compare_state import CompareState
from sweetspot.web.views.design_state import DesignState
from sweetspot.web.views.own_state import OwnState
from tests.web.test_page_sentences import shown

Tabled = Callable[[str, str, Any], list[list[str]]]
SCRIPT = """(async ([name, method, answer]) => {
  const { text } = await import("/static/controls/units.js");
  const app = { units: "us", text: (name, value, digits) => text(name, value, "us", digits) };
  const { default: View } = await import(`/static/views/${name}.js`);
  const told = Object.assign(Object.create(View.prototype), { app, answer })[method](answer);
  const cells = (row) => [...row.children].map((cell) => cell.textContent);
  return told.outerHTML ? [...told.querySelectorAll("tbody tr")].map(cells) : told.rows;
})"""
SWINGS = "bat_speed_mph,exit_speed_mph\n"
BETTER, WORSE = 1.06, 0.93
"""Of the barrel's diameter."""


@pytest.fixture(scope="module")
def tabled(visitor: BrowserContext, server: str) -> Iterator[Tabled]:
    """The rows of a view's table of an answer, in a page that draws nothing."""
    page = visitor.new_page()
    page.goto(f"{server}/docs")

    def rows(name: str, method: str, answer: Any) -> list[list[str]]:
        found = page.evaluate(SCRIPT, [name, method, plain_data(answer)])
        return [[str(cell).replace("\N{NO-BREAK SPACE}", " ") for cell in row] for row in found]

    yield rows
    page.close()


@pytest.mark.parametrize(
    ("rows", "counted", "bad"),
    [
        (["66,88", "68,90", "64,86", "66,85", "67,91"], "5 swings", ""),
        (["66,88", "68,90", "64,86", "66,85", "67,91", "68,nine"], "5 swings", "; 1 row could not be used"),
        (["66,88", "68,90", "64,86", "66,85", "67,91", "68,-9", "x,80"], "5 swings", "; 2 rows could not be used"),
    ],
)
def test_player_counts_swings_and_rows(rows: list[str], counted: str, bad: str, tabled: Tabled) -> None:
    found = player.answer(player.PlayerState(swings_csv=SWINGS + "\n".join(rows)))
    assert found.words == f"{counted}{bad}."
    first, *others = tabled("player", "tabled", found)
    assert len(others) == len(found.bat_speed) - 1 == 4
    assert first == ["1", shown(found.bat_speed[0], "speed"), shown(found.exit_speed[0], "speed")]


def test_the_made_up_player_is_called_so() -> None:
    found = player.answer(player.PlayerState())
    assert found.words.startswith(f"{len(found.bat_speed)} swings of a made-up player; ")


@pytest.mark.parametrize("balls", [1, 1234])
@pytest.mark.parametrize("squared", [None, 0.316])
@pytest.mark.parametrize("batter", [None, "Diaz, Cy"])
def test_season_says_the_means(balls: int, squared: float | None, batter: str | None) -> None:
    bat = "R161, white ash"
    words = str(balls_words(batter, bat, balls=balls, exit_speed=39.4, squared_up=squared, from_best=0.031))
    whose = "" if batter is None else f" of {batter}"
    assert words.startswith(
        f"{grouped(balls)} ball{'' if balls == 1 else 's'} in play{whose}: {shown(39.4, 'speed')} of exit speed"
    )
    bats = ", 32 % squared up against R161, white ash, met 1.22 in from its best place on average."
    assert words.endswith(bats) == (squared is not None)


@pytest.mark.parametrize(
    "measured",
    [
        {},
        {"weighed_oz": 31.0},
        {"weighed_oz": 31.0, "balanced_in": 22.05, "pendulum_ms": 1454.5},
        {"weighed_oz": 31.0, "balanced_in": 22.05, "pendulum_ms": 1430.0},
    ],
)
def test_own_bat_says_what_it_is_now(measured: dict[str, float]) -> None:
    found = own.answer(OwnState(**measured))
    words, fitted = found.headline["us"], found.fitted
    against = bool(found.contradictions["us"])
    assert ("As described, not measured" in words) == (not measured)
    assert words.startswith("The measurements contradict each other.") == against
    assert words.startswith("The measurements agree.") == (len(measured) > 1 and not against)
    assert words.startswith("By one measurement and what is usual of such bats: ") == (len(measured) == 1)
    assert against == (measured.get("pendulum_ms") == 1430.0)
    told = re.search(r"([\d.]+)(?: ± [\d.]+)? oz, balance ([\d.]+)(?: ± [\d.]+)? in from the knob", words)
    assert told is not None, words
    assert float(told[1]) == pytest.approx(float(fitted.mass) / OUNCE, abs=0.051)
    assert float(told[2]) == pytest.approx(float(fitted.balance_point) / INCH, abs=0.051)
    swing_weight = float(re.findall(r"swing weight ([\d,]+)", words)[0].replace(",", ""))
    assert swing_weight == pytest.approx(float(fitted.moi_6in) / OUNCE_INCH_SQUARED, abs=51)


def pulled(first: design.DesignPicture, factor: float) -> DesignState:
    """Return the state of the page in which the barrel has been pulled to another diameter."""
    numbers = [variable.value for variable in first.variables]
    numbers[7] *= factor
    return DesignState(design_si=numbers, design_for=first.key, pulled=7, keep_mass=False, keep_moi=False)


def size_of(found: design.DesignPicture) -> str:
    balance = shown(float(found.design.balance_point), "place")
    return f"{shown(float(found.design.mass), 'mass')}, balance {balance} from the knob"


def test_design_says_that_the_present_bat_is_the_present_bat() -> None:
    first = design.answer(DesignState())
    assert first.gained["us"][0].startswith("This is the present bat still")
    assert size_of(first) in " ".join(first.weighs["us"])


@pytest.mark.parametrize("factor", [BETTER, WORSE])
def test_design_says_faster_or_slower_as_the_table_does(factor: float) -> None:
    found = design.answer(pulled(design.answer(DesignState()), factor))
    change = next(measure.change for measure in found.measures if measure.name == "exit_speed")
    assert change is not None
    direction = "faster" if change > 0 else "slower"
    assert f"the ball leaves {shown(abs(change), 'speed_change')} {direction}." in " ".join(found.gained["us"])
    assert size_of(found) in " ".join(found.weighs["us"])


def test_design_says_how_sure_a_gain_is() -> None:
    worth = design.gain(pulled(design.answer(DesignState()), BETTER))
    words = " ".join(worth.gained["us"])
    half = shown(float(worth.half_interval), "speed_change")
    assert any(f"give or take {half} (90 %): {verdict}." in words for verdict in GainVerdict), words


def test_compare_s_table_has_the_answer_s_numbers_and_signs(tabled: Tabled) -> None:
    state = CompareState(bat="r161-ash", others=[{"bat": "youth-30"}, {"bat": "torpedo"}])
    found = to_dict(compare.answer(state))
    table = tabled("compare", "tableOfBats", found["bats"])
    for row, one in zip(table, found["bats"], strict=True):
        assert row[0] == one["label"] and row[1] == shown(one["bat"]["mass_kg"], "mass")
        assert row[5].startswith(shown(one["exit_speed_m_s"]["value"], "speed"))
        assert row[8] == f"{one['max_bbcor']:.3f}"
    for row, one in zip(table[1:], found["bats"][1:], strict=True):
        sign = "+" if one["change_m_s"]["value"] > 0 else ""  # the page's own minus comes with the number
        assert row[6].startswith(sign + shown(one["change_m_s"]["value"], "speed_change"))
        assert not re.search(r"(?<!\d)-\d", "".join(row))


PLACE = re.compile(r"(\N{MINUS SIGN}?[\d.]+) in (?:from|beyond) the tip")


QUESTIONS = ("end", "percussion", "corking", "drop", "energy", "verdict")
CONTROLS: dict[str, dict[str, Any]] = {
    "as printed": {},
    "moved": {
        **{"bat": "torpedo", "rod_hands_in": 11.0, "hands_moved_in": 5.0, "hole_diameter_in": 1.25},
        **{"hole_depth_in": 14.0, "block_thickness_m": 0.003, "block_support": "clamped", "metal_share": 0.3},
    },
}


@cache
def full_model(question: str, controls: str) -> tuple[dict[str, Any], str]:
    """Return the answer to one of the paper's questions, and what the full model says of it."""
    found = plain_data(paper.answer(paper.PaperState(question=question, **CONTROLS[controls])))
    return found, " ".join(found["truth"]["us"])


@pytest.mark.parametrize("question", QUESTIONS)
@pytest.mark.parametrize("controls", CONTROLS)
def test_the_paper_says_where_the_full_model_s_best_place_is(question: str, controls: str) -> None:
    found, words = full_model(question, controls)
    picture = found["picture"]
    assert not [place for place in PLACE.findall(words) if place.startswith("\N{MINUS SIGN}")], words
    best = picture.get("best_m") or picture.get("sweet_spots", {}).get("max_exit_speed_m")
    assert best is None or f"{shown(found['bat']['length_m'] - best, 'place')} from the tip" in words


@pytest.mark.parametrize("controls", CONTROLS)
def test_the_paper_says_how_fast_and_how_far_from_the_percussion_centre(controls: str) -> None:
    found, words = full_model("end", controls)
    assert shown(max(found["picture"]["exit_speed_m_s"]), "speed") in words
    found, words = full_model("percussion", controls)
    picture, length = found["picture"], found["bat"]["length_m"]
    gap = picture["best_m"] - picture["bat_percussion_m"]
    assert f"{shown(abs(gap), 'place')} {'further out' if gap > 0 else 'further in'}" in words
    for name in ("rod_percussion_m", "bat_percussion_m", "moved_percussion_m"):
        beyond = picture[name] > length
        assert f"{shown(abs(length - picture[name]), 'place')} {'beyond' if beyond else 'from'} the tip" in words


@pytest.mark.parametrize("controls", CONTROLS)
def test_the_paper_says_what_corking_does_in_the_full_model(controls: str) -> None:
    found, words = full_model("corking", controls)
    plain, corked = [row["full_model"] for row in found["rows"] if row["equation"] == "13"][-2:]
    assert ("The force grows" in words) == (corked > plain + 0.005)
    before, after = [row["full_model"] for row in found["rows"] if row["equation"] == "14"][-2:]
    assert ("slower" in words) == (after < before)


@pytest.mark.parametrize("controls", CONTROLS)
def test_the_paper_says_how_high_a_dropped_ball_comes_back(controls: str) -> None:
    found, words = full_model("drop", controls)
    for ball in ("wood", "metal"):
        back = found["picture"][ball]["rebound_m"]
        assert ("does not come off" if back is None else shown(back, "place")) in words
    assert ("trampoline: it takes" in words) == (controls == "moved")  # 3 mm, clamped

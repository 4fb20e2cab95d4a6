"""From every view to every other: the bat goes along, no page ends blank, and each fault stands beside its control."""

from __future__ import annotations

import json
from collections.abc import Callable
from itertools import pairwise
from pathlib import Path
from urllib.parse import quote

import pytest
from playwright.sync_api import Page, expect

from sweetspot import catalog
from sweetspot.catalog.files.write import bat_toml
from sweetspot.web.first_answers import first_questions, keep, kept_answer
from sweetspot.web.states import CARRIED
from sweetspot.web.views import VIEWS

Answered = Callable[..., int]

OWN = bat_toml(catalog.bat("youth-30").replaced(name="Somebody's own"))
STARTS = {
    "explorer": f"bat_toml={quote(OWN)}&offset_in=1.2&impact_from_tip_in=5",
    "hit": "bat=single-wall&wall_factor=0.9&exaggeration=8&held=true",
    "modes": "bat=composite&exaggeration=3&family=hoop&tap_from_tip_in=4",
    "compare": "bat=r161-ash&bore_diameter_in=1&others=" + quote(json.dumps([{"bat": "youth-30"}])),
    "flight": "start=swing&batter=left&bat=youth-30&choke_up_in=1",
    "paper": "question=corking&mass_oz=31.5",
    "optimum": "bat=mlb-a&cup_diameter_in=1&pitch=curve",
    "player": "bat=mlb-b&goal=carry",
    "own": "bat=russell-b1&weighed_oz=31&balanced_in=22",
    "design": "bat=single-wall&contact_in=5",
    "season": "bat=mlb-b&fence=oracle-park",
    "sports": "implement=cricket-bat&aside_in=0.5",
}
"""An address of each view with what used to break the next one."""


def test_carried_fields_mean_the_same_in_every_view() -> None:
    for field in CARRIED:
        own = [view.state.model_json_schema()["properties"].get(field) for view in VIEWS.values()]
        known = [{**one, "default": None} for one in own if one is not None]
        assert known and all(one == known[0] for one in known), field


def round_of(start: str) -> list[str]:
    """Return all views from one on: the rounds of all views together go every way from one to another once.

    For an even number n of views, in a circle: one on, two back, three on, four back (a Williams square).
    """
    names = list(VIEWS)
    first, count = names.index(start), len(names)
    steps = [(step + 1) // 2 * (1 if step % 2 else -1) for step in range(count)]
    return [names[(first + step) % count] for step in steps]


def test_the_rounds_go_every_way_once() -> None:
    ways = [way for start in STARTS for way in pairwise(round_of(start))]
    assert len(ways) == len({*ways}) == len(VIEWS) * (len(VIEWS) - 1)
    assert all({*round_of(start)} == {*VIEWS} and round_of(start)[0] == start for start in STARTS)


@pytest.mark.parametrize("start", STARTS)
def test_no_way_to_another_view_ends_blank(
    page: Page, server: str, answered: Answered, settled: Callable[[Page], None], start: str
) -> None:
    """Each view's own address is carried through all the others, and is there again when one goes back."""

    def check(view: str) -> None:
        expect(page.locator("#view")).to_have_attribute("data-view", view)
        answered(page)
        expect(page.locator("#fault")).to_be_hidden()
        label = tool if view == "sports" else name
        expect(page.locator("#bench-chip")).to_have_attribute("aria-label", label)

    page.emulate_media(reduced_motion="reduce")  # what moves would be drawn all the time
    page.set_viewport_size({"width": 700, "height": 500})
    page.goto(f"{server}/{start}?{STARTS[start]}")
    settled(page)  # the chip's name comes with the lists
    here = page.locator("#bench-chip").get_attribute("aria-label") or ""
    bat, racket = (f"On the bench: {catalog.implement(name).name}" for name in ("r161-ash", "tennis-racket"))
    name, tool = (bat, here) if start == "sports" else (here, racket)
    for other in (others := round_of(start)[1:]):
        page.get_by_role("link", name=VIEWS[other].title, exact=True).click()
        check(other)
        assert page.evaluate("scrollY") == 0
    page.go_back()
    check(others[-2])
    page.evaluate(f"history.go({1 - len(others)})")
    check(start)


def test_a_wrong_address_shows_the_first_picture_and_each_fault_beside_its_control(
    page: Page, server: str, answered: Answered
) -> None:
    page.goto(f"{server}/explorer?pitch_speed_mph=999&bore_diameter_in=7")
    answered(page)
    expect(page.locator("[data-field=pitch_speed_mph] .fault")).to_contain_text("110")
    expect(page.locator("[data-field=bore_diameter_in] .fault")).to_be_visible()  # its fold has opened


@pytest.mark.parametrize(
    "address",
    [
        "hit?moment_ms=abc",
        "paper?question=zzz",
        "explorer?mass_oz=[]",
        "explorer?profile_in=[[0,1]]",
        "compare?others=5",
    ],
)
def test_no_fault_is_hidden(page: Page, server: str, answered: Answered, address: str) -> None:
    page.goto(f"{server}/{address}")
    answered(page)
    expect(page.locator("#fault:visible, #view .fault:visible").first).to_be_visible()


def test_the_list_never_names_another_bat(page: Page, server: str, answered: Answered) -> None:
    page.goto(f"{server}/modes?bat_toml={quote(OWN)}")
    count = answered(page)
    chosen = page.locator("[data-field=bat] select")
    expect(chosen).to_have_value("own file")
    chosen.select_option("composite")
    answered(page, count)
    expect(page.locator("#verdict")).to_be_visible()
    expect(page.locator("#bench-chip")).to_contain_text("Composite")
    assert "bat_toml" not in page.url


def test_another_bat_starts_unchanged(page: Page, server: str, answered: Answered) -> None:
    page.goto(f"{server}/explorer?bore_diameter_in=1")
    count = answered(page)
    expect(page.locator("#bench-chip")).to_contain_text("hole 1.00 in wide")
    page.locator("[data-field=bat] select").select_option("composite")
    answered(page, count)
    expect(page.locator("#verdict")).to_contain_text("Composite")
    expect(page.locator("#bench-chip small")).to_be_empty()


def test_key_presses_on_a_slider_are_one_step_back(page: Page, server: str, answered: Answered) -> None:
    page.goto(f"{server}/explorer")
    answered(page)
    slider = page.get_by_role("slider", name="Pitch speed")
    slider.focus()
    for _ in range(6):
        slider.press("ArrowRight")
    expect(page).to_have_url(f"{server}/explorer?pitch_speed_mph=93")
    page.go_back()
    expect(page).to_have_url(f"{server}/explorer")


def test_sliders_end_where_the_bat_does(page: Page, server: str, answered: Answered) -> None:
    page.goto(f"{server}/explorer?bat=youth-30")
    answered(page)
    weight = page.locator("[data-field=weight_from_tip_in] input[type=range]")
    assert float(weight.get_attribute("max") or 0) == pytest.approx(30, abs=0.3)


def test_nothing_is_left_of_views_that_were_left(page: Page, server: str, answered: Answered) -> None:
    """A dropped file is read once, however many views came before."""
    page.goto(f"{server}/explorer")
    answered(page)
    for title in ("Modes", "Explorer", "Compare", "Explorer"):
        page.get_by_role("link", name=title, exact=True).click()
        answered(page)
    posted: list[str] = []
    page.on("request", lambda request: posted.append(request.url) if request.url.endswith("/api/v1/bat") else None)
    page.evaluate(
        """text => {
          const data = new DataTransfer();
          data.items.add(new File([text], "own.toml"));
          document.getElementById("view").dispatchEvent(new DragEvent("drop", { dataTransfer: data, bubbles: true }));
        }""",
        OWN,
    )
    expect(page.locator("#bench-chip")).to_contain_text("Somebody's own")
    assert len(posted) <= 2  # once to check it, once for its name


def test_first_answers_are_kept_for_this_state_of_the_package_only(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    from sweetspot.web import first_answers

    monkeypatch.setattr(first_answers, "kernel_folder", lambda: tmp_path)
    questions = [*first_questions()]
    name, state, _ = first = questions[0]
    assert ("player", VIEWS["player"].state(), "fit") in questions  # what comes apart, and takes longest
    assert kept_answer(*first) is None
    keep(first, b"{}")
    assert kept_answer(name, state) == b"{}"
    assert kept_answer(name, state, "why") is None
    assert kept_answer(name, state.model_copy(update={"pitch_speed_mph": 80.0})) is None
    monkeypatch.setattr(first_answers, "_package_digest", lambda: "another")
    assert kept_answer(name, state) is None
    keep(first, b"{1}")
    monkeypatch.undo()
    assert len([*tmp_path.iterdir()]) == 1

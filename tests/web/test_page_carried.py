"""From every view to every other: the bat goes along, no page ends blank, and each fault stands beside its control."""

from __future__ import annotations

import json
from itertools import pairwise
from pathlib import Path
from urllib.parse import quote

import pytest
from playwright.sync_api import Page, expect

from sweetspot import catalog
from sweetspot.catalog.files.write import bat_toml
from sweetspot.web import answers
from sweetspot.web.answers import first_questions, kept_answer, work_out
from sweetspot.web.controls import CARRIED
from sweetspot.web.views import VIEWS
from tests.web.parts import Answered, Wait, bench, choose, visit

OWN = bat_toml(catalog.bat("youth-30").replaced(name="Somebody's own"))
STATES = {
    "own file": ("explorer", f"bat_toml={quote(OWN)}&offset_in=1.2&impact_from_tip_in=5", "Somebody's own"),
    "changed bat": (
        "optimum",
        "bat=mlb-a&cup_diameter_in=1&bore_diameter_in=0.9&weight_oz=1&bat_speed_mph=80",
        "MLB profile A",
    ),
    "left-hander": ("flight", "start=swing&batter=left&bat=youth-30&choke_up_in=1&mass_oz=22", "Youth 30 in, wood"),
    "wall": ("hit", "bat=single-wall&wall_factor=0.9&exaggeration=8&held=true", "Single-wall aluminium"),
    "other sport": ("sports", "implement=cricket-bat&aside_in=0.5", "Cricket bat"),
}
"""What goes along from view to view: where it is chosen, how an address says it, and what then lies on the bench."""
EVERY_WAY = "own file"
"""The state that goes every way from view to view: the one that carries most."""
TO_AND_FRO = "other sport"
"""The state that goes from its only view to every other and back."""
LEFT = (
    "hit?exaggeration=8&recoil=true",
    "modes?exaggeration=3&family=hoop&tap_from_tip_in=4",
    "compare?others=" + quote(json.dumps([{"bat": "youth-30", "choke_up_in": 1}])),
    "paper?question=percussion",
    "optimum?pitch=curve",
    "player?goal=carry",
    "own?weighed_oz=31",
    "design?contact_in=5",
    "season?fence=oracle-park",
)
"""Addresses of views whose own controls used to break the next one; they are as they were left when one comes back."""
WAIT = """
const PATIENCE = 60000;
const view = document.getElementById("view");
const asked = () => view.dataset.waiting.split(" ").includes("answer");
const settled = (name) => view.dataset.view === name && view.dataset.answered && !asked();
const there = (name) => new Promise((done, failed) => {
  setTimeout(() => failed(new Error(`${name} stays blank`)), PATIENCE);
  const look = () => settled(name) && (watch.disconnect(), done());
  const watch = new MutationObserver(look);
  watch.observe(view, { attributes: true });
  look();
});
const rest = (time) => new Promise((done) => setTimeout(done, time));
const seen = (all) => [...document.querySelectorAll(all)].filter((one) => one.checkVisibility());
const open = async (address) => {
  history.pushState(null, "", `/${address}`);
  dispatchEvent(new PopStateEvent("popstate"));
  await there(address.split("?")[0]);
};
"""
OPEN = f"""async (addresses) => {{{WAIT}
  for (const address of addresses) await open(address);
}}"""
WALK = f"""async ([address, bench, names]) => {{{WAIT}
  const chip = document.getElementById("bench-chip");
  const named = () => chip.getAttribute("aria-label").includes(bench);
  const steps = [];
  await open(address);
  for (const end = Date.now() + PATIENCE; !named() && Date.now() < end;) await rest(20);
  for (const name of names) {{
    document.querySelector(`:is(.brand, #views a)[data-name=${{name}}]`).click();
    await there(name);
    steps.push({{ view: name, faults: seen("#fault, #view .fault").map((one) => one.textContent), scrolled: scrollY,
      bench: chip.getAttribute("aria-label"),
      told: view.innerText.trim().length, drawn: view.querySelectorAll("canvas").length }});
  }}
  return steps;
}}"""
"""In the page, for a hundred questions from here cost more than what they ask about."""


def test_carried_fields_mean_the_same_in_every_view() -> None:
    for field in CARRIED:
        own = [view.state.model_json_schema()["properties"].get(field) for view in VIEWS.values()]
        known = [{**one, "default": None} for one in own if one is not None]
        assert known and all(one == known[0] for one in known), field


def every_way(start: str) -> list[str]:
    """Return views in an order that goes once from each of them to every other, an Euler circuit."""
    left = {name: [other for other in VIEWS if other != name] for name in VIEWS}
    way, done = [start], []
    while way:
        if left[way[-1]]:
            way.append(left[way[-1]].pop())
        else:
            done.append(way.pop())
    return done[::-1]


def to_and_fro(start: str) -> list[str]:
    """Return views in an order that goes from the first to each of the others and back."""
    return [start, *(name for other in VIEWS if other != start for name in (other, start))]


def one_round(start: str, stride: int) -> list[str]:
    """Return views in an order that comes to each of them once, every ``stride``-th of the list as long as it goes."""
    left, way = [*VIEWS], [start]
    left.remove(start)
    while left:
        way.append(left.pop((stride * len(way)) % len(left)))
    return [*way, start]


@pytest.mark.parametrize("start", VIEWS)
def test_every_way_is_gone_once(start: str) -> None:
    round_trip = every_way(start)
    ways = [*pairwise(round_trip)]
    assert round_trip[0] == round_trip[-1] == start
    assert len(ways) == len({*ways}) == len(VIEWS) * (len(VIEWS) - 1)


def test_whatever_goes_along_no_way_to_another_view_ends_blank(page: Page, server: str, settled: Wait) -> None:
    """Each state goes to every view, some every way, in one page, past views that were left as somebody set them."""
    page.emulate_media(reduced_motion="reduce")  # what moves would be drawn all the time
    page.set_viewport_size({"width": 700, "height": 500})
    page.goto(f"{server}/explorer")
    settled(page)  # the chip's names come with the lists
    page.evaluate(OPEN, LEFT)
    for number, (state, (view, address, laid)) in enumerate(STATES.items()):
        ways = {EVERY_WAY: every_way(view), TO_AND_FRO: to_and_fro(view)}
        way = ways.get(state) or one_round(view, number)
        for step in page.evaluate(WALK, [f"{view}?{address}", laid, way[1:]]):
            assert step["faults"] == [], (state, step)
            assert step["scrolled"] == 0, (state, step)
            assert step["told"] > 100, (state, step)
            assert step["drawn"] > 0, (state, step)
            own_sport = (step["view"] == "sports") == (state == "other sport")
            assert laid in step["bench"] or not own_sport, (state, step)
    page.go_back()
    page.go_forward()
    settled(page)
    expect(page.locator("#view")).to_have_attribute("data-view", "sports")
    expect(page.locator("#bench-chip")).to_contain_text("Cricket bat")


def test_a_wrong_address_shows_the_first_picture_and_each_fault_beside_its_control(
    page: Page, server: str, answered: Answered
) -> None:
    page.goto(f"{server}/explorer?pitch_speed_mph=999&bore_diameter_in=7")
    answered(page)
    expect(page.locator("[data-field=pitch_speed_mph] .fault")).to_contain_text("125")
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
    expect(page.locator("#fault:visible, :is(#view, #bench) .fault:visible").first).to_be_visible()


def test_the_list_never_names_another_bat(page: Page, server: str, answered: Answered) -> None:
    page.goto(f"{server}/modes?bat_toml={quote(OWN)}")
    count = answered(page)
    expect(bench(page).locator("input:checked")).to_have_count(0)
    choose(page, "composite")
    answered(page, count)
    expect(page.locator("#verdict")).to_be_visible()
    expect(page.locator("#bench-chip")).to_contain_text("Composite")
    assert "bat_toml" not in page.url


def test_another_bat_starts_unchanged(page: Page, server: str, answered: Answered) -> None:
    page.goto(f"{server}/explorer?bore_diameter_in=1")
    count = answered(page)
    expect(page.locator("#bench-chip")).to_contain_text("hole 1.00 in wide")
    choose(page, "composite")
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
    weight = bench(page).locator("[data-field=weight_from_tip_in] input[type=range]")
    assert float(weight.get_attribute("max") or 0) == pytest.approx(30, abs=0.3)


def test_nothing_is_left_of_views_that_were_left(page: Page, server: str, answered: Answered) -> None:
    """A dropped file is read once, however many views came before."""
    page.goto(f"{server}/explorer")
    answered(page)
    for name in ("modes", "explorer", "compare", "explorer"):
        visit(page, name)
        answered(page)
    posted: list[str] = []
    page.on("request", lambda request: posted.append(request.url) if request.url.endswith("/api/v1/bring") else None)
    page.evaluate(
        """text => {
          const data = new DataTransfer();
          data.items.add(new File([text], "own.toml"));
          document.getElementById("view").dispatchEvent(new DragEvent("drop", { dataTransfer: data, bubbles: true }));
        }""",
        OWN,
    )
    expect(page.locator("#bench-chip")).to_contain_text("Somebody's own")
    assert len(posted) == 1


def test_first_answers_are_kept_for_this_state_of_the_package_only(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(answers, "kernel_folder", lambda: tmp_path)
    name, state = "player", VIEWS["player"].state()
    assert (state, "fit") in first_questions(name)  # what comes apart, and takes longest
    assert kept_answer(name, state) is None
    monkeypatch.setattr(answers, "answer_json", lambda *_: b"{}")
    work_out(name)
    assert kept_answer(name, state) == kept_answer(name, state, "fit") == b"{}"
    assert kept_answer("explorer", VIEWS["explorer"].state()) is None
    assert kept_answer(name, state.model_copy(update={"bat": "mlb-a"})) is None
    monkeypatch.setattr(answers, "_package_digest", lambda: "another")
    assert kept_answer(name, state) is None
    monkeypatch.setattr(answers, "answer_json", lambda *_: b"{1}")
    work_out(name)
    assert kept_answer(name, state) == b"{1}"
    monkeypatch.undo()
    assert len([*tmp_path.glob("*.json")]) == len([*first_questions(name)])

"""The page's modules one by one, in the browser that runs them: numbers in, numbers out, nothing drawn."""

from __future__ import annotations

import re
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from playwright.sync_api import Page, expect

from sweetspot.report.quantities import PALETTE, SI, US
from sweetspot.web.files import FOLDER

Answered = Callable[..., int]
SOUND = ("recorder",)
"""Modules that run where sound is heard, and nowhere else."""


@pytest.fixture
def run(page: Page, server: str) -> Callable[[str], Any]:
    """A function that evaluates a script with every module of the page as a variable of its name."""
    page.goto(f"{server}/docs")

    def evaluate(script: str) -> Any:
        names = [path.stem for path in FOLDER.glob("*.js") if path.stem not in ("main", "docs", *SOUND)]
        parts = [f"{name}: await import('/static/{name}.js')" for name in names]
        return page.evaluate(f"(async () => {{ const m = {{ {', '.join(parts)} }}; return {script}; }})()")

    return evaluate


def test_units_are_those_of_the_package(run: Callable[[str], Any]) -> None:
    for value, name, scale in (
        (41.2, "exit_speed_m_s", "speed"),
        (0.881, "mass_kg", "mass"),
        (104.2, "distance", "distance"),
    ):
        for system, reader in (("us", US), ("si", SI)):
            shown = run(f"m.units.text('{name}', {value}, '{system}')").replace("\N{MINUS SIGN}", "-")
            assert shown == reader.shown(value, scale)
    assert run(
        "m.units.fromShown('pitch_speed_mph', m.units.toShown('pitch_speed_mph', 87.5, 'si'), 'si')"
    ) == pytest.approx(87.5)
    assert run("m.units.text('exit_speed_m_s', null, 'us')") == "\N{EN DASH}"
    assert run("m.units.text('exit_speed_m_s', -0.001, 'us')") == "0.0 mph"


def test_addresses_hold_a_state_and_give_it_back(run: Callable[[str], Any]) -> None:
    back = """(await (async () => {
      const first = { a: 1, name: "x", list: [], on: false };
      const state = { a: 2.5, name: "å & ? #", list: [{ b: 1 }], on: true };
      const types = { a: "number", name: "string", list: "array", on: "boolean" };
      const schema = Object.fromEntries(Object.entries(types).map(([name, type]) => [name, { type }]));
      const found = [];
      for (const address of [m.address.addressOf("v", state, first), await m.address.shortAddressOf("v", state, first)])
        found.push(await m.address.stateIn(address.slice(address.indexOf("?")), schema, first));
      return [state, ...found];
    })())"""
    state, long, short = run(back)
    assert long == state
    assert short == state
    assert run("m.address.addressOf('v', { a: 1 }, { a: 1 })") == "/v"


def test_what_charts_are_made_of(run: Callable[[str], Any]) -> None:
    assert run("m.surface.ticks(0, 1, 5)") == pytest.approx([0, 0.2, 0.4, 0.6, 0.8, 1])
    assert run("m.chartpaint.between([0, 1, 3], [0, 10, 30], 2)") == pytest.approx(20)
    assert run("m.chartpaint.between([0, 1], [0, null], 0.5)") is None
    low, high = run("m.chartpaint.limits({ xs: [[0, 1, 2]], shown: [[5, 7, 100]], range: [0, 1] }, {})")
    assert low < 5
    assert 7 < high < 10  # what lies outside the range does not count
    pieces = run("m.heatmap.squares({ x: [0, 1], y: [0, 1], z: [[0, 1], [0, 1]] }, 0.25)")
    assert pieces == [[[0.25, 0], [0.25, 1]]]
    span = run("""(() => {
      const zoom = new m.zoom.Zoom({ onChange() {} });
      zoom.set([0, 10], [5, 10]);
      zoom.about(10, 0.5);
      return [zoom.range, (zoom.all(), zoom.range), (zoom.back(), zoom.range)];
    })()""")
    assert span == [[7.5, 10], [0, 10], [5, 10]]


def test_the_pages_colours_are_the_packages() -> None:
    sheet = Path(FOLDER / "theme.css").read_text(encoding="utf-8")
    light = dict(re.findall(r"--([a-z-]+): (#[0-9a-f]{6})", sheet[: sheet.index("}")]))
    assert {name: light[name] for name in PALETTE} == dict(PALETTE)


def test_a_bat_by_questions_and_what_words_mean(page: Page, server: str, answered: Answered) -> None:
    page.goto(f"{server}/explorer")
    count = answered(page)
    page.locator("#bench-chip").click()
    page.get_by_role("button", name="Describe another bat").click()
    page.get_by_label("Name", exact=True).fill("Grandfather's")
    page.get_by_label("Weight", exact=True).fill("15")
    page.get_by_role("button", name="Put it on the bench").click()
    expect(page.locator("#wizard-mass_oz-fault")).to_contain_text("density")
    page.locator("#wizard-mass_oz").fill("32")
    page.get_by_role("button", name="Put it on the bench").click()
    answered(page, count)
    expect(page.locator("#bench-chip")).to_contain_text("Grandfather's")
    expect(page.locator("#verdict")).to_contain_text("Grandfather's hits fastest")
    word = page.locator("dt .term", has_text="BBCOR").first
    word.focus()
    expect(page.locator(".tip:visible")).to_contain_text("F2219")


def test_words_keep_their_meanings_when_a_view_is_drawn_anew(
    page: Page, server: str, settled: Callable[[Page], None]
) -> None:
    """Its tables are then other ones: another system of units or another width must not take the meanings away."""
    page.goto(f"{server}/compare")
    settled(page)
    before = page.locator("th .term").all_text_contents()
    assert "Swing weight" in before
    acts: tuple[Callable[[], None], ...] = (
        lambda: page.get_by_role("radio", name="SI").check(force=True),
        lambda: page.set_viewport_size({"width": 900, "height": 900}),
    )
    for act in acts:
        act()
        settled(page)
        assert page.locator("th .term").all_text_contents() == before

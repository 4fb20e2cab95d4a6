"""An answer's page prints on one sheet of either paper, and says whom it is for and what it was made from."""

from __future__ import annotations

import random
import re
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest
from playwright.sync_api import Browser, Page

from sweetspot import catalog
from sweetspot.seasons.made_up import MadeSeason, made_season

Run = Callable[..., tuple[int, str, str]]

MARGINS = {"top": "11mm", "bottom": "11mm", "left": "14mm", "right": "14mm"}
"""As the page's own style has them."""
LETTERS = 7.5
"""Points, the small letters of all pictures."""
COMMANDS = (
    ("report", 6.5, ("report", "r161-ash")),
    ("report", 6.5, ("report", "college-alloy", "--uncertainty")),
    ("player", 6.5, ("fit-player", "FILE", "--bat", "r161-ash", "--batter", "Ann")),
    ("team", 0.0, ("fit-player", "FILE", "--bat", "r161-ash", "--batter", "all")),
    ("compare", 6.5, ("compare", "r161-ash", "single-wall", "mlb-a")),
    ("compare", 6.4, ("compare", "r161-ash", "--what-if", "cork")),
    ("certify", 5.5, ("certify", "college-alloy", "--wall-that-passes", "--uncertainty")),
    ("certify", 0.0, ("certify", "youth-alloy", "--league", "all")),  # whose many rules leave no room for a picture
    ("paper", 0.0, ("paper",)),
    ("play", 5.5, ("play", "r161-ash", "--park", "fenway")),
    ("park", 5.5, ("parks", "fenway")),
    ("parks", 0.0, ("parks",)),
    ("player-600003", 5.5, ("season", "SEASON", "--bat", "r161-ash", "--try", "mlb-a", "--player", "600003")),
    ("design", 0.0, ("design", "mlb-a", "--population", "8", "--generations", "1")),
)
"""Name of the page, points of its picture's small letters that stay on paper, and the command."""


@pytest.fixture(scope="module")
def swings(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Two batters, twelve swings each."""
    rows, throw = ["player,bat_speed_mph,exit_speed_mph,pitch_speed_mph"], random.Random(5)
    for _ in range(12):
        rows += [f"{name},{throw.gauss(66, 3):.1f},{throw.gauss(86, 6):.1f},60" for name in ("Ann", "Bo")]
    path = tmp_path_factory.mktemp("swings") / "swings.csv"
    path.write_text("\n".join(rows), encoding="utf-8")
    return path


@pytest.fixture(scope="module")
def season(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A made-up season of six batters."""
    path = tmp_path_factory.mktemp("season") / "season.parquet"
    made_season(catalog.bat("r161-ash"), MadeSeason(players=6, balls=60)).write_parquet(path)
    return path


@pytest.fixture(scope="module")
def opened(browser: Browser) -> Iterator[Page]:
    """One tab for all sheets: a new one costs more than most of them."""
    page = browser.new_page()
    yield page
    page.close()


@pytest.mark.parametrize(("name", "least", "command"), COMMANDS, ids=lambda one: one if isinstance(one, str) else "")
def test_a_page_is_one_sheet(
    run: Run,
    opened: Page,
    swings: Path,
    season: Path,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    name: str,
    least: float,
    command: tuple[str, ...],
) -> None:
    monkeypatch.setattr(
        "sweetspot.designs.local_search.LOOKS", 3
    )  # a design's sheet is as long when it is hardly polished
    given = {"FILE": str(swings), "SEASON": str(season)}
    words = [given.get(word, word) for word in command]
    code, _, said = run(*words, "--title", "Spring <2026>", "--for", "Ann Example", "--out", str(tmp_path))
    assert code in (0, 1), said
    page = (tmp_path / f"{name}.html").read_text(encoding="utf-8")
    assert "<h1>Spring &lt;2026&gt;</h1>" in page and "<b>For Ann Example</b>" in page
    assert re.search(r"\d{1,2} [A-Z][a-z]+ 20\d\d: sweetspot " + words[0], page)
    opened.emulate_media(media="null")
    opened.set_viewport_size({"width": 1280, "height": 720})
    opened.set_content(page)
    for paper in ("A4", "Letter"):
        printed = opened.pdf(format=paper, margin=MARGINS)  # type: ignore[arg-type]
        assert len(re.findall(rb"/Type\s*/Page\b", printed)) == 1, paper
    if "<figure" in page and "rules many" not in page:
        the_picture_takes_what_is_left(opened, least, A4)
        if name == "compare":
            the_picture_takes_what_is_left(opened, least, LETTER)


A4, LETTER = (688, 1039), (710, 973)
"""Pixels at 96 an inch: what the margins leave."""


def the_picture_takes_what_is_left(page: Page, least: float, paper: tuple[int, int]) -> None:
    """Hold a sheet to it: no picture on what follows it, its letters readable, the footer at the sheet's end."""
    width, height = paper
    page.set_viewport_size({"width": width, "height": height})
    page.emulate_media(media="print")
    sheet = page.evaluate(
        """() => { const box = (one) => one.getBoundingClientRect(); return {
             gaps: [...document.querySelectorAll("main > figure")].map(
               (one) => { let next = one.nextElementSibling; while (!next.offsetHeight) next = next.nextElementSibling;
                          return box(next).top - box([...one.querySelectorAll("svg")].at(-1)).bottom; }),
             highest: Math.max(...[...document.querySelectorAll("main > figure svg")].map((one) => box(one).height)),
             shown: Math.max(...[...document.querySelectorAll("main > figure svg")].map((one) => Math.min(
               box(one).width / one.viewBox.baseVal.width, box(one).height / one.viewBox.baseVal.height))),
             end: box(document.querySelector("main > footer")).bottom }; }"""
    )
    assert min(sheet["gaps"]) >= 0 and sheet["highest"] > 130, sheet
    assert LETTERS * sheet["shown"] * 72 / 96 >= least, sheet
    assert height - 9 < sheet["end"] <= height, sheet


def test_a_team_of_one_sheet_names_who_is_left_out(run: Run, swings: Path, tmp_path: Path) -> None:
    path = tmp_path / "team.csv"
    path.write_text(swings.read_text(encoding="utf-8") + "\nCy,66,88,60\n", encoding="utf-8")
    code, text, _ = run("fit-player", str(path), "--bat", "r161-ash", "--batter", "all")
    assert code == 0 and "Ann" in text and "Cy: " in text and "fewest" in text

"""Every answer's page prints on one sheet of either paper, and says whom it is for and what it was made from."""

from __future__ import annotations

import random
import re
from collections.abc import Callable
from pathlib import Path

import pytest
from playwright.sync_api import Browser

Run = Callable[..., tuple[int, str, str]]

MARGINS = {"top": "11mm", "bottom": "11mm", "left": "14mm", "right": "14mm"}
"""As the page's own style has them."""
COMMANDS = {
    "report": ("report", "r161-ash"),
    "player": ("fit-player", "FILE", "--bat", "r161-ash", "--batter", "Ann"),
    "team": ("fit-player", "FILE", "--bat", "r161-ash", "--batter", "all"),
    "compare": ("compare", "r161-ash", "single-wall", "mlb-a"),
    "certify": ("certify", "r161-ash"),
    "paper": ("paper",),
    "play": ("play", "r161-ash", "--park", "fenway"),
    "design": ("design", "mlb-a", "--population", "8", "--generations", "1"),
}


@pytest.fixture(scope="module")
def swings(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Two batters, twelve swings each."""
    rows, throw = ["player,bat_speed_mph,exit_speed_mph,pitch_speed_mph"], random.Random(5)
    for _ in range(12):
        rows += [f"{name},{throw.gauss(66, 3):.1f},{throw.gauss(86, 6):.1f},60" for name in ("Ann", "Bo")]
    path = tmp_path_factory.mktemp("swings") / "swings.csv"
    path.write_text("\n".join(rows), encoding="utf-8")
    return path


@pytest.mark.parametrize("name", COMMANDS)
def test_a_page_is_one_sheet(
    run: Run,
    browser: Browser,
    swings: Path,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    name: str,
) -> None:
    monkeypatch.setattr("sweetspot.design.polish.LOOKS", 3)  # a design's sheet is as long when it is hardly polished
    words = [str(swings) if word == "FILE" else word for word in COMMANDS[name]]
    code, _, said = run(*words, "--title", "Spring <2026>", "--for", "Ann Example", "--out", str(tmp_path))
    assert code in (0, 1), said
    page = (tmp_path / f"{name}.html").read_text(encoding="utf-8")
    assert "<h1>Spring &lt;2026&gt;</h1>" in page and "<b>For Ann Example</b>" in page
    assert re.search(r"\d{1,2} [A-Z][a-z]+ 20\d\d: sweetspot " + words[0], page)
    opened = browser.new_page()
    opened.set_content(page)
    for paper in ("A4", "Letter"):
        printed = opened.pdf(format=paper, margin=MARGINS)  # type: ignore[arg-type]
        assert len(re.findall(rb"/Type\s*/Page\b", printed)) == 1, paper
    opened.close()


def test_a_team_of_one_sheet_names_who_is_left_out(run: Run, swings: Path, tmp_path: Path) -> None:
    path = tmp_path / "team.csv"
    path.write_text(swings.read_text(encoding="utf-8") + "\nCy,66,88,60\n", encoding="utf-8")
    code, text, _ = run("fit-player", str(path), "--bat", "r161-ash", "--batter", "all")
    assert code == 0 and "Ann" in text and "Cy: " in text and "fewest" in text

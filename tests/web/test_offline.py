"""The file that is given away: it computes what the page computes, to the last printed digit, without a network."""

from __future__ import annotations

import random
import re
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import httpx
import numpy as np
import pytest
from playwright.sync_api import Browser, Page

from sweetspot.catalog.implements import loaded_implement
from sweetspot.catalog.standard_hit import standard_conditions
from sweetspot.cli import main
from sweetspot.dynamics.reduction import reduced_bat
from sweetspot.motion.swing import Pitch
from sweetspot.numerics.interpolants import vertex
from sweetspot.numerics.interval import REACH
from sweetspot.reports.page_words import film_phases
from sweetspot.reports.quantities import SYSTEMS, System, with_minus_signs
from sweetspot.uncertainty.drawn_hits import draws_of, hits_along
from sweetspot.uncertainty.sources import one_by_one, sources_of
from sweetspot.units import INCH, MPH
from sweetspot.web.bundle import BundleError, bundled
from sweetspot.web.offline.bat_numbers import OfflineBat, PackedArray
from sweetspot.web.offline.page import FileHead, offline_file
from sweetspot.web.offline.translation import TranslationError, javascript_of
from sweetspot.web.views import explorer, hit, sports
from tests.web.parts import Answered
from tests.web.test_page_access import CHECKS

LARGEST = 300_000
"""Bytes of a file, as any mail and messenger takes it."""
SETTINGS = 16

READ = """async (settings) => {
  const fields = Object.fromEntries([...document.querySelectorAll("#controls .control")].map((box) =>
    [box.dataset.field, box.querySelector("input[type=number]")]));
  const next = () => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)));
  const plain = (element) => element.textContent.replaceAll("\\u00a0", " ");
  const found = [];
  for (const values of settings) {
    const both = {};
    for (const system of ["us", "si"]) {
      if (system === "us") {
        document.querySelector("input[value=us]").click();
        await next();
        for (const [field, value] of Object.entries(values)) {
          fields[field].value = value;
          fields[field].dispatchEvent(new Event("change"));
        }
      } else document.querySelector("input[value=si]").click();
      await next();
      both[system] = { headline: plain(document.querySelector("#verdict")), why: plain(document.querySelector("#why")),
        facts: Object.fromEntries([...document.querySelectorAll(".facts div")].map(({ children }) =>
          [...children].map(plain))) };
    }
    found.push(both);
  }
  return found;
}"""
"""Sets the controls to each of several settings and reads what the file says, in either system of units."""

Read = Callable[[list[dict[str, float]]], list[dict[System, dict[str, Any]]]]


def offline_bat(name: str) -> OfflineBat:
    """Return an implement of the catalogue as it is usually swung."""
    implement = loaded_implement(name).implement
    conditions = standard_conditions(implement)
    return OfflineBat(
        reduced_bat(implement, ball=conditions.ball), conditions, sources_of(implement, conditions)
    )  # fmt: skip


@pytest.fixture(scope="session")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return where files are kept that several tests open."""
    return tmp_path_factory.mktemp("offline")


@pytest.fixture
def opened_file(browser: Browser, folder: Path) -> Iterator[Callable[..., Page]]:
    """Return what opens an implement's file in a browser without a network; whatever the page complains of fails."""
    complaints: list[str] = []
    contexts = []

    def opened(name: str, **options: Any) -> Page:
        path = folder / f"{name}.html"
        if not path.exists():
            path.write_bytes(offline_file(offline_bat(name)))
        context = browser.new_context(offline=True, **options)
        contexts.append(context)
        page = context.new_page()
        page.on("pageerror", lambda error: complaints.append(str(error)))
        page.on("console", lambda said: complaints.append(said.text))
        page.on("request", lambda asked: None if asked.url == path.as_uri() else complaints.append(asked.url))
        page.goto(path.as_uri())
        page.wait_for_selector("body[data-drawn]")
        return page

    yield opened
    for context in contexts:
        context.close()
    assert complaints == []


def settings_of(page: Page, *, seed: int) -> list[dict[str, float]]:
    """Return settings all over the travel of a file's sliders: places in tenths of an inch, speeds in mph."""
    rng = random.Random(seed)
    page.locator("input[value=us]").check(force=True)
    page.evaluate("new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))")
    ends = page.evaluate(
        """[...document.querySelectorAll("#controls .control")].map((box) =>
          [box.dataset.field, ...["min", "max"].map((end) => Number(box.querySelector("input[type=range]")[end]))])"""
    )
    return [
        {
            field: rng.randint(round(10 * low), round(10 * high)) / 10
            if field == "impact_from_tip_in"
            else rng.randint(round(low), int(high))
            for field, low, high in ends
        }
        for _ in range(SETTINGS)
    ]


@pytest.mark.parametrize("name", ["r161-ash", "corked-r161", "composite", "fast-pitch", "youth-alloy"])
def test_a_file_says_what_the_page_says_to_the_last_digit(name: str, opened_file: Callable[..., Page]) -> None:
    page = opened_file(name)
    settings = settings_of(page, seed=len(name))
    for chosen, found in zip(settings, page.evaluate(READ, settings), strict=True):
        answer = explorer.answer(explorer.ExplorerState(bat=name, same="speed", **chosen))
        struck = answer.hit
        for system, reader in SYSTEMS.items():
            said = found[system]
            assert said["headline"] == f"{answer.headline[system][0]} {answer.headline[system][-1]}", chosen
            assert said["why"].startswith(answer.why[system][0] if struck.exit_speed is not None else ""), chosen
            expected = {
                "Exit speed": (struck.exit_speed, "speed"),
                "Lost against the best": (answer.lost, "speed"),
                "Collision efficiency q": (struck.collision_efficiency, "ratio"),
                "BBCOR in play": (struck.bbcor, "ratio"),
                "Peak force": (struck.peak_force, "blow"),
                "Contact time": (struck.contact_time, "contact"),
            }
            for label, (value, scale) in expected.items():
                printed = "\N{EN DASH}" if value is None else with_minus_signs(reader.shown(float(value), scale))
                assert without_interval(said["facts"][label]) == printed, (chosen, label)


def without_interval(text: str) -> str:
    """Return a number without what it may be off by."""
    return re.sub(r" ± [\d.]+", "", text)


@pytest.mark.parametrize("name", ["tennis-racket", "cricket-bat", "golf-driver"])
def test_other_sports_too(name: str, opened_file: Callable[..., Page]) -> None:
    page = opened_file(name)
    settings = settings_of(page, seed=7)[:8]
    assert ("pitch_speed_mph" in settings[0]) == (name != "golf-driver"), "a ball at rest has no speed"
    for chosen, found in zip(settings, page.evaluate(READ, settings), strict=True):
        state = sports.SportsState(
            implement=name,
            swing_mph=chosen["bat_speed_mph"],
            incoming_mph=chosen.get("pitch_speed_mph", 0.0),
            met_from_tip_in=chosen["impact_from_tip_in"],
        )
        answer = sports.answer(state)
        for system, reader in SYSTEMS.items():
            assert found[system]["headline"] == " ".join(answer.headline[system]), chosen
            force = with_minus_signs(reader.shown(float(answer.hit.peak_force), "blow"))
            assert found[system]["facts"]["Peak force"] == force


@pytest.mark.parametrize("name", ["r161-ash", "slow-pitch"])
def test_intervals_are_those_of_every_source_one_by_one(name: str, opened_file: Callable[..., Page]) -> None:
    page, bat = opened_file(name), offline_bat(name)
    settings = [
        {**chosen, "impact_from_tip_in": 1 + place} for place, chosen in enumerate(settings_of(page, seed=3)[:8])
    ]
    assert bat.sources is not None
    count = len(bat.sources.names)
    for chosen, found in zip(settings, page.evaluate(READ, settings), strict=True):
        conditions = bat.conditions.replaced(
            pitch=Pitch(speed=chosen["pitch_speed_mph"] * MPH),
            swing=bat.conditions.swing.replaced(bat_speed=chosen["bat_speed_mph"] * MPH),
        )
        draws = draws_of(bat.reduced.beam, conditions, bat.sources, count=2 * count, normal=one_by_one(count))
        place = np.array([bat.reduced.bat.length - chosen["impact_from_tip_in"] * INCH])
        up, down = hits_along(draws, place).exit_speed[1:, 0].reshape(2, count)
        half = REACH * float(np.linalg.norm((up - down) / 2)) / MPH
        printed = re.search(r"± ([\d.]+)", found["us"]["facts"]["Exit speed"])
        assert printed is not None
        assert float(printed[1]) == pytest.approx(half, abs=0.05 + 0.01), chosen


@pytest.mark.parametrize(
    "name",
    ["r161-ash", "corked-r161", "slow-pitch", "double-wall", "cricket-bat",
     "badminton-racket", "pickleball-paddle"],
)  # fmt: skip
def test_a_file_is_small_whole_and_asks_for_nothing(name: str) -> None:
    content = offline_file(offline_bat(name), head=FileHead(title="<b>", made_for="R & D"))
    assert len(content) <= LARGEST
    text = content.decode()
    assert "<h1>&lt;b&gt;</h1>" in text
    assert "R &amp; D" in text
    assert not re.search(r"@(?:title|style|content|script|foot)@", text)
    assert not re.search(r"""(?:src|href)\s*=|https?://|import\s*\(|fetch\(|XMLHttp|WebSocket\(""", text)


def test_the_film_shows_the_hit_of_the_page(opened_file: Callable[..., Page]) -> None:
    page = opened_file("r161-ash")
    page.locator("#film summary").click()
    page.wait_for_selector("#moment-words:not(:empty)")  # the fold tells that it is open a little later
    reached = hit.answer(hit.HitFilmState(bat="r161-ash", impact_from_tip_in=5.7)).top_hand.arrival
    assert reached is not None
    words = {}
    for moment in (-0.2, 0.3, 1e3 * float(reached) - 0.1, 1e3 * float(reached) + 0.1, 4.0):
        page.evaluate(
            """(moment) => { const range = document.querySelector("#moment"); range.value = moment;
              range.dispatchEvent(new Event("input")); }""",
            moment,
        )
        words[moment] = page.locator("#moment-words").inner_text()
    told = [text.split(": ", 1)[1] for text in words.values()]
    film = [phase.split(": ", 1)[1] for _, phase in film_phases(1.0, 2.0)]
    assert told[0] == film[0]
    assert re.fullmatch(film[1].format(pressed=r"0\.\d\d in", force=r"\d{4} lbf"), told[1])
    assert told[2].endswith("the hands feel nothing yet")
    assert told[3].endswith("the wave has reached the hands")
    assert told[4] == "the ball has left; the wave has reached the hands"


@pytest.mark.parametrize(("width", "height"), [(390, 844), (844, 390), (1440, 900)])
@pytest.mark.parametrize("theme", ["light", "dark"])
def test_a_file_is_readable_and_reachable_everywhere(
    width: int, height: int, theme: str, opened_file: Callable[..., Page]
) -> None:
    page = opened_file("composite", viewport={"width": width, "height": height}, color_scheme=theme)
    for fold in page.locator("summary").all():
        if fold.locator("..").get_attribute("open") is None:
            fold.click()
    page.locator("#worksheet").click()
    page.wait_for_timeout(50)
    for name in ("names", "contrast"):
        assert page.evaluate(f"{CHECKS.rstrip()}.{name}()") == []
    assert page.evaluate("document.documentElement.scrollWidth <= innerWidth")


def test_the_picture_is_a_slider_and_printing_opens_folds(opened_file: Callable[..., Page]) -> None:
    page = opened_file("r161-ash")
    picture = page.get_by_role("slider", name="The bat to scale")
    picture.focus()
    before = float(picture.get_attribute("aria-valuenow") or "nan")
    page.keyboard.press("ArrowLeft")
    page.wait_for_function(
        "(before) => Number(document.querySelector('[role=slider]').ariaValueNow) > before", arg=before
    )
    assert float(picture.get_attribute("aria-valuenow") or "nan") == pytest.approx(before + 0.1)
    folds = "[...document.querySelectorAll('details')].map((fold) => fold.open)"
    shut = page.evaluate(folds)
    assert not all(shut)
    page.evaluate("dispatchEvent(new Event('beforeprint'))")
    assert all(page.evaluate(folds))
    page.evaluate("dispatchEvent(new Event('afterprint'))")
    assert page.evaluate(folds) == shut


def test_a_worksheet_asks_and_does_not_tell(opened_file: Callable[..., Page]) -> None:
    page = opened_file("r161-ash")
    page.locator("#worksheet").click()
    assert page.locator("#sheet li").count() >= 5
    assert "1 in nearer the hands" in page.locator("#sheet").inner_text()
    assert not page.locator(".facts").is_visible()
    page.locator("#worksheet").click()
    assert page.locator(".facts").is_visible()


def test_the_command_writes_it(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = tmp_path / "mine.html"
    with pytest.raises(SystemExit) as stopped:
        main(["report", "r161-ash", "--offline", str(path), "--for", "Ann", "--pitch-speed", "80mph"])
    assert stopped.value.code == 0
    assert str(path) in capsys.readouterr().err
    assert "Ann" in path.read_text(encoding="utf-8")
    with pytest.raises(SystemExit) as stopped:
        main(["report", "r161-ash", "--offline", str(tmp_path / "nowhere" / "x.html")])
    assert stopped.value.code == 2
    assert "cannot be written" in capsys.readouterr().err


def test_the_page_gives_it_away(client: httpx.Client) -> None:
    state = {"bat": "composite", "impact_from_tip_in": 4.2, "choke_up_in": 1.0}
    answer = client.post("/api/v1/explorer/file", json=state).raise_for_status().json()
    assert answer["name"] == "composite-one-piece-33-in.html"
    assert '"impact_from_tip_in":4.2' in answer["html"]
    assert "swung with the same effort as before the change" in answer["html"]


def test_the_export_saves_it(page: Page, server: str, answered: Answered) -> None:
    page.goto(f"{server}/hit?bat=r161-ash&impact_from_tip_in=7.3&pitch_speed_mph=81")
    answered(page)
    page.get_by_role("button", name="Export").click()
    with page.expect_download() as download:
        page.get_by_role("button", name="Save as one file").click()
    assert download.value.suggested_filename == "r161-white-ash.html"
    saved = download.value.path().read_text(encoding="utf-8")
    assert '"state":{"impact_from_tip_in":7.3,"pitch_speed_mph":81.0' in saved


def test_only_plain_arithmetic_is_translated() -> None:
    assert "Number.isFinite(bend)" in javascript_of([vertex])
    with pytest.raises(TranslationError, match="no translation of '\\[value for"):
        javascript_of([listing])
    with pytest.raises(TranslationError, match=r"no translation of a call of np\.cumsum"):
        javascript_of([adding])


def listing(values: list[float]) -> list[float]:
    """Return what the translation does not know."""
    return [value for value in values]  # noqa: C416


def adding(values: Any) -> Any:
    """Return what the translation has no word for."""
    return np.cumsum(values)


def test_only_known_imports_are_bundled() -> None:
    with pytest.raises(BundleError, match="no way is known to bundle 'import \\* as"):
        bundled("a.js", {"a.js": 'import * as b from "./b.js";\n', "b.js": ""})
    with pytest.raises(BundleError, match="modules import each other"):
        bundled("a.js", {"a.js": 'import { b } from "./b.js";\n', "b.js": 'import { a } from "./a.js";\n'})


@pytest.mark.parametrize("size", [4, 5, 8])
def test_numbers_survive_as_text(size: int) -> None:
    from base64 import b64decode

    values = np.array([[0.0, -1.0 / 3], [1e-9, 123456.789]])
    packed = PackedArray.of(values, size=size)
    raw = np.frombuffer(b64decode(packed.base64), np.uint8).reshape(-1, size)
    if size == 4:
        read = raw.reshape(-1).view("<f4").astype(float)
    else:
        read = np.pad(raw, ((0, 0), (8 - size, 0))).reshape(-1).view("<f8")
    assert packed.shape == (2, 2)
    np.testing.assert_allclose(read, values.ravel(), rtol={4: 6e-8, 5: 2e-9, 8: 0}[size])

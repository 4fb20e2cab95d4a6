"""Anything at one drop: what a file is follows from it alone, and a bat in it lies on the bench."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import httpx
import numpy as np
import pytest
from playwright.sync_api import Page, expect

from sweetspot import catalog
from sweetspot.catalog.files.write import bat_toml
from sweetspot.reports.drawings.drawing_file import drawing_bytes
from sweetspot.web.bats import bat_from_text
from tests.web.parts import Answered, Wait, bench

BAT = catalog.bat("mlb-a")
DROPPED = """([name, bytes]) => {
  const data = new DataTransfer();
  data.items.add(new File([new Uint8Array(bytes)], name));
  document.getElementById("view").dispatchEvent(new DragEvent("drop", { dataTransfer: data, bubbles: true }));
}"""
FROM_TIP = "in_from_tip,diameter_in\n" + "\n".join(f"{place},{2.5 if place < 12 else 1.0}" for place in range(34))


def brought(client: httpx.Client, name: str, content: bytes, **more: Any) -> httpx.Response:
    """Hand in a file and ask what it is."""
    key = client.post("/api/v1/uploads", json={"name": name, "size": len(content)}).raise_for_status().json()["upload"]
    client.post(f"/api/v1/uploads/{key}/0", content=content).raise_for_status()
    return client.post("/api/v1/bring", json={"upload": key, **more})


@pytest.mark.parametrize("ending", [".csv", ".svg", ".dxf", ".stl"])
def test_every_outline_that_is_written_is_taken_back(client: httpx.Client, ending: str) -> None:
    """Exact: the bat that was drawn, by its diameters, between stations as smooth as drawings make it."""
    name = f"a bat{ending}"
    answer = brought(client, name, drawing_bytes(BAT, Path(name))).raise_for_status().json()
    bat = bat_from_text(answer["toml"])
    assert (answer["kind"], bat.name) == ("bat", "a bat")
    places = np.linspace(0, BAT.length, 301)
    np.testing.assert_allclose(bat.diameter_at(places), BAT.diameter_at(places), atol=1e-3)
    assert any("white ash" in words for words in answer["notes"]["us"])  # what was assumed is told
    assert "cm" in answer["notes"]["si"][0] and " in " not in answer["notes"]["si"][0]


@pytest.mark.parametrize(
    ("name", "content", "kind"),
    [
        ("own.toml", bat_toml(BAT), "bat"),
        ("racket.toml", 'like = "tennis-racket"\nname = "Mine"\nmass = "310 g"\n', "implement"),
        ("ball.toml", 'like = "baseball"\nname = "Cold"\ntemperature = "40 degF"\n', "ball"),
        ("swings.csv", "exit_speed_mph,launch_angle_deg\n" + "90,20\n" * 40, "swings"),
        ("season.csv", "exit_speed_mph,launch_angle_deg\n" + "90,20\n" * 700, "season"),
        ("season.csv.gz", "not looked at", "season"),
        ("player.json", "{}", "batter"),
        ("tap.wav", "RIFF", "sound"),
    ],
)
def test_what_a_file_is(client: httpx.Client, name: str, content: str, kind: str) -> None:
    assert brought(client, name, content.encode()).raise_for_status().json()["kind"] == kind


def test_what_is_not_in_the_file_is_asked_for(client: httpx.Client) -> None:
    answer = brought(client, "caliper.csv", FROM_TIP.encode()).raise_for_status().json()
    assert answer["asks"] == "length_in" and not answer["toml"]
    assert "from the tip" in answer["notes"]["us"][0] and "--" not in answer["notes"]["us"][0]
    answer = brought(client, "caliper.csv", FROM_TIP.encode(), length_in=34).raise_for_status().json()
    assert bat_from_text(answer["toml"]).length == pytest.approx(34 * 0.0254)


@pytest.mark.parametrize(
    ("name", "content", "words"),
    [
        ("bat.toml", "name = ", "bat.toml"),
        ("bat.toml", 'name = "x"\n', "length"),
        ("bat.svg", "<svg/>", "bat.svg"),
        ("bat.stl", "solid x\nendsolid", "no triangles"),
        ("bat.jpg", "JFIF", "bat.jpg"),
        ("bat.heic", "x", "bat.heic"),
    ],
)
def test_what_is_wrong_is_told_by_the_name_of_the_file(
    client: httpx.Client, name: str, content: str, words: str
) -> None:
    answer = brought(client, name, content.encode(), length_in=33)
    assert answer.status_code == 422
    message = answer.json()["error"]["message"]
    assert words in message and "/tmp" not in message and "--" not in message


def test_a_drawing_dropped_anywhere_lies_on_the_bench(page: Page, server: str, settled: Wait) -> None:
    page.goto(server)
    settled(page)
    page.evaluate(DROPPED, ["lathe.dxf", list(drawing_bytes(BAT, Path("lathe.dxf")))])
    dialog = page.locator("dialog")
    expect(dialog).to_contain_text("Read: 34.0 in long, 2.52 in at its widest.")
    dialog.get_by_role("button", name="Close").click()
    expect(page.locator("#bench-chip")).to_contain_text("lathe")
    expect(page.locator("#verdict")).to_contain_text("lathe hits fastest")


def test_a_length_that_is_missing_is_asked_for_in_the_readers_units(
    page: Page, server: str, answered: Answered, settled: Wait, tmp_path: Path
) -> None:
    page.goto(f"{server}/modes")
    page.get_by_role("radio", name="SI", exact=True).check()
    settled(page)
    (tmp_path / "caliper.csv").write_text(FROM_TIP, encoding="utf-8")
    bench(page).locator("#any-file").set_input_files(tmp_path / "caliper.csv")
    length = page.get_by_label("Length of the bat")
    expect(length).to_have_value("83.8")
    length.fill("5")
    page.get_by_role("button", name="Read it").click()
    expect(page.locator("dialog [role=alert]")).to_be_visible()
    length.fill("86.36")
    page.get_by_role("button", name="Read it").click()
    expect(page.locator("dialog")).to_contain_text("Read: 86.4 cm long")


def test_sounds_and_tables_go_to_the_views_that_read_them(
    page: Page, server: str, settled: Wait, until: Callable[[Page, str], Any]
) -> None:
    page.goto(server)
    settled(page)
    rows = "bat_speed_mph,exit_speed_mph\n" + "".join(f"{60 + i % 9},{75 + i % 17}\n" for i in range(30))
    page.evaluate(DROPPED, ["swings.csv", list(rows.encode())])
    expect(page.locator("#view")).to_have_attribute("data-view", "player")
    expect(page.locator("#verdict")).to_contain_text("30 swings")
    page.evaluate(DROPPED, ["nothing.toml", list(b"name =")])
    expect(page.locator("dialog")).to_contain_text("nothing.toml")

"""Take the pictures of the page that the documentation shows, or some of them, into docs/pictures.

``python tools/picture_page.py [NAME…]``
"""

from __future__ import annotations

import io
import sys
import threading
import time
from pathlib import Path

from PIL import Image
from playwright.sync_api import sync_playwright

from sweetspot import catalog
from sweetspot.calibration.recording import recording_bytes, synthesised
from sweetspot.calibration.tap_analysis import modes_to_name
from sweetspot.units import INCH
from sweetspot.web.run_server import listening, server_for

sys.path.insert(0, str(Path(__file__).parents[1]))

from tests.browsers import for_people

FOLDER = Path(__file__).parents[1] / "docs" / "pictures"
SHOTS = {
    "page-start": ("/", "light", 1180, 790),
    "page-explorer": ("/explorer?bat=r161-ash&offset_in=0.5", "light", 1180, 1060),
    "page-explorer-dark": ("/explorer?bat=composite", "dark", 1180, 760),
    "page-phone": ("/explorer?bat=youth-30&pitch_speed_mph=50&bat_speed_mph=50", "light", 390, 900),
    "page-hit": ("/hit?bat=single-wall&moment_ms=0.45", "light", 1180, 900),
    "page-modes": ("/modes", "light", 1180, 760),
    "page-compare": ("/compare", "light", 1180, 980),
    "page-flight": ("/flight", "light", 1180, 760),
    "page-space": ("/flight?start=swing&attack_angle_deg=12", "light", 1180, 760),
    "page-paper": ("/paper", "light", 1180, 900),
    "page-own": ("/own?weighed_oz=31.2&balanced_in=22.1&pendulum_ms=1454.5", "light", 1180, 1010),
    "page-own-tap": ("/own?weighed_oz=31&balanced_in=22.05&pendulum_ms=1454.5", "light", 1180, 1400),
    "page-design": ("/design", "light", 1180, 900),
    "page-season": ("/season", "light", 1180, 1130),
}
"""Name of the picture: address, theme, width and height in pixels."""
PRESSED = {"page-season": ("Look at a made-up season", "#view .facts")}
"""What is pressed before a picture is taken, and what is there once that is done."""
OPENED = {"page-space": "#space"}
"""A fold that is opened before a picture is taken."""
HANDED_IN = {"page-own-tap": "#tap-file"}
"""Where a made-up sound of taps is handed in before a picture is taken; its tones are then among the measurements."""
READING = 600_000
"""ms that a reading may take, its kernels compiled first."""
FLAGS = ["--no-sandbox", "--disable-gpu", "--no-first-run", "--disable-background-networking"]
COLOURS = 256


def main(wanted: list[str]) -> None:
    """Start a server, look at each view, or at those that are named, and keep what is seen."""
    opened = listening("127.0.0.1", 0)
    address = f"http://127.0.0.1:{opened.getsockname()[1]}"
    server = server_for()
    thread = threading.Thread(target=server.run, kwargs={"sockets": [opened]}, daemon=True)
    thread.start()
    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=for_people(), args=FLAGS)
        for name, (path, theme, width, height) in SHOTS.items():
            if wanted and name not in wanted:
                continue
            context = browser.new_context(viewport={"width": width, "height": height}, reduced_motion="reduce")
            context.add_init_script(f"localStorage.setItem('theme', '{theme}')")
            page = context.new_page()
            page.goto(address + path)
            page.locator("#view[data-answered]").wait_for()
            if name in HANDED_IN:
                taps = {"name": "taps.wav", "mimeType": "audio/wav", "buffer": taps_of("r161-ash")}
                page.locator(HANDED_IN[name]).set_input_files(taps)  # type: ignore[arg-type]
                page.locator("#view").get_by_text("bending 5").last.wait_for(timeout=READING)
            if name in OPENED:
                page.locator(f"{OPENED[name]} summary").click()
            if name in PRESSED:
                words, there = PRESSED[name]
                page.get_by_role("button", name=words).click()
                page.locator(there).wait_for(timeout=READING)
                page.locator("#view[data-waiting~=answer]").wait_for(state="detached", timeout=READING)
            page.locator("#view[data-waiting='']").wait_for(timeout=READING)  # lists, words and parts come later
            time.sleep(1.0)  # painted, and what grew has settled
            shot = Image.open(io.BytesIO(page.screenshot()))
            small = shot.convert("RGB").quantize(COLOURS, kmeans=3, dither=Image.Dither.NONE)
            small.save(FOLDER / f"{name}.png", optimize=True)
            context.close()
        browser.close()
    server.should_exit = True
    thread.join(10)


def taps_of(name: str) -> bytes:
    """Return a made-up sound file of taps on a bat of the catalogue, 1 in from its tip."""
    bat = catalog.bat(name)
    place = bat.length - INCH
    sound = synthesised(modes_to_name(bat), position=place, listened=place)
    return recording_bytes(sound, Path("taps.wav"))


if __name__ == "__main__":
    main(sys.argv[1:])

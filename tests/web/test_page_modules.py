"""The page's modules one by one, in the browser that runs them: numbers in, numbers out, nothing drawn.

What needs no browser is tested by Node: `test_modules_in_node.py`.
"""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest
from playwright.sync_api import BrowserContext, Page, expect

from sweetspot.reports.quantities import PALETTE, SI, US
from sweetspot.web.page_modules import FOLDER
from tests.web.parts import Answered, Wait

SOUND = ("recorder",)
"""Modules that run where sound is heard, and nowhere else."""


@pytest.fixture(scope="module")
def run(visitor: BrowserContext, server: str) -> Iterator[Callable[[str], Any]]:
    """A function that evaluates a script with every module of the page as a part of `m`, all in one page."""
    elsewhere = {"views", "offline"}  # begun by the page itself; bundled with a kernel that is made for one bat
    paths = [path.relative_to(FOLDER) for path in sorted(FOLDER.glob("*/*.js")) if path.parent.name not in elsewhere]
    kept = [path for path in paths if path.stem not in ("main", "docs", *SOUND)]
    parts = [f"{path.stem}: await import('/static/{path.as_posix()}')" for path in kept]
    page = visitor.new_page()
    page.goto(f"{server}/docs")
    page.evaluate(f"(async () => {{ window.m = {{ {', '.join(parts)} }}; }})()")
    yield lambda script: page.evaluate(f"(async () => {{ const m = window.m; return {script}; }})()")
    page.close()


def test_units_are_those_of_the_package(run: Callable[[str], Any]) -> None:
    for value, name, scale in (
        (41.2, "exit_speed_m_s", "speed"),
        (0.881, "mass_kg", "mass"),
        (104.2, "distance", "distance"),
    ):
        for system, reader in (("us", US), ("si", SI)):
            shown = run(f"m.units.text('{name}', {value}, '{system}')").replace("\N{MINUS SIGN}", "-")
            assert shown == reader.shown(value, scale)
    assert run("m.units.text('exit_speed_m_s', -0.001, 'us')") == "0.0 mph"


def test_what_charts_are_made_of(run: Callable[[str], Any]) -> None:
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


def test_a_chart_puts_numbers_where_its_axis_says(run: Callable[[str], Any]) -> None:
    """Exact: between the margins of 46 and 12 pixels places are even; half of 0.8 m lies in the middle."""
    svg = run("""(() => {
      const axis = { kind: "position_m", from: () => 0.8, label: "from the tip" };
      const panels = [{ title: "A", kind: "ratio", height: 100, lines: [{ key: "a", color: "red" }] }];
      const chart = new m.chart.Chart({ units: "si", colors: { red: "#f00" } }, { label: "it", panels, axis });
      chart.draw({ x: [0, 0.4, 0.8], lines: { a: [0, 1, 0] }, range: [0, 0.8] });
      const context = new m.svgcontext.SvgContext(458, 200);
      chart.paint(context, 458);
      return context.toString();
    })()""")
    (curve,) = re.findall(r'd="(M46 [^"]+)" fill="none" stroke="#f00"', svg)
    assert [float(x) for x in re.findall(r"[ML]([0-9.]+) ", curve)] == pytest.approx([46, 246, 446])
    assert "from the tip</text>" in svg
    ticks = re.findall(r'matrix\(1 0 0 1 ([0-9.]+) [0-9.]+\)" text-anchor="middle"[^>]*>([0-9]+)</text>', svg)
    assert len(ticks) > 4
    for x, centimetres in ticks:
        assert float(x) == pytest.approx(46 + 400 * (1 - float(centimetres) / 80), abs=0.01)
    assert run("m.chartpaint.shownPlace({ kind: 'position_m', from: () => 0.8 }, 0.7, 'si')") == pytest.approx(
        run("m.units.toShown('position_m', 0.1, 'si')")
    )
    assert run("(() => { const lines = [[1, null], [2, 3]]; m.chartpaint.stack(lines); return lines[1]; })()") == [3, 3]
    assert run("(() => { const two = [[null], [null]]; m.chartpaint.stack(two); return two[1]; })()") == [None]
    assert run("m.chartpaint.stretches([null, 1, 2, null, null, 3])") == [[1, 2], [5, 5]]


def test_pictures_as_svg_are_what_a_canvas_would_draw(run: Callable[[str], Any]) -> None:
    """Exact: places by hand; arcs are as long as the circle's, as the browser measures its own paths."""
    path = """((draw) => {
      const context = new m.svgcontext.SvgContext(100, 100);
      context.beginPath();
      draw(context);
      context.stroke();
      return /d="([^"]*)"/.exec(context.toString())[1];
    })"""
    assert run(f"{path}((c) => {{ c.translate(10, 5); c.scale(2); c.moveTo(0, 0); c.lineTo(3, 4); }})") == "M10 5L16 13"
    assert run(f"{path}((c) => {{ c.rotate(Math.PI / 2); c.moveTo(7, 0); c.lineTo(0, 0); }})") == "M0 7L0 0"
    twice = "c.rotate(Math.PI / 4); c.rotate(Math.PI / 4)"
    assert run(f"{path}((c) => {{ {twice}; c.translate(3, 0); c.moveTo(1, 0); c.lineTo(0, 2); }})") == "M0 4L-2 3"
    for start, stop, backwards, turns in (
        (0, math.pi, "false", 0.5),
        (0, math.pi / 2, "true", 0.75),
        (0, 7, "false", 1),
    ):
        length = run(f"""(() => {{
          const path = document.createElementNS("http://www.w3.org/2000/svg", "path");
          path.setAttribute("d", {path}((c) => c.arc(50, 50, 30, {start}, {stop}, {backwards})));
          return path.getTotalLength();
        }})()""")
        assert length == pytest.approx(turns * 2 * math.pi * 30, rel=2e-3)
    svg = run("""(() => {
      const c = new m.svgcontext.SvgContext(100, 100);
      c.save();
      c.globalAlpha = 0.5;
      c.rect(0, 0, 10, 10);
      c.clip();
      c.fillText('a < b & "c"', 1, 2);
      c.restore();
      c.fillRect(0, 0, 1, 1);
      return c.toString();
    })()""")
    assert "a &#60; b &#38; &#34;c&#34;" in svg
    assert svg.count("<g ") == svg.count("</g>") == 1
    assert svg.count('opacity="0.5"') == 1  # restored


def test_words_numbers_and_files_that_the_page_makes(run: Callable[[str], Any]) -> None:
    assert run("m.numbers.evenly([0, 1, 2, 3, 4, 5, 6, 7, 8, 9], 4)") == [0, 3, 6, 9]
    assert run("m.controls.boundsOf({ anyOf: [{ minimum: 1, maximum: 2 }, { type: 'null' }] })") == {
        "least": 1,
        "most": 2,
    }
    assert run("[-1, 0, 0.5, 1].map(m.heat.heat)") == [
        "rgb(68, 1, 84)",
        "rgb(68, 1, 84)",
        "rgb(33, 145, 140)",
        "rgb(253, 231, 37)",
    ]
    assert run("m.exports.csvOf({ a_m: [1, null], b: ['x\"y', 2], no_column: 3 })") == 'a_m,b\n1,"x""y"\n,2\n'
    formula = run("m.formula.mathOf('{ F_1 | I } = l^2').outerHTML")
    assert "<mfrac><mrow><msub><mi>F</mi><mn>1</mn></msub></mrow><mrow><mi>I</mi></mrow></mfrac>" in formula
    assert 'alttext="(F_1) / (I) = l^2"' in formula
    assert "no }" in run("(() => { try { m.formula.mathOf('{ F | I'); } catch (error) { return error.message; } })()")
    assert "no HTMLElement at .it" in run(
        "(() => { try { m.parts.partOf(document, '.it', HTMLElement); } catch (error) { return error.message; } })()"
    )
    sound = run("""(async () => {
      const file = m.listening.wavOf([Float32Array.of(0, 0.5), Float32Array.of(-1)], 8000);
      const heard = await new OfflineAudioContext(1, 3, 8000).decodeAudioData(file);
      return [heard.sampleRate, ...heard.getChannelData(0)];
    })()""")
    assert sound == [8000, 0, 0.5, -1]
    assert run("m.film.Film.prototype.where.call({ times: [0, 1, 3] }, 2)") == [1, 0.5]


@pytest.mark.parametrize(
    ("loudness", "said"),
    [
        ("() => 0", ["nothing but silence"]),
        ("() => 0.5", ["too loud here"]),
        ("(i) => (i === 40 ? 0.01 : 0.0005)", ["too quiet"]),
        ("(i) => (i === 40 ? 0.01 : i === 80 ? 0.5 : 0.0005)", ["too quiet", ""]),
        ("(i) => (i < 200 ? 0 : 0.0005)", ["nothing but silence", ""]),
        ("(i) => (i === 40 ? 0.5 : 0.0005)", []),
    ],
)
def test_a_microphone_says_why_it_finds_no_tap(run: Callable[[str], Any], loudness: str, said: list[str]) -> None:
    heard = run(f"""(() => {{
      const words = [], loudness = {loudness};
      const onDoubt = (one) => words.push(one);
      const ear = new m.listening.Listening({{ onLevel() {{}}, onTap() {{}}, onEnd() {{}}, onDoubt }});
      ear.audio = {{ sampleRate: 48000 }};
      for (let i = 0; i < 300; i += 1) ear.take(new Float32Array(1024).fill(loudness(i)));
      return words;
    }})()""")
    assert len(heard) == len(said) and all(part in words for part, words in zip(said, heard, strict=True)), heard


def test_a_drag_ends_once(run: Callable[[str], Any]) -> None:
    """Whatever ends a later one: nothing of a drag listens any more when it is over."""
    ends = run("""(() => {
      const surface = new m.surface.Surface({}, { height: () => 1, paint() {} });
      surface.element.setPointerCapture = () => {};
      let ends = 0;
      surface.drags(({ last }) => { if (last) ends += 1; });
      for (const name of ["down", "up", "down", "up", "down", "cancel", "up", "cancel"])
        surface.element.dispatchEvent(new PointerEvent(`pointer${name}`, { button: 0 }));
      return ends;
    })()""")
    assert ends == 3


def test_a_film_stays_at_its_moment_while_a_hand_drags(run: Callable[[str], Any]) -> None:
    moments = run("""(() => {
      const seen = [];
      const app = { rests: true, control() {}, announce() {}, setState() {} };
      app.onFrame = (step) => { app.step = step; return () => {}; };
      const told = { field: "moment_ms", onMoment: (at) => seen.push(at), describe: () => ({ short: "", long: "" }) };
      const film = new m.transport.Transport(app, told);
      film.set({ from: 0, to: 1, frames: [0, 1], slowness: 1 });
      film.play();
      for (const [now, rests] of [[0, true], [100, true], [200, false], [300, false], [350, true]]) {
        app.rests = rests;
        app.step(now);
      }
      return seen;
    })()""")
    assert moments == pytest.approx([0.0, 0.1, 0.15])


def test_what_is_asked_apart_waits_for_the_picture(run: Callable[[str], Any]) -> None:
    asked = """(await new Promise((done) => {
      const told = [];
      const app = { name: "v", state: {}, asking: true, waits() {}, ask: async () => told.push(app.asking) };
      new m.later.Later(app).aside("a", [], 0, () => done(told));
      setTimeout(() => { app.asking = false; }, 200);
    }))"""
    assert run(asked) == [False]


def test_the_last_question_wins(run: Callable[[str], Any]) -> None:
    """While one is under way the others wait, and of those that wait only the latest is asked."""
    sent, drawn = run("""(() => {
      const [sent, drawn, Real] = [[], [], window.WebSocket];
      window.WebSocket = class { static OPEN = 1; readyState = 1; send(text) { sent.push(JSON.parse(text)); } };
      const line = new m.socket.Line({ onAnswer: (view, answer, state) => drawn.push([answer, state]), onStatus() {} });
      for (const a of [1, 2, 3]) line.ask("v", a);
      line.take({ id: 1, answer: "first" });
      line.take({ id: 7, answer: "of nobody" });
      line.take({ id: 2, answer: "last" });
      window.WebSocket = Real;
      return [sent, drawn];
    })()""")
    assert sent == [{"id": 1, "view": "v", "state": 1}, {"id": 2, "view": "v", "state": 3}]
    assert drawn == [["first", 1], ["last", 3]]


def test_the_first_question_goes_apart_and_falls_back_on_the_line(run: Callable[[str], Any]) -> None:
    """Its answer is drawn and not asked for again; where none comes the line asks; a line that was lost asks again."""
    sent, drawn = run("""(async () => {
      const [sent, drawn, Real, real] = [[], [], window.WebSocket, window.fetch];
      window.WebSocket = class {
        static OPEN = 1; readyState = 0;
        send(text) { sent.push(JSON.parse(text)); }
      };
      for (const gone of [false, true]) {
        window.fetch = async (path, { body }) => {
          if (gone) throw new Error("gone");
          return { ok: true, status: 200, json: async () => `${path} ${body}` };
        };
        const line = new m.socket.Line({ apart: true, onAnswer: (view, answer) => drawn.push(answer), onStatus() {} });
        line.ask("v", { a: 1 });
        await new Promise((done) => setTimeout(done, 0));
        line.socket.readyState = 1;
        line.socket.onopen();
        if (!gone) line.back = true, line.socket.onopen();  // lost, and there again
      }
      [window.WebSocket, window.fetch] = [Real, real];
      return [sent, drawn];
    })()""")
    assert drawn == ['/api/v1/v {"a":1}']
    assert sent == 2 * [{"id": 2, "view": "v", "state": {"a": 1}}]


def test_the_controls_of_another_bat_keep_its_part_of_the_state(run: Callable[[str], Any]) -> None:
    """What is as usual is left out; what is to be undone together is handed on."""
    seen = run("""(() => {
      const seen = [];
      const app = { name: "v", schema: { a: { default: 1 }, b: {} }, views: new Map([["v", { bat: ["a", "b"] }]]),
        state: { others: [{}, { b: 2 }] }, lists() {}, text() {},
        setState: (...all) => seen.push(all), commit: (...all) => seen.push(all) };
      const one = m.parts.scoped(app, 1);
      one.setState({ a: 3 }, { commit: false });
      one.setState({ b: null }, { commit: true });
      one.commit({ merge: "keys" });
      return [one.state, ...seen];
    })()""")
    assert seen == [
        {"a": 1, "b": 2},
        [{"others": [{}, {"a": 3, "b": 2}]}, {"commit": False}],
        [{"others": [{}, {}]}, {"commit": True}],
        [{"merge": "keys"}],
    ]


def test_the_pages_colours_are_the_packages() -> None:
    sheet = Path(FOLDER / "theme.css").read_text(encoding="utf-8")
    light = dict(re.findall(r"--([a-z-]+): (#[0-9a-f]{6})", sheet[: sheet.index("}")]))
    assert {name: light[name] for name in PALETTE} == dict(PALETTE)


def test_a_bat_by_questions_and_what_words_mean(page: Page, server: str, answered: Answered) -> None:
    page.goto(f"{server}/explorer")
    count = answered(page)
    page.locator("#bench-chip").click()
    page.get_by_role("button", name="Describe yours").click()
    page.get_by_label("Name", exact=True).fill("Grandfather's")
    page.get_by_label("Weight", exact=True).fill("15")
    page.get_by_role("button", name="Put it on the bench").click()
    expect(page.locator("#wizard-mass_oz-fault")).to_have_text("Allowed is 26.08 to 36.31 oz.")  # of white ash
    page.locator("#wizard-mass_oz").fill("32")
    page.get_by_role("button", name="Put it on the bench").click()
    answered(page, count)
    expect(page.locator("#bench-chip")).to_contain_text("Grandfather's")
    expect(page.locator("#verdict")).to_contain_text("Grandfather's hits fastest")
    word = page.locator("dt .term", has_text="BBCOR").first
    word.focus()
    expect(page.locator(".tip:visible")).to_contain_text("F2219")


def test_words_keep_their_meanings_when_a_view_is_drawn_anew(page: Page, server: str, settled: Wait) -> None:
    """Its tables are then other ones: another system of units or another width must not take the meanings away."""
    page.goto(f"{server}/compare")
    expect(page.locator("th .term", has_text="Swing weight").first).to_be_attached()  # drawn with the whole intervals
    settled(page)
    before = page.locator("th .term").all_text_contents()
    assert "Swing weight" in before
    acts: tuple[Callable[[], None], ...] = (
        lambda: page.get_by_role("radio", name="SI", exact=True).check(force=True),
        lambda: page.set_viewport_size({"width": 900, "height": 900}),
    )
    for act in acts:
        act()
        settled(page)
        assert page.locator("th .term").all_text_contents() == before

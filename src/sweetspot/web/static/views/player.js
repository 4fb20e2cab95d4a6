// The player: a table of measured swings, what it says of bat speed and scatter, and which bat and place serve.


import { button, choice, faultPlace, group, slider } from "../controls/controls.js";
import { DocumentPlace } from "../controls/document.js";
import { Numbers } from "../charts/numbers.js";
import { make } from "../controls/parts.js";
import { upload } from "../controls/upload.js";
import { Filter } from "./filter.js";
import { dot, line } from "../charts/pen.js";
import { FONT, Surface, ticks } from "../charts/surface.js";
import { fromShown, toShown, unitOf } from "../controls/units.js";
/** @import { Answers } from "../answers.js" */
/** @import { AppOf, Guide } from "../shell/main.js" */

const LONGEST = 40000; // letters that are taken as they are
const LARGEST = 10e6; // bytes
const LEFT = 46, FOOT = 34, TOP = 12, RIGHT = 12;

export default class PlayerView {
  /** @type {Guide} */
  static guide = [
    ["Your swings", "Bring a table of swings: Blast, HitTrax, Statcast, or two columns of bat speed and exit speed. Until then a made-up player stands here."],
    ["What they say", "The report tells mean bat speed, where you meet the ball, how much both scatter, and how sure that is."],
    ["What serves", "Below it: which bat, which place and what practice are worth how much. "],
  ];

  /** @param {HTMLElement} root @param {AppOf<"player">} app */
  constructor(root, app) {
    this.app = app;
    /** @type {Answers["player"] | null} */
    this.answer = null;
    const file = make("input", { type: "file", id: "swings-file", accept: ".csv,.tsv,.txt,.gz,.parquet,text/csv,text/plain" });
    file.addEventListener("change", () => {
      const chosen = [...(file.files ?? [])];
      file.value = "";
      this.bring(chosen);
    });
    this.whose = new Filter(app, "swings_of", { label: "Whose swings", all: "the first in the alphabet" });
    const side = make("div", { className: "side" },
      group("The swings", [
        make("p", { className: "own" }, make("label", { htmlFor: "swings-file", textContent: "Table of swings (CSV, .csv.gz, Parquet)" }), file), faultPlace(app, ["swings_csv"]),
        slider(app, "given_pitch_mph", { label: "Pitch, where a row has none", step: 1 }),
        this.whose.element, button("The example again", () => app.setState({ swings_csv: null, swings_of: null })),
      ]),
      group("What is wanted", [choice(app, "goal", { label: "More", options: [["exit-speed", "exit speed"], ["carry", "carry"]] })]));
    this.words = make("p", { className: "verdict", id: "verdict" });
    this.bad = make("ul", { className: "note" });
    this.points = new Surface(app, { height: () => 260, paint: (...all) => this.paint(...all) });
    this.points.element.classList.add("pinned");
    this.numbers = new Numbers(app, "These swings as a table", () => this.tabled());
    this.report = new DocumentPlace(app, "Reading the swings; this takes a few seconds …");
    root.append(side, make("div", { className: "stack" },
      make("section", { className: "picture" }, this.words, this.points.element, this.numbers.element, this.bad),
      make("section", { className: "picture" }, this.report.element)));
  }

  /** @param {File[]} files */
  async bring([file]) {
    if (!file) return;
    const { app } = this;
    const short = file.size <= LONGEST && !/\.(gz|parquet)$/i.test(file.name);
    if (file.size > LARGEST) {
      app.controls.get("swings_csv")?.fault?.(`${file.name} has ${(file.size / 1e6).toFixed(0)} MB; at most ${LARGEST / 1e6}. Hand in the rows of one batter, or take the command fit-player.`);
      return;
    }
    app.waits("table");
    if (!short) this.words.textContent = `Reading ${file.name} …`;
    try { // of a long file the server keeps the columns that mean something
      const text = short ? await file.text() : (await app.ask("player/table", { ...app.state, upload: await upload(file, undefined, app.signal) })).csv;
      app.setState({ swings_csv: text ?? null, swings_of: null });
    } catch (fault) {
      if (app.signal.aborted) return;
      app.redraw();
      app.controls.get("swings_csv")?.fault?.(fault.message);
    }
    if (!app.signal.aborted) app.waits("table", false);
  }

  /** @param {Answers["player"]} answer */
  update(answer) {
    this.answer = answer;
    this.whose.fill(answer.batters.map((name) => [name]));
    this.words.textContent = answer.words;
    this.app.announce(answer.words);
    this.bad.replaceChildren(...answer.notes[this.app.units].map((words) => make("li", { textContent: words })));
    this.points.label(`Exit speed against bat speed. ${answer.words}`);
    this.points.draw();
    this.numbers.redraw();
    this.report.redraw();
    this.app.aside("fit", [], 400, (found) => this.report.show(found));
  }

  tabled() {
    if (!this.answer) return null;
    const { bat_speed_m_s: bat, exit_speed_m_s: ball } = this.answer;
    const rows = bat.map((speed, i) => [String(i + 1), this.app.text("v_m_s", speed), this.app.text("v_m_s", ball[i])]);
    return { caption: "Measured swings", columns: ["Swing", "Bat speed", "Exit speed"], rows };
  }

  /** @param {CanvasRenderingContext2D} context @param {number} width @param {number} height */
  paint(context, width, height) {
    if (!this.answer) return;
    const { colors, units } = this.app, { bat_speed_m_s: bat, exit_speed_m_s: ball } = this.answer;
    const pairs = bat.flatMap((speed, i) => (speed === null || ball[i] === null ? [] : [[speed, ball[i] ?? 0]]));
    if (!pairs.length) return;
    const [[least, most], [low, high]] = [0, 1].map((k) => pairs.map((pair) => pair[k])).map((speeds) => [Math.min(...speeds), Math.max(...speeds)]);
    const across = (/** @type {number} */ x) => LEFT + 8 + ((x - least) / (most - least || 1)) * (width - LEFT - RIGHT - 16);
    const up = (/** @type {number} */ y) => TOP + 8 + (1 - (y - low) / (high - low || 1)) * (height - TOP - FOOT - 16);
    const shown = (/** @type {number} */ value) => toShown("v_m_s", value, units);
    Object.assign(context, { font: `11px ${FONT}`, fillStyle: colors.muted, textAlign: "right", textBaseline: "middle" });
    for (const value of ticks(shown(low), shown(high), 5)) {
      const y = up(fromShown("v_m_s", value, units));
      context.fillText(String(value), LEFT - 6, y);
      line(context, [[LEFT, y], [width - RIGHT, y]], colors.grid);
    }
    Object.assign(context, { textAlign: "center", textBaseline: "top" });
    for (const value of ticks(shown(least), shown(most), width / 90)) context.fillText(String(value), across(fromShown("v_m_s", value, units)), height - FOOT + 4);
    context.textAlign = "right";
    context.fillText(`${unitOf("v_m_s", units)}: bat speed →, exit speed ↑`, width - RIGHT, height - 14);
    for (const [x, y] of pairs) dot(context, [across(x), up(y)], 4, { fill: colors.blue, edge: colors.panel, width: 1 });
  }

  figures() { return [this.points.figure("swings")]; }
  table() {
    const { bat_speed_m_s = [], exit_speed_m_s = [] } = this.answer ?? {};
    return { bat_speed_m_s, exit_speed_m_s };
  }
}

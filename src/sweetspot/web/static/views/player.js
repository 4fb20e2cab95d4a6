// The player: a table of measured swings, what it says of bat speed and scatter, and which bat and place serve.

import { Bench } from "../bat/bench.js";
import { button, choice, group, reveal, slider } from "../controls/controls.js";
import { DocumentPlace } from "../controls/document.js";
import { Numbers } from "../charts/numbers.js";
import { make } from "../controls/parts.js";
import { upload } from "../controls/upload.js";
import { Filter } from "./filter.js";
import { FONT, Surface, ticks } from "../charts/surface.js";
import { fromShown, toShown, unitOf } from "../controls/units.js";
/** @import { Answer, View } from "../shell/main.js" */

const LONGEST = 40000; // letters that are taken as they are
const LARGEST = 10e6; // bytes
const LEFT = 46, FOOT = 34, TOP = 12, RIGHT = 12;

/** @type {View<"player">} */
export const view = {
  name: "player",
  guide: [
    ["Your swings", "Bring a table of swings: Blast, HitTrax, Statcast, or two columns of bat speed and exit speed. Until then a made-up player stands here."],
    ["What they say", "The report tells mean bat speed, where you meet the ball, how much both scatter, and how sure that is."],
    ["What serves", "Below it: which bat, which place and what practice are worth how much. "],
  ],

  mount(root, app) {
    Object.assign(this, { app, answer: null });
    this.bench = new Bench(app, { open: false });
    const file = make("input", { type: "file", id: "swings-file", accept: ".csv,.tsv,.txt,.gz,.parquet,text/csv,text/plain" });
    file.addEventListener("change", () => this.read(file));
    this.wrong = make("p", { className: "fault", hidden: true });
    app.control({ field: "swings_csv", sync: () => {}, fault: (message) => {
      this.wrong.textContent = message;
      this.wrong.hidden = message === "";
      if (message) reveal(this.wrong);
    } });
    this.whose = new Filter(app, "swings_of", { label: "Whose swings", all: "the first in the alphabet" });
    const side = make("div", { className: "side" },
      group("The swings", [
        make("p", { className: "own" }, make("label", { htmlFor: "swings-file", textContent: "Table of swings (CSV, .csv.gz, Parquet)" }), file), this.wrong,
        slider(app, "given_pitch_mph", { label: "Pitch, where a row has none", step: 1 }),
        this.whose.element, button("The example again", () => app.setState({ swings_csv: null, swings_of: null })),
      ]),
      group("What is wanted", [choice(app, "goal", { label: "More", options: [["exit-speed", "exit speed"], ["carry", "carry"]] })]),
      this.bench.element);
    this.words = make("p", { className: "verdict", id: "verdict" });
    this.bad = make("ul", { className: "note" });
    this.points = new Surface(app, { height: () => 260, paint: (...all) => this.paint(...all) });
    this.points.element.classList.add("pinned");
    this.numbers = new Numbers(app, "These swings as a table", () => this.tabled());
    this.report = new DocumentPlace(app, "Reading the swings; this takes a few seconds …");
    root.append(side, make("div", { className: "stack" },
      make("section", { className: "picture" }, this.words, this.points.element, this.numbers.element, this.bad),
      make("section", { className: "picture" }, this.report.element)));
  },

  /** @param {HTMLInputElement} input */
  async read(input) {
    const file = input.files?.[0];
    if (!file) return;
    input.value = "";
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
      app.setState({ swings_csv: text, swings_of: null });
    } catch (fault) {
      if (app.signal.aborted) return;
      app.redraw();
      app.controls.get("swings_csv")?.fault?.(fault.message);
    }
    if (!app.signal.aborted) app.waits("table", false);
  },

  update(answer) {
    this.answer = answer;
    this.bench.update(answer);
    const { count, bad_rows: bad, batter, batters, example, notes } = answer;
    this.whose.fill(batters.map((/** @type {string} */ name) => [name]));
    const many = (/** @type {number} */ number, /** @type {string} */ words) => `${number} ${words}${number === 1 ? "" : "s"}`;
    this.words.textContent = `${many(count, "swing")}${batter === null ? "" : ` of ${batter}`}${example ? " of a made-up player; bring your own table to read yours" : ""}${bad ? `; ${many(bad, "row")} could not be used` : ""}.`;
    this.app.announce(this.words.textContent);
    this.bad.replaceChildren(...notes[this.app.units].map((/** @type {string} */ words) => make("li", { textContent: words })));
    this.points.label(`Exit speed against bat speed of ${many(count, "swing")}.`);
    this.points.draw();
    this.numbers.redraw();
    this.report.redraw();
    this.app.aside("fit", [], 400, (found) => this.report.show(found));
  },

  tabled() {
    if (!this.answer) return null;
    const { bat_speed_m_s: bat, exit_speed_m_s: ball } = this.answer;
    const words = (/** @type {number} */ value) => (typeof value === "number" ? this.app.text("v_m_s", value) : "–");
    return { caption: "Measured swings", columns: ["Swing", "Bat speed", "Exit speed"], rows: bat.map((/** @type {Answer} */ one, /** @type {number} */ i) => [String(i + 1), words(one), words(ball[i])]) };
  },

  /**
   * @param {CanvasRenderingContext2D} context
   * @param {number} width
   * @param {number} height
   */
  paint(context, width, height) {
    if (!this.answer) return;
    const { colors, units } = this.app;
    const pairs = this.answer.bat_speed_m_s.map((/** @type {number} */ x, /** @type {number} */ i) => [x, this.answer.exit_speed_m_s[i]]).filter((/** @type {[number, number]} */ [x, y]) => typeof x === "number" && typeof y === "number");
    if (!pairs.length) return;
    const span = (/** @type {number} */ k) => [Math.min(...pairs.map((/** @type {number[]} */ pair) => pair[k])), Math.max(...pairs.map((/** @type {number[]} */ pair) => pair[k]))];
    const [[least, most], [low, high]] = [span(0), span(1)];
    const across = (/** @type {number} */ x) => LEFT + 8 + ((x - least) / (most - least || 1)) * (width - LEFT - RIGHT - 16);
    const up = (/** @type {number} */ y) => TOP + 8 + (1 - (y - low) / (high - low || 1)) * (height - TOP - FOOT - 16);
    Object.assign(context, { font: `11px ${FONT}`, fillStyle: colors.muted, strokeStyle: colors.grid, lineWidth: 1 });
    const shown = (/** @type {number} */ value) => toShown("v_m_s", value, units);
    for (const value of ticks(shown(low), shown(high), 5)) {
      const y = up(fromShown("v_m_s", value, units));
      Object.assign(context, { textAlign: "right", textBaseline: "middle" });
      context.fillText(String(value), LEFT - 6, y);
      context.beginPath();
      context.moveTo(LEFT, y);
      context.lineTo(width - RIGHT, y);
      context.stroke();
    }
    for (const value of ticks(shown(least), shown(most), width / 90)) {
      Object.assign(context, { textAlign: "center", textBaseline: "top" });
      context.fillText(String(value), across(fromShown("v_m_s", value, units)), height - FOOT + 4);
    }
    context.textAlign = "right";
    context.fillText(`${unitOf("v_m_s", units)}: bat speed →, exit speed ↑`, width - RIGHT, height - 14);
    Object.assign(context, { fillStyle: colors.blue, strokeStyle: colors.panel });
    for (const [x, y] of pairs) {
      context.beginPath();
      context.arc(across(x), up(y), 4, 0, 2 * Math.PI);
      context.fill();
      context.stroke();
    }
  },

  unmount() { Object.assign(this, { answer: null }); },
  figures() { return [this.points.figure("swings")]; },
  table() {
    const { bat_speed_m_s, exit_speed_m_s } = this.app.answer;
    return { bat_speed_m_s, exit_speed_m_s };
  },
};

// Every sport: what one hits with, its face as a map, and what a hit at a place gives, in the sport's own words.

import { Chart } from "../charts/chart.js";
import { button, faultPlace, group, slider } from "../controls/controls.js";
import { HeatMap } from "../charts/heatmap.js";
import { factList, make, paragraphs, section, tell } from "../controls/parts.js";
import { INCH } from "../controls/units.js";
import { FORGOTTEN } from "./own_measured.js";
/** @import { SportsPicture, SportsFace, SportsWords } from "../answers.js" */
/** @import { Fact } from "../controls/parts.js" */
/** @import { AppOf, Guide, State } from "../shell/main.js" */

const PLACE = ["met_from_tip_in", "aside_in"]; // where the ball meets it changes neither map nor words

/** @type {Fact<SportsPicture>[]} */
const FACTS = [
  ["Leaves at", (a) => ["exit_speed_m_s", a.hit.exit_speed_m_s]],
  ["Efficiency", (a) => ["ratio", a.hit.collision_efficiency]],
  ["Moves at", (a) => ["bat_speed_m_s", a.hit.bat_speed_m_s]],
  ["Contact time", (a) => ["contact_time_s", a.hit.contact_time_s]],
  ["Peak force", (a) => ["peak_force_n", a.hit.peak_force_n]],
  ["Vibration at the handle", (a) => ["sting", a.hit.sting_m_s]],
  ["Weight", (a) => ["mass_kg", a.tool.mass_kg]],
  ["Length", (a) => ["length_m", a.tool.length_m]],
  ["Balance from the grip's end", (a) => ["balance_point_m", a.tool.balance_point_m]],
];

export default class SportsView {
  /** @type {Guide} */
  static guide = [
    ["Every sport", "Rackets, bats, clubs and sticks by the same physics: choose one, and its usual stroke meets its usual ball."],
    ["The face", "The map shows how fast the ball leaves from every place of the face. Press or drag on it to hit there."],
    ["Another stroke", "Change how fast it is swung and how fast the ball comes. "],
  ];

  /** @param {HTMLElement} root @param {AppOf<"sports">} app */
  constructor(root, app) {
    this.app = app;
    /** @type {SportsPicture | null} */
    this.answer = null;
    /** @type {SportsFace["face"] | null} */
    this.face = null;
    /** @type {SportsWords["sentences"] | null} */
    this.sentences = null;
    this.shown = ""; // the implement of both
    const usual = (/** @type {"swing_mph" | "incoming_mph"} */ name) => () => app.answer?.[name] ?? null;
    const side = make("div", { className: "side" },
      group("What one hits with", [make("div", { className: "row" }, button("Another one\u00a0…", () => app.bench.turn(true), { primary: true }),
      button("Weigh, balance and tap it", () => app.visitWith("own", { ...FORGOTTEN, pivot_in: null, implement: app.state.implement, implement_toml: app.state.implement_toml }),
        { title: "In Own bat: from what you measure to this very one" })), faultPlace(app, ["implement", "implement_toml"])]),
      group("Stroke", [
        slider(app, "swing_mph", { label: () => `Speed of the ${this.ownWords().implement}`, step: 1, empty: usual("swing_mph") }),
        slider(app, "incoming_mph", { label: () => `Speed of the ${this.ownWords().ball} before`, step: 1, empty: usual("incoming_mph") }),
      ]),
      group("Where they meet", [
        slider(app, "met_from_tip_in", { label: () => `From the ${this.ownWords().tip}`, step: 0.1, empty: () => this.fromTip() }),
        slider(app, "aside_in", { label: "Across the face", step: 0.05 }),
      ]));
    this.words = make("p", { className: "verdict", id: "verdict" });
    this.again = make("p", { className: "note" });
    this.facts = factList(FACTS, app);
    const axis = this.axis = { kind: "position_m", from: () => this.answer?.tool.length_m ?? 0.7, label: "" };
    this.map = new HeatMap(app, { label: "", title: "", height: 240,
      x: axis, y: { kind: "lateral_m", label: "across" }, z: { kind: "exit_speed_m_s" }, onPick: (x, y, { last }) => this.pick(x, y, last) });
    this.map.element.classList.add("pinned");
    this.chart = new Chart(app, { label: "Speed, efficiency and vibration", axis, onPick: (x, { last }) => this.pick(x, null, last), panels: [
      { title: "", kind: "exit_speed_m_s", height: 140, lines: [{ key: "exit_speed_m_s", label: "real", color: "red", width: 2.4 },
        { key: "rigid_exit_speed_m_s", label: "rigid", color: "muted", dash: [5, 4], width: 1.6 }] },
      { title: "Efficiency", kind: "ratio", height: 80, lines: [{ key: "collision_efficiency", color: "orange" }] },
      { title: "Vibration at the handle", kind: "sting", height: 80, zero: true, lines: [{ key: "sting_m_s", color: "purple" }] }] });
    this.report = make("div", { className: "words" });
    root.append(side, make("div", { className: "stack" },
      make("section", { className: "picture" }, this.words, this.map.element, this.again, this.map.numbers.element, this.facts.element, this.chart.element),
      section("Where it hits best, and why", this.report)));
  }

  // What its people call things; before the first answer, what everybody does.
  ownWords() { return this.app.answer?.words ?? { implement: "implement", ball: "ball", tip: "tip" }; }

  fromTip() {
    const { answer } = this.app;
    return answer ? (answer.tool.length_m - answer.hit.position_m) / INCH : null;
  }

  /** @param {number} position @param {number | null} across @param {boolean} last */
  pick(position, across, last) {
    const { answer } = this;
    if (!answer) return;
    const inches = (/** @type {number} */ metres) => Math.round((20 * metres) / INCH) / 20;
    /** @type {Partial<State>} */
    const change = { met_from_tip_in: Math.max(0, inches(answer.tool.length_m - position)) };
    if (across !== null) change.aside_in = inches(across);
    this.app.setState(change, { commit: last });
  }

  /** @param {SportsPicture} answer */
  update(answer) {
    this.answer = answer;
    const { hit, scan, sweet_spots: spots, words } = answer;
    this.axis.label = `from the ${words.tip}`;
    this.chart.panels[0].title = `Speed of the ${words.ball}`;
    this.map.title = `Speed of the ${words.ball} over the face`;
    const { units } = this.app;
    const headline = [...answer.headline[units], ...hit.touched_again[units]].join(" ");
    tell(this.words, headline);
    tell(this.again, hit.touched_again[units].length ? "" : answer.touched_again[units].join(" "));
    this.app.announce(headline);
    this.facts.fill(answer);
    const shown = this.app.state.implement_toml ?? answer.implement;
    if (shown !== this.shown) Object.assign(this, { face: null, sentences: null, shown });
    this.drawFace(answer);
    paragraphs(this.report, this.sentences?.[this.app.units] ?? []);
    this.app.aside("face", PLACE, 80, ({ face }) => {
      this.face = face;
      if (this.answer) this.drawFace(this.answer);
    });
    this.app.aside("sentences", PLACE, 400, ({ sentences }) => {
      this.sentences = sentences;
      paragraphs(this.report, sentences[this.app.units]);
    });
    const zone = spots.zone_m;
    this.chart.draw({ x: scan.position_m, lines: { ...scan }, range: [scan.position_m[0], scan.position_m[scan.position_m.length - 1]], cursor: hit.position_m,
      bands: zone ? [{ from: zone[0], to: zone[1] }] : [], marks: [{ at: spots.max_exit_speed_m, color: "red", label: "fastest" }] });
    this.chart.label(`Speed of the ${words.ball}, efficiency and vibration along the ${words.implement}. ${headline}`);
  }

  // The map comes apart: the last one stands there until then.
  /** @param {SportsPicture} answer */
  drawFace({ hit, has_face: some }) {
    const { face } = this;
    this.map.element.hidden = this.map.numbers.element.hidden = !some;
    if (!some) return;
    if (!face) {
      this.map.clear();
      return;
    }
    this.map.draw({ x: face.position_m, y: face.lateral_m, z: face.exit_speed_m_s, cross: [hit.position_m, hit.lateral_m] });
    this.map.label(`How fast the ${this.ownWords().ball} leaves from every place of the face. ${this.words.textContent}`);
  }

  figures() { return [...(this.face ? [this.map.figure("face")] : []), this.chart.figure("curves")]; }
  table() { return { ...this.answer?.scan }; }
}

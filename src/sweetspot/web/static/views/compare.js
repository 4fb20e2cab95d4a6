// Compare: up to four bats in the same hands, or what a hole or another wall makes of one; curves, verdict, rules.

import { Chart } from "../charts/chart.js";
import { ballGroup, swingGroup, usualChoice } from "../bat/swing.js";
import { choice, group, slider, words } from "../controls/controls.js";
import { HowSure } from "../controls/howsure.js";
import { make, paragraphs, section, tableOf, tell, withDoubt } from "../controls/parts.js";
import { INCH } from "../controls/units.js";
import { ChangePicture, LINES, RowsPicture } from "./compare_pictures.js";
import { Slots } from "./compare_slots.js";
/** @import { CertifiedBats, ComparisonPicture, DrawnComparedBat, RuleRow, States, SureBat, SureComparison } from "../answers.js" */
/** @import { AppOf, Guide } from "../shell/main.js" */
/** @import { Curve } from "../charts/chart.js" */

/** @typedef {DrawnComparedBat & Partial<SureBat>} Bat  with its intervals, once they are there */
const BARREL = 12 * INCH; // shown until somebody zooms
const SWUNG = ["pitch_speed_mph", "bat_speed_mph", "hands_in", "same", "swing_law"]; // which no rule asks about
const VERDICT = 110; // pixels that a column of verdicts needs

export default class CompareView {
  /** @type {Guide} */
  static guide = [
    ["Which bat hits harder", "Up to four bats in the same player's hands, or one bat against itself after a change. " +
      "The verdict says what changes and how sure that is."],
    ["Read the curves", "One curve for each bat, tips aligned: how fast the ball leaves from each place. The table below " +
      "gives weight, swing weight, speeds, and the swing that would make up for the difference."],
    ["Change the question", "Choose the bats, the same effort or the same bat speed, and whose rules they are held against. "],
  ];

  /** @param {HTMLElement} root @param {AppOf<"compare">} app */
  constructor(root, app) {
    this.app = app;
    /** @type {ComparisonPicture | null} */
    this.answer = null;
    this.longest = 1; // m
    /** @type {{ asked: string, found: SureComparison } | null} */
    this.known = null; // the intervals, and of which question
    /** @type {CertifiedBats | null} */
    this.certified = null;
    this.ruled = ""; // the system of units in which it is shown
    this.rulesOpen = false;
    this.slots = new Slots(app);
    const hole = make("div", {},
      slider(app, "hole_diameter_in", { label: "Hole, width", step: 0.05 }),
      slider(app, "hole_depth_in", { label: "Hole, depth from the tip", step: 0.25 }));
    const wall = slider(app, "wall_times", { label: "Wall, times bat 1's own", step: 0.01 });
    const change = words(app, "change", { label: "Change",
      note: "lead 6g@27in, knob-weight 2oz, end-load 1oz, shaved 0.2mm, rolled, broken-in, moisture 14%, drilled 10in, cork, rubber, foam, cup 0.9in, cut 0.5in, handle -0.03in or taper 1in; several after commas." });
    app.control({ field: "parts of what_if", sync: ({ what_if: asked }) => {
      hole.hidden = asked !== "cork";
      wall.hidden = asked !== "wall";
      change.hidden = asked !== "change";
    } });
    const side = make("div", { className: "side" },
      group("Question", [
        choice(app, "what_if", { label: "Compare", options: [
          ["none", "these bats"], ["cork", "bat 1 drilled and corked"], ["wall", "bat 1 with another wall"],
          ["change", "bat 1 after a change"]] }),
        hole, wall, change,
        choice(app, "same", { label: "Swung with", options: [["effort", "the same effort"], ["speed", "the same bat speed"]] }),
        usualChoice(app, "swing_law", { label: "Players", options: [["baseball", "baseball"], ["slow-pitch", "slow-pitch softball"]] }),
      ]),
      this.slots.element, swingGroup(app, { title: "Swing of bat 1, and pitch", asked: false }), ballGroup(app),
    );
    this.words = make("div", { className: "words", id: "verdict" });
    this.chart = new Chart(app, { label: "Curves along the bats, tips aligned", panels: [], axis: { kind: "position_m", from: () => this.longest, label: "from the tip" } });
    this.rows = new RowsPicture(app);
    this.change = new ChangePicture(app);
    this.change.element.classList.add("pinned");
    this.bats = make("div");
    this.rules = make("div");
    this.reasons = make("div", { className: "words" });
    this.why = make("details", { className: "report" }, make("summary", { textContent: "Why, and what was published" }), this.reasons);
    this.wait = make("p", { className: "note", id: "working", textContent: "Working out how sure each difference is …" });
    this.assumed = make("p", { className: "note" });
    this.sure = new HowSure(app, { but: ["league"] });
    this.sureRules = new HowSure(app, { aside: "rules_sure", but: SWUNG, title: "How sure each bat's test is, and what that comes from" });
    const legend = make("p", { className: "note", textContent: "Dot: the ball leaves fastest there. Bar below the bat, and shaded stretch of the first one's in the curves: the sweet zone. Pale stretches around a curve: its 90 % interval. Square: a weight fixed to the bat." });
    const main = make("div", { className: "stack" },
      section("Verdict", this.words, this.wait, this.change.element, this.why),
      section("The bats and where they hit", this.rows.element, legend, this.chart.element, this.bats, this.assumed, this.sure.element),
      section("League rules", usualChoice(app, "league", { label: "Rules of", options: leagues(app) }), this.rules, this.sureRules.element));
    root.append(side, main);
  }

  /** @param {ComparisonPicture} answer @param {States["compare"]} state */
  update(answer, state) {
    this.answer = answer;
    this.longest = Math.max(...answer.bats.map(({ bat }) => bat.length_m));
    this.slots.update(answer, state);
    this.rows.draw(answer.bats, this.longest, answer.fastest[this.app.units].join(" "));
    const asked = JSON.stringify({ ...state, league: null });
    this.judge(answer, this.known?.asked === asked ? this.known.found : null);
    this.app.aside("intervals", ["league"], 150, (found) => {
      this.known = { asked, found };
      if (this.answer) this.judge(this.answer, found);
    });
    this.showRules();
    this.sure.update();
    this.sureRules.update();
    this.app.aside("rules", SWUNG, 150, (certified) => {
      this.certified = certified;
      this.ruled = "";
      this.showRules();
    });
  }

  // What changes. Nothing is called a gain or a loss before the whole interval is there.
  /** @param {ComparisonPicture} answer @param {SureComparison | null} sure */
  judge(answer, sure) {
    const { units } = this.app;
    /** @type {Bat[]} */
    const bats = answer.bats.map((bat, i) => ({ ...bat, ...sure?.bats[i] }));
    const { verdict, assumptions, changes } = sure ?? answer;
    this.wait.hidden = sure !== null || bats.length < 2;
    paragraphs(this.words, verdict[units].slice(0, bats.length)); // one for each other bat, and the answer to what was asked
    paragraphs(this.reasons, verdict[units].slice(bats.length));
    this.why.hidden = verdict[units].length <= bats.length;
    tell(this.assumed, assumptions[units].join(" "));
    this.app.announce(verdict[units][0]);
    this.change.draw(bats, changes[units].join(" "));
    this.drawCurves(bats);
    this.app.afterwards(this.bats, () => this.bats.replaceChildren(this.tableOfBats(bats)));
  }

  // The curves, and below them how far each lies from the first one's, with its interval.
  /** @param {Bat[]} bats */
  drawCurves(bats) {
    /** @type {Record<string, (number | null)[]>} */
    const lines = {};
    /** @type {Record<string, number[]>} */
    const xs = {};
    const first = bats[0];
    bats.forEach(({ scan, bat, change_low_m_s: low, change_high_m_s: high }, i) => {
      const places = scan.position_m.map((place) => place + this.longest - bat.length_m);
      const curves = { exit_speed_m_s: scan.exit_speed_m_s, collision_efficiency: scan.collision_efficiency, change: scan.change_m_s, change_low: low, change_high: high };
      for (const [key, values] of Object.entries(curves)) if (values) [lines[`${key}_${i}`], xs[`${key}_${i}`]] = [values, places];
    });
    /** @type {(key: string, label: string, i: number, band?: string[] | null) => Curve} */
    const line = (key, label, i, band) => ({ key: `${key}_${i}`, ...LINES[i], label: "", name: label, band: band?.map((/** @type {string} */ name) => `${name}_${i}`) });
    const others = bats.slice(1);
    this.chart.panels = [
      { title: "Exit speed", kind: "exit_speed_m_s", height: 190, lines: bats.map(({ label }, i) => line("exit_speed_m_s", label, i)) },
      ...(others.length ? [{ title: `Faster or slower than ${first.label}`, kind: "speed_change", height: 130, zero: true,
        lines: others.map(({ label, change_low_m_s: low }, i) => line("change", label, i + 1, low ? ["change_low", "change_high"] : null)) }] : []),
      { title: "Collision efficiency q", kind: "ratio", height: 100, lines: bats.map(({ label }, i) => line("collision_efficiency", label, i)) },
    ];
    const zone = first.zone_m?.map((place) => place + this.longest - first.bat.length_m);
    this.chart.draw({ x: [], xs, lines, range: [0, this.longest], usual: [this.longest - Math.min(BARREL, this.longest), this.longest],
      marks: [], bands: zone ? [{ from: zone[0], to: zone[1] }] : [] });
    this.chart.label(`Exit speed, its difference from the first bat's, and collision efficiency along ${bats.map(({ label }) => label).join(", ")}, tips aligned.`);
  }

  /** @param {Bat[]} bats */
  tableOfBats(bats) {
    const show = this.app.text.bind(this.app);
    const range = (/** @type {string} */ name, /** @type {{ value: number, low: number, high: number }} */ { value, low, high }, sign = "") => {
      const signed = (/** @type {number} */ one) => show(name, one).replace(/^(?=\d)/, sign);
      return { text: signed(value), note: low < high ? `${signed(low).split(" ")[0]} to ${signed(high)}` : "" };
    };
    return tableOf("The bats and what they do in play; small: the interval", [
      "Bat", "Weight", "Balance", "Swing weight", "Bat speed", "Exit speed", "Change", "Breaks even at", "BBCOR in play",
    ], bats.map((one, i) => [
      one.label, show("mass_kg", one.bat.mass_kg), show("balance_point_m", one.bat.balance_point_m, 1),
      withDoubt("moi_6in_kg_m2", one.bat.moi_6in_kg_m2, one.bat.moi_6in_half_kg_m2, this.app), range("bat_speed_m_s", one.bat_speed_m_s),
      range("exit_speed_m_s", one.exit_speed_m_s), i ? range("speed_change", one.change_m_s, "+") : "reference",
      i ? show("bat_speed_m_s", one.break_even_bat_speed_m_s) : "reference", one.max_bbcor.toFixed(3),
    ]));
  }

  showRules() {
    const { certified, app: { units } } = this;
    if (!certified || this.ruled === units) return;
    this.ruled = units;
    this.rules.replaceChildren(...this.rulesOf(certified));
  }

  // Rules that say something of one of the bats; those that do not apply or cannot be decided are folded away.
  /** @param {CertifiedBats} certified */
  rulesOf({ certification, rules }) {
    const { units } = this.app;
    const bats = certification.map(({ label, results }) => ({ text: label, note: results }));
    const table = (/** @type {string} */ caption, /** @type {RuleRow[]} */ rows) => {
      const made = tableOf(caption, ["Rule", ...bats], rows.map(({ title, limit, verdicts }) => [
        { text: title, note: limit[units] }, ...verdicts.map(({ words, reason, mark }) => ({ text: words[units], note: reason, className: mark })),
      ]), { column: VERDICT });
      made.classList.add("rules");
      return made;
    };
    const [decided, rest] = [true, false].map((wanted) => rules.filter((row) => row.decided === wanted));
    const fold = make("details", { open: this.rulesOpen }, make("summary", { textContent: `${rest.length} more that do not apply to these bats or cannot be decided` }),
      table("Rules without a verdict", rest));
    fold.addEventListener("toggle", () => (this.rulesOpen = fold.open));
    return [...(decided.length ? [table("Every rule held against every bat, from the simulated test", decided)] : []), ...(rest.length ? [fold] : [])];
  }

  figures() { return [this.change.surface.figure("change"), this.rows.surface.figure("bats"), this.chart.figure("curves")]; }
  table() {
    const bats = this.answer?.bats ?? [];
    const column = (/** @type {"position_m" | "exit_speed_m_s" | "collision_efficiency" | "bbcor"} */ name) => bats.flatMap(({ scan }) => scan[name]);
    return { label: bats.flatMap(({ label, scan }) => scan.position_m.map(() => label)), position_m: column("position_m"), exit_speed_m_s: column("exit_speed_m_s"),
      collision_efficiency: column("collision_efficiency"), bbcor: column("bbcor") };
  }
}

/** @param {AppOf<"compare">} app */
const leagues = (app) => app.lists("leagues").then((lists) => [["all", "all leagues"], ...(lists.leagues ?? []).map(({ key, name }) => [key, name])]);

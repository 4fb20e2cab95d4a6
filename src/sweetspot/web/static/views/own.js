// Own bat: from a scale, a balance point, a pendulum and a tap to the bat that one has in hand, and how sure each value is.

import { BatView } from "../batview.js";
import { Bench, unchanged } from "../bench.js";
import { button, choice, group, slider } from "../controls.js";
import { download } from "../download.js";
import { Lights, showRules } from "../lights.js";
import { make, paragraphs, tableOf, tell, withDoubt } from "../parts.js";
import table from "../quantities.js";
import { takeDrops } from "../upload.js";
import { SOUNDS, TapPlace } from "./own_tap.js";
/** @import { Answer, App, View } from "../main.js" */

/** @type {Record<string, number>} */
const DIGITS = { mass: 2, density: 0, share: 2 };
const SOUND = new RegExp(`(${SOUNDS.join("|").replaceAll(".", "\\.")})$`, "i");

/** @type {View} */
export const view = {
  name: "own",
  guide: [
    ["Describe it, then measure it", "Begin with a bat like yours: of the list, by questions, or by its outline. Then weigh it, balance it on an edge, let it swing, tap it."],
    ["How sure", "Each measurement has its error. The table says what is known, from what, and how far each measurement lies from all the others."],
    ["Tap", "Hang the bat freely, press Listen, tap. Each tap freezes the picture; bad ones are left out and told why. Nothing leaves this machine."],
  ],

  mount(root, app) {
    Object.assign(this, { app, answer: null, measuredAs: this.measuredAs ?? null }); // stays while other views are open
    this.bench = new Bench(app);
    this.picture = new BatView(app, { label: "The bat" });
    this.picture.element.classList.add("pinned");
    this.tap = new TapPlace(app);
    this.words = make("p", { className: "verdict flow", id: "verdict" });
    this.against = make("div", { className: "words against", hidden: true });
    this.against.setAttribute("role", "alert");
    this.values = make("div", { className: "measured" });
    this.residuals = make("div", { className: "measured" });
    this.moved = make("p", { className: "note", hidden: true, id: "moved" });
    this.doubt = make("div", { className: "words" });
    this.rules = new Lights("Rules");
    this.said = make("p", { className: "note" });
    this.said.setAttribute("role", "status");
    const section = (/** @type {string} */ title, /** @type {(Node | string)[]} */ ...parts) => make("section", { className: "picture" }, make("h2", { textContent: title }), ...parts);
    root.append(this.side(app), make("div", { className: "stack" },
      make("section", { className: "picture" }, this.words, this.picture.element, this.against, this.moved, this.residuals, this.tools(app), this.said),
      section("Tap it", this.tap.element), section("How sure", this.values, this.doubt, this.rules.element)));
    takeDrops(root, SOUND, app.signal, (sounds) => this.tap.add(sounds));
  },

  /** @param {App} app */
  side(app) {
    const guess = (/** @type {string} */ field) => () => app.answer?.guesses[field] ?? null;
    /** @type {{ field: string, given: HTMLElement[], lacks: HTMLElement }[]} */
    this.steps = [];
    // What somebody measures; its error, and the way back, are there once it is measured. Errors are told as all intervals.
    const measured = (/** @type {string} */ field, /** @type {string} */ label, /** @type {number} */ step, /** @type {string} */ error, /** @type {number} */ fine, /** @type {string} */ note) => {
      const lacks = make("p", { className: "note", textContent: `Not measured. ${note}` });
      const given = [slider(app, error, { label: "Give or take (90 %)", step: fine, times: table.reach }), make("div", { className: "row tight" }, button("Not measured", () => app.setState({ [field]: null })))];
      this.steps.push({ field, given, lacks });
      return [slider(app, field, { label, step, empty: guess(field), absent: "not measured" }), lacks, ...given];
    };
    const leagues = app.lists("leagues").then(({ leagues: all }) => [["usual", "usual for this bat"], ...all.map(({ key, name }) => [key, name])]);
    return make("div", { className: "side" }, this.bench.element,
      group("Scale", measured("weighed_oz", "It weighs", 0.05, "weighed_error_oz", 0.01, "Move the slider, or type what the scale says.")),
      group("Balance", measured("balanced_in", "Balances, from the knob's end", 0.05, "balanced_error_in", 0.01, "Lay the bat across an edge.")),
      group("Pendulum", [...measured("pendulum_ms", "One full swing takes", 0.5, "pendulum_error_ms", 0.1, "Time ten small swings, there and back; a tenth of that."),
        slider(app, "pivot_in", { label: "Hung, from the knob's end", step: 0.05 })]),
      group("Tap, diameters and rules", [slider(app, "tap_from_tip_in", { label: "Tapped, from the tip", step: 0.25 }),
        slider(app, "diameter_error", { label: "Diameters, give or take (90 %), in %", step: 0.0005, times: 100 * table.reach }), choice(app, "league", { label: "Rules of", options: leagues })], { open: false }));
  },

  /** @param {App} app */
  tools(app) {
    const file = async (/** @type {(toml: string) => void} */ then) => {
      this.said.textContent = "";
      try {
        const { toml } = await app.ask("own/file", app.state);
        if (toml) then(toml);
        else this.said.textContent = "Nothing was measured yet: weigh, balance, swing or tap the bat first.";
      } catch (fault) {
        this.said.textContent = fault.message;
      }
    };
    this.bringers = [
      button("Put it on the bench", () => file((toml) => {
        app.setState({ ...unchanged(app), bat_toml: toml, weighed_oz: null, balanced_in: null, pendulum_ms: null, tones: [], damping: null, left_out: [] });
        this.said.textContent = "It lies on the bench now, for every view. Measuring it again begins anew.";
      }), { primary: true, title: "From now on it is the bat of every view" }),
      button("Bat file, with intervals", () => file((toml) => download("my-bat.toml", "application/toml", toml))),
    ];
    this.forget = button("Forget what was measured", () => app.setState({ weighed_oz: null, balanced_in: null, pendulum_ms: null, tones: [], damping: null, left_out: [] }));
    return make("div", { className: "row" }, ...this.bringers, this.forget);
  },

  update(answer) {
    this.answer = answer;
    const { app } = this;
    this.bench.update(answer);
    this.picture.draw({ bat: { ...answer.bat, balance_point_m: answer.fitted.balance_point_m } });
    this.tap.draw(answer);
    const off = answer.contradictions[app.units];
    this.against.hidden = off.length === 0;
    paragraphs(this.against, off.map((/** @type {string} */ words) => words.replace(/, or --leave-out '[^']*'/, ", or leave it out")));
    for (const { field, given, lacks } of this.steps) {
      for (const one of given) one.hidden = app.state[field] === null;
      lacks.hidden = app.state[field] !== null;
    }
    this.measurements(answer.measurements);
    this.otherBat(answer);
    app.afterwards(this.values, () => {
      this.sure(answer);
      showRules(this.rules, answer.rules, app);
    });
    for (const one of this.bringers) one.disabled = !answer.values.length || off.length > 0;
    this.forget.disabled = !answer.measurements.length;
    this.say(answer);
  },

  // Measurements are of the bat in hand, whatever it is described by; when that changes, it is said and they can go.
  /** @param {Answer} given */
  otherBat({ bat, measurements }) {
    this.measuredAs = measurements.length ? this.measuredAs ?? bat.name : null;
    const other = this.measuredAs !== null && this.measuredAs !== bat.name;
    this.moved.textContent = other ? `Measured while the bat was described as ${this.measuredAs}; it all counts for ${bat.name} now. If that is another bat, press Forget what was measured.` : "";
    this.moved.hidden = !other;
  },

  /** @param {Answer[]} rows */
  measurements(rows) {
    const { app } = this;
    const left = app.state.left_out;
    if (!rows.length) {
      this.residuals.replaceChildren(make("p", { className: "note", textContent: "Nothing measured yet: set a slider of Scale, Balance or Pendulum to what you measured, or tap." }));
      return;
    }
    const show = (/** @type {Answer} */ one, /** @type {number} */ value) => app.text(one.scale, value, one.digits);
    const agree = rows.every(({ fitted }) => fitted !== null);
    const [title, heads] = agree ? ["What was measured, and what the bat that fits all of it says", ["the fitted bat"]] : ["What was measured; no bat fits all of it", []];
    const box = tableOf(title, ["Measured", "value (90 %)", ...heads, "off by", ""], rows.map((one) => [
      one.name, `${show(one, one.value)} ± ${show(one, one.half)}`, ...(agree ? [show(one, one.fitted)] : []),
      one.counts ? { text: `${one.sigma >= 0 ? "+" : "−"}${Math.abs(one.sigma).toFixed(1)} sigma`, className: Math.abs(one.sigma) > 3 ? "bad" : "" } : "left out", ""]));
    box.querySelectorAll("tbody tr").forEach((row, i) => {
      const { name, counts } = rows[i];
      const act = button(counts ? "Leave out" : "Count it", () => app.setState({ left_out: counts ? [...left, name] : left.filter((/** @type {Answer} */ one) => one !== name) }));
      act.setAttribute("aria-label", `${counts ? "Leave out" : "Count"}: ${name}`);
      row.lastElementChild?.replaceChildren(act);
    });
    this.residuals.replaceChildren(box);
  },

  // What is known now, and beside it how the intervals have shrunk.
  /** @param {Answer} given */
  sure({ values, unknowns, budget, contradictions }) {
    const { app } = this;
    const told = values.length ? [tableOf("The bat, with 90 % intervals", ["", "value", "known from"], values.map((/** @type {{ label: string, scale: string, value: number, half: number, known_from: string }} */ { label, scale, value, half, known_from: from }) => (
      [label, `${app.text(scale, value, DIGITS[scale])} ± ${app.text(scale, half, DIGITS[scale])}`, from])))] : [make("p", { className: "note", textContent: contradictions.us.length ? "Nothing is told of the bat while its measurements contradict each other; the rules below are held against it as described."
      : "What the catalogue knows of such wood or metal is all that is known so far." })];
    if (unknowns.length) {
      const share = (/** @type {Answer} */ part) => app.text("share", part, 1);
      const box = tableOf("What was not known: 90 % intervals before and now", ["", "before", "now", "off the description", "what is left comes from"], unknowns.map((/** @type {Answer} */ one) => [
        one.label, `±\u00a0${share(one.before)}`, `±\u00a0${share(one.after)}`, share(one.off), one.budget.slice(0, 2).map((/** @type {{ name: string, share: number }} */ { name, share: part }) => `${name}: ${share(part)}`).join(", ")]));
      box.querySelectorAll("tbody tr").forEach((row, i) => {
        const left = make("span");
        left.style.width = `${100 * Math.min(1, unknowns[i].after / unknowns[i].before)}%`;
        row.lastElementChild?.classList.add("sources");
        row.children[2].append(make("span", { className: "shrunk", ariaHidden: "true" }, left));
      });
      told.push(box);
    }
    this.values.replaceChildren(...told);
    paragraphs(this.doubt, budget[app.units].map((/** @type {string} */ words) => words.replace(" and give --pendulum", ""))); // what the command line has it by
  },

  /** @param {Answer} given */
  say({ fitted, values, contradictions, measurements }) {
    const { app } = this;
    const moi = values.find((/** @type {{ name: string }} */ { name }) => name === "moi");
    const swing = withDoubt("moi_kg_m2", fitted.moi_6in_kg_m2, moi?.half ?? fitted.moi_6in_half_kg_m2, app);
    const state = contradictions.us.length ? "The measurements contradict each other. As described: " : ["As described, not measured: ", "By one measurement and what is usual of such bats: "][measurements.filter((/** @type {Answer} */ { counts }) => counts).length] ?? "The measurements agree. ";
    const words = `${state}${app.text("mass_kg", fitted.mass_kg)}, balance ${app.text("balance_point_m", fitted.balance_point_m, 1)} from the knob, swing weight ${swing}.`;
    tell(this.words, words);
    app.announce(words);
    this.picture.label(`The bat and its balance point. ${words}`);
  },

  unmount() { this.answer = null; },
  figures() { return [this.picture.figure("bat"), this.tap.chart.figure("spectrum")]; },
  table() {
    const rows = this.app.answer.unknowns;
    return { before: rows.map((/** @type {{ before: string }} */ { before }) => before), now: rows.map((/** @type {{ after: string }} */ { after }) => after), off: rows.map((/** @type {{ off: number }} */ { off }) => off) };
  },
};

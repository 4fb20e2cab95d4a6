// Own bat: from a scale, a balance point, a pendulum and a tap to the bat that one has in hand, and how sure each value is;
// to a racket, cricket bat, club or stick as well.

import { BatView } from "../bat/batview.js";

import { unchanged } from "../bat/unchanged.js";
import { button, choice, group, slider } from "../controls/controls.js";
import { download } from "../shell/download.js";
import { Lights, showRules } from "../controls/lights.js";
import { changed, make, paragraphs, partOf, section, showWords, tableOf, tell, withDoubt } from "../controls/parts.js";
import table from "../quantities.js";
import { takeDrops } from "../controls/upload.js";
import { FORGOTTEN } from "./own_measured.js";
import { SOUNDS, TapPlace } from "./own_tap.js";
/** @import { OwnAnswer, OwnMeasurement } from "../answers.js" */
/** @import { Words } from "../controls/controls.js" */
/** @import { AppOf, Field, Guide } from "../shell/main.js" */

const ROUND = ""; // a bat of the bench, in the list of what there is to measure
const OWN = "own file";
const SOON = 1000; // ms until which nobody needs to be told that something is being worked on
/** @type {string | null} */
let measuredAs = null; // what the bat was called as it was measured; stays while other views are open
const SOUND = new RegExp(`(${SOUNDS.join("|").replaceAll(".", "\\.")})$`, "i");

export default class OwnView {
  /** @type {Guide} */
  static guide = [
    ["Describe it, then measure it", "Begin with a bat like yours: of the list, by questions, or by its outline. Then weigh it, balance it on an edge, let it swing, tap it. A racket, cricket bat, club or stick goes the same way."],
    ["How sure", "Each measurement has its error. The table says what is known, from what, and how far each measurement lies from all the others."],
    ["Tap", "Hang the bat freely, press Listen, tap. Each tap freezes the picture; bad ones are left out and told why. Nothing leaves this machine."],
  ];

  /** @param {HTMLElement} root @param {AppOf<"own">} app */
  constructor(root, app) {
    this.app = app;
    /** @type {OwnAnswer | null} */
    this.answer = null;
    this.picture = new BatView(app, { label: "The bat" });
    this.picture.element.classList.add("pinned");
    this.tap = new TapPlace(app);
    this.words = make("p", { className: "verdict flow", id: "verdict" });
    this.against = make("div", { className: "words against", hidden: true });
    this.against.setAttribute("role", "alert");
    this.values = make("div", { className: "measured" });
    this.residuals = make("div", { className: "measured" });
    this.busy = make("p", { className: "note", hidden: true }, make("progress", { ariaLabel: "Fitting" }), " ", make("span"));
    this.watch(app);
    this.moved = make("p", { className: "note", hidden: true, id: "moved" });
    this.doubt = make("div", { className: "words" });
    this.rules = new Lights("Rules");
    this.said = make("p", { className: "note" });
    this.said.setAttribute("role", "status");
    /** @type {{ field: Field, given: HTMLElement[], lacks: HTMLElement, off: HTMLElement }[]} */
    this.steps = [];
    const tip = () => app.answer?.words.tip ?? "tip", butt = () => app.answer?.grip_end ?? "knob end";
    const leagues = app.lists("leagues").then(({ leagues: all }) => [["usual", "usual for this bat"], ...all.map(({ key, name }) => [key, name])]);
    this.league = choice(app, "league", { label: "Rules of", options: leagues });
    this.ofBat = slider(app, "diameter_error", { label: "Diameters, give or take (90 %), in %", step: 0.0005, times: 100 * table.reach });
    this.unlike = make("p", { className: "contradicts", hidden: true, textContent: "No single measurement explains the contradiction. Look here first: is this its outline, and its wood or wall?" });
    const side = make("div", { className: "side" },
      group("What is measured", [this.kind(app), make("p", { className: "note", textContent: "A racket, club or stick of your own: bring its file to Every sport, and measure it from there." })]),
      this.unlike,
      group("Scale", this.measured("weighed_oz", "It weighs", 0.05, "weighed_error_oz", 0.01, "Move the slider, or type what the scale says.")),
      group("Balance", this.measured("balanced_in", () => `Balances, from the ${butt()}`, 0.05, "balanced_error_in", 0.01, "Lay it across an edge.")),
      group("Pendulum or swing weight", [...this.measured("pendulum_ms", "One full swing takes", 0.5, "pendulum_error_ms", 0.1, "Time ten small swings, there and back; a tenth of that."),
        ...this.measured("swing_weight_oz_in2", "Swing weight, if a machine told it", 1, "swing_weight_error_oz_in2", 1, "A pendulum does as well."),
        slider(app, "pivot_in", { label: () => `Both about an axis, from the ${butt()}`, step: 0.05, empty: () => app.answer?.guesses.pivot_in ?? null })]),
      group("Tap, diameters and rules", [slider(app, "tap_from_tip_in", { label: () => `Tapped, from the ${tip()}`, step: 0.25 }), this.ofBat, this.league], { open: false }));
    this.onward = button("Put it on the bench", () => this.file((toml) => {
      if (app.state.implement) {
        app.visitWith("sports", { implement: app.state.implement, implement_toml: toml });
        return;
      }
      app.setState({ ...unchanged(app), ...FORGOTTEN, bat_toml: toml });
      this.said.textContent = "It lies on the bench now, for every view. Measuring it again begins anew.";
    }), { primary: true });
    this.bringers = [this.onward, button("Its file, with intervals", () => this.file((toml) => download(`my-${app.answer?.words.implement ?? "bat"}.toml`, "application/toml", toml)))];
    this.forget = button("Forget what was measured", () => app.setState(FORGOTTEN));
    root.append(side, make("div", { className: "stack" },
      make("section", { className: "picture" }, this.words, this.busy, this.picture.element, this.against, this.moved, this.residuals, make("div", { className: "row" }, ...this.bringers, this.forget), this.said),
      section("Tap it", this.tap.element), section("How sure", this.values, this.doubt, this.rules.element)));
    takeDrops(root, SOUND, app.signal, (sounds) => this.tap.add(sounds));
  }

  /** @param {File[]} sounds */
  bring(sounds) { return this.tap.add(sounds); }

  // The list of what can be measured: a bat of the bench, or something of another sport.
  /** @param {AppOf<"own">} app */
  kind(app) {
    const options = app.lists("implements", "bats").then(({ implements: all, bats }) => {
      const round = new Set(bats.map(({ key }) => key));
      return [[ROUND, "a bat"], ...all.filter(({ key }) => !round.has(key)).map(({ key, name, sport }) => [key, name, sport])];
    });
    return choice(app, "implement", { label: "It is", options, take: (kind) => kind !== OWN && this.other(kind),
      shown: (state) => (state.implement && state.implement_toml ? OWN : state.implement ?? ROUND) });
  }

  // What somebody measures; its error, and the way back, are there once it is measured. Errors are told as all intervals.
  /** @param {keyof OwnAnswer["guesses"] & Field} field @param {Words} label @param {number} step @param {Field} error @param {number} fine @param {string} note */
  measured(field, label, step, error, fine, note) {
    const { app } = this;
    const lacks = make("p", { className: "note", textContent: `Not measured. ${note}` });
    const off = make("p", { className: "contradicts", hidden: true });
    const given = [slider(app, error, { label: "Give or take (90 %)", step: fine, times: table.reach }), make("div", { className: "row tight" }, button("Not measured", () => app.setState(changed(field, null))))];
    this.steps.push({ field, given, lacks, off });
    return [slider(app, field, { label, step, empty: () => app.answer?.guesses[field] ?? null, absent: "not measured" }), off, lacks, ...given];
  }

  // With tones a fit takes a while, and nobody knows how many steps: how long it has gone on is said.
  /** @param {AppOf<"own">} app */
  watch(app) {
    const words = partOf(this.busy, "span", HTMLElement);
    let began = 0;
    const look = () => {
      if (!app.asking || !app.state.tones?.length) began = 0;
      else began ||= performance.now();
      const lasts = began ? performance.now() - began : 0;
      this.busy.hidden = lasts < SOON;
      if (lasts >= SOON) words.textContent = `Looking for the ${this.name} that fits all that was measured, ${Math.round(lasts / 1000)} s …`;
    };
    const timer = setInterval(look, SOON / 2);
    app.signal.addEventListener("abort", () => clearInterval(timer));
  }

  // Something else is measured: what was measured so far was not it.
  /** @param {string} kind */
  other(kind) {
    this.tap.empty();
    this.app.setState({ ...FORGOTTEN, implement: kind || null, implement_toml: null, pivot_in: null });
  }

  // What was measured, as a bat's file.
  /** @param {(toml: string) => void} then */
  async file(then) {
    this.said.textContent = "";
    try {
      const { toml } = await this.app.ask("own/file", this.app.state);
      if (toml) then(toml);
      else this.said.textContent = "Nothing was measured yet: weigh, balance, swing or tap the bat first.";
    } catch (fault) {
      this.said.textContent = fault.message;
    }
  }

  /** @param {OwnAnswer} answer */
  update(answer) {
    this.answer = answer;
    const { app } = this, { bat, contradictions, headline, measurements, values } = answer;
    const round = bat.outline !== null;
    this.picture.element.hidden = this.league.hidden = this.ofBat.hidden = !round;
    if (bat.outline !== null) {
        this.picture.draw({ bat: { ...bat, balance_point_m: answer.fitted.balance_point_m } });
    }
    this.onward.textContent = round ? "Put it on the bench" : "Hit with it in Every sport";
    this.onward.title = round ? "From now on it is the bat of every view" : "";
    this.tap.draw(answer);
    const off = contradictions[app.units];
    this.against.hidden = off.length === 0;
    paragraphs(this.against, off);
    this.besideFields(answer);
    this.measurements(measurements);
    this.otherBat(answer);
    app.afterwards(this.values, () => {
      this.sure(answer);
      showRules(this.rules, answer.rules, app);
    });
    for (const bringer of this.bringers) bringer.disabled = !values.length || off.length > 0;
    this.forget.disabled = !measurements.length;
    const words = headline[app.units];
    tell(this.words, words);
    app.announce(words);
    this.picture.label(`The bat and its balance point. ${words}`);
  }

  // Beside what was measured what is wrong with it; where no single measurement is, beside what it was described by.
  /** @param {OwnAnswer} answer */
  besideFields({ measurements, contradictions, bat }) {
    const { app } = this;
    for (const { field, given, lacks, off } of this.steps) {
      for (const control of given) control.hidden = app.state[field] === null;
      lacks.hidden = app.state[field] !== null;
      showWords(off, measurements.find((row) => row.field === field)?.beside?.[app.units] ?? "");
    }
    this.unlike.hidden = bat.outline === null || !contradictions.us.length || measurements.some(({ beside }) => beside !== null);
  }

  // Measurements are of the bat in hand, whatever it is described by; when that changes, it is said and they can go.
  /** @param {OwnAnswer} answer */
  otherBat({ bat, measurements }) {
    measuredAs = measurements.length ? measuredAs ?? bat.name : null;
    const other = measuredAs !== null && measuredAs !== bat.name;
    showWords(this.moved, other ? `Measured while the bat was described as ${measuredAs}; it all counts for ${bat.name} now. If that is another bat, press Forget what was measured.` : "");
  }

  /** @param {OwnMeasurement[]} rows */
  measurements(rows) {
    const { app } = this, left = app.state.left_out;
    if (!rows.length) {
      this.residuals.replaceChildren(make("p", { className: "note", textContent: "Nothing measured yet: set a slider of Scale, Balance or Pendulum to what you measured, or tap." }));
      return;
    }
    const agree = rows.every(({ fitted }) => fitted !== null), what = this.name;
    const [title, heads] = agree ? [`What was measured, and what the ${what} that fits all of it says`, [`the fitted ${what}`]] : [`What was measured; no ${what} fits all of it`, []];
    const box = tableOf(title, ["Measured", "value (90 %)", ...heads, "off by", ""], rows.map(({ name, scale, digits, value, half, fitted, sigma }) => [
      name, `${app.text(scale, value, digits)} ± ${app.text(scale, half, digits)}`, ...(agree ? [app.text(scale, fitted, digits)] : []),
      sigma === null ? "left out" : { text: `${sigma >= 0 ? "+" : "−"}${Math.abs(sigma).toFixed(1)} sigma`, className: Math.abs(sigma) > 3 ? "bad" : "" }, ""]));
    box.querySelectorAll("tbody tr").forEach((row, i) => {
      const { name, counts, tone, right_tone: right } = rows[i];
      const act = button(counts ? "Leave out" : "Count it", () => app.setState({ left_out: counts ? [...left, name] : left.filter((other) => other !== name) }));
      act.setAttribute("aria-label", `${counts ? "Leave out" : "Count"}: ${name}`);
      const renamed = app.state.tones.map(([mode, ...heard]) => [mode === tone ? right : mode, ...heard]);
      row.lastElementChild?.replaceChildren(...(right ? [button(`It is ${right.replace("-", " ")}`, () => app.setState(changed("tones", renamed))), " "] : []), act);
    });
    this.residuals.replaceChildren(box);
  }

  // What people call what is measured.
  get name() { return this.answer?.words.implement ?? "bat"; }

  // What is known now, and beside it how the intervals have shrunk.
  /** @param {OwnAnswer} answer */
  sure({ values, unfitted, unknowns, budget }) {
    const { app } = this;
    const parts = [unfitted ? make("p", { className: "note", textContent: unfitted }) : tableOf(`The ${this.name}, with 90 % intervals`, ["", "value", "known from"],
      values.map(({ label, scale, value, half, known_from: from }) => [label[app.units], withDoubt(scale, value, half, app), from]))];
    if (unknowns.length) {
      const share = (/** @type {number} */ part) => app.text("share", part, 1);
      const box = tableOf("What was not known: 90 % intervals before and now", ["", "before", "now", "off the description", "what is left comes from"], unknowns.map(({ label, before, after, off, budget: sources }) => [
        label, `±\u00a0${share(before)}`, `±\u00a0${share(after)}`, share(off), sources.slice(0, 2).map(([name, part]) => `${name}: ${share(part)}`).join(", ")]));
      box.querySelectorAll("tbody tr").forEach((row, i) => {
        const left = make("span");
        left.style.width = `${100 * Math.min(1, unknowns[i].after / unknowns[i].before)}%`;
        row.lastElementChild?.classList.add("sources");
        row.children[2].append(make("span", { className: "shrunk", ariaHidden: "true" }, left));
      });
      parts.push(box);
    }
    this.values.replaceChildren(...parts);
    paragraphs(this.doubt, budget[app.units]);
  }

  figures() { return [...(this.picture.element.hidden ? [] : [this.picture.figure("bat")]), this.tap.chart.figure("spectrum")]; }
  table() {
    const rows = this.answer?.unknowns ?? [];
    return { before: rows.map(({ before }) => before), now: rows.map(({ after }) => after), off: rows.map(({ off }) => off) };
  }
}

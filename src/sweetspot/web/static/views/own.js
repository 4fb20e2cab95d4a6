// Own bat: from a scale, a balance point, a pendulum and a tap to the bat that one has in hand, and how sure each value is;
// to a racket, cricket bat, club or stick as well.

import { BatView } from "../bat/batview.js";
import { Bench } from "../bat/bench.js";
import { unchanged } from "../bat/unchanged.js";
import { button, choice, group, slider } from "../controls/controls.js";
import { download } from "../shell/download.js";
import { Lights, showRules } from "../controls/lights.js";
import { make, paragraphs, partOf, tableOf, tell, withDoubt } from "../controls/parts.js";
import table from "../quantities.js";
import { takeDrops } from "../controls/upload.js";
import { FORGOTTEN } from "./own_measured.js";
import { SOUNDS, TapPlace } from "./own_tap.js";
/** @import { Answer, App, View } from "../shell/main.js" */

const ROUND = ""; // a bat of the bench, in the list of what there is to measure
const OWN = "own file";
const SOON = 1000; // ms until which nobody needs to be told that something is being worked on
const SOUND = new RegExp(`(${SOUNDS.join("|").replaceAll(".", "\\.")})$`, "i");

/** @type {View<"own">} */
export const view = {
  name: "own",
  guide: [
    ["Describe it, then measure it", "Begin with a bat like yours: of the list, by questions, or by its outline. Then weigh it, balance it on an edge, let it swing, tap it. A racket, cricket bat, club or stick goes the same way."],
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
    this.busy = make("p", { className: "note", hidden: true }, make("progress", { ariaLabel: "Fitting" }), " ", make("span"));
    this.watch(app);
    this.moved = make("p", { className: "note", hidden: true, id: "moved" });
    this.doubt = make("div", { className: "words" });
    this.rules = new Lights("Rules");
    this.said = make("p", { className: "note" });
    this.said.setAttribute("role", "status");
    const section = (/** @type {string} */ title, /** @type {(Node | string)[]} */ ...parts) => make("section", { className: "picture" }, make("h2", { textContent: title }), ...parts);
    root.append(this.side(app), make("div", { className: "stack" },
      make("section", { className: "picture" }, this.words, this.busy, this.picture.element, this.against, this.moved, this.residuals, this.tools(app), this.said),
      section("Tap it", this.tap.element), section("How sure", this.values, this.doubt, this.rules.element)));
    takeDrops(root, SOUND, app.signal, (sounds) => this.tap.add(sounds));
  },

  /** @param {App} app */
  side(app) {
    const guess = (/** @type {string} */ field) => () => app.answer?.guesses[field] ?? null;
    const butt = () => app.answer?.grip_end ?? "knob end";
    /** @type {{ field: string, given: HTMLElement[], lacks: HTMLElement, off: HTMLElement }[]} */
    this.steps = [];
    // What somebody measures; its error, and the way back, are there once it is measured. Errors are told as all intervals.
    const measured = (/** @type {string} */ field, /** @type {string | (() => string)} */ label, /** @type {number} */ step, /** @type {string} */ error, /** @type {number} */ fine, /** @type {string} */ note) => {
      const lacks = make("p", { className: "note", textContent: `Not measured. ${note}` });
      const off = make("p", { className: "contradicts", hidden: true });
      const given = [slider(app, error, { label: "Give or take (90 %)", step: fine, times: table.reach }), make("div", { className: "row tight" }, button("Not measured", () => app.setState({ [field]: null })))];
      this.steps.push({ field, given, lacks, off });
      return [slider(app, field, { label, step, empty: guess(field), absent: "not measured" }), off, lacks, ...given];
    };
    const leagues = app.lists("leagues").then(({ leagues: all }) => [["usual", "usual for this bat"], ...all.map(({ key, name }) => [key, name])]);
    const kinds = app.lists("implements", "bats").then(({ implements: all, bats }) => {
      const round = new Set(bats.map(({ key }) => key));
      return [[ROUND, "a bat"], ...all.filter(({ key }) => !round.has(key)).map(({ key, name, sport }) => [key, name, sport])];
    });
    this.league = choice(app, "league", { label: "Rules of", options: leagues });
    this.ofBat = slider(app, "diameter_error", { label: "Diameters, give or take (90 %), in %", step: 0.0005, times: 100 * table.reach });
    this.unlike = make("p", { className: "contradicts", hidden: true, textContent: "No single measurement explains the contradiction. Look here first: is this its outline, and its wood or wall?" });
    return make("div", { className: "side" },
      group("What is measured", [choice(app, "implement", { label: "It is", options: kinds,
        shown: (state) => (state.implement && state.implement_toml ? OWN : state.implement ?? ROUND), take: (kind) => kind !== OWN && this.other(kind) }),
      make("p", { className: "note", textContent: "A racket, club or stick of your own: bring its file to Every sport, and measure it from there." })]),
      this.unlike, this.bench.element,
      group("Scale", measured("weighed_oz", "It weighs", 0.05, "weighed_error_oz", 0.01, "Move the slider, or type what the scale says.")),
      group("Balance", measured("balanced_in", () => `Balances, from the ${butt()}`, 0.05, "balanced_error_in", 0.01, "Lay it across an edge.")),
      group("Pendulum or swing weight", [...measured("pendulum_ms", "One full swing takes", 0.5, "pendulum_error_ms", 0.1, "Time ten small swings, there and back; a tenth of that."),
        ...measured("swing_weight_oz_in2", "Swing weight, if a machine told it", 1, "swing_weight_error_oz_in2", 1, "A pendulum does as well."),
        slider(app, "pivot_in", { label: () => `Both about an axis, from the ${butt()}`, step: 0.05, empty: guess("pivot_in") })]),
      group("Tap, diameters and rules", [slider(app, "tap_from_tip_in", { label: () => `Tapped, from the ${app.answer?.words.tip ?? "tip"}`, step: 0.25 }), this.ofBat, this.league], { open: false }));
  },

  // With tones a fit takes a while, and nobody knows how many steps: how long it has gone on is said.
  /** @param {App} app */
  watch(app) {
    const words = partOf(this.busy, "span", HTMLElement);
    let began = 0;
    const look = () => {
      if (!app.asking || !app.state.tones?.length) began = 0;
      else began ||= performance.now();
      const lasts = began ? performance.now() - began : 0;
      this.busy.hidden = lasts < SOON;
      if (lasts >= SOON) words.textContent = `Looking for the ${this.names()[0]} that fits all that was measured, ${Math.round(lasts / 1000)} s …`;
    };
    const timer = setInterval(look, SOON / 2);
    app.signal.addEventListener("abort", () => clearInterval(timer));
  },

  // Something else is measured: what was measured so far was not it.
  /** @param {string} kind */
  other(kind) {
    this.tap.empty();
    this.app.setState({ ...FORGOTTEN, implement: kind || null, implement_toml: null, pivot_in: null });
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
    this.onward = button("Put it on the bench", () => file((toml) => {
      if (app.state.implement) {
        app.visitWith("sports", { implement: app.state.implement, implement_toml: toml });
        return;
      }
      app.setState({ ...unchanged(app), ...FORGOTTEN, bat_toml: toml });
      this.said.textContent = "It lies on the bench now, for every view. Measuring it again begins anew.";
    }), { primary: true });
    this.bringers = [this.onward, button("Its file, with intervals", () => file((toml) => download(`my-${app.answer?.words.implement ?? "bat"}.toml`, "application/toml", toml)))];
    this.forget = button("Forget what was measured", () => app.setState(FORGOTTEN));
    return make("div", { className: "row" }, ...this.bringers, this.forget);
  },

  update(answer) {
    this.answer = answer;
    const { app } = this;
    const round = answer.bat.outline !== null;
    this.bench.element.hidden = this.picture.element.hidden = this.league.hidden = this.ofBat.hidden = !round;
    if (round) {
      this.bench.update(answer);
      this.picture.draw({ bat: { ...answer.bat, balance_point_m: answer.fitted.balance_point_m } });
    }
    this.onward.textContent = round ? "Put it on the bench" : "Hit with it in Every sport";
    this.onward.title = round ? "From now on it is the bat of every view" : "";
    this.tap.draw(answer);
    const off = answer.contradictions[app.units];
    this.against.hidden = off.length === 0;
    paragraphs(this.against, off.map((/** @type {string} */ words) => words.replace(/, or --leave-out '[^']*'/, ", or leave it out")));
    this.besideFields(answer);
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

  // Beside what was measured what is wrong with it; where no single measurement is, beside what it was described by.
  /** @param {Answer} given */
  besideFields({ measurements, contradictions, bat }) {
    const { app } = this;
    for (const { field, given, lacks, off } of this.steps) {
      for (const one of given) one.hidden = app.state[field] === null;
      lacks.hidden = app.state[field] !== null;
      const wrong = measurements.find((/** @type {Answer} */ one) => one.field === field && one.should !== null);
      off.hidden = !wrong;
      const others = measurements.length === 1 ? "the description" : "all the others";
      if (wrong) off.textContent = `${wrong.contradicts ? `${Math.abs(wrong.sigma).toFixed(1)} sigma off. ` : ""}By ${others} it should be ${app.text(wrong.scale, wrong.should, wrong.digits)}.`;
    }
    this.unlike.hidden = bat.outline === null || !contradictions.us.length || measurements.some((/** @type {Answer} */ { should }) => should !== null);
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
    const agree = rows.every(({ fitted }) => fitted !== null), [what, fit] = this.names();
    const [title, heads] = agree ? [`What was measured, and what the ${what} that fits all of it says`, [fit]] : [`What was measured; no ${what} fits all of it`, []];
    const box = tableOf(title, ["Measured", "value (90 %)", ...heads, "off by", ""], rows.map((one) => [
      one.name, `${show(one, one.value)} ± ${show(one, one.half)}`, ...(agree ? [show(one, one.fitted)] : []),
      one.counts ? { text: `${one.sigma >= 0 ? "+" : "−"}${Math.abs(one.sigma).toFixed(1)} sigma`, className: Math.abs(one.sigma) > 3 ? "bad" : "" } : "left out", ""]));
    box.querySelectorAll("tbody tr").forEach((row, i) => {
      const { name, counts, tone, right_tone: right } = rows[i];
      const act = button(counts ? "Leave out" : "Count it", () => app.setState({ left_out: counts ? [...left, name] : left.filter((/** @type {Answer} */ one) => one !== name) }));
      act.setAttribute("aria-label", `${counts ? "Leave out" : "Count"}: ${name}`);
      const renamed = app.state.tones.map((/** @type {[string, number, number]} */ [mode, ...heard]) => [mode === tone ? right : mode, ...heard]);
      row.lastElementChild?.replaceChildren(...(right ? [button(`It is ${right.replace("-", " ")}`, () => app.setState({ tones: renamed })), " "] : []), act);
    });
    this.residuals.replaceChildren(box);
  },

  // What people call what is measured, and what was fitted to it.
  names() {
    const what = this.answer?.words.implement ?? "bat";
    return [what, `the fitted ${what}`];
  },

  // What is known now, and beside it how the intervals have shrunk.
  /** @param {Answer} given */
  sure({ values, unknowns, budget, contradictions }) {
    const { app } = this;
    const told = values.length ? [tableOf(`The ${this.names()[0]}, with 90 % intervals`, ["", "value", "known from"], values.map((/** @type {{ label: Answer, scale: string, value: number, half: number, known_from: string }} */ { label, scale, value, half, known_from: from }) => (
      [label[app.units], withDoubt(scale, value, half, app), from])))] : [make("p", { className: "note", textContent: contradictions.us.length ? `Nothing is told of the ${this.names()[0]} while its measurements contradict each other; rules are held against it as described.`
      : "What the catalogue knows of it is all that is known so far." })];
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
  say({ fitted, values, contradictions, measurements, words: { implement, butt } }) {
    const { app } = this;
    const half = (/** @type {string} */ of) => values.find((/** @type {{ name: string }} */ { name }) => name === of)?.half ?? null;
    const at = half("balance_point") ? withDoubt("balance_point_m", fitted.balance_point_m, half("balance_point"), app) : app.text("balance_point_m", fitted.balance_point_m, 1);
    const swing = withDoubt("moi_kg_m2", fitted.swing_weight_kg_m2, half("moi") ?? fitted.swing_weight_half_kg_m2, app);
    const state = contradictions.us.length ? "The measurements contradict each other. As described: " : ["As described, not measured: ", `By one measurement and what is usual of such ${implement}s: `][measurements.filter((/** @type {Answer} */ { counts }) => counts).length] ?? "The measurements agree. ";
    const words = `${state}${withDoubt("mass_kg", fitted.mass_kg, half("mass"), app)}, balance ${at} from the ${butt}, swing weight ${swing}.`;
    tell(this.words, words);
    app.announce(words);
    this.picture.label(`The bat and its balance point. ${words}`);
  },

  unmount() { Object.assign(this, { answer: null }); },
  figures() { return [...(this.picture.element.hidden ? [] : [this.picture.figure("bat")]), this.tap.chart.figure("spectrum")]; },
  table() {
    const rows = this.app.answer.unknowns;
    return { before: rows.map((/** @type {{ before: string }} */ { before }) => before), now: rows.map((/** @type {{ after: string }} */ { after }) => after), off: rows.map((/** @type {{ off: number }} */ { off }) => off) };
  },
};

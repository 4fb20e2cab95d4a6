// Design: pull a bat into shape for a batter; what it weighs, whether it is allowed and what it gains follow at once.

import { BatView } from "../bat/batview.js";
import { ballGroup, swingGroup } from "../bat/swing.js";
import { unchanged } from "../bat/unchanged.js";
import { Chart } from "../charts/chart.js";
import { button, choice, group, reveal, slider, toggle } from "../controls/controls.js";
import { download } from "../shell/download.js";
import { Lights, showRules } from "../controls/lights.js";
import { make, paragraphs, section, showWords, tableOf, tell, write } from "../controls/parts.js";
import { Front, WANTS } from "./design_front.js";
import { grouped } from "../controls/units.js";
/** @import { DesignFiles, DesignWorth, DesignLight, DesignPicture, ShapedNumber, States, Station } from "../answers.js" */
/** @import { Light } from "../controls/lights.js" */
/** @import { App, AppOf, Control, Field, Guide, State, Step } from "../shell/main.js" */

const LONGEST = 40000;
/** @type {Record<string, number>} */
const STEPS = { length: 0.000127, compression: 0.00005, ratio: 0.005, mass: 0.0005 };
const PANELS = [
  { title: "Exit speed", kind: "exit_speed_m_s", height: 120, lines: [
    { key: "exit_speed_m_s", label: "this bat", color: "red", width: 2.4 },
    { key: "present_exit_speed_m_s", label: "present bat", color: "muted", dash: [5, 4], width: 1.6 }] },
  { title: "This bat less the present one", kind: "speed_change", height: 100, zero: true, lines: [
    { key: "nothing", name: "no change", label: "band: two bats of one shape, 90 %", color: "green", width: 1, silent: true, band: ["noise_low_m_s", "noise_high_m_s"] },
    { key: "difference_m_s", name: "change", label: "", color: "red", width: 2.4 }] },
  { title: "Where this batter meets the ball", kind: "share", height: 50, zero: true, lines: [{ key: "contacts", color: "blue", fill: true }] },
];
/** @type {Record<string, string>} */
const CHANGES = { speed: "speed_change", place: "length" }; // how a change is shown where it is shown otherwise
const ELSEWHERE = ["league", "want", "also_want", "generations", "seed", "swings_csv", "swings_of"]; // what the gain does not depend on

export default class DesignView {
  /** @type {Guide} */
  static guide = [
    ["Pull it into shape", "Pull the round handles on the outline. Weight, balance, swing weight, league rules and the curves follow at once; " +
      "what is locked stays, and the other numbers give way."],
    ["For this batter", "Tell where the batter meets the ball, or bring swings: the gain counts over these contacts, beside what two pieces of wood differ."],
    ["Find better", "The search looks for bats that keep every limit; each small bat of the front can be taken with a click."],
  ];

  /** @param {HTMLElement} root @param {AppOf<"design">} app */
  constructor(root, app) {
    this.app = app;
    /** @type {DesignPicture | null} */
    this.answer = null;
    /** @type {DesignWorth | null} */
    this.worth = null; // of the bat that is shown
    /** @type {DesignWorth | null} */
    this.noise = null; // of the last bat that it was worked out for
    /** @type {{ index: number, numbers: number[] } | null} */
    this.base = null; // the bat's numbers as one of them began to be pulled, and which
    /** @type {Control[]} */
    this.own = []; // of the bat's numbers
    this.about = ""; // what the gain is about
    this.made = ""; // for which numbers
    this.picture = new BatView(app, { onBall() {}, onStations: (stations, { last }) => this.pulled(stations, last), label: "The bat that is shaped" });
    this.picture.drawing = true;
    this.picture.element.classList.add("pinned");
    const axis = { kind: "position_m", from: () => app.answer?.bat.length_m ?? 0.84, label: "from the tip" };
    this.chart = new Chart(app, { label: "Exit speed along the bat", panels: PANELS, axis });
    this.words = make("p", { className: "verdict flow", id: "verdict" });
    this.note = make("p", { className: "note" });
    this.gain = make("div", { className: "words", ariaBusy: "true" });
    this.lights = { locks: new Lights("What must stay"), rules: new Lights("Rules"), limits: new Lights("Can be turned, will not break") };
    this.beside = make("div");
    this.numbers = make("div");
    this.front = new Front(app, { state: () => ({ ...app.state, swings_csv: null }), onTake: (numbers) => this.take(numbers) });
    const file = (/** @type {string} */ words, /** @type {string} */ ending, /** @type {string} */ type, /** @type {(files: DesignFiles) => string | undefined} */ of) => button(words, async () => {
      download(`designed-bat.${ending}`, type, of(await app.ask("design/files", { ...app.state, swings_csv: null })) ?? "");
    });
    const drawing = (/** @type {string} */ words, /** @type {"svg" | "dxf" | "csv"} */ ending, /** @type {string} */ type) => file(words, ending, type, (files) => files[app.units]?.[ending]);
    this.drawings = [drawing("Drawing (SVG)", "svg", "image/svg+xml"), drawing("Drawing (DXF)", "dxf", "image/vnd.dxf"), drawing("Diameters (CSV)", "csv", "text/csv")];
    const tools = make("div", { className: "row tight" },
      button("As the present bat", () => this.anew({ design_si: null, design_for: null, pulled: null })),
      button("Put it on the bench", async () => {
        const { toml } = await app.ask("design/files", { ...app.state, swings_csv: null });
        this.anew({ ...unchanged(app), bat_toml: toml, design_si: null, design_for: null, pulled: null });
      }, { title: "From now on it is the present bat in every view" }),
      file("Bat file", "toml", "application/toml", ({ toml }) => toml), ...this.drawings);
    root.append(this.side(app), make("div", { className: "stack" },
      make("section", { className: "picture" }, this.words, this.picture.element, this.note,
        make("div", { className: "light-rows" }, ...Object.values(this.lights).map(({ element }) => element)), tools),
      section("Find better", this.front.element),
      section("What it does, beside the present bat", this.chart.element, this.gain, this.beside)));
  }

  /** @param {App} app */
  side(app) {
    const wants = Object.entries(WANTS).filter(([name]) => name !== "moi").map(([name, [, words]]) => [name, words]);
    const leagues = app.lists("leagues").then(({ leagues: all }) => [["usual", "usual for this bat"], ["none", "none"], ...all.map(({ key, name }) => [key, name])]);
    return make("div", { className: "side" },
      group("What must stay", [
        toggle(app, "keep_mass", { label: "Weight" }), toggle(app, "keep_moi", { label: "Swing weight (MOI)" }),
        toggle(app, "keep_wood", { label: "Density of the wood" }),
        toggle(app, "keep_balance", { label: "Balance point" }), toggle(app, "keep_grip", { label: "Grip's smallest diameter" }),
        make("p", { className: "note", textContent: "Within 1 %. Length, knob and the cup's width stay; the command takes ranges for them (--length, --knob, --cup-diameter)." }),
        choice(app, "league", { label: "Rules of", options: leagues }),
      ]),
      group("The batter", [
        slider(app, "contact_in", { label: "Meets the ball, from the tip", step: 0.1 }),
        slider(app, "contact_spread_in", { label: "Standard deviation of that", step: 0.1 }), this.swings(app),
        group("More of the batter", [
          slider(app, "contact_doubt_in", { label: "The place is known to (standard deviation)", step: 0.1 }),
          slider(app, "miss_in", { label: "Ball above the axis", step: 0.05 }), slider(app, "miss_spread_in", { label: "Standard deviation of that", step: 0.05 }),
          choice(app, "swing_law", { label: "A heavier bat is swung", options: [["baseball", "slower, by the players' law"], ["none", "just as fast"]] }),
        ], { open: false }),
      ]),
      group("The search", [
        choice(app, "want", { label: "Better in", options: wants }), choice(app, "also_want", { label: "And in", options: wants }),
        slider(app, "generations", { label: "Generations", step: 5 }), slider(app, "deepest_cup_in", { label: "Deepest cup", step: 0.05 }),
      ], { open: false }),
      group("Other sports", [make("p", { className: "note" },
        "Here bats of baseball and softball are designed. Cricket bats, rackets and golf clubs have a few numbers of their own, and the command designs them: ",
        make("code", { textContent: "sweetspot design cricket-bat --out blade" }), ", ", make("code", { textContent: "tennis-racket" }), ", ", make("code", { textContent: "golf-driver" }), ".")], { open: false }),
      group("The bat's numbers", [this.numbers], { open: false }), swingGroup(app, { open: false }), ballGroup(app));
  }

  // A batter from swings: a table, an answer of fit-player, or the table of the Player view.
  /** @param {App} app */
  swings(app) {
    const file = make("input", { type: "file", id: "batter-file", accept: ".csv,.json,text/csv,application/json,text/plain" });
    const wrong = make("p", { className: "fault", hidden: true });
    const refuse = (/** @type {string} */ message) => {
      showWords(wrong, message);
      reveal(wrong);
    };
    const read = async (/** @type {string} */ text, /** @type {string | null} */ whose = null) => {
      wrong.hidden = true;
      file.setAttribute("aria-busy", "true");
      try {
        app.setState(await app.ask("design/batter", { ...app.state, swings_csv: text, swings_of: whose }));
      } catch (fault) {
        refuse(fault.message);
      }
      file.removeAttribute("aria-busy");
    };
    this.bring = async (/** @type {File[]} */ [chosen]) => {
      if (!chosen) return;
      const text = await chosen.text();
      if (text.length > LONGEST) refuse(`${chosen.name} has ${text.length} letters; at most ${LONGEST}. Bring it to the view Player, which takes longer ones, and come back.`);
      else read(text);
    };
    file.addEventListener("change", () => {
      const files = [...(file.files ?? [])];
      file.value = "";
      this.bring?.(files);
    });
    const { swings_csv: known, swings_of: whose } = app.left.get("player") ?? {};
    return make("div", { className: "own" }, make("label", { htmlFor: "batter-file", textContent: `Or from swings (CSV, or player.json of fit-player; up to ${grouped(LONGEST)} letters)` }), file, wrong,
      ...(known ? [button("The swings of the view Player", () => read(known, whose))] : []));
  }

  /** @param {Partial<State>} change */
  anew(change) {
    this.base = null;
    this.app.setState(change);
  }

  /** @param {number[]} numbers */
  take(numbers) { if (this.answer) this.anew({ design_si: numbers, design_for: this.answer.key, pulled: null }); }

  // One number pulled: the others as they were when the pulling began, so that back is back.
  /** @param {number} index @param {number} value @param {Step} [options] */
  pull(index, value, options) {
    if (!this.answer) return;
    if (this.base?.index !== index) this.base = { index, numbers: this.answer.variables.map(({ value: present }) => present) };
    const numbers = this.base.numbers.map((number, i) => (i === index ? value : number));
    this.app.setState({ design_si: numbers, design_for: this.answer.key, pulled: index }, options);
    if (options?.commit !== false) this.base = null;
  }

  /** @param {Station[]} stations @param {boolean} last */
  pulled(stations, last) {
    if (!this.answer) return;
    const { design, variables } = this.answer, index = stations.findIndex(({ diameter_m: wide }, i) => wide !== design.stations[i].diameter_m);
    if (index < 0 && last) this.app.commit();
    if (index < 0) {
      if (last) this.base = null;
      return;
    }
    const { low, high } = variables[index];
    this.pull(index, Math.min(high, Math.max(low, stations[index].diameter_m)), { commit: last });
  }

  // A slider a number, for the keyboard and for what has no handle; made anew where another kind of bat has others.
  /** @param {ShapedNumber[]} variables */
  sliders(variables) {
    const names = variables.map(({ key, low, high }) => `${key} ${low} ${high}`).join();
    if (names !== this.made) {
      this.made = names;
      this.own = [];
      const { app } = this;
      const inner = {
        schema: Object.fromEntries(variables.map(({ key, low, high }) => [key, { minimum: low, maximum: high }])),
        get units() { return app.units; },
        commit: (/** @type {Step} */ options) => {
          this.base = null;
          app.commit(options);
        },
        control: (/** @type {Control} */ control) => this.own.push(control),
        setState: (/** @type {Partial<State>} */ partial, /** @type {Step} */ options) => {
          const [[name, value]] = Object.entries(partial);
          this.pull(variables.findIndex(({ key }) => key === name), Number(value), options);
        },
      };
      this.numbers.replaceChildren(...variables.map(({ key, label, scale, low, high }) => slider(inner, /** @type {Field} */ (key), { label: () => label[app.units], step: STEPS[scale] ?? (high - low) / 100 })));
    }
    const state = /** @type {State} */ (/** @type {unknown} */ (Object.fromEntries(variables.map(({ key, value }) => [key, value]))));
    for (const control of this.own) control.sync(state);
  }

  /** @param {DesignPicture} answer @param {States["design"]} state */
  update(answer, state) {
    this.answer = answer;
    const { app } = this;
    this.sliders(answer.variables);
    const { design } = answer;
    this.picture.draw({ bat: design, ghost: answer.present });
    this.light(answer);
    this.compare(answer);
    this.front.draw(answer.key, answer.shaped ? answer.variables.map(({ value }) => value) : null);
    const note = [...answer.left_out, design.stations.length ? "Dashed: the present bat. Pull a round handle." : "Dashed: the present bat. A hollow bat's wall is changed by “The bat's numbers” among the controls."].join(" ");
    write(this.note, note);
    for (const file of this.drawings) file.hidden = design.hollow;
    const about = JSON.stringify(Object.entries(state).filter(([field]) => !ELSEWHERE.includes(field)));
    if (about !== this.about) Object.assign(this, { about, worth: null }); // that is of the bat before
    this.draw(answer);
    this.say(answer);
    this.gain.ariaBusy = String(!this.worth);
    app.aside("gain", ELSEWHERE, 120, (found) => {
      this.worth = this.noise = found;
      if (!this.answer) return;
      this.draw(this.answer);
      this.say(this.answer);
    });
  }

  /** @param {DesignPicture} answer */
  draw({ curves, design }) {
    const { noise_low_m_s = [], noise_high_m_s = [] } = this.noise ?? {};
    const lines = { ...curves, nothing: curves.position_m.map(() => 0), noise_low_m_s, noise_high_m_s };
    this.chart.draw({ x: curves.position_m, lines, range: [curves.position_m[0], design.length_m] });
  }

  /** @param {DesignPicture} answer */
  light({ locks, rules, limits }) {
    const lamp = (/** @type {DesignLight} */ { label, holds, words }) => ({ state: /** @type {Light} */ (holds ? "pass" : "fail"), name: label, words: words[this.app.units] });
    this.lights.locks.show(locks.map(lamp));
    this.lights.limits.show(limits.map(lamp));
    showRules(this.lights.rules, rules, this.app);
  }

  /** @param {DesignPicture} answer */
  compare({ measures }) {
    const show = (/** @type {string} */ scale, /** @type {number | null} */ value, sign = false) => {
      const words = this.app.text(sign ? CHANGES[scale] ?? scale : scale, value, scale === "contact" ? 2 : undefined);
      return sign && value !== null && value > 0 && Number.parseFloat(words) !== 0 ? `+${words}` : words;
    };
    this.app.afterwards(this.beside, () => this.beside.replaceChildren(tableOf("Beside the present bat", ["Measure", "present", "this bat", "change"],
      measures.map(({ label, scale, present, value, change }) => [label, show(scale, present), show(scale, value), show(scale, change, true)]))));
  }

  // First what is gained over this batter's contacts and, once that is known, whether anybody could see it.
  /** @param {DesignPicture} answer */
  say(answer) {
    const { app: { units }, worth } = this;
    const words = [...(worth ?? answer).gained[units], ...answer.weighs[units]].join(" ");
    tell(this.words, words);
    this.app.announce(words);
    this.picture.label(`The bat that is shaped, its handles, and dashed the present one. ${words} The bat's numbers change it by keyboard.`);
    this.chart.label(`Exit speed along the bat and what it gains on the present one. ${words}`);
    if (worth) {
      paragraphs(this.gain, worth.sentences[units]);
      this.gain.ariaBusy = "false";
    }
  }

  figures() { return [this.picture.figure("bat"), this.chart.figure("curves"), ...(this.front.found ? [this.front.surface.figure("front")] : [])]; }
  table() { return { ...this.answer?.curves }; }
}

// The paper: one question after the other, its claim and formula with numbers that can be moved, and the full model.

import { ballGroup, swingGroup } from "../bat/swing.js";
import { FILLS } from "../bat/workshop.js";
import { button, choice, group, slider } from "../controls/controls.js";
import { mathOf, typeset } from "../controls/formula.js";
import { inReadersUnit, make, section, tableOf, tell } from "../controls/parts.js";
import { unbroken } from "../controls/tables.js";
import { PICTURES } from "./paper_pictures.js";
/** @import { PaperPicture, Statement } from "../answers.js" */
/** @import { App, AppOf, Guide } from "../shell/main.js" */
/** @import { Drawing } from "./paper_pictures.js" */

const FILLED = FILLS.filter(([fill]) => fill !== "nothing");
const HELD = [["floor", "lying on concrete"], ["clamped", "clamped at the edges"], ["free", "lying free"]];
/** @type {{ key: keyof typeof PICTURES, title: string, controls: (app: App) => HTMLElement[] }[]} the paper's questions in its order */
const STEPS = [
  { key: "end", title: "Why not the end?", controls: (app) => [slider(app, "entry_angle_deg", { label: "Entry angle α", step: 1 })] },
  { key: "percussion", title: "Where is it, then?", controls: (app) => [
    slider(app, "rod_hands_in", { label: "Rod held, from its end", step: 0.25 }),
    slider(app, "hands_moved_in", { label: "Hands moved up the handle by", step: 0.25 }),
  ] },
  { key: "corking", title: "Does corking help?", controls: (app) => [
    slider(app, "hole_diameter_in", { label: "Hole, width", step: 0.05 }),
    slider(app, "hole_depth_in", { label: "Hole, depth from the tip", step: 0.25 }),
    choice(app, "hole_fill", { label: "Filled with", options: FILLED }),
  ] },
  { key: "drop", title: "The drop experiment", controls: (app) => [
    slider(app, "drop_height_m", { label: "Height of the fall", step: 0.02 }),
    slider(app, "block_thickness_m", { label: "Thickness of the blocks", step: 0.001 }),
    choice(app, "block_support", { label: "The blocks are", options: HELD }),
  ] },
  { key: "energy", title: "Why not metal?", controls: (app) => [
    slider(app, "ball_restitution", { label: "k₀, restitution of the ball", step: 0.01 }),
    slider(app, "wood_restitution", { label: "k₁, of wood", step: 0.01 }),
    slider(app, "wood_share", { label: "z₁, share of wood", step: 0.005 }),
    slider(app, "metal_restitution", { label: "k₂, of metal", step: 0.01 }),
    slider(app, "metal_share", { label: "z₂, share of metal", step: 0.005 }),
  ] },
  { key: "verdict", title: "The answer", controls: () => [] },
];

export default class PaperView {
  /** @type {Guide} */
  static guide = [
    ["A paper on the sweet spot", "It asks why the sweet spot is not at the end of the bat. One question after the other: " +
      "what the paper says, and its formulas."],
    ["Move its numbers", "Move a slider under a question and its formula follows, and so does the picture."],
    ["Hold it against the full model", "Below stands every statement three times: the paper's number, its formula worked out " +
      "here, and the full model with the bat and the swing of your choice. "],
  ];

  /** @param {HTMLElement} root @param {AppOf<"paper">} app */
  constructor(root, app) {
    this.app = app;
    /** @type {PaperPicture | null} */
    this.answer = null;
    /** @type {Drawing | null} */
    this.drawing = null;
    this.steps = STEPS.map((step, i) => {
      const made = button(`${i + 1}. ${step.title}`, () => app.setState({ question: step.key }));
      made.className = "step";
      return made;
    });
    const list = make("ol", { className: "questions" }, ...this.steps.map((step) => make("li", {}, step)));
    const nav = make("nav", { className: "group", ariaLabel: "Questions of the paper" }, make("h2", { textContent: "Questions" }), list);
    this.own = Object.fromEntries(STEPS.map((step) => [step.key, make("div", {}, ...step.controls(app))]));
    this.sliders = group("Move it", Object.values(this.own));
    this.sliders.classList.add("across");
    app.control({ field: "question", sync: ({ question }) => this.choose(question) });
    this.said = make("div", { className: "claim" });
    this.formulas = make("div", { className: "formulas", tabIndex: 0, role: "region", ariaLabel: "Formulas" }); // a long one is wider than a phone
    this.live = make("div", { className: "live" }); // with the numbers of now
    this.slips = make("details", { className: "slips" });
    this.picture = make("div");
    this.rows = make("div");
    this.truth = make("p", { className: "words", id: "verdict" });
    this.back = button("Back", () => this.go(-1));
    this.next = button("Next question", () => this.go(1), { primary: true });
    this.title = make("h1");
    root.append(
      make("div", { className: "side" }, nav, swingGroup(app, { open: false }), ballGroup(app)),
      make("div", { className: "stack" }, this.title, section("What the full model says", this.picture, this.truth), this.sliders,
        section("The paper says", this.said, this.formulas, this.slips), section("Statement by statement", this.rows), make("div", { className: "row" }, this.back, this.next)));
  }

  /** @param {string} question */
  choose(question) {
    STEPS.forEach((step, i) => {
      const here = step.key === question;
      this.own[step.key].hidden = !here;
      if (here) this.steps[i].setAttribute("aria-current", "step");
      else this.steps[i].removeAttribute("aria-current");
    });
  }

  /** @param {number} by */
  go(by) {
    const at = STEPS.findIndex(({ key }) => key === this.app.state.question) + by;
    const next = STEPS[Math.min(STEPS.length - 1, Math.max(0, at))];
    this.app.setState({ question: next.key });
    scrollTo({ top: 0 });
    this.steps[STEPS.indexOf(next)].focus();
  }

  /** @param {PaperPicture} answer */
  update(answer) {
    const { units } = this.app;
    if (this.answer?.question !== answer.question) this.show(answer);
    this.answer = answer;
    this.live.replaceChildren(...answer.live[units].map((source) => formulaRow("now", source, "")));
    const truth = answer.truth[units].join(" ");
    tell(this.truth, truth);
    this.app.announce(truth);
    this.drawing?.draw(answer);
    this.app.afterwards(this.rows, () => {
      this.rows.replaceChildren(this.statements(answer.rows));
      typeset(this.rows);
    });
    const at = STEPS.findIndex(({ key }) => key === answer.question);
    this.back.disabled = at === 0;
    this.next.disabled = at === STEPS.length - 1;
  }

  /** @param {PaperPicture} answer */
  show({ question: key, asked: { question, claim, formulas, misprints } }) {
    this.title.textContent = question;
    this.said.replaceChildren(...claim.map((text) => make("p", { textContent: unbroken(text) })));
    this.formulas.replaceChildren(...formulas.map((formula) => formulaRow(...partsOf(formula))), this.live);
    this.slips.replaceChildren(make("summary", { textContent: "Misprints to know" }), make("ul", {}, ...misprints.map((text) => make("li", { textContent: text }))));
    typeset(this.slips);
    this.slips.hidden = misprints.length === 0;
    this.sliders.hidden = this.own[key].childElementCount === 0;
    this.drawing = PICTURES[key](this.app);
    this.picture.replaceChildren(...this.drawing.elements);
  }

  /** @param {Statement[]} rows */
  statements(rows) {
    const show = (/** @type {Statement["paper"]} */ value, /** @type {string} */ unit) => (typeof value === "string" ? value : inReadersUnit(value, unit, this.app));
    return tableOf("Each statement: the paper's number or claim, its formula evaluated here, the full model", [
      "Statement", "Paper", "Its formula", "Full model",
    ], rows.map((row) => [
      { text: `${row.equation === "-" ? "" : `(${row.equation}) `}${row.words[this.app.units].quantity}`, note: row.words[this.app.units].comment },
      show(row.paper, row.unit), show(row.computed, row.unit), show(row.full_model, row.unit)]));
  }

  figures() { return this.drawing?.figures() ?? []; }
  table() {
    const { rows } = this.answer ?? { rows: [] };
    return Object.fromEntries(/** @type {const} */ (["equation", "quantity", "unit", "paper", "computed", "full_model", "comment"]).map((key) => [key, rows.map((row) => row[key])]));
  }
}

/** @param {string} number @param {string} source @param {string} words */
function formulaRow(number, source, words) {
  return make("div", { className: "formula" }, make("span", { className: "number", textContent: number === "now" ? "now" : number ? `(${number})` : "" }),
    mathOf(source), make("span", { className: "note", textContent: words }));
}

// Number, formula and what it is of.
/** @param {string} formula @returns {[string, string, string]} */
function partsOf(formula) {
  const [, number, source, words] = /^(.*?): (.*); (.*)$/.exec(formula) ?? ["", "", formula, ""];
  return [number, source, words];
}

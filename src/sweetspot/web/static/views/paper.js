// The paper: one question after the other, its claim and formula with numbers that can be moved, and the full model.

import { Bench, ballGroup, swingGroup } from "../bat/bench.js";
import { button, group } from "../controls/controls.js";
import { mathOf, typeset } from "../controls/formula.js";
import { inReadersUnit, make, tableOf, tell } from "../controls/parts.js";
import { unbroken } from "../controls/tables.js";
import { PICTURES } from "./paper_pictures.js";
import { STEPS } from "./paper_steps.js";
/** @import { Statement } from "../answers.js" */
/** @import { View } from "../shell/main.js" */
/** @import { Asked } from "./paper_steps.js" */

/** @type {View<"paper">} */
export const view = {
  name: "paper",
  guide: [
    ["A paper on the sweet spot", "It asks why the sweet spot is not at the end of the bat. One question after the other: " +
      "what the paper says, and its formulas."],
    ["Move its numbers", "Move a slider under a question and its formula follows, and so does the picture."],
    ["Hold it against the full model", "Below stands every statement three times: the paper's number, its formula worked out " +
      "here, and the full model with the bat and the swing of your choice. "],
  ],

  mount(root, app) {
    Object.assign(this, { app, shown: null });
    this.steps = STEPS.map((step, i) => {
      const made = button(`${i + 1}. ${step.title}`, () => app.setState({ question: step.key }));
      made.className = "step";
      return made;
    });
    const list = make("ol", { className: "questions" }, ...this.steps.map((/** @type {HTMLElement} */ step) => make("li", {}, step)));
    const nav = make("nav", { className: "group", ariaLabel: "Questions of the paper" }, make("h2", { textContent: "Questions" }), list);
    this.own = Object.fromEntries(STEPS.map((step) => [step.key, make("div", {}, ...step.controls(app))]));
    this.sliders = group("Move it", Object.values(this.own));
    this.sliders.classList.add("across");
    app.control({ field: "question", sync: ({ question }) => this.choose(question) });
    this.bench = new Bench(app, { open: false });
    this.said = make("div", { className: "claim" });
    this.formulas = make("div", { className: "formulas", tabIndex: 0, role: "region", ariaLabel: "Formulas" }); // a long one is wider than a phone
    this.live = make("div", { className: "live" }); // with the numbers of now
    this.slips = make("details", { className: "slips" });
    this.picture = make("div");
    this.rows = make("div");
    this.truth = make("p", { className: "words", id: "verdict" });
    this.turn = make("div", { className: "row" },
      button("Back", () => this.go(-1)), button("Next question", () => this.go(1), { primary: true }));
    const section = (/** @type {string} */ title, /** @type {(Node | string)[]} */ ...parts) => make("section", { className: "picture" }, make("h2", { textContent: title }), ...parts);
    this.title = make("h1");
    root.append(
      make("div", { className: "side" }, nav, this.bench.element, swingGroup(app, { open: false }), ballGroup(app)),
      make("div", { className: "stack" }, this.title, section("The paper says", this.said, this.formulas, this.slips),
        this.sliders, section("What the full model says", this.truth, this.picture),
        section("Statement by statement", this.rows), this.turn));
  },

  /** @param {string} question */
  choose(question) {
    STEPS.forEach((step, i) => {
      const here = step.key === question;
      this.own[step.key].hidden = !here;
      if (here) this.steps[i].setAttribute("aria-current", "step");
      else this.steps[i].removeAttribute("aria-current");
    });
  },

  /** @param {number} by */
  go(by) {
    const at = STEPS.findIndex(({ key }) => key === this.app.state.question) + by;
    const next = STEPS[Math.min(STEPS.length - 1, Math.max(0, at))];
    this.app.setState({ question: next.key });
    scrollTo({ top: 0 });
    this.steps[STEPS.indexOf(next)].focus();
  },

  update(answer) {
    const step = STEPS.find(({ key }) => key === answer.question) ?? STEPS[0];
    this.answer = answer;
    this.bench.update(answer);
    if (this.shown !== step.key) this.show(step);
    const { units } = this.app;
    this.live.replaceChildren(...answer.live[units].map((source) => formulaRow("now", source, "")));
    const truth = answer.truth[units].join(" ");
    tell(this.truth, truth);
    this.app.announce(truth);
    this.drawing.draw(answer);
    this.app.afterwards(this.rows, () => {
      this.rows.replaceChildren(this.table_(answer.rows));
      typeset(this.rows);
    });
    const at = STEPS.indexOf(step);
    this.turn.firstChild.disabled = at === 0;
    this.turn.lastChild.disabled = at === STEPS.length - 1;
  },

  /** @param {Asked} step */
  show(step) {
    this.shown = step.key;
    this.title.textContent = step.question;
    this.said.replaceChildren(...step.claim.map((text) => make("p", { textContent: unbroken(text) })));
    this.formulas.replaceChildren(...step.formulas.map(([number, source, words]) => formulaRow(number, source, words)), this.live);
    this.slips.replaceChildren(make("summary", { textContent: "Misprints to know" }),
      make("ul", {}, ...step.slips.map((text) => make("li", { textContent: text }))));
    typeset(this.slips);
    this.slips.hidden = step.slips.length === 0;
    this.sliders.hidden = this.own[step.key].childElementCount === 0;
    this.drawing = PICTURES[step.key](this.app);
    this.picture.replaceChildren(...this.drawing.elements);
  },

  /** @param {Statement[]} rows */
  table_(rows) {
    const show = (/** @type {Statement["paper"]} */ value, /** @type {string} */ unit) => (typeof value === "string" ? value : inReadersUnit(value, unit, this.app));
    return tableOf("Each statement: the paper's number or claim, its formula evaluated here, the full model", [
      "Statement", "Paper", "Its formula", "Full model",
    ], rows.map((row) => [
      { text: `${row.equation === "-" ? "" : `(${row.equation}) `}${row.words[this.app.units].quantity}`, note: row.words[this.app.units].comment },
      show(row.paper, row.unit), show(row.computed, row.unit), show(row.full_model, row.unit)]));
  },

  unmount() {},

  figures() {
    return this.drawing.figures();
  },

  table() {
    const { rows } = this.answer;
    return Object.fromEntries(/** @type {const} */ (["equation", "quantity", "unit", "paper", "computed", "full_model", "comment"]).map((key) => [key, rows.map((row) => row[key])]));
  },
};

/**
 * @param {string} number
 * @param {string} source
 * @param {string} words
 */
function formulaRow(number, source, words) {
  return make("div", { className: "formula" }, make("span", { className: "number", textContent: number === "now" ? "now" : number ? `(${number})` : "" }),
    mathOf(source), make("span", { className: "note", textContent: words }));
}

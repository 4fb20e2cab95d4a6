// A bat, racket, club or stick by questions; which ones, and how far an answer may go, the server says (web/wizard.py).

import { unchanged } from "./unchanged.js";
import { ANY_STEP, button } from "../controls/controls.js";
import { make } from "../controls/parts.js";
import { posted } from "../shell/post.js";
import { wordsOf } from "../shell/status.js";
import { fromShown, toShown, unitOf } from "../controls/units.js";
/** @import { Form, Pattern, Usual, WizardQuestion } from "../answers.js" */
/** @import { App } from "../shell/main.js" */
/** @import { System } from "../controls/units.js" */

/** @typedef {HTMLInputElement | HTMLSelectElement} Field */

const DROP = "drop";
const FIGURES = 4; // of a first value and of a bound

/** @type {Wizard | null} */
let begun = null; // closed before its answers lay on the bench: they are there when it is opened again

/** @param {App} app */
export async function wizard(app) {
  const { questions: forms } = await app.lists("questions");
  (begun ?? new Wizard(app, forms)).open();
}

class Wizard {
  /** @param {App} app @param {Form[]} forms */
  constructor(app, forms) {
    this.app = app;
    this.forms = forms;
    /** @type {Map<string, HTMLElement>} */
    this.faults = new Map();
    /** @type {[WizardQuestion, Field][]} */
    this.fields = [];
    this.sport = picked(forms.map(({ sport, name }) => [sport, name]));
    this.built = picked([]);
    this.name = make("input", { type: "text", maxLength: 60 });
    this.asked = make("div");
    this.said = make("p", { className: "fault", hidden: true });
    this.said.setAttribute("role", "alert");
    this.dialog = make("dialog", { className: "wizard" });
    this.dialog.setAttribute("aria-labelledby", "wizard-title");
    this.dialog.addEventListener("close", () => this.dialog.remove());
    this.dialog.addEventListener("input", () => { begun = this; });
    this.units = app.units; // in which the answers stand
    this.build();
  }

  /** @returns {Form} */
  get form() { return this.forms.find(({ sport }) => sport === this.sport.value) ?? this.forms[0]; }

  /** @returns {Pattern} */
  get pattern() { return this.form.patterns.find(({ key }) => key === this.built.value) ?? this.form.patterns[0]; }

  build() {
    const here = this.forms.find(({ name, view }) => view === this.app.name && name === this.app.answer?.sport);
    if (here) this.sport.value = here.sport;
    this.like = this.row("pattern", "Built", this.built);
    this.dialog.append(make("h2", { id: "wizard-title", textContent: "Describe your own" }),
      make("p", { className: "note", textContent: "Its shape is a usual one's, stretched to your length. What you measured is matched or, where that cannot be, refused with the reason; what you leave empty is in proportion. A file says more." }),
      this.row("sport", "Sport", this.sport), this.like, this.row("name", "Name", this.name), this.asked, this.said,
      make("div", { className: "row" }, button("Put it on the bench", () => this.use(), { primary: true }), button("Close", () => this.dialog.close())));
    this.sport.addEventListener("change", () => this.anew());
    this.built.addEventListener("change", () => this.ask());
    this.anew();
  }

  // Another view, by the way back, is another page: nothing may lie over it.
  open() {
    this.wellAgain();
    if (this.units !== this.app.units) this.askIn(this.app.units);
    document.body.append(this.dialog);
    this.dialog.showModal();
    addEventListener("popstate", () => this.dialog.close(), { once: true });
  }

  // The same questions in the other units, and with them what was answered.
  /** @param {System} units */
  askIn(units) {
    /** @type {Map<string, string>} */
    const given = new Map();
    for (const [question, { value, dataset }] of this.fields) {
      const { field, kind, system } = question;
      if (value === (dataset.usual ?? "")) continue;
      given.set(field, kind && value !== "" && system === null ? String(this.shown(question, fromShown(kind, Number(value), this.units))) : value);
    }
    this.units = units;
    this.ask();
    for (const [question, field] of this.fields) {
      field.value = given.get(question.field) ?? field.value;
      field.dispatchEvent(new Event("change")); // others may be in proportion
    }
  }

  // Another sport has other patterns, and another word for what one hits with.
  anew() {
    const { patterns, implement } = this.form;
    this.built.replaceChildren(...patterns.map(({ key, name }) => new Option(name, key)));
    if (this.like) this.like.hidden = patterns.length === 1;
    if (!this.name.value || /^my \w+$/.test(this.name.value)) this.name.value = `my ${implement}`;
    this.ask();
  }

  ask() {
    for (const [{ field }] of this.fields) this.faults.delete(field);
    this.fields = this.pattern.questions.map((question) => [question, this.field(question)]);
    this.asked.replaceChildren(...this.fields.map(([question, field]) => (
      this.row(question.field, question.label[this.system(question)], field, question.kind && unitOf(question.kind, this.system(question))))));
    for (const [question, field] of this.fields) {
      this.fill(question, field);
      field.addEventListener("change", () => this.fields.forEach(([other, its]) => [other.follows, other.proportion_to].includes(question.field) && this.fill(other, its)));
    }
    this.dropped();
  }

  // A drop is the weight in ounces less the length in inches; people write it with and without its sign.
  dropped() {
    const [drop, length, mass] = [DROP, "length_in", "mass_oz"].map((name) => this.fields.find(([{ field }]) => field === name));
    if (!drop || !length || !mass) return;
    const put = () => {
      const inches = fromShown("length_in", Number(length[1].value), this.system(length[0]));
      if (drop[1].value !== "" && inches > 0) mass[1].value = String(this.shown(mass[0], inches - Math.abs(Number(drop[1].value))));
    };
    for (const [, field] of [drop, length]) field.addEventListener("change", put);
  }

  // What is usual here, which may follow from other answers.
  /** @param {WizardQuestion} question @returns {Usual} */
  usual(question) {
    const answerTo = (/** @type {string} */ name) => this.fields.find(([{ field }]) => field === name);
    const known = question.by[answerTo(question.follows)?.[1].value ?? ""];
    const { value, least, most } = known ?? question;
    const [whole, given] = answerTo(question.proportion_to) ?? [];
    if (typeof value !== "number" || typeof whole?.value !== "number" || !(Number(given?.value) > 0)) return { value, least, most };
    const part = Number(given?.value) / this.shown(whole, whole.value);
    const bound = (/** @type {number | null} */ one) => (known && one !== null ? part * one : one);
    return { value: part * value, least: bound(least), most: bound(most) };
  }

  // The usual answer, unless somebody gave another one.
  /** @param {WizardQuestion} question @param {Field} field */
  fill(question, field) {
    const { value } = this.usual(question);
    if (typeof value !== "number" || field.value !== (field.dataset.usual ?? "")) return;
    field.value = field.dataset.usual = String(this.shown(question, value));
  }

  /** @param {WizardQuestion} question @param {number} value */
  shown(question, value) { return Number(toShown(question.kind, value, this.system(question)).toPrecision(FIGURES)); }

  /** @param {WizardQuestion} question */
  system({ system }) { return system ?? this.app.units; }

  /** @param {WizardQuestion} question @returns {Field} */
  field(question) {
    const { kind, options } = question;
    if (options.length) return picked(options.map(({ key, name }) => [key, name]));
    return kind ? make("input", { type: "number", step: ANY_STEP }) : make("input", { type: "text", maxLength: 20 });
  }

  /** @param {string} field @param {string} words @param {Field} input */
  row(field, words, input, unit = "") {
    input.id = `wizard-${field}`;
    const fault = make("p", { className: "fault", hidden: true, id: `wizard-${field}-fault` });
    input.setAttribute("aria-describedby", fault.id);
    this.faults.set(field, fault);
    return make("div", { className: "control" }, make("label", { htmlFor: input.id, textContent: words }),
      make("div", { className: "entry" }, input, make("span", { className: "unit", textContent: unit })), fault);
  }

  /** @param {string} field @param {string} message */
  fault(field, message) {
    const beside = this.faults.get(field);
    const place = beside && !beside.parentElement?.hidden ? beside : this.said;
    const first = [...this.faults.values(), this.said].every((fault) => fault.hidden);
    place.textContent = message;
    place.hidden = false;
    const input = this.dialog.querySelector(`#wizard-${field}`);
    if (place !== beside || !(input instanceof HTMLElement)) return;
    input.setAttribute("aria-invalid", "true");
    if (first) input.focus(); // on a phone it may stand out of sight
  }

  wellAgain() {
    for (const fault of [...this.faults.values(), this.said]) fault.hidden = true;
    for (const input of this.dialog.querySelectorAll("[aria-invalid]")) input.removeAttribute("aria-invalid");
  }

  // The answers as the server takes them; null where one is out of bounds, which is said beside it.
  wanted() {
    /** @type {Record<string, string | number>} */
    const wanted = { sport: this.form.sport, pattern: this.pattern.key, name: this.name.value || `my ${this.form.implement}` };
    let good = true;
    for (const [question, { value, validity }] of this.fields) {
      const { field, kind } = question;
      const { least, most } = this.usual(question);
      if (validity.badInput) {
        this.fault(field, "Give a number, or leave it empty.");
        good = false;
        continue;
      }
      if (value === "" || field === DROP) continue;
      if (least === null || most === null) {
        wanted[field] = value;
        continue;
      }
      const system = this.system(question);
      wanted[field] = fromShown(kind, Number(value), system);
      if (wanted[field] >= least && wanted[field] <= most) continue;
      const [low, high] = [inward(toShown(kind, least, system), Math.ceil), inward(toShown(kind, most, system), Math.floor)];
      this.fault(field, `Allowed is ${low} to ${high} ${unitOf(kind, system)}.`);
      good = false;
    }
    return good ? wanted : null;
  }

  async use() {
    this.wellAgain();
    const wanted = this.wanted();
    if (!wanted) return;
    try {
      const { toml, told, assumed } = await posted("/api/v1/describe", wanted);
      begun = null;
      this.dialog.close();
      await this.lay(toml);
      this.app.bench.assume(toml, { us: [...assumed.us, ...[told.us].filter(Boolean)], si: [...assumed.si, ...[told.si].filter(Boolean)] });
    } catch (fault) {
      this.fault(fault.field, wordsOf(fault, this.app.units));
    }
  }

  // On the bench: a bat for every view, anything else in the view of its own.
  /** @param {string} toml */
  async lay(toml) {
    const { app } = this;
    if (this.form.view === "sports") {
      await app.visitWith("sports", { implement_toml: toml, swing_mph: null, incoming_mph: null, met_from_tip_in: null, aside_in: 0 });
      return;
    }
    const fields = { ...unchanged({ schema: app.entry("explorer").schema }), bat_toml: toml };
    if (Object.hasOwn(app.schema, "bat_toml")) app.setState(fields);
    else {
      Object.assign(app.carried, fields);
      await app.visit(app.addressFor("explorer"));
    }
  }
}

// A bound with a few figures, itself allowed.
/** @param {number} bound @param {(value: number) => number} round */
function inward(bound, round) {
  const step = 10 ** (Math.floor(Math.log10(bound)) + 1 - FIGURES);
  return Number((step * round(bound / step)).toPrecision(FIGURES));
}

/** @param {string[][]} options */
function picked(options) {
  return make("select", {}, ...options.map(([value, words]) => new Option(words, value)));
}

// The bats beside the first one: each chosen from the catalogue or a file, each changed as a workshop would.

import { checked, textOf } from "../bat/batfile.js";
import { batChoice, workshop } from "../bat/workshop.js";
import { unchanged } from "../bat/unchanged.js";
import { button, faultPlace } from "../controls/controls.js";
import { make, scoped } from "../controls/parts.js";
import { wordsOf } from "../shell/status.js";
/** @import { BatState, ComparisonPicture, States } from "../answers.js" */
/** @import { AppOf, State } from "../shell/main.js" */

const MOST = 3;
const FIRST_CHOICES = ["corked-r161", "russell-b6", "youth-30", "composite"];
const SOFTBALL = ["softball", "slow-pitch"]; // both are played with one kind of bat

export class Slots {
  /** @param {AppOf<"compare">} app */
  constructor(app) {
    this.app = app;
    this.slots = Array.from({ length: MOST }, (_, index) => this.slot(index));
    this.more = button("Add a bat", () => this.add());
    this.element = make("details", { className: "group", open: true }, make("summary", { textContent: "Compared with" }),
      ...this.slots.map(({ element }) => element), this.more);
    this.element.append(faultPlace(app, ["others"], (state) => this.sync(state)));
  }

  /** @param {number} index */
  slot(index) {
    const one = scoped(this.app, index, (field) => this.app.answer?.others_bounds?.[index]?.[field]);
    const title = `Bat ${index + 2}`;
    const file = make("input", { type: "file", accept: ".toml,text/plain", ariaLabel: `${title}: your own bat file (TOML)` });
    file.addEventListener("change", () => this.read(file, one, index));
    const { controls, show } = workshop(one, () => this.app.answer?.bats[index + 1]?.bat.mass_kg);
    const change = make("details", {}, make("summary", { textContent: "Change it" }), ...controls,
      make("label", { className: "note" }, "Your own bat file ", file));
    const remove = button("Remove", () => this.remove(index));
    remove.setAttribute("aria-label", `Remove ${title}`);
    const element = make("fieldset", { className: "slot" }, make("legend", { className: "unseen", textContent: title }),
      batChoice(one, title), change, make("div", { className: "row" }, remove));
    return { element, show };
  }

  // A what-if is about bat 1 alone; the others keep their places in the state until it is over.
  /** @param {State} state */
  sync({ others, what_if: asked }) {
    this.slots.forEach(({ element }, i) => (element.hidden = i >= others.length || asked !== "none"));
    this.more.hidden = others.length >= MOST || asked !== "none";
    this.element.hidden = asked !== "none";
  }

  /** @param {ComparisonPicture} answer @param {States["compare"]} state */
  update({ bat, bats }, { what_if: asked, others }) {
    if (asked === "none") this.keepToTheSport(bat.sport, others);
    if (asked === "none") bats.slice(1).forEach(({ shape }, i) => this.slots[i].show(shape));
  }

  // The bats that stand there before anybody chose are baseball's: beside a bat of another sport those of its own stand.
  /** @param {string} sport @param {Partial<BatState>[]} others */
  async keepToTheSport(sport, others) {
    const first = JSON.stringify(this.app.defaults.others);
    if (JSON.stringify(others) !== first || alike(sport, "baseball")) return;
    const next = (await this.ofTheSport(sport)).filter((name) => name !== this.app.state.bat);
    if (next.length && JSON.stringify(this.app.state.others) === first) this.app.setState({ others: next.slice(0, 2).map((bat) => ({ bat })) }, { instead: true });
  }

  /** @param {string} sport */
  async ofTheSport(sport) {
    const { bats } = await this.app.lists("bats");
    return bats.filter((one) => alike(one.sport, sport)).map(({ key }) => key);
  }

  async add() {
    const sport = this.app.answer?.bat.sport ?? "baseball";
    const choices = alike(sport, "baseball") ? FIRST_CHOICES : [...(await this.ofTheSport(sport)), ...FIRST_CHOICES];
    const taken = [this.app.state.bat, ...this.app.state.others.map(({ bat }) => bat)];
    const next = choices.find((name) => !taken.includes(name)) ?? choices[0];
    this.app.setState({ others: [...this.app.state.others, { bat: next }] });
  }

  /** @param {number} index */
  remove(index) {
    this.app.setState({ others: this.app.state.others.filter((_, i) => i !== index) });
    this.more.focus();
  }

  /** @param {HTMLInputElement} input @param {ReturnType<typeof scoped>} one @param {number} index */
  async read(input, one, index) {
    const file = input.files?.[0];
    if (!file) return;
    const say = (/** @type {string} */ message) => this.app.controls.get(`others.${index}.bat`)?.fault?.(message);
    try {
      const text = await textOf(file);
      await checked(text);
      one.setState({ ...unchanged(one), bat_toml: text });
    } catch (fault) {
      say(wordsOf(fault, this.app.units));
    }
    input.value = ""; // so that the same file, mended, can be chosen again
  }
}

// Whether bats of two sports meet the same ball in the same hands.
/** @param {string} one @param {string} other */
const alike = (one, other) => one === other || [one, other].every((name) => SOFTBALL.includes(name));

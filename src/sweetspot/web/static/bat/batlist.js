// The list of what one can hit with: the catalogue's bats by what they are used for, then what other sports hit with.

import { make, showWords, write } from "../controls/parts.js";
/** @import { BatFacts, Tool } from "../answers.js" */
/** @import { BenchDesk } from "./desk.js" */

const NONE = "No bat of the list is called that. Describe yours by questions, or open its file.";

/** @typedef {{ bat: boolean, key: string, input: HTMLInputElement, label: HTMLElement, small: HTMLElement, facts: BatFacts | null, words: string }} Row */

export class BatList {
  /** @param {BenchDesk} desk @param {(key: string, bat: boolean) => void} choose */
  constructor(desk, choose) {
    this.desk = desk;
    this.choose = choose;
    /** @type {Row[]} */
    this.rows = [];
    this.units = "";
    this.search = make("input", { type: "search", id: "bench-search", placeholder: "Name, sport or kind" });
    this.list = make("div", { className: "bat-list" });
    this.none = make("p", { className: "note", hidden: true });
    this.none.setAttribute("role", "status");
    this.element = make("div", {}, make("label", { className: "note", htmlFor: this.search.id, textContent: "Find a bat" }), this.search, this.list, this.none);
    this.search.addEventListener("input", () => this.filter());
    desk.lists("bats", "implements").then(({ bats, implements: tools }) => this.fill(bats, tools), () => {});
  }

  /** @param {BatFacts[]} bats @param {Tool[]} tools */
  fill(bats, tools) {
    const known = new Set(bats.map(({ key }) => key));
    const others = tools.filter(({ key }) => !known.has(key));
    const rows = [...bats.map((facts) => this.row(facts.key, facts.name, facts.use, facts)), ...others.map(({ key, name, sport }) => this.row(key, name, sport, null))];
    this.rows = rows;
    const groups = [...new Set([...bats.map(({ use }) => use), ...others.map(({ sport }) => sport)])];
    this.list.replaceChildren(...groups.map((group) => make("fieldset", {}, make("legend", { textContent: group }),
      ...rows.filter(({ input }) => input.dataset.group === group).map(({ label }) => label))));
    this.sync();
    this.filter();
  }

  /** @param {string} key @param {string} name @param {string} group @param {BatFacts | null} facts @returns {Row} */
  row(key, name, group, facts) {
    const input = make("input", { type: "radio", name: "bench-bat", value: key }), small = make("small");
    input.dataset.group = group;
    input.addEventListener("change", () => this.choose(key, facts !== null));
    return { bat: facts !== null, key, input, small, facts, label: make("label", {}, input, make("span", {}, `${name} `, small)), words: `${name} ${group} ${key} ${facts?.hollow ? "hollow" : ""}`.toLowerCase() };
  }

  // What lies on the bench; nothing of the list where it is a file.
  sync() {
    const { app } = this.desk;
    const tool = app.state.implement, own = tool ? app.state.implement_toml : this.desk.state.bat_toml;
    for (const { input, key, small, facts } of this.rows) {
      input.checked = !own && key === (tool ?? this.desk.state.bat);
      if (facts && this.units !== app.units) write(small, `${app.text("length_m", facts.length_m, 1)}, ${app.text("mass_kg", facts.mass_kg, 1)}`);
    }
    if (this.rows.length) this.units = app.units;
  }

  filter() {
    const wanted = this.search.value.toLowerCase().split(/\s+/).filter(Boolean);
    for (const { label, words } of this.rows) label.hidden = !wanted.every((word) => words.includes(word));
    for (const group of this.list.children) if (group instanceof HTMLElement) group.hidden = !group.querySelector("label:not([hidden])");
    showWords(this.none, this.rows.length && this.rows.every(({ label }) => label.hidden) ? NONE : "");
  }

  // The chosen one in the middle of the list, where it is seen.
  show() {
    const chosen = this.rows.find(({ input }) => input.checked)?.label;
    if (chosen) this.list.scrollTop = chosen.offsetTop - this.list.clientHeight / 2;
  }
}

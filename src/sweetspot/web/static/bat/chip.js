// The chip in the header: what lies on the bench, what was changed of it, and what can be done with it.

import { batText, describeOwn, orSaid } from "./bench.js";
import { unchanged } from "./unchanged.js";
import { button } from "../controls/controls.js";
import { download } from "../shell/download.js";
import { make, write } from "../controls/parts.js";
import { posted } from "../shell/post.js";
/** @import { App, Field } from "../shell/main.js" */

/** @type {[Field, string][]} a field that changes the bat, and what is said of it; #: its value */
const CHANGES = [["profile_in", "outline drawn"], ["mass_oz", "weight #"], ["wall_factor", "wall × #"], ["bore_diameter_in", "hole # wide"],
  ["cup_diameter_in", "cup # wide"], ["weight_oz", "# added"], ["choke_up_in", "choked up #"]];

export class Chip {
  /** @param {App} app */
  constructor(app) {
    this.app = app;
    /** @type {Map<string, Promise<string>>} */
    this.names = new Map(); // by catalogue name or text
    this.name = make("strong");
    this.changes = make("small");
    this.open = make("button", { type: "button", id: "bench-chip" }, make("span", {}, this.name, " ", this.changes));
    this.open.setAttribute("aria-haspopup", "dialog");
    this.element = make("div", { className: "bench-chip" }, this.open);
    this.open.addEventListener("click", () => this.menu());
  }

  get bat() {
    return { bat: "r161-ash", bat_toml: null, ...this.app.carried };
  }

  /** @returns {[Field, string][]} */
  made() {
    const { app } = this, { schema } = app.entry("explorer"), { carried } = app;
    const changed = CHANGES.filter(([field]) => carried[field] !== undefined && JSON.stringify(carried[field]) !== JSON.stringify(schema[field].default ?? null));
    return changed.map(([field, words]) => [field, words.replace("#", field === "wall_factor" ? String(carried[field]) : app.text(field, Number(carried[field])))]);
  }

  // Where another sport's implement lies before one, it is named; where nothing does, the bat on the bench has nothing to say.
  async sync() {
    this.element.hidden = this.app.schema.bat === undefined && !this.other;
    if (this.other) {
      this.show(this.app.answer?.tool?.name ?? this.app.answer?.bat?.name ?? this.app.state.implement ?? "", this.app.state.implement_toml ? "your own file" : "");
      return;
    }
    const { bat, bat_toml: text } = this.bat;
    const changes = [text ? "your own file" : "", ...this.made().map(([, words]) => words)].filter(Boolean).join(", ");
    write(this.changes, changes);
    const key = text ?? bat;
    this.name.textContent ||= bat; // until its name is known
    if (!this.names.has(key)) this.names.set(key, this.look(bat, text));
    const name = (await this.names.get(key)) ?? bat;
    const now = this.bat.bat_toml ?? this.bat.bat;
    if (key === now && !this.other) this.show(name, changes);
  }

  // Whether the view shows an implement of its own, of any sport.
  get other() { return Boolean(this.app.state.implement); }

  /** @param {string} name @param {string} changes */
  show(name, changes) {
    write(this.name, name);
    write(this.changes, changes);
    const said = `On the bench: ${name}${changes ? `, ${changes}` : ""}`;
    if (this.open.getAttribute("aria-label") !== said) this.open.setAttribute("aria-label", said);
  }

  /** @param {string} bat @param {string | null} text @returns {Promise<string>} */
  async look(bat, text) {
    try {
      const facts = text ? await posted("/api/v1/bat", { toml: text }) : (await this.app.lists("bats")).bats.find(({ key }) => key === bat);
      return facts?.name ?? bat;
    } catch {
      this.names.delete(text ?? bat); // so that the next who asks tries again
      return text ? "your own bat" : bat;
    }
  }

  menu() {
    const dialog = make("dialog", { className: "bench-menu" });
    dialog.setAttribute("aria-labelledby", "bench-name");
    const act = (/** @type {string} */ words, /** @type {() => void} */ doing) => button(words, () => {
      dialog.close();
      doing();
    });
    dialog.append(
      make("h2", { id: "bench-name", textContent: this.name.textContent }),
      ...(this.other ? this.ofOther(act) : this.ofBat(act)),
      make("form", { method: "dialog" }, make("button", { textContent: "Close" })));
    dialog.addEventListener("close", () => dialog.remove());
    document.body.append(dialog);
    dialog.showModal();
  }

  /** @param {(words: string, doing: () => void) => HTMLButtonElement} act */
  ofBat(act) {
    const { app } = this;
    const made = this.made();
    const list = made.length ? make("ul", {}, ...made.map(([field, words]) => make("li", {}, `${words} `,
      Object.assign(act("Undo", () => app.setState({ [field]: app.entry("explorer").schema[field].default ?? null })), { ariaLabel: `Undo: ${words}` }))))
      : make("p", { className: "note", textContent: "Nothing was changed of it." });
    return [list, make("div", { className: "row" },
      act("As it was", () => app.setState(unchanged({ schema: app.entry("explorer").schema }))),
      act("Save as bat.toml", () => orSaid(async () => download("bat.toml", "application/toml", await batText(app)))),
      act("Describe another bat …", () => describeOwn(app)),
      act("Compare this with …", () => app.visit(app.addressFor("compare"))),
      act("Start this view anew", () => app.reset()))];
  }

  /** @param {(words: string, doing: () => void) => HTMLButtonElement} act */
  ofOther(act) {
    const { app } = this;
    const text = app.state.implement_toml;
    return [make("div", { className: "row" },
      ...(text ? [act("Save as mine.toml", () => download("mine.toml", "application/toml", text))] : []),
      act("Describe another …", () => describeOwn(app)),
      act("Start this view anew", () => app.reset()))];
  }
}

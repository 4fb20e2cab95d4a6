// The chip in the header: which bat lies on the bench, what was changed of it, and what can be done with it.

import { batText, unchanged } from "./bench.js";
import { button } from "./controls.js";
import { download } from "./exports.js";
import { make } from "./parts.js";
import { posted } from "./post.js";
import { wizard } from "./wizard.js";
/** @import { App, State } from "./main.js" */

// A field that changes the bat: what to say of it.
const CHANGES = {
  profile_in: () => "outline drawn",
  mass_oz: (value, app) => `weight ${app.text("mass_oz", value)}`,
  wall_factor: (value) => `wall × ${value}`,
  bore_diameter_in: (value, app) => `hole ${app.text("bore_diameter_in", value)} wide`,
  cup_diameter_in: (value, app) => `cup ${app.text("cup_diameter_in", value)} wide`,
  weight_oz: (value, app) => `${app.text("weight_oz", value)} added`,
  choke_up_in: (value, app) => `choked up ${app.text("choke_up_in", value)}`,
};

export class Chip {
  /** @param {App} app */
  constructor(app) {
    this.app = app;
    this.names = new Map(); // promises, by catalogue name or text
    this.name = make("strong");
    this.changes = make("small");
    this.open = make("button", { type: "button", id: "bench-chip" }, this.name, this.changes);
    this.open.setAttribute("aria-haspopup", "dialog");
    this.element = make("div", { className: "bench-chip" }, this.open);
    this.open.addEventListener("click", () => this.menu());
  }

  /** @returns {State} */
  get bat() {
    return { bat: "r161-ash", ...this.app.carried };
  }

  made() {
    const { schema } = this.app.entry("explorer");
    const changed = Object.entries(CHANGES).filter(([field]) => (
      this.bat[field] !== undefined && JSON.stringify(this.bat[field]) !== JSON.stringify(schema[field].default ?? null)));
    return changed.map(([field, words]) => [field, words(this.bat[field], this.app)]);
  }

  async sync() {
    const { bat, bat_toml: text } = this.bat;
    const changes = this.made().map(([, words]) => words);
    this.changes.textContent = [text ? "your own file" : "", ...changes].filter(Boolean).join(", ");
    const key = text ?? bat;
    this.name.textContent ||= bat; // until its name is known
    if (!this.names.has(key)) this.names.set(key, this.look(bat, text));
    const name = await this.names.get(key);
    const now = this.bat.bat_toml ?? this.bat.bat;
    if (key !== now) return;
    this.name.textContent = name;
    this.open.setAttribute("aria-label", `Bat: ${name}${this.changes.textContent ? `, ${this.changes.textContent}` : ""}`);
  }

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
    const { app } = this;
    const dialog = make("dialog", { className: "bench-menu" });
    dialog.setAttribute("aria-labelledby", "bench-name");
    const act = (words, doing) => button(words, () => {
      dialog.close();
      doing();
    });
    const made = this.made();
    const list = made.length ? make("ul", {}, ...made.map(([field, words]) => make("li", {}, `${words} `,
      Object.assign(act("Undo", () => app.setState({ [field]: unchanged({ schema: app.entry("explorer").schema })[field] })), { ariaLabel: `Undo: ${words}` }))))
      : make("p", { className: "note", textContent: "Nothing was changed of it." });
    dialog.append(
      make("h2", { id: "bench-name", textContent: this.name.textContent }), list,
      make("div", { className: "row" },
        act("As it was", () => app.setState(unchanged({ schema: app.entry("explorer").schema }))),
        act("Save as bat.toml", async () => download("bat.toml", "application/toml", await batText(app))),
        act("Describe another bat …", () => wizard(app)),
        act("Compare this with …", () => app.visit(app.addressFor("compare"))),
        act("Start this view anew", () => app.reset())),
      make("form", { method: "dialog" }, make("button", { textContent: "Close" })));
    dialog.addEventListener("close", () => dialog.remove());
    document.body.append(dialog);
    dialog.showModal();
  }
}

// The chip in the header: what lies on the bench and what was changed of it. It opens the bench.

import { make, write } from "../controls/parts.js";
import { posted } from "../shell/post.js";
/** @import { App } from "../shell/main.js" */

export class Chip {
  /** @param {App} app */
  constructor(app) {
    this.app = app;
    /** @type {Map<string, Promise<string>>} */
    this.names = new Map(); // by catalogue name or text
    this.name = make("strong");
    this.changes = make("small");
    this.open = make("button", { type: "button", id: "bench-chip" }, make("span", {}, this.name, " ", this.changes));
    this.open.setAttribute("aria-expanded", "false");
    this.open.setAttribute("aria-controls", "bench");
    this.element = make("div", { className: "bench-chip" }, this.open);
    this.open.addEventListener("click", () => app.bench.turn());
  }

  get bat() {
    return { bat: "r161-ash", bat_toml: null, ...this.app.carried };
  }

  // Where another sport's implement lies before one, it is named; where nothing does, the bat on the bench has nothing to say.
  async sync() {
    this.element.hidden = this.app.schema.bat === undefined && !this.other;
    if (this.other) {
      this.show(this.app.answer?.tool?.name ?? this.app.answer?.bat?.name ?? this.app.state.implement ?? "", this.app.state.implement_toml ? "your own file" : "");
      return;
    }
    const { bat, bat_toml: text } = this.bat;
    const changes = [text ? "your own file" : "", ...this.app.bench.made().map(([, words]) => words)].filter(Boolean).join(", ");
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
    this.app.bench.named(name);
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
}

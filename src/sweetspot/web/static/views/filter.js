// One field of the state that may be empty: a select whose list comes with the answer, as [value], [value, how many] or
// [value, how many, words]; hidden where there is nothing to choose.

import { reveal } from "../controls/controls.js";
import { make } from "../controls/parts.js";
import { grouped } from "../controls/units.js";
/** @import { Answer, App, State } from "../shell/main.js" */

export class Filter {
  /** @param {App} app */
  constructor(app, /** @type {string} */ field, /** @type {{ label: string, all: string }} */ { label, all }) {
    this.app = app;
    this.field = field;
    this.all = all;
    this.made = "";
    const id = `${app.name}-${field}`;
    this.select = make("select", { id });
    this.fault = make("p", { className: "fault", id: `${id}-fault`, hidden: true });
    this.select.setAttribute("aria-describedby", this.fault.id);
    this.select.addEventListener("change", () => app.setState({ [field]: this.select.value || null }));
    this.element = make("div", { className: "control", hidden: true }, make("label", { htmlFor: id, textContent: label }), make("div", { className: "entry" }, this.select), this.fault);
    this.element.dataset.field = field;
    this.fill([]);
    app.control({ field, sync: (state) => this.sync(state), fault: (message) => {
      this.fault.textContent = message;
      this.fault.hidden = message === "";
      if (message) reveal(this.fault);
    } });
  }

  /** @param {Answer[]} list */
  fill(list) {
    const made = JSON.stringify(list);
    if (made !== this.made) {
      this.made = made;
      this.select.replaceChildren(new Option(this.all, ""), ...list.map(([value, balls, words = value]) => new Option(balls === undefined ? words : `${words} (${grouped(balls)})`, value)));
    }
    this.element.hidden = list.length < 2 && this.app.state[this.field] === null;
    this.sync(this.app.state);
  }

  /** @param {State} state */
  sync(state) {
    const value = state[this.field] ?? "";
    if (![...this.select.options].some((option) => option.value === value)) this.select.append(new Option(value, value));
    this.select.value = value;
  }
}

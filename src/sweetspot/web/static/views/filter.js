// One field of the state that may be empty: a select whose list comes with the answer, as [value], [value, how many] or
// [value, how many, words]; hidden where there is nothing to choose.

import { faultPlace } from "../controls/controls.js";
import { changed, make } from "../controls/parts.js";
import { grouped } from "../controls/units.js";
/** @import { App, Field, State } from "../shell/main.js" */

export class Filter {
  /** @param {App} app */
  constructor(app, /** @type {Field} */ field, /** @type {{ label: string, all: string }} */ { label, all }) {
    this.app = app;
    this.field = field;
    this.all = all;
    this.made = "";
    const id = `${app.name}-${field}`;
    this.select = make("select", { id });
    const fault = Object.assign(faultPlace(app, [field], (state) => this.sync(state)), { id: `${id}-fault` });
    this.select.setAttribute("aria-describedby", fault.id);
    this.select.addEventListener("change", () => app.setState(changed(field, this.select.value || null)));
    this.element = make("div", { className: "control", hidden: true }, make("label", { htmlFor: id, textContent: label }), make("div", { className: "entry" }, this.select), fault);
    this.element.dataset.field = field;
    this.fill([]);
  }

  /** @param {[value: string, balls?: number, words?: string][]} list */
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
    const value = String(state[this.field] ?? "");
    if (![...this.select.options].some((option) => option.value === value)) this.select.append(new Option(value, value));
    this.select.value = value;
  }
}

// What the bench's controls need of the app: they stay while views come and go, and stand for the bat that goes along.

import { defaultsOf } from "../controls/fields.js";
/** @import { App, Control, Field, State, Step } from "../shell/main.js" */

export class BenchDesk {
  /** @param {App} app */
  constructor(app) {
    this.app = app;
    this.schema = app.entry("explorer").schema; // which has every field of a bat
    this.defaults = defaultsOf(this.schema);
    this.lists = app.lists.bind(app);
    this.text = app.text.bind(app);
    /** @type {Map<string, Control>} */
    this.controls = new Map();
  }

  get units() { return this.app.units; }
  get answer() { return this.app.answer; }
  /** @returns {State} */
  get state() { return /** @type {State} */ ({ ...this.defaults, ...this.app.carried }); }
  /** @param {Field} field */
  bounds(field) { return this.app.bounds(field); }

  // A view of a bat shows it changed at once; from another one it leads to the view of what is along the bat.
  /** @param {Partial<State>} partial @param {Step} [step] */
  setState(partial, step) {
    if (Object.hasOwn(this.app.schema, "bat")) this.app.setState(partial, step);
    else {
      Object.assign(this.app.carried, partial);
      this.app.visit(this.app.addressFor("explorer"));
    }
  }

  /** @param {Step} [step] */
  commit(step) { this.app.commit(step); }

  /** @param {Control} control */
  control(control) {
    this.controls.set(control.field, control);
    control.sync(this.state);
  }

  sync() {
    const { state } = this;
    for (const control of this.controls.values()) control.sync(state);
  }
}

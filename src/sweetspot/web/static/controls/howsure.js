// How sure a view's numbers are: a fold with the server's document of intervals, asked for only by those who open it.
//
//   const sure = new HowSure(app, { but: ["impact_from_tip_in"] });   // fields that make no difference to it
//   box.append(sure.element);
//   sure.update();             // after every answer

import { DocumentPlace } from "./document.js";
import { make } from "./parts.js";
/** @import { App } from "../shell/main.js" */

export class HowSure {
  /**
   * @param {App} app
   * @param {{ aside?: "sure" | "rules_sure", but?: string[], title?: string }} [options]
   */
  constructor(app, { aside = "sure", but = [], title = "How sure these numbers are, and what that comes from" } = {}) {
    this.app = app;
    this.aside = aside;
    this.but = but;
    this.place = new DocumentPlace(app, "Drawing bats and balls that may be meant …");
    this.element = make("details", { className: "report", id: aside, open: false }, make("summary", { textContent: title }), this.place.element);
    this.element.addEventListener("toggle", () => this.ask());
  }

  update() {
    this.place.redraw();
    this.ask();
  }

  // Hundreds of bats are hit for it.
  ask() {
    if (this.element.open && this.app.answer) this.app.aside(this.aside, this.but, 600, (found) => this.place.show(found));
  }
}

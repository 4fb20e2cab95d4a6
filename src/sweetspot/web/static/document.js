// A document of the server's (web/documents.py): text and tables in the reader's units, asked for apart.
//
//   const place = new DocumentPlace(app, "Working out the report …");
//   box.append(place.element);
//   place.show(found)        // what an aside has answered: { title, html: { us, si } }
//   place.redraw()           // after a change of units
//   place.waits()            // until the next answer is there

import { make } from "./parts.js";
/** @import { App } from "./main.js" */

export class DocumentPlace {
  /** @param {App} app */
  constructor(app, waiting) {
    this.app = app;
    this.waiting = waiting;
    this.found = null;
    this.element = make("div", { className: "document" }, make("p", { className: "note", textContent: waiting }));
    this.element.setAttribute("aria-busy", "true");
  }

  // The server's own words: its templates escape whatever came from elsewhere.
  show(found) {
    this.found = found;
    this.redraw();
  }

  redraw() {
    if (!this.found) return;
    this.element.innerHTML = this.found.html[this.app.units];
    this.element.setAttribute("aria-busy", "false");
    for (const box of this.element.querySelectorAll(".scroll")) box.setAttribute("role", "region");
    for (const box of this.element.querySelectorAll(".scroll")) box.setAttribute("aria-label", box.querySelector("caption")?.textContent ?? "Table");
  }

  waits() {
    this.element.setAttribute("aria-busy", "true");
  }
}

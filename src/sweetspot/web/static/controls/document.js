// A document of the server's (web/documents.py): text and tables in the reader's units, asked for apart.
//
//   const place = new DocumentPlace(app, "Working out the report …");
//   box.append(place.element);
//   place.show(found)        // what an aside has answered: { title, html: { us, si } }
//   place.redraw()           // after every answer: made anew only where units or the document changed
//   place.waits()            // until the next answer is there

import { make } from "./parts.js";
import { fitted, unbroken } from "./tables.js";
/** @import { App } from "../shell/main.js" */
/** @import { System } from "./units.js" */

/** @typedef {{ html: Record<System, string> }} Told */

// What a table is of: the document's first heading, and its own caption or the heading that it stands under.
/** @param {Element} box */
function titleOf(box) {
  const headings = [...(box.closest(".sweetspot")?.querySelectorAll("h2") ?? [])];
  const above = headings.filter((one) => one.compareDocumentPosition(box) & Node.DOCUMENT_POSITION_FOLLOWING).at(-1);
  const own = box.querySelector("caption")?.textContent || above?.textContent || "Table";
  return [...new Set([headings[0]?.textContent, own])].filter(Boolean).join(": ");
}

export class DocumentPlace {
  /**
   * @param {App} app
   * @param {string} waiting  what is said until the first answer
   */
  constructor(app, waiting) {
    this.app = app;
    this.waiting = waiting;
    /** @type {Told | null} */
    this.found = null;
    this.shown = ""; // of it, in the reader's units
    this.element = make("div", { className: "document" }, make("p", { className: "note", textContent: waiting }));
    this.element.setAttribute("aria-busy", "true");
  }

  // The server's own words: its templates escape whatever came from elsewhere.
  /** @param {Told} found */
  show(found) {
    this.found = found;
    this.redraw();
  }

  redraw() {
    if (!this.found) return;
    this.element.setAttribute("aria-busy", "false");
    const html = this.found.html[this.app.units];
    if (html === this.shown) return;
    this.shown = html;
    this.element.innerHTML = html;
    const texts = document.createTreeWalker(this.element, NodeFilter.SHOW_TEXT);
    for (let node = texts.nextNode(); node; node = texts.nextNode()) node.textContent = unbroken(node.textContent ?? "");
    // several documents may stand on one page: none has names that another has, or a title that says nothing
    for (const one of this.element.querySelectorAll("h2")) if (!one.textContent) one.remove();
    for (const section of this.element.querySelectorAll("section")) section.removeAttribute("aria-labelledby");
    for (const one of this.element.querySelectorAll("[id]")) if (!one.closest("svg")) one.removeAttribute("id"); // a drawing refers to its own
    for (const box of this.element.querySelectorAll(".scroll")) {
      box.setAttribute("role", "region");
      box.setAttribute("aria-label", titleOf(box));
      fitted(box);
    }
  }

  waits() {
    this.element.setAttribute("aria-busy", "true");
  }
}

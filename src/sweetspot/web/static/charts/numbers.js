// The numbers of a picture as a table under a heading that folds, for those who do not see the picture.
//
//   const numbers = new Numbers(app, "These curves as a table", () => ({ caption, columns, rows }));   or null: nothing yet
//   box.append(numbers.element);
//   numbers.redraw();        // after every change of the picture

import { make, tableOf } from "../controls/parts.js";
/** @import { App } from "../shell/main.js" */

const NOTHING = "–"; // where there is no number; a row of nothing else is left out

export class Numbers {
  /**
   * @param {App} app
   * @param {string} words
   * @param {() => { caption: string, columns: string[], rows: string[][], column?: number } | null} tabled  column: pixels that one needs
   */
  constructor(app, words, tabled) {
    this.app = app;
    this.tabled = tabled;
    this.element = make("details", { className: "numbers" }, make("summary", { textContent: words }));
    this.element.addEventListener("toggle", () => this.redraw());
  }

  redraw() {
    if (this.element.open) this.app.afterwards(this, () => this.fill());
    else this.empty();
  }

  fill() {
    this.empty();
    const found = this.element.open ? this.tabled() : null;
    if (found) this.element.append(tableOf(found.caption, found.columns, found.rows.filter((row) => row.slice(1).some((cell) => cell !== NOTHING)), { column: found.column, all: true }));
  }

  empty() { this.element.querySelector(".scroll")?.remove(); }
}

// About so many of a list, evenly, with the first and the last.
/** @template Item @param {Item[]} list @param {number} count */
export function evenly(list, count) {
  if (list.length <= count) return list;
  return Array.from({ length: count }, (_, i) => list[Math.round((i * (list.length - 1)) / (count - 1))]);
}
